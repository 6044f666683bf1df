// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Reference/ReferenceTone.cpp, one fragment a lane, operation by operation. Compiled once per
// instruction set by whoever includes it.
#include "Rendering/Base/Lanes-inl.h"
#include "Rendering/Base/Power-inl.h"
#include "Rendering/Texture/SampleTexture-inl.h"
#include "Rendering/ToneStyle.h"
#include "Rendering/Vertex/ClippingRange.h"

#include <array>

#if defined(LIMN_TONE_EQUATIONS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMN_TONE_EQUATIONS_INL_H
#undef LIMN_TONE_EQUATIONS_INL_H
#else
#define LIMN_TONE_EQUATIONS_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace limn::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Keeps what does not change exact.
constexpr float kLeastSlope = 1e-6f;

HWY_INLINE V bounded(V x, V low, V high)
{
  return hn::IfThenElse(hn::Gt(x, low), hn::IfThenElse(hn::Lt(x, high), x, high), low);
}
HWY_INLINE V bounded(V x, float low, float high)
{
  return bounded(x, set(low), set(high));
}

/// A value where the fragments are, and a pixel to the right and above.
struct ScreenValues {
  V here, right, above;
};
HWY_INLINE V slopeOf(ScreenValues values)
{
  const V x = hn::Sub(values.right, values.here), y = hn::Sub(values.above, values.here);
  return hn::Sqrt(hn::Add(hn::Mul(x, x), hn::Mul(y, y)));
}

HWY_INLINE V smoothStep(V x)
{
  const V t = bounded(x, 0.0f, 1.0f);
  return hn::Mul(hn::Mul(t, t), hn::Sub(set(3.0f), hn::Mul(set(2.0f), t)));
}

/// Style::toonBands of t.
HWY_INLINE V stepped(V t, V slope, int bands)
{
  const auto count = static_cast<float>(bands);
  const V n = set(count), one = set(1.0f), most = set(1.0f / count);
  const V edge = hn::Round(bounded(hn::Mul(t, n), 1.0f, count - 1.0f));
  const V pixel = bounded(hn::IfThenElse(hn::Lt(slope, most), slope, most), kLeastSlope, 1.0f);
  const V way = hn::Add(hn::Div(hn::Sub(t, hn::Div(edge, n)), pixel), set(0.5f));
  return hn::Div(hn::Add(hn::Sub(edge, one), smoothStep(way)), set(count - 1.0f));
}

/// A highlight, all or nothing.
HWY_INLINE V onOff(V highlight, V slope)
{
  const V pixel = bounded(slope, kLeastSlope, 1.0f);
  return smoothStep(hn::Add(hn::Div(hn::Sub(highlight, set(0.5f)), pixel), set(0.5f)));
}

/// How much of a pixel the line of Style::evenOutline covers, g = n.v, f that of the triangle.
HWY_INLINE V evenLine(ScreenValues g, V f, float width)
{
  const V curvature = hn::Mul(f, slopeOf(g)), least = set(kLeastSlope);
  const V bounds = hn::IfThenElse(hn::Gt(curvature, least), curvature, least);
  const V distance = hn::Div(hn::Mul(g.here, g.here), hn::Mul(set(2.0f), bounds));
  return bounded(hn::Sub(set(width + 0.5f), distance), 0.0f, 1.0f);
}

HWY_INLINE V arcCosine(V x)
{
  const V a = bounded(hn::Abs(x), 0.0f, 1.0f);
  V series = hn::Add(set(0.0742610f), hn::Mul(a, set(-0.0187293f)));
  series = hn::Add(set(-0.2121144f), hn::Mul(a, series));
  series = hn::Add(set(1.5707288f), hn::Mul(a, series));
  const V angle = hn::Mul(hn::Sqrt(hn::Sub(set(1.0f), a)), series);
  return hn::IfThenElse(hn::Lt(x, hn::Zero(D())), hn::Sub(set(3.14159265f), angle), angle);
}

/// Of stripes.
constexpr std::array<float, kMetalStripes> metalGreys()
{
  std::array<float, kMetalStripes> greys = {};
  for (std::uint32_t i = 0; i < greys.size(); ++i) {
    std::uint32_t bits = (i + 1) * 2654435761u;
    bits ^= bits >> 16;
    bits *= 2246822519u;
    bits ^= bits >> 13;
    greys[i] = static_cast<float>(bits >> 8) * (0.5f / 16777216.0f);
  }
  return greys;
}
inline constexpr std::array<float, kMetalStripes> kMetalGreys = metalGreys();

/// Tone::kMetal's grey.
HWY_INLINE V metalGrey(Lanes3 n, Lanes3 l)
{
  constexpr float kLast = static_cast<float>(kMetalStripes - 1);
  const auto across = [](V cosine) HWY_ATTR {
    return hn::Mul(arcCosine(cosine), set(static_cast<float>(kMetalStripes) / 3.14159265f));
  };
  const V light = hn::Floor(bounded(across(l.x), 0.0f, kLast));
  const V place = bounded(hn::Sub(across(n.x), set(0.5f)), 0.0f, kLast);
  const V left = hn::Floor(place), fraction = hn::Sub(place, left);
  const auto grey = [&](V stripe) HWY_ATTR {
    const auto number = hn::ConvertTo(hn::RebindToSigned<D>(), stripe);
    return hn::IfThenElse(hn::Eq(stripe, light), set(1.0f),
                          hn::GatherIndex(D(), kMetalGreys.data(), number));
  };
  const V first = grey(left), second = grey(bounded(hn::Add(left, set(1.0f)), 0.0f, kLast));
  return hn::Add(first, hn::Mul(hn::Sub(second, first), fraction));
}

/// A ToneRamp, ready to be read.
class Ramp {
 public:
  Ramp(const ToneRamp& ramp, const Camera& camera) : ramp_(ramp)
  {
    sampler_.wrapU = sampler_.wrapV = TextureWrap::kClamp;
    if (ramp.image == nullptr) return;
    range_ = depthRangeOf(ramp, camera);
    octaves_ = 1.0f / power_detail::log2Normal(range_.farthest / range_.nearest);
  }

  HWY_INLINE V detail(V depth, V nv, V rv) const
  {
    switch (ramp_.detail) {
      case RampDetail::kSilhouette:
        return powerOf(hn::Abs(nv), ramp_.exponent);
      case RampDetail::kHighlight:
        return powerOf(positive(rv), ramp_.exponent);
      default: {
        const V z = bounded(depth, range_.nearest, range_.farthest);
        const V octave = log2Normal(hn::Div(z, set(range_.nearest)));
        return hn::Sub(set(1.0f), hn::Mul(octave, set(octaves_)));
      }
    }
  }
  HWY_INLINE Lanes3 colorAt(V u, V v) const
  {
    const Lanes2 still = set(Vec2f{0, 0});
    const Lanes4 color = sampleTexture(*ramp_.image, sampler_, {u, v}, still, still);
    return {color.x, color.y, color.z};
  }
  HWY_INLINE Lanes3 matCap(Lanes3 n, Lanes3 v) const
  {
    const Lanes3 right = normalized(Lanes3{v.z, hn::Zero(D()), hn::Neg(v.x)});
    const Lanes3 up = cross(v, right);
    const auto coordinate = [&](Lanes3 axis) HWY_ATTR {
      return hn::Add(set(0.5f), hn::Mul(set(0.5f), dot(n, axis)));
    };
    return colorAt(coordinate(right), coordinate(up));
  }

 private:
  const ToneRamp& ramp_;
  TextureSampler sampler_;
  DepthRange range_ = {1, 2};
  float octaves_ = 1;
};

}  // namespace limn::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // per-target guard
