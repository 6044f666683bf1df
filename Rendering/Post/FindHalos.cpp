// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Post/FindHalos.h"

#include "Rendering/Lines/HaloCut.h"
#include "Rendering/Post/EffectPass.h"

#include <algorithm>
#include <cmath>

namespace limn {

HaloFinder::HaloFinder(const CuePass& pass, const DistancePlane& distances)
    : pass_(pass), distances_(distances)
{
  for (const Instance& instance : pass.scene.instances) {
    const float width = hasCues(instance) ? instance.style.cues.halo.width : 0.0f;
    width_.push_back(width);
    if (width > 0.0f) reach_ = std::max(reach_, static_cast<int>(std::ceil(width)) + 1);
    cutsPanes_ = cutsPanes_ || instance.isTranslucent();
    cutsOverNobody_ = cutsOverNobody_ || !instance.lines.empty() || instance.isTranslucent();
  }
}

void HaloFinder::find()
{
  SurfaceLayers& layers = pass_.layers;
  borders_.resize(static_cast<std::size_t>(layers.height));
  layers.halo.resize(layers.instance.size());
  if (layers.apron > 0) std::fill_n(layers.halo.data(), layers.halo.size(), 0.0f);
  layers.haloOwner.resize(layers.instance.size());
  layers.ends.resize(layers.instance.size());
  if (cutsPanes_) layers.haloBorder.resize(layers.instance.size());
  forEachRow(pass_.threads, layers.height, [&](int y) { findBorders(y); });
  forEachRow(pass_.threads, layers.height, [&](int y) { findShares(y); });
}

/// How far a pixel is before or behind a distance beside it, if it shows the instance.
float HaloFinder::slopeTo(int x, int y, float distance, std::uint32_t instance) const
{
  const SurfaceLayers& layers = pass_.layers;
  if (x < 0 || y < 0 || x >= layers.width || y >= layers.height ||
      layers.instance[layers.indexOf(x, y)] != instance)
    return 0.0f;
  const float change = distances_.row(y)[x] - distance;
  return change < 0.0f ? -change : change;
}

/// Whether the surface ends there: before others, before parts of itself, too.
HaloFinder::End HaloFinder::endAt(int x, int y) const
{
  const SurfaceLayers& layers = pass_.layers;
  const std::size_t index = layers.indexOf(x, y);
  const std::uint32_t instance = layers.instance[index];
  const float own = distances_.row(y)[x];
  const float slope = haloOf(index).depth * layers.pointAt(x, y).pixel;
  const int x0 = std::max(x - 1, 0), x1 = std::min(x + 1, distances_.width - 1);
  const int y0 = std::max(y - 1, 0), y1 = std::min(y + 1, distances_.height - 1);
  End end = End::kNone;
  for (int row = y0; row <= y1; ++row)
    for (int column = x0; column <= x1; ++column) {
      const float other = distances_.row(row)[column], jump = other - own;
      if (other != DistancePlane::kFar && !(jump > slope)) continue;
      if (layers.instance[layers.indexOf(column, row)] != instance) {
        end = End::kBeforeOthers;
        continue;
      }
      // A rounded surface gets steep by and by.
      const float before = slopeTo(2 * x - column, 2 * y - row, own, instance);
      const float after = slopeTo(2 * column - x, 2 * row - y, other, instance);
      if (jump > 2.0f * (before < after ? after : before)) return End::kBeforeItself;
    }
  return end;
}

void HaloFinder::findBorders(int y)
{
  const SurfaceLayers& layers = pass_.layers;
  std::vector<Column>& columns = borders_[static_cast<std::size_t>(y)];
  const std::uint32_t* const instance = layers.instance.data() + layers.indexOf(0, y);
  std::uint8_t* const ends = pass_.layers.ends.data() + layers.indexOf(0, y);
  std::fill_n(ends, static_cast<std::size_t>(layers.width), std::uint8_t{0});
  for (int x = 0; x < layers.width; ++x) {
    if (instance[x] == kNobody || !(width_[instance[x]] > 0.0f)) continue;
    const End end = endAt(x, y);
    if (end == End::kNone) continue;
    ends[x] = 1;
    columns.push_back({x, end == End::kBeforeItself});
  }
}

void HaloFinder::findShares(int y)
{
  SurfaceLayers& layers = pass_.layers;
  std::fill_n(layers.halo.data() + layers.indexOf(0, y), static_cast<std::size_t>(layers.width),
              0.0f);
  std::vector<float> farthest(cutsPanes_ ? static_cast<std::size_t>(layers.width) : 0, 0.0f);
  for (int row = std::max(y - reach_, 0); row <= std::min(y + reach_, layers.height - 1); ++row)
    for (const Column& column : borders_[static_cast<std::size_t>(row)])
      addHalo(y, column, row, farthest);
}

/// Of parts of one instance: whether they are different surfaces.
bool HaloFinder::isStep(std::size_t behind, std::size_t before) const
{
  // Others may paint the colours meanwhile.
  const SurfaceLayers& layers = pass_.layers;
  const ViewPoint first = layers.pointAt(behind), second = layers.pointAt(before);
  const Style& style = pass_.scene.instances[layers.instance[before]].style;
  const float a = stepTolerance(style, first), b = stepTolerance(style, second);
  return PlaneDistances({first.position, layers.plane[behind]},
                        {second.position, layers.plane[before]})
      .areStep(a < b ? b : a);
}

bool HaloFinder::areOneSurface(std::size_t behind, std::size_t before, bool isBeforeItself) const
{
  return pass_.layers.instance[behind] == pass_.layers.instance[before] &&
         !(isBeforeItself && isStep(behind, before));
}

/// Over the pixels of row y, of the surface that ends in another row. `farthest`: how far halos
/// reach beyond the row's pixels, if haloBorder is wanted.
void HaloFinder::addHalo(int y, Column end, int row, std::vector<float>& farthest)
{
  const int column = end.x;
  SurfaceLayers& layers = pass_.layers;
  const std::size_t before = layers.indexOf(column, row);
  const HaloBorder border(pass_.scene, layers, before);
  const auto dy = static_cast<float>(y - row);
  const int reach = static_cast<int>(std::ceil(border.width)) + 1;
  if (y - row > reach || row - y > reach) return;
  for (int x = std::max(column - reach, 0); x <= std::min(column + reach, layers.width - 1); ++x) {
    const float other = distances_.row(y)[x];
    if (other == DistancePlane::kFar && !cutsOverNobody_) continue;
    const float width = border.widthOver(other);
    if (width == 0.0f) continue;
    const float reachOver = border.reachOver(width, static_cast<float>(x - column), dy);
    if (!(reachOver > 0.0f)) continue;
    const float share = reachOver < 1.0f ? reachOver : 1.0f;
    const std::size_t index = layers.indexOf(x, y);
    const bool isFarthest = !farthest.empty() && reachOver > farthest[static_cast<std::size_t>(x)];
    const bool isBetter = share > layers.halo[index] ||
                          (share == layers.halo[index] &&
                           border.distance < -layers.pointAt(layers.haloOwner[index]).position.z);
    if (!(isBetter || isFarthest) || areOneSurface(index, before, end.isBeforeItself)) continue;
    if (isFarthest) {
      farthest[static_cast<std::size_t>(x)] = reachOver;
      layers.haloBorder[index] = static_cast<std::uint32_t>(before);
    }
    if (!isBetter) continue;
    layers.halo[index] = share;
    layers.haloOwner[index] = static_cast<std::uint32_t>(before);
  }
}

float HaloFinder::shareBehind(Column end, int y) const
{
  const int x = end.x;
  const std::size_t before = pass_.layers.indexOf(x, y);
  const HaloBorder border(pass_.scene, pass_.layers, before);
  float most = 0.0f;
  const int x0 = std::max(x - 1, 0), x1 = std::min(x + 1, distances_.width - 1);
  const int y0 = std::max(y - 1, 0), y1 = std::min(y + 1, distances_.height - 1);
  for (int row = y0; row <= y1; ++row)
    for (int column = x0; column <= x1; ++column) {
      const float other = distances_.row(row)[column];
      if (other == DistancePlane::kFar) continue;
      const float width = border.widthOver(other);
      if (width > most &&
          !areOneSurface(pass_.layers.indexOf(column, row), before, end.isBeforeItself))
        most = width;
    }
  return border.shareOfRest(most);
}

}  // namespace limn
