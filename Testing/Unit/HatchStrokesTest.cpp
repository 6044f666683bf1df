// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Strokes along the principal curvature: where they run, how far they are apart, and which are
// drawn in what light.
#include "Rendering/Lines/HatchLines.h"
#include "Testing/Unit/Polyhedra.h"
#include "Testing/Unit/TestScene.h"

#include <cmath>

namespace limn::testing {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// A mesh with all that strokes on it are made from.
struct Hatched {
  Polyhedron mesh;
  std::vector<Vec3f> normals, field;
  std::vector<VertexCurvature> curvature;
  EdgeTable table;
  HatchStrokes strokes;

  explicit Hatched(Polyhedron solid, std::vector<Vec3f> given = {})
      : mesh(std::move(solid)), normals(std::move(given))
  {
    if (normals.empty()) normals = vertexNormals(mesh.view(), NormalWeight::kArea);
    curvature = vertexCurvature(mesh.view(), normals, 2);
    EXPECT_TRUE(buildEdgeTable(mesh.view(), 0, 2, table).ok());
    const CurvedSurface surface = {mesh.view(), normals, curvature};
    field = hatchField(surface, 2);
    strokes = traceHatching(surface, table, field, 2);
  }

  /// Calls visit(middle, unit direction, is across, rank) for all pieces of strokes.
  template <class Visit>
  void forEachPiece(const Visit& visit) const
  {
    for (std::size_t s = 0; s < strokes.strokeCount(); ++s)
      for (std::uint32_t i = strokes.first[s]; i + 1 < strokes.first[s + 1]; ++i) {
        const Vec3d a = strokes.points[strokes.vertex[i]];
        const Vec3d way = strokes.points[strokes.vertex[i + 1]] - a;
        visit(a + way * 0.5, way, strokes.isCross[s] != 0, static_cast<double>(strokes.rank[s]));
      }
  }
  /// Of strokes up to a rank.
  double length(bool isCross, double rank) const
  {
    double sum = 0;
    forEachPiece([&](Vec3d, Vec3d way, bool cross, double own) {
      if (cross == isCross && own <= rank) sum += std::sqrt(dot(way, way));
    });
    return sum;
  }
};

Polyhedron grid(std::uint32_t across, std::uint32_t along,
                const std::function<Vec3f(double, double)>& at)
{
  Polyhedron mesh;
  for (std::uint32_t j = 0; j <= along; ++j)
    for (std::uint32_t i = 0; i <= across; ++i)
      mesh.positions.push_back(at(1.0 * i / across, 1.0 * j / along));
  for (std::uint32_t j = 0; j < along; ++j)
    for (std::uint32_t i = 0; i < across; ++i) {
      const std::uint32_t p = j * (across + 1) + i;
      mesh.triangles.push_back({{p, p + 1, p + across + 2}});
      mesh.triangles.push_back({{p, p + across + 2, p + across + 1}});
    }
  return mesh;
}

constexpr std::uint32_t kSides = 96;
/// Radius 1 about the z axis, 3 long, open at both ends, its seam closed.
const Hatched& cylinder()
{
  static const Hatched hatched = [] {
    Polyhedron mesh = grid(kSides, 40, [](double s, double t) {
      return vec3Cast<float>(Vec3d{std::cos(2 * kPi * s), std::sin(2 * kPi * s), 3 * t - 1.5});
    });
    for (Triangle& triangle : mesh.triangles)
      for (std::uint32_t& v : triangle.vertex)
        if (v % (kSides + 1) == kSides) v -= kSides;
    std::vector<Vec3f> normals;
    for (const Vec3f& p : mesh.positions)
      normals.push_back({p.x, p.y, 0});
    return Hatched(mesh, normals);
  }();
  return hatched;
}
const Hatched& plane()
{
  static const Hatched hatched(grid(30, 30, [](double s, double t) {
    return vec3Cast<float>(Vec3d{2 * s - 1, 2 * t - 1, 0});
  }));
  return hatched;
}
const Hatched& ring()
{
  static const Hatched hatched(torus(1, 0.35, 160, 80));
  return hatched;
}
const Hatched& ball()
{
  static const Hatched hatched = [] {
    const OwnedMesh sphere = testing::sphere(60, 90);
    Polyhedron mesh;
    mesh.positions = sphere.positions;
    mesh.triangles = sphere.triangles;
    return Hatched(mesh);
  }();
  return hatched;
}

const double kDegree = std::sin(kPi / 180);

TEST(HatchStrokes, OfACylinderRunAroundAndAlongItsAxis)
{
  double around = 0, along = 0;
  cylinder().forEachPiece([&](Vec3d, Vec3d way, bool isCross, double) {
    const double length = std::sqrt(dot(way, way));
    const double off = isCross ? std::hypot(way.x, way.y) : std::fabs(way.z);
    EXPECT_LE(off, kDegree * length);
    (isCross ? along : around) += length;
  });
  const double all = 6 * kPi / cylinder().strokes.spacing;
  EXPECT_GT(around, 0.6 * all);
  EXPECT_GT(along, 0.6 * all);
}

TEST(HatchStrokes, OfATorusRunAlongMeridiansAndParallels)
{
  std::size_t pieces = 0;
  ring().forEachPiece([&](Vec3d p, Vec3d way, bool isCross, double) {
    const Vec3d parallel = normalized(Vec3d{-p.y, p.x, 0});
    const double length = std::sqrt(dot(way, way)), along = dot(way, parallel);
    const double across = std::sqrt(std::max(0.0, length * length - along * along));
    EXPECT_LE(isCross ? across : std::fabs(along), kDegree * length);
    ++pieces;
  });
  EXPECT_GT(pieces, 10000u);
}

TEST(HatchStrokes, AreEvenlyApartInEveryDensity)
{
  // Twice as many to a rank twice as high: what there is of strokes is area over distance.
  for (const bool isCross : {false, true})
    for (const double rank : {0.125, 0.25, 0.5, 1.0}) {
      const double expected = 4 / (plane().strokes.spacing / rank);
      EXPECT_NEAR(plane().length(isCross, rank) / expected, 1, 0.3) << isCross << ' ' << rank;
      const double onTorus = 4 * kPi * kPi * 0.35 / (ring().strokes.spacing / rank);
      EXPECT_NEAR(ring().length(isCross, rank) / onTorus, 1, 0.4) << isCross << ' ' << rank;
    }
}

TEST(HatchStrokes, OfSurfacesThatBendAlikeEverywhereAreSmooth)
{
  for (const Hatched* surface : {&plane(), &ball()}) {
    ASSERT_GT(surface->strokes.strokeCount(), 100u);
    std::size_t pieces = 0, sharp = 0;
    const HatchStrokes& strokes = surface->strokes;
    for (std::size_t s = 0; s < strokes.strokeCount(); ++s)
      for (std::uint32_t i = strokes.first[s]; i + 2 < strokes.first[s + 1]; ++i) {
        const auto point = [&](std::uint32_t k) { return strokes.points[strokes.vertex[k]]; };
        const Vec3d a = normalized(point(i + 1) - point(i));
        const Vec3d b = normalized(point(i + 2) - point(i + 1));
        ++pieces;
        sharp += dot(a, b) < std::cos(kPi / 9);
      }
    EXPECT_LT(static_cast<double>(sharp), 0.005 * static_cast<double>(pieces));
  }
}

TEST(HatchStrokes, LieOnTheSurfaceAndCloseAroundIt)
{
  std::size_t rings = 0;
  const HatchStrokes& strokes = cylinder().strokes;
  for (const Vec3d& p : strokes.points) {
    EXPECT_GT(std::hypot(p.x, p.y), std::cos(kPi / kSides) - 1e-6);
    EXPECT_LT(std::hypot(p.x, p.y), 1 + 1e-6);
  }
  for (std::size_t s = 0; s < strokes.strokeCount(); ++s)
    rings += strokes.vertex[strokes.first[s]] == strokes.vertex[strokes.first[s + 1] - 1];
  EXPECT_GT(rings, 50u);
}

/// The plane from above, under light of one strength.
struct Lit {
  Stage stage;
  double light;
  float darkest = 1;
  ToneLight toneLight = ToneLight::kFirst;

  ContourLines lines(const Hatched& hatched) const
  {
    const Camera camera = stage.camera();
    const auto grey = static_cast<float>(light);
    return hatchLines(
        hatched.strokes, Mat4d::identity(),
        {camera, {grey, grey, grey}, stage.lights, true, toneLight, stage.height, 6, darkest}, 2);
  }
};
double lengthOf(const ContourLines& lines)
{
  double sum = 0;
  for (std::size_t c = 0; c + 1 < lines.chains.first.size(); ++c)
    for (std::uint32_t i = lines.chains.first[c]; i + 1 < lines.chains.first[c + 1]; ++i) {
      const Vec3d way =
          lines.points[lines.chains.vertex[i + 1]] - lines.points[lines.chains.vertex[i]];
      sum += std::sqrt(dot(way, way));
    }
  return sum;
}
Lit fromAbove(double light)
{
  Lit lit;
  lit.light = light;
  lit.stage.view = parallelView({0, 0, 5}, {0, 0, 0}, 1);
  lit.stage.width = lit.stage.height = 400;
  return lit;
}

TEST(HatchLines, AreNoneInFullLightAndMoreTheDarkerItIs)
{
  EXPECT_EQ(lengthOf(fromAbove(1).lines(plane())), 0);
  double before = 0;
  for (const double light : {0.9, 0.8, 0.7, 0.6, 0.5, 0.4, 0.2, 0.0}) {
    const double length = lengthOf(fromAbove(light).lines(plane()));
    EXPECT_GT(length, before) << light;
    before = length;
  }
}

TEST(HatchLines, AreAsFarApartOnTheScreenAsAsked)
{
  // 2 x 2 units on 400 x 400 pixels; half of the light leaves the first family alone.
  const double length = lengthOf(fromAbove(0.5).lines(plane())) * 200;
  EXPECT_NEAR(400.0 * 400 / length, 6, 1.5);
  // Twice as near, each is shown twice as large, and more are drawn, as far as there are any.
  Lit far = fromAbove(0.75), near = far;
  near.stage.view.halfHeight = 0.5;
  EXPECT_NEAR(lengthOf(near.lines(plane())) / lengthOf(far.lines(plane())), 2, 0.3);
}

TEST(HatchLines, EndWhereItGetsLighter)
{
  Lit lit = fromAbove(0);
  Light lamp;
  lamp.kind = LightKind::kPoint;
  lamp.position = {1, 0, 1};
  lamp.attenuation = {1, 0, 0};
  lit.stage.lights = {lamp};
  const ContourLines lines = lit.lines(plane());
  std::size_t left = 0, right = 0;
  for (const Vec3d& p : lines.points)
    (p.x < 0 ? left : right) += 1;
  EXPECT_GT(left, 2 * right);
  EXPECT_GT(right, 0u);
}

TEST(HatchLines, TakeTheCamerasLightWhereAsked)
{
  Lit lit = fromAbove(0);
  lit.toneLight = ToneLight::kUpperRight;
  const ContourLines lines = lit.lines(ball());
  double bright = 0, dark = 0;
  for (const Vec3d& p : lines.points)
    if (p.z > 0.3) (p.x + p.y > 0 ? bright : dark) += 1;
  EXPECT_GT(dark, 1.5 * bright);
  EXPECT_GT(bright, 0);
}

TEST(HatchLines, StayWhereTheyAreWhenTheCameraMoves)
{
  Lit lit = fromAbove(0.5);
  const ContourLines before = lit.lines(ball());
  lit.stage.view.eye = {0.3, 0.2, 5};
  const ContourLines after = lit.lines(ball());
  std::size_t shared = 0;
  std::vector<Vec3d> old = before.points;
  const auto less = [](const Vec3d& a, const Vec3d& b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  };
  std::sort(old.begin(), old.end(), less);
  for (const Vec3d& p : after.points)
    shared += std::binary_search(old.begin(), old.end(), p, less);
  EXPECT_GT(static_cast<double>(shared), 0.8 * static_cast<double>(after.points.size()));
}

TEST(HatchLines, AreTheSameOnAnyNumberOfThreadsAndFromBothRenderers)
{
  const CurvedSurface surface = {ring().mesh.view(), ring().normals, ring().curvature};
  const std::vector<Vec3f> alone = hatchField(surface, 1), many = hatchField(surface, 8);
  EXPECT_TRUE(std::equal(alone.begin(), alone.end(), many.begin()));
  const HatchStrokes strokes = traceHatching(surface, ring().table, alone, 1);
  EXPECT_EQ(strokes.vertex, ring().strokes.vertex);
  EXPECT_EQ(strokes.first, ring().strokes.first);
  EXPECT_TRUE(
      std::equal(strokes.points.begin(), strokes.points.end(), ring().strokes.points.begin()));
  const Lit lit = fromAbove(0.2);
  const ContourLines lines = lit.lines(ring());
  const LineSet set = lines.lines({});
  const OwnedMesh square = sheet({-1, -1, -2}, {2, 0, 0}, {0, 2, 0});
  Stage stage = lit.stage;
  stage.view.halfHeight = 1.6;
  Instance instance = painted(square, {1, 1, 1});
  instance.lines = {&set, 1};
  stage.instances = {instance};
  const Picture picture = stage.draw(Backend::kPipeline);
  EXPECT_EQ(stage.draw(Backend::kReference).differingPixels(picture), 0u);
  std::size_t ink = 0;
  for (const Rgba8 color : picture.color)
    ink += color.a != 0 && color.g < 128;
  EXPECT_GT(ink, 3000u);
}

}  // namespace
}  // namespace limn::testing
