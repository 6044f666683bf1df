// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Post/ResolveRadiance.h"

#include "Rendering/Base/BitCount.h"
#include "Rendering/Post/TilePlace.h"

#include <algorithm>

namespace limn {
namespace {

void copyRadiance(const RadianceArrays& from, std::size_t i, const RadianceView& out,
                  std::ptrdiff_t index, std::size_t count)
{
  std::copy_n(from.r.data() + i, count, out.r + index);
  std::copy_n(from.g.data() + i, count, out.g + index);
  std::copy_n(from.b.data() + i, count, out.b + index);
}

/// A sum weighted by counts of samples, and its mean.
class RadianceSum {
 public:
  explicit RadianceSum(const RadianceView& out) : out_(out) {}

  void add(const RadianceArrays& from, std::size_t i, std::uint32_t samples)
  {
    add({from.r[i], from.g[i], from.b[i]}, samples);
  }
  void addOld(std::ptrdiff_t index, std::uint32_t samples)
  {
    add({out_.r[index], out_.g[index], out_.b[index]}, samples);
  }
  std::uint32_t count() const { return count_; }
  void writeMean(std::ptrdiff_t index) const
  {
    const auto count = static_cast<float>(count_);
    out_.r[index] = sum_.x / count;
    out_.g[index] = sum_.y / count;
    out_.b[index] = sum_.z / count;
  }

 private:
  void add(Vec3f radiance, std::uint32_t samples)
  {
    sum_ = sum_ + radiance * static_cast<float>(samples);
    count_ += samples;
  }

  const RadianceView& out_;
  Vec3f sum_ = {0, 0, 0};
  std::uint32_t count_ = 0;
};

}  // namespace

void resolveRadiance(const TileClusters& clusters, const TileRectangle& pixels,
                     const FragmentList& fragments, const TileColors& colors,
                     const FrameView& frame)
{
  const TilePlace place(pixels, frame);
  for (std::size_t r = 0; r < fragments.runCount; ++r)
    copyRadiance(colors.pixelRadiance, fragments.run[r].pixel, frame.radiance,
                 place.indexOf(fragments.run[r].pixel), fragments.run[r].length);
  const auto samples = static_cast<std::uint32_t>(clusters.scene->scene->samples);
  for (std::size_t next = 0; next < fragments.count;) {
    const std::size_t pixel = fragments.pixel[next];
    const std::ptrdiff_t index = place.indexOf(pixel);
    RadianceSum sum(frame.radiance);
    for (; next < fragments.count && fragments.pixel[next] == pixel; ++next)
      sum.add(colors.fragmentRadiance, next, samples == 1 ? 1 : bitCount(fragments.coverage[next]));
    if (sum.count() < samples && frame.background == Background::kBlend)
      sum.addOld(index, samples - sum.count());
    sum.writeMean(index);
  }
}

}  // namespace limn
