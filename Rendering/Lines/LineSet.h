// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Span.h"
#include "Rendering/Base/Vec.h"
#include "Rendering/Mesh/MeshView.h"

#include <cstdint>

/// Lines of a model, drawn as strokes of an exact width on the screen.
namespace limn {

/// What becomes of the parts of lines that lie behind surfaces.
enum class HiddenLines : std::uint8_t {
  kOff,     ///< left out
  kDashed,  ///< dashed, by kHiddenWidth thinner
  kThin,    ///< drawn through, by kHiddenWidth thinner
};

/// How a chain of lines ends.
enum class LineCap : std::uint8_t {
  kRound,  ///< by half a disc as wide as the line
  kButt,   ///< cut off at its last point
};

/// Width of hidden lines as a share of that of visible ones.
inline constexpr float kHiddenWidth = 0.5f;
/// Dashes of hidden lines and the gaps between them, in widths of visible lines, plus two pixels.
inline constexpr float kHiddenDash = 2.5f, kHiddenGap = 1.5f;

/// How much surfaces may lie before a line and not hide it: what they slope within so many pixels
/// in x and y, as a pixel's depth is that of its nearest sample, and rounding.
inline constexpr double kSlopePixels = 0.5;
inline constexpr double kDepthBias = 1e-6;
inline constexpr double kBridgedSlack = 4;  ///< LineSet::slack
/// What is seen of lines whose middle is outside of the frame is decided by surfaces out there,
/// too: so many pixels farther out than half a line's width and the width of a pixel. Two are those
/// of points in a row that count for each other, one that of a point that lies half outside, and
/// two show how the surfaces slope.
inline constexpr int kStrokeApron = 5;
/// But no more than this, that of the widest style; kOuterLines that are wider take surfaces beyond
/// to be those of the nearest pixel within.
inline constexpr int kWidestStrokeApron = 134;

/// Lengths are pixels of the screen, whatever the distance, the tilt or the size of the picture.
struct LineStyle {
  Vec3f color = {0, 0, 0};  ///< as colours of Material
  float opacity = 1;        ///< 0 to 1
  float width = 1.5f;     ///< > 0, at most kMaxLineWidth; below 1 a line is one pixel wide and pale
  float outerFactor = 1;  ///< >= 0; segments with kOuterLine are so many times as wide
  float taper = 0;        ///< over this length the ends of open chains grow from width 0
  float dash = 0, gap = 0;  ///< dash 0: no dashes; else both > 0
  HiddenLines hidden = HiddenLines::kOff;
  LineCap cap = LineCap::kRound;
};
inline constexpr float kMaxLineWidth = 256;
static_assert(kWidestStrokeApron == static_cast<int>(kMaxLineWidth / 2) + 1 + kStrokeApron);
/// In pixels. Of longer segments double does not tell the part that is in the picture.
inline constexpr double kLongestSegment = 1e12;

inline bool operator==(const LineStyle& a, const LineStyle& b)
{
  return a.color == b.color && a.opacity == b.opacity && a.width == b.width &&
         a.outerFactor == b.outerFactor && a.taper == b.taper && a.dash == b.dash &&
         a.gap == b.gap && a.hidden == b.hidden && a.cap == b.cap;
}

/// Of one segment of a line.
enum LineFlag : std::uint8_t {
  kOuterLine = 1,      ///< between the object and what lies behind it: LineStyle::outerFactor
  kConcealedLine = 2,  ///< hidden, whatever the depths say
};

/// Chains of segments in model coordinates. All that is empty or out of order is refused by
/// checkScene(); segments with a point that is not finite are left out.
///
/// A pixel's coverage is the area that it shares with the band about a segment, the largest over
/// all segments of the instance with an equal style that come one after another; it is laid over
/// the colour once, so joints are no darker, and order does not count. Whether a piece of a line
/// is seen is decided on its middle, about once a pixel, whatever its width: it is if one of the
/// 3 x 3 pixels there does not hide it. Each pixel's depth is carried over to the line's point by
/// how it slopes to its neighbour in x and in y, of two the one that slopes less, and less
/// kSlopePixels of that slope. So a line in a surface is seen at any tilt, and one that lies some
/// way behind it is not. What most of five points in a row are all are. Points, and the surfaces
/// next to the frame, are those of a larger picture; what the frame has held before is taken to go
/// on as at its border.
struct LineSet {
  MeshView points;                   ///< triangles are not read
  Span<const std::uint32_t> vertex;  ///< points of all chains, one after another
  Span<const std::uint32_t> first;   ///< where in `vertex` a chain begins; and the end
  Span<const std::uint8_t> flags;    ///< LineFlags of the segment from vertex[i] to the next
  /// By point, in view units: surfaces that lie no more than this before the line do not hide it.
  /// For lines beside the mesh, as smooth contours of a faceted one are. Empty: 0. Where a
  /// kOuterLine is hidden between two places at which it is seen, by surfaces no more than
  /// kBridgedSlack times this before it, it is seen all along: facets of its own hide it there.
  Span<const float> slack;
  LineStyle style;
  /// By point, 0 to 1: what share of the style's width the line has there, linear on the screen
  /// in between. Empty: 1.
  Span<const float> share = {};

  std::size_t chainCount() const { return first.empty() ? 0 : first.size() - 1; }
};

}  // namespace limn
