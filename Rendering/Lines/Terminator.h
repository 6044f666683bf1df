// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Lines/Contours.h"
#include "Rendering/Vertex/LightRays.h"

namespace limn {

/// The terminator n.l = 0, where a surface turns away from a light: facetContours() with the light
/// in the place of the eye, so that it is where Phong's shading of these normals turns dark. Where
/// the two sides of an edge have other normals it follows edges that are lit on one side only. Of a
/// spot inside of its cone. Does not ask whether something else is before the light. Changes with
/// mesh and light, not with the camera. `bounds`: none, or those of boundNormals().
ContourLines terminatorLines(const MeshView& mesh, const EdgeTable& table,
                             const FeatureArrays& arrays, const FacingBounds& bounds,
                             const LightRays& light, const Mat4d& modelToWorld, int threads);

}  // namespace limn
