// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Lines/Contours.h"
#include "Rendering/Lines/CurveBounds.h"

/// Lines inside of smooth surfaces, found from their curvature: one segment a triangle.
namespace limn {

struct CurveThresholds {
  double ridge = 0.1;        ///< ridges and valleys bend more than this over s
  double suggestive = 0.01;  ///< the derivative of suggestive contours is above this over s^2
};

enum class ExtremeKind : std::uint8_t { kRidge, kValley };

/// Where the larger principal curvature k_1 is extreme along its own direction (Ohtake et al.
/// 2004): D_1 k_1 = 0, a maximum with k_1 > 0 at a ridge, a minimum with k_1 < 0 in a valley. Only
/// where |k_1| falls by 2 % or more of itself within a feature size: less is rounding's work, as on
/// cylinders and tori. Does not depend on the view.
/// `featureSize` is that of the mesh.
ContourLines extremeLines(const CurvedSurface& surface, const EdgeTable& table, ExtremeKind kind,
                          const CurveThresholds& thresholds, double featureSize, int threads);

/// Where the surface would have a contour from a view nearby (DeCarlo et al. 2003): the curvature
/// k_r along the view, projected into the surface, is 0 and grows towards the viewer. None where
/// both curvatures have one sign. `bounds`: none, or those of boundCurves(), which change nothing
/// but the time that it takes.
ContourLines suggestiveContours(const CurvedSurface& surface, const EdgeTable& table,
                                const CurveBounds& bounds, const Camera& camera,
                                const Mat4d& modelToWorld, const CurveThresholds& thresholds,
                                int threads);

}  // namespace limn
