// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Mesh/MoveVertices.h"

#include "Rendering/Base/Executor.h"

#include <algorithm>

namespace limn {
namespace {

void fill(const MeshView& mesh, Span<const Vec3f> normals, VertexBatch& batch)
{
  batch.hasNormals = !normals.empty();
  for (int i = 0; i < batch.count; ++i) {
    const std::size_t v = batch.first + static_cast<std::size_t>(i);
    const Vec3d p = mesh.position(v);
    batch.x[i] = p.x;
    batch.y[i] = p.y;
    batch.z[i] = p.z;
    if (!batch.hasNormals) continue;
    batch.normalX[i] = normals[v].x;
    batch.normalY[i] = normals[v].y;
    batch.normalZ[i] = normals[v].z;
  }
}

/// Vertices lost in one part of the mesh.
struct Lost {
  std::size_t count = 0, first = 0;
};

void keep(const MeshView& mesh, const VertexBatch& batch, MovedVertices& moved, Lost& lost)
{
  for (int i = 0; i < batch.count; ++i) {
    const std::size_t v = batch.first + static_cast<std::size_t>(i);
    const Vec3d p = {batch.x[i], batch.y[i], batch.z[i]};
    const Vec3f rounded = vec3Cast<float>(p);
    if (moved.positions.empty())
      moved.precisePositions[v] = p;
    else
      moved.positions[v] = rounded;
    if (!moved.normals.empty())
      moved.normals[v] = {batch.normalX[i], batch.normalY[i], batch.normalZ[i]};
    const bool isGood = moved.positions.empty() ? isFinite(p) : isFinite(rounded);
    if (!isGood && isFinite(mesh.position(v)) && lost.count++ == 0) lost.first = v;
  }
}

}  // namespace

void moveVertices(const VertexShader& shader, const MeshView& mesh, Span<const Vec3f> normals,
                  int threads, MovedVertices& moved)
{
  constexpr std::size_t kBatch = VertexBatch::kCapacity, kPart = 64 * kBatch;
  const std::size_t count = mesh.vertexCount();
  moved.positions.resize(mesh.positions.size());
  moved.precisePositions.resize(mesh.precisePositions.size());
  moved.normals.resize(shader.movesNormals() ? normals.size() : 0);
  std::vector<Lost> lost((count + kPart - 1) / kPart);
  parallelFor(threads, lost.size(), [&](std::size_t part) {
    VertexBatch batch;
    const std::size_t end = std::min(count, (part + 1) * kPart);
    for (std::size_t first = part * kPart; first < end; first += kBatch) {
      batch.first = static_cast<std::uint32_t>(first);
      batch.count = static_cast<int>(std::min(kBatch, end - first));
      fill(mesh, normals, batch);
      shader.move(batch);
      keep(mesh, batch, moved, lost[part]);
    }
  });
  moved.lostVertices = moved.firstLost = 0;
  for (const Lost& part : lost) {
    if (moved.lostVertices == 0) moved.firstLost = part.first;
    moved.lostVertices += part.count;
  }
}

}  // namespace limn
