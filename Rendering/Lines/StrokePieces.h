// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/FrameView.h"
#include "Rendering/Lines/ApronDepths.h"
#include "Rendering/Scene.h"

#include <cstddef>
#include <vector>

namespace limn {

/// A straight piece of a stroke that is drawn, in pixels from the viewport's lower left corner.
struct StrokePiece {
  double x0, y0, x1, y1;
  float half0, half1;    ///< half the width at its ends
  float depth0, depth1;  ///< window depth; kNoDepth where it writes none
  bool round0, round1;   ///< ends in half a disc, which joins it to the next piece
};
inline constexpr float kNoDepth = 2;

/// Pieces whose coverage is combined before it is blended once.
struct StrokeGroup {
  std::uint32_t instance;  ///< place in Scene::instances
  Vec3f color;
  float opacity;
  std::size_t endPiece;  ///< begins where the one before ends
};

/// All strokes of one frame.
struct StrokePlan {
  std::vector<StrokePiece> pieces;
  std::vector<StrokeGroup> groups;  ///< in the order in which they are blended
};

/// How far from its middle a line has pixels: half its width and the width of a pixel.
inline double strokeReach(const LineStyle& style)
{
  const double factor = style.outerFactor > 1 ? style.outerFactor : 1.0;
  return 0.5 * static_cast<double>(style.width) * factor + 1.0;
}

/// How many pixels outside of a frame tell what is seen of its lines; 0 if there are none.
int strokeApron(const Scene& scene);

/// Cuts the scene's lines into pieces by what hides them: `frame.depth` are the depths of all its
/// surfaces, and `around` those of strokeApron() pixels around it, or more. In the order of
/// instances, sets and chains, on any number of threads.
StrokePlan findStrokePieces(const Scene& scene, const FrameView& frame, const ApronDepths& around,
                            int threads);

}  // namespace limn
