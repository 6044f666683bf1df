// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Textures on meshes, pixel by pixel against what rays see: the mip level on a tilted plane by the
// analytic footprint, and a sphere without a seam.
#include "Testing/Unit/TestScene.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

using testing::Hit;
using testing::OwnedMesh;
using testing::Picture;
using testing::Stage;

constexpr double kPi = 3.14159265358979323846;

TextureImage imageOf(int width, int height, const std::function<double(int, int)>& red)
{
  std::vector<float> texels;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      texels.push_back(static_cast<float>(red(x, y)));
  TextureImage image;
  const Status status = image.build(
      {width, height, 1, TexelFormat::kFloat32, texels.data(), texels.size() * sizeof(float)},
      MipChain::kFull);
  EXPECT_TRUE(status.ok()) << status.message;
  return image;
}

/// What one pixel sees of a surface, in texels.
struct Footprint {
  double x;                ///< of the pixel's centre, across the stripes
  double longer, shorter;  ///< lengths of the steps to the next pixel and to the next row
  double longerX;          ///< x of the longer step
};

/// Stripes of 2^k texels, black and white by turns, along y, and what trilinear filtering makes of
/// them: level k is texel by texel black and white, the levels above it are grey.
class Stripes {
 public:
  static constexpr int kSide = 64;
  TextureImage image;

  explicit Stripes(int k)
      : image(imageOf(kSide, kSide, [k](int x, int) { return (x >> k) & 1; })), k_(k)
  {
  }

  double trilinear(double x, double level) const
  {
    if (!(level > 0)) return bilinear(x, 0);
    const int finer = static_cast<int>(level);
    const double weight = level - finer;
    return (1 - weight) * bilinear(x, finer) + weight * bilinear(x, finer + 1);
  }

 private:
  double texel(double i, int level) const
  {
    if (level > k_) return 0.5;
    const double stripe = std::floor(i / std::exp2(k_ - level));
    return stripe - 2 * std::floor(stripe / 2);
  }
  double bilinear(double x, int level) const
  {
    const double position = x / std::exp2(level) - 0.5;
    const double first = std::floor(position);
    const double weight = position - first;
    return (1 - weight) * texel(first, level) + weight * texel(first + 1, level);
  }

  int k_;
};

/// A plane seen at a low angle, kTexels texels a unit, so that rows of pixels are on levels 0 to 4.
class TiltedPlane : public testing::BothBackends {
 protected:
  static constexpr double kTexels = 30;

  TiltedPlane() : mesh_(testing::sheet({-8, -4, 0}, {16, 0, 0}, {0, 16, 0}, 4))
  {
    for (const Vec3f p : mesh_.positions)
      uv_.push_back(Vec2f{p.x, p.y} * static_cast<float>(kTexels / Stripes::kSide));
    stage_.view = testing::perspectiveView({0, -4, 2}, {0, 1, 0}, 50, {0.5, 40});
    stage_.instances = {testing::painted(mesh_, {1, 1, 1})};
    stage_.instances[0].attributes.uv = uv_;
  }

  /// From rays through this pixel's centre and its neighbours', to the right and above.
  std::optional<Footprint> footprint(const Hit& hit) const
  {
    const Vec3d window = stage_.project(hit.position);
    const auto right = testing::hitPlane(stage_.ray(window.x + 1, window.y));
    const auto above = testing::hitPlane(stage_.ray(window.x, window.y + 1));
    if (!right || !above) return std::nullopt;
    const Vec3d ddx = (right->position - hit.position) * kTexels;
    const Vec3d ddy = (above->position - hit.position) * kTexels;
    const double dx = std::hypot(ddx.x, ddx.y), dy = std::hypot(ddy.x, ddy.y);
    return Footprint{hit.position.x * kTexels, std::max(dx, dy), std::min(dx, dy),
                     dx > dy ? ddx.x : ddy.x};
  }

  void expectStripes(int k, int anisotropy,
                     const std::function<std::optional<double>(const Footprint&)>& value)
  {
    TextureLayer layer;
    const Stripes stripes(k);
    layer.image = &stripes.image;
    layer.sampler.filter = TextureFilter::kTrilinear;
    layer.sampler.maxAnisotropy = anisotropy;
    stage_.instances[0].layers = {&layer, 1};
    const auto equation = [&](const Hit& hit) -> std::optional<Vec3d> {
      const auto seen = footprint(hit);
      const auto red = seen ? value(*seen) : std::nullopt;
      if (!red) return std::nullopt;
      return Vec3d{*red, *red, *red};
    };
    // Corners snap to 1/256 of a pixel, which moves textures by less than 1/255 of a texel, and by
    // that a stripe's steepest flank climbs one byte.
    testing::expectPicture(stage_, draw(stage_), testing::hitPlane, equation,
                           testing::kRounding + 1.0);
  }

  OwnedMesh mesh_;
  std::vector<Vec2f> uv_;
  Stage stage_;
};

TEST_P(TiltedPlane, ReadsTheMipLevelOfTheAnalyticFootprint)
{
  for (const int k : {0, 1, 2, 3}) {
    const Stripes stripes(k);
    double least = 9, most = 0;
    expectStripes(k, 1, [&](const Footprint& seen) -> std::optional<double> {
      const double level = std::log2(seen.longer);
      least = std::min(least, level);
      most = std::max(most, level);
      return stripes.trilinear(seen.x, level);
    });
    EXPECT_LT(least, 0.5);
    EXPECT_GT(most, 2.5);
  }
}

TEST_P(TiltedPlane, IsSharperWithProbesAlongTheLongerAxis)
{
  for (const int anisotropy : {2, 16})
    for (const int k : {0, 1, 2}) {
      const Stripes stripes(k);
      expectStripes(k, anisotropy, [&](const Footprint& seen) -> std::optional<double> {
        const double ratio = seen.longer / std::max(seen.shorter, 1.0);
        // Where rounding decides how many probes there are.
        if (std::fabs(ratio - std::round(ratio)) < 1e-3) return std::nullopt;
        const double probes = std::min(std::max(std::ceil(ratio), 1.0), double(anisotropy));
        double sum = 0;
        for (double i = 1; i <= probes; ++i)
          sum += stripes.trilinear(seen.x + (i / (probes + 1) - 0.5) * seen.longerX,
                                   std::log2(seen.longer / probes));
        return sum / probes;
      });
    }
}

LIMN_ON_BOTH_BACKENDS(TiltedPlane);

/// A unit sphere whose texture goes once round the y axis, from u = 0 in front.
struct Globe {
  static constexpr std::uint32_t kColumns = 128, kRows = 64;
  OwnedMesh mesh;
  std::vector<Vec2f> uv;
};

/// Where the texture meets itself there are two columns of points, one with u = 0 and one with
/// u = 1; if `isWelded` it is one, and u falls back to 0 within a column of faces.
Globe globe(bool isWelded)
{
  Globe globe;
  const std::uint32_t columns = Globe::kColumns + (isWelded ? 0 : 1);
  for (std::uint32_t row = 0; row <= Globe::kRows; ++row)
    for (std::uint32_t column = 0; column < columns; ++column) {
      const double u = static_cast<double>(column) / Globe::kColumns;
      const double v = static_cast<double>(row) / Globe::kRows;
      const double radius = std::sin(kPi * v);
      const Vec3f p = vec3Cast<float>(Vec3d{radius * std::sin(2 * kPi * u), -std::cos(kPi * v),
                                            radius * std::cos(2 * kPi * u)});
      globe.mesh.positions.push_back(p);
      globe.mesh.vertexNormals.push_back(p);
      globe.uv.push_back({static_cast<float>(u), static_cast<float>(v)});
    }
  for (std::uint32_t row = 0; row < Globe::kRows; ++row)
    for (std::uint32_t column = 0; column < Globe::kColumns; ++column) {
      const std::uint32_t a = row * columns + column, b = row * columns + (column + 1) % columns;
      globe.mesh.triangles.push_back({{a, b, b + columns}});
      globe.mesh.triangles.push_back({{a, b + columns, a + columns}});
    }
  testing::finish(globe.mesh);
  return globe;
}

class SeamOfASphere : public testing::BothBackends {
 protected:
  static constexpr double kWaves = 5;

  /// White at the seam, in front.
  static double value(double u) { return 0.5 + 0.5 * std::cos(2 * kPi * kWaves * u); }

  /// Pixels that are more than `tolerance` bytes from the wave.
  int wrongPixels(const Globe& globe, const TextureSampler& sampler) const
  {
    const TextureImage image = imageOf(256, 4, [](int x, int) { return value((x + 0.5) / 256); });
    TextureLayer layer;
    layer.image = &image;
    layer.sampler = sampler;
    Stage stage;
    stage.view = testing::perspectiveView({0, 0, 3}, {0, 0, 0}, 45);
    stage.instances = {testing::painted(globe.mesh, {1, 1, 1})};
    stage.instances[0].attributes.uv = globe.uv;
    stage.instances[0].layers = {&layer, 1};
    const Picture picture = draw(stage);
    constexpr double kTolerance = 4;
    int wrong = 0, compared = 0;
    for (int y = 0; y < stage.height; ++y)
      for (int x = 0; x < stage.width; ++x) {
        const auto hit = testing::hitSphere(stage.ray(x + 0.5, y + 0.5));
        // Near the poles a column of faces is a triangle, over which u is not linear.
        if (!hit || dot(hit->normal, hit->towardEye) < 0.4 || std::fabs(hit->position.y) > 0.9)
          continue;
        const double u = std::atan2(hit->position.x, hit->position.z) / (2 * kPi);
        const double difference = testing::at(picture, x, y).r - 255 * value(u);
        wrong += std::fabs(difference) > kTolerance ? 1 : 0;
        ++compared;
      }
    EXPECT_GT(compared, 2000);
    return wrong;
  }
};

TEST_P(SeamOfASphere, IsNotSeen)
{
  const Globe whole = globe(/*isWelded=*/false);
  for (const TextureFilter filter : {TextureFilter::kBilinear, TextureFilter::kTrilinear})
    for (const int anisotropy : {1, 16}) {
      TextureSampler sampler;
      sampler.filter = filter;
      sampler.maxAnisotropy = anisotropy;
      EXPECT_EQ(wrongPixels(whole, sampler), 0) << static_cast<int>(filter) << ' ' << anisotropy;
    }
}

TEST_P(SeamOfASphere, IsSeenWhereTheMeshIsWeldedAcrossIt)
{
  TextureSampler sampler;
  sampler.filter = TextureFilter::kTrilinear;
  EXPECT_GT(wrongPixels(globe(/*isWelded=*/true), sampler), 50);
}

LIMN_ON_BOTH_BACKENDS(SeamOfASphere);

}  // namespace
}  // namespace limn
