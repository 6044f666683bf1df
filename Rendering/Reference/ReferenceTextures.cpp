// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Reference/ReferenceTextures.h"

#include "Rendering/Texture/SampleTexture.h"

namespace limn::reference {

Vec4f sampleLayer(const TextureLayer& layer, const TexturePoint& point)
{
  if (layer.image != nullptr)
    return sampleTexture(*layer.image, layer.sampler, point.uv, point.ddx, point.ddy);
  const bool byUv = layer.procedural->space == ProceduralSpace::kUv;
  return proceduralColor(*layer.procedural,
                         byUv ? Vec3f{point.uv.x, point.uv.y, 0} : point.position);
}

Vec3f combine(TextureMode mode, Vec3f color, Vec4f texture, float k)
{
  const Vec3f t = {texture.x, texture.y, texture.z};
  switch (mode) {
    case TextureMode::kModulate:
      return color * t;
    case TextureMode::kReplace:
      return t * k;
    case TextureMode::kDecal:
      return color + (t * k - color) * texture.w;
    default:
      return color + t * k;
  }
}

Vec4f joined(TextureJoin join, Vec4f before, Vec4f next)
{
  const Vec3f c = {before.x, before.y, before.z}, t = {next.x, next.y, next.z};
  const float b = before.w, a = next.w;
  const auto make = [](Vec3f color, float alpha) {
    return Vec4f{color.x, color.y, color.z, alpha};
  };
  constexpr Vec3f kHalf = {0.5f, 0.5f, 0.5f};
  switch (join) {
    case TextureJoin::kReplace:
      return make(t * a + c * (1.0f - a), a + b * (1.0f - a));
    case TextureJoin::kModulate:
      return make(c * t, b * a);
    case TextureJoin::kAdd:
      return make(t * a + c * b, b + a);
    case TextureJoin::kAddSigned:
      return make(t * a + c * b - kHalf, b + a - 0.5f);
    default:
      return make(c - t * a, b);
  }
}

TangentFrame tangentFrame(Vec3f edge1, Vec3f edge2, const Vec2f (&uv)[3])
{
  const Vec2f d1 = uv[1] - uv[0], d2 = uv[2] - uv[0];
  const float area = d1.x * d2.y - d2.x * d1.y;
  // As 1 / area, but of which only the sign counts.
  const float turn = area > 0.0f ? 1.0f : area < 0.0f ? -1.0f : 0.0f;
  return {(edge1 * d2.y - edge2 * d1.y) * turn, (edge2 * d1.x - edge1 * d2.x) * turn};
}

}  // namespace limn::reference
