// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/Folds.h"

#include "Rendering/Mesh/EdgesAhead.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace limn {
namespace {

/// On which side of the edge's line a point is; 0 if that is not known.
double sideOf(const PlacedEdge& edge, const PlacedPoint& p)
{
  const PlacedPoint &a = edge.screen[0], &b = edge.screen[1];
  return p.isPlaced ? (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) : 0.0;
}

}  // namespace

PicturePlane::PicturePlane(const Camera& camera, const Mat4d& modelToWorld, double width,
                           double height)
    : toClip_(camera.viewToClip * (camera.worldToView * modelToWorld)),
      halfWidth_(width / 2.0),
      halfHeight_(height / 2.0)
{
  for (int r = 0; r < 2; ++r) {
    const auto& m = toClip_.m[r];
    const double size = std::sqrt(m[0] * m[0] + m[1] * m[1] + m[2] * m[2]);
    pixelsPerUnit_ = std::max(pixelsPerUnit_, size * (r == 0 ? halfWidth_ : halfHeight_));
  }
}

Vec3d FoldFinder::normalOf(std::uint32_t corner) const
{
  const std::uint32_t normal = arrays_.normalOfCorner.empty()
                                   ? mesh_.triangles[corner / 3].vertex[corner % 3]
                                   : arrays_.normalOfCorner[corner];
  return normalized(vec3Cast<double>(arrays_.vertexNormals[normal]));
}

std::uint32_t FoldFinder::vertexOf(std::uint32_t corner) const
{
  return table_.place[mesh_.triangles[corner / 3].vertex[corner % 3]];
}

/// Opposite to the edge that a face has from a corner on.
const FoldFinder::PlacedVertex& FoldFinder::apexOf(std::uint32_t corner)
{
  return at(vertexOf(nextCorner(nextCorner(corner))));
}

/// Until the next call.
const FoldFinder::PlacedVertex& FoldFinder::at(std::uint32_t vertex)
{
  return vertexAt_.at(vertex, [this](std::uint32_t v) {
    const Vec3d place = mesh_.position(v);
    return PlacedVertex{place, plane_.place(place)};
  });
}

void FoldFinder::addAbout(std::uint32_t triangle, std::vector<Fold>& folds)
{
  for (std::uint32_t k = 0; k < 3; ++k) {
    const std::uint32_t edge = edgeFrom(3 * triangle + k);
    if (edge == kNoCorner) continue;
    add(edge, folds);
    forEachFace(table_.edges[edge], [&](std::uint32_t corner) {
      if (corner / 3 == triangle) return;
      for (const std::uint32_t other : {nextCorner(corner), nextCorner(nextCorner(corner))})
        if (const std::uint32_t beside = edgeFrom(other); beside != kNoCorner) add(beside, folds);
    });
  }
}

/// Number of the edge that a face has from a corner on; kNoCorner where the table has left it out.
std::uint32_t FoldFinder::edgeFrom(std::uint32_t corner) const
{
  const auto [low, high] = std::minmax({vertexOf(corner), vertexOf(nextCorner(corner))});
  return table_.edgeBetween(low, high);
}

void FoldFinder::add(std::uint32_t edge, std::vector<Fold>& folds)
{
  const std::optional<Fold>& fold =
      foldAt_.at(edge, [this](std::uint32_t e) { return findFold(table_.edges[e]); });
  if (fold) folds.push_back(*fold);
}

std::optional<Fold> FoldFinder::findFold(const MeshEdge& edge)
{
  Fold fold;
  for (int end = 0; end < 2; ++end) {
    const PlacedVertex& vertex = at(edge.vertex[end]);
    if (!vertex.screen.isPlaced) return {};
    fold.vertex[end] = edge.vertex[end];
    fold.edge.place[end] = vertex.place;
    fold.edge.screen[end] = vertex.screen;
  }
  const Vec3d along = fold.edge.place[1] - fold.edge.place[0];
  std::uint32_t nearer = edge.corner[0];
  if (edge.isShared()) {
    const PlacedVertex apex[2] = {apexOf(edge.corner[0]), apexOf(edge.corner[1])};
    const double side = sideOf(fold.edge, apex[0].screen) * sideOf(fold.edge, apex[1].screen);
    if (!(side > 0)) return {};
    // One face hides the other if this lies behind its plane.
    const Vec3d normal = cross(along, apex[0].place - fold.edge.place[0]);
    const bool isBefore = dot(normal, apex[1].place - fold.edge.place[0]) > 0;
    if (isBefore == (dot(normal, eye_.toward(fold.edge.place[0])) > 0)) nearer = edge.corner[1];
  }
  const Vec3d normal = cross(along, apexOf(nearer).place - fold.edge.place[0]);
  const std::uint32_t first = nearer / 3 * 3;
  const Vec3d outward = normalOf(first) + normalOf(first + 1) + normalOf(first + 2);
  fold.bulges = (dot(normal, outward) > 0) == (dot(normal, eye_.toward(fold.edge.place[0])) > 0);
  return fold;
}

}  // namespace limn
