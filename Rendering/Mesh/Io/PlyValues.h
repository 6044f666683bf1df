// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Mesh/Io/PlyHeader.h"

namespace limn::meshio {

/// The values after the header of a PLY file, one after the other, whatever the encoding.
class PlyValues {
 public:
  PlyValues(Source& source, const PlyHeader& header);

  /// The next value. Throws Fault if it is not there or is no number. May be NaN or infinite.
  double next(PlyType type);
  /// The next value of a whole-number type, from 0 to `largest`; `what` names it in the Fault
  /// thrown otherwise.
  std::uint32_t nextCount(PlyType type, const char* what, std::size_t largest);
  /// The next value as the number of things that follow, each of `size` bytes at least in a binary
  /// file; `what` names them in the Fault thrown if the file is too short for so many.
  std::uint32_t nextLength(PlyType type, const char* what, std::size_t size);
  /// Passes over the next value, whatever it is.
  void skip(PlyType type);

  /// Throws Fault about the value that was read last.
  [[noreturn]] void fail(const std::string& what, Error error = Error::kFile) const;

 private:
  std::size_t remainingBytes() const { return source_.bytes().size() - byte_; }
  std::string_view nextWord();
  double nextBinary(PlyType type);

  Source& source_;
  PlyEncoding encoding_;
  std::size_t byte_;
  std::size_t line_;  ///< of byte_; only of an ASCII file
  std::size_t valueByte_ = 0;
};

}  // namespace limn::meshio
