// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Lines/ChainEdges.h"
#include "Rendering/Lines/FacingBounds.h"

#include <vector>

/// Lines where a surface turns away from the viewer. They change with every step of the camera.
namespace limn {

/// Edges of which one face is seen from its front and the other from its back, however they are
/// wound; closed meshes have closed chains. Borders are none. All are kOuterLine. `bounds`: none,
/// or those of boundFaces(), which change nothing but the time that it takes.
EdgeChains silhouetteEdges(const MeshView& mesh, const EdgeTable& table, const FacingBounds& bounds,
                           const Camera& camera, const Mat4d& modelToWorld, int threads);

/// What a segment of a smooth contour lies in.
struct ContourFacet {
  std::uint32_t triangle;  ///< kNoCorner along an edge
  bool bulges;             ///< the surface's front lies before what is behind it
};

/// Lines through points of their own.
struct ContourLines {
  std::vector<Vec3d> points;
  std::vector<float> slack;
  std::vector<float> share = {};  ///< LineSet::share
  LineChains chains;
  std::vector<ContourFacet> facets = {};  ///< of smooth contours, by segment as chains.flags

  LineSet lines(const LineStyle& style) const
  {
    return {{{}, points, {}}, chains.vertex, chains.first, chains.flags, slack, style, share};
  }
};

/// The contour n.v = 0 of the smooth surface that `arrays.vertexNormals` tells of, one segment a
/// triangle. On an edge from P to Q, with e = Q - P, a crossing lies where n(t).(eye - b(t))
/// changes its sign, b the cubic with the control points P + (e - (e.N_P) N_P) / 3 and likewise at
/// Q, and n the quadratic with the middle N_P + N_Q mirrored at the plane across e (Vlachos et al.
/// 2001). Where the two sides of an edge have other normals the contour follows the edge. Closed
/// meshes have closed chains: at n.v = 0 a vertex counts as front. All segments are kOuterLine.
/// Where a contour runs along the gaze it turns back on the screen; the part that does not bulge
/// goes away from there right behind the surface, which depths would not tell: it is kConcealedLine
/// as long as it goes farther away.
/// `bounds`: none, or those of boundNormals(), as above.
/// Requires: vertex normals for all vertices or corners. The same on any number of threads.
ContourLines smoothContours(const MeshView& mesh, const EdgeTable& table,
                            const FeatureArrays& arrays, const FacingBounds& bounds,
                            const Camera& camera, const Mat4d& modelToWorld, int threads);

/// The same in the facets themselves, n and b linear along an edge, as Phong's shading has them.
/// Not kOuterLine, and without slack.
ContourLines facetContours(const MeshView& mesh, const EdgeTable& table,
                           const FeatureArrays& arrays, const FacingBounds& bounds,
                           const Camera& camera, const Mat4d& modelToWorld, int threads);

}  // namespace limn
