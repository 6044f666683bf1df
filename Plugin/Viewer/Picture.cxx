// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Picture.h"

#include "Messages.h"
#include "UserError.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>

#include <png.h>

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace limn::viewer
{
namespace
{

namespace fs = std::filesystem;

/// A file that disappears unless it is renamed.
class TemporaryFile
{
public:
  explicit TemporaryFile(const std::string& finalName)
    : name_(finalName + ".part" + std::to_string(getpid()))
  {
  }
  ~TemporaryFile()
  {
    std::error_code ignored;
    fs::remove(this->name_, ignored);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  /// False on an error, with errno set.
  bool write(const unsigned char* bytes, vtkIdType size)
  {
    errno = 0;
    std::ofstream stream(this->name_, std::ios::binary);
    stream.write(reinterpret_cast<const char*>(bytes), size);
    stream.close();
    return !stream.fail();
  }

  /// False on an error, with errno set.
  bool renameTo(const std::string& finalName)
  {
    return std::rename(this->name_.c_str(), finalName.c_str()) == 0;
  }

private:
  std::string name_;
};

} // namespace

void checkWritable(const std::string& file)
{
  if (fs::is_directory(file))
  {
    throw UserError("cannot write " + file + ": it is a directory; name a file in it");
  }
  const fs::path parent = fs::path(file).parent_path();
  const fs::path folder = parent.empty() ? fs::path(".") : parent;
  if (!fs::is_directory(folder))
  {
    throw UserError("cannot write " + file + ": there is no folder " + folder.string() +
                    "; make it, or choose another");
  }
  if (access(folder.c_str(), W_OK) != 0)
  {
    throw UserError("cannot write " + file + ": the folder " + folder.string() +
                    " is not writable; choose another");
  }
}

void writePicture(vtkImageData& picture, const std::string& file)
{
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(&picture);
  writer->WriteToMemoryOn();
  writer->Write();
  throwCollectedErrors(file);
  vtkUnsignedCharArray* const bytes = writer->GetResult();
  TemporaryFile temporary(file);
  if (!temporary.write(bytes->GetPointer(0), bytes->GetNumberOfValues()) ||
      !temporary.renameTo(file))
  {
    throw UserError("cannot write " + file + ": " + std::strerror(errno));
  }
}

Picture readPicture(const std::string& file)
{
  if (fs::is_directory(file))
  {
    throw UserError("cannot read " + file + ": it is a directory; name a PNG file in it");
  }
  // Not vtkPNGReader, which crashes on files that are cut short.
  png_image png = {};
  png.version = PNG_IMAGE_VERSION;
  if (!png_image_begin_read_from_file(&png, file.c_str()))
  {
    throw UserError("cannot read " + file + ": " + png.message);
  }
  if (png.format & PNG_FORMAT_FLAG_LINEAR)
  {
    png_image_free(&png);
    throw UserError("cannot read " + file + ": it has 16 bits per channel; save it with 8");
  }
  png.format = PNG_FORMAT_RGBA;
  Picture picture;
  picture.width = static_cast<int>(png.width);
  picture.height = static_cast<int>(png.height);
  picture.rgba.resize(PNG_IMAGE_SIZE(png));
  if (!png_image_finish_read(&png, nullptr, picture.rgba.data(), 0, nullptr))
  {
    throw UserError("cannot read " + file + ": " + png.message);
  }
  return picture;
}

} // namespace limn::viewer
