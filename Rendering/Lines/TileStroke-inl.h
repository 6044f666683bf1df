// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Compiled once per instruction set by TileStroke.cpp.
#include "Rendering/Base/Lanes-inl.h"
#include "Rendering/Lines/TileStroke.h"

HWY_BEFORE_NAMESPACE();
namespace limn::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

HWY_INLINE V lesser(V a, V b)
{
  return hn::IfThenElse(hn::Lt(b, a), b, a);
}
HWY_INLINE V greater(V a, V b)
{
  return hn::IfThenElse(hn::Lt(a, b), b, a);
}
HWY_INLINE V inUnitRange(V a)
{
  return lesser(positive(a), set(1.0f));
}

/// A TileStroke, one value a lane. Local to the kernel: it might change with all that is written
/// else.
struct StrokeLanes {
  V distance, normalX, normalY, along, alongX, alongY;
  V length, inverseLength, half, halfGrowth, startLimit, endLimit, round0, round1;
  V nearest, depthGrowth, inner, outer, linear, quadratic;

  explicit StrokeLanes(const TileStroke& stroke)
      : distance(set(stroke.distance)),
        normalX(set(stroke.normalX)),
        normalY(set(stroke.normalY)),
        along(set(stroke.along)),
        alongX(set(stroke.alongX)),
        alongY(set(stroke.alongY)),
        length(set(stroke.length)),
        inverseLength(set(stroke.inverseLength)),
        half(set(stroke.half)),
        halfGrowth(set(stroke.halfGrowth)),
        startLimit(set(stroke.startLimit)),
        endLimit(set(stroke.endLimit)),
        round0(set(stroke.round0)),
        round1(set(stroke.round1)),
        nearest(set(stroke.nearest)),
        depthGrowth(set(stroke.depthGrowth)),
        inner(set(stroke.inner)),
        outer(set(stroke.outer)),
        linear(set(stroke.linear)),
        quadratic(set(stroke.quadratic))
  {
  }
};

/// The share of a pixel that lies before a straight line at signed distance d from its centre.
HWY_INLINE V shareBefore(const StrokeLanes& stroke, V d)
{
  const V y = hn::Abs(d);
  const V rest = positive(hn::Sub(stroke.outer, y));
  const V far = hn::Sub(set(1.0f), hn::Mul(hn::Mul(rest, rest), stroke.quadratic));
  const V near = hn::Add(set(0.5f), hn::Mul(y, stroke.linear));
  const V share = hn::IfThenElse(hn::Le(y, stroke.inner), near, far);
  return hn::IfThenElse(hn::Lt(d, hn::Zero(D())), hn::Sub(set(1.0f), share), share);
}

struct StrokeColumns {
  int first, end;
};

/// Of a row those that the band may meet.
HWY_INLINE StrokeColumns columnsOf(const TileStroke& stroke, float y)
{
  constexpr float kNearlyLevel = 0.05f;
  const float normal = std::fabs(stroke.normalX);
  if (normal < kNearlyLevel) return {stroke.x0, stroke.x1};
  const auto bounded = [](float value) {
    constexpr float kSide = kTileSide;
    return value > 0.0f ? (value < kSide ? value : kSide) : 0.0f;
  };
  const float centre = -(stroke.distance + y * stroke.normalY) / stroke.normalX;
  const float radius = stroke.reach / normal + 1.0f;
  return {std::max(stroke.x0, static_cast<int>(bounded(centre - radius))),
          std::min(stroke.x1, static_cast<int>(bounded(centre + radius + 1.0f)))};
}

void coverStrokeKernel(const TileStroke& stroke, StrokeTile& tile)
{
  const D lanes;
  const auto step = static_cast<int>(hn::Lanes(lanes));
  const V half = set(0.5f), iota = hn::Iota(lanes, 0.5f);
  const StrokeLanes lanesOf(stroke);
  for (int row = stroke.y0, end = stroke.y1; row < end; ++row) {
    const StrokeColumns columns = columnsOf(stroke, static_cast<float>(row) + 0.5f);
    const V y = set(static_cast<float>(row) + 0.5f);
    float* const coverage = tile.coverage + row * kTileSide;
    float* const depth = tile.depth + row * kTileSide;
    // Strokes are narrow: from their own first column on one vector mostly holds all of a row.
    for (int first = columns.first; first < columns.end; first += step) {
      const int column = std::min(first, kTileSide - step);
      const V x = hn::Add(set(static_cast<float>(column)), iota);
      const V d = hn::Add(hn::Add(lanesOf.distance, hn::Mul(x, lanesOf.normalX)),
                          hn::Mul(y, lanesOf.normalY));
      const V s =
          hn::Add(hn::Add(lanesOf.along, hn::Mul(x, lanesOf.alongX)), hn::Mul(y, lanesOf.alongY));
      const V before = hn::Mul(positive(hn::Neg(s)), lanesOf.round0);
      const V after = hn::Mul(positive(hn::Sub(s, lanesOf.length)), lanesOf.round1);
      const V beyond = hn::Add(before, after);
      const V distance = hn::Sqrt(hn::Add(hn::Mul(d, d), hn::Mul(beyond, beyond)));
      const V t = inUnitRange(hn::Mul(s, lanesOf.inverseLength));
      const V width = hn::Add(lanesOf.half, hn::Mul(t, lanesOf.halfGrowth));
      const V across = hn::Sub(shareBefore(lanesOf, hn::Add(distance, width)),
                               shareBefore(lanesOf, hn::Sub(distance, width)));
      const V along = inUnitRange(hn::Sub(lesser(hn::Add(s, half), lanesOf.endLimit),
                                          greater(hn::Sub(s, half), lanesOf.startLimit)));
      const V covered = hn::Mul(across, along);
      const V old = hn::LoadU(lanes, coverage + column);
      hn::StoreU(greater(old, covered), lanes, coverage + column);
      const V z = hn::Add(lanesOf.nearest, hn::Mul(t, lanesOf.depthGrowth));
      const V oldDepth = hn::LoadU(lanes, depth + column);
      hn::StoreU(hn::IfThenElse(isPositive(covered), lesser(oldDepth, z), oldDepth), lanes,
                 depth + column);
    }
  }
}

}  // namespace limn::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
