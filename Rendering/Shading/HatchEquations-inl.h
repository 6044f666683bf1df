// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Reference/ReferenceHatching.cpp, one fragment a lane, operation by operation. Compiled once per
// instruction set by whoever includes it.
#include "Rendering/Shading/ToneEquations-inl.h"
#include "Rendering/Texture/TonalArtMap.h"

#if defined(LIMN_HATCH_EQUATIONS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMN_HATCH_EQUATIONS_INL_H
#undef LIMN_HATCH_EQUATIONS_INL_H
#else
#define LIMN_HATCH_EQUATIONS_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace limn::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Draws strokes of one darkness and spacing for a vector of fragments.
class HatchPen {
 public:
  using Numbers = hn::Vec<hn::RebindToSigned<D>>;
  /// One coordinate's part in four texels: two of the finer level, then two of the coarser.
  struct Taps {
    // Written out, since GCC makes an implicit one outside of the instruction set's region.
    HWY_INLINE Taps() {}

    Numbers texel[4];
    V weight[4];
  };

  HatchPen(V darkness, float spacing)
      : texelsPerSlope_(set(spacing * (1.0f / static_cast<float>(TonalArtMap::kQuarterSpacing)))),
        tone_(toneOf(darkness))
  {
  }

  Taps tapsOf(ScreenValues coordinate) const
  {
    const V size = hn::Mul(slopeOf(coordinate), texelsPerSlope_);
    const V octave = log2Normal(bounded(size, 1e-30f, 1e30f));
    const V finer = hn::Floor(octave), coarser = hn::Sub(octave, finer), one = set(1.0f);
    Taps taps;
    tap(coordinate.here, finer, hn::Sub(one, coarser), taps.texel, taps.weight);
    tap(coordinate.here, hn::Add(finer, one), coarser, taps.texel + 2, taps.weight + 2);
    return taps;
  }

  V inkOf(const Taps& u, const Taps& v) const
  {
    const float* const map = tonalArtMap().firstTones();
    const V next = hn::Add(tone_, set(1.0f));
    V ink = set(0.0f);
    for (int y = 0; y < 4; ++y) {
      static_assert(TonalArtMap::kSide == 1 << 7, "a row of the map is a shift");
      const Numbers start = hn::ShiftLeft<7>(v.texel[y]);
      V row = set(0.0f);
      for (int x = 0; x < 4; ++x) {
        const V first = hn::GatherIndex(D(), map, hn::Add(start, u.texel[x]));
        row = hn::Add(row, hn::Mul(u.weight[x], bounded(hn::Sub(next, first), 0.0f, 1.0f)));
      }
      ink = hn::Add(ink, hn::Mul(v.weight[y], row));
    }
    return ink;
  }

 private:
  static V toneOf(V darkness)
  {
    const TonalArtMap& map = tonalArtMap();
    V tone = set(0.0f);
    for (int k = 0; k < TonalArtMap::kTones; ++k) {
      const V way = hn::Mul(hn::Sub(darkness, set(map.coverage(k))), set(map.perCoverage(k)));
      tone = hn::Add(tone, bounded(way, 0.0f, 1.0f));
    }
    return tone;
  }
  static void tap(V coordinate, V octave, V share, Numbers* texel, V* weight)
  {
    const hn::RebindToSigned<D> di;
    const auto last = hn::Set(di, TonalArtMap::kSide - 1);
    // 2^(-octave - 7)
    const auto exponent = hn::Sub(hn::Set(di, 127 - 7), hn::ConvertTo(di, octave));
    const V pictures = hn::Mul(coordinate, hn::BitCast(D(), hn::ShiftLeft<23>(exponent)));
    const V inPicture = bounded(hn::Sub(pictures, hn::Floor(pictures)), 0.0f, 1.0f);
    const V place = hn::Sub(hn::Mul(inPicture, set(128.0f)), set(0.5f));
    const V left = hn::Floor(place), fraction = hn::Sub(place, left);
    const auto first = hn::ConvertTo(di, left);
    texel[0] = hn::And(first, last);
    texel[1] = hn::And(hn::Add(first, hn::Set(di, 1)), last);
    weight[0] = hn::Mul(share, hn::Sub(set(1.0f), fraction));
    weight[1] = hn::Mul(share, fraction);
  }

  V texelsPerSlope_, tone_;
};

/// At a pixel, and a pixel to the right and above in the triangle's plane.
struct HatchPositions {
  Lanes3 here, right, above;
};

HWY_INLINE V hatchNearness(V component)
{
  const V excess = bounded(hn::Sub(hn::Mul(component, component), set(0.2f)), 0.0f, 1.0f);
  return hn::Mul(excess, excess);
}

HWY_NOINLINE V hatchInModel(const HatchPen& pen, const HatchPositions& position, Lanes3 normal)
{
  const auto taps = [&](auto coordinate) HWY_ATTR {
    return pen.tapsOf(
        {coordinate(position.here), coordinate(position.right), coordinate(position.above)});
  };
  const HatchPen::Taps rows =
      taps([](Lanes3 p) HWY_ATTR { return hn::Add(hn::Add(p.x, p.y), p.z); });
  const V x = hatchNearness(normal.x), y = hatchNearness(normal.y), z = hatchNearness(normal.z);
  const V sum = hn::Add(hn::Add(x, y), z), share = reciprocalIfPositive(sum, sum);
  V ink = set(0.0f);
  const auto blend = [&](V nearness, auto coordinate) HWY_ATTR {
    if (hn::AllFalse(D(), isPositive(nearness))) return;
    const V part = hn::Mul(nearness, share);
    ink = hn::Add(ink, hn::Mul(part, pen.inkOf(taps(coordinate), rows)));
  };
  blend(x, [](Lanes3 p) HWY_ATTR { return hn::Sub(p.y, p.z); });
  blend(y, [](Lanes3 p) HWY_ATTR { return hn::Sub(p.z, p.x); });
  blend(z, [](Lanes3 p) HWY_ATTR { return hn::Sub(p.x, p.y); });
  return ink;
}

HWY_NOINLINE V hatchByTexture(const HatchPen& pen, const Lanes2 (&uv)[3])
{
  const HatchPen::Taps u = pen.tapsOf({uv[0].x, uv[1].x, uv[2].x});
  return pen.inkOf(u, pen.tapsOf({uv[0].y, uv[1].y, uv[2].y}));
}

}  // namespace limn::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // per-target guard
