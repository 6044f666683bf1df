// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Textures against closed forms. Testing/Agreement/TextureAgreementTest.cpp holds the vector form
// to the scalar one.
#include "Rendering/Texture/SampleTexture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

namespace limn {
namespace {

constexpr Vec2f kNoMove = {0, 0};
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// Of floats, red by place.
TextureImage imageOf(int width, int height, const std::function<float(int, int)>& red)
{
  std::vector<float> texels;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      texels.push_back(red(x, y));
  TextureImage image;
  const Status status = image.build(
      {width, height, 1, TexelFormat::kFloat32, texels.data(), texels.size() * sizeof(float)},
      MipChain::kFull);
  EXPECT_TRUE(status.ok()) << status.message;
  return image;
}

float column(int x, int)
{
  return static_cast<float>(x);
}

TextureSampler samplerOf(TextureFilter filter, TextureWrap wrap = TextureWrap::kRepeat,
                         int anisotropy = 1)
{
  return {wrap, wrap, filter, anisotropy, {-7, -8, -9, -10}};
}

float red(const TextureImage& image, const TextureSampler& sampler, Vec2f uv, Vec2f ddx = kNoMove,
          Vec2f ddy = kNoMove)
{
  return sampleTexture(image, sampler, uv, ddx, ddy).x;
}

TEST(NearestFilter, ShowsTheTexelThatHoldsTheCoordinate)
{
  const TextureImage image =
      imageOf(4, 2, [](int x, int y) { return static_cast<float>(10 * y + x); });
  const TextureSampler sampler = samplerOf(TextureFilter::kNearest);
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 4; ++x)
      for (const float within : {0.0f, 0.5f, 0.99f})
        EXPECT_EQ(red(image, sampler,
                      {(static_cast<float>(x) + within) / 4, (static_cast<float>(y) + within) / 2}),
                  static_cast<float>(10 * y + x));
}

TEST(BilinearFilter, ReproducesALinearRampExactly)
{
  const TextureImage image =
      imageOf(16, 8, [](int x, int y) { return static_cast<float>(3 * x - 5 * y); });
  const TextureSampler sampler = samplerOf(TextureFilter::kBilinear);
  // All numbers are short binary fractions.
  for (int y = 32; y <= 8 * 64 - 32; y += 7)
    for (int x = 32; x <= 16 * 64 - 32; x += 5) {
      const float tx = static_cast<float>(x) / 64, ty = static_cast<float>(y) / 64;
      ASSERT_EQ(red(image, sampler, {tx / 16, ty / 8}), 3 * (tx - 0.5f) - 5 * (ty - 0.5f));
    }
}

TEST(Filters, WithoutAChainReadLevelZeroWhateverTheFootprint)
{
  const TextureImage image = imageOf(16, 16, [](int x, int y) { return float((x ^ y) & 1); });
  for (const TextureFilter filter : {TextureFilter::kNearest, TextureFilter::kBilinear})
    for (const float move : {0.1f, 10.0f, kInfinity})
      for (const float u : {0.03f, 0.31f, 0.77f})
        EXPECT_EQ(red(image, samplerOf(filter), {u, u}, {move, 0}, {0, move}),
                  red(image, samplerOf(filter), {u, u}));
}

TEST(Filters, GiveWhiteAsExactlyOneAndCodesToTheLastBit)
{
  for (const TexelFormat format : {TexelFormat::kUnorm8, TexelFormat::kUnorm16}) {
    const bool isByte = format == TexelFormat::kUnorm8;
    const int most = isByte ? 255 : 65535;
    for (int code = 0; code <= most; code += isByte ? 1 : 257) {
      const auto byte = static_cast<std::uint8_t>(code);
      const auto word = static_cast<std::uint16_t>(code);
      TextureImage image;
      const void* texel = isByte ? static_cast<const void*>(&byte) : &word;
      ASSERT_TRUE(image.build({1, 1, 1, format, texel, 2}, MipChain::kFull).ok());
      const float exact = static_cast<float>(code) / static_cast<float>(most);
      const float value = red(image, samplerOf(TextureFilter::kBilinear), {0.3f, 0.6f});
      EXPECT_NEAR(value, exact, exact * 1.2e-7f);
      if (code == 0 || code == most) {
        EXPECT_EQ(value, exact);
      }
    }
  }
}

constexpr float kSomeU[] = {0.0f, 0.0625f, 0.3125f, 0.5f, 0.71875f, 0.96875f};

TEST(Wraps, RepeatHasPeriodOne)
{
  const TextureImage image = imageOf(8, 8, [](int x, int y) { return float(x * x + 3 * y); });
  for (const TextureFilter filter : {TextureFilter::kNearest, TextureFilter::kBilinear})
    for (const float u : kSomeU)
      for (const float whole : {-1000.0f, -1.0f, 1.0f, 7.0f, 4096.0f})
        for (const float v : {0.25f, 0.8125f})
          EXPECT_EQ(red(image, samplerOf(filter), {u + whole, v - whole}),
                    red(image, samplerOf(filter), {u, v}))
              << u << ' ' << whole;
}

TEST(Wraps, RepeatBlendsTheLastTexelWithTheFirst)
{
  const TextureImage image = imageOf(4, 1, column);
  const TextureSampler sampler = samplerOf(TextureFilter::kBilinear);
  EXPECT_EQ(red(image, sampler, {0, 0}), 1.5f);
  EXPECT_EQ(red(image, sampler, {1, 0}), 1.5f);
  EXPECT_EQ(red(image, sampler, {-1e-20f, 0}), 1.5f) << "its fractional part rounds to 1";
  EXPECT_EQ(red(image, samplerOf(TextureFilter::kNearest), {-1e-20f, 0}), 0.0f);
}

TEST(Wraps, MirrorIsEvenAboutEveryWholeNumber)
{
  const TextureImage image = imageOf(8, 8, [](int x, int y) { return float(x * x + 3 * y); });
  const TextureSampler sampler = samplerOf(TextureFilter::kBilinear, TextureWrap::kMirror);
  for (const float u : kSomeU)
    for (const float whole : {-6.0f, -1.0f, 0.0f, 1.0f, 3.0f}) {
      EXPECT_EQ(red(image, sampler, {whole + u, 0.25f}), red(image, sampler, {whole - u, 0.25f}));
      EXPECT_EQ(red(image, sampler, {0.25f, whole + u}), red(image, sampler, {0.25f, whole - u}));
      EXPECT_EQ(red(image, sampler, {u + 2, u}), red(image, sampler, {u, u}));
    }
  const TextureSampler repeat = samplerOf(TextureFilter::kBilinear);
  EXPECT_EQ(red(image, sampler, {0.5f, 0.5f}), red(image, repeat, {0.5f, 0.5f}));
  EXPECT_NE(red(image, sampler, {1.25f, 0.5f}), red(image, repeat, {1.25f, 0.5f}));
}

TEST(Wraps, ClampHoldsTheEdge)
{
  const TextureImage image = imageOf(4, 1, column);
  const TextureSampler sampler = samplerOf(TextureFilter::kBilinear, TextureWrap::kClamp);
  for (const float u : {-1e38f, -100.0f, -0.01f, 0.0f, 0.125f})
    EXPECT_EQ(red(image, sampler, {u, 0.5f}), 0.0f) << u;
  for (const float u : {0.875f, 1.0f, 1.3f, 1e38f})
    EXPECT_EQ(red(image, sampler, {u, 0.5f}), 3.0f) << u;
  EXPECT_EQ(red(image, sampler, {0.5f, 0.5f}), 1.5f);
}

TEST(Wraps, BorderBlendsWithinHalfATexelOfTheEdge)
{
  const TextureImage image = imageOf(4, 4, [](int, int) { return 1.0f; });
  const TextureSampler sampler = samplerOf(TextureFilter::kBilinear, TextureWrap::kBorder);
  EXPECT_EQ(red(image, sampler, {0.125f, 0.5f}), 1.0f);
  EXPECT_EQ(red(image, sampler, {0.0f, 0.5f}), 0.5f * (1 - 7));
  EXPECT_EQ(red(image, sampler, {1.0f, 0.5f}), 0.5f * (1 - 7));
  for (const float u : {-0.125f, -1.0f, -1e30f, 1.125f, 2.0f, 3e38f}) {
    EXPECT_EQ(sampleTexture(image, sampler, {u, 0.5f}, kNoMove, kNoMove), sampler.borderColor) << u;
    EXPECT_EQ(sampleTexture(image, sampler, {0.5f, u}, kNoMove, kNoMove), sampler.borderColor) << u;
  }
  EXPECT_EQ(red(image, samplerOf(TextureFilter::kNearest, TextureWrap::kBorder), {-0.01f, 0.5f}),
            -7.0f);
  EXPECT_EQ(red(image, samplerOf(TextureFilter::kNearest, TextureWrap::kBorder), {0.99f, 0.5f}),
            1.0f);
}

TEST(Wraps, ACoordinateThatIsNotFiniteCountsAsZero)
{
  const TextureImage image = imageOf(8, 8, [](int x, int y) { return float(1 + x + 10 * y); });
  for (const TextureWrap wrap :
       {TextureWrap::kRepeat, TextureWrap::kMirror, TextureWrap::kClamp, TextureWrap::kBorder})
    for (const float wrong : {kNan, kInfinity, -kInfinity}) {
      const TextureSampler sampler = samplerOf(TextureFilter::kTrilinear, wrap, 16);
      EXPECT_EQ(red(image, sampler, {wrong, 0.3f}), red(image, sampler, {0, 0.3f}));
      EXPECT_EQ(red(image, sampler, {0.3f, wrong}), red(image, sampler, {0.3f, 0}));
      EXPECT_EQ(red(image, sampler, {0.3f, 0.4f}, {wrong, 0.5f}, {0.1f, wrong}),
                red(image, sampler, {0.3f, 0.4f}, {0, 0.5f}, {0.1f, 0}));
    }
}

TEST(Wraps, ReduceExactlyHoweverFar)
{
  const TextureImage image = imageOf(8, 1, column);
  const TextureSampler sampler = samplerOf(TextureFilter::kNearest);
  EXPECT_EQ(red(image, sampler, {2097152.25f, 0}), 2.0f);
  EXPECT_EQ(red(image, sampler, {-2097152.25f, 0}), 6.0f);
  EXPECT_EQ(red(image, sampler, {8388609.0f, 0}), 0.0f) << "from 2^23 on all are whole";
  EXPECT_EQ(red(image, sampler, {3e38f, 0}), 0.0f);
}

/// Red is (x + 1/2)^2. A texel of level k is the mean of 2^k such, c^2 + (4^k - 1) / 12 at its
/// centre c; between two of them, t of the way, there are t (1 - t) 4^k on top of that.
class Parabola {
 public:
  static constexpr int kSide = 256;

  Parabola()
      : image(
            imageOf(kSide, kSide, [](int x, int) { return (float(x) + 0.5f) * (float(x) + 0.5f); }))
  {
  }
  static double atLevel(double x, int level)
  {
    const double size = std::exp2(level);
    const double position = x / size - 0.5;
    const double t = position - std::floor(position);
    return x * x + t * (1 - t) * size * size + (size * size - 1) / 12;
  }
  static double atLevel(double x, double level)
  {
    const int finer = static_cast<int>(level);
    const double weight = level - finer;
    return (1 - weight) * atLevel(x, finer) + weight * atLevel(x, finer + 1);
  }

  TextureImage image;
};

TEST(TrilinearFilter, ReadsTheLevelOfTheFootprint)
{
  const Parabola parabola;
  const TextureSampler sampler = samplerOf(TextureFilter::kTrilinear);
  const float x = 97.25f;
  for (const float texels : {1.0f, 1.1f, 1.5f, 2.0f, 3.0f, 4.0f, 5.7f, 8.0f, 13.0f, 31.0f})
    for (const float other : {0.0f, 0.5f, 1.0f}) {
      const float move = texels / Parabola::kSide;
      const double expected = Parabola::atLevel(double{x}, std::log2(double{texels}));
      const Vec2f uv = {x / Parabola::kSide, 0.4f};
      // Whichever way the longer axis goes, and whichever of the two it is.
      for (const Vec2f axis : {Vec2f{move, 0}, Vec2f{0, -move}, Vec2f{0.6f * move, 0.8f * move}}) {
        const Vec2f shorter = axis * other;
        EXPECT_NEAR(red(parabola.image, sampler, uv, axis, shorter), expected, expected * 2e-6);
        EXPECT_NEAR(red(parabola.image, sampler, uv, shorter, axis), expected, expected * 2e-6);
      }
    }
}

TEST(TrilinearFilter, MeasuresTheFootprintInTexelsOfEachSide)
{
  const TextureImage image =
      imageOf(256, 16, [](int x, int) { return (float(x) + 0.5f) * (float(x) + 0.5f); });
  const TextureSampler sampler = samplerOf(TextureFilter::kTrilinear);
  const Vec2f uv = {97.25f / 256, 0.4f};
  const double expected = Parabola::atLevel(97.25, 2);
  EXPECT_NEAR(red(image, sampler, uv, {4.0f / 256, 0}, kNoMove), expected, 0.02);
  EXPECT_NEAR(red(image, sampler, uv, {0, 4.0f / 16}, kNoMove), expected, 0.02);
}

TEST(TrilinearFilter, IsBilinearWhereTheTextureIsMagnified)
{
  const Parabola parabola;
  for (const float texels : {0.0f, 1e-20f, 0.5f, 1.0f})
    for (const int anisotropy : {1, 16})
      for (const float u : {0.1f, 0.377f, 0.9f}) {
        const float move = texels / Parabola::kSide;
        EXPECT_EQ(red(parabola.image,
                      samplerOf(TextureFilter::kTrilinear, TextureWrap::kRepeat, anisotropy),
                      {u, u}, {move, 0}, {0, move}),
                  red(parabola.image, samplerOf(TextureFilter::kBilinear), {u, u}));
      }
}

TEST(TrilinearFilter, EndsInTheMeanOfTheImage)
{
  const Parabola parabola;
  const float mean = parabola.image.texel(8, 0, 0).x;
  EXPECT_NEAR(mean, 256.0 * 256 / 3, 0.1);
  for (const float move : {1.0f, 2.0f, 1e10f, 3e38f})
    EXPECT_EQ(red(parabola.image, samplerOf(TextureFilter::kTrilinear), {0.3f, 0.3f}, {move, 0},
                  {0, move}),
              mean);
}

TEST(AnisotropicFilter, OfARoundFootprintIsTrilinear)
{
  const Parabola parabola;
  for (const float texels : {0.3f, 1.0f, 3.0f, 7.7f}) {
    const float move = texels / Parabola::kSide;
    for (const float u : {0.21f, 0.6f})
      EXPECT_EQ(
          red(parabola.image, samplerOf(TextureFilter::kTrilinear, TextureWrap::kRepeat, 16),
              {u, u}, {move, 0}, {0, move}),
          red(parabola.image, samplerOf(TextureFilter::kTrilinear), {u, u}, {move, 0}, {0, move}));
  }
}

TEST(AnisotropicFilter, IsTheMeanOfProbesAlongTheLongerAxis)
{
  const Parabola parabola;
  const Vec2f uv = {0.4f, 0.6f};
  const struct {
    float longer, shorter;
    int most, probes;
    float level;  // log2(longer / probes)
  } cases[] = {{8, 1, 16, 8, 0},   {8, 2, 16, 4, 1}, {7.5f, 2, 16, 4, std::log2(7.5f / 4)},
               {64, 1, 16, 16, 2}, {8, 1, 2, 2, 2},  {5, 0, 16, 5, 0}};
  for (const auto& c : cases) {
    const float longer = c.longer / Parabola::kSide, shorter = c.shorter / Parabola::kSide;
    const TextureSampler sampler =
        samplerOf(TextureFilter::kTrilinear, TextureWrap::kRepeat, c.most);
    double sum = 0;
    for (int i = 1; i <= c.probes; ++i) {
      const double along = static_cast<double>(i) / (c.probes + 1) - 0.5;
      sum += Parabola::atLevel(double{uv.x} * Parabola::kSide + along * double{c.longer},
                               double{c.level});
    }
    const double expected = sum / c.probes;
    EXPECT_NEAR(red(parabola.image, sampler, uv, {longer, 0}, {0, shorter}), expected,
                expected * 3e-6)
        << c.longer << " x " << c.shorter;
    EXPECT_NEAR(red(parabola.image, sampler, uv, {0, shorter}, {longer, 0}), expected,
                expected * 3e-6);
  }
}

TEST(AnisotropicFilter, KeepsStripesThatTrilinearBlurs)
{
  const TextureImage stripes = imageOf(64, 64, [](int x, int) { return float(x & 1); });
  // Looking along the stripes at a low angle: a pixel is 1 texel wide and 16 long.
  const Vec2f ddx = {1.0f / 64, 0}, ddy = {0, 16.0f / 64};
  for (const float x : {10.5f, 11.5f}) {
    const Vec2f uv = {x / 64, 0.5f};
    EXPECT_EQ(red(stripes, samplerOf(TextureFilter::kTrilinear), uv, ddx, ddy), 0.5f);
    EXPECT_EQ(
        red(stripes, samplerOf(TextureFilter::kTrilinear, TextureWrap::kRepeat, 16), uv, ddx, ddy),
        float(static_cast<int>(x) & 1));
  }
}

TEST(HeightGradient, OfAPlaneIsItsSlopeAtEveryLevel)
{
  // Height 0.5 u - 3 v.
  const TextureImage image =
      imageOf(64, 32, [](int x, int y) { return 0.5f * float(x) / 64 - 3.0f * float(y) / 32; });
  for (const TextureFilter filter :
       {TextureFilter::kNearest, TextureFilter::kBilinear, TextureFilter::kTrilinear})
    for (const int anisotropy : {1, 16})
      for (const float texels : {0.5f, 2.0f, 3.0f}) {
        const Vec2f gradient =
            heightGradient(image, samplerOf(filter, TextureWrap::kClamp, anisotropy),
                           {0.51f, 0.47f}, {texels / 64, 0}, {0, 1.5f * texels / 32});
        EXPECT_NEAR(gradient.x, 0.5f, 1e-5f);
        EXPECT_NEAR(gradient.y, -3.0f, 1e-5f);
      }
}

TEST(HeightGradient, IsTheCentralDifferenceOfNeighbours)
{
  const TextureImage image = imageOf(8, 8, [](int x, int y) { return float(x * x + 5 * y * y); });
  const TextureSampler sampler = samplerOf(TextureFilter::kBilinear);
  // At the centre of texel (3, 5): (16 - 4) / 2 * 8 and 5 (36 - 16) / 2 * 8.
  const Vec2f centre = heightGradient(image, sampler, {3.5f / 8, 5.5f / 8}, kNoMove, kNoMove);
  EXPECT_EQ(centre, (Vec2f{48, 400}));
  // Half way to the next texel that of a parabola is linear.
  const Vec2f between = heightGradient(image, sampler, {4.0f / 8, 5.5f / 8}, kNoMove, kNoMove);
  EXPECT_EQ(between, (Vec2f{56, 400}));
}

TEST(HeightGradient, FollowsTheWrap)
{
  const TextureImage image = imageOf(8, 8, [](int x, int y) { return float(x * x + 3 * x * y); });
  const auto at = [&](TextureWrap wrap, Vec2f uv) {
    return heightGradient(image, samplerOf(TextureFilter::kBilinear, wrap), uv, kNoMove, kNoMove);
  };
  for (const float u : {0.03f, 0.25f, 0.7f}) {
    const Vec2f own = at(TextureWrap::kMirror, {u, 0.4f});
    const Vec2f turned = at(TextureWrap::kMirror, {-u, 0.4f});
    EXPECT_NEAR(turned.x, -own.x, 1e-3f) << "downhill there";
    EXPECT_NEAR(turned.y, own.y, 1e-3f);
    EXPECT_NEAR(at(TextureWrap::kRepeat, {u + 5, 0.4f}).x, at(TextureWrap::kRepeat, {u, 0.4f}).x,
                1e-3f);
  }
  EXPECT_EQ(at(TextureWrap::kMirror, {0, 0.4f}).x, 0.0f);
  EXPECT_EQ(at(TextureWrap::kClamp, {-0.5f, 0.4f}).x, 0.0f);
  EXPECT_EQ(at(TextureWrap::kClamp, {0.5f, 7.0f}).y, 0.0f);
  EXPECT_EQ(at(TextureWrap::kBorder, {-0.5f, 0.4f}).x, 0.0f);
}

TEST(HeightGradient, ReadsBytesInUnitsOfSampleTexture)
{
  const std::vector<std::uint8_t> bytes = {0, 51, 102, 153, 204, 255};
  TextureImage image;
  ASSERT_TRUE(image.build({6, 1, 1, TexelFormat::kUnorm8, bytes.data(), 6}, MipChain::kFull).ok());
  const Vec2f gradient =
      heightGradient(image, samplerOf(TextureFilter::kBilinear), {0.5f, 0.5f}, kNoMove, kNoMove);
  EXPECT_NEAR(gradient.x, 0.2f * 6, 1e-6f);
  EXPECT_EQ(gradient.y, 0.0f);
}

TEST(CheckSampler, NamesWhatIsWrong)
{
  const auto error = [](const TextureSampler& sampler) {
    return checkSampler(sampler, "Texture 3");
  };
  EXPECT_TRUE(error(TextureSampler()).ok());
  for (const int wrong : {-1, 0, 17}) {
    TextureSampler sampler;
    sampler.maxAnisotropy = wrong;
    EXPECT_EQ(error(sampler).error, Error::kInvalidSampleCount);
    EXPECT_NE(error(sampler).message.find("Texture 3"), std::string::npos);
    EXPECT_NE(error(sampler).message.find(std::to_string(wrong)), std::string::npos);
  }
  for (const float wrong : {kNan, kInfinity, 1e30f})
    for (float Vec4f::*channel : {&Vec4f::x, &Vec4f::y, &Vec4f::z, &Vec4f::w}) {
      TextureSampler sampler;
      sampler.borderColor.*channel = wrong;
      EXPECT_EQ(error(sampler).error, Error::kNotFinite);
    }
}

}  // namespace
}  // namespace limn
