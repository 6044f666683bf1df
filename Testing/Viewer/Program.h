// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

/// Runs the built program `limn` and looks at what it leaves.
namespace limn::testing
{

using Environment = std::map<std::string, std::string>;

struct Outcome
{
  int status = -1; ///< exit status; 128 + the signal if one ended it
  std::string out, err;
};

/// Runs `limn` with these arguments. DISPLAY is taken out of the environment before `environment`
/// is added to it.
Outcome runLimn(const std::vector<std::string>& arguments, const Environment& environment = {});

/// The same where no file may become larger than `bytes`, as on a full disk.
Outcome runLimnWithFileLimit(const std::vector<std::string>& arguments, unsigned long bytes);

/// Starts `limn` with the environment of the test; the caller waits for it. What it prints on
/// stderr goes to the file `err`.
pid_t startLimn(const std::vector<std::string>& arguments, const std::string& err);

/// The path of one of the meshes that come with Limn.
std::string meshFile(const std::string& name);

/// A new folder that goes, with all in it, when this object does.
class Folder
{
public:
  Folder();
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::string file(const std::string& name) const { return (path_ / name).string(); }
  /// Writes a file and returns its path.
  std::string write(const std::string& name, const std::string& content) const;
  /// The names of all that is in the folder, sorted.
  std::vector<std::string> names() const;

private:
  std::filesystem::path path_;
};

/// The bytes of a file; "" if it cannot be read.
std::string bytesOf(const std::string& file);

/// What an 8-bit PNG file declares of itself. All 0 if it is none.
struct PngHeader
{
  int width = 0, height = 0, channels = 0;
};
PngHeader pngHeader(const std::string& file);

} // namespace limn::testing
