// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Lines/FacingBounds.h"
#include "Rendering/Mesh/Curvature.h"

#include <cstdint>
#include <vector>

namespace limn {

/// A smooth surface: unit normals, one per vertex, and its vertexCurvature().
struct CurvedSurface {
  MeshView mesh;
  Span<const Vec3f> normals;
  Span<const VertexCurvature> curvature;
};

/// The length s by which thresholds are told, so that they do not depend on the unit of length: a
/// twentieth of half the diagonal of the mesh's box.
double featureSize(const MeshView& mesh, int threads = 1);
/// Of finiteBox() of the mesh.
double featureSize(const Box& box);

/// Box about the curvature tensors K = k_1 e_1 e_1^T + k_2 e_2 e_2^T of some vertices.
struct CurvatureBox {
  Vec3f center;  ///< of a ball about the vertices
  float radius;
  float size;       ///< at least the largest |k_1| + |k_2|; infinite: nothing is known
  float middle[6];  ///< xx, yy, zz, xy, yz, zx
  float half[6];
};

/// Of each kEdgesPerBound edges of an EdgeTable how the surface bends there, for stretches that
/// have no suggestive contour: seen from behind, or with a curvature along the view, v^T K v, of
/// one sign. None, and nothing is left out, while `boxes` is empty.
struct CurveBounds {
  FacingBounds facing;  ///< boundEnds()
  std::vector<CurvatureBox> boxes;
  std::vector<std::uint8_t> isConvex;  ///< by box: v^T K v is not negative from anywhere
  double featureSize = 0;
};

/// The same on any number of threads.
CurveBounds boundCurves(const CurvedSurface& surface, const EdgeTable& table, int threads);

/// Which bounded stretches have no suggestive contour for a camera.
class BoundedCurves {
 public:
  /// `bounds` is borrowed.
  BoundedCurves(const CurveBounds& bounds, const Camera& camera, const Mat4d& modelToWorld)
      : bounds_(bounds), facing_(bounds.facing, camera, modelToWorld), eye_(camera, modelToWorld)
  {
  }

  bool hasNone(std::size_t box) const
  {
    if (bounds_.boxes.empty()) return false;
    return bounds_.isConvex[box] != 0 || facing_.side(box) == BoundedFacing::Side::kBack ||
           hasOneSign(bounds_.boxes[box]);
  }

 private:
  bool hasOneSign(const CurvatureBox& box) const;

  const CurveBounds& bounds_;
  BoundedFacing facing_;
  ModelEye eye_;
};

}  // namespace limn
