// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Shading/TranslucentFragments.h"

#include <algorithm>
#include <numeric>

namespace limn {
namespace {

constexpr std::uint32_t kNone = 0xFFFFFFFFu;

}  // namespace

void TranslucentFragments::reserve(const TranslucentTile& tile, int samples)
{
  const std::size_t most = tile.count();
  const std::size_t numbers = most + static_cast<std::size_t>(kTilePixels * samples);
  if (layers_.size() < numbers) layers_.resize(numbers);
  if (keepsDepths_ && depth_.size() < numbers) depth_.resize(numbers);
  if (order_.size() >= most) return;
  for (Array<std::uint32_t>* array : {&owner_, &pixel_, &order_, &fragment_, &older_,
                                      &rest_.fragment, &rest_.owner, &rest_.pixel})
    array->resize(most);
  coverage_.resize(most);
  rest_.coverage.resize(most);
  color_.resize(most);
}

/// The one of that triangle among the newest `most` of a pixel, else a new one.
std::uint32_t TranslucentFragments::fragmentOf(std::uint32_t owner, std::uint32_t pixel, int most)
{
  std::uint32_t f = newest_[pixel];
  for (int i = 0; i < most && f != kNone; ++i, f = older_[f])
    if (owner_[f] == owner) return f;
  const auto fresh = static_cast<std::uint32_t>(count_++);
  owner_[fresh] = owner;
  pixel_[fresh] = pixel;
  coverage_[fresh] = 0;
  older_[fresh] = newest_[pixel];
  newest_[pixel] = fresh;
  return fresh;
}

void TranslucentFragments::findFragments(int samples, const TranslucentTile& tile)
{
  count_ = 0;
  std::fill(std::begin(newest_), std::end(newest_), kNone);
  std::fill(std::begin(isRepeated_), std::end(isRepeated_), false);
  // With one sample a triangle comes again only where a clipped one's pieces overlap.
  const int most = samples == 1 ? 1 : static_cast<int>(TranslucentTile::kMostMixed);
  for (std::size_t i = 0; i < tile.count(); ++i) {
    const std::uint32_t pixel = tile.pixel(i);
    const std::uint32_t f = fragmentOf(tile.owner(i), pixel, most);
    const auto bit = static_cast<std::uint16_t>(1u << tile.sample(i));
    if ((coverage_[f] & bit) != 0) isRepeated_[pixel] = true;
    coverage_[f] = static_cast<std::uint16_t>(coverage_[f] | bit);
    fragment_[i] = f;
  }
}

/// findFragments() where each sample of the tile is a fragment.
void TranslucentFragments::takeEach(const TranslucentTile& tile)
{
  count_ = tile.count();
  std::fill(std::begin(isRepeated_), std::end(isRepeated_), false);
  std::copy_n(tile.owners(), count_, owner_.data());
  std::fill_n(coverage_.data(), count_, std::uint16_t{1});
  for (std::size_t i = 0; i < count_; ++i)
    pixel_[i] = tile.pixel(i);
}

void TranslucentFragments::findRuns()
{
  runs_.clear();
  runOwners_.clear();
  rest_.count = 0;
  for (std::size_t first = 0; first < count_;) {
    std::size_t end = first + 1;
    while (end < count_ && owner_[end] == owner_[first])
      ++end;
    runs_.push_back({static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(end)});
    runOwners_.push_back(owner_[first]);
    if (end - first < Run::kShortest) {
      breakRun(runs_.size() - 1);
      runs_.pop_back();
      runOwners_.pop_back();
    }
    first = end;
  }
}

void TranslucentFragments::breakRun(std::size_t run)
{
  for (std::uint32_t f = runs_[run].first; f < runs_[run].end; ++f) {
    rest_.fragment[rest_.count] = f;
    rest_.owner[rest_.count] = owner_[f];
    rest_.pixel[rest_.count] = pixel_[f];
    rest_.coverage[rest_.count++] = coverage_[f];
  }
}

void TranslucentFragments::sortByPixel(const TranslucentTile& tile)
{
  std::fill(std::begin(first_), std::end(first_), 0u);
  for (std::size_t i = 0; i < tile.count(); ++i)
    ++first_[tile.pixel(i)];
  std::partial_sum(std::begin(first_), std::end(first_), std::begin(first_));
  // From the last one down, each place becomes the one before: the ends become the beginnings.
  for (std::size_t i = tile.count(); i-- > 0;)
    order_[--first_[tile.pixel(i)]] = static_cast<std::uint32_t>(i);
}

void TranslucentFragments::collect(const TileClusters& clusters, int samples,
                                   const TranslucentTile& tile, Depths depths)
{
  keepsDepths_ = depths == Depths::kKept;
  reserve(tile, samples);
  isEachItsOwn_ = samples == 1 && !tile.hasPieces();
  if (isEachItsOwn_)
    takeEach(tile);
  else
    findFragments(samples, tile);
  findRuns();
  sortByPixel(tile);
  layerCount_ = 0;
  touched_.clear();
  for (std::uint32_t pixel = 0; pixel < kTilePixels; ++pixel) {
    if (first_[pixel] == first_[pixel + 1]) continue;
    touched_.push_back({pixel, layerCount_});
    collectPixel(clusters, samples, tile, pixel);
  }
}

void TranslucentFragments::collectPixel(const TileClusters& clusters, int samples,
                                        const TranslucentTile& tile, std::uint32_t pixel)
{
  const std::uint32_t* const numbers = order_.data() + first_[pixel];
  const std::size_t count = first_[pixel + 1] - first_[pixel];
  if (sorted_.size() < count) sorted_.resize(count);
  if (samples == 1) {
    for (std::size_t k = 0; k < count; ++k)
      sorted_[k] = {tile.depth(numbers[k]), isEachItsOwn_ ? numbers[k] : fragment_[numbers[k]]};
    addLayers(clusters, pixel, sorted_.data(), sorted_.data() + count);
    return;
  }
  std::uint32_t place[kMaxSamples + 1] = {};
  for (std::size_t k = 0; k < count; ++k)
    ++place[tile.sample(numbers[k])];
  std::uint32_t end = 0;
  for (std::uint32_t& p : place)
    p = end += p;
  for (std::size_t k = count; k-- > 0;)
    sorted_[--place[tile.sample(numbers[k])]] = {tile.depth(numbers[k]), fragment_[numbers[k]]};
  for (int s = 0; s < samples; ++s)
    addLayers(clusters, pixel, sorted_.data() + place[s], sorted_.data() + place[s + 1]);
}

void TranslucentFragments::addLayers(const TileClusters& clusters, std::uint32_t pixel,
                                     Layer* first, Layer* end)
{
  sortLayers(clusters, first, end);
  if (isRepeated_[pixel]) first = withoutRepetition(first, end);
  layers_[layerCount_++] = static_cast<std::uint32_t>(end - first);
  for (; first != end; ++first) {
    if (keepsDepths_) depth_[layerCount_] = first->depth;
    layers_[layerCount_++] = first->fragment;
  }
}

bool TranslucentFragments::areSameInAll(Pixel touched, std::uint32_t samples) const
{
  const std::uint32_t* const layers = layers_.data() + touched.first;
  const std::size_t length = 1 + layers[0];
  for (std::uint32_t s = 1; s < samples; ++s)
    if (layers[s * length] != layers[0] ||
        !std::equal(layers, layers + length, layers + s * length))
      return false;
  return true;
}

/// Each triangle counts once, where it is nearest. Returns the first of those that stay.
TranslucentFragments::Layer* TranslucentFragments::withoutRepetition(Layer* first, Layer* end)
{
  Layer* kept = end;
  for (Layer* next = end; next-- != first;)
    if (std::none_of(kept, end, [&](Layer one) { return one.fragment == next->fragment; }))
      *--kept = *next;
  return kept;
}

void TranslucentFragments::sortLayers(const TileClusters& clusters, Layer* first, Layer* end) const
{
  const auto isFarther = [&](Layer a, Layer b) {
    return a.depth > b.depth || (a.depth == b.depth && a.fragment != b.fragment &&
                                 clusters.drawnLater(owner_[b.fragment], owner_[a.fragment]));
  };
  constexpr std::ptrdiff_t kFew = 32;
  if (end - first > kFew) {
    std::sort(first, end, isFarther);
    return;
  }
  for (Layer* next = first; next < end; ++next) {
    const Layer layer = *next;
    Layer* place = next;
    for (; place != first && isFarther(layer, place[-1]); --place)
      *place = place[-1];
    *place = layer;
  }
}

}  // namespace limn
