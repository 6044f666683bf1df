// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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

}  // namespace limn
