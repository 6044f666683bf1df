// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/MendBorder.h"

#include <gtest/gtest.h>

#include <initializer_list>

namespace limn {
namespace {

/// Chains in a plane, all with the same gap.
struct Border {
  BorderPieces pieces;
  double gap;

  explicit Border(double gapOfAll) : gap(gapOfAll) {}
  void add(std::initializer_list<Vec3d> points, bool showsOut = true)
  {
    const auto first = static_cast<std::uint32_t>(pieces.points.size());
    for (const Vec3d& p : points) {
      pieces.points.push_back(p);
      pieces.receiver.push_back(0);
      pieces.reach.push_back(gap);
      pieces.isOfContour.push_back(1);
      pieces.showsOut.push_back(showsOut ? 1 : 0);
    }
    for (std::uint32_t i = 0; i + 1 < points.size(); ++i)
      pieces.links.push_back({first + i, first + i + 1, 0});
  }
  std::size_t chainsWhenMended(const std::vector<ShadowCaster>& casters = {})
  {
    mendBorder(casters, pieces);
    LineChains chains;
    chainLinks(pieces.links, pieces.points.size(), chains, nullptr);
    return chains.first.size() - 1;
  }
};

ShadowCaster contour(Vec3d a, Vec3d b, std::uint64_t place, std::uint32_t triangle)
{
  return {{a, b}, {place, place + 1}, {triangle, triangle}, {kNoCorner, kNoCorner}, 0, true, 1, 1};
}

TEST(MendBorder, JoinsWhatGoesOnWithinTheGap)
{
  Border near(1);
  near.add({{0, 0, 0}, {5, 0, 0}});
  near.add({{5.9, 0.1, 0}, {10, 0, 0}});
  EXPECT_EQ(near.chainsWhenMended(), 1u);
  Border far(0.8);
  far.add({{0, 0, 0}, {5, 0, 0}});
  far.add({{5.9, 0.1, 0}, {10, 0, 0}});
  EXPECT_EQ(far.chainsWhenMended(), 2u);
  Border exact(0);
  exact.add({{0, 0, 0}, {5, 0, 0}});
  exact.add({{5 + 1e-9, 0, 0}, {10, 0, 0}});
  EXPECT_EQ(exact.chainsWhenMended(), 2u);
}

TEST(MendBorder, DoesNotTurnBackNorJoinTwoSidesOfASheet)
{
  Border besides(1);
  besides.add({{0, 0, 0}, {5, 0, 0}});
  besides.add({{0, 0.1, 0}, {5, 0.1, 0}});
  EXPECT_EQ(besides.chainsWhenMended(), 2u);
  Border behind(1);
  behind.add({{0, 0, 0}, {5, 0, 0}});
  behind.add({{5.5, 0, 0}, {9, 0, 0}}, false);
  EXPECT_EQ(behind.chainsWhenMended(), 2u);
}

TEST(MendBorder, TheNearestEndsAreJoinedFirst)
{
  Border border(2);
  border.add({{0, 0, 0}, {5, 0, 0}});
  border.add({{6.5, 0, 0}, {10, 0, 0}});
  border.add({{6, 0.1, 0}, {10, 3, 0}});
  EXPECT_EQ(border.chainsWhenMended(), 2u);
  const LineLink joint = border.pieces.links.back();
  EXPECT_EQ(joint.a, 1u);
  EXPECT_EQ(joint.b, 4u);
}

TEST(MendBorder, DropsSpecksAndKeepsLoops)
{
  Border border(1);
  border.add({{0, 0, 0}, {5, 0, 0}});
  border.add({{2, 4, 0}, {2.5, 4, 0}});
  EXPECT_EQ(border.chainsWhenMended(), 1u);
  Border loop(1);
  loop.add({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0.2, 0}});
  EXPECT_EQ(loop.chainsWhenMended(), 1u);
  EXPECT_EQ(loop.pieces.links.size(), 5u) << "closed";
}

// To where contours turn back rather than to the nearest point of one, and no farther than twice
// the gap.
TEST(MendBorder, LeadsEndsToContours)
{
  Border border(1);
  border.add({{0, 0, 0}, {5, 0, 0}});
  const std::vector<ShadowCaster> across = {contour({6, -3, 0}, {6, 1, 0}, 10, 7),
                                            contour({6, 1, 0}, {6, 3, 0}, 11, 8)};
  EXPECT_EQ(border.chainsWhenMended(across), 1u);
  ASSERT_EQ(border.pieces.points.size(), 3u);
  EXPECT_NEAR(border.pieces.points[2].x, 6, 1e-12);
  EXPECT_NEAR(border.pieces.points[2].y, 0, 1e-12);
  EXPECT_EQ(border.pieces.receiver[2], 7u);
  Border turning(1);
  turning.add({{0, 0, 0}, {5, 0, 0}});
  EXPECT_EQ(turning.chainsWhenMended({contour({6.5, 0.5, 0}, {5.5, 3, 0}, 10, 7)}), 1u);
  ASSERT_EQ(turning.pieces.points.size(), 3u);
  EXPECT_NEAR(turning.pieces.points[2].x, 6.5, 1e-12);
  Border far(0.4);
  far.add({{0, 0, 0}, {5, 0, 0}});
  EXPECT_EQ(far.chainsWhenMended(across), 1u);
  EXPECT_EQ(far.pieces.points.size(), 2u);
}

}  // namespace
}  // namespace limn
