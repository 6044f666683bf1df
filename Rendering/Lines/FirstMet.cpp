// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/FirstMet.h"

#include <cmath>

namespace limn {
namespace {

/// What rounding may do to u.
constexpr double kNearby = 1e-12;

/// Where the slice is there; elsewhere at its end.
double within(const Slice& slice, double u)
{
  return slice.at(std::min(std::max(u, slice.u0), slice.u1));
}

/// Whether it has anything between u = low and high, give or take rounding.
bool isAt(const Slice& slice, double low, double high)
{
  return slice.u0 <= high + kNearby && slice.u1 >= low - kNearby;
}

/// Whether one is behind another by more than `apart` wherever it is between u = low and high.
bool isBehind(const Slice& slice, const Slice& other, double low, double high, double apart)
{
  const double a = std::min(std::max(low, slice.u0), slice.u1),
               b = std::max(std::min(high, slice.u1), slice.u0);
  return slice.at(a) + apart < within(other, a) && slice.at(b) + apart < within(other, b);
}

}  // namespace

void LightFront::start(double low, double high)
{
  low_ = low;
  high_ = high;
  lit_ = kShadowSteps;
  std::fill(least_, least_ + kShadowSteps, -HUGE_VAL);
}

void LightFront::add(const Slice& slice)
{
  if (!slice.endsLight) return;
  const double perStep = kShadowSteps / (high_ - low_);
  const int first = std::max(static_cast<int>((slice.u0 - low_) * perStep), 0);
  for (int step = first; step < kShadowSteps && at(step + 1) <= slice.u1; ++step) {
    const double least = std::min(slice.at(at(step)), slice.at(at(step + 1)));
    if (at(step) < slice.u0 || !(least > least_[step])) continue;
    if (least >= 0 && !isDark(step)) --lit_;
    least_[step] = least;
  }
}

bool LightFront::isDark(double u) const
{
  int step = 0;
  while (step + 1 < kShadowSteps && at(step + 1) <= u)
    ++step;
  return isDark(step);
}

LightFront::Light LightFront::lightAt(const HalfPlane::Extent& extent, double apart) const
{
  const double perStep = kShadowSteps / (high_ - low_);
  const double first = (extent.u0 - kNearby - low_) * perStep,
               last = (extent.u1 + kNearby - low_) * perStep;
  if (!(first < kShadowSteps && last >= 0)) return Light::kComes;
  const int end = last < kShadowSteps - 1 ? static_cast<int>(last) : kShadowSteps - 1;
  Light light = Light::kIsDark;
  for (int step = first > 0 ? static_cast<int>(first) : 0; step <= end; ++step) {
    if (isDark(step)) continue;
    if (!(extent.most + apart < least_[step])) return Light::kComes;
    light = Light::kEndsBefore;
  }
  return light;
}

void FirstMet::look(const std::vector<Slice>& slices, const LightFront& front, double apart)
{
  slices_ = &slices;
  low_ = front.low();
  high_ = front.high();
  apart_ = apart;
  work_ = 0;
  halves_.clear();
  parts_.clear();
  parted_.clear();
  waysOut_.clear();
  stops_.clear();
  lastPart_.assign(slices.size(), 0);
  depth_.resize(slices.size());
  if (slices.empty()) return;
  for (std::uint32_t i = 0; i < slices.size(); ++i)
    if (slices[i].isWayOut()) {
      waysOut_.push_back(i);
      for (const double u : {slices[i].u0, slices[i].u1})
        if (!front.isDark(u)) stops_.push_back(u);
    }
  for (int first = 0, end = 1; first < kShadowSteps; first = end++) {
    while (end < kShadowSteps && front.isDark(end) == front.isDark(first))
      ++end;
    if (front.isDark(first)) continue;
    const double low = front.at(first), high = front.at(end);
    halves_.clear();
    for (std::uint32_t i = 0; i < slices.size(); ++i)
      if (isAt(slices[i], low, high)) halves_.push_back(i);
    split(low, high, 0, 0);
    if (first > 0) stops_.push_back(low);
    if (end < kShadowSteps) stops_.push_back(high);
  }
  std::sort(stops_.begin(), stops_.end());
  stops_.erase(std::unique(stops_.begin(), stops_.end()), stops_.end());
}

/// Of halves_ from `begin` on.
void FirstMet::split(double low, double high, std::size_t begin, int depth)
{
  dropHidden(low, high, begin);
  const std::size_t end = halves_.size(), count = end - begin;
  work_ += count;
  if (count <= kFew || depth >= kDeepest || work_ > kMostWork * slices_->size()) {
    addPart(low, high, begin);
    return;
  }
  const double middle = 0.5 * (low + high);
  const auto half = [&](double from, double to) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint32_t number = halves_[i];
      if (isAt((*slices_)[number], from, to)) halves_.push_back(number);
    }
    split(from, to, end, depth + 1);
    halves_.resize(end);
  };
  half(low, middle);
  half(middle, high);
}

void FirstMet::dropHidden(double low, double high, std::size_t begin)
{
  const std::vector<Slice>& slices = *slices_;
  const double middle = 0.5 * (low + high);
  std::uint32_t first = kNoSlice;
  double most = -HUGE_VAL;
  for (std::size_t i = begin; i < halves_.size(); ++i) {
    const Slice& slice = slices[halves_[i]];
    if (!slice.endsLight || slice.u0 > low || slice.u1 < high || !(slice.at(middle) > most))
      continue;
    first = halves_[i];
    most = slice.at(middle);
  }
  if (first == kNoSlice) return;
  // Twice as far, so that rounding does not tell otherwise than isHidden() at one place.
  halves_.erase(std::remove_if(halves_.begin() + static_cast<std::ptrdiff_t>(begin), halves_.end(),
                               [&](std::uint32_t i) {
                                 return isBehind(slices[i], slices[first], low, high, 2 * apart_);
                               }),
                halves_.end());
}

void FirstMet::addPart(double low, double high, std::size_t begin)
{
  const std::size_t first = parted_.size();
  parted_.insert(parted_.end(), halves_.begin() + static_cast<std::ptrdiff_t>(begin),
                 halves_.end());
  parts_.push_back({low, high, first, parted_.size()});
  addStops(parts_.back());
}

void FirstMet::addStops(const Part& part)
{
  const std::vector<Slice>& slices = *slices_;
  const auto add = [&](const Slice& slice, double u) {
    if (holds(part, u) && !isHidden(part, slice, u)) stops_.push_back(u);
  };
  for (std::size_t i = part.first; i < part.end; ++i) {
    const Slice& p = slices[parted_[i]];
    add(p, p.u0);
    add(p, p.u1);
    for (std::size_t j = i + 1; j < part.end; ++j) {
      const Slice& q = slices[parted_[j]];
      const double low = std::max(p.u0, q.u0), high = std::min(p.u1, q.u1);
      if (!(low < high)) continue;
      const double atLow = p.at(low) - q.at(low), atHigh = p.at(high) - q.at(high);
      if ((atLow < 0) != (atHigh < 0)) add(p, low + (high - low) * (atLow / (atLow - atHigh)));
    }
  }
}

bool FirstMet::isHidden(const Part& part, const Slice& slice, double u) const
{
  const double limit = within(slice, u) + apart_;
  for (std::size_t i = part.first; i < part.end; ++i) {
    const Slice& other = (*slices_)[parted_[i]];
    if (other.endsLight && other.u0 <= u && u <= other.u1 && other.at(u) > limit) return true;
  }
  return false;
}

void FirstMet::enter(std::size_t part)
{
  for (std::size_t i = parts_[part].first; i < parts_[part].end; ++i)
    lastPart_[parted_[i]] = part + 1;
}

/// The part's slices that reach from u0 to u1.
void FirstMet::order(const Part& part, double u0, double u1)
{
  const double middle = 0.5 * (u0 + u1);
  there_.clear();
  for (std::size_t i = part.first; i < part.end; ++i) {
    const Slice& slice = (*slices_)[parted_[i]];
    if (slice.u0 > u0 || slice.u1 < u1) continue;
    there_.push_back(parted_[i]);
    depth_[parted_[i]] = slice.at(middle);
  }
  std::sort(there_.begin(), there_.end(), [&](std::uint32_t a, std::uint32_t b) {
    return depth_[a] != depth_[b] ? depth_[a] > depth_[b] : a < b;
  });
}

bool FirstMet::isWayOutBehind(std::size_t part, double u0, double u1) const
{
  return std::any_of(waysOut_.begin(), waysOut_.end(), [&](std::uint32_t i) {
    const Slice& slice = (*slices_)[i];
    return lastPart_[i] != part + 1 && slice.u0 <= u0 && slice.u1 >= u1;
  });
}

}  // namespace limn
