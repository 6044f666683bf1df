// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The vector forms of Rendering/Texture, by the kernels in use, on arrays.
#pragma once

#include "Rendering/Texture/Procedural.h"
#include "Rendering/Texture/SampleTexture.h"

#include <vector>

namespace limn::testing {

struct TexturePoint {
  Vec2f uv, ddx, ddy;
};

std::vector<Vec4f> sampledByLanes(const TextureImage& image, const TextureSampler& sampler,
                                  const std::vector<TexturePoint>& points);
std::vector<Vec2f> gradientsByLanes(const TextureImage& image, const TextureSampler& sampler,
                                    const std::vector<TexturePoint>& points);
std::vector<Vec4f> proceduralByLanes(const ProceduralTexture& texture,
                                     const std::vector<Vec3f>& points);

}  // namespace limn::testing
