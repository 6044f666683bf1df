// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Exaggerated shading: normals at several scales against the heat equation's own answers, and what
// is seen against the paper's formula.
#include "Rendering/Mesh/EdgeTable.h"
#include "Rendering/Mesh/SmoothNormals.h"
#include "Testing/Unit/Polyhedra.h"
#include "Testing/Unit/TestScene.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace limn::testing {
namespace {

SmoothNormals smoothed(const OwnedMesh& mesh, const SmoothScales& scales = {}, int threads = 2)
{
  SmoothNormals smooth;
  const Status status = smoothNormals({mesh.view()}, scales, threads, smooth);
  EXPECT_TRUE(status.ok()) << status.message;
  return smooth;
}
/// Of the mesh's own normals.
SmoothNormals smoothedExactly(const OwnedMesh& mesh, const SmoothScales& scales)
{
  SmoothNormals smooth;
  const Status status = smoothNormals({mesh.view(), mesh.vertexNormals}, scales, 2, smooth);
  EXPECT_TRUE(status.ok()) << status.message;
  return smooth;
}

Vec3d normalAt(const SmoothNormals& smooth, std::size_t vertex, int level)
{
  const std::size_t place = vertex * static_cast<std::size_t>(smooth.levels);
  return vec3Cast<double>(unpackedNormal(smooth.packed[place + static_cast<std::size_t>(level)]));
}

/// Angle in radians, for small ones.
double apart(Vec3d a, Vec3d b)
{
  const Vec3d across = cross(a, b);
  return std::sqrt(dot(across, across));
}

/// The waves z = height sin(k x) over -1 to 1, in triangles of 2 / cells.
struct Waves {
  double k, height;

  double slope(double x) const { return height * k * std::cos(k * x); }
  OwnedMesh mesh(std::uint32_t cells) const
  {
    OwnedMesh mesh = sheet({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, cells);
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
      Vec3f& p = mesh.positions[v];
      p.z = static_cast<float>(height * std::sin(k * static_cast<double>(p.x)));
      mesh.vertexNormals[v] =
          vec3Cast<float>(normalized(Vec3d{-slope(static_cast<double>(p.x)), 0, 1}));
    }
    finish(mesh);
    return mesh;
  }
};

/// sigma of the finest level of a sheet of 2 x 2 units.
double meanDistance(std::uint32_t cells)
{
  const double vertices = (cells + 1.0) * (cells + 1.0);
  return std::sqrt(2 * 4 / (std::sqrt(3.0) * vertices));
}

TEST(SmoothNormals, UnitVectorsComeBackFromTheirWord)
{
  double worst = 0, longest = 0;
  for (int i = 0; i < 20000; ++i) {
    // Fibonacci's spiral.
    const double z = 1 - (2 * i + 1) / 20000.0, r = std::sqrt(1 - z * z), turn = 2.399963 * i;
    const Vec3d n = {r * std::cos(turn), r * std::sin(turn), z};
    const Vec3d back = vec3Cast<double>(unpackedNormal(packedNormal(n)));
    worst = std::max(worst, apart(n, back));
    longest = std::max(longest, std::fabs(dot(back, back) - 1));
  }
  EXPECT_LT(worst, 7e-5);
  EXPECT_LT(longest, 5e-7);
  for (const Vec3d axis :
       {Vec3d{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}})
    EXPECT_EQ(vec3Cast<double>(unpackedNormal(packedNormal(axis))), axis);
}

TEST(SmoothNormals, OfAPlaneAreThePlanesOwn)
{
  const OwnedMesh mesh = sheet({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, 40);
  const SmoothNormals smooth = smoothed(mesh, {8, 0.3f});
  EXPECT_EQ(smooth.levels, 8);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    for (int level = 0; level < 8; ++level)
      ASSERT_EQ(normalAt(smooth, v, level), (Vec3d{0, 0, 1})) << v << ' ' << level;
}

TEST(SmoothNormals, OfASphereAreItsOwnByItsSymmetry)
{
  const OwnedMesh& mesh = fineSphere();
  const SmoothNormals smooth = smoothedExactly(mesh, {5, 0.06f});
  double worst = 0, worstAtPoles = 0;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    for (int level = 0; level < 5; ++level) {
      const double angle =
          apart(normalAt(smooth, v, level), vec3Cast<double>(mesh.vertexNormals[v]));
      // There needles meet, and steps that their small areas ask for are bounded.
      double& most = std::fabs(mesh.positions[v].z) < 0.99f ? worst : worstAtPoles;
      most = std::max(most, angle);
    }
  EXPECT_LT(worst, 1.5e-3);
  EXPECT_LT(worstAtPoles, 5e-3);
}

TEST(SmoothNormals, AWaveFadesByTheGaussiansTransform)
{
  constexpr std::uint32_t kCells = 120;
  for (const double k : {8.0, 16.0, 24.0}) {
    const Waves waves = {k, 0.1 / k};
    const OwnedMesh mesh = waves.mesh(kCells);
    const SmoothNormals smooth = smoothedExactly(mesh, {6, 0.06f});
    double sigma = meanDistance(kCells);
    EXPECT_NEAR(sigma * std::pow(static_cast<double>(smooth.ratio), 5), 0.06 * 2, 0.002);
    for (int level = 0; level < 6; ++level) {
      const double factor = std::exp(-k * k * sigma * sigma / 2);
      double worst = 0;
      for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        const Vec3f p = mesh.positions[v];
        // Borders let no heat through, as mirrors: away from them by some sigma.
        if (std::max(std::fabs(p.x), std::fabs(p.y)) > 0.5f) continue;
        const Vec3d n = normalAt(smooth, v, level);
        const double given = -waves.slope(static_cast<double>(p.x));
        worst = std::max(worst, std::fabs(n.x / n.z - given * factor));
      }
      EXPECT_LT(worst, 0.1 * 0.01) << "k " << k << ", level " << level;
      sigma *= static_cast<double>(smooth.ratio);
    }
  }
}

TEST(SmoothNormals, DoNotSeeScalePlaceNorHowVerticesAreShared)
{
  const OwnedMesh mesh = Waves{12, 0.05}.mesh(30);
  const SmoothNormals smooth = smoothed(mesh);
  OwnedMesh large = Waves{12, 0.05}.mesh(30);
  std::vector<Vec3d> corners;
  for (Vec3f& p : large.positions)
    p = p * 1024.0f + Vec3f{4096, 0, 0};
  const SmoothNormals ofLarge = smoothed(large);
  for (const Triangle& triangle : mesh.triangles)
    for (const std::uint32_t v : triangle.vertex)
      corners.push_back(vec3Cast<double>(mesh.positions[v]));
  const OwnedMesh loose = soup(corners);
  const SmoothNormals ofLoose = smoothed(loose);
  EXPECT_EQ(ofLoose.ratio, smooth.ratio);
  std::size_t corner = 0;
  for (const Triangle& triangle : mesh.triangles)
    for (const std::uint32_t v : triangle.vertex) {
      for (int level = 0; level < smooth.levels; ++level) {
        ASSERT_LT(apart(normalAt(ofLarge, v, level), normalAt(smooth, v, level)), 3e-4);
        ASSERT_LT(apart(normalAt(ofLoose, corner, level), normalAt(smooth, v, level)), 1e-4);
      }
      ++corner;
    }
}

TEST(SmoothNormals, AreTheSameOnAnyNumberOfThreads)
{
  const OwnedMesh mesh = Waves{12, 0.05}.mesh(100);
  for (const double creaseDegrees : {180.0, 1.0}) {
    const SmoothScales scales = {3, 0.05f, creaseDegrees};
    const SmoothNormals one = smoothed(mesh, scales, 1);
    EXPECT_EQ(one.ofCorner.empty(), creaseDegrees == 180);
    for (const int threads : {2, 3, 8}) {
      const SmoothNormals many = smoothed(mesh, scales, threads);
      EXPECT_EQ(many.packed, one.packed) << threads;
      EXPECT_EQ(many.ofCorner, one.ofCorner) << threads;
    }
  }
}

/// The cube from -1 to 1 in squares, its vertices shared by all faces or, with normals, by those of
/// one alone.
OwnedMesh boxOfSquares(bool hasNormals)
{
  constexpr std::uint32_t kCells = 6;
  OwnedMesh box;
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) {
      Vec3d n = {0, 0, 0}, u = n, v = n;
      (axis == 0 ? n.x : axis == 1 ? n.y : n.z) = side;
      (axis == 0 ? u.y : axis == 1 ? u.z : u.x) = 2;
      v = cross(n, u);
      const OwnedMesh face = sheet(n - u * 0.5 - v * 0.5, u, v, kCells);
      const auto first = static_cast<std::uint32_t>(box.positions.size());
      box.positions.insert(box.positions.end(), face.positions.begin(), face.positions.end());
      box.vertexNormals.resize(box.positions.size(), vec3Cast<float>(n));
      for (const Triangle& t : face.triangles)
        box.triangles.push_back({{first + t.vertex[0], first + t.vertex[1], first + t.vertex[2]}});
    }
  if (hasNormals) return box;
  EdgeTable table;
  EXPECT_TRUE(buildEdgeTable(box.view(), 0, 1, table).ok());
  for (Triangle& triangle : box.triangles)
    for (std::uint32_t& v : triangle.vertex)
      v = table.place[v];
  box.vertexNormals = vertexNormals(box.view(), NormalWeight::kArea);
  return box;
}

/// Calls visit(triangle, its plane's normal, that of a level at its corner).
template <class Visit>
void forEachCorner(const OwnedMesh& mesh, const SmoothNormals& smooth, const Visit& visit)
{
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& vertex = mesh.triangles[t].vertex;
    const Vec3d p = mesh.view().position(vertex[0]);
    const Vec3d plane =
        normalized(cross(mesh.view().position(vertex[1]) - p, mesh.view().position(vertex[2]) - p));
    for (std::size_t k = 0; k < 3; ++k)
      for (int level = 0; level < smooth.levels; ++level)
        visit(t, plane,
              normalAt(smooth, smooth.ofCorner.empty() ? vertex[k] : smooth.ofCorner[3 * t + k],
                       level));
  }
}

TEST(SmoothNormals, OfACubeApartAtItsEdgesAreItsFacesOwn)
{
  const OwnedMesh box = boxOfSquares(false), loose = boxOfSquares(true);
  const SmoothScales scales = {8, 0.3f, 40};
  std::size_t corners = 0;
  const auto isFacesOwn = [&](std::size_t t, Vec3d plane, Vec3d normal) {
    ASSERT_LT(apart(normal, plane), 1e-9) << t;
    ++corners;
  };
  forEachCorner(box, smoothed(box, scales), isFacesOwn);
  forEachCorner(loose, smoothed(loose, scales), isFacesOwn);
  forEachCorner(loose, smoothedExactly(loose, scales), isFacesOwn);
  EXPECT_EQ(corners, 3u * 6 * 72 * 3 * 8);
  // Six faces of their own vertices.
  EXPECT_EQ(smoothed(box, scales).packed.size(), 6u * 49 * 8);
  // Nothing else holds an edge together.
  std::size_t bent = 0;
  forEachCorner(box, smoothed(box, {8, 0.3f, 95}), [&](std::size_t, Vec3d plane, Vec3d normal) {
    bent += apart(plane, normal) > 0.01;
  });
  EXPECT_GT(bent, 6u * 72 * 3);
}

TEST(SmoothNormals, GivenOnesSayWhereSharpEdgesAreSmooth)
{
  const OwnedMesh box = boxOfSquares(false);
  const SmoothScales scales = {4, 0.05f, 40};
  const SmoothNormals smooth = smoothedExactly(box, scales);
  EXPECT_TRUE(smooth.ofCorner.empty());
  EXPECT_EQ(smooth.packed, smoothedExactly(box, {4, 0.05f}).packed);
}

TEST(SmoothNormals, OfSmoothSurfacesDoNotChangeByWhatWouldBeACrease)
{
  const OwnedMesh& sphere = fineSphere();
  EXPECT_EQ(smoothed(sphere, {5, 0.06f, 40}).packed, smoothed(sphere).packed);
  EXPECT_TRUE(smoothed(sphere, {5, 0.06f, 40}).ofCorner.empty());
  const OwnedMesh waves = Waves{12, 0.05}.mesh(30);
  EXPECT_EQ(smoothed(waves, {5, 0.06f, 40}).packed, smoothed(waves).packed);
}

/// z = h (sin(k x) + sin(k y)) for x > 0, and a wall below its border x = 0.
struct WavesAtAWall {
  static constexpr double kHeight = 0.01, kWave = 12;
  static constexpr std::uint32_t kCells = 60;
  OwnedMesh mesh;

  explicit WavesAtAWall(bool isWallFirst)
  {
    const auto waves = [](double s, double t) {
      const double z = kHeight * (std::sin(2 * kWave * s) + std::sin(kWave * (2 * t - 1)));
      return vec3Cast<float>(Vec3d{2 * s, 2 * t - 1, z});
    };
    const auto wall = [](double s, double t) {
      const double z = kHeight * std::sin(kWave * (2 * t - 1));
      return vec3Cast<float>(Vec3d{0, 2 * t - 1, z + 2 * s - 2});
    };
    for (const bool isWall : {isWallFirst, !isWallFirst}) {
      const Polyhedron part = isWall ? grid(kCells, kCells, wall) : grid(kCells, kCells, waves);
      const auto first = static_cast<std::uint32_t>(mesh.positions.size());
      for (const Vec3f& p : part.positions) {
        mesh.positions.push_back(p);
        mesh.vertexNormals.push_back(vec3Cast<float>(isWall ? Vec3d{-1, 0, 0} : normal(p, 1)));
      }
      for (const Triangle& t : part.triangles)
        mesh.triangles.push_back({{first + t.vertex[0], first + t.vertex[1], first + t.vertex[2]}});
    }
  }
  static Vec3d normal(Vec3f p, double fade)
  {
    const double slope = kHeight * kWave * fade;
    return normalized(Vec3d{-slope * std::cos(kWave * static_cast<double>(p.x)),
                            -slope * std::cos(kWave * static_cast<double>(p.y)), 1});
  }
};

TEST(SmoothNormals, OfAWaveBehindACreaseFadeAsBeforeAMirror)
{
  // The slopes are even about x = 0: no heat would flow over it if the waves went on.
  for (const bool isWallFirst : {false, true}) {
    const OwnedMesh mesh = WavesAtAWall(isWallFirst).mesh;
    const SmoothNormals smooth = smoothedExactly(mesh, {4, 0.03f, 40});
    constexpr double kSide = WavesAtAWall::kCells + 1, kWave = WavesAtAWall::kWave;
    double sigma = std::sqrt(8 / (std::sqrt(3.0) * kSide * kSide));
    for (int level = 0; level < smooth.levels; ++level) {
      for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
          const std::uint32_t v = mesh.triangles[t].vertex[k];
          const Vec3f p = mesh.positions[v];
          const bool isWall = mesh.vertexNormals[v].x < -0.9f;
          if (std::fabs(p.y) > 0.4f || p.x > 0.8f || p.z < -0.8f) continue;
          const Vec3d n = normalAt(smooth, smooth.ofCorner[3 * t + k], level);
          const Vec3d expected =
              isWall ? Vec3d{-1, 0, 0}
                     : WavesAtAWall::normal(p, std::exp(-kWave * kWave * sigma * sigma / 2));
          ASSERT_LT(apart(n, expected), isWall ? 1e-4 : 0.0025) << level << ' ' << p.x;
        }
      sigma *= static_cast<double>(smooth.ratio);
    }
  }
}

TEST(SmoothNormals, TakeNormalsThatAreGivenAndBrokenMeshes)
{
  OwnedMesh mesh = sheet({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, 8);
  const std::vector<Vec3f> down(mesh.positions.size(), Vec3f{0, 0, -3});
  SmoothNormals smooth;
  ASSERT_TRUE(smoothNormals({mesh.view(), down}, {2, 0.05f}, 1, smooth).ok());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    EXPECT_EQ(normalAt(smooth, v, 1), (Vec3d{0, 0, -1}));
  // One vertex nowhere, a triangle without a vertex, one without an area.
  mesh.positions[0].x = std::nanf("");
  mesh.triangles.push_back({{0, 1, 4000}});
  mesh.triangles.push_back({{7, 7, 8}});
  smooth = smoothed(mesh);
  for (std::size_t v = 1; v < mesh.positions.size(); ++v)
    EXPECT_EQ(normalAt(smooth, v, 4), (Vec3d{0, 0, 1})) << v;
  EXPECT_TRUE(smoothed(OwnedMesh()).packed.empty());
}

class Exaggerations : public BothBackends {};
LIMN_ON_BOTH_BACKENDS(Exaggerations);

/// A surface of k_d = 1 under exaggerated shading and one directional light.
struct ExaggeratedStage {
  SmoothNormals smooth;
  Stage stage;

  ExaggeratedStage(const OwnedMesh& mesh, Vec3d towardLight, const SmoothScales& scales = {})
      : smooth(smoothed(mesh, scales))
  {
    stage.view.parallel = true;
    stage.instances = {instanceOf(mesh)};
    instance().style.tone = Tone::kExaggerated;
    instance().attributes.smoothNormals = smooth.packed;
    instance().attributes.smoothOfCorner = smooth.ofCorner;
    instance().attributes.smoothCount = smooth.count();
    instance().attributes.smoothLevels = smooth.levels;
    instance().attributes.smoothRatio = smooth.ratio;
    Light light;
    light.kind = LightKind::kDirectional;
    light.direction = -towardLight;
    stage.lights = {light};
  }
  Instance& instance() { return stage.instances[0]; }
  Exaggeration& exaggeration() { return instance().style.exaggeration; }
};

Vec3d grey(double c)
{
  return {c, c, c};
}

TEST_P(Exaggerations, APlaneHasItsBaseAndNoDetailWhateverTheExponentAndTheContrast)
{
  const Vec3d tilt = normalized(Vec3d{0.3, -0.2, 1}), l = normalized(Vec3d{1, 2, 0.5});
  const OwnedMesh mesh = sheet({-3, -3, 0.3}, {6, 0, -1.8}, {0, 6, 1.2}, 12);
  ExaggeratedStage plane(mesh, l);
  for (const float exponent : {1.0f, 0.0f, -1.0f, -2.0f})
    for (const float contrast : {0.0f, 5.0f, 20.0f}) {
      plane.exaggeration() = {contrast, exponent, 0.4f};
      const double c = 0.4 * (0.5 + 0.5 * dot(tilt, l)) + 0.6 * 0.5;
      const Picture picture = draw(plane.stage);
      for (const Rgba8 color : picture.color)
        // A word's 5e-5 times half the contrast.
        ASSERT_NEAR(color.g, 255 * c, kRounding + 255 * 5e-5 * contrast) << exponent;
    }
}

TEST_P(Exaggerations, ASphereHasItsBaseAsAllItsNormalsAreOne)
{
  const Vec3d l = normalized(Vec3d{-1, 1, 0.4});
  ExaggeratedStage sphere(fineSphere(), l, {4, 0.05f});
  sphere.exaggeration() = {2, -1, 0.5f};
  const auto tone = [&](const Hit& hit) {
    return grey(0.5 * (0.5 + 0.5 * dot(hit.normal, l)) + 0.25);
  };
  // Half of the contrast's share times what the normals of scales are off.
  expectPicture(sphere.stage, draw(sphere.stage), hitSphere, tone,
                kRounding + kFacets + 255 * 0.5 * 2e-3);
}

TEST_P(Exaggerations, EachFaceOfACubeHasOneColorWhereItsEdgesAreSharp)
{
  OwnedMesh box = boxOfSquares(false);
  finish(box);
  const Vec3d l = normalized(Vec3d{0.3, -0.7, 0.9});
  ExaggeratedStage cube(box, l, {5, 0.1f, 40});
  SplitNormals split;
  ASSERT_TRUE(splitVertexNormals(box.view(), {}, NormalWeight::kArea, 40, 1, split).ok());
  cube.stage.view = perspectiveView({3, -4, 3.5}, {0, 0, 0}, 30);
  Attributes& attributes = cube.instance().attributes;
  attributes.vertexNormals = split.normals;
  attributes.normalOfCorner = split.ofCorner;
  for (const ShadingFrequency frequency :
       {ShadingFrequency::kPhong, ShadingFrequency::kGouraud, ShadingFrequency::kFlat}) {
    cube.instance().style.frequency = frequency;
    const Picture picture = draw(cube.stage);
    std::size_t seen = 0;
    for (std::size_t i = 0; i < picture.color.size(); ++i) {
      if (picture.coverage[i] == 0) continue;
      const auto& vertex = box.triangles[picture.cell[i]].vertex;
      const Vec3d p = box.view().position(vertex[0]);
      const Vec3d n =
          normalized(cross(box.view().position(vertex[1]) - p, box.view().position(vertex[2]) - p));
      ASSERT_NEAR(picture.color[i].g, 255 * (0.4 * (0.5 + 0.5 * dot(n, l)) + 0.3), kRounding + 0.1);
      ++seen;
    }
    EXPECT_GT(seen, 1000u);
  }
}

TEST_P(Exaggerations, WithoutContrastOnlyTheBaseIsLeft)
{
  const OwnedMesh mesh = Waves{12, 0.05}.mesh(40);
  ExaggeratedStage waves(mesh, {1, 0, 1});
  waves.stage.view.halfHeight = 0.9;
  waves.exaggeration() = {0, -1, 0};
  const Picture picture = draw(waves.stage);
  for (const Rgba8 color : picture.color)
    ASSERT_NEAR(color.g, 127.5, kRounding);
}

/// c of the paper, from normals given one by one, the surface's own first.
double paperTone(const std::vector<Vec3d>& normals, Vec3d l, double ratio, const Exaggeration& e)
{
  const std::size_t levels = normals.size() - 1;
  double weights = 0, sum = 0;
  for (std::size_t i = 0; i < levels; ++i) {
    const Vec3d n = normals[i], coarser = normals[i + 1];
    const Vec3d across = l - coarser * dot(l, coarser);
    const Vec3d grazing = across * (1 / std::max(std::sqrt(dot(across, across)), 0.25));
    const double sigma = std::pow(ratio, static_cast<double>(i));
    const double k = std::pow(sigma, static_cast<double>(e.exponent));
    const double a = static_cast<double>(e.contrast) * dot(n, grazing);
    sum += k * (0.5 + 0.5 * std::clamp(a, -1.0, 1.0));
    weights += k;
  }
  const double base = static_cast<double>(e.base);
  return base * (0.5 + 0.5 * dot(normals.back(), l)) + (1 - base) * sum / weights;
}

TEST_P(Exaggerations, WavesAreThePapersFormula)
{
  constexpr std::uint32_t kCells = 160;
  const Waves shape = {14, 0.1 / 14};
  const OwnedMesh mesh = shape.mesh(kCells);
  const SmoothScales scales = {4, 0.05f};
  for (const Vec3d l : {normalized(Vec3d{1, 0.5, 0.2}), normalized(Vec3d{-1, 1, 3}),
                        normalized(Vec3d{0.1, 0.1, 1})})
    for (const Exaggeration e :
         {Exaggeration{6, -1, 0.3f}, {3, 1, 0.1f}, {12, -2, 0}, {8, 0.5f, 1}}) {
      ExaggeratedStage waves(mesh, l, scales);
      waves.stage.view.halfHeight = 0.5;
      waves.exaggeration() = e;
      const Picture picture = draw(waves.stage);
      const auto ratio = static_cast<double>(waves.smooth.ratio);
      for (int x = 0; x < picture.width; ++x) {
        const double at = ((x + 0.5) / picture.width - 0.5);
        std::vector<Vec3d> normals;
        double sigma = 0;
        for (int i = 0; i <= scales.levels; ++i) {
          const double factor = std::exp(-shape.k * shape.k * sigma * sigma / 2);
          normals.push_back(normalized(Vec3d{-shape.slope(at) * factor, 0, 1}));
          sigma = sigma > 0 ? sigma * ratio : meanDistance(kCells);
        }
        const double c = paperTone(normals, l, ratio, e);
        // A hundredth of the slope times half of the contrast.
        ASSERT_NEAR(testing::at(picture, x, 40).g, 255 * c, 1 + 255 * 0.0005 * e.contrast)
            << "x " << x << ", contrast " << e.contrast;
      }
    }
}

TEST_P(Exaggerations, TheInsideIsShadedByItsOwnSide)
{
  const Vec3d l = normalized(Vec3d{0.4, 0.3, 1});
  const OwnedMesh front = sheet({-3, -3, 0}, {6, 0, 0}, {0, 6, 0}, 4);
  const OwnedMesh back = sheet({-3, -3, 0}, {0, 6, 0}, {6, 0, 0}, 4);
  ExaggeratedStage outside(front, l), inside(back, l);
  const double c = 0.4 * (0.5 + 0.5 * l.z) + 0.3;
  for (ExaggeratedStage* side : {&outside, &inside})
    EXPECT_NEAR(at(draw(side->stage), 40, 40).g, 255 * c, kRounding + 0.1);
}

TEST_P(Exaggerations, ColorsOfDataKeepTheirHueOrGetAnUndertone)
{
  const Vec3d l = normalized(Vec3d{1, 0, 1});
  OwnedMesh mesh = sheet({-3, -3, 0}, {6, 0, 0}, {0, 6, 0}, 4);
  mesh.vertexColors.assign(mesh.positions.size(), {200, 100, 50, 255});
  ExaggeratedStage plane(mesh, l);
  plane.exaggeration() = {5, -1, 1};
  const double c = 0.5 + 0.5 / std::sqrt(2);
  Style& style = plane.instance().style;
  EXPECT_NEAR(at(draw(plane.stage), 40, 40).g, 100 * c, kRounding + 0.01);
  style.toneOverData = ToneOverData::kUndertone;
  style.undertone = 0.5f;
  EXPECT_NEAR(at(draw(plane.stage), 40, 40).g, 0.5 * 100 + 0.5 * 255 * c / 2, kRounding + 0.01);
  // L* is told apart by where it ends: as another tone of the same l.n has it.
  style.toneOverData = ToneOverData::kLegendSafe;
  const Rgba8 safe = at(draw(plane.stage), 40, 40);
  style.tone = Tone::kGooch;
  const Rgba8 gooch = at(draw(plane.stage), 40, 40);
  EXPECT_EQ(safe.r, gooch.r);
  EXPECT_EQ(safe.g, gooch.g);
  EXPECT_EQ(safe.b, gooch.b);
  EXPECT_GT(safe.g, 100);
}

TEST_P(Exaggerations, StepsAreWherePlainTonesPassTheirEdges)
{
  const OwnedMesh mesh = Waves{10, 0.1}.mesh(80);
  ExaggeratedStage waves(mesh, {1, 0, 1});
  waves.stage.view.halfHeight = 0.8;
  const Picture plain = draw(waves.stage);
  waves.instance().style.toonBands = 3;
  const Picture steps = draw(waves.stage);
  int between = 0;
  for (std::size_t i = 0; i < steps.color.size(); ++i) {
    const int band = std::min(plain.color[i].g * 3 / 255, 2);
    const int expected = band * 255 / 2;
    // At an edge a pixel is a mixture.
    if (std::abs(steps.color[i].g - expected) > 1) ++between;
  }
  EXPECT_GT(between, 0);
  EXPECT_LT(between, static_cast<int>(steps.color.size()) / 4);
}

TEST_P(Exaggerations, EachPixelIsLitWithGouraudTooAndFacesHaveTheirOwnNormal)
{
  const OwnedMesh mesh = Waves{9, 0.1}.mesh(20);
  ExaggeratedStage waves(mesh, {1, 1, 1});
  waves.stage.view.halfHeight = 0.8;
  const Picture phong = draw(waves.stage);
  Style& style = waves.instance().style;
  style.frequency = ShadingFrequency::kGouraud;
  EXPECT_EQ(draw(waves.stage).differingPixels(phong), 0u);
  style.frequency = ShadingFrequency::kPhong;
  style.normals = NormalSource::kTriangle;
  const Picture facets = draw(waves.stage);
  EXPECT_GT(facets.differingPixels(phong), 1000u);
  // Triangles of two to a face, which is no plane's: the face's normal is the mean of theirs.
  style.frequency = ShadingFrequency::kFlat;
  EXPECT_GT(draw(waves.stage).differingPixels(phong), 1000u);
}

}  // namespace
}  // namespace limn::testing
