// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Compiled once per instruction set by BorderBatch.cpp.
#include "Rendering/Base/Simd.h"
#include "Rendering/Lines/BorderBatch.h"

HWY_BEFORE_NAMESPACE();
namespace limn::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using DPixels = hn::CappedTag<float, BorderBatch::kPixels>;
using VPixels = hn::Vec<DPixels>;
using MPixels = hn::Mask<DPixels>;
using DNumbers = hn::RebindToSigned<DPixels>;
using VNumbers = hn::Vec<DNumbers>;

HWY_INLINE VPixels pixelsOf(float value)
{
  return hn::Set(DPixels(), value);
}
HWY_INLINE VPixels productOf(VPixels ax, VPixels ay, VPixels bx, VPixels by)
{
  return hn::Add(hn::Mul(ax, bx), hn::Mul(ay, by));
}

/// Some of a batch's pixels.
class BorderLanes {
 public:
  BorderLanes(const BorderBatch& batch, std::size_t first)
      : reach_(hn::Load(DNumbers(), batch.reach + first)),
        instance_(hn::Load(DNumbers(), batch.instance + first)),
        column_(hn::Iota(DNumbers(), batch.x + static_cast<int>(first))),
        x_(hn::Add(hn::ConvertTo(DPixels(), column_), pixelsOf(0.5f))),
        y_(pixelsOf(static_cast<float>(batch.y) + 0.5f)),
        outside_(hn::Neg(hn::Load(DPixels(), batch.outside + first)))
  {
  }

  struct Way {
    VPixels x, y;   ///< from the pixels' centres to the edge
    VPixels along;  ///< of that, how much is along the edge's normal
  };
  Way wayTo(const EdgePoint& edge) const
  {
    const VPixels x = hn::Sub(pixelsOf(edge.foot.x), x_), y = hn::Sub(pixelsOf(edge.foot.y), y_);
    return {x, y, productOf(pixelsOf(edge.normal.x), pixelsOf(edge.normal.y), x, y)};
  }
  /// Whether an edge counts.
  MPixels areNear(const BatchEdge& near, const Way& way) const
  {
    const EdgePoint& edge = *near.edge;
    const VNumbers columns = hn::Abs(hn::Sub(hn::Set(DNumbers(), edge.column), column_));
    const VNumbers rows = hn::Set(DNumbers(), near.rowsAway);
    const auto isFar = hn::Or(hn::Gt(columns, reach_), hn::Gt(rows, reach_));
    const auto isSame =
        hn::Eq(instance_, hn::Set(DNumbers(), static_cast<std::int32_t>(edge.instance)));
    return hn::AndNot(hn::Lt(way.along, outside_),
                      hn::RebindMask(DPixels(), hn::AndNot(isFar, isSame)));
  }

 private:
  VNumbers reach_, instance_, column_;
  VPixels x_, y_, outside_;
};

void findNearestEdgesKernel(BorderBatch& batch)
{
  const auto step = hn::Lanes(DPixels());
  for (std::size_t i = 0; i < BorderBatch::kPixels; i += step) {
    const BorderLanes pixels(batch, i);
    VPixels squared = hn::Zero(DPixels());
    VNumbers nearest = hn::Set(DNumbers(), BorderBatch::kNoEdge);
    VNumbers parts = hn::Zero(DNumbers());
    std::int32_t number = 0;
    for (const BatchEdge& edge : batch.edges) {
      const BorderLanes::Way way = pixels.wayTo(*edge.edge);
      const MPixels near = pixels.areNear(edge, way);
      const VPixels other = productOf(way.x, way.y, way.x, way.y);
      const MPixels isFirst = hn::RebindMask(DPixels(), hn::Lt(nearest, hn::Zero(DNumbers())));
      const MPixels isNearest = hn::And(near, hn::Or(isFirst, hn::Lt(other, squared)));
      squared = hn::IfThenElse(isNearest, other, squared);
      nearest = hn::IfThenElse(hn::RebindMask(DNumbers(), isNearest), hn::Set(DNumbers(), number),
                               nearest);
      if (edge.edge->part < 1.0f)
        parts = hn::Or(parts, hn::VecFromMask(DNumbers(), hn::RebindMask(DNumbers(), near)));
      ++number;
    }
    hn::Store(nearest, DNumbers(), batch.nearest + i);
    hn::Store(parts, DNumbers(), batch.haveParts + i);
  }
}

/// CutPixel::areaBelow()
HWY_INLINE VPixels areaBelow(VPixels normalX, VPixels normalY, VPixels distance)
{
  const VPixels zero = hn::Zero(DPixels()), one = pixelsOf(1.0f), half = pixelsOf(0.5f);
  const VPixels x = hn::Abs(normalX), y = hn::Abs(normalY);
  const MPixels isLower = hn::Lt(x, y);
  const VPixels longer = hn::IfThenElse(isLower, y, x), shorter = hn::IfThenElse(isLower, x, y);
  const VPixels flat = hn::Mul(hn::Sub(longer, shorter), half);
  const VPixels end = hn::Mul(hn::Add(longer, shorter), half);
  const VPixels linear = hn::Add(half, hn::Div(distance, longer));
  const MPixels isBefore = hn::Lt(distance, zero);
  const VPixels rest = hn::IfThenElse(isBefore, hn::Add(end, distance), hn::Sub(end, distance));
  const VPixels corner =
      hn::Div(hn::Mul(rest, rest), hn::Mul(hn::Mul(pixelsOf(2.0f), longer), shorter));
  const VPixels cut = hn::IfThenElse(isBefore, corner, hn::Sub(one, corner));
  const MPixels isFlat = hn::And(hn::Ge(distance, hn::Neg(flat)), hn::Le(distance, flat));
  const VPixels within = hn::IfThenElse(isFlat, linear, cut);
  const VPixels bounded = hn::IfThenElse(hn::Lt(distance, end), within, one);
  return hn::IfThenElseZero(hn::Gt(distance, hn::Neg(end)), bounded);
}

void coverBordersKernel(BorderBatch& batch)
{
  const auto step = hn::Lanes(DPixels());
  for (std::size_t i = 0; i < BorderBatch::kPixels; i += step) {
    const BorderLanes pixels(batch, i);
    const VPixels normalX = hn::Load(DPixels(), batch.normalX + i);
    const VPixels normalY = hn::Load(DPixels(), batch.normalY + i);
    const VPixels footX = hn::Load(DPixels(), batch.footX + i);
    const VPixels footY = hn::Load(DPixels(), batch.footY + i);
    const VPixels half = pixelsOf(0.5f);
    VPixels sum = hn::Zero(DPixels()), parts = sum, weights = sum;
    for (const BatchEdge& near : batch.edges) {
      const EdgePoint& edge = *near.edge;
      const BorderLanes::Way way = pixels.wayTo(edge);
      const VPixels along = hn::Abs(hn::Sub(hn::Mul(normalX, way.y), hn::Mul(normalY, way.x)));
      const VPixels weight = hn::Sub(pixelsOf(BorderRule::kSpan), along);
      const VPixels sameWay =
          productOf(pixelsOf(edge.normal.x), pixelsOf(edge.normal.y), normalX, normalY);
      const VPixels apart =
          hn::Abs(productOf(normalX, normalY, hn::Sub(pixelsOf(edge.foot.x), footX),
                            hn::Sub(pixelsOf(edge.foot.y), footY)));
      const MPixels isItsBorder = hn::And(hn::And(hn::Gt(weight, hn::Zero(DPixels())),
                                                  hn::Ge(sameWay, pixelsOf(BorderRule::kSameWay))),
                                          hn::Le(apart, pixelsOf(BorderRule::kSameBorder)));
      const MPixels counts = hn::And(isItsBorder, pixels.areNear(near, way));
      const VPixels mean =
          hn::Mul(half, hn::Add(way.along, productOf(normalX, normalY, way.x, way.y)));
      sum = hn::IfThenElse(counts, hn::Add(sum, hn::Mul(weight, mean)), sum);
      parts = hn::IfThenElse(counts, hn::Add(parts, hn::Mul(weight, pixelsOf(edge.part))), parts);
      weights = hn::IfThenElse(counts, hn::Add(weights, weight), weights);
    }
    const VPixels distance = hn::Div(sum, weights);
    const VPixels width = hn::Mul(hn::Load(DPixels(), batch.width + i), hn::Div(parts, weights));
    const VPixels area = areaBelow(normalX, normalY, hn::Sub(distance, width));
    const VPixels share = hn::Sub(hn::Load(DPixels(), batch.own + i), area);
    hn::Store(hn::IfThenElseZero(hn::Gt(share, hn::Zero(DPixels())), share), DPixels(),
              batch.share + i);
  }
}

}  // namespace limn::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
