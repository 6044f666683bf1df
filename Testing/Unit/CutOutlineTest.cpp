// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Lines from the finished picture where actors cut each other.
#include "Testing/Unit/OutlinedScene.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace limn::testing {
namespace {

class CutOutlines : public BothBackends {};
LIMN_ON_BOTH_BACKENDS(CutOutlines);

/// Two spheres that cut each other, seen in parallel along z, `kScale` pixels a unit.
struct CutSpheres {
  static constexpr int kSide = 192;
  static constexpr double kScale = 76, kRadius = 0.8;
  Vec3d centre[2] = {{-0.5, 0.05, 0}, {0.5, 0, 0.25}};

  Instance at(int i, float width) const
  {
    Instance instance = outlined(fineSphere(), width, static_cast<std::uint32_t>(i) + 1);
    instance.style.normals = NormalSource::kVertex;
    const double place[] = {centre[i].x, centre[i].y, centre[i].z};
    for (int row = 0; row < 3; ++row) {
      instance.modelToWorld.m[row][row] = kRadius;
      instance.modelToWorld.m[row][3] = place[row];
    }
    return instance;
  }
  /// Where a pixel is seen from a sphere's middle, in pixels.
  Vec3d from(int i, double x, double y) const
  {
    const Vec3d c = centre[i];
    return {x - kSide / 2.0 - c.x * kScale, y - kSide / 2.0 - c.y * kScale, 0};
  }
  /// Which sphere is before the other in a pixel of both.
  int shownAt(double x, double y) const
  {
    double depth[2];
    for (const int i : {0, 1}) {
      const Vec3d at = from(i, x, y);
      const double r = kRadius * kScale;
      const double squared = r * r - at.x * at.x - at.y * at.y;
      depth[i] = squared > 0 ? centre[i].z * kScale + std::sqrt(squared) : -1000;
    }
    return depth[0] > depth[1] ? 0 : 1;
  }
  /// What of the line's width is on the side of the one shown, at a place of the cut: half of it,
  /// and what the distances from the spheres' outlines add, by the slope of 1 - (r / R)^2 towards
  /// the middle.
  double partAt(int shown, Vec3d place) const
  {
    double near[2];
    for (const int i : {0, 1}) {
      const Vec3d at = from(i, place.x, place.y);
      const double r = kRadius * kScale;
      const double dx = std::max(8 * std::fabs(at.x) - 16, 0.0) / 4,
                   dy = std::max(8 * std::fabs(at.y) - 16, 0.0) / 4;
      near[i] = std::hypot(dx, dy) / (r * r - at.x * at.x - at.y * at.y);
    }
    return 0.5 + std::clamp(1.5 * (near[shown] - near[1 - shown]), -0.5, 0.5);
  }
  Stage stage(int samples) const
  {
    Stage stage;
    stage.width = stage.height = kSide;
    stage.resolve = Resolve::kLinear;
    stage.samples = samples;
    stage.view = parallelView({0, 0, 6}, {0, 0, 0}, kSide / kScale / 2, {1, 12});
    return stage;
  }
};

/// A part of the circle along which they cut, as it is seen: that where both look at the eye.
class Cut {
 public:
  explicit Cut(const CutSpheres& spheres)
  {
    const Vec3d way = spheres.centre[1] - spheres.centre[0];
    const double half = std::sqrt(dot(way, way)) / 2;
    const double radius = std::sqrt(spheres.kRadius * spheres.kRadius - half * half);
    const Vec3d axis = way * (0.5 / half), middle = (spheres.centre[0] + spheres.centre[1]) * 0.5;
    Vec3d u = Vec3d{0, 0, 1} - axis * axis.z;
    u = u * (1 / std::sqrt(dot(u, u)));
    const Vec3d v = {axis.y * u.z - axis.z * u.y, axis.z * u.x - axis.x * u.z,
                     axis.x * u.y - axis.y * u.x};
    constexpr int kSteps = 600;
    for (int i = 0; i <= kSteps; ++i) {
      const double angle = (i - kSteps / 2) * (kPi / kSteps);
      const Vec3d at = middle + (u * std::cos(angle) + v * std::sin(angle)) * radius;
      const auto faces = [&](Vec3d centre) { return (at - centre).z / spheres.kRadius; };
      if (faces(spheres.centre[0]) < 0.4 || faces(spheres.centre[1]) < 0.4) continue;
      points_.push_back({at.x * spheres.kScale + spheres.kSide / 2.0,
                         at.y * spheres.kScale + spheres.kSide / 2.0, 0});
    }
  }
  double length() const
  {
    double sum = 0;
    for (std::size_t i = 1; i < points_.size(); ++i)
      sum += std::hypot(points_[i].x - points_[i - 1].x, points_[i].y - points_[i - 1].y);
    return sum;
  }
  struct Place {
    double distance;  ///< > 0 to the right of the way along it
    bool isBeside;    ///< and not beyond its ends
    Vec3d nearest;    ///< on it
  };
  Place placeOf(double x, double y) const
  {
    const auto squared = [&](Vec3d p) { return (p.x - x) * (p.x - x) + (p.y - y) * (p.y - y); };
    const auto nearest = std::min_element(
        points_.begin(), points_.end(), [&](Vec3d a, Vec3d b) { return squared(a) < squared(b); });
    const bool isBeside = nearest != points_.begin() && nearest + 1 != points_.end();
    const Vec3d along = *std::min(nearest + 1, points_.end() - 1) -
                        *(nearest == points_.begin() ? nearest : nearest - 1);
    const double side = along.y * (x - nearest->x) - along.x * (y - nearest->y);
    const double distance = std::sqrt(squared(*nearest));
    return {side > 0 ? distance : -distance, isBeside, *nearest};
  }

 private:
  std::vector<Vec3d> points_;
};

TEST_P(CutOutlines, RunAlongTheCutOfTwoSpheres)
{
  const CutSpheres spheres;
  const Cut cut(spheres);
  ASSERT_GT(cut.length(), 30);
  const bool isFast = GetParam() == Backend::kPipeline;
  for (const int samples : isFast ? std::vector<int>{1, 4, 8} : std::vector<int>{4})
    for (const float width : isFast ? std::vector<float>{2, 5, 9} : std::vector<float>{5}) {
      Stage stage = spheres.stage(samples);
      stage.instances = {spheres.at(0, width), spheres.at(1, width)};
      const Picture picture = drawOverWhite(stage, GetParam());
      double sum = 0;
      for (int y = 0; y < stage.height; ++y)
        for (int x = 0; x < stage.width; ++x) {
          const Cut::Place place = cut.placeOf(x + 0.5, y + 0.5);
          if (!(std::fabs(place.distance) < width + 4)) continue;
          constexpr int kFine = 4;  // of pixels that are partly beyond the ends
          for (int i = 0; i < kFine * kFine; ++i) {
            const double fineX = x + (i % kFine + 0.5) / kFine,
                         fineY = y + (i / kFine + 0.5) / kFine;
            if (cut.placeOf(fineX, fineY).isBeside)
              sum += darknessOf(at(picture, x, y)) / (kFine * kFine);
          }
          const double off =
              std::fabs(place.distance) -
              width * spheres.partAt(spheres.shownAt(x + 0.5, y + 0.5), place.nearest);
          const double error = 0.8 + 0.06 * width;
          if (!place.isBeside) continue;
          if (off < -error) {
            ASSERT_LE(at(picture, x, y).g, 8) << x << ", " << y << " of " << samples;
          } else if (off > error) {
            ASSERT_EQ(at(picture, x, y).g, 255) << x << ", " << y << " of " << samples;
          }
        }
      EXPECT_NEAR(sum / (cut.length() * width), 1, 0.02)
          << "width " << width << ", " << samples << " samples";
    }
}

TEST_P(CutOutlines, LieOnTheSideOfTheOneThatHasLines)
{
  const CutSpheres spheres;
  const Cut cut(spheres);
  const float width = 4;
  for (const int samples : {1, 4})
    for (const int lined : {0, 1}) {
      Stage stage = spheres.stage(samples);
      stage.instances = {spheres.at(0, width), spheres.at(1, width)};
      stage.instances[static_cast<std::size_t>(1 - lined)].style.imageOutline = {};
      const Picture picture = drawOverWhite(stage, GetParam());
      double sum[2] = {0, 0};
      for (int y = 0; y < stage.height; ++y)
        for (int x = 0; x < stage.width; ++x) {
          const Cut::Place place = cut.placeOf(x + 0.5, y + 0.5);
          if (!place.isBeside || std::fabs(place.distance) > width + 3) continue;
          sum[place.distance > 0] += darknessOf(at(picture, x, y));
        }
      const double inside = std::max(sum[0], sum[1]), outside = std::min(sum[0], sum[1]);
      // The one side of a bent line is longer than the other.
      EXPECT_NEAR((inside + outside) / (cut.length() * width), 1, 0.06)
          << lined << " of " << samples;
      EXPECT_LT(outside, 0.3 * cut.length()) << lined << " of " << samples;
    }
}

// As DrawALineWhereASteepWallStandsOnAFloor, of two actors.
TEST_P(CutOutlines, RunWhereASteepWallStandsOnAFloor)
{
  for (const int samples : {1, 8})
    for (const double rise : {1.0, 4.0, 10.0})
      for (const double degrees : {0.0, 9.0, 40.0}) {
        const double c = std::cos(degrees * kPi / 180), s = std::sin(degrees * kPi / 180);
        const Vec3d middle = {32.37, 31.81, 10}, along = {80 * c, 80 * s, 0};
        const Vec3d up = {-8 * s, 8 * c, 8 * rise};
        // The floor goes on below the wall, and the wall below the floor.
        const OwnedMesh wall = sheet(middle - along - up, along * 2.0, up * 2.0),
                        floor = sheet({-40, -40, 10}, {150, 0, 0}, {0, 150, 0});
        Stage stage = flatStage(64, samples);
        stage.view.eye.z = 120;
        stage.view.near = 1;
        stage.view.far = 200;
        stage.instances = {outlined(wall, 3, 1), outlined(floor, 3, 2)};
        const Picture picture = drawOverWhite(stage, GetParam());
        SCOPED_TRACE(::testing::Message() << samples << " samples, rise " << rise);
        expectEvenLine(picture, middle, degrees);
      }
}

/// Adds the part of the plane z = a x + b y over a rectangle.
void addSlope(double a, double b, Vec3d low, Vec3d high, std::vector<Vec3d>& points)
{
  for (const Vec3d p : {low, Vec3d{high.x, low.y, 0}, high, low, high, Vec3d{low.x, high.y, 0}})
    points.push_back({p.x, p.y, a * p.x + b * p.y});
}

/// A wall cuts a roof, of which it leaves an acute piece of one side between it and the ridge.
TEST_P(CutOutlines, StayInTheMiddleWhereASharpEdgeIsNear)
{
  constexpr int kSide = 96;
  for (const int samples : {1, 4})
    for (const float width : {3.0f, 6.0f})
      for (const double degrees : {12.0, 20.0}) {
        // The ridge is the x axis, and the wall cuts its sides along two rays from the origin.
        const double tangent = std::tan(degrees * kPi / 180);
        std::vector<Vec3d> sides, plane;
        addSlope(0, -2, {-100, 0, 0}, {100, 100, 0}, sides);
        addSlope(0, 0.3, {-100, -100, 0}, {100, 0, 0}, sides);
        addSlope(-3 * tangent, 1, {-100, -100, 0}, {100, 100, 0}, plane);
        const OwnedMesh roof = soup(sides), wall = soup(plane);
        const double slopeOfSide = 3 * tangent / 0.7;
        Stage stage = flatStage(kSide, samples);
        stage.view = parallelView({0.3, 0.2, 300}, {0.3, 0.2, 0}, kSide / 2.0, {1, 700});
        stage.instances = {outlined(roof, width, 1), outlined(wall, width, 2)};
        for (Instance& instance : stage.instances)
          instance.style.imageOutline.creaseDegrees = 180;
        const Picture picture = drawOverWhite(stage, GetParam());
        for (int y = 10; y < kSide - 10; ++y)
          for (int x = 10; x < kSide - 10; ++x) {
            const Vec3d p = {x + 0.5 - kSide / 2.0 + 0.3, y + 0.5 - kSide / 2.0 + 0.2, 0};
            const auto toRay = [&](double toX, double toY) {
              const double length = std::hypot(toX, toY);
              const double along = std::max((p.x * toX + p.y * toY) / length, 0.0);
              return std::hypot(p.x - along * toX / length, p.y - along * toY / length);
            };
            const double distance = std::min(toRay(1, tangent), toRay(-1, -slopeOfSide));
            if (distance < width / 2 - 1) {
              EXPECT_LE(at(picture, x, y).g, 20)
                  << x << ", " << y << " of " << samples << " at " << degrees;
            } else if (distance > width / 2 + 1 && std::hypot(p.x, p.y) > width + 4) {
              EXPECT_EQ(at(picture, x, y).g, 255)
                  << x << ", " << y << " of " << samples << " at " << degrees;
            }
          }
      }
}

/// A ball about the corner of three square sheets that cut each other, turned about the vertical
/// and tilted towards the eye, which looks along -z. In pixels.
struct BallInCorner {
  static constexpr double kHalf = 60, kRadius = 32, kAside = 8;
  Vec3d axes[3];  ///< normals of the sheets, which also lie along the others' sides

  BallInCorner(double turn, double tilt)
  {
    const double c = std::cos(turn), s = std::sin(turn), u = std::cos(tilt), v = std::sin(tilt);
    axes[0] = {c, s * v, -s * u};
    axes[1] = {0, u, v};
    axes[2] = {s, -c * v, c * u};
  }
  Vec3d middle() const { return (axes[0] + axes[1] + axes[2]) * kAside; }
  OwnedMesh sheetAcross(int k) const
  {
    const Vec3d a = axes[(k + 1) % 3] * kHalf, b = axes[(k + 2) % 3] * kHalf;
    return sheet(a * -1.0 - b, a * 2.0, b * 2.0);
  }
  /// The sheet that is shown, 3 for the ball or 4 for nothing.
  int shownAt(double x, double y) const
  {
    int shown = 4;
    double highest = -1000;
    const auto see = [&](int i, double z) {
      if (z <= highest) return;
      highest = z;
      shown = i;
    };
    for (int k = 0; k < 3; ++k) {
      const Vec3d n = axes[k], p = {x, y, -(n.x * x + n.y * y) / n.z};
      if (std::fabs(dot(axes[(k + 1) % 3], p)) < kHalf &&
          std::fabs(dot(axes[(k + 2) % 3], p)) < kHalf)
        see(k, p.z);
    }
    const Vec3d m = middle();
    const double squared = kRadius * kRadius - (x - m.x) * (x - m.x) - (y - m.y) * (y - m.y);
    if (squared > 0) see(3, m.z + std::sqrt(squared));
    return shown;
  }
};

/// Where three surfaces meet each has two borders, and the last piece of one may look like one of
/// the other's, which is hidden there: taken for that it was moved aside by up to three pixels.
TEST_P(CutOutlines, LeaveNoDashesWhereThreeSurfacesMeet)
{
  constexpr int kSide = 128, kFine = 4;
  constexpr double kShift = 0.3;
  const float width = 2;
  for (const int degrees : {5, 16, 19, 24, 33, 41, 46, 71}) {
    const BallInCorner scene(degrees * kPi / 180, 25 * kPi / 180);
    const OwnedMesh sheets[] = {scene.sheetAcross(0), scene.sheetAcross(1), scene.sheetAcross(2)};
    Stage stage = flatStage(kSide, 4);
    stage.view = parallelView({kShift, kShift, 300}, {kShift, kShift, 0}, kSide / 2.0, {1, 700});
    for (int k = 0; k < 3; ++k)
      stage.instances.push_back(outlined(sheets[k], width, static_cast<std::uint32_t>(k) + 1));
    Instance ball = outlined(fineSphere(), width, 4);
    const Vec3d middle = scene.middle();
    const double place[] = {middle.x, middle.y, middle.z};
    for (int row = 0; row < 3; ++row) {
      ball.modelToWorld.m[row][row] = scene.kRadius;
      ball.modelToWorld.m[row][3] = place[row];
    }
    ball.style.normals = NormalSource::kVertex;
    stage.instances.push_back(ball);
    const Picture picture = drawOverWhite(stage, GetParam());

    std::vector<int> shown;
    for (int y = 0; y < kSide * kFine; ++y)
      for (int x = 0; x < kSide * kFine; ++x)
        shown.push_back(scene.shownAt((x + 0.5) / kFine - kSide / 2.0 + kShift,
                                      (y + 0.5) / kFine - kSide / 2.0 + kShift));
    const auto isOneAround = [&](int x, int y, double far) {
      const double mx = (x + 0.5) * kFine, my = (y + 0.5) * kFine;
      const int reach = static_cast<int>(far * kFine) + 1, cx = static_cast<int>(mx),
                cy = static_cast<int>(my);
      for (int j = cy - reach; j <= cy + reach; ++j)
        for (int i = cx - reach; i <= cx + reach; ++i)
          if (std::hypot(i + 0.5 - mx, j + 0.5 - my) <= far * kFine &&
              shown[static_cast<std::size_t>(j * kSide * kFine + i)] !=
                  shown[static_cast<std::size_t>(cy * kSide * kFine + cx)])
            return false;
      return true;
    };
    for (int y = 8; y < kSide - 8; ++y)
      for (int x = 8; x < kSide - 8; ++x)
        if (isOneAround(x, y, width + 0.75)) {
          EXPECT_EQ(at(picture, x, y).g, 255) << x << ", " << y << " at " << degrees;
        }
  }
}

/// A rectangle whose vertices have a normal of their own.
OwnedMesh rectangle(Vec3d corner, Vec3d a, Vec3d b, Vec3f normal)
{
  OwnedMesh mesh;
  for (const Vec3d p : {corner, corner + a, corner + a + b, corner + b}) {
    mesh.positions.push_back(vec3Cast<float>(p));
    mesh.vertexNormals.push_back(normal);
  }
  mesh.triangles = {{{0, 1, 2}}, {{0, 2, 3}}};
  finish(mesh);
  return mesh;
}

TEST(CutOutline, IsTheSameInBothBackendsWhereNormalsArePerpendicularToTheGaze)
{
  // As those of leaves: nobody can tell by them how far an outline is.
  for (const double degrees : {9.0, 40.0}) {
    const double c = std::cos(degrees * kPi / 180), s = std::sin(degrees * kPi / 180);
    const Vec3d middle = {32.37, 31.81, 10}, along = {80 * c, 80 * s, 0},
                up = {-64 * s, 64 * c, 64};
    const OwnedMesh wall = rectangle(middle - along - up, along * 2.0, up * 2.0,
                                     vec3Cast<float>(normalized(Vec3d{s, -c, 1})));
    const OwnedMesh leaf = rectangle({-40, -40, 10}, {150, 0, 0}, {0, 150, 0}, {0, 1, 0});
    Stage stage = flatStage(64, 1);
    stage.view.eye.z = 120;
    stage.view.near = 1;
    stage.view.far = 200;
    stage.instances = {outlined(wall, 6, 1), outlined(leaf, 6, 2)};
    for (Instance& instance : stage.instances)
      instance.style.normals = NormalSource::kVertex;
    const Picture picture = drawOverWhite(stage, Backend::kPipeline);
    EXPECT_EQ(drawOverWhite(stage, Backend::kReference).differingPixels(picture), 0u) << degrees;
    double ink = 0;
    for (int y = 12; y < 52; ++y)
      for (int x = 12; x < 52; ++x)
        ink += darknessOf(at(picture, x, y));
    // It lies on one side, and where it ends short of the wall some of it is missing.
    EXPECT_NEAR(ink, 6 * 40 / c, 0.06 * 240 / c) << degrees;
  }
}

/// A groove that ends two pixels before a tile does, where an earlier frame showed a surface of the
/// same number that lay otherwise.
TEST_P(CutOutlines, DoNotDependOnAnEarlierFrame)
{
  const OwnedMesh wide = sheet({0, 0, 0}, {128, 0, 0}, {0, 128, 0});
  const OwnedMesh rising = sheet({20, 20, 0}, {41.5, 0, 41.5}, {0, 40, 0});
  const OwnedMesh falling = sheet({20, 20, 80}, {41.5, 0, -41.5}, {0, 40, 0});
  Stage stage = flatStage(128, 1);
  stage.view = parallelView({64, 64, 200}, {64, 64, 0}, 64, {1, 400});
  Stage before = stage;
  before.instances = {outlined(wide, 4, 1)};
  stage.instances = {outlined(rising, 4, 1), outlined(falling, 4, 2)};
  const Picture expected = drawOverWhite(stage, Backend::kReference);
  drawOverWhite(before, GetParam());
  const Picture picture = drawOverWhite(stage, GetParam());
  EXPECT_EQ(picture.differingPixels(expected), 0u);
}

}  // namespace
}  // namespace limn::testing
