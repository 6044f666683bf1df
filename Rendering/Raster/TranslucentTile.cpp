// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Raster/TranslucentTile.h"

#include <algorithm>

namespace limn {
namespace {

// A vector may be written behind the last element.
constexpr std::size_t kRoom = kMaxTranslucentSamples + 2 * TranslucentTile::kMostMixed;

}  // namespace

void TranslucentTile::clear()
{
  place_.resize(kRoom);
  owner_.resize(kRoom);
  depth_.resize(kRoom);
  count_ = 0;
  isOverfull_ = hasPieces_ = false;
  clusters_ = nullptr;
}

void TranslucentTile::keepNearest(const TileClusters& clusters, int samples)
{
  clear();
  heap_.resize(kMaxTranslucentSamples);
  clusters_ = &clusters;
  samples_ = samples;
  std::fill(std::begin(heapSize_), std::end(heapSize_), 0u);
  truncated_ = 0;
}

void TranslucentTile::makeRoom()
{
  if (clusters_ != nullptr)
    sift();
  else
    isOverfull_ = true;
  count_ = 0;
}

bool TranslucentTile::isNearer(Layer a, Layer b) const
{
  return a.depth < b.depth ||
         (a.depth == b.depth && a.owner != b.owner && clusters_->drawnLater(a.owner, b.owner));
}

void TranslucentTile::sift()
{
  const std::size_t most = translucentLayersKept(samples_);
  const auto nearer = [&](Layer a, Layer b) { return isNearer(a, b); };
  for (std::size_t i = 0; i < count_; ++i) {
    const std::uint32_t column = pixel(i) % kTileSide;
    row_ = pixel(i) - column;
    const std::uint32_t place = column * static_cast<std::uint32_t>(samples_) + sample(i);
    Layer* const heap = heap_.data() + place * most;
    std::uint32_t& size = heapSize_[place];
    const Layer fresh = {depth_[i], owner_[i]};
    if (size == most) {
      truncated_ |= std::uint64_t{1} << column;
      if (!isNearer(fresh, heap[0])) continue;
      std::pop_heap(heap, heap + size, nearer);
      --size;
    }
    heap[size++] = fresh;
    std::push_heap(heap, heap + size, nearer);
  }
}

std::size_t TranslucentTile::settle()
{
  sift();
  count_ = 0;
  const std::size_t most = translucentLayersKept(samples_);
  const auto samples = static_cast<std::uint32_t>(samples_);
  for (std::uint32_t column = 0; column < kTileSide; ++column) {
    ofPixel_.clear();
    for (std::uint32_t s = 0; s < samples; ++s) {
      const std::uint32_t place = column * samples + s;
      for (std::uint32_t i = 0; i < heapSize_[place]; ++i)
        ofPixel_.push_back({heap_[place * most + i], s});
    }
    std::sort(ofPixel_.begin(), ofPixel_.end(), [](const Kept& a, const Kept& b) {
      return a.layer.owner != b.layer.owner ? a.layer.owner < b.layer.owner : a.sample < b.sample;
    });
    for (const Kept& kept : ofPixel_) {
      place_[count_] = (row_ + column) << kSampleBits | kept.sample;
      owner_[count_] = kept.layer.owner;
      depth_[count_++] = kept.layer.depth;
    }
  }
  std::size_t pixels = 0;
  for (std::uint64_t bits = truncated_; bits != 0; bits &= bits - 1)
    ++pixels;
  return pixels;
}

}  // namespace limn
