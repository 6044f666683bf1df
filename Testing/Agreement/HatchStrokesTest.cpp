// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Strokes of hatching on lumps of many shapes: the same on any number of threads, and with one hash
// everywhere.
#include "Testing/Unit/HatchedMesh.h"

#include <cstring>
#include <iostream>
#include <random>

namespace limn::testing {
namespace {

constexpr std::uint64_t kHashOfHatchStrokes = 16844368154079709229u;
constexpr int kSeeds = 5;

/// A cube's six grids, rounded by a share and bent, from + - * / and roots alone: libm's cosine is
/// not the same everywhere.
Polyhedron lump(std::uint32_t seed)
{
  std::mt19937 random(seed);
  const auto number = [&](double low, double high) {
    return low + (high - low) * (static_cast<double>(random() >> 8) / 16777216.0);
  };
  const auto cells = static_cast<std::uint32_t>(4 + random() % 12);
  const double round = seed % 4 == 0 ? 0 : number(0, 1), bend = seed % 3 == 0 ? 0 : number(0, 0.4);
  const Vec3d scale = {1, number(0.4, 1), number(0.4, 1.5)};
  Polyhedron mesh;
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) {
      const auto at = [&](double s, double t) {
        const double u = 2 * s - 1, v = (2 * t - 1) * side;
        const Vec3d p = axis == 0   ? Vec3d{side, u, v}
                        : axis == 1 ? Vec3d{v, side, u}
                                    : Vec3d{u, v, side};
        const Vec3d q = p * (1 - round + round / std::sqrt(dot(p, p)));
        return vec3Cast<float>(Vec3d{q.x, q.y + bend * q.x * q.x, q.z} * scale);
      };
      const Polyhedron face = grid(cells, cells, at);
      const auto first = static_cast<std::uint32_t>(mesh.positions.size());
      mesh.positions.insert(mesh.positions.end(), face.positions.begin(), face.positions.end());
      for (const Triangle& t : face.triangles)
        mesh.triangles.push_back({{first + t.vertex[0], first + t.vertex[1], first + t.vertex[2]}});
    }
  return mesh;
}

class Hash {
 public:
  template <class T>
  void add(const std::vector<T>& values)
  {
    std::vector<unsigned char> bytes(values.size() * sizeof(T));
    if (!bytes.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
    for (const unsigned char byte : bytes)
      value_ = (value_ ^ byte) * 1099511628211u;
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 14695981039346656037u;
};

TEST(HatchStrokes, OfRandomLumpsHaveTheKnownHash)
{
  Hash hash;
  std::size_t count = 0, flats = 0;
  for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
    const Hatched hatched(welded(lump(seed)), {}, kSharp);
    const HatchStrokes& strokes = hatched.strokes;
    if (seed % 2 == 1) {
      constexpr int threads = 8;
      const HatchField field = hatchField(hatched.surface(), threads);
      const HatchStrokes again = traceHatching(hatched.surface(), field, threads);
      ASSERT_EQ(again.points.size(), strokes.points.size());
      ASSERT_TRUE(std::equal(again.points.begin(), again.points.end(), strokes.points.begin()));
      ASSERT_EQ(again.rank, strokes.rank);
    }
    hash.add(strokes.points);
    hash.add(strokes.normals);
    hash.add(strokes.across);
    hash.add(strokes.first);
    hash.add(strokes.rank);
    count += strokes.strokeCount();
    flats += hatched.field.flats.regions.size();
  }
  EXPECT_GT(count, 3000u);
  EXPECT_GT(flats, 6u);
  std::cout << "kHashOfHatchStrokes " << hash.value() << '\n';
  EXPECT_EQ(hash.value(), kHashOfHatchStrokes);
}

}  // namespace
}  // namespace limn::testing
