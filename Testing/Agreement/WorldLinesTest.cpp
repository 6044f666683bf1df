// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Shadows' borders and intersections of random bodies: as the reference has them, on any number of
// threads, and with one hash everywhere.
#include "Rendering/Reference/ReferenceShadows.h"
#include "Testing/Unit/WorldStage.h"

#include <gtest/gtest.h>

#include <cstring>
#include <iostream>
#include <random>

namespace limn {
namespace {

constexpr std::uint64_t kHashOfShadows = 8817568399245522993u;
constexpr std::uint64_t kHashOfSoupShadows = 9763850317719148289u;
constexpr std::uint64_t kHashOfIntersections = 84245614203796633u;
constexpr int kSeeds = 400;

class RandomWorld {
 public:
  explicit RandomWorld(std::uint32_t seed) : random_(seed)
  {
    const int bodies = 2 + whole(3);
    for (int i = 0; i < bodies; ++i)
      meshes_.push_back(solid());
    std::vector<PlacedMesh> placed;
    for (const testing::Polyhedron& mesh : meshes_)
      placed.push_back({mesh.view(), place()});
    wanted.resize(placed.size());
    for (std::uint8_t& one : wanted)
      one = whole(4) > 0 ? 1 : 0;
    for (std::size_t i = 0; i < placed.size(); ++i)
      creaseDegrees.push_back(whole(3) * 40.0);
    EXPECT_TRUE(buildWorldMesh(placed, wanted, 2, world).ok());
    const int kind = whole(3);
    light = {kind == 0, kind == 0 ? normalized(vector()) : vector() * 4.0, kind == 2,
             normalized(vector()), 0.5 * share() + 0.4};
    // Towards the middle, mostly.
    if (light.isCone) light.axis = normalized(-light.source + vector());
  }

  WorldMesh world;
  LightRays light = {};
  std::vector<double> creaseDegrees;
  std::vector<std::uint8_t> wanted;

 private:
  double share() { return static_cast<double>(random_() >> 8) * 0x1p-24; }
  int whole(int count) { return static_cast<int>(share() * count); }
  Vec3d vector()
  {
    const double x = 2 * share() - 1, y = 2 * share() - 1, z = 2 * share() - 1;
    return {x, y, z};
  }
  testing::Polyhedron solid()
  {
    switch (whole(5)) {
      case 0:
        return testing::cube();
      case 1:
        return testing::plane(1 + static_cast<std::uint32_t>(whole(6)));
      case 2:
        return testing::icosahedron();
      case 3:
        return testing::torus(1, 0.4, 12, 8);
      default:
        return soup();
    }
  }
  testing::Polyhedron soup()
  {
    testing::Polyhedron mesh;
    for (int i = 0; i < 12; ++i)
      mesh.positions.push_back(vec3Cast<float>(vector()));
    for (int i = 0; i < 16; ++i) {
      const auto corner = [&] { return static_cast<std::uint32_t>(whole(13)); };
      const std::uint32_t a = corner(), b = corner(), c = corner();
      mesh.triangles.push_back({{a, b, c}});
    }
    return mesh;
  }
  /// Some on a grid, for planes and corners that coincide.
  Mat4d place()
  {
    Mat4d m = Mat4d::identity();
    const bool isOnGrid = whole(2) == 0;
    for (int r = 0; r < 3; ++r) {
      const Vec3d x = vector();
      const double to = 2 * share() - 1;
      double* const row = m.m[r];
      if (!isOnGrid) {
        row[0] = x.x;
        row[1] = x.y;
        row[2] = x.z;
      }
      row[3] = isOnGrid ? std::floor(to * 2) : to * 2;
    }
    return m;
  }

  std::mt19937 random_;
  std::vector<testing::Polyhedron> meshes_;
};

class Hash {
 public:
  void add(const void* data, std::size_t size)
  {
    const auto* const bytes = static_cast<const unsigned char*>(data);
    for (std::size_t i = 0; i < size; ++i)
      value_ = (value_ ^ bytes[i]) * 1099511628211u;
  }
  void add(Vec3d p)
  {
    for (const double value : {p.x + 0.0, p.y + 0.0, p.z + 0.0})
      add(&value, sizeof value);
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 14695981039346656037u;
};

bool same(Vec3d a, Vec3d b)
{
  return std::memcmp(&a, &b, sizeof a) == 0;
}
bool same(const ShadowCaster& a, const ShadowCaster& b)
{
  for (int i = 0; i < 2; ++i)
    if (!same(a.end[i], b.end[i]) || a.place[i] != b.place[i] || a.triangle[i] != b.triangle[i] ||
        a.point[i] != b.point[i])
      return false;
  return a.body == b.body && a.bulgesOut == b.bulgesOut && a.reach == b.reach && a.gap == b.gap;
}
bool same(const ShadowPiece& a, const ShadowPiece& b)
{
  return a.caster == b.caster && a.receiver == b.receiver && a.u0 == b.u0 && a.u1 == b.u1 &&
         same(a.from, b.from) && same(a.to, b.to);
}
bool same(const CutPoint& a, const CutPoint& b)
{
  return a.point[0] == b.point[0] && a.point[1] == b.point[1] && a.triangle == b.triangle &&
         same(a.place, b.place);
}
bool same(const CutPiece& a, const CutPiece& b)
{
  return a.triangle[0] == b.triangle[0] && a.triangle[1] == b.triangle[1] &&
         same(a.end[0], b.end[0]) && same(a.end[1], b.end[1]);
}

template <class Piece>
void expectSame(const std::vector<Piece>& actual, const std::vector<Piece>& expected,
                std::uint32_t seed)
{
  ASSERT_EQ(actual.size(), expected.size()) << "seed " << seed;
  for (std::size_t i = 0; i < actual.size(); ++i)
    ASSERT_TRUE(same(actual[i], expected[i])) << "seed " << seed << ", piece " << i;
}

/// Every so many of the worlds are as fine as they are when they cast shadows.
constexpr std::uint32_t kRefined = 50;

TEST(WorldLines, ShadowsAreLikeTheReferences)
{
  Hash hash;
  std::size_t count = 0, contours = 0;
  for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
    const RandomWorld random(seed);
    WorldMesh world = random.world;
    WorldNormals normals;
    ASSERT_TRUE(worldNormals(world, random.creaseDegrees, 2, normals).ok());
    if (seed % kRefined == 0) {
      RefinedWorld refined = refineWorld(world, normals);
      world = refined.mesh;
      normals = refined.normals;
    }
    const TriangleTree tree(world);
    const auto casters = reference::shadowCasters(world, normals, random.light);
    const auto expected =
        reference::shadowPieces(world, random.light, casters, random.creaseDegrees);
    for (const int threads : {1, 3, 8}) {
      expectSame(shadowCasters(world, normals, random.light, threads), casters, seed);
      expectSame(shadowPieces(world, tree, random.light, casters, random.creaseDegrees, threads),
                 expected, seed);
    }
    for (const ShadowPiece& piece : expected) {
      hash.add(piece.from);
      hash.add(piece.to);
      contours += casters[piece.caster].isContour() ? 1 : 0;
    }
    count += expected.size();
  }
  EXPECT_GT(count, 1000u);
  EXPECT_GT(contours, 1000u);
  std::cout << "kHashOfShadows " << hash.value() << '\n';
  EXPECT_EQ(hash.value(), kHashOfShadows);
}

/// Triangles between random ones of random points, much that shadows much, over a floor that lies
/// in a plane with some of them.
testing::Polyhedron soup(std::mt19937& random, std::uint32_t triangles)
{
  const auto share = [&] { return static_cast<double>(random() >> 8) * 0x1p-24; };
  const std::uint32_t points = triangles / 2;
  const auto corner = [&] {
    return static_cast<std::uint32_t>(share() * static_cast<double>(points));
  };
  testing::Polyhedron mesh = testing::plane(2);
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (std::uint32_t i = 0; i < points; ++i) {
    const double x = 2 * share() - 1, y = 2 * share() - 1, z = i % 4 == 0 ? 0 : share();
    mesh.positions.push_back(vec3Cast<float>(Vec3d{x, y, z}));
  }
  for (std::uint32_t i = 0; i < triangles; ++i) {
    const std::uint32_t a = corner(), b = corner(), c = corner();
    mesh.triangles.push_back({{first + a, first + b, first + c}});
  }
  return mesh;
}

// With many triangles in the way of each ray: what is left out early is never met.
TEST(WorldLines, ShadowsOfSoupAreLikeTheReferences)
{
  Hash hash;
  std::size_t count = 0;
  for (std::uint32_t seed = 0; seed < 12; ++seed) {
    std::mt19937 random(seed);
    const testing::Polyhedron mesh = soup(random, 80), other = soup(random, 40);
    const std::vector<PlacedMesh> placed = {{mesh.view(), Mat4d::identity()},
                                            {other.view(), translation({0, 0, -0.2})}};
    const std::vector<std::uint8_t> wanted = {1, 1};
    const std::vector<double> creaseDegrees(2, seed % 2 == 0 ? 40.0 : 180.0);
    WorldMesh world;
    WorldNormals normals;
    ASSERT_TRUE(buildWorldMesh(placed, wanted, 2, world).ok());
    ASSERT_TRUE(worldNormals(world, creaseDegrees, 2, normals).ok());
    const TriangleTree tree(world);
    LightRays light = testing::sunlight({0.3, 0.2 * seed - 1, -1});
    if (seed % 3 == 1) light = testing::lamp({0.4, -0.2, 0.2 * seed});
    if (seed % 3 == 2) light = {false, {0.5, 0.3, 3}, true, normalized(Vec3d{-0.2, 0, -1}), 0.97};
    auto casters = reference::shadowCasters(world, normals, light);
    // Light goes on through what is nearer to contours: of some of it, and of a body that it cannot
    // end in from inside.
    world.isClosed[0] = seed % 4 == 3 ? 1 : 0;
    for (ShadowCaster& caster : casters)
      if (caster.isContour() && seed % 2 == 1) caster.reach = 0.1 * seed;
    const auto expected = reference::shadowPieces(world, light, casters, creaseDegrees);
    expectSame(shadowPieces(world, tree, light, casters, creaseDegrees, 2), expected, seed);
    for (const ShadowPiece& piece : expected) {
      hash.add(piece.from);
      hash.add(piece.to);
    }
    count += expected.size();
  }
  EXPECT_GT(count, 500u);
  std::cout << "kHashOfSoupShadows " << hash.value() << '\n';
  EXPECT_EQ(hash.value(), kHashOfSoupShadows);
}

TEST(WorldLines, IntersectionsAreLikeTheReferences)
{
  Hash hash;
  std::size_t count = 0;
  for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
    const RandomWorld random(seed);
    const TriangleTree tree(random.world);
    const auto expected = reference::intersections(random.world, random.wanted);
    for (const int threads : {1, 3, 8})
      expectSame(intersections(random.world, tree, random.wanted, threads), expected, seed);
    for (const CutPiece& piece : expected) {
      hash.add(piece.end[0].place);
      hash.add(piece.end[1].place);
    }
    count += expected.size();
  }
  EXPECT_GT(count, 1000u);
  std::cout << "kHashOfIntersections " << hash.value() << '\n';
  EXPECT_EQ(hash.value(), kHashOfIntersections);
}

}  // namespace
}  // namespace limn
