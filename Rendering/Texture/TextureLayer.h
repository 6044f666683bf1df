// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Texture/Procedural.h"
#include "Rendering/Texture/TextureImage.h"
#include "Rendering/Texture/TextureSampler.h"

#include <cstdint>

namespace limn {

/// What of a surface a texture says. t is the texture's colour, a its alpha.
enum class TextureRole : std::uint8_t {
  kShaded,   ///< the colour after all else, as VTK's textures
  kSurface,  ///< k_d and k_a; with Gouraud's frequency, which lights corners, as kShaded
  /// Light that was computed before (seed 003, "lightmap"): k_d t is added to what the lights give,
  /// where there is a light equation at all.
  kLight,
  /// The normal in tangent space, x to where u grows, y to where v grows, z outward, as t = (n + 1)
  /// / 2.
  kNormal,
  /// Heights, of the red channel: n + b_u N_u + b_v N_v, renormalised, with -b the heights'
  /// gradient by u and by v and N_u, N_v the unit directions in which these grow (seed 003, "bump
  /// mapping").
  kBump,
};

/// How a texture is put over a colour c, by role kShaded and kSurface; k is 1 or k_d's coefficient.
enum class TextureMode : std::uint8_t {
  kModulate,  ///< c t
  kReplace,   ///< k t
  kDecal,     ///< c + (k t - c) a
  kAdd,       ///< c + k t
};

/// How a texture's colour t and alpha a are joined with c and b, those of the texture before it in
/// the list, so that both together are put over the surface as one: the blending of VTK's textures.
enum class TextureJoin : std::uint8_t {
  kNone,       ///< it stands by itself
  kReplace,    ///< t a + c (1 - a), alpha a + b (1 - a)
  kModulate,   ///< c t, alpha b a
  kAdd,        ///< t a + c b, alpha b + a
  kAddSigned,  ///< t a + c b - 1/2, alpha b + a - 1/2
  kSubtract,   ///< c - t a, alpha b
};

/// One texture of an instance. Normals are bent with the frequency kPhong alone.
struct TextureLayer {
  // One of these two, and it has to outlive render():
  const TextureImage* image = nullptr;
  const ProceduralTexture* procedural = nullptr;  ///< for kShaded, kSurface and kLight
  TextureSampler sampler;                         ///< of the image
  int uvSet = 0;                                  ///< 0: Attributes::uv, 1: uv2
  /// u' = m[0] u + m[1] v + m[2], v' = m[3] u + m[4] v + m[5]
  float uvTransform[6] = {1, 0, 0, 0, 1, 0};
  TextureRole role = TextureRole::kShaded;
  TextureMode mode = TextureMode::kModulate;
  /// Not kNone: `role`, `mode`, `amount` and `onBackFaces` are those of the first texture that it
  /// is joined with. Not for textures that bend normals.
  TextureJoin join = TextureJoin::kNone;
  /// kLight: t times this; kNormal: its x and y; kBump: the heights.
  float amount = 1;
  bool onBackFaces = true;  ///< false: surfaces seen from inside are drawn without
  bool isData = false;      ///< its colours are data's, for Style::toneOverData

  bool readsUv() const { return image != nullptr || procedural->space == ProceduralSpace::kUv; }
  /// Whether it reads the derivatives of uv.
  bool readsFootprint() const
  {
    return image != nullptr && sampler.filter == TextureFilter::kTrilinear;
  }
  /// Of instances with Style::readsAlpha.
  bool setsAlpha() const
  {
    return (role == TextureRole::kShaded || role == TextureRole::kSurface) &&
           mode != TextureMode::kDecal;
  }
  bool bendsNormals() const { return role == TextureRole::kNormal || role == TextureRole::kBump; }
};

}  // namespace limn
