// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/Generator/GeneratedMeshes.h"
#include "Rendering/Base/SamplePositions.h"
#include "Rendering/Mesh/HullEdges.h"
#include "Testing/Unit/TestScene.h"

#include <algorithm>
#include <cmath>

namespace limn::testing {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr Vec3f kSolid = {1, 0, 0}, kInk = {0, 1, 0};
/// Snapping moves a vertex by half of 1/256 pixel in x and in y.
constexpr double kSnapping = 0.01;

/// A mesh with its hull's edges.
struct Solid {
  OwnedMesh mesh;

  explicit Solid(OwnedMesh&& given) : mesh(std::move(given))
  {
    const Status status = buildHullEdges(mesh.view(), 2, mesh.hull);
    EXPECT_TRUE(status.ok()) << status.message;
  }
  Instance surface(const Mat4d& place = Mat4d::identity()) const
  {
    Instance instance = painted(mesh, kSolid, 3);
    instance.modelToWorld = place;
    return instance;
  }
  Instance hull(float width, const Mat4d& place = Mat4d::identity()) const
  {
    Instance instance = surface(place);
    instance.clusters = nullptr;
    instance.hull = &mesh.hull;
    instance.style.outlineWidth = width;
    instance.style.outlineColor = kInk;
    instance.id = 4;
    return instance;
  }
};

/// The box from -half to half, each face with its own vertices, cut into two triangles.
OwnedMesh box(Vec3d half)
{
  std::vector<Vec3d> points;
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) {
      const auto corner = [&](double u, double v) {
        double c[3];
        c[axis] = side;
        c[(axis + 1) % 3] = u * side;
        c[(axis + 2) % 3] = v;
        return Vec3d{c[0], c[1], c[2]} * half;
      };
      const Vec3d a = corner(-1, -1), b = corner(1, -1), c = corner(1, 1), d = corner(-1, 1);
      points.insert(points.end(), {a, b, c, a, c, d});
    }
  return soup(points);
}

/// About the z axis.
OwnedMesh torus(double major, double minor, std::uint32_t steps)
{
  OwnedMesh mesh;
  for (std::uint32_t i = 0; i < 2 * steps; ++i)
    for (std::uint32_t j = 0; j < steps; ++j) {
      const double u = kPi * i / steps, v = 2 * kPi * j / steps;
      const double r = major + minor * std::cos(v);
      mesh.positions.push_back(
          vec3Cast<float>(Vec3d{r * std::cos(u), r * std::sin(u), minor * std::sin(v)}));
      mesh.vertexNormals.push_back({0, 0, 1});
      const std::uint32_t nextI = (i + 1) % (2 * steps), nextJ = (j + 1) % steps;
      const std::uint32_t a = i * steps + j, b = nextI * steps + j, c = nextI * steps + nextJ,
                          d = i * steps + nextJ;
      mesh.triangles.push_back({{a, b, c}});
      mesh.triangles.push_back({{a, c, d}});
    }
  finish(mesh);
  return mesh;
}

Mat4d turned(double aboutX, double aboutY)
{
  const double cx = std::cos(aboutX), sx = std::sin(aboutX), cy = std::cos(aboutY),
               sy = std::sin(aboutY);
  const Mat4d x = {{{1, 0, 0, 0}, {0, cx, -sx, 0}, {0, sx, cx, 0}, {0, 0, 0, 1}}};
  const Mat4d y = {{{cy, 0, sy, 0}, {0, 1, 0, 0}, {-sy, 0, cy, 0}, {0, 0, 0, 1}}};
  return y * x;
}

Mat4d scaled(Vec3d s)
{
  return {{{s.x, 0, 0, 0}, {0, s.y, 0, 0}, {0, 0, s.z, 0}, {0, 0, 0, 1}}};
}

struct Point2 {
  double x, y;
};
double turn(Point2 a, Point2 b, Point2 c)
{
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The outline of a convex body: the convex hull of what its vertices become on the screen.
std::vector<Point2> outlineOf(const Stage& stage, const OwnedMesh& mesh, const Mat4d& place)
{
  std::vector<Point2> points;
  for (const Vec3f& p : mesh.positions) {
    const Vec3d seen = stage.project(transformPoint(place, vec3Cast<double>(p)));
    points.push_back({seen.x, seen.y});
  }
  std::sort(points.begin(), points.end(),
            [](Point2 a, Point2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  std::vector<Point2> hull;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t first = hull.size();
    for (const Point2 p : points) {
      while (hull.size() > first + 1 && turn(hull[hull.size() - 2], hull.back(), p) <= 1e-9)
        hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

/// Largest distance of p beyond the lines of the polygon's sides; negative inside.
double beyond(const std::vector<Point2>& polygon, Point2 p)
{
  double most = -1e9;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    most = std::max(most, -turn(a, b, p) / std::hypot(b.x - a.x, b.y - a.y));
  }
  return most;
}

/// Each pixel's centre is solid inside the outline, ink up to `width` beyond the lines of its
/// sides, so that corners are mitred and closed, and nothing farther out.
void expectOutline(const Stage& stage, const Picture& picture, const std::vector<Point2>& outline,
                   double width)
{
  std::size_t inked = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const double d = beyond(outline, {x + 0.5, y + 0.5});
      if (std::fabs(d) < kSnapping || std::fabs(d - width) < kSnapping) continue;
      const Rgba8 c = at(picture, x, y);
      const bool isInk = d > 0 && d < width;
      inked += isInk;
      ASSERT_EQ(c.r, d < 0 ? 255 : 0) << x << ' ' << y << " at " << d << " green " << int{c.g};
      ASSERT_EQ(c.g, isInk ? 255 : 0) << x << ' ' << y << " at " << d;
    }
  EXPECT_GT(inked, 60u);
  EXPECT_EQ(stage.samples, 1);
}

class Hull : public BothBackends {};
LIMN_ON_BOTH_BACKENDS(Hull);

TEST_P(Hull, OfACubeIsEquallyWideAndClosedAtEveryTurn)
{
  const Solid cube(box({1, 1, 1}));
  for (int frame = 0; frame < 360; ++frame) {
    Stage stage;
    stage.width = frame % 2 == 0 ? 96 : 128;
    stage.height = 72;
    stage.view = frame % 3 == 0 ? parallelView({0, 0, 5}, {0, 0, 0}, 2.4)
                                : perspectiveView({0.8, -0.5, 5}, {0, 0, 0}, 50);
    const Mat4d place = turned(frame * kPi / 45, frame * kPi / 180);
    stage.instances = {cube.surface(place), cube.hull(4, place)};
    expectOutline(stage, draw(stage), outlineOf(stage, cube.mesh, place), 4);
    if (HasFatalFailure()) FAIL() << "frame " << frame;
  }
}

OwnedMesh generated(const GeneratedMesh& mesh)
{
  OwnedMesh owned;
  owned.positions = mesh.positions;
  owned.triangles = mesh.triangles();
  owned.vertexNormals.assign(owned.positions.size(), {0, 0, 1});
  finish(owned);
  return owned;
}

/// Pixels of the background nearer than `distance` to one of the solid.
std::size_t gaps(const Picture& picture, int distance)
{
  std::size_t count = 0;
  const auto instance = [&](int x, int y) {
    return picture.instance[static_cast<std::size_t>(y * picture.width + x)];
  };
  for (int y = distance; y < picture.height - distance; ++y)
    for (int x = distance; x < picture.width - distance; ++x) {
      if (instance(x, y) != 3) continue;
      for (int dy = -distance; dy <= distance; ++dy)
        for (int dx = -distance; dx <= distance; ++dx)
          if (std::hypot(dx, dy) < distance && instance(x + dx, y + dy) == kNobody) ++count;
    }
  return count;
}

TEST_P(Hull, HasNoGapInAnyFrameOfATurn)
{
  const Solid solids[] = {Solid(generated(teapot(4))), Solid(generated(knot(60, 10, 0.5))),
                          Solid(generated(gear(12, 0.6))), Solid(sphere(5, 7))};
  const double sizes[] = {3.2, 4, 1.6, 1.3};
  const int step = GetParam() == Backend::kReference ? 9 : 1;  // which takes its time
  for (int i = 0; i < 4; ++i)
    for (int frame = 0; frame < 360; frame += step) {
      Stage stage;
      stage.width = 96;
      stage.height = 72;
      stage.view =
          perspectiveView({0, 0, 4 * sizes[i]}, {0, 0, 0}, 32, {2 * sizes[i], 6 * sizes[i]});
      const Mat4d place = turned(0.4, frame * kPi / 180);
      stage.instances = {solids[i].surface(place), solids[i].hull(4, place)};
      const Picture picture = draw(stage);
      ASSERT_EQ(gaps(picture, 3), 0u) << "solid " << i << " frame " << frame;
    }
}

// A hull that is moved by the same number in clip x and y is 1.78 times as wide at the sides of a
// 16:9 picture, and one whose normal keeps its z is the narrower the more that is.
TEST_P(Hull, HasTheSameWidthAtAnyDistanceAndAspect)
{
  const Solid ball(sphere(9, 14));
  for (const double distance : {2.0, 3.0, 20.0, 200.0})
    for (const int width : {96, 128}) {
      Stage stage;
      stage.width = width;
      stage.height = 72;
      const double half = std::asin(1 / distance) * 180 / kPi;
      stage.view =
          perspectiveView({0, 0, distance}, {0, 0, 0}, 2.8 * half, {distance / 3, distance * 2});
      const Mat4d place = turned(0.3 * distance, 0.1);
      stage.instances = {ball.hull(3, place), ball.surface(place)};
      expectOutline(stage, draw(stage), outlineOf(stage, ball.mesh, place), 3);
      if (HasFatalFailure()) FAIL() << "distance " << distance;
    }
}

TEST_P(Hull, HasTheSameWidthFarFromTheMiddleOfAWideView)
{
  const Solid ball(sphere(9, 14));
  Stage stage;
  stage.width = 192;
  stage.height = 108;
  stage.view = perspectiveView({0, 0, 3}, {0, 0, 0}, 100);
  const Mat4d place = translation({3.6, 1.2, 0}) * turned(0.5, 0.2);
  stage.instances = {ball.surface(place), ball.hull(4, place)};
  expectOutline(stage, draw(stage), outlineOf(stage, ball.mesh, place), 4);
}

TEST_P(Hull, HasTheSameWidthWhateverTheActorsMatrix)
{
  const Solid cube(box({1, 1, 1})), ball(sphere(9, 14));
  for (const Vec3d scale : {Vec3d{0.3, 1.6, 0.8}, Vec3d{-1, 1, 1}, Vec3d{-1.5, -0.4, -1}})
    for (const Solid* solid : {&cube, &ball})
      for (int frame = 0; frame < 12; ++frame) {
        Stage stage;
        stage.view = perspectiveView({0.5, 0.3, 6}, {0, 0, 0}, 50);
        const Mat4d place = turned(frame * 0.5, frame * 0.3) * scaled(scale) * turned(0.4, 0.7);
        stage.instances = {solid->surface(place), solid->hull(3, place)};
        stage.instances[0].cullBackFaces = true;
        expectOutline(stage, draw(stage), outlineOf(stage, solid->mesh, place), 3);
        if (HasFatalFailure()) FAIL() << "frame " << frame << " scale " << scale.x;
      }
}

TEST_P(Hull, OfAFineSphereIsARingOfTheKnownArea)
{
  static const Solid ball(sphere(96, 192));
  for (const bool parallel : {false, true}) {
    Stage stage;
    stage.width = 320;
    stage.height = 240;
    stage.samples = 8;
    stage.view = parallel ? parallelView({0, 0, 3}, {0, 0, 0}, 1.2)
                          : perspectiveView({0, 0, 3}, {0, 0, 0}, 50);
    const double r = parallel ? 240 / (2 * 1.2) : 120 / std::tan(25 * kPi / 180) / std::sqrt(8.0);
    const double w = 3.5;
    const auto areaOf = [&] {
      const Picture picture = draw(stage);
      double area = 0;
      for (const std::uint8_t bits : picture.coverage)
        area += bitCount(bits) / 8.0;
      return area;
    };
    stage.instances = {ball.surface()};
    const double disc = areaOf();
    stage.instances.push_back(ball.hull(static_cast<float>(w)));
    const double ring = areaOf() - disc;
    EXPECT_NEAR(ring, kPi * ((r + w) * (r + w) - r * r), 0.005 * ring) << parallel;
  }
}

/// Widths of the ring in sectors, by the area of its samples there.
TEST_P(Hull, HasOneWidthInAllDirections)
{
  static const Solid ball(sphere(96, 192));
  Stage stage;
  stage.width = 320;
  stage.height = 240;
  stage.samples = 8;
  stage.view = parallelView({0, 0, 3}, {0, 0, 0}, 1.2);
  const double r = 100;
  constexpr int kSectors = 40;
  stage.instances = {ball.hull(5)};
  const Picture picture = draw(stage);
  double area[kSectors] = {};
  const Span<const SampleOffset> offsets = samplePositions(8);
  for (int y = 0; y < stage.height; ++y)
    for (int x = 0; x < stage.width; ++x)
      for (std::size_t s = 0; s < offsets.size(); ++s) {
        const std::size_t pixel = static_cast<std::size_t>(y * stage.width + x);
        if ((picture.coverage[pixel] >> s & 1) == 0) continue;
        const double dx = x + offsets[s].x / 256.0 - 160, dy = y + offsets[s].y / 256.0 - 120;
        if (std::hypot(dx, dy) < r) continue;
        const double turns = std::atan2(dy, dx) / (2 * kPi) + 1;
        area[static_cast<int>(turns * kSectors) % kSectors] += 1.0 / 8;
      }
  double squares = 0;
  for (const double one : area) {
    const double width = std::sqrt(r * r + 2 * one / (2 * kPi / kSectors)) - r;
    squares += (width - 5) * (width - 5);
  }
  EXPECT_LT(std::sqrt(squares / kSectors), 0.1);
}

TEST_P(Hull, KeepsTheInnerContourOfATorus)
{
  // The tube's near side lies before its far side: its upper contour is in the picture's middle.
  static const Solid ring(torus(1, 0.45, 96));
  Stage stage;
  stage.width = 160;
  stage.height = 200;
  stage.view = parallelView({0, 0, 5}, {0, 0, 0}, 2);
  const double tilt = 70 * kPi / 180;
  const Mat4d place = turned(-tilt, 0);
  stage.instances = {ring.surface(place), ring.hull(4, place)};
  const Picture picture = draw(stage);
  const double scale = 50, near = 100 + scale * (-std::cos(tilt) + 0.45);
  ASSERT_LT(near + 4, 100 + scale * (std::cos(tilt) + 0.45)) << "the far side lies behind";
  for (int y = static_cast<int>(near) - 10; y < static_cast<int>(near) + 10; ++y) {
    const double d = y + 0.5 - near;
    if (std::fabs(d) < 0.1 || std::fabs(d - 4) < 0.1) continue;
    EXPECT_EQ(at(picture, 80, y).g, d > 0 && d < 4 ? 255 : 0) << y << " at " << d;
    EXPECT_EQ(at(picture, 80, y).r, d > 0 && d < 4 ? 0 : 255) << y << " at " << d;
  }
}

TEST_P(Hull, FillsTheRimOfATorusHoleFromInside)
{
  static const Solid ring(torus(1, 0.4, 64));
  Stage stage;
  stage.width = stage.height = 200;
  stage.view = parallelView({0, 0, 5}, {0, 0, 0}, 1.6);
  stage.instances = {ring.surface(), ring.hull(6)};
  const Picture picture = draw(stage);
  const double r = 0.6 * 62.5;
  for (int y = 60; y < 140; ++y)
    for (int x = 60; x < 140; ++x) {
      const double d = r - std::hypot(x + 0.5 - 100, y + 0.5 - 100);
      if (std::fabs(d) < 0.1 || std::fabs(d - 6) < 0.1) continue;
      EXPECT_EQ(at(picture, x, y).g, d > 0 && d < 6 ? 255 : 0) << x << ' ' << y << " at " << d;
    }
}

TEST_P(Hull, IsHiddenByWhatIsNearerAndHidesWhatIsFarther)
{
  const Solid cube(box({0.5, 0.5, 0.5}));
  const OwnedMesh wall = sheet({-2, -2, 0}, {4, 0, 0}, {0, 4, 0});
  Stage stage;
  stage.view = parallelView({0, 0, 5}, {0, 0, 0}, 1);
  for (const double z : {-1.0, 1.0}) {
    Instance plane = painted(wall, {0, 0, 1}, 9);
    plane.modelToWorld = translation({0, 0, z});
    stage.instances = {plane, cube.surface(), cube.hull(4)};
    const Picture picture = draw(stage);
    EXPECT_EQ(at(picture, 22, 48).b, z > 0 ? 255 : 0);
    EXPECT_EQ(at(picture, 22, 48).g, z > 0 ? 0 : 255);
    EXPECT_EQ(at(picture, 18, 48).b, 255);
  }
}

TEST_P(Hull, IsNotCutWhereTheSolidReachesTheFarPlane)
{
  // A needle that points away: at its tip both edges of its outline lead on deeper.
  const Vec3d tip = {0.9, 0, -0.9}, a = {-1, -0.8, 0.3}, b = {-1, 0.8, 0.3}, c = {-1, 0, 0.8};
  const Solid needle(soup({tip, a, b, tip, b, c, tip, c, a, a, c, b}));
  for (const bool parallel : {false, true})
    for (int frame = 0; frame < 10; ++frame) {
      const Mat4d place = turned(frame * 0.05, frame * 0.03);
      double farthest = 0;
      for (const Vec3f& p : needle.mesh.positions)
        farthest = std::max(farthest, 5 - transformPoint(place, vec3Cast<double>(p)).z);
      const ClipRange range = {3, farthest * 1.00001};
      Stage stage;
      stage.view = parallel ? parallelView({0, 0, 5}, {0, 0, 0}, 2.4, range)
                            : perspectiveView({0, 0, 5}, {0, 0, 0}, 50, range);
      stage.instances = {needle.surface(place), needle.hull(4, place)};
      const Picture picture = draw(stage);
      const std::vector<Point2> outline = outlineOf(stage, needle.mesh, place);
      for (int y = 0; y < stage.height; ++y)
        for (int x = 0; x < stage.width; ++x) {
          const double d = beyond(outline, {x + 0.5, y + 0.5});
          if (d < kSnapping || std::fabs(d - 4) < 2 * kSnapping) continue;
          ASSERT_EQ(at(picture, x, y).g, d < 4 ? 255 : 0) << x << ' ' << y << " at " << d;
        }
    }
}

double distance(Point2 p, Point2 a, Point2 b)
{
  const double x = b.x - a.x, y = b.y - a.y;
  const double t = ((p.x - a.x) * x + (p.y - a.y) * y) / (x * x + y * y);
  const double bounded = std::min(std::max(t, 0.0), 1.0);
  return std::hypot(a.x + bounded * x - p.x, a.y + bounded * y - p.y);
}

TEST_P(Hull, ShowsInAnOpenBoxAtItsRimAlone)
{
  OwnedMesh open = box({1, 1, 1});
  open.triangles.resize(10);  // without its front
  finish(open);
  const Solid solid(std::move(open));
  Stage stage;
  stage.samples = 4;
  stage.view = perspectiveView({0, 0, 5}, {0, 0, 0}, 50);
  std::size_t within = 0;
  for (int frame = 0; frame < 20; ++frame) {
    const Mat4d place = turned(frame * 0.05, frame * 0.04 - 0.5);
    stage.instances = {solid.surface(place)};
    const Picture without = draw(stage);
    stage.instances.push_back(solid.hull(4, place));
    const Picture with = draw(stage);
    std::vector<Point2> rim;
    for (const Vec3d p : {Vec3d{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}, {-1, -1, 1}}) {
      const Vec3d seen = stage.project(transformPoint(place, p));
      rim.push_back({seen.x, seen.y});
    }
    std::size_t inked = 0;
    for (std::size_t i = 0; i < with.color.size(); ++i) {
      inked += with.color[i].g > 0;
      if (without.coverage[i] != 15 || with.color[i].g == 0) continue;
      ++within;
      const Point2 centre = {static_cast<double>(i % 96) + 0.5, static_cast<double>(i / 96) + 0.5};
      double nearest = 1e9;
      for (int k = 0; k < 4; ++k)
        nearest = std::min(nearest, distance(centre, rim[k], rim[k + 1]));
      // Half a pixel's diagonal, and the miter of the corners.
      EXPECT_LT(nearest, 4 * 1.5 + 0.8) << "frame " << frame;
    }
    EXPECT_GT(inked, 100u) << frame;
  }
  EXPECT_GT(within, 200u) << "where a wall's front is seen its rim is before the others";
}

TEST_P(Hull, OfASheetIsAsWideAsOfASolid)
{
  const Solid square(sheet({-1, -0.7, 0}, {2, 0, 0}, {0, 1.4, 0}, 5));
  for (const bool parallel : {false, true})
    for (int frame = 0; frame < 12; ++frame) {
      // From its front and from its back.
      const Mat4d place = turned(0.3 * std::sin(frame), 0.15 * frame - 0.8 + (frame % 2) * kPi);
      Stage stage;
      stage.width = 128;
      stage.view = parallel ? parallelView({0, 0, 5}, {0, 0, 0}, 1.7)
                            : perspectiveView({0, 0, 5}, {0, 0, 0}, 40);
      stage.instances = {square.surface(place), square.hull(5, place)};
      expectOutline(stage, draw(stage), outlineOf(stage, square.mesh, place), 5);
    }
}

TEST_P(Hull, OfASheetIsBeforeWhatIsBehind)
{
  // Two sheets of one mesh.
  const std::vector<Vec3d> points = {{-1, -1, 0}, {1, -1, 0},    {1, 1, 0},     {-1, -1, 0},
                                     {1, 1, 0},   {-1, 1, 0},    {-.5, -.5, 1}, {.5, -.5, 1},
                                     {.5, .5, 1}, {-.5, -.5, 1}, {.5, .5, 1},   {-.5, .5, 1}};
  const Solid sheets(soup(points));
  Stage stage;
  stage.view = parallelView({0, 0, 5}, {0, 0, 0}, 1.5);
  stage.instances = {sheets.surface(), sheets.hull(4)};
  const Picture picture = draw(stage);
  for (int y = 0; y < 96; ++y)
    for (int x = 0; x < 96; ++x) {
      // 32 pixels a unit.
      const double d = std::max(std::fabs(x + 0.5 - 48), std::fabs(y + 0.5 - 48));
      const bool isInk = (d > 16 && d < 20) || (d > 32 && d < 36);
      ASSERT_EQ(at(picture, x, y).g, isInk ? 255 : 0) << x << ' ' << y;
      ASSERT_EQ(at(picture, x, y).r, !isInk && d < 32 ? 255 : 0) << x << ' ' << y;
    }
}

// Of a bowl the outline goes over from the rim to where the surface turns away.
TEST_P(Hull, OfABowlIsClosed)
{
  OwnedMesh bowl = sphere(24, 48);
  bowl.triangles.resize(bowl.triangles.size() / 2);
  finish(bowl);
  const Solid solid(std::move(bowl));
  for (int frame = 0; frame < 12; ++frame) {
    const Mat4d place = turned(0.5 * frame, 0.3 * frame);
    Stage stage;
    stage.view = perspectiveView({0, 0, 5}, {0, 0, 0}, 40);
    stage.instances = {solid.surface(place), solid.hull(4, place)};
    const Picture picture = draw(stage);
    for (int y = 1; y < 95; ++y)
      for (int x = 1; x < 95; ++x) {
        if (at(picture, x, y).r == 0) continue;
        for (const Rgba8 beside : {at(picture, x + 1, y), at(picture, x - 1, y),
                                   at(picture, x, y + 1), at(picture, x, y - 1)})
          ASSERT_NE(beside.r, beside.g) << x << ' ' << y << " of frame " << frame;
      }
  }
}

TEST_P(Hull, NamesItsInstanceAndACellBehindItAndNothingElse)
{
  const Solid cube(box({0.5, 0.5, 0.5}));
  Stage stage;
  stage.view = parallelView({0, 0, 5}, {0, 0, 0}, 1);
  const Mat4d place = turned(0.5, 0.6);
  stage.instances = {cube.surface(place)};
  const Picture without = draw(stage);
  stage.instances.push_back(cube.hull(4, place));
  const Picture with = draw(stage);
  std::size_t inked = 0;
  for (std::size_t i = 0; i < with.color.size(); ++i) {
    if (without.instance[i] == 3u) {
      EXPECT_EQ(with.instance[i], 3u);
      EXPECT_EQ(with.cell[i], without.cell[i]);
      EXPECT_EQ(with.depth[i], without.depth[i]);
    } else if (with.instance[i] != kNobody) {
      EXPECT_EQ(with.instance[i], 4u);
      ++inked;
      // Its two triangles look away.
      const std::uint32_t t = with.cell[i];
      const auto corner = [&](int k) {
        return transformPoint(
            place, vec3Cast<double>(cube.mesh.positions[cube.mesh.triangles[t].vertex[k]]));
      };
      EXPECT_LT(cross(corner(1) - corner(0), corner(2) - corner(0)).z, 0);
    }
  }
  EXPECT_GT(inked, 500u);
}

TEST_P(Hull, LetsShowThroughWhatItsOpacitySays)
{
  const Solid ball(sphere(24, 48));
  Stage stage;
  stage.view = perspectiveView({0, 0, 3}, {0, 0, 0}, 60);
  stage.resolve = Resolve::kLinear;
  stage.instances = {ball.surface(), ball.hull(5)};
  const Picture solid = draw(stage);
  stage.instances[1].style.outlineOpacity = 0.5f;
  const Picture faint = draw(stage);
  std::size_t inked = 0;
  for (int y = 0; y < stage.height; ++y)
    for (int x = 0; x < stage.width; ++x) {
      if (at(solid, x, y).g == 0) continue;
      ++inked;
      EXPECT_EQ(at(faint, x, y).g, 128) << x << ' ' << y;
    }
  EXPECT_GT(inked, 500u);
}

TEST_P(Hull, OfNoWidthIsNone)
{
  const Solid cube(box({1, 1, 1}));
  Stage stage;
  stage.view = perspectiveView({2, 1, 4}, {0, 0, 0}, 50);
  stage.instances = {cube.surface()};
  const Picture without = draw(stage);
  stage.instances.push_back(cube.hull(0));
  EXPECT_EQ(draw(stage).differingPixels(without), 0u);
}

TEST_P(Hull, OfASolidThatIsInsideOutIsTheSame)
{
  OwnedMesh insideOut = box({0.8, 0.6, 0.5});
  for (Triangle& t : insideOut.triangles)
    std::swap(t.vertex[1], t.vertex[2]);
  finish(insideOut);
  const Solid cube(std::move(insideOut));
  Stage stage;
  stage.view = perspectiveView({2, 1, 4}, {0, 0, 0}, 40);
  stage.instances = {cube.surface(), cube.hull(4)};
  expectOutline(stage, draw(stage), outlineOf(stage, cube.mesh, Mat4d::identity()), 4);
}

TEST_P(Hull, OfAPlateThinnerThanAPixelHasItsWidth)
{
  const Solid plate(box({1, 1e-4, 0.7}));
  Stage stage;
  stage.view = parallelView({0, 0, 5}, {0, 0, 0}, 1.5);
  stage.instances = {plate.surface(), plate.hull(4)};
  const Picture picture = draw(stage);
  for (int y = 40; y < 56; ++y)
    EXPECT_EQ(at(picture, 48, y).g, std::fabs(y + 0.5 - 48) < 4 ? 255 : 0) << y;
}

TEST(HullEdgesTest, AreTheConvexEdgesOfTheSolid)
{
  const Solid cube(box({1, 1, 1}));
  EXPECT_EQ(cube.mesh.hull.edges.size(), 12u) << "no diagonals";
  EXPECT_EQ(cube.mesh.positions.size(), 36u);
  std::vector<std::uint32_t> places = cube.mesh.hull.weld;
  std::sort(places.begin(), places.end());
  EXPECT_EQ(std::unique(places.begin(), places.end()) - places.begin(), 8);
}

std::size_t borderCount(const std::vector<HullEdge>& edges)
{
  return static_cast<std::size_t>(std::count_if(edges.begin(), edges.end(), [](HullEdge edge) {
    return edge.triangle[0] == edge.triangle[1];
  }));
}

TEST(HullEdgesTest, AreTheBordersOfASheet)
{
  const Solid square(sheet({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 4));
  EXPECT_EQ(square.mesh.hull.edges.size(), 16u);
  EXPECT_EQ(borderCount(square.mesh.hull.edges), 16u);
}

TEST(HullEdgesTest, HaveNoBorderBesideATriangleWithoutAreaOrOneThatIsWoundTheOtherWay)
{
  const Vec3d a = {0, 0, 0}, b = {2, 0, 0}, middle = {1, 0, 0}, up = {1, 1, 0}, down = {1, -1, 0};
  const Solid split(soup({a, b, up, a, middle, b, a, down, middle, middle, down, b}));
  EXPECT_EQ(borderCount(split.mesh.hull.edges), 4u);
  const Solid turned(soup({a, b, up, a, b, down}));
  EXPECT_EQ(borderCount(turned.mesh.hull.edges), 4u);
}

/// Every third triangle wound the other way.
OwnedMesh mixed(OwnedMesh mesh)
{
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3)
    std::swap(mesh.triangles[t].vertex[1], mesh.triangles[t].vertex[2]);
  finish(mesh);
  return mesh;
}

TEST(HullEdgesTest, TakeNeighboursAsWoundAlike)
{
  for (const OwnedMesh& shape :
       {box({1, 1, 1}), sphere(8, 12), sheet({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 4)}) {
    const HullEdges alike = Solid(OwnedMesh(shape)).mesh.hull;
    const HullEdges unlike = Solid(mixed(shape)).mesh.hull;
    EXPECT_GT(alike.edges.size(), 10u);
    EXPECT_EQ(unlike.edges.size(), alike.edges.size());
    EXPECT_EQ(borderCount(unlike.edges), borderCount(alike.edges));
    ASSERT_EQ(unlike.normal.size(), alike.normal.size());
    for (std::size_t t = 0; t < unlike.normal.size(); ++t)
      EXPECT_GE(dot(unlike.normal[t], alike.normal[t]), 0) << t;
  }
}

TEST(HullEdgesTest, TurnClosedPartsOutwardOneByOne)
{
  // A large box that is inside out, and one triangle turned in a small one beside it.
  std::vector<Vec3d> points;
  const auto add = [&](double half, double x, const auto& isTurned) {
    const OwnedMesh cube = box({half, half, half});
    for (std::size_t t = 0; t < cube.triangles.size(); ++t)
      for (const int k : {0, isTurned(t) ? 2 : 1, isTurned(t) ? 1 : 2})
        points.push_back(cube.view().position(cube.triangles[t].vertex[k]) + Vec3d{x, 0, 0});
  };
  add(10, 0, [](std::size_t) { return true; });
  add(1, 20, [](std::size_t t) { return t == 3; });
  const Solid both(soup(points));
  EXPECT_EQ(both.mesh.hull.edges.size(), 24u);
  for (std::size_t t = 0; t < 24; ++t) {
    const Vec3d n = vec3Cast<double>(both.mesh.hull.normal[t]);
    EXPECT_GT(dot(n, points[3 * t] - Vec3d{t < 12 ? 0.0 : 20.0, 0, 0}), 0) << t;
  }
}

TEST(HullEdgesTest, TurnPartsByThemselves)
{
  // A box all of whose triangles but one are inside out, and a sheet beside it that is as it is.
  std::vector<Vec3d> points;
  OwnedMesh cube = box({1, 1, 1});
  for (std::size_t t = 0; t < cube.triangles.size(); ++t)
    for (const int k : {0, t == 5 ? 1 : 2, t == 5 ? 2 : 1})
      points.push_back(cube.view().position(cube.triangles[t].vertex[k]));
  points.insert(points.end(), {{5, 0, 0}, {5, 1, 0}, {6, 0, 0}});
  const Solid both(soup(points));
  const Vec3d out[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (std::size_t t = 0; t < cube.triangles.size(); ++t) {
    const Vec3f n = both.mesh.hull.normal[t];
    const Vec3d p = cube.view().position(cube.triangles[t].vertex[0]);
    double sign = 0;
    for (const Vec3d axis : out)
      sign += dot(vec3Cast<double>(n), axis) * dot(p, axis);
    EXPECT_GT(sign, 0) << t;
  }
  EXPECT_LT(both.mesh.hull.normal.back().z, 0);
}

TEST(HullEdgesTest, OfABandWithOneSideAreThere)
{
  std::vector<Vec3d> points;
  constexpr int kParts = 24;
  const auto at = [](int i, double side) {
    const double a = 2 * kPi * i / kParts, r = 2 + side * std::cos(a / 2);
    return Vec3d{r * std::cos(a), r * std::sin(a), side * std::sin(a / 2)};
  };
  for (int i = 0; i < kParts; ++i) {
    const bool isLast = i + 1 == kParts;
    const Vec3d a = at(i, -0.5), b = at(i, 0.5);
    const Vec3d c = isLast ? at(0, -0.5) : at(i + 1, 0.5),
                d = isLast ? at(0, 0.5) : at(i + 1, -0.5);
    points.insert(points.end(), {a, b, c, a, c, d});
  }
  EXPECT_EQ(borderCount(Solid(soup(points)).mesh.hull.edges), 2u * kParts);
}

TEST(HullEdgesTest, HaveNoBorderWhereRoundingLeavesAGap)
{
  // Two squares side by side whose corners between them differ by less than a millionth of the box.
  const auto squares = [](double gap) {
    return Solid(soup({{0, 0, 0},
                       {1, 0, 0},
                       {1, 1, 0},
                       {0, 0, 0},
                       {1, 1, 0},
                       {0, 1, 0},
                       {1 + gap, 0, 0},
                       {2, 0, 0},
                       {2, 1, 0},
                       {1 + gap, 0, 0},
                       {2, 1, 0},
                       {1 + gap, 1, 0}}));
  };
  EXPECT_EQ(borderCount(squares(1e-6).mesh.hull.edges), 6u);
  EXPECT_EQ(borderCount(squares(1e-5).mesh.hull.edges), 8u);
}

/// Two strips of so many squares side by side, at a place in space.
std::size_t stripBorders(int left, int right, const Mat4d& place)
{
  std::vector<Vec3d> points;
  const auto add = [&](int count, double x) {
    // As most files have them.
    const auto at = [&](double u, int i) {
      const Vec3d p = transformPoint(place, {x + u, static_cast<double>(i) / count, 0});
      return vec3Cast<double>(vec3Cast<float>(p));
    };
    for (int i = 0; i < count; ++i)
      points.insert(points.end(),
                    {at(0, i), at(1, i), at(1, i + 1), at(0, i), at(1, i + 1), at(0, i + 1)});
  };
  add(left, 0);
  add(right, 1);
  return borderCount(Solid(soup(points)).mesh.hull.edges);
}

TEST(HullEdgesTest, HaveNoBorderAlongASeamWhosePointsDiffer)
{
  for (const Mat4d& place : {Mat4d::identity(), turned(0.3, 0.7)}) {
    EXPECT_EQ(stripBorders(1, 4, place), 1u + 4u + 4u);
    EXPECT_EQ(stripBorders(2, 3, place), 2u + 3u + 4u);
    EXPECT_EQ(stripBorders(5, 5, place), 5u + 5u + 4u);
    EXPECT_EQ(stripBorders(7, 12, place), 7u + 12u + 4u);
    EXPECT_EQ(stripBorders(97, 70, place), 97u + 70u + 4u);
  }
}

TEST(HullEdgesTest, HaveTheBordersOfSheetsThatLieOnEachOther)
{
  std::vector<Vec3d> points;
  const auto square = [&](double x, double y, double side) {
    points.insert(points.end(), {{x, y, 0},
                                 {x + side, y, 0},
                                 {x + side, y + side, 0},
                                 {x, y, 0},
                                 {x + side, y + side, 0},
                                 {x, y + side, 0}});
  };
  square(0, 0, 1);
  for (const double x : {0.0, 0.5})
    for (const double y : {0.0, 0.5})
      square(x, y, 0.5);
  EXPECT_EQ(borderCount(Solid(soup(points)).mesh.hull.edges), 4u + 8u);
}

// By comparing all with all this would take minutes.
TEST(HullEdgesTest, AreFoundWhereManyBordersMeet)
{
  constexpr int kBlades = 40000;
  std::vector<Vec3d> points;
  for (int i = 0; i < kBlades; ++i) {
    const double z = 1 - 2 * (i + 0.5) / kBlades, r = std::sqrt(1 - z * z), a = 2.4 * i;
    const Vec3d tip = {r * std::cos(a), r * std::sin(a), z};
    points.insert(points.end(), {{0, 0, 0}, tip, tip + Vec3d{0, 0, 1e-3}});
  }
  EXPECT_EQ(borderCount(Solid(soup(points)).mesh.hull.edges), 3u * kBlades);
}

TEST(HullEdgesTest, HaveBordersBesideAWiderOpening)
{
  // A triangle beyond half of a square's side.
  EXPECT_EQ(borderCount(Solid(soup({{0, 0, 0},
                                    {1, 0, 0},
                                    {1, 1, 0},
                                    {0, 0, 0},
                                    {1, 1, 0},
                                    {0, 1, 0},
                                    {1, 0, 0},
                                    {2, 0, 0},
                                    {1, 0.5, 0}}))
                            .mesh.hull.edges),
            7u);
}

TEST(HullEdgesTest, HaveNoBorderAtPolesThatRoundingDraws)
{
  // A fan about the points of a pole, all of them 0 but for rounding, and triangles between these.
  std::vector<Vec3d> points;
  constexpr int kSides = 6;
  const auto rim = [](int i) {
    return Vec3d{std::cos(i % kSides * kPi / 3), std::sin(i % kSides * kPi / 3), 1};
  };
  const auto pole = [&](int i) { return Vec3d{rim(i).x * 1e-17, rim(i).y * 1e-17, 0}; };
  for (int i = 0; i < kSides; ++i)
    points.insert(points.end(), {pole(i), pole(i + 1), rim(i + 1), pole(i), rim(i + 1), rim(i)});
  EXPECT_EQ(borderCount(Solid(soup(points)).mesh.hull.edges), 6u);
}

TEST(HullEdgesTest, LeaveOutHollows)
{
  // A bump on a plane: its foot is hollow, its four ridges are not.
  const std::vector<Vec3d> ridge = {{0, 0, 1},  {-1, -1, 0}, {1, -1, 0},  {0, 0, 1},  {1, -1, 0},
                                    {1, 1, 0},  {0, 0, 1},   {1, 1, 0},   {-1, 1, 0}, {0, 0, 1},
                                    {-1, 1, 0}, {-1, -1, 0}, {-1, -1, 0}, {0, -3, 0}, {1, -1, 0}};
  const Solid bump(soup(ridge));
  EXPECT_EQ(borderCount(bump.mesh.hull.edges), 5u);
  EXPECT_EQ(bump.mesh.hull.edges.size(), 4u + 5u);
}

TEST(HullEdgesTest, AreTheSameOnAnyNumberOfThreads)
{
  const OwnedMesh mesh = torus(1, 0.4, 64);
  HullEdges one, many;
  ASSERT_TRUE(buildHullEdges(mesh.view(), 1, one).ok());
  ASSERT_TRUE(buildHullEdges(mesh.view(), 8, many).ok());
  ASSERT_EQ(one.edges.size(), many.edges.size());
  EXPECT_EQ(one.weld, many.weld);
  for (std::size_t e = 0; e < one.edges.size(); ++e) {
    EXPECT_EQ(one.edges[e].vertex[1], many.edges[e].vertex[1]);
    EXPECT_EQ(one.edges[e].triangle[0], many.edges[e].triangle[0]);
  }
}

}  // namespace
}  // namespace limn::testing
