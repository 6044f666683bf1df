// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Compiled once per instruction set by AddBloom.cpp.
#include "Rendering/Base/Lanes-inl.h"
#include "Rendering/Base/Simd.h"

HWY_BEFORE_NAMESPACE();
namespace limn::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

HWY_INLINE V larger(V a, V b)
{
  return hn::IfThenElse(hn::Gt(a, b), a, b);
}

void brightPartKernel(const ColorPlanes& image, float threshold, int y, ColorPlanes& bright)
{
  const float* const in[3] = {image[0].row(y), image[1].row(y), image[2].row(y)};
  const auto width = static_cast<std::size_t>(image[0].width());
  for (std::size_t x = 0; x < width; x += hn::Lanes(D())) {
    const V r = hn::LoadU(D(), in[0] + x), g = hn::LoadU(D(), in[1] + x),
            b = hn::LoadU(D(), in[2] + x);
    const V most = larger(larger(r, g), b);
    const M isBright = hn::Gt(most, set(threshold));
    const V part = hn::IfThenElseZero(isBright, hn::Div(hn::Sub(most, set(threshold)), most));
    hn::StoreU(hn::Mul(r, part), D(), bright[0].row(y) + x);
    hn::StoreU(hn::Mul(g, part), D(), bright[1].row(y) + x);
    hn::StoreU(hn::Mul(b, part), D(), bright[2].row(y) + x);
  }
}

/// ((a + e) + 4 (b + d) + 6 c) / 16
HWY_INLINE V binomial(V a, V b, V c, V d, V e)
{
  const V sides = hn::Add(hn::Add(a, e), hn::Mul(set(4.0f), hn::Add(b, d)));
  return hn::Mul(hn::Add(sides, hn::Mul(set(6.0f), c)), set(1.0f / 16));
}
/// ((a + c) + 6 b) / 8
HWY_INLINE V evenBetween(V a, V b, V c)
{
  return hn::Mul(hn::Add(hn::Add(a, c), hn::Mul(set(6.0f), b)), set(1.0f / 8));
}
HWY_INLINE V oddBetween(V a, V b)
{
  return hn::Mul(hn::Add(a, b), set(1.0f / 2));
}

/// One row of the next coarser level. `column` has room as a row of the finer level has.
void reduceRowKernel(const float* const (&rows)[5], int fineWidth, float* column, float* out)
{
  const auto width = static_cast<std::size_t>(fineWidth);
  const std::size_t lanes = hn::Lanes(D());
  for (std::size_t x = 0; x < width; x += lanes) {
    const auto at = [&](int k) HWY_ATTR { return hn::LoadU(D(), rows[k] + x); };
    hn::StoreU(binomial(at(0), at(1), at(2), at(3), at(4)), D(), column + x);
  }
  for (std::size_t i = 0; 2 * i < width; i += lanes) {
    V a = set(0.0f), b = a, c = a, d = a, e = a, unused = a;
    hn::LoadInterleaved2(D(), column + 2 * i - 2, a, b);
    hn::LoadInterleaved2(D(), column + 2 * i, c, d);
    hn::LoadInterleaved2(D(), column + 2 * i + 2, e, unused);
    hn::StoreU(binomial(a, b, c, d, e), D(), out + i);
  }
}

/// What a row between two rows of the coarser level holds, or, of an even row, between three.
void blendRowsKernel(const float* const (&rows)[3], int coarseWidth, bool isEven, float* out)
{
  const auto width = static_cast<std::size_t>(coarseWidth);
  for (std::size_t x = 0; x < width; x += hn::Lanes(D())) {
    const V middle = hn::LoadU(D(), rows[1] + x), last = hn::LoadU(D(), rows[2] + x);
    hn::StoreU(
        isEven ? evenBetween(hn::LoadU(D(), rows[0] + x), middle, last) : oddBetween(middle, last),
        D(), out + x);
  }
}

/// Adds `scale` times a blended row, made twice as long, to a row of the finer level.
void expandRowKernel(const float* blended, float scale, int fineWidth, float* out)
{
  const auto width = static_cast<std::size_t>(fineWidth);
  const std::size_t lanes = hn::Lanes(D());
  alignas(64) float both[2 * HWY_MAX_BYTES / sizeof(float)];
  for (std::size_t i = 0; 2 * i < width; i += lanes) {
    const V before = hn::LoadU(D(), blended + i - 1), here = hn::LoadU(D(), blended + i),
            after = hn::LoadU(D(), blended + i + 1);
    hn::StoreInterleaved2(evenBetween(before, here, after), oddBetween(here, after), D(), both);
    for (std::size_t half = 0; half < 2 * lanes; half += lanes) {
      float* const to = out + 2 * i + half;
      hn::StoreU(hn::Add(hn::LoadU(D(), to), hn::Mul(set(scale), hn::Load(D(), both + half))), D(),
                 to);
    }
  }
}

}  // namespace limn::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
