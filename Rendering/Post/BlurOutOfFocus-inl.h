// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Compiled once per instruction set by BlurOutOfFocus.cpp.
#include "Rendering/Base/Lanes-inl.h"
#include "Rendering/Base/Simd.h"

HWY_BEFORE_NAMESPACE();
namespace limn::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Gathers the discs that reach the pixels [x0, x1) of a row. `taps` are those within reach.
void gatherDiscsKernel(const LensPlanes& lens, Span<const LensTap> taps, const LensSegment& segment)
{
  for (int x = segment.x0; x < segment.x1; x += static_cast<int>(hn::Lanes(D()))) {
    const std::ptrdiff_t pixel = segment.y * lens.stride + x;
    const V depth = hn::LoadU(D(), lens.depth + pixel);
    const V radius = hn::LoadU(D(), lens.radius + pixel);
    const V share = hn::LoadU(D(), lens.share + pixel);
    V weights = hn::Zero(D());
    V r = weights, g = weights, b = weights, a = weights;
    for (const LensTap& tap : taps) {
      if (segment.y + tap.dy < 0 || segment.y + tap.dy >= lens.height) continue;
      const std::ptrdiff_t from = pixel + tap.dy * lens.stride + tap.dx;
      const V fromRadius = hn::LoadU(D(), lens.radius + from);
      const M isHeld =
          hn::And(hn::Gt(hn::LoadU(D(), lens.depth + from), depth), hn::Lt(radius, fromRadius));
      const V disc = hn::IfThenElse(isHeld, radius, fromRadius);
      const V inside = positive(hn::Sub(hn::Add(disc, set(0.5f)), set(tap.distance)));
      const V covered = hn::IfThenElse(hn::Lt(inside, set(1.0f)), inside, set(1.0f));
      const V weight =
          hn::Mul(covered, hn::IfThenElse(isHeld, share, hn::LoadU(D(), lens.share + from)));
      weights = hn::Add(weights, weight);
      r = hn::Add(r, hn::Mul(weight, hn::LoadU(D(), lens.channel[0] + from)));
      g = hn::Add(g, hn::Mul(weight, hn::LoadU(D(), lens.channel[1] + from)));
      b = hn::Add(b, hn::Mul(weight, hn::LoadU(D(), lens.channel[2] + from)));
      a = hn::Add(a, hn::Mul(weight, hn::LoadU(D(), lens.channel[3] + from)));
    }
    hn::StoreU(hn::Div(r, weights), D(), segment.out[0] + x);
    hn::StoreU(hn::Div(g, weights), D(), segment.out[1] + x);
    hn::StoreU(hn::Div(b, weights), D(), segment.out[2] + x);
    hn::StoreU(hn::Div(a, weights), D(), segment.out[3] + x);
  }
}

}  // namespace limn::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
