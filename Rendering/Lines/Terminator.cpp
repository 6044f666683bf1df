// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/Terminator.h"

#include <cmath>

namespace limn {
namespace {

/// Sees what the light does.
Camera cameraOf(const LightRays& light)
{
  Camera camera = {Mat4d::identity(), Mat4d::identity(), light.isParallel};
  if (!light.isParallel) {
    camera.worldToView = translation(-light.source);
    return camera;
  }
  const Vec3d z = light.source;
  const Vec3d x = normalized(cross(std::fabs(z.y) < 0.9 ? Vec3d{0, 1, 0} : Vec3d{1, 0, 0}, z));
  const Vec3d y = cross(z, x);
  camera.worldToView = {{{x.x, x.y, x.z, 0}, {y.x, y.y, y.z, 0}, {z.x, z.y, z.z, 0}, {0, 0, 0, 1}}};
  return camera;
}

/// What of `lines` the light's cone holds.
ContourLines insideCone(const ContourLines& lines, const LightRays& light,
                        const Mat4d& modelToWorld)
{
  ContourLines result;
  result.points = lines.points;
  std::vector<LineLink> links;
  const auto isHeld = [&](Vec3d p) { return light.holds(transformPoint(modelToWorld, p)); };
  const auto leaves = [&](std::uint32_t in, std::uint32_t out) {
    Vec3d held = lines.points[in], lost = lines.points[out];
    constexpr int kHalvings = 50;
    for (int i = 0; i < kHalvings; ++i) {
      const Vec3d middle = (held + lost) * 0.5;
      (isHeld(middle) ? held : lost) = middle;
    }
    result.points.push_back(held);
    return static_cast<std::uint32_t>(result.points.size() - 1);
  };
  const LineChains& chains = lines.chains;
  for (std::size_t c = 0; c + 1 < chains.first.size(); ++c)
    for (std::uint32_t i = chains.first[c]; i + 1 < chains.first[c + 1]; ++i) {
      std::uint32_t a = chains.vertex[i], b = chains.vertex[i + 1];
      const bool isHeldA = isHeld(lines.points[a]), isHeldB = isHeld(lines.points[b]);
      if (!isHeldA && !isHeldB) continue;
      if (!isHeldB) b = leaves(a, b);
      if (!isHeldA) a = leaves(b, a);
      links.push_back({a, b, kNoCorner});
    }
  chainLinks(links, result.points.size(), result.chains, nullptr);
  result.chains.flags.assign(result.chains.vertex.size(), 0);
  result.slack.assign(result.points.size(), 0.0f);
  return result;
}

}  // namespace

ContourLines terminatorLines(const MeshView& mesh, const EdgeTable& table,
                             const FeatureArrays& arrays, const FacingBounds& bounds,
                             const LightRays& light, const Mat4d& modelToWorld, int threads)
{
  ContourLines lines =
      facetContours(mesh, table, arrays, bounds, cameraOf(light), modelToWorld, threads);
  return light.isCone ? insideCone(lines, light, modelToWorld) : lines;
}

}  // namespace limn
