// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Mesh/Io/Source.h"
#include "Rendering/Base/Vec.h"

#include <cstddef>
#include <string>
#include <vector>

namespace limn::meshio {

/// Which of OpenMesh's parsers reads a normal form. OFF has none of its own here: OpenMesh's parser
/// for it takes what the header announces only from a file of that name, never from a stream.
enum class Parser { kObj, kPly, kStl, kOm };

/// What a format's check hands over: bytes that OpenMesh's parser reads without loss or danger, and
/// what the parser must find in them.
struct NormalForm {
  Parser parser = Parser::kPly;
  std::string bytes;
  std::size_t vertexCount = 0;
  std::size_t faceCount = 0;     ///< in the file, also the degenerate ones
  std::vector<Vec3d> positions;  ///< the file's own precision; empty if that is float
  bool hasNormals = false;       ///< per vertex, or per corner
  bool hasTexCoords = false;     ///< per vertex, or per corner
  bool hasVertexColors = false;
  bool hasFaceColors = false;
};

/// Each checks a whole file of its format and throws Fault for the first thing that is wrong.
/// Memory stays in proportion to the size of the file, whatever numbers the file announces.
NormalForm normalizeObj(Source& source);
NormalForm normalizeOff(Source& source);
NormalForm normalizePly(Source& source);
NormalForm normalizeStl(Source& source);
NormalForm normalizeOm(Source& source);

}  // namespace limn::meshio
