// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Status.h"
#include "Rendering/Base/Vec.h"

#include <cstdint>
#include <string>

namespace limn {

/// What a texture shows where a coordinate is outside 0 to 1.
enum class TextureWrap : std::uint8_t {
  kRepeat,  ///< its fractional part counts
  kMirror,  ///< as kRepeat, every second copy turned round
  kClamp,   ///< the texel at the edge
  kBorder,  ///< TextureSampler::borderColor; blends with the edge's texels within half a texel
};

enum class TextureFilter : std::uint8_t {
  kNearest,    ///< the texel that the coordinate lies in, of level 0
  kBilinear,   ///< the four texels around it, of level 0
  kTrilinear,  ///< bilinear in the two levels of the mip chain that are nearest to the footprint
};

/// How a texture is read.
struct TextureSampler {
  static constexpr int kMaxAnisotropy = 16;

  TextureWrap wrapU = TextureWrap::kRepeat, wrapV = TextureWrap::kRepeat;
  TextureFilter filter = TextureFilter::kBilinear;
  /// Most probes along the longer axis of the footprint, 1 to kMaxAnisotropy; for kTrilinear only.
  int maxAnisotropy = 1;
  Vec4f borderColor = {0, 0, 0, 0};  ///< in the units of sampleTexture(), up to kLargestTexel
};

/// Errors: kNotFinite for a border colour that is not a number or too large, kInvalidSampleCount
/// for an anisotropy outside 1 to 16; the message begins with `name`.
Status checkSampler(const TextureSampler& sampler, const std::string& name);

}  // namespace limn
