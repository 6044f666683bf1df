// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Vec.h"

#include <cstdint>

/// The tones of illustration, which take the place of a surface's diffuse term. Notation as in
/// Scene.h; t, f and D are numbers from 0 to 1.
namespace limn {

class TextureImage;  // Rendering/Texture/TextureImage.h

enum class Tone : std::uint8_t {
  kNone,
  kGooch,         ///< warm faces the light: ((1+l.n)/2) k_warm + ((1-l.n)/2) k_cool
  kGoochChapter,  ///< (12.6) as printed: cool faces the light
  /// kGooch times the stripes of milled metal (Gooch 1998, section 4.3, in the form that needs no
  /// parametrization: Gooch, Interactive Technical Illustration 1999): kMetalStripes stripes of
  /// equal width over the angle between n and the view's x axis, grey by a fixed hash from 0 to
  /// 1/2, that which l falls into white; linear between their centres.
  kMetal,
  /// k_d T(max(0, n.l), D), a picture that has the tone to the right and a detail D upwards
  /// (X-Toon: Barla, Thollot and Markosian 2006). Needs Style::ramp.
  kRamp,
  /// k_d T(n), a picture of a lit sphere (Sloan et al. 2001), n in the basis of v, of the axis to
  /// the right and of that upwards that are perpendicular to v. Needs Style::ramp.
  kMatCap,
  kHatching,     ///< strokes, as dense as the light is weak; see Hatching
  kExaggerated,  ///< k_d c, detail of all sizes in grazing light; see Exaggeration
};

inline constexpr int kMetalStripes = 20;

/// Whose l a tone is for.
enum class ToneLight : std::uint8_t {
  kFirst,       ///< of the first light; along the gaze where there is none
  kUpperRight,  ///< (1, 1, 0) / sqrt(2) in view space: perpendicular to the gaze, so that the whole
                ///< scale is seen, and fixed to the camera
};

/// The highlight of kGooch, kGoochChapter and kMetal.
enum class ToneHighlight : std::uint8_t {
  kAdded,      ///< k_s max(0, n.h)^p without the light's colour, where n.l > 0
  kReflected,  ///< k_s max(0, r.v)^p likewise, r = 2 (n.l) n - l (Rost, OpenGL Shading Language)
  kWhite,      ///< white in the share clamp(100 r.v - 97) (Real-Time Rendering, 4th ed., 5.1)
  kNone,
};

/// Most values of Style::toonBands.
inline constexpr int kMaxToonBands = 64;

/// What D is in T(t, D).
enum class RampDetail : std::uint8_t {
  kDepth,       ///< 1 - log(z / nearest) / log(farthest / nearest), z along the gaze
  kSilhouette,  ///< |n.v|^exponent
  kHighlight,   ///< max(0, r.v)^exponent
};

/// The picture of Tone::kRamp or kMatCap, read bilinearly, its edges prolonged.
struct ToneRamp {
  const TextureImage* image = nullptr;  ///< outlives render()
  RampDetail detail = RampDetail::kDepth;
  float exponent = 1;               ///< >= 0
  float nearest = 0, farthest = 0;  ///< 0 < nearest < farthest; both 0: the camera's clipping
                                    ///< planes, but at least a thousandth of the farther
};

/// What the strokes of Tone::kHatching lie on.
enum class HatchPlace : std::uint8_t {
  /// Where the planes x + y + z = const cut the mesh, and for strokes across these the differences
  /// of two coordinates, those of the plane that the surface is nearest to; two or three of these
  /// are blended where it is near to several. So strokes have no seams, whatever the mesh, and stay
  /// where they are when the camera moves.
  kModel,
  kTexture,  ///< Attributes::uv: along the first coordinate, then along the second
};

/// Tone::kHatching: k_d times the paper's colour, with strokes of ink. Their share of the surface
/// is darkest (1 - t), t = k_a I_a + sum I max(0, n.l) for k_d = 1, its strongest channel, 0 to 1;
/// with ToneLight::kUpperRight t = (1 + n.l) / 2.
/// Drawn from a TonalArtMap (Praun, Hoppe, Webb and Finkelstein 2001): of two tones and two sizes
/// of stroke the mean, by weights. Lit by each pixel, with kGouraud too, and with kFlat by each
/// face. Where a surface shader asks for light, it gets the mean of ink and paper.
struct Hatching {
  Vec3f paper = {1, 1, 1}, ink = {0, 0, 0};  ///< >= 0
  /// From stroke to stroke where a quarter of the surface is ink, in pixels across the strokes, 1
  /// to kMaxHatchSpacing. Kept at any distance and tilt: of two sizes, one the double of the
  /// other, strokes of the larger fade in as the smaller become too dense.
  float spacing = 6;
  float darkest = 0.85f;  ///< ink's share where no light arrives, 0 to 1
  HatchPlace place = HatchPlace::kModel;
};
inline constexpr float kMaxHatchSpacing = 256;

/// Tone::kExaggerated (Rusinkiewicz, Burns and DeCarlo 2006): c is a base of c_b and for the rest
/// the mean of c_0 to c_L-1, weighed by sigma^exponent of their levels.
///   c_b = 1/2 + n_L.l / 2 and c_i = 1/2 + clamp(contrast n_i.l_i+1, -1, 1) / 2,
/// where l_i+1 is the part of l across n_i+1 divided by its length: light that grazes the surface
/// as the next coarser level has it. Divided by kLeastGrazing if that is more, so that there is no
/// spot where l and n_i+1 meet and this direction turns round; the detail fades there. n_0 is the
/// surface's normal, as far in sigma from the first of Attributes::smoothNormals as that from the
/// second, and n_1 to n_L are these, by (12.4) and renormalised. By each pixel, with kGouraud too;
/// with kFlat n_0 is the face's. Where a surface shader asks for light, c is 1/2 + n.l / 2.
struct Exaggeration {
  float contrast = 10;  ///< a, 0 to kMaxExaggeration
  float exponent = 0;   ///< p, -4 to 4: above 0 large shapes count more, below fine detail
  float base = 0.4f;    ///< k_b, 0 to 1
};
inline constexpr float kLeastGrazing = 0.25f;
inline constexpr float kMaxExaggeration = 1000;
inline constexpr float kMaxExaggerationExponent = 4;

}  // namespace limn
