// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Vec.h"

#include <cstdint>
#include <vector>

namespace limn {

/// Strokes on a surface, of which the denser the more are drawn. They do not depend on the view.
struct HatchStrokes {
  static constexpr std::uint32_t kNoFace = 0xFFFFFFFFu;

  std::vector<Vec3d> points;
  std::vector<std::uint32_t> triangle;  ///< by point
  std::vector<Vec3f> normals;           ///< of the smooth surface, unit, by point
  std::vector<Vec3f> across;            ///< unit, perpendicular to stroke and normal, by point
  std::vector<std::uint32_t> vertex;    ///< points of all strokes, one after another
  std::vector<std::uint32_t> first;     ///< where in `vertex` a stroke begins; and the end
  /// By stroke, above 0, at most 1: half as wide as others where all up to it are as dense as
  /// asked.
  std::vector<float> rank;
  std::vector<char> isCross;  ///< by stroke: of the second family, across the first
  /// By stroke: one number for each family of each flat face, kNoFace elsewhere.
  std::vector<std::uint32_t> face;
  /// Between neighbours where all are drawn. Those of a rank up to r are spacing / r apart.
  double spacing = 0;
  double step = 0;  ///< from point to point, at most; more along straight ones

  std::size_t strokeCount() const { return first.empty() ? 0 : first.size() - 1; }
  /// Adds another's strokes of the same spacing.
  void append(const HatchStrokes& more);
};

}  // namespace limn
