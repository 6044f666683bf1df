// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Lines/Contours.h"

namespace limn {

/// Where and how lines are drawn that part a surface from what lies behind it.
struct LinePicture {
  const Camera& camera;
  const Mat4d& modelToWorld;
  int width, height;  ///< in pixels
  const LineStyle& style;
};

/// Moves smoothContours() of the same mesh and view towards where the facets end on the screen. The
/// smooth surface ends elsewhere, by an eighth of an edge times the angle by which the surface
/// turns there: nothing on fine meshes, several pixels on coarse ones that are drawn large. Beside
/// the line one would see what lies behind, or facets beyond it.
///
/// Facets end at folds, edges whose two faces lie on the same side of them on the screen, and at
/// borders. A point of the line moves straight towards the nearest of those that belong to its own
/// or the next triangles and turn the same side to the eye, until the stroke covers what is
/// between. So it keeps to the smooth contour as far as that goes, and where it does not each
/// corner of the facets' outline is one of the line. Points farther from folds than the surface's
/// turning tells stay: there the contour runs out within the surface. As nothing depends on which
/// fold is taken where two are as near, lines do not jump while the camera moves.
/// The same on any number of threads.
void followFacets(const MeshView& mesh, const EdgeTable& table, const FeatureArrays& arrays,
                  const LinePicture& picture, int threads, ContourLines& contours);

}  // namespace limn
