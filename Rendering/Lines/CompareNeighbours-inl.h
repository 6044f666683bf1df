// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Compiled once per instruction set by CompareNeighbours.cpp.
#include "Rendering/Base/Lanes-inl.h"
#include "Rendering/Base/Prefetch.h"
#include "Rendering/Lines/CompareNeighbours.h"

HWY_BEFORE_NAMESPACE();
namespace limn::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using DI = hn::ScalableTag<std::int32_t>;
using VI = hn::Vec<DI>;
using DBytes = hn::Rebind<std::uint8_t, DI>;

HWY_INLINE V absolute(V x)
{
  return hn::IfThenElse(hn::Lt(x, hn::Zero(D())), hn::Neg(x), x);
}
HWY_INLINE VI instancesAt(const SurfaceLayers& layers, std::size_t index)
{
  return hn::LoadU(DI(), reinterpret_cast<const std::int32_t*>(layers.instance.data()) + index);
}
HWY_INLINE Lanes3 load(const LayerVectors& from, std::size_t index)
{
  return {hn::LoadU(D(), from.x.data() + index), hn::LoadU(D(), from.y.data() + index),
          hn::LoadU(D(), from.z.data() + index)};
}
/// Nobody, or what memory holds behind the pixels.
HWY_INLINE M isNobody(VI instance, const NeighbourBounds& bounds)
{
  const auto last = static_cast<std::int32_t>(bounds.asks.size()) - 1;
  return hn::RebindMask(
      D(), hn::Or(hn::Lt(instance, hn::Zero(DI())), hn::Gt(instance, hn::Set(DI(), last))));
}
HWY_INLINE M areSame(VI a, VI b)
{
  return hn::RebindMask(D(), hn::Eq(a, b));
}

/// One vector of pixels beside each other.
struct LayerLanes {
  VI instance;
  Lanes3 place, plane;
  V tolerance;  ///< stepTolerance()

  LayerLanes(const RowJob& job, std::size_t index, int x, int y)
      : instance(instancesAt(job.layers, index)),
        place{hn::Zero(D()), hn::Zero(D()), hn::Zero(D())},
        plane(load(job.layers.plane, index)),
        tolerance(hn::Zero(D()))
  {
    putInView(job, index, x, y);
  }

 private:
  /// As ScreenToView::at().
  void putInView(const RowJob& job, std::size_t index, int column, int row)
  {
    const Mat4f& m = job.layers.toView->matrix();
    VI x = hn::Set(DI(), kPixelCentre.x), y = hn::Set(DI(), kPixelCentre.y);
    if (job.samples > 1) {
      const VI sample =
          hn::And(hn::PromoteTo(DI(), hn::LoadU(DBytes(), job.layers.sample.data() + index)),
                  hn::Set(DI(), kMaxSamples - 1));
      x = hn::GatherIndex(DI(), job.test.offsetX, sample);
      y = hn::GatherIndex(DI(), job.test.offsetY, sample);
    }
    x = hn::Add(hn::ShiftLeft<kSubpixelBits>(hn::Iota(DI(), column)), x);
    y = hn::Add(hn::Set(DI(), row * kSubpixels), y);
    const V perSubpixel = set(1.0f / kSubpixels);
    const V px = hn::Mul(hn::ConvertTo(D(), x), perSubpixel);
    const V py = hn::Mul(hn::ConvertTo(D(), y), perSubpixel);
    const V depth = hn::LoadU(D(), job.layers.depth.data() + index);
    const auto rowOf = [&](int r) HWY_ATTR {
      return hn::Add(hn::Add(hn::Mul(set(m.m[r][0]), px), hn::Mul(set(m.m[r][1]), py)),
                     hn::Add(hn::Mul(set(m.m[r][2]), depth), set(m.m[r][3])));
    };
    const V inverseW = hn::Div(set(1.0f), rowOf(3));
    place = {hn::Mul(rowOf(0), inverseW), hn::Mul(rowOf(1), inverseW), hn::Mul(rowOf(2), inverseW)};
    const V perDepth = hn::Mul(hn::Sub(set(m.m[2][2]), hn::Mul(place.z, set(m.m[3][2]))), inverseW);
    const V rounding = hn::Mul(absolute(perDepth), set(ScreenToView::kDepthRounding));
    const V pixel = absolute(hn::Mul(set(m.m[1][1]), inverseW));
    const VI safe =
        hn::IfThenZeroElse(hn::RebindMask(DI(), isNobody(instance, job.bounds)), instance);
    const V perPixel = hn::GatherIndex(D(), job.bounds.tolerance.data(), safe);
    tolerance = hn::Add(hn::Mul(perPixel, pixel), rounding);
  }
};

/// PlaneDistances::areStep() by the smaller tolerance: where no instance asks for more.
HWY_INLINE M areStep(const LayerLanes& p, const LayerLanes& q)
{
  const Lanes3 way = sub(q.place, p.place);
  const V ofSecond = dot(p.plane, way), ofFirst = hn::Neg(dot(q.plane, way));
  const V tolerance = hn::IfThenElse(hn::Lt(p.tolerance, q.tolerance), p.tolerance, q.tolerance);
  const V less = hn::Neg(tolerance);
  const M isOff = hn::Or(hn::Or(hn::Gt(ofSecond, tolerance), hn::Lt(ofSecond, less)),
                         hn::Or(hn::Gt(ofFirst, tolerance), hn::Lt(ofFirst, less)));
  return hn::And(isOff, hn::Or(isPositive(ofSecond), isPositive(ofFirst)));
}

HWY_INLINE VI bitIf(M mask, std::int32_t bit)
{
  return hn::IfThenElseZero(hn::RebindMask(DI(), mask), hn::Set(DI(), bit));
}

/// What most pixels are compared by. All of it is local to the kernel: what the marks are written
/// to, bytes, might be anything that is not.
struct GentleTest {
  const float *depth, *x, *y, *z;  ///< of the layers: depths, normals
  V perDepth, growth, start, gentle, sharpest;

  explicit GentleTest(const RowJob& job)
      : depth(job.layers.depth.data()),
        x(job.layers.normal.x.data()),
        y(job.layers.normal.y.data()),
        z(job.layers.normal.z.data()),
        perDepth(set(job.test.perDepth)),
        growth(set(job.layers.toView->matrix().m[3][2])),
        start(set(job.layers.toView->matrix().m[3][3])),
        gentle(set(job.test.gentle)),
        sharpest(set(job.test.sharpest))
  {
  }
};

/// Depths of pixels and the size of ScreenToView's w there.
struct DepthLanes {
  V depth, w;

  DepthLanes(const GentleTest& test, std::size_t index)
      : depth(hn::LoadU(D(), test.depth + index)),
        w(absolute(hn::Add(hn::Mul(test.growth, depth), test.start)))
  {
  }
};

HWY_INLINE M areGentle(const GentleTest& test, const DepthLanes& p, const DepthLanes& q)
{
  const V w = hn::IfThenElse(hn::Lt(p.w, q.w), p.w, q.w);
  return hn::Le(hn::Mul(absolute(hn::Sub(p.depth, q.depth)), test.perDepth),
                hn::Mul(w, test.gentle));
}

/// kMayCreaseRight and kMayCreaseAbove, by the smallest bound; any where another instance is.
HWY_INLINE VI creaseBits(const GentleTest& test, std::size_t index, std::size_t over)
{
  const auto normalAt = [&](std::size_t i) HWY_ATTR {
    return Lanes3{hn::LoadU(D(), test.x + i), hn::LoadU(D(), test.y + i),
                  hn::LoadU(D(), test.z + i)};
  };
  const Lanes3 own = normalAt(index);
  const auto isBent = [&](std::size_t other) HWY_ATTR {
    return hn::Gt(hn::Sub(set(1.0f), dot(own, normalAt(other))), test.sharpest);
  };
  return hn::Or(bitIf(isBent(index + 1), kMayCreaseRight), bitIf(isBent(over), kMayCreaseAbove));
}

/// What the instances ask, by pixels; 0 of nobody's.
HWY_INLINE VI askedBits(const RowJob& job, VI instance, M nobody)
{
  const VI safe = hn::IfThenZeroElse(hn::RebindMask(DI(), nobody), instance);
  const VI asked = job.test.asksAlike ? hn::Set(DI(), job.bounds.asks[0])
                                      : hn::GatherIndex(DI(), job.bounds.asks.data(), safe);
  return hn::IfThenZeroElse(hn::RebindMask(DI(), nobody), asked);
}

/// Begins to read what a pixel two rows above will be compared by: layers are written tile by tile,
/// and most have left the caches.
HWY_INLINE void fetchAhead(const RowJob& job, const GentleTest& test, std::size_t index)
{
  constexpr std::size_t kPixelsPerLine = 16;
  constexpr int kRows = 2;
  if ((index - job.first) % kPixelsPerLine != 0 || job.y + kRows >= job.layers.endY()) return;
  const std::size_t ahead = index + kRows * job.layers.stride();
  prefetch(job.layers.instance.data() + ahead);
  for (const float* values : {test.depth, test.x, test.y, test.z})
    prefetch(values + ahead);
}

void comparePairsKernel(const RowJob& job, std::uint8_t* pairs, std::uint8_t* asks)
{
  const auto width = job.layers.stride();
  const bool isTop = job.y + 1 >= job.layers.endY();
  const VI onTop = hn::Set(DI(), isTop ? kStepAbove : 0);
  const GentleTest test(job);
  const auto* const instances = reinterpret_cast<const std::int32_t*>(job.layers.instance.data());
  const VI last = hn::Set(DI(), static_cast<std::int32_t>(job.bounds.asks.size()) - 1);
  const std::size_t first = job.first, count = job.count;
  const bool isSingle = job.samples == 1;
  for (std::size_t i = 0; i < count; i += hn::Lanes(D())) {
    const std::size_t index = first + i, over = isTop ? index : index + width;
    fetchAhead(job, test, index);
    const VI instance = hn::LoadU(DI(), instances + index);
    const M nobody =
        hn::RebindMask(D(), hn::Or(hn::Lt(instance, hn::Zero(DI())), hn::Gt(instance, last)));
    const M sameRight = areSame(instance, hn::LoadU(DI(), instances + index + 1));
    const M sameAbove = areSame(instance, hn::LoadU(DI(), instances + over));
    VI bits, asked = hn::Zero(DI());
    if (hn::AllTrue(D(), nobody)) {
      bits = hn::Or(bitIf(hn::Not(sameRight), kStepRight), bitIf(hn::Not(sameAbove), kStepAbove));
    } else {
      asked = askedBits(job, instance, nobody);
      M looked = hn::RebindMask(D(), hn::Gt(asked, hn::Set(DI(), NeighbourBounds::kAlways - 1)));
      if (!isSingle) {
        const VI shown = hn::PromoteTo(DI(), hn::LoadU(DBytes(), job.layers.count.data() + index));
        looked = hn::Or(looked, hn::RebindMask(D(), hn::Lt(shown, hn::Set(DI(), job.samples))));
      }
      const DepthLanes own(test, index);
      const auto unsure = [&](M same, std::size_t other) HWY_ATTR {
        return hn::AndNot(nobody, hn::AndNot(areGentle(test, own, DepthLanes(test, other)), same));
      };
      const M right = unsure(sameRight, index + 1), above = unsure(sameAbove, over);
      bits = hn::Or(
          hn::Or(bitIf(hn::Not(sameRight), kStepRight), bitIf(hn::Not(sameAbove), kStepAbove)),
          creaseBits(test, index, over));
      if (!hn::AllFalse(D(), hn::Or(right, above))) {
        const int x = job.x0 + static_cast<int>(i);
        const LayerLanes here(job, index, x, job.y);
        const auto steps = [&](M among, const LayerLanes& next, std::int32_t step) HWY_ATTR {
          return bitIf(hn::And(among, areStep(here, next)), step);
        };
        if (!hn::AllFalse(D(), right))
          bits = hn::Or(bits, steps(right, LayerLanes(job, index + 1, x + 1, job.y), kStepRight));
        if (!hn::AllFalse(D(), above))
          bits = hn::Or(
              bits, steps(above, LayerLanes(job, over, x, isTop ? job.y : job.y + 1), kStepAbove));
      }
      bits = hn::Or(bits, bitIf(looked, kStepRight));
    }
    hn::StoreU(hn::DemoteTo(DBytes(), hn::Or(bits, onTop)), DBytes(), pairs + i);
    hn::StoreU(hn::DemoteTo(DBytes(), asked), DBytes(), asks + i);
  }
}

HWY_INLINE VI idsAt(const SurfaceLayers& layers, std::size_t index)
{
  return hn::LoadU(DI(), reinterpret_cast<const std::int32_t*>(layers.id.data()) + index);
}

/// Adds where pixels of one instance differ by SurfaceLayers::id.
void compareIdsKernel(const RowJob& job, std::uint8_t* pairs)
{
  const auto width = job.layers.stride();
  const bool isTop = job.y + 1 >= job.layers.endY();
  for (std::size_t i = 0; i < job.count; i += hn::Lanes(D())) {
    const std::size_t index = job.first + i, over = isTop ? index : index + width;
    const VI instance = instancesAt(job.layers, index), id = idsAt(job.layers, index);
    const auto differ = [&](std::size_t other) HWY_ATTR {
      return hn::And(areSame(instance, instancesAt(job.layers, other)),
                     hn::Not(areSame(id, idsAt(job.layers, other))));
    };
    const VI bits =
        hn::Or(bitIf(differ(index + 1), kMayCreaseRight), bitIf(differ(over), kMayCreaseAbove));
    const auto old = hn::LoadU(DBytes(), pairs + i);
    hn::StoreU(hn::Or(old, hn::DemoteTo(DBytes(), bits)), DBytes(), pairs + i);
  }
}

}  // namespace limn::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
