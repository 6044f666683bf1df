// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Triangles that share edges cover each sample exactly once, however a surface is cut up.
#include "Testing/Unit/TestScene.h"

#include "Rendering/Base/SamplePositions.h"

#include <algorithm>
#include <cmath>

namespace limn::testing {
namespace {

class FillRule : public BothBackends {};
LIMN_ON_BOTH_BACKENDS(FillRule);

constexpr int kSide = 64;

/// How often each sample of a picture is covered when triangles are drawn each for itself.
class CoverCounts {
 public:
  CoverCounts(const Stage& stage, Backend backend) : stage_(stage), backend_(backend)
  {
    counts_.resize(static_cast<std::size_t>(stage.width * stage.height * stage.samples));
  }
  void add(const OwnedMesh& mesh)
  {
    for (const Triangle& triangle : mesh.triangles) {
      OwnedMesh alone;
      for (const std::uint32_t v : triangle.vertex)
        alone.positions.push_back(mesh.positions[v]);
      alone.triangles = {{{0, 1, 2}}};
      finish(alone);
      stage_.instances = {painted(alone, {1, 1, 1})};
      const Picture picture = stage_.draw(backend_);
      for (std::size_t pixel = 0; pixel < picture.coverage.size(); ++pixel)
        for (int s = 0; s < stage_.samples; ++s)
          counts_[index(pixel, s)] += picture.coverage[pixel] >> s & 1;
    }
  }
  int of(int x, int y, int s) const
  {
    return counts_[index(static_cast<std::size_t>(y * stage_.width + x), s)];
  }

 private:
  std::size_t index(std::size_t pixel, int s) const
  {
    return pixel * static_cast<std::size_t>(stage_.samples) + static_cast<std::size_t>(s);
  }

  Stage stage_;
  Backend backend_;
  std::vector<int> counts_;
};

struct Point {
  std::int64_t x, y;  ///< 1/256 pixel
};
std::int64_t area(Point a, Point b, Point c)
{
  return (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
}

/// A square cut up by putting points, one after the other, into a triangle or onto an edge.
class Triangulation {
 public:
  Triangulation(std::int64_t low, std::int64_t high) : low_(low), high_(high)
  {
    points_ = {{low, low}, {high, low}, {high, high}, {low, high}};
    triangles_ = {{{0, 1, 2}}, {{0, 2, 3}}};
  }

  /// Splits the triangle that holds the point; no effect on an edge or outside.
  void insert(Point p)
  {
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      const auto [a, b, c] = triangles_[t].vertex;
      if (area(points_[a], points_[b], p) <= 0 || area(points_[b], points_[c], p) <= 0 ||
          area(points_[c], points_[a], p) <= 0)
        continue;
      const std::uint32_t fresh = addPoint(p);
      triangles_[t] = {{a, b, fresh}};
      triangles_.push_back({{b, c, fresh}});
      triangles_.push_back({{c, a, fresh}});
      return;
    }
  }
  /// A point close to the line from a corner of some triangle to another: a sliver.
  void insertNearEdge(Random& random)
  {
    const Triangle& t = triangles_[random.below(static_cast<std::uint32_t>(triangles_.size()))];
    const Point a = points_[t.vertex[0]], b = points_[t.vertex[1]], c = points_[t.vertex[2]];
    const double u = random.between(0.02, 0.98), v = random.between(0, 0.01);
    const auto mix = [&](std::int64_t i, std::int64_t j, std::int64_t k) {
      return std::llround((1 - v) *
                              ((1 - u) * static_cast<double>(i) + u * static_cast<double>(j)) +
                          v * static_cast<double>(k));
    };
    insert({mix(a.x, b.x, c.x), mix(a.y, b.y, c.y)});
  }
  void insertAnywhere(Random& random)
  {
    const auto size = static_cast<std::uint32_t>(high_ - low_);
    insert({low_ + random.below(size), low_ + random.below(size)});
  }
  /// A vertex right on a sample.
  void insertOnSample(Random& random, int samples)
  {
    const auto offsets = samplePositions(samples);
    const SampleOffset o = offsets[random.below(static_cast<std::uint32_t>(offsets.size()))];
    const std::int64_t x = random.below(kSide), y = random.below(kSide);
    insert({x * kSubpixels + o.x, y * kSubpixels + o.y});
  }
  /// Corners in pixels; every third triangle turned around.
  OwnedMesh mesh() const
  {
    OwnedMesh mesh;
    for (const Point& p : points_)
      mesh.positions.push_back(
          {static_cast<float>(p.x) / kSubpixels, static_cast<float>(p.y) / kSubpixels, 0});
    mesh.triangles = triangles_;
    for (std::size_t t = 0; t < triangles_.size(); t += 3)
      std::swap(mesh.triangles[t].vertex[0], mesh.triangles[t].vertex[1]);
    return mesh;
  }

 private:
  std::uint32_t addPoint(Point p)
  {
    points_.push_back(p);
    return static_cast<std::uint32_t>(points_.size() - 1);
  }

  std::int64_t low_, high_;
  std::vector<Point> points_;
  std::vector<Triangle> triangles_;
};

/// Left and top borders belong to the square: low <= x < high, low < y <= high.
void expectSquareCoveredOnce(const CoverCounts& counts, int samples, std::int64_t low,
                             std::int64_t high)
{
  const auto offsets = samplePositions(samples);
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x)
      for (int s = 0; s < samples; ++s) {
        const SampleOffset o = offsets[static_cast<std::size_t>(s)];
        const std::int64_t sx = x * kSubpixels + o.x, sy = y * kSubpixels + o.y;
        const bool inside = low <= sx && sx < high && low < sy && sy <= high;
        ASSERT_EQ(counts.of(x, y, s), inside ? 1 : 0)
            << "sample " << s << " of pixel " << x << ", " << y << ", " << samples << " samples";
      }
}

TEST_P(FillRule, EachSampleOfARandomlyTriangulatedSquareIsCoveredExactlyOnce)
{
  for (const int samples : {1, 2, 4, 8})
    for (const std::int64_t shift : {0, kSubpixels / 2}) {
      Random random(static_cast<std::uint32_t>(samples + shift));
      const std::int64_t low = 7 * kSubpixels + shift, high = 55 * kSubpixels + shift;
      Triangulation square(low, high);
      for (int i = 0; i < 12; ++i) {
        square.insertAnywhere(random);
        square.insertOnSample(random, samples);
        square.insertNearEdge(random);
      }
      CoverCounts counts(pixelStage(kSide, samples), GetParam());
      counts.add(square.mesh());
      expectSquareCoveredOnce(counts, samples, low, high);
    }
}

TEST_P(FillRule, EdgesRightThroughTheSamplesGoToOneSide)
{
  // Cells of 1.5 pixels: every second edge runs through pixel centres, and all diagonals do.
  for (const int samples : {1, 2, 4, 8}) {
    const OwnedMesh mesh = sheet({4, 4, 0}, {15, 0, 0}, {0, 15, 0}, 10);
    CoverCounts counts(pixelStage(kSide, samples), GetParam());
    counts.add(mesh);
    expectSquareCoveredOnce(counts, samples, 4 * kSubpixels, 19 * kSubpixels);
  }
}

TEST_P(FillRule, ATriangleWithoutAreaCoversNothing)
{
  const OwnedMesh mesh = soup({{3.5, 3.5, 0},
                               {20.5, 20.5, 0},
                               {40.5, 40.5, 0},  // on a line
                               {5.5, 9.5, 0},
                               {30.5, 9.5, 0},
                               {5.5, 9.5, 0},  // back and forth
                               {8.5, 8.5, 0},
                               {8.5, 8.5, 0},
                               {8.5, 8.5, 0}});  // a point
  for (const int samples : {1, 8}) {
    Stage stage = pixelStage(kSide, samples);
    stage.instances = {painted(mesh, {1, 1, 1})};
    for (const std::uint8_t coverage : draw(stage).coverage)
      ASSERT_EQ(coverage, 0);
  }
}

/// A fan of triangles about (0.1, 0.05) in the plane z = 0 if standing, else y = 0.
OwnedMesh fan(int corners, double radius, bool standing)
{
  OwnedMesh mesh;
  const auto addPoint = [&](double u, double v) {
    mesh.positions.push_back(vec3Cast<float>(standing ? Vec3d{u, v, 0} : Vec3d{u, 0, v}));
  };
  addPoint(0.1, 0.05);
  for (int i = 0; i < corners; ++i) {
    const double angle = 6.283185307179586 * (i + 0.37) / corners;
    addPoint(radius * std::cos(angle), radius * std::sin(angle));
  }
  const auto count = static_cast<std::uint32_t>(corners);
  for (std::uint32_t i = 0; i < count; ++i)
    mesh.triangles.push_back({{0, 1 + i, 1 + (i + 1) % count}});
  return mesh;
}

TEST_P(FillRule, TrianglesCutAtTheNearPlaneLeaveNoCrackAndNoDoubleCover)
{
  for (const int samples : {1, 8}) {
    Stage stage = pixelStage(kSide, samples);
    // A floor under the eye, seen down to the near plane, which cuts every triangle of the fan.
    stage.view = perspectiveView({0, 0.4, 0.3}, {0.02, 0.3, -0.1}, 70, {0.5, 50});
    CoverCounts counts(stage, GetParam());
    counts.add(fan(23, 30, false));
    const Axes axes = axesOf(stage.view);
    int once = 0;
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x)
        for (int s = 0; s < samples; ++s) {
          ASSERT_LE(counts.of(x, y, s), 1) << x << ", " << y;
          const SampleOffset o = samplePositions(samples)[static_cast<std::size_t>(s)];
          const Ray ray = stage.ray(x + o.x / 256.0, y + o.y / 256.0);
          if (ray.direction.y >= 0) continue;
          const Vec3d p = ray.origin - ray.direction * (ray.origin.y / ray.direction.y);
          const double distance = -dot(axes.back, p - stage.view.eye);
          if (distance < 0.51 || p.x * p.x + p.z * p.z > 29 * 29) continue;
          ASSERT_EQ(counts.of(x, y, s), 1) << x << ", " << y;
          ++once;
        }
    EXPECT_GT(once, 1500 * samples);
  }
}

TEST_P(FillRule, TrianglesFarBeyondTheGuardBandLeaveNoCrack)
{
  for (const double radius : {3e4, 1e6, 1e9}) {
    Stage stage = pixelStage(kSide, 4);
    stage.view = perspectiveView({0, 0, 1}, {0, 0, 0}, 50, {0.5, 50});
    CoverCounts counts(stage, GetParam());
    counts.add(fan(17, radius, true));
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x)
        for (int s = 0; s < 4; ++s)
          ASSERT_EQ(counts.of(x, y, s), 1) << "radius " << radius << " pixel " << x << ", " << y;
  }
}

}  // namespace
}  // namespace limn::testing
