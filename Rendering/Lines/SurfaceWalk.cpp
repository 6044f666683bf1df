// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/SurfaceWalk.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

/// Triangles that one step may cross: more are slivers, or a point where many meet.
constexpr int kMostCrossings = 256;

Vec3d inPlane(Vec3d direction, Vec3d normal)
{
  return normalized(direction - normal * dot(direction, normal));
}

}  // namespace

SurfaceWalk::SurfaceWalk(const HatchSurface& surface, const HatchField& field)
    : surface_(surface.curved),
      field_(field),
      neighbour_(3 * surface_.mesh.triangles.size(), kNoCorner)
{
  for (std::size_t e = 0; e < surface.table.edges.size(); ++e) {
    const MeshEdge& edge = surface.table.edges[e];
    if (edge.faceCount != 2 || (surface.kinds[e] & kCreaseEdge) != 0) continue;
    neighbour_[edge.corner[0]] = edge.corner[1] / 3;
    neighbour_[edge.corner[1]] = edge.corner[0] / 3;
  }
}

SurfaceWalk::Corners SurfaceWalk::cornersOf(std::uint32_t triangle) const
{
  const auto& vertex = surface_.mesh.triangles[triangle].vertex;
  Corners corners;
  for (int i = 0; i < 3; ++i)
    corners.p[i] = surface_.mesh.position(vertex[i]);
  corners.normal =
      normalized(limn::cross(corners.p[1] - corners.p[0], corners.p[2] - corners.p[0]));
  return corners;
}

Vec3d SurfaceWalk::axisOf(std::uint8_t about)
{
  return {about == 1 ? 1.0 : 0.0, about == 2 ? 1.0 : 0.0, about == 3 ? 1.0 : 0.0};
}

std::uint8_t SurfaceWalk::circlesAt(std::size_t triangle) const
{
  const auto& vertex = surface_.mesh.triangles[triangle].vertex;
  for (const std::uint32_t v : vertex)
    if (v >= field_.circles.size()) return 0;
  return field_.flats.of(triangle) == FlatRegions::kNone ? field_.circles[vertex[0]]
                                                         : std::uint8_t{0};
}

std::vector<std::uint32_t> SurfaceWalk::circledTriangles() const
{
  std::vector<std::uint32_t> found;
  if (field_.circled.empty()) return found;
  std::vector<bool> isWanted(surface_.mesh.vertexCount(), false);
  for (const std::uint32_t v : field_.circled)
    isWanted[v] = true;
  const Span<const Triangle> triangles = surface_.mesh.triangles;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    if (circlesAt(t) == 0) continue;
    const auto& vertex = triangles[t].vertex;
    const auto* const first =
        std::find_if(vertex, vertex + 3, [&](std::uint32_t v) { return isWanted[v]; });
    if (first == vertex + 3) continue;
    isWanted[*first] = false;
    found.push_back(t);
  }
  return found;
}

bool SurfaceWalk::seed(std::size_t number, WalkPoint& point) const
{
  const auto& vertex = surface_.mesh.triangles[number].vertex;
  for (const std::uint32_t v : vertex)
    if (v >= surface_.mesh.vertexCount()) return false;
  const Corners corners = cornersOf(static_cast<std::uint32_t>(number));
  if (!isFinite(corners.normal) || corners.normal == Vec3d{0, 0, 0}) return false;
  point.triangle = static_cast<std::uint32_t>(number);
  point.position = (corners.p[0] + corners.p[1] + corners.p[2]) * (1.0 / 3);
  point.direction = axisAt(point, corners);
  return !(point.direction == Vec3d{0, 0, 0});
}

void SurfaceWalk::weigh(const WalkPoint& point, const Corners& corners, double (&weight)[3]) const
{
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    const Vec3d a = corners.p[(i + 1) % 3], b = corners.p[(i + 2) % 3];
    weight[i] = std::max(0.0, dot(limn::cross(b - a, point.position - a), corners.normal));
    sum += weight[i];
  }
  for (double& one : weight)
    one = sum > 0 ? one / sum : 1.0 / 3;
}

Vec3d SurfaceWalk::axisAt(const WalkPoint& point, const Corners& corners) const
{
  const std::uint32_t flat = field_.flats.of(point.triangle);
  if (flat != FlatRegions::kNone) return inPlane(field_.flats.regions[flat].along, corners.normal);
  const auto& vertex = surface_.mesh.triangles[point.triangle].vertex;
  if (const std::uint8_t about = circlesAt(point.triangle); about != 0) {
    // Of the smooth surface, carried along its normal into the triangle.
    const Vec3d n = normalAt(point), level = limn::cross(axisOf(about), n);
    const double facing = dot(n, corners.normal);
    constexpr double kPole = 1e-6;
    if (dot(level, level) > kPole && std::fabs(facing) > 0.5)
      return normalized(level - n * (dot(level, corners.normal) / facing));
  }
  double weight[3];
  weigh(point, corners, weight);
  // Of crosses that of the heaviest corner says which arms of the others go with its first.
  const int first =
      weight[0] >= weight[1] ? (weight[0] >= weight[2] ? 0 : 2) : (weight[1] >= weight[2] ? 1 : 2);
  const Vec3d guide = vec3Cast<double>(field_.axis[vertex[first]]);
  Vec3d sum = {0, 0, 0};
  for (int i = 0; i < 3; ++i) {
    Vec3d one = vec3Cast<double>(field_.axis[vertex[i]]);
    const Vec3d other = limn::cross(corners.normal, one);
    double along = dot(one, guide);
    const double across = dot(other, guide);
    if (std::fabs(across) > std::fabs(along)) {
      one = other;
      along = across;
    }
    sum = sum + one * (along < 0 ? -weight[i] : weight[i]);
  }
  return inPlane(sum, corners.normal);
}

Vec3d SurfaceWalk::fieldAt(const WalkPoint& point, bool across) const
{
  const Corners corners = cornersOf(point.triangle);
  const Vec3d axis = axisAt(point, corners);
  const Vec3d way = across ? limn::cross(corners.normal, axis) : axis;
  return dot(way, point.direction) < 0 ? -way : way;
}

Vec3d SurfaceWalk::normalAt(const WalkPoint& point) const
{
  const auto& vertex = surface_.mesh.triangles[point.triangle].vertex;
  double weight[3];
  weigh(point, cornersOf(point.triangle), weight);
  Vec3d sum = {0, 0, 0};
  for (int i = 0; i < 3; ++i)
    sum = sum + vec3Cast<double>(surface_.normals[vertex[i]]) * weight[i];
  return normalized(sum);
}

bool SurfaceWalk::cross(WalkPoint& point, int edge, const Corners& from) const
{
  const std::uint32_t next =
      neighbour_[3 * std::size_t{point.triangle} + static_cast<std::size_t>(edge)];
  if (next == kNoCorner) return false;
  const Corners to = cornersOf(next);
  const Vec3d hinge = normalized(from.p[(edge + 1) % 3] - from.p[edge]);
  // Faces that are wound the other way round look the other way.
  const auto& vertex = surface_.mesh.triangles[next].vertex;
  bool isWoundAlike = false;
  for (int i = 0; i < 3; ++i)
    isWoundAlike =
        isWoundAlike || (to.p[i] == from.p[(edge + 1) % 3] && to.p[(i + 1) % 3] == from.p[edge]);
  const Vec3d normal = isWoundAlike ? to.normal : -to.normal;
  if (to.normal == Vec3d{0, 0, 0} || vertex[0] == vertex[1]) return false;
  // What lies along the edge stays, what leaves it leaves it in the other plane.
  const double along = dot(point.direction, hinge);
  const double away = std::sqrt(std::max(0.0, 1 - along * along));
  point.direction = hinge * along + limn::cross(hinge, normal) * away;
  point.triangle = next;
  return true;
}

bool SurfaceWalk::goStraight(WalkPoint& point, double length) const
{
  for (int crossings = 0; crossings < kMostCrossings; ++crossings) {
    const Corners corners = cornersOf(point.triangle);
    double way = length;
    int exit = -1;
    for (int i = 0; i < 3; ++i) {
      const Vec3d inwards = limn::cross(corners.normal, corners.p[(i + 1) % 3] - corners.p[i]);
      const double rate = dot(point.direction, inwards);
      if (!(rate < 0)) continue;
      const double toEdge = std::max(0.0, dot(point.position - corners.p[i], inwards) / -rate);
      if (toEdge < way) {
        way = toEdge;
        exit = i;
      }
    }
    point.position = point.position + point.direction * way;
    if (exit < 0) return true;
    length -= way;
    if (!cross(point, exit, corners)) return false;
  }
  return false;
}

bool SurfaceWalk::stepAlong(WalkPoint& point, bool across, double length, double drift) const
{
  const Vec3d start = fieldAt(point, across);
  constexpr double kHalfRightAngle = 0.7071;
  if (!(dot(start, point.direction) > kHalfRightAngle)) return false;
  WalkPoint middle = point;
  middle.direction = start;
  if (!goStraight(middle, 0.5 * length)) {
    point.direction = start;
    return goStraight(point, length);
  }
  // The middle's direction, back in the plane of the start.
  const Vec3d there = fieldAt(middle, across);
  const Vec3d normal = cornersOf(point.triangle).normal;
  const Vec3d direction = inPlane(there, normal);
  point.direction = dot(direction, start) > kHalfRightAngle ? direction : start;
  if (drift != 0)
    point.direction = normalized(point.direction + limn::cross(normal, point.direction) * drift);
  if (!goStraight(point, length)) return false;
  return true;
}

}  // namespace limn
