// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/Panes.h"

#include <algorithm>

namespace limn {
namespace {

Vec3f full(Vec3f c)
{
  return {c.x < 1.0f ? c.x : 1.0f, c.y < 1.0f ? c.y : 1.0f, c.z < 1.0f ? c.z : 1.0f};
}

}  // namespace

void TilePanes::add(const TileClusters& clusters, int samples,
                    const TranslucentFragments& fragments)
{
  for (const TranslucentFragments::Pixel& touched : fragments.touched()) {
    const auto lists = static_cast<std::uint32_t>(
        fragments.areSameInAll(touched, static_cast<std::uint32_t>(samples)) ? 1 : samples);
    pixels_.push_back({touched.pixel, static_cast<std::uint32_t>(listEnd_.size()), lists});
    std::size_t next = touched.first;
    for (std::uint32_t list = 0; list < lists; ++list) {
      for (std::uint32_t count = fragments.layers()[next++]; count > 0; --count, ++next) {
        const std::uint32_t fragment = fragments.layers()[next];
        const std::uint32_t slot = TileOwner::slot(fragments.owners()[fragment]);
        const std::ptrdiff_t instance = clusters.at(slot).placed - clusters.scene->instances.data();
        panes_.push_back({fragments.depths()[next], static_cast<std::uint32_t>(instance),
                          fragments.colors()[fragment]});
      }
      listEnd_.push_back(static_cast<std::uint32_t>(panes_.size()));
    }
  }
}

LineColor TilePanes::before(const Pixel& pixel, Vec3f color, float depth,
                            std::uint32_t instance) const
{
  Vec3f colors = {0, 0, 0}, radiances = {0, 0, 0};
  std::size_t next = pixel.firstList == 0 ? 0 : listEnd_[pixel.firstList - 1];
  for (std::uint32_t list = 0; list < pixel.lists; ++list) {
    LineColor seen = {full(color), color};
    for (; next < listEnd_[pixel.firstList + list]; ++next) {
      const Pane& pane = panes_[next];
      if (pane.depth > depth || pane.instance == instance) continue;
      const Vec3f own = {pane.color.x, pane.color.y, pane.color.z};
      const float a = pane.color.w, rest = 1.0f - a;
      seen = {full(own) * a + seen.color * rest, own * a + seen.radiance * rest};
    }
    colors = colors + seen.color;
    radiances = radiances + seen.radiance;
  }
  const auto count = static_cast<float>(pixel.lists);
  return {{colors.x / count, colors.y / count, colors.z / count},
          {radiances.x / count, radiances.y / count, radiances.z / count}};
}

bool Panes::areNeeded(const Scene& scene, const FrameView& frame)
{
  if (frame.background == Background::kKeepApart) return false;
  const Span<const Instance> all = scene.instances;
  const auto translucent = std::count_if(all.begin(), all.end(),
                                         [](const Instance& one) { return one.isTranslucent(); });
  return std::any_of(all.begin(), all.end(), [&](const Instance& one) {
    return !one.lines.empty() && translucent > (one.isTranslucent() ? 1 : 0);
  });
}

}  // namespace limn
