// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cassert>
#include <cstdint>
#include <string>

/// Stops a debug build at one of our own mistakes. Data that comes from a user gets a Status.
#define LIMN_ASSERT(condition) assert(condition)

namespace limn {

enum class Error : std::uint8_t {
  kNone,
  kIndexOutOfRange,     ///< a triangle names a vertex that is not there
  kNotFinite,           ///< NaN or infinity where a number is needed
  kSizeMismatch,        ///< an attribute array has not one value per vertex or per cell
  kInvalidImageSize,    ///< zero, negative or larger than kMaxImageSide
  kInvalidSampleCount,  ///< not 1, 2, 4 or 8
  kInvalidLight,        ///< a shape, unit or number of lights that cannot be
  kTooManyPrimitives,   ///< more clusters or triangles in one frame than an owner can number
  kMissingData,         ///< the scene lacks what the chosen renderer or shading needs
  kFile,                ///< a file cannot be opened, read or understood
};

/// Outcome of an operation on user data. `message` names the thing and the mend; empty when ok.
struct [[nodiscard]] Status {
  Error error = Error::kNone;
  std::string message;

  bool ok() const { return error == Error::kNone; }
};

}  // namespace limn
