// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Mesh/Io/Source.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace limn::meshio {

enum class PlyType : std::uint8_t {
  kInt8,
  kUint8,
  kInt16,
  kUint16,
  kInt32,
  kUint32,
  kFloat32,
  kFloat64
};

std::size_t sizeOf(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::kFloat32;
  bool isList = false;
  PlyType countType = PlyType::kUint8;  ///< of a list
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
};

enum class PlyEncoding : std::uint8_t { kAscii, kLittleEndian, kBigEndian };

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::kAscii;
  std::vector<PlyElement> elements;
  std::size_t size = 0;       ///< bytes before the data
  std::size_t lineCount = 0;  ///< lines before the data
};

/// Throws Fault if the file does not start with the header of a PLY file, or if it announces more
/// than the rest of the file can hold.
PlyHeader readPlyHeader(const Source& source);

}  // namespace limn::meshio
