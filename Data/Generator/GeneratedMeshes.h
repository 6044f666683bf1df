// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Vec.h"
#include "Rendering/Mesh/MeshView.h"

#include <cstdint>
#include <vector>

/// The meshes of Data/Meshes, made from formulas. Counter-clockwise seen from outside, y up.
namespace limn {

struct GeneratedMesh {
  std::vector<Vec3f> positions;
  std::vector<Vec3f> normals;    ///< unit, one per position; empty if the mesh has none
  std::vector<Vec2f> texCoords;  ///< likewise
  std::vector<std::vector<std::uint32_t>> polygons;

  /// Fans (0, i, i+1) of the polygons.
  std::vector<Triangle> triangles() const;
};

/// Centre at the origin; `around` columns and `along` rings of faces.
GeneratedMesh sphere(int around, int along, double radius);
/// The unit sphere with dents, ridges and grain: waves of three lengths in seven directions each.
GeneratedMesh rock(int around, int along);
/// Around the y axis; radius of the ring and of the tube.
GeneratedMesh torus(int around, int across, double ring, double tube);
/// A tube along the trefoil (sin t + 2 sin 2t, cos t - 2 cos 2t, -sin 3t).
GeneratedMesh knot(int along, int across, double tube);
/// A spur gear with a round bore, flat and sharp; no normals.
GeneratedMesh gear(int teeth, double thickness);
/// y = 0.25 sin(pi x) over [-2, 2] x [-1, 1], in quads.
GeneratedMesh extrudedSine(int columns, int rows);
/// An open sheet in the plane of x and z, gently waved.
GeneratedMesh sheet(int side);
/// The unit sphere with texture coordinates: u grows eastwards from -z, v from the south pole to
/// the north pole. The points of that seam and of the poles are there for each u.
GeneratedMesh globe(int around, int along);
/// Side 2 in the plane z = 0, which looks along z, with texture coordinates from -0.5 to 1.5, for
/// what is beyond an image to be seen.
GeneratedMesh board(int side);
/// Side 2, six quads, eight points; no normals.
GeneratedMesh cube();
/// The Utah teapot, after the control points that Martin Newell published in 1975: 32 bicubic
/// patches, each cut into divisions x divisions quads, seams welded. Height 3.15.
GeneratedMesh teapot(int divisions);

}  // namespace limn
