// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Vec.h"
#include "Rendering/Texture/TextureImage.h"
#include "Rendering/Texture/TextureSampler.h"

/// Reading a texture at a point, as OpenGL defines it; SampleTexture-inl.h has the vector form with
/// the same operations in the same order.
///
/// uv is (0, 0) at the lower left corner of the image and (1, 1) at the upper right one; texel i of
/// w has its centre at (i + 1/2) / w. Repeating and mirroring reduce coordinates of any size
/// exactly; of those between -1 and 0 the result is rounded to a float. (From 2^23 on all floats
/// are whole.) A coordinate that is not finite counts as 0, as does such a derivative; nothing
/// outside the image is read.
///
/// Footprint, for kTrilinear: with (du/dx, dv/dx) and (du/dy, dv/dy), the derivatives by window
/// coordinates in pixels, in texels of level 0, let P_max be the longer and P_min the shorter one's
/// length. Without anisotropy the level is log2 P_max, within the chain (OpenGL 4.6, 8.14.1 with
/// the longer axis for rho); up to 0 it is level 0, read bilinearly. With it, N = min(ceil(P_max /
/// max(P_min, 1)), maxAnisotropy) probes lie at i / (N + 1) - 1/2, i = 1 ... N, of the longer axis,
/// each of level log2(P_max / N); their mean is the result (EXT_texture_filter_anisotropic 1999,
/// but for the 1, which saves probes less than a texel apart).
namespace limn {

/// RGBA; 0 to 1 for integer formats, as they are for floats. All inputs are allowed.
/// Requires: the image is not empty and the sampler is checked.
Vec4f sampleTexture(const TextureImage& image, const TextureSampler& sampler, Vec2f uv, Vec2f ddx,
                    Vec2f ddy);

/// (b_u, b_v) of a bump map, the derivatives of its height by u and by v: height (the red channel,
/// in the units of sampleTexture()) per unit of uv, that is per whole image. A texel's are half the
/// differences of its two neighbours to the right and left, above and below (seed 003, "bump
/// mapping"), times the level's columns or rows; between texels, levels and probes they are
/// filtered as colours are. Requires: as sampleTexture().
Vec2f heightGradient(const TextureImage& image, const TextureSampler& sampler, Vec2f uv, Vec2f ddx,
                     Vec2f ddy);

}  // namespace limn
