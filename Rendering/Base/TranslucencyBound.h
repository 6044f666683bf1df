// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace limn {

/// How many samples of translucent triangles a thread keeps at a time; with what belongs to them at
/// most 24 MiB. Where a tile of 64 x 64 pixels has more it is drawn by parts, down to single rows,
/// which changes nothing. Only a row of 64 pixels that has more by itself (256 sheets over each
/// other with 16 samples a pixel, 4096 with one) is not drawn exactly: each of its samples keeps
/// the translucentLayersKept() nearest, of equal depths the latest in draw order, and
/// RenderStats::truncatedPixels counts the pixels that lost some.
inline constexpr std::size_t kMaxTranslucentSamples = std::size_t{1} << 18;
inline constexpr int kTranslucentRowPixels = 64;

/// Of each sample in a row that has more than kMaxTranslucentSamples.
constexpr std::size_t translucentLayersKept(int samples)
{
  return kMaxTranslucentSamples / (kTranslucentRowPixels * static_cast<std::size_t>(samples));
}

}  // namespace limn
