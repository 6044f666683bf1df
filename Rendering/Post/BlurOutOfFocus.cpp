// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Post/EffectPass.h"

#include "Rendering/Post/LensTaps.h"
#include "Rendering/Binning/TileGrid.h"
#include "Rendering/Base/Span.h"

#include <cmath>
#include <utility>
#include <vector>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Rendering/Post/BlurOutOfFocus.cpp"
#include <hwy/foreach_target.h>

#include "Rendering/Post/BlurOutOfFocus-inl.h"

#if HWY_ONCE
namespace limn {
namespace {

HWY_EXPORT(gatherDiscsKernel);

/// A pixel in focus: half a pixel covers it and nothing of its neighbours.
constexpr float kSharpRadius = 0.5f;
constexpr float kPi = 3.14159265f;
static_assert(kMaxBlurRadius < kTileSide, "discs reach the next tile, and no farther");

/// A row's discs, and what the gathering reads besides the image.
void prepareRow(const EffectPass& pass, const ThinLens& lens, int y)
{
  EffectPlanes& planes = pass.planes;
  const float* const depth = pass.frame.depth + y * pass.frame.rowStride;
  const Rgba8* const color = pass.frame.color + y * pass.frame.rowStride;
  const auto most = static_cast<float>(pass.effects.depthOfField.maxRadius);
  float* const radius = planes.radius.row(y);
  float* const share = planes.share.row(y);
  float* const alpha = planes.alpha.row(y);
  std::copy_n(depth, pass.frame.width, planes.depth.row(y));
  for (int x = 0; x < pass.frame.width; ++x) {
    const float found = std::fabs(lens.slope * depth[x] + lens.offset);
    const float r = found > kSharpRadius ? (found < most ? found : most) : kSharpRadius;
    radius[x] = r;
    // The area of the disc, its edge half a pixel soft, in whole pixels: 1 where it is sharp.
    share[x] = 1.0f / (1.0f + kPi * (r * r - kSharpRadius * kSharpRadius));
    alpha[x] = static_cast<float>(color[x].a);
  }
  planes.depth.padRow(y, 0, 0);
  planes.radius.padRow(y, kSharpRadius, kSharpRadius);
  planes.share.padRow(y, 0, 0);
  planes.alpha.padRow(y, 0, 0);
}

float largestRadius(const PaddedPlane& radius, const TileRectangle& tile)
{
  float largest = kSharpRadius;
  for (int y = tile.y0; y < tile.y1; ++y)
    for (int x = tile.x0; x < tile.x1; ++x)
      largest = std::max(largest, radius.row(y)[x]);
  return largest;
}

/// Of the discs that may meet the tile.
float reachOf(const std::vector<float>& largest, const TileGrid& grid, std::size_t tile)
{
  const int column = static_cast<int>(tile) % grid.columns();
  const int row = static_cast<int>(tile) / grid.columns();
  float reach = kSharpRadius;
  for (int y = std::max(row - 1, 0); y <= std::min(row + 1, grid.rows() - 1); ++y)
    for (int x = std::max(column - 1, 0); x <= std::min(column + 1, grid.columns() - 1); ++x)
      reach = std::max(reach, largest[grid.index(x, y)]);
  return reach;
}

/// All within reach, row by row from below: sums run in this order. What a longer reach would add
/// to them is zeros.
void listTaps(float reach, std::vector<LensTap>& taps)
{
  taps.clear();
  const int side = static_cast<int>(reach + kSharpRadius);
  for (int dy = -side; dy <= side; ++dy)
    for (int dx = -side; dx <= side; ++dx) {
      const float distance = std::sqrt(static_cast<float>(dx * dx + dy * dy));
      if (distance < reach + kSharpRadius) taps.push_back({dx, dy, distance});
    }
}

void blurTile(const EffectPass& pass, float reach, const TileRectangle& tile)
{
  EffectPlanes& planes = pass.planes;
  const PaddedPlane* const in[4] = {&planes.image[0], &planes.image[1], &planes.image[2],
                                    &planes.alpha};
  PaddedPlane* const out[4] = {&planes.blurred[0], &planes.blurred[1], &planes.blurred[2],
                               &planes.blurredAlpha};
  if (reach == kSharpRadius) {
    for (int y = tile.y0; y < tile.y1; ++y)
      for (int c = 0; c < 4; ++c)
        std::copy_n(in[c]->row(y) + tile.x0, tile.x1 - tile.x0, out[c]->row(y) + tile.x0);
    return;
  }
  thread_local std::vector<LensTap> taps;
  listTaps(reach, taps);
  const LensPlanes lens = {
      planes.depth.stride(), pass.frame.height,
      planes.depth.row(0),   planes.radius.row(0),
      planes.share.row(0),   {in[0]->row(0), in[1]->row(0), in[2]->row(0), in[3]->row(0)}};
  for (int y = tile.y0; y < tile.y1; ++y)
    HWY_DYNAMIC_DISPATCH(gatherDiscsKernel)
  (lens, taps,
   {y, tile.x0, tile.x1, {out[0]->row(y), out[1]->row(y), out[2]->row(y), out[3]->row(y)}});
}

void writeAlpha(const EffectPass& pass, int y)
{
  Rgba8* const color = pass.frame.color + y * pass.frame.rowStride;
  const float* const alpha = pass.planes.blurredAlpha.row(y);
  for (int x = 0; x < pass.frame.width; ++x)
    color[x].a = static_cast<std::uint8_t>(std::nearbyint(alpha[x]));
}

}  // namespace

void blurOutOfFocus(const EffectPass& pass, const ThinLens& lens)
{
  EffectPlanes& planes = pass.planes;
  const FrameView& frame = pass.frame;
  for (PaddedPlane* plane :
       {&planes.alpha, &planes.blurredAlpha, &planes.radius, &planes.share, &planes.depth,
        &planes.blurred[0], &planes.blurred[1], &planes.blurred[2]})
    plane->resize(frame.width, frame.height);
  forEachRow(pass.threads, frame.height, [&](int y) { prepareRow(pass, lens, y); });
  const TileGrid grid = {frame.width, frame.height};
  planes.largestRadius.resize(grid.count());
  parallelFor(pass.threads, grid.count(), [&](std::size_t tile) {
    planes.largestRadius[tile] = largestRadius(planes.radius, grid.rectangle(tile));
  });
  parallelFor(pass.threads, grid.count(), [&](std::size_t tile) {
    blurTile(pass, reachOf(planes.largestRadius, grid, tile), grid.rectangle(tile));
  });
  forEachRow(pass.threads, frame.height, [&](int y) { writeAlpha(pass, y); });
  std::swap(planes.image, planes.blurred);
}

}  // namespace limn
#endif  // HWY_ONCE
