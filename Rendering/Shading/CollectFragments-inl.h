// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Compiled once per instruction set by CollectFragments.cpp.
#include "Rendering/Base/Compress-inl.h"
#include "Rendering/Base/MaskBits-inl.h"
#include "Rendering/Base/Simd.h"

HWY_BEFORE_NAMESPACE();
namespace limn::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// A row of a tile, a bit for each column.
struct RowBits {
  std::uint64_t visible;  ///< some sample shows a triangle
  std::uint64_t whole;    ///< all samples show the same triangle
  std::uint64_t ends;     ///< the next pixel's first sample shows another
};
static_assert(kTileSide == 64, "a row is a word");

RowBits bitsOfRow(const VisibilityTile& tile, int samples, int row)
{
  const hn::ScalableTag<std::uint32_t> d;
  const auto nobody = hn::Set(d, kNobody);
  RowBits bits = {};
  for (int column = 0; column < kTileSide; column += static_cast<int>(hn::Lanes(d))) {
    const int first = row * kTileSide + column;
    const auto owner = hn::Load(d, tile.owner[0] + first);
    // Past the end of a row there is another, or another member of the tile; see below.
    const auto ends = hn::Ne(owner, hn::LoadU(d, tile.owner[0] + first + 1));
    auto visible = hn::Ne(owner, nobody);
    auto whole = visible;
    for (int s = 1; s < samples; ++s) {
      const auto other = hn::Load(d, tile.owner[s] + first);
      visible = hn::Or(visible, hn::Ne(other, nobody));
      whole = hn::And(whole, hn::Eq(other, owner));
    }
    bits.visible |= bitsOf(d, visible) << column;
    bits.whole |= bitsOf(d, whole) << column;
    bits.ends |= bitsOf(d, ends) << column;
  }
  bits.ends |= std::uint64_t{1} << (kTileSide - 1);
  return bits;
}

/// Lists the row's runs; returns the pixels that belong to none.
std::uint64_t collectRuns(const VisibilityTile& tile, int row, const RowBits& bits,
                          FragmentList& fragments)
{
  const std::uint64_t starts = bits.whole & (bits.ends << 1 | ~(bits.whole << 1));
  const std::uint64_t goesOn = bits.whole & ~starts;
  std::uint64_t rest = bits.visible;
  // Starts with kShortest - 1 pixels that go on behind.
  std::uint64_t runs = starts;
  for (int i = 1; i < FragmentRun::kShortest; ++i)
    runs &= goesOn >> i;
  for (; runs != 0; runs &= runs - 1) {
    const int column = static_cast<int>(hwy::Num0BitsBelowLS1Bit_Nonzero64(runs));
    const std::uint64_t stops = ~goesOn >> (column + 1);
    const int length = stops == 0 ? kTileSide - column
                                  : 1 + static_cast<int>(hwy::Num0BitsBelowLS1Bit_Nonzero64(stops));
    const int pixel = row * kTileSide + column;
    fragments.addRun(tile.owner[0][pixel], pixel, length);
    rest &= ~(~std::uint64_t{0} >> (kTileSide - length) << column);
  }
  return rest;
}

/// Appends a row's fragments of one sample a pixel.
void collectOnes(const VisibilityTile& tile, int row, std::uint64_t pixels, FragmentList& fragments)
{
  const hn::ScalableTag<std::uint32_t> d;
  const auto lanes = static_cast<int>(hn::Lanes(d));
  for (int column = 0; column < kTileSide; column += lanes) {
    const std::uint64_t bits = pixels >> column & (~std::uint64_t{0} >> (kTileSide - lanes));
    if (bits == 0) continue;
    const int first = row * kTileSide + column;
    compressStoreBits(d, hn::Load(d, tile.owner[0] + first), bits,
                      fragments.owner.data() + fragments.count);
    fragments.count += compressStoreBits(d, hn::Iota(d, static_cast<std::uint32_t>(first)), bits,
                                         fragments.pixel.data() + fragments.count);
  }
}

/// Appends a row's fragments of several samples a pixel.
void collectSeveral(const VisibilityTile& tile, int samples, int row, std::uint64_t pixels,
                    FragmentList& fragments)
{
  for (; pixels != 0; pixels &= pixels - 1) {
    const int pixel =
        row * kTileSide + static_cast<int>(hwy::Num0BitsBelowLS1Bit_Nonzero64(pixels));
    const std::size_t first = fragments.count;
    for (int s = 0; s < samples; ++s) {
      const std::uint32_t owner = tile.owner[s][pixel];
      if (owner == kNobody) continue;
      const auto bit = static_cast<std::uint16_t>(1u << s);
      std::size_t f = first;
      while (f < fragments.count && fragments.owner[f] != owner)
        ++f;
      if (f == fragments.count) {
        fragments.owner[f] = owner;
        fragments.pixel[f] = static_cast<std::uint32_t>(pixel);
        fragments.coverage[f] = bit;
        ++fragments.count;
      } else {
        fragments.coverage[f] = static_cast<std::uint16_t>(fragments.coverage[f] | bit);
      }
    }
  }
}

void collectFragmentsKernel(const VisibilityTile& tile, const TileRectangle& pixels, int samples,
                            bool byRuns, FragmentList& fragments)
{
  // Nobody owns the pixels beyond the frame.
  for (int row = 0; row < pixels.y1 - pixels.y0; ++row) {
    const RowBits bits = bitsOfRow(tile, samples, row);
    const std::uint64_t rest = byRuns ? collectRuns(tile, row, bits, fragments) : bits.visible;
    if (rest == 0) continue;
    if (samples == 1)
      collectOnes(tile, row, rest, fragments);
    else
      collectSeveral(tile, samples, row, rest, fragments);
  }
}

}  // namespace limn::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
