// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Compiled once per instruction set by CompareNeighbours.cpp.
#include "Rendering/Base/Lanes-inl.h"
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
HWY_INLINE Lanes3 placesAt(const PlacedRow& row, std::size_t i)
{
  return {hn::LoadU(D(), row.x.data() + i), hn::LoadU(D(), row.y.data() + i),
          hn::LoadU(D(), row.z.data() + i)};
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

/// ScreenToView::at() of a row's pixels, and what is too little for a step there.
void placeRowKernel(const RowJob& job, PlacedRow& row)
{
  const Mat4f& m = job.layers.toView->matrix();
  std::int32_t offsetX[kMaxSamples] = {}, offsetY[kMaxSamples] = {};
  for (std::size_t s = 0; s < job.layers.offsets.size(); ++s) {
    offsetX[s] = job.layers.offsets[s].x;
    offsetY[s] = job.layers.offsets[s].y;
  }
  const V perSubpixel = set(1.0f / kSubpixels);
  for (std::size_t i = 0; i < job.count; i += hn::Lanes(D())) {
    const std::size_t index = job.first + i;
    const VI instance = instancesAt(job.layers, index);
    const M nobody = isNobody(instance, job.bounds);
    if (hn::AllTrue(D(), nobody)) continue;
    VI x = hn::Set(DI(), kPixelCentre.x), y = hn::Set(DI(), kPixelCentre.y);
    if (job.samples > 1) {
      const VI sample =
          hn::And(hn::PromoteTo(DI(), hn::LoadU(DBytes(), job.layers.sample.data() + index)),
                  hn::Set(DI(), kMaxSamples - 1));
      x = hn::GatherIndex(DI(), offsetX, sample);
      y = hn::GatherIndex(DI(), offsetY, sample);
    }
    const VI column = hn::Iota(DI(), job.x0 + static_cast<std::int32_t>(i));
    x = hn::Add(hn::ShiftLeft<kSubpixelBits>(column), x);
    y = hn::Add(hn::Set(DI(), job.y * kSubpixels), y);
    const V px = hn::Mul(hn::ConvertTo(D(), x), perSubpixel);
    const V py = hn::Mul(hn::ConvertTo(D(), y), perSubpixel);
    const V depth = hn::LoadU(D(), job.layers.depth.data() + index);
    const auto rowOf = [&](int r) HWY_ATTR {
      return hn::Add(hn::Add(hn::Mul(set(m.m[r][0]), px), hn::Mul(set(m.m[r][1]), py)),
                     hn::Add(hn::Mul(set(m.m[r][2]), depth), set(m.m[r][3])));
    };
    const V inverseW = hn::Div(set(1.0f), rowOf(3));
    const V z = hn::Mul(rowOf(2), inverseW);
    hn::StoreU(hn::Mul(rowOf(0), inverseW), D(), row.x.data() + i);
    hn::StoreU(hn::Mul(rowOf(1), inverseW), D(), row.y.data() + i);
    hn::StoreU(z, D(), row.z.data() + i);
    const V perDepth = hn::Mul(hn::Sub(set(m.m[2][2]), hn::Mul(z, set(m.m[3][2]))), inverseW);
    const V rounding = hn::Mul(absolute(perDepth), set(ScreenToView::kDepthRounding));
    const V pixel = absolute(hn::Mul(set(m.m[1][1]), inverseW));
    const VI safe = hn::IfThenZeroElse(hn::RebindMask(DI(), nobody), instance);
    const V tolerance = hn::GatherIndex(D(), job.bounds.tolerance.data(), safe);
    hn::StoreU(hn::Add(hn::Mul(tolerance, pixel), rounding), D(), row.tolerance.data() + i);
  }
}

/// One vector of pixels beside each other.
struct LayerLanes {
  VI instance;
  Lanes3 place, plane, normal;
  V tolerance;

  LayerLanes(const SurfaceLayers& layers, std::size_t index, const PlacedRow& row, std::size_t i)
      : instance(instancesAt(layers, index)),
        place(placesAt(row, i)),
        plane(load(layers.plane, index)),
        normal(load(layers.normal, index)),
        tolerance(hn::LoadU(D(), row.tolerance.data() + i))
  {
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

/// What a pixel has to do with the next, as bits: that to the right, then that above.
HWY_INLINE VI pairBits(const LayerLanes& here, const LayerLanes& next, V crease, std::int32_t step,
                       std::int32_t creased)
{
  const M same = areSame(here.instance, next.instance);
  const M bent = hn::Gt(hn::Sub(set(1.0f), dot(here.normal, next.normal)), crease);
  return hn::Or(bitIf(hn::Or(hn::Not(same), areStep(here, next)), step),
                bitIf(hn::And(same, bent), creased));
}

void comparePairsKernel(const RowJob& job, const PlacedRow& here, const PlacedRow& above,
                        std::uint8_t* pairs, std::uint8_t* asks)
{
  const auto width = static_cast<std::size_t>(job.layers.width);
  const bool isTop = job.y + 1 >= job.layers.height;
  const VI onTop = hn::Set(DI(), isTop ? kStepAbove : 0);
  for (std::size_t i = 0; i < job.count; i += hn::Lanes(D())) {
    const std::size_t index = job.first + i, over = isTop ? index : index + width;
    const VI instance = instancesAt(job.layers, index);
    const M nobody = isNobody(instance, job.bounds);
    VI bits, asked = hn::Zero(DI());
    if (hn::AllTrue(D(), nobody)) {
      bits =
          hn::Or(bitIf(hn::Not(areSame(instance, instancesAt(job.layers, index + 1))), kStepRight),
                 bitIf(hn::Not(areSame(instance, instancesAt(job.layers, over))), kStepAbove));
    } else {
      const LayerLanes own(job.layers, index, here, i);
      const VI safe = hn::IfThenZeroElse(hn::RebindMask(DI(), nobody), instance);
      asked = hn::IfThenZeroElse(hn::RebindMask(DI(), nobody),
                                 hn::GatherIndex(DI(), job.bounds.asks.data(), safe));
      const V crease = hn::GatherIndex(D(), job.bounds.crease.data(), safe);
      const VI count = hn::PromoteTo(DI(), hn::LoadU(DBytes(), job.layers.count.data() + index));
      const M looked =
          hn::RebindMask(D(), hn::Or(hn::Lt(count, hn::Set(DI(), job.samples)),
                                     hn::Gt(asked, hn::Set(DI(), NeighbourBounds::kAlways - 1))));
      bits = hn::Or(bitIf(looked, kStepRight),
                    hn::Or(pairBits(own, LayerLanes(job.layers, index + 1, here, i + 1), crease,
                                    kStepRight, kMayCreaseRight),
                           pairBits(own, LayerLanes(job.layers, over, isTop ? here : above, i),
                                    crease, kStepAbove, kMayCreaseAbove)));
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
  const auto width = static_cast<std::size_t>(job.layers.width);
  const bool isTop = job.y + 1 >= job.layers.height;
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
