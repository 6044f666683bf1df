// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Status.h"

#include <cstddef>
#include <functional>
#include <string>

namespace limn::meshio {

/// A fault on its way to readMesh(), which turns it into its Status. An exception, because
/// OpenMesh's parsers lie between the finder of a fault and readMesh() and know no other way out.
struct Fault {
  Status status;
};

/// A mesh file in memory.
class Source {
 public:
  using Progress = std::function<bool(double fraction)>;

  /// Reads the whole file. Throws Fault if there is none, or it is no regular file, or empty.
  Source(std::string path, Progress progress);

  const std::string& path() const { return path_; }
  const std::string& bytes() const { return bytes_; }
  /// Gives the bytes away; bytes() is empty then.
  std::string takeBytes() { return std::move(bytes_); }

  /// Tells the user; throws Fault if the user cancels. Cheap enough for each line of a file.
  void reportChecked(std::size_t byte);
  void reportParsed(std::size_t done, std::size_t total);

  [[noreturn]] void fail(const std::string& what, Error error = Error::kFile) const;
  [[noreturn]] void failAtLine(std::size_t line, const std::string& what,
                               Error error = Error::kFile) const;
  [[noreturn]] void failAtByte(std::size_t byte, const std::string& what,
                               Error error = Error::kFile) const;

 private:
  void report(double fraction);

  std::string path_;
  std::string bytes_;
  Progress progress_;
  double reported_ = 0;
};

}  // namespace limn::meshio
