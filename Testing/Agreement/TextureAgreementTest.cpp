// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The vector forms of textures give the bits of the scalar ones, on every instruction set, whatever
// the image, the sampler and the coordinates.
#include "Rendering/Renderer.h"
#include "Testing/Agreement/TextureLanes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace limn {
namespace {

using testing::gradientsByLanes;
using testing::proceduralByLanes;
using testing::sampledByLanes;
using testing::TexturePoint;

class TextureLanes : public ::testing::TestWithParam<std::string> {
 protected:
  void SetUp() override { ASSERT_TRUE(useTarget(GetParam())); }
  void TearDown() override { useTarget(""); }
};

/// The distributions of the standard library are not the same everywhere.
class Draw {
 public:
  explicit Draw(std::uint32_t seed) : engine_(seed) {}

  int below(int end) { return static_cast<int>(engine_() % static_cast<std::uint32_t>(end)); }
  float within(float low, float high)
  {
    return low + (high - low) * (static_cast<float>(engine_() >> 8) / (1 << 24));
  }
  template <class T, std::size_t N>
  T of(const T (&values)[N])
  {
    return values[below(N)];
  }
  std::uint32_t bits() { return static_cast<std::uint32_t>(engine_()); }

 private:
  std::mt19937 engine_;
};

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kOdd[] = {0.0f,   -0.0f,   1.0f,      -1.0f,      2.0f,       1e-10f,     -1e-10f,
                          1e-40f, -1e-40f, 8388609.f, 16777218.f, 3e9f,       -3e9f,      3e38f,
                          -3e38f, kNan,    -kNan,     kInfinity,  -kInfinity, 0.99999994f};

TextureImage randomImage(Draw& draw)
{
  const struct {
    int width, height;
  } sizes[] = {{1, 1}, {1, 7},  {16, 1},  {2, 2},   {3, 5},
               {8, 8}, {13, 9}, {64, 32}, {257, 3}, {61, 100}};
  const auto size = draw.of(sizes);
  const TexelFormat formats[] = {TexelFormat::kUnorm8, TexelFormat::kUnorm16,
                                 TexelFormat::kFloat32};
  const TexelFormat format = draw.of(formats);
  const int components = 1 + draw.below(4);
  const std::size_t count = static_cast<std::size_t>(size.width * size.height * components);
  std::vector<std::uint32_t> bytes(count);
  for (std::uint32_t& word : bytes)
    word = draw.bits();
  if (format == TexelFormat::kFloat32) {
    const float most = draw.below(4) == 0 ? kLargestTexel : 2.0f;
    for (std::uint32_t& word : bytes) {
      const float value = draw.within(-most, most);
      std::memcpy(&word, &value, sizeof word);
    }
  }
  TextureImage image;
  const Status status = image.build(
      {size.width, size.height, components, format, bytes.data(), bytes.size() * sizeof bytes[0]},
      draw.below(4) == 0 ? MipChain::kNone : MipChain::kFull, 1);
  EXPECT_TRUE(status.ok()) << status.message;
  return image;
}

TextureSampler randomSampler(Draw& draw)
{
  const TextureWrap wraps[] = {TextureWrap::kRepeat, TextureWrap::kMirror, TextureWrap::kClamp,
                               TextureWrap::kBorder};
  const TextureFilter filters[] = {TextureFilter::kNearest, TextureFilter::kBilinear,
                                   TextureFilter::kTrilinear, TextureFilter::kTrilinear};
  const int anisotropies[] = {1, 2, 3, 8, 16};
  TextureSampler sampler;
  sampler.wrapU = draw.of(wraps);
  sampler.wrapV = draw.of(wraps);
  sampler.filter = draw.of(filters);
  sampler.maxAnisotropy = draw.of(anisotropies);
  const float most = draw.below(8) == 0 ? kLargestTexel : 1.0f;
  sampler.borderColor = {draw.within(-most, most), draw.within(0, 1), draw.within(0, 1), 0.5f};
  return sampler;
}

std::vector<TexturePoint> randomPoints(Draw& draw, const TextureImage& image)
{
  // One vector's derivatives are often all alike, as a triangle's are.
  const int evenness = draw.below(3);
  const float size = std::exp2(draw.within(-12, 3));
  const auto coordinate = [&](int side) {
    switch (draw.below(8)) {
      case 0:
        return draw.of(kOdd);
      case 1:
        return static_cast<float>(draw.below(4 * side) - side) / static_cast<float>(side);
      case 2:
        return (static_cast<float>(draw.below(4 * side) - side) + 0.5f) / static_cast<float>(side);
      default:
        return draw.within(-3, 4);
    }
  };
  const auto derivative = [&]() {
    if (evenness == 0 && draw.below(6) == 0) return draw.of(kOdd);
    const float own = evenness == 2 ? size : std::exp2(draw.within(-12, 3));
    return draw.within(-own, own);
  };
  std::vector<TexturePoint> points(203);
  for (TexturePoint& p : points)
    p = {{coordinate(image.width()), coordinate(image.height())},
         {derivative(), derivative()},
         {derivative(), derivative()}};
  return points;
}

template <class T>
bool sameBits(const T& a, const T& b)
{
  return std::memcmp(&a, &b, sizeof a) == 0;
}

std::string name(const TextureImage& image, const TextureSampler& sampler, TexturePoint p)
{
  std::ostringstream text;
  text << image.width() << " x " << image.height() << " format " << int(image.format()) << " wraps "
       << int(sampler.wrapU) << ' ' << int(sampler.wrapV) << " filter " << int(sampler.filter)
       << " anisotropy " << sampler.maxAnisotropy << " at " << p.uv.x << ' ' << p.uv.y << " ddx "
       << p.ddx.x << ' ' << p.ddx.y << " ddy " << p.ddy.x << ' ' << p.ddy.y;
  return text.str();
}

TEST_P(TextureLanes, SampleAsTheScalarSampler)
{
  for (std::uint32_t seed = 0; seed < 1500; ++seed) {
    Draw draw(seed);
    const TextureImage image = randomImage(draw);
    const TextureSampler sampler = randomSampler(draw);
    const std::vector<TexturePoint> points = randomPoints(draw, image);
    const std::vector<Vec4f> colors = sampledByLanes(image, sampler, points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const TexturePoint& p = points[i];
      const Vec4f expected = sampleTexture(image, sampler, p.uv, p.ddx, p.ddy);
      ASSERT_TRUE(isFinite(expected)) << name(image, sampler, p);
      ASSERT_TRUE(sameBits(colors[i], expected))
          << "seed " << seed << ", " << name(image, sampler, p) << ": " << colors[i].x << " for "
          << expected.x;
    }
  }
}

TEST_P(TextureLanes, DifferentiateAsTheScalarSampler)
{
  for (std::uint32_t seed = 5000; seed < 6000; ++seed) {
    Draw draw(seed);
    const TextureImage image = randomImage(draw);
    const TextureSampler sampler = randomSampler(draw);
    const std::vector<TexturePoint> points = randomPoints(draw, image);
    const std::vector<Vec2f> gradients = gradientsByLanes(image, sampler, points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const TexturePoint& p = points[i];
      const Vec2f expected = heightGradient(image, sampler, p.uv, p.ddx, p.ddy);
      ASSERT_TRUE(isFinite(expected)) << name(image, sampler, p);
      ASSERT_TRUE(sameBits(gradients[i], expected))
          << "seed " << seed << ", " << name(image, sampler, p) << ": " << gradients[i].x << ' '
          << gradients[i].y << " for " << expected.x << ' ' << expected.y;
    }
  }
}

TEST_P(TextureLanes, ComputeProceduralTexturesAsTheScalarCode)
{
  const ProceduralKind kinds[] = {ProceduralKind::kChecker, ProceduralKind::kWood,
                                  ProceduralKind::kMarble};
  for (std::uint32_t seed = 0; seed < 400; ++seed) {
    Draw draw(seed);
    ProceduralTexture texture;
    texture.kind = draw.of(kinds);
    texture.colorA = {draw.within(0, 1), draw.within(0, 1), 0.25f, 1};
    texture.colorB = {draw.within(0, 1), draw.within(0, 1), 0.75f, 0};
    texture.scale = std::exp2(draw.within(-4, 8));
    texture.turbulence = draw.below(4) == 0 ? 0.0f : std::exp2(draw.within(-4, 3));
    std::vector<Vec3f> points(203);
    const auto coordinate = [&]() {
      return draw.below(8) == 0 ? draw.of(kOdd) : draw.within(-10, 10);
    };
    for (Vec3f& p : points)
      p = {coordinate(), coordinate(), coordinate()};
    const std::vector<Vec4f> colors = proceduralByLanes(texture, points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec4f expected = proceduralColor(texture, points[i]);
      ASSERT_TRUE(isFinite(expected));
      ASSERT_TRUE(sameBits(colors[i], expected))
          << "seed " << seed << " kind " << int(texture.kind) << " at " << points[i].x << ' '
          << points[i].y << ' ' << points[i].z << ": " << colors[i].x << " for " << expected.x;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Targets, TextureLanes, ::testing::ValuesIn(availableTargets()),
                         [](const auto& target) { return target.param; });

}  // namespace
}  // namespace limn
