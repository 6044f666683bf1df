// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Lines/HatchField.h"

namespace limn {

/// Strokes on a surface, of which the denser the more are drawn. They do not depend on the view.
struct HatchStrokes {
  std::vector<Vec3d> points;
  std::vector<std::uint32_t> triangle;  ///< by point
  std::vector<Vec3f> normals;           ///< of the smooth surface, unit, by point
  std::vector<Vec3f> across;            ///< unit, perpendicular to stroke and normal, by point
  std::vector<std::uint32_t> vertex;    ///< points of all strokes, one after another
  std::vector<std::uint32_t> first;     ///< where in `vertex` a stroke begins; and the end
  std::vector<float> rank;              ///< by stroke, above 0, at most 1
  std::vector<char> isCross;            ///< by stroke: of the second family, across the first
  /// Between neighbours where all are drawn. Those of a rank up to r are spacing / r apart.
  double spacing = 0;
  double step = 0;  ///< from point to point

  std::size_t strokeCount() const { return first.empty() ? 0 : first.size() - 1; }
};

/// The distance of strokes, as a share of the diagonal of the mesh's box.
inline constexpr double kHatchDensity = 1.0 / 200;

/// Streamlines of hatchField() and of the directions across it, over the triangles, until they
/// meet a border, an edge of more than 60 degrees, or come too near to another of their family
/// (Jobard and Lefer 1997). In four rounds, each with half the distance of the one before; ranks
/// are random within a round. The same on any number of threads.
HatchStrokes traceHatching(const CurvedSurface& surface, const EdgeTable& table,
                           Span<const Vec3f> field, int threads);

}  // namespace limn
