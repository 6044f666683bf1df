// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Texture/TextureSampler.h"

#include "Rendering/Texture/TextureImage.h"

#include <cmath>

namespace limn {

Status checkSampler(const TextureSampler& sampler, const std::string& name)
{
  const auto isLow = [](float v) { return std::fabs(v) <= kLargestTexel; };
  const Vec4f border = sampler.borderColor;
  if (!isLow(border.x) || !isLow(border.y) || !isLow(border.z) || !isLow(border.w))
    return {Error::kNotFinite,
            name + ": its border colour has a channel that is not a number up to 1e27."};
  if (sampler.maxAnisotropy < 1 || sampler.maxAnisotropy > TextureSampler::kMaxAnisotropy)
    return {Error::kInvalidSampleCount,
            name + ": its anisotropy " + std::to_string(sampler.maxAnisotropy) +
                " is not between 1 and " + std::to_string(TextureSampler::kMaxAnisotropy) + "."};
  return {};
}

}  // namespace limn
