// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Scene.h"

namespace limn::reference {

/// Where a texture is read.
struct TexturePoint {
  Vec2f uv, ddx, ddy;  ///< after TextureLayer::uvTransform; derivatives by a pixel
  Vec3f position;      ///< in the model's own coordinates
};

Vec4f sampleLayer(const TextureLayer& layer, const TexturePoint& point);

/// TextureMode, with k the weight of the texture's colour.
Vec3f combine(TextureMode mode, Vec3f color, Vec4f texture, float k);

/// TextureJoin of the textures so far and the next.
Vec4f joined(TextureJoin join, Vec4f before, Vec4f next);

/// The unit directions of a triangle in which u and v grow; zero where they do not grow.
struct TangentFrame {
  Vec3f u, v;
};
TangentFrame tangentFrame(Vec3f edge1, Vec3f edge2, const Vec2f (&uv)[3]);

}  // namespace limn::reference
