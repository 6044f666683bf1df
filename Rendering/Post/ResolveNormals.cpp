// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Post/ResolveNormals.h"

#include "Rendering/Post/NearestSample.h"
#include "Rendering/Post/TilePlace.h"

#include <algorithm>

namespace limn {
namespace {

void copyNormals(const VectorArrays& from, std::size_t i, const NormalView& out,
                 std::ptrdiff_t index, std::size_t count)
{
  std::copy_n(from.x.data() + i, count, out.x + index);
  std::copy_n(from.y.data() + i, count, out.y + index);
  std::copy_n(from.z.data() + i, count, out.z + index);
}

}  // namespace

void resolveNormals(const TileClusters& clusters, const VisibilityTile& tile,
                    const TileRectangle& pixels, const FragmentList& fragments,
                    const TileColors& colors, const FrameView& frame)
{
  const TilePlace place(pixels, frame);
  for (std::size_t r = 0; r < fragments.runCount; ++r)
    copyNormals(colors.pixelNormal, fragments.run[r].pixel, frame.normal,
                place.indexOf(fragments.run[r].pixel), fragments.run[r].length);
  const int samples = clusters.scene->scene->samples;
  for (std::size_t f = 0; f < fragments.count; ++f) {
    const std::size_t pixel = fragments.pixel[f];
    if (nearestSample(clusters, tile, samples, pixel).owner == fragments.owner[f])
      copyNormals(colors.fragmentNormal, f, frame.normal, place.indexOf(pixel), 1);
  }
}

}  // namespace limn
