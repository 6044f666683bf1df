// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/HaloCut.h"

#include <algorithm>
#include <cmath>

namespace limn {

HaloBorder::HaloBorder(const Scene& scene, const SurfaceLayers& layers, std::size_t index)
{
  const Halo& halo = scene.instances[layers.instance[index]].style.cues.halo;
  const ViewPoint point = layers.pointAt(index);
  distance = -point.position.z;
  width = halo.width;
  full = halo.depth * halo.width * point.pixel;
  covered = static_cast<float>(layers.countAt(index)) / static_cast<float>(scene.samples);
}

float HaloBorder::widthOver(float other) const
{
  if (other == kBehindAll) return width;
  const float behind = other - distance;
  if (!(behind > 0.0f)) return 0.0f;
  const float t = behind < full ? behind / full : 1.0f;
  return width * ((t * t) * (3.0f - 2.0f * t));
}

float HaloBorder::shareOf(float haloWidth, float dx, float dy) const
{
  const float unbounded = reachOver(haloWidth, dx, dy);
  return unbounded < 1.0f ? unbounded : 1.0f;
}

float HaloBorder::reachOver(float haloWidth, float dx, float dy) const
{
  const float fromBorder = std::sqrt(dx * dx + dy * dy) - (covered - 0.5f);
  return haloWidth + 0.5f - fromBorder;
}

float HaloBorder::shareOfRest(float haloWidth) const
{
  if (!(covered < 1.0f)) return 0.0f;
  const float share = haloWidth / (1.0f - covered);
  return share < 1.0f ? share : 1.0f;
}

/// Along the gaze, in the middle of a pixel.
float HaloCut::distanceAt(int x, int y, float depth) const
{
  if (depth > 1.0f) return HaloBorder::kBehindAll;
  const Vec2f centre = {static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f};
  return -layers_.toView->at(centre.x, centre.y, depth).position.z;
}

/// How much nearer the surface gets, at most, that ends in a pixel, within the next one.
float HaloCut::riseAt(std::size_t owner) const
{
  const auto [x, y] = layers_.pixelOf(owner);
  const float own = layers_.pointAt(owner).position.z;
  float most = 0.0f;
  for (int row = y - 1; row <= y + 1; ++row)
    for (int column = x - 1; column <= x + 1; ++column) {
      if (layers_.instance[layers_.indexOf(column, row)] != layers_.instance[owner]) continue;
      most = std::max(most, layers_.pointAt(column, row).position.z - own);
    }
  return most;
}

float HaloCut::shareAt(int x, int y, float depth, std::uint32_t instance) const
{
  const std::size_t index = layers_.indexOf(x, y);
  return layers_.halo[index] > 0.0f ? shareBy(layers_.haloOwner[index], x, y, depth, instance)
                                    : 0.0f;
}

float HaloCut::shareBy(std::size_t owner, int x, int y, float depth, std::uint32_t instance) const
{
  const HaloBorder border(scene_, layers_, owner);
  const float distance = distanceAt(x, y, depth);
  const PixelPlace at = layers_.pixelOf(owner);
  const auto dx = static_cast<float>(x - at.x), dy = static_cast<float>(y - at.y);
  const float away = 0.5f * std::sqrt(dx * dx + dy * dy) + 1.0f;
  if (instance == layers_.instance[owner] &&
      !(distance - border.distance > border.full + Halo::kHorizon * riseAt(owner) * away))
    return 0.0f;
  const float width = border.widthOver(distance);
  if (width == 0.0f) return 0.0f;
  const float share = border.shareOf(width, dx, dy);
  return share > 0.0f ? share : 0.0f;
}

HaloShare HaloCut::overPane(int x, int y, float depth, std::uint32_t instance) const
{
  const std::size_t index = layers_.indexOf(x, y);
  float share = 0.0f;
  std::size_t owner = index;
  if (layers_.halo[index] > 0.0f)
    for (const std::size_t one : {layers_.haloOwner[index], layers_.haloBorder[index]}) {
      const float by = shareBy(one, x, y, depth, instance);
      if (!(by > share)) continue;
      share = by;
      owner = one;
    }
  if (layers_.ends[index] != 0) {
    const HaloBorder border(scene_, layers_, index);
    const float ofRest = border.shareOfRest(border.widthOver(distanceAt(x, y, depth)));
    if (ofRest > share) {
      share = ofRest;
      owner = index;
    }
  }
  if (!(share > 0.0f)) return {0, {0, 0, 0}};
  return {share, scene_.instances[layers_.instance[owner]].style.cues.halo.color};
}

}  // namespace limn
