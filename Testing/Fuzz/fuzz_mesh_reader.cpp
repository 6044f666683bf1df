// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause

// Feeds any bytes to the mesh readers. The first byte picks the format, the rest is the file.
// A mesh that is read must be consistent; anything else must be refused with a message.

#include "Rendering/Mesh/Io/ReadMesh.h"

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

namespace {

void require(bool condition)
{
  if (!condition) std::abort();
}

void requireConsistent(const limn::MeshFile& mesh)
{
  const std::size_t vertices = mesh.vertexCount();
  require(vertices > 0);
  require(mesh.positions.empty() || mesh.precisePositions.empty());
  require(mesh.normals.empty() || mesh.normals.size() == vertices);
  require(mesh.texCoords.empty() || mesh.texCoords.size() == vertices);
  require(mesh.vertexColors.empty() || mesh.vertexColors.size() == vertices);
  require(mesh.faceColors.empty() || mesh.faceColors.size() == mesh.polygonCount());
  require(mesh.polygonOffsets.front() == 0);
  require(mesh.polygonOffsets.back() == mesh.polygonCorners.size());
  for (std::size_t i = 0; i < mesh.polygonCount(); ++i) {
    require(mesh.polygonOffsets[i] + 3 <= mesh.polygonOffsets[i + 1]);
  }
  for (const std::uint32_t corner : mesh.polygonCorners)
    require(corner < vertices);
  for (const limn::Vec3f& position : mesh.positions)
    require(limn::isFinite(position));
  for (const limn::Vec3f& normal : mesh.normals)
    require(limn::isFinite(normal));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  if (size == 0) return 0;
  static const char* const kExtensions[] = {".obj", ".off", ".ply", ".stl", ".om"};
  static const std::string stem =
      (std::filesystem::temp_directory_path() / ("limn-fuzz-" + std::to_string(getpid()))).string();
  const std::string path = stem + kExtensions[data[0] % 5];
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(data + 1), static_cast<std::streamsize>(size - 1));

  limn::MeshFile mesh;
  const limn::Status status = limn::readMesh(path, mesh);
  if (status.ok()) {
    requireConsistent(mesh);
  } else {
    require(status.message.rfind(path + ": ", 0) == 0 && mesh.vertexCount() == 0);
  }
  std::filesystem::remove(path);
  return 0;
}
