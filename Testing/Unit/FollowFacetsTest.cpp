// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/FollowFacets.h"
#include "Testing/Unit/EdgedMesh.h"
#include "Testing/Unit/Polyhedra.h"
#include "Testing/Unit/TestScene.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

namespace limn {
namespace {

using testing::OwnedMesh;
using testing::Polyhedron;
using testing::Stage;

constexpr double kPi = 3.14159265358979323846;
/// Strokes of the style's default width leave so much that does not show.
constexpr double kShowsNot = 0.25;

struct Model : testing::EdgedMesh {
  using EdgedMesh::EdgedMesh;

  ContourLines smooth(const Stage& stage) const
  {
    return smoothContours(mesh, table, arrays, {}, stage.camera(), Mat4d::identity(), 2);
  }
  ContourLines followed(const Stage& stage, const LineStyle& style = {}, int threads = 2) const
  {
    return followed(smooth(stage), stage, style, threads);
  }
  ContourLines followed(ContourLines contours, const Stage& stage, const LineStyle& style,
                        int threads) const
  {
    followFacets(mesh, table, arrays,
                 {stage.camera(), Mat4d::identity(), stage.width, stage.height, style}, threads,
                 contours);
    return contours;
  }
};

struct Torus {
  Polyhedron mesh;
  std::vector<Vec3f> normals;
  OwnedMesh owned;

  Torus(std::uint32_t around, std::uint32_t across)
      : mesh(testing::torus(1, 0.4, around, across)),
        normals(vertexNormals(mesh.view(), NormalWeight::kAngle))
  {
    owned.positions = mesh.positions;
    owned.triangles = mesh.triangles;
    owned.cells = mesh.cells;
    owned.vertexNormals = normals;
    testing::finish(owned);
  }
};

Stage stageOf(const testing::Viewpoint& view, int side = 1000)
{
  Stage stage;
  stage.width = stage.height = side;
  stage.view = view;
  return stage;
}
testing::Viewpoint viewOf(double angle, bool isParallel)
{
  const Vec3d eye = {4 * std::cos(angle), 1 + std::sin(3 * angle), 4 * std::sin(angle)};
  return isParallel ? testing::parallelView(eye, {0, 0, 0}, 1.2)
                    : testing::perspectiveView(eye, {0, 0, 0}, 32);
}

struct Point {
  double x, y;
};
struct Line {
  Point a, b;
};

Point onScreen(const Stage& stage, Vec3d place)
{
  const Vec3d at = stage.project(place);
  return {at.x, at.y};
}
double turn(Point a, Point b, Point c)
{
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The outline of a convex mesh.
std::vector<Point> hullOf(const MeshView& mesh, const Stage& stage)
{
  std::vector<Point> points;
  for (std::size_t v = 0; v < mesh.vertexCount(); ++v)
    points.push_back(onScreen(stage, mesh.position(v)));
  std::sort(points.begin(), points.end(), [](const Point& a, const Point& b) {
    return std::pair(a.x, a.y) < std::pair(b.x, b.y);
  });
  std::vector<Point> hull;
  for (int half = 0; half < 2; ++half) {
    const std::size_t start = hull.size();
    for (const Point& p : points) {
      while (hull.size() >= start + 2 && turn(hull[hull.size() - 2], hull.back(), p) <= 0)
        hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

std::vector<Line> ringOf(const std::vector<Point>& points)
{
  std::vector<Line> lines;
  for (std::size_t i = 0; i < points.size(); ++i)
    lines.push_back({points[i], points[(i + 1) % points.size()]});
  return lines;
}
std::vector<Line> linesOf(const ContourLines& contours, const Stage& stage)
{
  std::vector<Line> lines;
  const LineChains& chains = contours.chains;
  for (std::size_t c = 0; c + 1 < chains.first.size(); ++c)
    for (std::size_t i = chains.first[c]; i + 1 < chains.first[c + 1]; ++i)
      lines.push_back({onScreen(stage, contours.points[chains.vertex[i]]),
                       onScreen(stage, contours.points[chains.vertex[i + 1]])});
  return lines;
}

double distance(Point p, const Line& line)
{
  const double dx = line.b.x - line.a.x, dy = line.b.y - line.a.y;
  const double squared = dx * dx + dy * dy;
  const double along = (p.x - line.a.x) * dx + (p.y - line.a.y) * dy;
  const double t = squared > 0 ? std::clamp(along / squared, 0.0, 1.0) : 0.0;
  return std::hypot(line.a.x + t * dx - p.x, line.a.y + t * dy - p.y);
}
/// How far some lines lie from others, at most.
double farthest(const std::vector<Line>& lines, const std::vector<Line>& others)
{
  constexpr int kPlaces = 16;
  double worst = 0;
  for (const Line& line : lines)
    for (int k = 0; k <= kPlaces; ++k) {
      const double t = static_cast<double>(k) / kPlaces;
      const Point p = {line.a.x + t * (line.b.x - line.a.x), line.a.y + t * (line.b.y - line.a.y)};
      double least = HUGE_VAL;
      for (const Line& other : others)
        least = std::min(least, distance(p, other));
      worst = std::max(worst, least);
    }
  return worst;
}

// The smooth contour is up to 24 pixels off.
TEST(FollowFacets, OfACoarseSphereAreTheHullOfItsCorners)
{
  const OwnedMesh sphere = testing::sphere(8, 12);
  const Model model(sphere.view(), sphere.vertexNormals);
  double apart = 0;
  for (const bool isParallel : {false, true})
    for (int frame = 0; frame < 60; ++frame) {
      const Stage stage = stageOf(viewOf(frame * kPi / 30, isParallel));
      const std::vector<Line> hull = ringOf(hullOf(model.mesh, stage));
      const std::vector<Line> lines = linesOf(model.followed(stage), stage);
      EXPECT_LT(farthest(lines, hull), kShowsNot + 0.02) << frame;
      EXPECT_LT(farthest(hull, lines), kShowsNot + 0.02) << frame;
      apart = std::max(apart, farthest(linesOf(model.smooth(stage), stage), hull));
    }
  EXPECT_GT(apart, 15);
}

TEST(FollowFacets, ChainsStayWhole)
{
  const Torus torus(14, 9);
  const Model model(torus.mesh.view(), torus.normals);
  for (int frame = 0; frame < 60; ++frame) {
    const Stage stage = stageOf(viewOf(frame * kPi / 30, false));
    const LineChains smooth = model.smooth(stage).chains;
    const ContourLines followed = model.followed(stage);
    const LineChains& chains = followed.chains;
    ASSERT_EQ(chains.first.size(), smooth.first.size());
    ASSERT_EQ(chains.flags.size(), chains.vertex.size());
    ASSERT_EQ(followed.facets.size(), chains.vertex.size());
    ASSERT_EQ(followed.slack.size(), followed.points.size());
    EXPECT_GT(chains.vertex.size(), smooth.vertex.size());
    for (std::size_t c = 0; c + 1 < chains.first.size(); ++c) {
      EXPECT_EQ(chains.vertex[chains.first[c]], smooth.vertex[smooth.first[c]]);
      EXPECT_EQ(chains.vertex[chains.first[c + 1] - 1], smooth.vertex[smooth.first[c + 1] - 1]);
    }
  }
}

void expectUnmoved(const Model& model, const Stage& stage, const LineStyle& style)
{
  const ContourLines smooth = model.smooth(stage), followed = model.followed(stage, style);
  EXPECT_EQ(followed.chains.vertex, smooth.chains.vertex);
  EXPECT_EQ(followed.chains.first, smooth.chains.first);
  EXPECT_TRUE(followed.points == smooth.points);
  EXPECT_EQ(followed.slack, smooth.slack);
}

TEST(FollowFacets, OfFineMeshesAreTheSmoothContours)
{
  const OwnedMesh sphere = testing::sphere(64, 96);
  expectUnmoved(Model(sphere.view(), sphere.vertexNormals), stageOf(viewOf(0.7, false), 480), {});
}

TEST(FollowFacets, StayWhereTheStrokeCoversWhatIsBetween)
{
  const OwnedMesh sphere = testing::sphere(15, 16);
  const Model model(sphere.view(), sphere.vertexNormals);
  const Stage stage = stageOf(viewOf(0.7, false), 480);
  LineStyle style;
  style.width = 24;
  expectUnmoved(model, stage, style);
  style.width = 12;
  style.outerFactor = 2;
  expectUnmoved(model, stage, style);
  // One sees through these.
  style.opacity = 0.5f;
  EXPECT_FALSE(model.followed(stage, style).points == model.smooth(stage).points);
}

TEST(FollowFacets, OfWhatIsBehindTheEyeStay)
{
  const Torus torus(14, 9);
  const Model model(torus.mesh.view(), torus.normals);
  for (int frame = 0; frame < 60; ++frame) {
    const double angle = frame * kPi / 30;
    const Vec3d eye = {std::cos(angle), std::sin(angle), 0.5 * std::sin(3 * angle)};
    const Stage stage =
        stageOf(testing::perspectiveView(eye, {std::sin(angle), 0.3, 0.8}, 70, {0.01, 10}));
    for (const Vec3d& p : model.followed(stage).points)
      ASSERT_LT(dot(p, p), 4) << frame;
  }
}

/// A sheet whose points are up to four edges out of their plane.
OwnedMesh noise(std::uint32_t side)
{
  OwnedMesh mesh;
  std::mt19937 random(7);
  const auto at = [side](std::uint32_t x, std::uint32_t z) { return z * (side + 1) + x; };
  const float edge = 2.0f / static_cast<float>(side);
  for (std::uint32_t z = 0; z <= side; ++z)
    for (std::uint32_t x = 0; x <= side; ++x) {
      const float up = static_cast<float>(random() % 1024) / 256.0f;
      mesh.positions.push_back(
          {static_cast<float>(x) * edge - 1.0f, up * edge, static_cast<float>(z) * edge - 1.0f});
      if (x == side || z == side) continue;
      mesh.triangles.push_back({{at(x, z), at(x, z + 1), at(x + 1, z)}});
      mesh.triangles.push_back({{at(x + 1, z), at(x, z + 1), at(x + 1, z + 1)}});
    }
  mesh.vertexNormals = vertexNormals(mesh.view(), NormalWeight::kAngle);
  testing::finish(mesh);
  return mesh;
}

TEST(FollowFacets, AreTheSameOnAnyNumberOfThreads)
{
  const OwnedMesh sheet = noise(160);
  const Model model(sheet.view(), sheet.vertexNormals);
  const Stage stage = stageOf(viewOf(0.4, false));
  const ContourLines expected = model.followed(stage, {}, 1);
  ASSERT_GT(expected.points.size(), 4096u);
  for (const int threads : {2, 3, 8}) {
    const ContourLines followed = model.followed(stage, {}, threads);
    EXPECT_TRUE(followed.points == expected.points) << threads;
    EXPECT_EQ(followed.slack, expected.slack) << threads;
    EXPECT_EQ(followed.chains.vertex, expected.chains.vertex) << threads;
    EXPECT_EQ(followed.chains.first, expected.chains.first) << threads;
    EXPECT_EQ(followed.chains.flags, expected.chains.flags) << threads;
  }
}

std::vector<Vec3d> pointsOf(const ContourLines& contours, std::size_t chain)
{
  std::vector<Vec3d> points;
  for (std::size_t i = contours.chains.first[chain]; i < contours.chains.first[chain + 1]; ++i)
    points.push_back(contours.points[contours.chains.vertex[i]]);
  return points;
}

/// One of several, which shares no end with others, behind one that is long but nowhere.
ContourLines behind(std::size_t length, const ContourLines& contours, std::size_t chain)
{
  ContourLines lines = contours;
  const auto part = [&](auto& list, const auto& filling) {
    list.erase(list.begin() + contours.chains.first[chain + 1], list.end());
    list.erase(list.begin(), list.begin() + contours.chains.first[chain]);
    list.insert(list.begin(), length, filling);
  };
  part(lines.chains.vertex, contours.chains.vertex[contours.chains.first[chain]]);
  part(lines.chains.flags, std::uint8_t{kOuterLine});
  part(lines.facets, ContourFacet{kNoCorner, false});
  lines.chains.first = {0, static_cast<std::uint32_t>(length),
                        static_cast<std::uint32_t>(lines.chains.vertex.size())};
  return lines;
}

// Threads take the chains in stretches, of 1024 places or a share of that.
TEST(FollowFacets, StretchesMayBeginAnywhereInALoop)
{
  const OwnedMesh sheet = noise(160);
  const Model model(sheet.view(), sheet.vertexNormals);
  const Stage stage = stageOf(viewOf(0.4, false));
  const ContourLines smooth = model.smooth(stage), all = model.followed(stage);
  const std::vector<std::uint32_t>&first = smooth.chains.first, &vertex = smooth.chains.vertex;
  int loops = 0;
  for (std::size_t c = 0; c + 1 < first.size() && loops < 8; ++c) {
    const std::size_t size = first[c + 1] - first[c];
    if (size < 16 || vertex[first[c]] != vertex[first[c + 1] - 1]) continue;
    ++loops;
    for (std::size_t k = 0; k <= size; ++k) {
      const ContourLines one = model.followed(behind(4096 - k, smooth, c), stage, {}, 1);
      ASSERT_TRUE(pointsOf(one, 1) == pointsOf(all, c)) << c << " from " << k;
    }
  }
  EXPECT_EQ(loops, 8);
}

/// How many pixels of a blue surface have black ones beside them, without a red line between.
int bared(const testing::Picture& picture)
{
  int count = 0;
  for (int y = 1; y + 1 < picture.height; ++y)
    for (int x = 1; x + 1 < picture.width; ++x) {
      const Rgba8 own = testing::at(picture, x, y);
      if (own.b < 64 || own.r > 64) continue;
      bool isBare = false;
      for (const auto& [dx, dy] : {std::pair(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
        const Rgba8 beside = testing::at(picture, x + dx, y + dy);
        isBare = isBare || (beside.b < 32 && beside.r < 32);
      }
      count += isBare ? 1 : 0;
    }
  return count;
}

class FollowFacetsPictures : public testing::BothBackends {
 protected:
  void expectCovered(const OwnedMesh& mesh, const Model& model, bool isParallel, int bare) const
  {
    LineStyle style;
    style.color = {1, 0, 0};
    const int frames = GetParam() == Backend::kReference ? 4 : 40;
    for (int frame = 0; frame < frames; ++frame) {
      Stage stage = stageOf(viewOf(frame * 2 * kPi / frames, isParallel), 300);
      stage.samples = 1 << frame % 4;
      const ContourLines contours = model.followed(stage, style);
      const LineSet set = contours.lines(style);
      stage.instances = {testing::painted(mesh, {0, 0, 1})};
      stage.instances[0].lines = {&set, 1};
      EXPECT_LE(bared(draw(stage)), bare) << "frame " << frame;
    }
  }
};

TEST_P(FollowFacetsPictures, NothingIsBesideTheOutlineOfACoarseSphere)
{
  const OwnedMesh sphere = testing::sphere(8, 12);
  const Model model(sphere.view(), sphere.vertexNormals);
  expectCovered(sphere, model, false, 0);
  expectCovered(sphere, model, true, 0);
}

// A pixel may be where one outline goes on behind another.
TEST_P(FollowFacetsPictures, NothingIsBesideTheOutlineOfACoarseTorus)
{
  const Torus torus(20, 12);
  const Model model(torus.owned.view(), torus.owned.vertexNormals);
  expectCovered(torus.owned, model, false, 1);
  expectCovered(torus.owned, model, true, 1);
}
LIMN_ON_BOTH_BACKENDS(FollowFacetsPictures);

}  // namespace
}  // namespace limn
