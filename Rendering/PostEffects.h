// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

/// What is done to a whole picture after its surfaces are drawn, as a chain of stages:
///
///   radiance → exposure → depth of field → bloom → tone mapping → bytes → FXAA
///
/// The default of each setting leaves its stage out. The stages before the bytes work on
/// FrameView::radiance, which knows colours above 1. No stage encodes colours for a display: the
/// bytes are 255 times the colour, as everywhere in Limn (no hidden sRGB).
namespace limn {

/// The curve from radiance to 0 ... 1; what it leaves above 1 is clamped.
enum class ToneMapping : std::uint8_t {
  kNone,
  /// c / (1 + L), L = 0.2126 r + 0.7152 g + 0.0722 b: Reinhard, Stark, Shirley and Ferwerda 2002,
  /// "Photographic tone reproduction for digital images", equation 3.
  kReinhard,
  /// c (1 + L / w²) / (1 + L): equation 4 there. A grey of `whitePoint` w becomes white.
  kReinhardExtended,
  /// c (2.51 c + 0.03) / (c (2.43 c + 0.59) + 0.14) for each channel: Narkowicz 2015, "ACES filmic
  /// tone mapping curve", a fit to the curve of the Academy.
  kAces,
};

/// Light that spills over from what is brighter than `threshold`. Of a pixel whose largest channel
/// is m, the part (m - threshold) / m is spread by a pyramid (Burt and Adelson 1983, with the
/// binomial weights 1 4 6 4 1) and added: the mean of its `levels` levels times `strength`. Level l
/// is about a Gaussian of standard deviation sqrt(2 (4^l - 1) / 3) pixels. No light is lost or won
/// on the way but across the picture's border: what is added sums to `strength` times the part.
struct Bloom {
  float strength = 0;   ///< >= 0; 0: off
  float threshold = 1;  ///< >= 0
  int levels = 5;       ///< 1 to kMaxBloomLevels
};
inline constexpr int kMaxBloomLevels = 8;

/// The blur of a thin lens (Potmesil and Chakravarty 1981). A point at distance d from the eye,
/// along the gaze, becomes a disc of diameter `aperture` |d - focus| / d in the plane of focus.
/// Each pixel gathers the discs that reach it; a disc from behind a pixel is no larger there than
/// the pixel's own, so that what is sharp stays sharp before a blurred background.
struct DepthOfField {
  float aperture = 0;       ///< diameter of the lens in world units, >= 0; 0: off, a pinhole
  float focusDistance = 1;  ///< from the eye to the plane of focus, in world units, > 0
  int maxRadius = 16;       ///< of a disc, in pixels: larger ones become that; 1 to kMaxBlurRadius
};
inline constexpr int kMaxBlurRadius = 63;

/// Smooths stairs along edges of the finished bytes: Lottes 2011, "FXAA 3.11", in the form and with
/// the parameters of VTK's vtkFXAAOptions, which explains them.
struct Fxaa {
  bool enabled = false;
  // Of luma 0.299 r + 0.587 g + 0.114 b; each 0 to 1.
  float relativeContrastThreshold = 1.0f / 8;
  float hardContrastThreshold = 1.0f / 16;
  float subpixelBlendLimit = 3.0f / 4;
  float subpixelContrastThreshold = 1.0f / 4;
  /// Compares the pixels on both sides of an edge to find its end, not their mean: finds the ends
  /// of lines one pixel wide.
  bool highQualityEndpoints = true;
  int endpointSearchIterations = 12;  ///< pixels to either side, 0 to kMaxImageSide
};

struct PostEffects {
  float exposure = 1;  ///< factor of all radiance, >= 0
  DepthOfField depthOfField;
  Bloom bloom;
  ToneMapping toneMapping = ToneMapping::kNone;
  float whitePoint = 4;  ///< of kReinhardExtended, > 0
  Fxaa fxaa;

  /// Whether a stage reads FrameView::radiance.
  bool needRadiance() const
  {
    return exposure != 1 || depthOfField.aperture > 0 || bloom.strength > 0 ||
           toneMapping != ToneMapping::kNone;
  }
  bool areOn() const { return needRadiance() || fxaa.enabled; }
};

}  // namespace limn
