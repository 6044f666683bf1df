// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Lines/FlatRegions.h"

namespace limn {

/// Which way strokes run that show how a surface bends: a cross at each vertex, of which strokes of
/// the first family follow one axis and those across them the other.
struct HatchField {
  /// The first family's axis, by vertex: unit, in the tangent plane, of which the sign means
  /// nothing; {0, 0, 0} where there is no proper face.
  std::vector<Vec3f> axis;
  /// By vertex: 1, 2 or 3 where strokes of the first family are circles about the x, y or z axis:
  /// they run where the smooth normal's part along it stays what it is. Else 0.
  std::vector<std::uint8_t> circles;
  std::vector<std::uint32_t> circled;  ///< a vertex of each connected surface of circles
  FlatRegions flats;                   ///< where it is FlatRegion::along instead
};

/// Crosses have the principal directions where these are reliable: where the curvatures differ by
/// much, for the size of the mesh and beside their own size. Beyond, towards umbilics, spheres and
/// planes, where they are noise, crosses are filled in from reliable ones, the nearest first, and
/// then smoothed, kFieldRounds times, to means of their neighbours', each turned into the vertex'
/// plane (after Hertzmann and Zorin 2000). Means of crosses, not of lines: where the two principal
/// directions swap, nothing turns. A connected surface that has nothing reliable gets circles about
/// an axis of the model, that of which its normals have least, z in doubt; spheres have parallels.
///
/// The first axis is that of the greater curvature, signed, for most of a connected surface, and
/// its continuation on all of it; it swaps only along cuts between singularities.
/// The same on any number of threads.
HatchField hatchField(const HatchSurface& surface, int threads);
inline constexpr int kFieldRounds = 24;

}  // namespace limn
