// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Array.h"
#include "Rendering/Base/Status.h"
#include "Rendering/Base/Vec.h"

#include <cstddef>
#include <cstdint>

namespace limn {

enum class TexelFormat : std::uint8_t {
  kUnorm8,   ///< 0 to 255 mean 0 to 1
  kUnorm16,  ///< 0 to 65535 mean 0 to 1
  kFloat32,  ///< as they are, up to kLargestTexel in magnitude
};

/// Colours and gradients of 16 probes stay finite, even of a border in numbers of 16 bits.
inline constexpr float kLargestTexel = 1e27f;

/// A borrowed image: rows from the lowest up, in each texels from the left, in each `components`
/// numbers of the machine's byte order, without gaps.
struct TextureView {
  int width = 0, height = 0;
  int components = 0;  ///< 1: L,L,L,1; 2: L,L,L,A; 3: R,G,B,1; 4: R,G,B,A, as VTK reads them
  TexelFormat format = TexelFormat::kUnorm8;
  const void* texels = nullptr;
  std::size_t byteCount = 0;  ///< at least width * height * components * size of a number
};

enum class MipChain : std::uint8_t {
  kNone,  ///< level 0 alone, for filters that read no other
  kFull,  ///< down to 1 x 1
};

/// A texture that can be sampled: texels of four channels and their mip chain.
///
/// Level k + 1 has half the columns and rows of level k, rounded down, but at least one. A texel is
/// the mean of what it covers: 2 x 2 texels where a side is even. A side of 2n + 1 texels becomes
/// one of n whose texel i is (n - i, n, i + 1) / (2n + 1) of texels 2i, 2i + 1, 2i + 2, so that
/// every texel counts the same (Guthe and Heckbert 2005, Non-Power-of-Two Mipmapping). Integer
/// formats round to nearest, half to even, from exact sums; floats are summed in double, by rows.
///
/// The chain adds a third to level 0: 1 + 1/4 + 1/16 + ... = 4/3. The seed that says "twice" is
/// wrong for images; a single row or column has 1 + 1/2 + 1/4 + ... = 2.
class TextureImage {
 public:
  static constexpr int kMaxSide = 16384;
  static constexpr int kMaxLevels = 15;

  /// Copies `view` and computes its chain with at most `threads` threads (0: all); the bytes do not
  /// depend on their number.
  /// Errors, after which the image is empty: kInvalidImageSize for a side of less than 1 or more
  /// than kMaxSide or one that does not fit into the memory, kSizeMismatch for components other
  /// than 1 to 4 or too few bytes, kNotFinite for a float that is not a number or above
  /// kLargestTexel, naming the first such texel. Messages begin with "Texture".
  Status build(const TextureView& view, MipChain chain, int threads = 0);

  bool empty() const { return levels_.count == 0; }
  TexelFormat format() const { return format_; }
  int width(int level = 0) const { return levels_.width[level]; }
  int height(int level = 0) const { return levels_.height[level]; }
  int levelCount() const { return levels_.count; }
  /// Memory of the texels of all levels.
  std::size_t bytes() const { return words_.size() * sizeof words_[0]; }

  /// A texel in the units of sampleTexture(). Requires: level, x and y within the image.
  Vec4f texel(int level, int x, int y) const;

  // For samplers.

  /// By level, ready to be gathered.
  struct Levels {
    std::int32_t width[kMaxLevels + 1] = {}, height[kMaxLevels + 1] = {};
    std::int32_t offset[kMaxLevels + 1] = {};  ///< of the first texel, in texels
    int count = 0;
  };
  const Levels& levels() const { return levels_; }
  /// Texels of kUnorm8 are one word each, red in the lowest byte; of kUnorm16 two, red and blue in
  /// the lower halves; of kFloat32 four.
  const std::uint32_t* words() const { return words_.data(); }
  /// What the number of a texel is multiplied with: 1/255, 1/65535 or 1.
  float unit() const { return unit_; }
  /// The number that means 1: 255, 65535 or 1.
  float one() const { return one_; }

 private:
  TexelFormat format_ = TexelFormat::kUnorm8;
  float unit_ = 1, one_ = 1;
  Levels levels_;
  Array<std::uint32_t> words_;
};

}  // namespace limn
