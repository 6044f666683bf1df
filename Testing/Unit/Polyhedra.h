// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Mesh/MeshView.h"

#include <cstdint>
#include <functional>
#include <vector>

/// Meshes whose edges are known.
namespace limn::testing {

struct Polyhedron {
  std::vector<Vec3f> positions;
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> cells;  ///< face of each triangle

  MeshView view() const { return {positions, {}, triangles}; }
  /// Three points for each triangle.
  Polyhedron unwelded() const;
  /// A face about its centre, counter-clockwise from outside of a convex body about the origin.
  void addFace(std::vector<std::uint32_t> corners);
};

// All with corners on the unit sphere but the cube, which reaches from -1 to 1.
Polyhedron tetrahedron();
Polyhedron cube();
Polyhedron octahedron();
Polyhedron dodecahedron();
Polyhedron icosahedron();
/// cells x cells squares of [-1, 1]^2 at z = 0, towards +z.
Polyhedron plane(std::uint32_t cells);
/// at(s, t) for s and t from 0 to 1, across x along squares, towards d/ds x d/dt.
Polyhedron grid(std::uint32_t across, std::uint32_t along,
                const std::function<Vec3f(double s, double t)>& at);
/// R and r about the z axis.
Polyhedron torus(double R, double r, std::uint32_t around, std::uint32_t across);

}  // namespace limn::testing
