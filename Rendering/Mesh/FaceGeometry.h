// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Mesh/MeshView.h"

#include <cstdint>
#include <vector>

namespace limn {

/// Where flat shading lights a face (DESIGN: one evaluation at the centroid with the face normal).
/// A face is a cell: all triangles that one polygon was cut into share one entry.
struct FaceGeometry {
  std::vector<Vec3d> centroid;  ///< area-weighted, in model coordinates
  std::vector<Vec3f> normal;    ///< unit, outward by the winding; zero for faces without area
};

/// `cells[t]` is the cell of triangle t, empty if every triangle is its own cell. Sums run in
/// double in the order of the triangles. A face without area gets the mean of its corners as
/// centroid. Triangles with a vertex out of range or not finite are left out.
FaceGeometry faceGeometry(const MeshView& mesh, Span<const std::uint32_t> cells,
                          std::size_t cellCount);

/// The first corner of each face's first triangle, in model coordinates, as another place to light
/// it at; zero for faces without one. Arguments as above.
std::vector<Vec3d> firstCorners(const MeshView& mesh, Span<const std::uint32_t> cells,
                                std::size_t cellCount);

}  // namespace limn
