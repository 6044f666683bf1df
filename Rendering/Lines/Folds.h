// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Lines/FacingBounds.h"
#include "Rendering/Mesh/EdgeTable.h"
#include "Rendering/Mesh/RecentValues.h"
#include "Rendering/Scene.h"
#include "Rendering/Vertex/ScreenVertex.h"

#include <optional>
#include <vector>

namespace limn {

struct PlacedPoint {
  double x, y, w;  ///< in pixels of the picture
  bool isPlaced;   ///< not before the near plane
};

/// Where a camera puts points of a model in a picture.
class PicturePlane {
 public:
  PicturePlane(const Camera& camera, const Mat4d& modelToWorld, double width, double height);

  PlacedPoint place(Vec3d at) const
  {
    const auto row = [&](int r) {
      const auto& m = toClip_.m[r];
      return (m[0] * at.x + m[1] * at.y) + (m[2] * at.z + m[3]);
    };
    const double w = row(3);
    if (!(w >= kSmallestW) || !(row(2) + w >= 0)) return {0, 0, 1, false};
    return {row(0) / w * halfWidth_ + halfWidth_, row(1) / w * halfHeight_ + halfHeight_, w, true};
  }
  bool contains(const PlacedPoint& p, double margin) const
  {
    return p.x > -margin && p.x < 2 * halfWidth_ + margin && p.y > -margin &&
           p.y < 2 * halfHeight_ + margin;
  }
  /// Pixels of a unit at w = 1, at most.
  double pixelsPerUnit() const { return pixelsPerUnit_; }

 private:
  Mat4d toClip_;
  double halfWidth_, halfHeight_;
  double pixelsPerUnit_ = 0;
};

struct PlacedEdge {
  Vec3d place[2];
  PlacedPoint screen[2];
};

/// An edge at which facets end on the screen: both faces lie on the same side of it there, or it is
/// a border.
struct Fold {
  std::uint32_t vertex[2];
  PlacedEdge edge;
  bool bulges;  ///< the nearer of its faces turns its front to the eye

  bool isSame(const Fold& other) const
  {
    return vertex[0] == other.vertex[0] && vertex[1] == other.vertex[1];
  }
};

/// Finds the folds of a mesh, one thread each. Requires: vertex normals.
class FoldFinder {
 public:
  FoldFinder(const MeshView& mesh, const EdgeTable& table, const FeatureArrays& arrays,
             const PicturePlane& plane, const ModelEye& eye)
      : mesh_(mesh), table_(table), arrays_(arrays), plane_(plane), eye_(eye)
  {
  }

  /// Of a triangle's edges and those of its neighbours.
  void addAbout(std::uint32_t triangle, std::vector<Fold>& folds);
  /// The normal at a corner, of unit length.
  Vec3d normalOf(std::uint32_t corner) const;

 private:
  struct PlacedVertex {
    Vec3d place;
    PlacedPoint screen;
  };

  std::uint32_t edgeFrom(std::uint32_t corner) const;
  void add(std::uint32_t edge, std::vector<Fold>& folds);
  std::optional<Fold> findFold(const MeshEdge& edge);
  std::uint32_t vertexOf(std::uint32_t corner) const;
  const PlacedVertex& apexOf(std::uint32_t corner);
  const PlacedVertex& at(std::uint32_t vertex);

  const MeshView& mesh_;
  const EdgeTable& table_;
  const FeatureArrays& arrays_;
  const PicturePlane& plane_;
  const ModelEye& eye_;
  // Triangles in a row share most of these.
  RecentValues<PlacedVertex> vertexAt_;
  RecentValues<std::optional<Fold>> foldAt_;  ///< by edge
};

}  // namespace limn
