// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Mesh/Io/Source.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <utility>

namespace limn::meshio {
namespace {

constexpr double kStep = 1.0 / 128;
constexpr double kCheckedShare = 0.5;  ///< of the whole time, the rest is parsing

}  // namespace

Source::Source(std::string path, Progress progress)
    : path_(std::move(path)), progress_(std::move(progress))
{
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::file_status status = fs::status(path_, error);
  if (!fs::exists(status)) {
    fail(status.type() == fs::file_type::not_found ? "there is no such file" : error.message());
  }
  if (fs::is_directory(status)) fail("this is a directory; name a mesh file in it");
  if (!fs::is_regular_file(status)) fail("this is not a regular file; copy its content to one");
  const std::uintmax_t size = fs::file_size(path_, error);
  if (error) fail("cannot be read: " + error.message());
  if (size == 0) fail("the file is empty; save the mesh again");

  std::ifstream stream(path_, std::ios::binary);
  if (!stream) fail(std::string("cannot be opened: ") + std::strerror(errno));
  bytes_.resize(size);
  stream.read(bytes_.data(), static_cast<std::streamsize>(size));
  if (static_cast<std::uintmax_t>(stream.gcount()) != size) {
    fail("could be read only up to byte " + std::to_string(stream.gcount()));
  }
}

void Source::report(double fraction)
{
  const bool isDue = fraction >= reported_ + kStep || (fraction == 1 && reported_ < 1);
  if (!progress_ || !isDue) return;
  reported_ = fraction;
  if (!progress_(fraction)) fail("cancelled");
}

void Source::reportChecked(std::size_t byte)
{
  report(kCheckedShare * static_cast<double>(byte) / static_cast<double>(bytes_.size()));
}

void Source::reportParsed(std::size_t done, std::size_t total)
{
  const double part = static_cast<double>(done) / static_cast<double>(total);
  report(kCheckedShare + (1 - kCheckedShare) * part);
}

void Source::fail(const std::string& what, Error error) const
{
  throw Fault{{error, path_ + ": " + what}};
}

void Source::failAtLine(std::size_t line, const std::string& what, Error error) const
{
  fail("line " + std::to_string(line) + ": " + what, error);
}

void Source::failAtByte(std::size_t byte, const std::string& what, Error error) const
{
  fail("byte " + std::to_string(byte) + ": " + what, error);
}

}  // namespace limn::meshio
