// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Lines/SurfaceCurves.h"

namespace limn {

/// Which way strokes run that show how a surface bends, by vertex: a unit vector in the tangent
/// plane, of which the sign means nothing; {0, 0, 0} where there is no proper face. Strokes across
/// them are perpendicular to it.
///
/// It is the principal direction of the greater curvature, signed, where the two differ by much.
/// Towards umbilics, where they are equal and their directions noise, it becomes the mean of its
/// neighbours', each turned into the vertex' plane (after Hertzmann and Zorin 2000, who optimise
/// such places): so it is smooth. kFieldRounds times, from a direction that the axes of the model
/// give. Vertices at edges sharper than 45 degrees count as umbilics. The same on any number of
/// threads.
std::vector<Vec3f> hatchField(const CurvedSurface& surface, int threads);
inline constexpr int kFieldRounds = 40;

}  // namespace limn
