// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/FirstMet.h"

#include <gtest/gtest.h>

#include <random>

namespace limn {
namespace {

Slice slice(double u0, double w0, double u1, double w1)
{
  return {u0, u1, w0, w1, 0, false, false, false, true};
}

/// Told apart with the front that their own make, and how often what was looked at.
struct Looked {
  std::vector<Stretch> stretches;
  std::size_t calls = 0, slices = 0;

  explicit Looked(const std::vector<Slice>& all)
  {
    LightFront front;
    front.start(0, 1);
    for (const Slice& one : all)
      front.add(one);
    FirstMet firstMet;
    firstMet.look(all, front, 1e-6);
    firstMet.find(
        [&](const std::vector<std::uint32_t>& there, const auto&) {
          ++calls;
          slices += there.size();
          return there.empty() ? kNoSlice : there[0];
        },
        stretches);
  }
};

/// Behind the caster.
std::vector<Slice> randomSlices(std::size_t count, double longest)
{
  std::mt19937 random(7);
  const auto share = [&] { return static_cast<double>(random() >> 8) * 0x1p-24; };
  std::vector<Slice> slices;
  while (slices.size() < count) {
    const double u = share() * (1 + longest) - longest, length = share() * longest;
    const double w0 = -share() - 0.1, w1 = -share() - 0.1;
    Slice one = slice(u, w0, u + length, w1);
    if (one.u1 <= 0 || one.u0 >= 1) continue;
    const Slice whole = one;
    one.u0 = std::max(one.u0, 0.0);
    one.u1 = std::min(one.u1, 1.0);
    one.w0 = whole.at(one.u0);
    one.w1 = whole.at(one.u1);
    slices.push_back(one);
  }
  return slices;
}

TEST(FirstMet, TellsTheHighestOfCrossingSlices)
{
  const std::vector<Slice> slices = {slice(0, -1, 1, -3), slice(0, -3, 1, -1),
                                     slice(0.25, -1, 0.75, -1), slice(0, -9, 1, -9)};
  const Looked looked(slices);
  ASSERT_EQ(looked.stretches.size(), 3u);
  const std::uint32_t expected[] = {0, 2, 1};
  const double ends[] = {0, 0.25, 0.75, 1};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(looked.stretches[i].slice, expected[i]);
    EXPECT_EQ(looked.stretches[i].u0, ends[i]);
    EXPECT_EQ(looked.stretches[i].u1, ends[i + 1]);
  }
}

TEST(FirstMet, TellsTheHighestOfManyEverywhere)
{
  for (const double longest : {0.05, 0.5, 3.0}) {
    const std::vector<Slice> slices = randomSlices(300, longest);
    const Looked looked(slices);
    for (int i = 0; i < 1000; ++i) {
      const double u = (i + 0.5) / 1000;
      double most = -HUGE_VAL, found = -HUGE_VAL;
      for (const Slice& one : slices)
        if (one.u0 <= u && u <= one.u1) most = std::max(most, one.at(u));
      for (const Stretch& stretch : looked.stretches)
        if (stretch.u0 <= u && u <= stretch.u1) found = slices[stretch.slice].at(u);
      EXPECT_EQ(found, most) << longest << ", " << u;
    }
  }
}

// Pairs of slices cross about a million times here, and a thousand are there at each place.
TEST(FirstMet, LooksAtFewOfManyThatCross)
{
  const Looked looked(randomSlices(2000, 3));
  EXPECT_GT(looked.stretches.size(), 1u);
  EXPECT_LT(looked.calls, 200u);
  EXPECT_LT(looked.slices, 2000u);
}

// Of a fine surface many slices are there, one after another, and others behind them.
TEST(FirstMet, LooksAtFewOfManyLayers)
{
  std::vector<Slice> slices;
  for (int layer = 0; layer < 20; ++layer)
    for (int i = 0; i < 500; ++i)
      slices.push_back(slice(i / 500.0, -1.0 - layer, (i + 1) / 500.0, -1.0 - layer));
  const Looked looked(slices);
  EXPECT_EQ(looked.stretches.size(), 500u);
  EXPECT_LE(looked.calls, 500u);
  EXPECT_LE(looked.slices, 500u);
}

// Where the caster lies in the dark there is nothing to tell.
TEST(FirstMet, DoesNotLookAtDarkSteps)
{
  std::vector<Slice> slices = randomSlices(50, 3);
  slices.push_back(slice(0.25, 1, 1, 2));
  const Looked looked(slices);
  ASSERT_FALSE(looked.stretches.empty());
  EXPECT_EQ(looked.stretches.back().u1, 0.25);
  slices.push_back(slice(0, 0, 0.5, 0));
  EXPECT_TRUE(Looked(slices).stretches.empty());
}

HalfPlane::Extent extent(double u0, double u1, double most)
{
  return {u0, u1, most};
}

TEST(LightFront, TellsWhereLightEnds)
{
  using Light = LightFront::Light;
  LightFront front;
  front.start(0, 1);
  front.add(slice(0.25, -1, 0.76, -2));
  front.add(slice(0.6, 1, 1, 0));
  EXPECT_EQ(front.lightAt(extent(0.3, 0.5, -2.1), 0.01), Light::kEndsBefore);
  EXPECT_EQ(front.lightAt(extent(0.3, 0.5, -0.9), 0.01), Light::kComes);
  EXPECT_EQ(front.lightAt(extent(0.2, 0.5, -2.1), 0.01), Light::kComes) << "reaches beside it";
  EXPECT_EQ(front.lightAt(extent(0.3, 0.9, -2.1), 0.01), Light::kEndsBefore);
  EXPECT_EQ(front.lightAt(extent(0.8, 0.9, 5), 0.01), Light::kIsDark);
  EXPECT_EQ(front.lightAt(extent(0.5, 0.9, 5), 0.01), Light::kComes);
  EXPECT_TRUE(front.isDark(0.7));
  EXPECT_FALSE(front.isDark(0.6)) << "its step begins before the slice";
  EXPECT_FALSE(front.isAllDark());
  front.add(slice(0, 0, 1, 0));
  EXPECT_TRUE(front.isAllDark());
}

}  // namespace
}  // namespace limn
