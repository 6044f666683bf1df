// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Texture/TextureImage.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

namespace limn {
namespace {

template <class T>
constexpr TexelFormat kFormatOf = sizeof(T) == 1   ? TexelFormat::kUnorm8
                                  : sizeof(T) == 2 ? TexelFormat::kUnorm16
                                                   : TexelFormat::kFloat32;

template <class T>
TextureView viewOf(const std::vector<T>& texels, int width, int height, int components)
{
  return {width, height, components, kFormatOf<T>, texels.data(), texels.size() * sizeof(T)};
}

template <class T>
TextureImage imageOf(const std::vector<T>& texels, int width, int height, int components = 1)
{
  TextureImage image;
  const Status status = image.build(viewOf(texels, width, height, components), MipChain::kFull);
  EXPECT_TRUE(status.ok()) << status.message;
  return image;
}

void expectError(const TextureView& view, Error error, const char* word)
{
  TextureImage image = imageOf<std::uint8_t>({1}, 1, 1);
  const Status status = image.build(view, MipChain::kFull);
  EXPECT_EQ(status.error, error) << status.message;
  EXPECT_NE(status.message.find(word), std::string::npos) << status.message;
  EXPECT_TRUE(image.empty());
  EXPECT_EQ(image.bytes(), 0u);
}

TEST(TextureImage, RejectsSizesThatCannotBe)
{
  const std::vector<std::uint8_t> texels(64);
  expectError(viewOf(texels, 0, 4, 1), Error::kInvalidImageSize, "0 x 4");
  expectError(viewOf(texels, 4, 0, 1), Error::kInvalidImageSize, "4 x 0");
  expectError(viewOf(texels, -1, 4, 1), Error::kInvalidImageSize, "-1 x 4");
  expectError(viewOf(texels, 16385, 1, 1), Error::kInvalidImageSize, "16385 x 1");
  expectError(viewOf(texels, 1, 1 << 30, 1), Error::kInvalidImageSize, "16384");
  expectError(viewOf(texels, 2, 2, 0), Error::kSizeMismatch, "0 components");
  expectError(viewOf(texels, 2, 2, 5), Error::kSizeMismatch, "5 components");
  expectError(viewOf(texels, 8, 8, 3), Error::kSizeMismatch, "64 bytes of 192");
  expectError({2, 2, 1, TexelFormat::kUnorm8, nullptr, 64}, Error::kSizeMismatch, "0 bytes of 4");
}

TEST(TextureImage, RejectsTruncatedTexelsOfEveryFormat)
{
  const std::vector<std::uint8_t> bytes(16 * 3 * 4);
  for (const auto& [format, size] :
       {std::pair{TexelFormat::kUnorm8, 1u}, std::pair{TexelFormat::kUnorm16, 2u},
        std::pair{TexelFormat::kFloat32, 4u}}) {
    TextureImage image;
    EXPECT_TRUE(image.build({4, 4, 3, format, bytes.data(), 48 * size}, MipChain::kNone).ok());
    expectError({4, 4, 3, format, bytes.data(), 48 * size - 1}, Error::kSizeMismatch, "truncated");
  }
}

TEST(TextureImage, NamesTheFirstTexelThatIsNotANumber)
{
  for (const float wrong :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
        -std::numeric_limits<float>::infinity(), 1.1e27f}) {
    std::vector<float> texels(300 * 200 * 2, 0.5f);
    texels[(100 * 300 + 17) * 2 + 1] = wrong;
    texels[(150 * 300 + 2) * 2] = wrong;
    expectError(viewOf(texels, 300, 200, 2), Error::kNotFinite, "(17, 100)");
  }
  EXPECT_EQ(imageOf<float>({-1e27f}, 1, 1).texel(0, 0, 0).x, -1e27f);
}

TEST(TextureImage, MakesFourChannelsAsVtkDoes)
{
  const std::vector<std::uint8_t> bytes = {51, 102, 153, 204};
  const float c[] = {51 * (1 / 255.0f), 102 * (1 / 255.0f), 153 * (1 / 255.0f), 204 * (1 / 255.0f)};
  const auto first = [&](int components) {
    return imageOf(bytes, 1, 1, components).texel(0, 0, 0);
  };
  EXPECT_EQ(first(1), (Vec4f{c[0], c[0], c[0], 1}));
  EXPECT_EQ(first(2), (Vec4f{c[0], c[0], c[0], c[1]}));
  EXPECT_EQ(first(3), (Vec4f{c[0], c[1], c[2], 1}));
  EXPECT_EQ(first(4), (Vec4f{c[0], c[1], c[2], c[3]}));
  EXPECT_EQ(imageOf<std::uint16_t>({13107, 65535}, 1, 1, 2).texel(0, 0, 0).w, 1.0f);
  EXPECT_EQ(imageOf<float>({-2.5f, 7, 1e9f}, 1, 1, 3).texel(0, 0, 0), (Vec4f{-2.5f, 7, 1e9f, 1}));
}

TEST(TextureImage, KeepsRowsFromTheLowestUp)
{
  const TextureImage image = imageOf<float>({0, 1, 2, 3, 4, 5}, 3, 2);
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 3; ++x)
      EXPECT_EQ(image.texel(0, x, y).x, static_cast<float>(3 * y + x));
}

TEST(TextureImage, ReachesOneByOneInHalves)
{
  const TextureImage image = imageOf(std::vector<std::uint8_t>(13 * 3), 13, 3);
  ASSERT_EQ(image.levelCount(), 4);
  const int width[] = {13, 6, 3, 1}, height[] = {3, 1, 1, 1};
  for (int level = 0; level < 4; ++level) {
    EXPECT_EQ(image.width(level), width[level]);
    EXPECT_EQ(image.height(level), height[level]);
  }
  TextureImage flat;
  ASSERT_TRUE(
      flat.build(viewOf(std::vector<std::uint8_t>(16384), 16384, 1, 1), MipChain::kFull).ok());
  EXPECT_EQ(flat.levelCount(), TextureImage::kMaxLevels);
  ASSERT_TRUE(flat.build(viewOf(std::vector<std::uint8_t>(64), 8, 8, 1), MipChain::kNone).ok());
  EXPECT_EQ(flat.levelCount(), 1);
  EXPECT_EQ(flat.bytes(), 64u * 4);
}

template <class T>
void expectConstantChain(T value)
{
  for (const auto& [width, height] : {std::pair{8, 8}, std::pair{7, 5}, std::pair{13, 1},
                                      std::pair{1, 100}, std::pair{101, 38}}) {
    const TextureImage image =
        imageOf(std::vector<T>(static_cast<std::size_t>(width * height), value), width, height);
    const Vec4f expected = image.texel(0, 0, 0);
    for (int level = 0; level < image.levelCount(); ++level)
      for (int y = 0; y < image.height(level); ++y)
        for (int x = 0; x < image.width(level); ++x)
          ASSERT_EQ(image.texel(level, x, y), expected) << level << ": " << x << ", " << y;
  }
}

TEST(MipChain, OfAConstantImageIsConstant)
{
  expectConstantChain<std::uint8_t>(255);
  expectConstantChain<std::uint8_t>(77);
  expectConstantChain<std::uint16_t>(65535);
  expectConstantChain<std::uint16_t>(12345);
  expectConstantChain<float>(0.1f);
  expectConstantChain<float>(-1e27f);
}

TEST(MipChain, EndsInTheMeanOfPowersOfTwo)
{
  std::mt19937 random(1);
  std::vector<float> texels(256 * 64);
  double sum = 0;
  for (float& texel : texels) {
    // Whole numbers below 256: all means are exact.
    texel = static_cast<float>(random() >> 24);
    sum += texel;
  }
  const TextureImage image = imageOf(texels, 256, 64);
  EXPECT_EQ(image.texel(image.levelCount() - 1, 0, 0).x,
            static_cast<float>(sum / static_cast<double>(texels.size())));
}

TEST(MipChain, CountsEachTexelOfOddSidesTheSame)
{
  const int width = 7, height = 5;
  for (int at = 0; at < width * height; ++at) {
    std::vector<float> texels(static_cast<std::size_t>(width * height));
    texels[static_cast<std::size_t>(at)] = 1;
    const TextureImage image = imageOf(texels, width, height);
    double sum = 0;
    for (int y = 0; y < image.height(1); ++y)
      for (int x = 0; x < image.width(1); ++x)
        sum += static_cast<double>(image.texel(1, x, y).x);
    EXPECT_NEAR(sum / (image.width(1) * image.height(1)), 1.0 / (width * height), 1e-9) << at;
  }
}

TEST(MipChain, WeighsOddSidesByWhatIsCovered)
{
  const TextureImage image = imageOf<float>({10, 20, 40, 80, 160}, 5, 1);
  EXPECT_FLOAT_EQ(image.texel(1, 0, 0).x, (2 * 10 + 2 * 20 + 1 * 40) / 5.0f);
  EXPECT_FLOAT_EQ(image.texel(1, 1, 0).x, (1 * 40 + 2 * 80 + 2 * 160) / 5.0f);
  const TextureImage three = imageOf<std::uint8_t>({0, 100, 101}, 1, 3);
  EXPECT_EQ(three.texel(1, 0, 0).x, 67 * (1 / 255.0f));
}

TEST(MipChain, RoundsHalvesToEvenAndSoDoesNotDrift)
{
  const auto two = [](std::uint8_t a, std::uint8_t b) {
    return std::lround(imageOf<std::uint8_t>({a, b}, 2, 1).texel(1, 0, 0).x * 255);
  };
  EXPECT_EQ(two(0, 1), 0);
  EXPECT_EQ(two(1, 2), 2);
  EXPECT_EQ(two(254, 255), 254);
  std::mt19937 random(2);
  double drift = 0;
  constexpr int kImages = 64;
  for (int i = 0; i < kImages; ++i) {
    std::vector<std::uint8_t> texels(64 * 64);
    double sum = 0;
    for (std::uint8_t& texel : texels) {
      texel = static_cast<std::uint8_t>(random() >> 24);
      sum += texel;
    }
    const TextureImage image = imageOf(texels, 64, 64);
    drift += static_cast<double>(image.texel(6, 0, 0).x) * 255 - sum / (64 * 64);
  }
  // Always up would be 6/8.
  EXPECT_LT(std::fabs(drift / kImages), 0.15);
}

TEST(MipChain, TakesAThirdOfLevelZero)
{
  const auto ratio = [](int width, int height) {
    const auto texels = static_cast<std::size_t>(width * height);
    const std::vector<std::uint16_t> numbers(texels);
    return static_cast<double>(imageOf(numbers, width, height).bytes()) /
           static_cast<double>(texels * 4 * sizeof(std::uint16_t));
  };
  EXPECT_NEAR(ratio(512, 512), 4.0 / 3, 1e-5);
  EXPECT_NEAR(ratio(640, 480), 4.0 / 3, 1e-3);
  EXPECT_NEAR(ratio(333, 333), 4.0 / 3, 5e-3);
  EXPECT_NEAR(ratio(4096, 1), 2.0, 1e-3) << "what seed 003 says of images is true of lines";
  EXPECT_EQ(ratio(1, 1), 1.0);
}

TEST(MipChain, HasTheSameBytesWithAnyNumberOfThreads)
{
  std::mt19937 random(3);
  std::vector<float> texels(701 * 512 * 3);
  for (float& texel : texels)
    texel = static_cast<float>(random()) * 1e-6f;
  std::vector<std::uint32_t> words[4];
  const int threads[] = {1, 2, 3, 8};
  for (int i = 0; i < 4; ++i) {
    TextureImage image;
    ASSERT_TRUE(image.build(viewOf(texels, 701, 512, 3), MipChain::kFull, threads[i]).ok());
    words[i].assign(image.words(), image.words() + image.bytes() / 4);
    EXPECT_EQ(words[i], words[0]) << threads[i] << " threads";
  }
}

}  // namespace
}  // namespace limn
