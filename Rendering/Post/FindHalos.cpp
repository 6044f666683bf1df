// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Post/FindHalos.h"

#include "Rendering/Lines/HaloCut.h"
#include "Rendering/Post/EffectPass.h"

#include <algorithm>
#include <cmath>

namespace limn {

HaloFinder::HaloFinder(const CuePass& pass, const DistancePlane& distances, Array<float>& all)
    : pass_(pass), inFrame_(distances), distance_(all), apron_(haloApron(pass.scene))
{
  for (const Instance& instance : pass.scene.instances) {
    const float width = haloWidth(instance);
    width_.push_back(width);
    if (width > 0.0f) reach_ = std::max(reach_, haloReach(width));
    cutsPanes_ = cutsPanes_ || instance.isTranslucent();
    cutsOverNobody_ = cutsOverNobody_ || !instance.lines.empty() || instance.isTranslucent();
  }
}

void HaloFinder::find()
{
  SurfaceLayers& layers = pass_.layers;
  const int rows = layers.height + 2 * reach_;
  distance_.resize(layers.instance.size());
  borders_.resize(static_cast<std::size_t>(rows));
  layers.halo.resize(layers.instance.size());
  layers.haloOwner.resize(layers.instance.size());
  layers.ends.resize(layers.instance.size());
  if (cutsPanes_) layers.haloBorder.resize(layers.instance.size());
  forEachRow(pass_.threads, layers.height + 2 * apron_, [&](int y) { fillDistances(y - apron_); });
  forEachRow(pass_.threads, rows, [&](int y) { findBorders(y - reach_); });
  forEachRow(pass_.threads, layers.height, [&](int y) { findShares(y); });
}

/// Of a pixel of the apron.
float HaloFinder::distanceBeside(std::size_t index) const
{
  const SurfaceLayers& layers = pass_.layers;
  return layers.instance[index] == kNobody ? DistancePlane::kFar
                                           : -layers.pointAt(index).position.z;
}

void HaloFinder::fillDistances(int y)
{
  const SurfaceLayers& layers = pass_.layers;
  const bool isInFrame = y >= 0 && y < layers.height;
  const int inner = isInFrame ? 0 : layers.width;
  const auto fill = [&](int x0, int x1) {
    for (int x = x0; x < x1; ++x) {
      const std::size_t index = layers.indexOf(x, y);
      distance_[index] = distanceBeside(index);
    }
  };
  fill(-apron_, inner);
  if (isInFrame)
    std::copy_n(inFrame_.row(y), layers.width, distance_.data() + layers.indexOf(0, y));
  fill(layers.width, layers.width + apron_);
}

/// How far a pixel is before or behind a distance beside it, if it shows the instance.
float HaloFinder::slopeTo(std::size_t index, float distance, std::uint32_t instance) const
{
  if (pass_.layers.instance[index] != instance) return 0.0f;
  const float change = distance_[index] - distance;
  return change < 0.0f ? -change : change;
}

/// Whether the surface ends there: before others, before parts of itself, too.
HaloFinder::End HaloFinder::endAt(int x, int y) const
{
  const SurfaceLayers& layers = pass_.layers;
  const std::size_t index = layers.indexOf(x, y);
  const std::uint32_t instance = layers.instance[index];
  const float own = distance_[index];
  const float slope = haloOf(index).depth * layers.pointAt(x, y).pixel;
  End end = End::kNone;
  for (int row = y - 1; row <= y + 1; ++row)
    for (int column = x - 1; column <= x + 1; ++column) {
      const std::size_t beside = layers.indexOf(column, row);
      const float other = distance_[beside], jump = other - own;
      if (other != DistancePlane::kFar && !(jump > slope)) continue;
      if (layers.instance[beside] != instance) {
        end = End::kBeforeOthers;
        continue;
      }
      // A rounded surface gets steep by and by.
      const float before = slopeTo(2 * index - beside, own, instance);
      const float after = slopeTo(2 * beside - index, other, instance);
      if (jump > 2.0f * (before < after ? after : before)) return End::kBeforeItself;
    }
  return end;
}

void HaloFinder::findBorders(int y)
{
  const SurfaceLayers& layers = pass_.layers;
  std::vector<Column>& columns = borders_[static_cast<std::size_t>(y + reach_)];
  const int first = -reach_, end = layers.width + reach_;
  const std::size_t place = layers.indexOf(first, y);
  const std::uint32_t* const instance = layers.instance.data() + place;
  std::uint8_t* const ends = pass_.layers.ends.data() + place;
  std::fill_n(ends, static_cast<std::size_t>(end - first), std::uint8_t{0});
  for (int x = first; x < end; ++x) {
    if (instance[x - first] == kNobody || !(width_[instance[x - first]] > 0.0f)) continue;
    const End which = endAt(x, y);
    if (which == End::kNone) continue;
    ends[x - first] = 1;
    columns.push_back({x, which == End::kBeforeItself});
  }
}

void HaloFinder::findShares(int y)
{
  SurfaceLayers& layers = pass_.layers;
  std::fill_n(layers.halo.data() + layers.indexOf(0, y), static_cast<std::size_t>(layers.width),
              0.0f);
  std::vector<float> farthest(cutsPanes_ ? static_cast<std::size_t>(layers.width) : 0, 0.0f);
  for (int row = y - reach_; row <= y + reach_; ++row)
    for (const Column& column : bordersOf(row))
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
  const int reach = haloReach(border.width);
  if (y - row > reach || row - y > reach) return;
  for (int x = std::max(column - reach, 0); x <= std::min(column + reach, layers.width - 1); ++x) {
    const std::size_t index = layers.indexOf(x, y);
    const float other = distance_[index];
    if (other == DistancePlane::kFar && !cutsOverNobody_) continue;
    const float width = border.widthOver(other);
    if (width == 0.0f) continue;
    const float reachOver = border.reachOver(width, static_cast<float>(x - column), dy);
    if (!(reachOver > 0.0f)) continue;
    const float share = reachOver < 1.0f ? reachOver : 1.0f;
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
  for (int row = y - 1; row <= y + 1; ++row)
    for (int column = x - 1; column <= x + 1; ++column) {
      const std::size_t index = pass_.layers.indexOf(column, row);
      const float other = distance_[index];
      if (other == DistancePlane::kFar) continue;
      const float width = border.widthOver(other);
      if (width > most && !areOneSurface(index, before, end.isBeforeItself)) most = width;
    }
  return border.shareOfRest(most);
}

}  // namespace limn
