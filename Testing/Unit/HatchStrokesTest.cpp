// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Strokes along the principal curvature, and straight ones on flat faces: where they run and how
// far they are apart.
#include "Rendering/Lines/CurveBounds.h"
#include "Testing/Unit/HatchedMesh.h"

#include <cmath>
#include <limits>

namespace limn::testing {
namespace {

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

TEST(HatchStrokes, DoNotDependOnPointsThatNoFaceUses)
{
  // A ball of curved strokes and a cube of straight ones.
  const Polyhedron meshes[] = {ball().mesh, cube()};
  for (const Polyhedron& mesh : meshes) {
    const Hatched plain(mesh);
    ASSERT_GT(plain.strokes.strokeCount(), 50u);
    for (const float far : {2.0f, 1e9f}) {
      Polyhedron more = mesh;
      more.positions.push_back({far, -far, far});
      const Hatched hatched(more);
      EXPECT_EQ(featureSize(more.view()), featureSize(mesh.view()));
      EXPECT_EQ(hatched.field.flats.ofTriangle, plain.field.flats.ofTriangle);
      EXPECT_EQ(hatched.strokes.spacing, plain.strokes.spacing);
      EXPECT_EQ(hatched.strokes.first, plain.strokes.first);
      EXPECT_EQ(hatched.strokes.vertex, plain.strokes.vertex);
      ASSERT_EQ(hatched.strokes.points.size(), plain.strokes.points.size());
      for (std::size_t i = 0; i < plain.strokes.points.size(); ++i)
        ASSERT_TRUE(hatched.strokes.points[i] == plain.strokes.points[i]);
    }
  }
}

// Those of the data may be anything.
TEST(HatchStrokes, EndWhereNormalsTellNoSides)
{
  const Polyhedron& mesh = ring().mesh;
  const float infinite = std::numeric_limits<float>::infinity();
  for (const float part : {0.0f, std::nanf(""), infinite}) {
    const std::vector<Vec3f> unusable(mesh.positions.size(), Vec3f{0, part, part});
    EXPECT_EQ(Hatched(mesh, unusable).strokes.strokeCount(), 0u) << part;
    std::vector<Vec3f> some = ring().normals;
    for (std::size_t v = 0; v < some.size() / 2; ++v)
      some[v] = unusable[v];
    const HatchStrokes strokes = Hatched(mesh, some).strokes;
    EXPECT_GT(strokes.strokeCount(), 50u) << part;
    for (const Vec3f normal : strokes.normals)
      ASSERT_NEAR(dot(normal, normal), 1, 1e-5) << part;
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
  std::size_t rings = 0, around = 0;
  const HatchStrokes& strokes = cylinder().strokes;
  for (const Vec3d& p : strokes.points) {
    EXPECT_GT(std::hypot(p.x, p.y), std::cos(kPi / kSides) - 1e-6);
    EXPECT_LT(std::hypot(p.x, p.y), 1 + 1e-6);
  }
  for (std::size_t s = 0; s < strokes.strokeCount(); ++s) {
    rings += cylinder().isRing(s);
    around += strokes.isCross[s] == 0;
  }
  EXPECT_GT(rings, 50u);
  EXPECT_EQ(rings, around);
  double highest = 0;
  for (const Vec3d& p : strokes.points)
    highest = std::max(highest, p.z);
  EXPECT_NEAR(highest, 1.5, 1e-9) << "and go on to the border";
}

/// Calls visit(stroke, its first and last point) and requires the points between to be on the line.
template <class Visit>
void forEachStraight(const Hatched& hatched, const Visit& visit)
{
  const HatchStrokes& strokes = hatched.strokes;
  for (std::size_t s = 0; s < strokes.strokeCount(); ++s) {
    const Vec3d a = hatched.point(strokes.first[s]);
    const Vec3d b = hatched.point(strokes.first[s + 1] - 1), way = normalized(b - a);
    for (std::uint32_t i = strokes.first[s]; i < strokes.first[s + 1]; ++i) {
      const Vec3d off = cross(hatched.point(i) - a, way);
      ASSERT_LT(std::sqrt(dot(off, off)), 1e-9);
    }
    visit(s, a, b);
  }
}
double largest(Vec3d a)
{
  return std::max({std::fabs(a.x), std::fabs(a.y), std::fabs(a.z)});
}

TEST(HatchStrokes, OfACubeAreParallelToItsEdgesFromEdgeToEdge)
{
  const Hatched cube(testing::cube(), {}, kSharp);
  const HatchStrokes& strokes = cube.strokes;
  std::size_t count = 0;
  forEachStraight(cube, [&](std::size_t s, Vec3d a, Vec3d b) {
    const Vec3d way = b - a,
                n = vec3Cast<double>(strokes.normals[strokes.vertex[strokes.first[s]]]);
    EXPECT_NEAR(std::sqrt(dot(way, way)), 2, 1e-12);
    EXPECT_NEAR(largest(way), 2, 1e-12);
    EXPECT_EQ(largest(n), 1) << "the face's own, not the corners'";
    EXPECT_NEAR(dot(a, n), 1, 1e-12);
    ++count;
  });
  EXPECT_NEAR(static_cast<double>(count), 6 * 2 * (2 / strokes.spacing), 12);
}

TEST(HatchStrokes, OfATiltedPlaneHaveOneDirection)
{
  // Edges along u, shorter ones along v; both families, whatever the triangles.
  const Vec3d u = normalized(Vec3d{3, 1, 2}), v = normalized(cross(u, Vec3d{1, 5, 1}));
  const Hatched tilted(grid(17, 9, [&](double s, double t) {
    const double bent = t > 0 && t < 1 ? 0.02 * std::sin(40 * s) : 0;
    return vec3Cast<float>(u * (3 * s) + v * (t + bent));
  }));
  ASSERT_EQ(tilted.field.flats.regions.size(), 1u);
  EXPECT_GT(tilted.strokes.strokeCount(), 100u);
  forEachStraight(tilted, [&](std::size_t s, Vec3d a, Vec3d b) {
    const Vec3d way = normalized(b - a);
    EXPECT_GT(std::fabs(dot(way, tilted.strokes.isCross[s] != 0 ? v : u)), 1 - 1e-9);
  });
}

/// A disk about the z axis, at a height.
Polyhedron disk(std::uint32_t sides, double z)
{
  Polyhedron mesh;
  mesh.positions.push_back(vec3Cast<float>(Vec3d{0, 0, z}));
  for (std::uint32_t i = 0; i < sides; ++i) {
    const double a = 2 * kPi * i / sides;
    mesh.positions.push_back(vec3Cast<float>(Vec3d{std::cos(a), std::sin(a), z}));
    mesh.triangles.push_back({{0, 1 + i, 1 + (i + 1) % sides}});
  }
  return mesh;
}

TEST(HatchStrokes, OfADiskFollowAnAxisOfTheModel)
{
  const Hatched round(disk(64, 0));
  EXPECT_GT(round.strokes.strokeCount(), 200u);
  forEachStraight(round, [&](std::size_t s, Vec3d a, Vec3d b) {
    const Vec3d way = normalized(b - a);
    EXPECT_GT(std::fabs(round.strokes.isCross[s] != 0 ? way.y : way.x), 1 - 1e-9);
  });
}

TEST(HatchStrokes, OfADrumAreStraightOnItsEndsAndRunAroundAndAlongItsWall)
{
  // Facets, 15 degrees apart, are no flat faces; the ends are.
  constexpr std::uint32_t kFacets = 24;
  Polyhedron drum = disk(kFacets, 1);
  for (std::uint32_t i = 1; i <= kFacets; ++i)
    drum.positions.push_back({drum.positions[i].x, drum.positions[i].y, -1});
  for (std::uint32_t i = 1; i <= kFacets; ++i) {
    const std::uint32_t next = i % kFacets + 1;
    drum.triangles.push_back({{i, i + kFacets, next + kFacets}});
    drum.triangles.push_back({{i, next + kFacets, next}});
  }
  const Hatched hatched(drum, {}, kSharp);
  ASSERT_EQ(hatched.field.flats.regions.size(), 1u);
  double onWall = 0;
  hatched.forEachPiece([&](Vec3d p, Vec3d way, bool isCross, double) {
    const double length = std::sqrt(dot(way, way));
    if (p.z > 1 - 1e-9) {
      EXPECT_NEAR(largest(way), length, 1e-9);
      return;
    }
    const double off = isCross ? std::hypot(way.x, way.y) : std::fabs(way.z);
    EXPECT_LE(off, 3 * kDegree * length);
    onWall += length;
  });
  EXPECT_GT(onWall * hatched.strokes.spacing, 0.6 * 2 * 4 * kPi);
}

TEST(HatchStrokes, GoOnWhereThePrincipalDirectionsSwap)
{
  // r^4 + z^4 = 1 about the z axis: its wall bends more around, its shoulder more over.
  const Hatched barrel([] {
    Polyhedron mesh = grid(120, 60, [](double s, double t) {
      const double z = 1.8 * t - 0.9, r = std::sqrt(std::sqrt(1 - z * z * z * z));
      return vec3Cast<float>(Vec3d{r * std::cos(2 * kPi * s), r * std::sin(2 * kPi * s), z});
    });
    for (Triangle& triangle : mesh.triangles)
      for (std::uint32_t& v : triangle.vertex)
        if (v % 121 == 120) v -= 120;
    return mesh;
  }());
  double level = 0, steep = 0;
  barrel.forEachPiece([&](Vec3d p, Vec3d way, bool isCross, double) {
    const Vec3d around = normalized(Vec3d{-p.y, p.x, 0});
    const double length = std::sqrt(dot(way, way)), along = std::fabs(dot(way, around));
    const double off = std::min(along, std::sqrt(std::max(0.0, length * length - along * along)));
    // But for the border, where vertices' normals are those of one side alone.
    if (std::fabs(p.z) > 0.85) return;
    EXPECT_LE(off, 4 * kDegree * length) << p.z;
    ((along > 0.7 * length) != isCross ? level : steep) += length;
  });
  EXPECT_EQ(std::min(level, steep), 0) << "one family is level everywhere";
  EXPECT_GT(level + steep, 1000 * barrel.strokes.spacing);
}

TEST(HatchStrokes, FillASphereEvenlyAndCloseAroundIt)
{
  const HatchStrokes& strokes = ball().strokes;
  std::size_t empty = 0, rings = 0, level = 0;
  for (const Triangle& triangle : ball().mesh.triangles) {
    const MeshView mesh = ball().mesh.view();
    const Vec3d middle = (mesh.position(triangle.vertex[0]) + mesh.position(triangle.vertex[1]) +
                          mesh.position(triangle.vertex[2])) *
                         (1.0 / 3);
    double nearest = 4;
    for (std::size_t s = 0; s < strokes.strokeCount(); ++s)
      for (std::uint32_t i = strokes.first[s]; !strokes.isCross[s] && i < strokes.first[s + 1];
           ++i) {
        const Vec3d way = ball().point(i) - middle;
        nearest = std::min(nearest, dot(way, way));
      }
    empty += std::sqrt(nearest) > 1.5 * strokes.spacing;
  }
  EXPECT_LT(empty, ball().mesh.triangles.size() / 100);
  for (std::size_t s = 0; s < strokes.strokeCount(); ++s) {
    rings += strokes.isCross[s] == 0 && ball().isRing(s);
    level += strokes.isCross[s] == 0;
  }
  EXPECT_GT(static_cast<double>(rings), 0.8 * static_cast<double>(level));
}

TEST(HatchStrokes, OfABallAreEvenlyApartFromPoleToPole)
{
  // Of the first rounds: rings about the y axis, as there are fewest vertices that look along it,
  // all have one distance along the profile, to the poles as well.
  const HatchStrokes& strokes = ball().strokes;
  for (const double rank : {1.0 / 16, 1.0 / 8, 1.0 / 4}) {
    std::vector<double> rings, profiles;
    for (std::size_t s = 0; s < strokes.strokeCount(); ++s) {
      if (static_cast<double>(strokes.rank[s]) > rank) continue;
      const Vec3d p = normalized(ball().point(strokes.first[s]));
      if (strokes.isCross[s] == 0) {
        EXPECT_TRUE(ball().isRing(s));
        rings.push_back(std::acos(p.y));
        for (std::uint32_t i = strokes.first[s]; i < strokes.first[s + 1]; ++i)
          EXPECT_NEAR(std::acos(normalized(ball().point(i)).y), rings.back(), 0.003);
      } else {
        for (std::uint32_t i = strokes.first[s]; i + 1 < strokes.first[s + 1]; ++i)
          if ((ball().point(i).y < 0) != (ball().point(i + 1).y < 0))
            profiles.push_back(std::atan2(ball().point(i).x, ball().point(i).z));
      }
    }
    std::sort(rings.begin(), rings.end());
    const double apart = strokes.spacing / rank;
    for (std::size_t i = 0; i + 1 < rings.size(); ++i)
      EXPECT_NEAR((rings[i + 1] - rings[i]) / apart, 0.95, 0.02) << rank;
    EXPECT_LT(rings.front(), 1.15 * apart);
    EXPECT_GT(rings.back(), kPi - 1.15 * apart);
    std::sort(profiles.begin(), profiles.end());
    profiles.push_back(profiles.front() + 2 * kPi);
    for (std::size_t i = 0; i + 1 < profiles.size(); ++i)
      EXPECT_LT(profiles[i + 1] - profiles[i], 1.12 * apart) << rank;
  }
}

TEST(HatchStrokes, OfACoarseBallAreAsRoundAsItsNormals)
{
  const OwnedMesh sphere = testing::sphere(10, 14);
  Polyhedron mesh;
  mesh.positions = sphere.positions;
  mesh.triangles = sphere.triangles;
  const Hatched coarse(welded(mesh), sphere.positions, 90);
  std::size_t rings = 0;
  for (std::size_t s = 0; s < coarse.strokes.strokeCount(); ++s) {
    if (coarse.strokes.isCross[s] != 0) continue;
    ASSERT_TRUE(coarse.isRing(s));
    const Vec3d first = normalized(coarse.point(coarse.strokes.first[s]));
    double most = 0;
    for (std::uint32_t i = coarse.strokes.first[s]; i < coarse.strokes.first[s + 1]; ++i)
      most = std::max(most, std::fabs(normalized(coarse.point(i)).y - first.y));
    // A quarter of the distance of all strokes.
    EXPECT_LT(most, 0.25 * coarse.strokes.spacing) << first.y;
    ++rings;
  }
  EXPECT_GT(rings, 150u);
}

TEST(HatchStrokes, CloseInSpiteOfWhatACoarseMeshStrays)
{
  // Parallels of a coarse torus drift by more than their distance, each round.
  const Hatched coarse(torus(1, 0.35, 48, 24));
  std::size_t rings = 0, parallels = 0;
  for (std::size_t s = 0; s < coarse.strokes.strokeCount(); ++s) {
    rings += coarse.strokes.isCross[s] != 0 && coarse.isRing(s);
    parallels += coarse.strokes.isCross[s] != 0;
  }
  // Others meet neighbours first. Where none is turned back, 19 % close.
  EXPECT_GT(static_cast<double>(rings), 0.28 * static_cast<double>(parallels));
}

}  // namespace
}  // namespace limn::testing
