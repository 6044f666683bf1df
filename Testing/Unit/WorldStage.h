// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Lines/CastShadows.h"
#include "Rendering/Lines/Intersections.h"
#include "Testing/Unit/Polyhedra.h"

#include <cmath>
#include <memory>
#include <vector>

namespace limn::testing {

/// Bodies in the world, and lines of what they do to each other.
struct WorldStage {
  WorldMesh world;
  RefinedWorld refined;
  std::unique_ptr<const TriangleTree> tree;  ///< of it
  std::vector<double> creaseDegrees;
  std::vector<std::uint8_t> isWanted;

  explicit WorldStage(const std::vector<PlacedMesh>& bodies)
      : creaseDegrees(bodies.size(), 40), isWanted(bodies.size(), 1)
  {
    status = buildWorldMesh(bodies, isWanted, 2, world);
    WorldNormals normals;
    if (status.ok()) status = worldNormals(world, creaseDegrees, 2, normals);
    if (status.ok()) refined = refineWorld(world, normals);
    tree = std::make_unique<const TriangleTree>(refined.mesh);
  }
  ContourLines shadowOf(std::size_t body, const LightRays& light) const
  {
    const auto casters = shadowCasters(refined.mesh, refined.normals, light, 2);
    const auto pieces = shadowPieces(refined.mesh, *tree, light, casters, creaseDegrees, 2);
    return shadowBorder(refined, casters, pieces, light, body, Mat4d::identity()).lines;
  }
  ContourLines cuts(std::size_t body = 0) const
  {
    return intersectionLines(world, intersections(world, TriangleTree(world), isWanted, 2),
                             isWanted, body, Mat4d::identity());
  }
  Status status;
};

inline std::size_t chainCount(const ContourLines& lines)
{
  return lines.chains.first.empty() ? 0 : lines.chains.first.size() - 1;
}
inline std::size_t closedChains(const ContourLines& lines)
{
  const LineChains& chains = lines.chains;
  std::size_t count = 0;
  for (std::size_t c = 0; c < chainCount(lines); ++c)
    count += chains.vertex[chains.first[c]] == chains.vertex[chains.first[c + 1] - 1] ? 1 : 0;
  return count;
}
inline double lengthOf(const ContourLines& lines)
{
  double sum = 0;
  for (std::size_t c = 0; c < chainCount(lines); ++c)
    for (std::uint32_t i = lines.chains.first[c]; i + 1 < lines.chains.first[c + 1]; ++i) {
      const Vec3d step =
          lines.points[lines.chains.vertex[i]] - lines.points[lines.chains.vertex[i + 1]];
      sum += std::sqrt(dot(step, step));
    }
  return sum;
}

/// Scaled, then moved.
inline Mat4d placed(double scale, Vec3d to)
{
  return {{{scale, 0, 0, to.x}, {0, scale, 0, to.y}, {0, 0, scale, to.z}, {0, 0, 0, 1}}};
}

inline LightRays sunlight(Vec3d direction)
{
  return {true, normalized(-direction), false, {0, 0, 0}, 0};
}
inline LightRays lamp(Vec3d position)
{
  return {false, position, false, {0, 0, 0}, 0};
}

}  // namespace limn::testing
