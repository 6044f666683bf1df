// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Vec.h"

/// Depth cues: what tells from the finished picture's depths which surface lies before which. They
/// change the colours of surfaces after these are shaded and before lines are drawn, so that lines,
/// and whatever is no surface of the scene, keep theirs. A pixel's depth is that of its nearest
/// sample, and what changes is the share of the pixel that shows that sample's surface. What other
/// surfaces have of the pixel changes as the farthest of the eight pixels around that shows their
/// instance, if one lies behind.
///
/// d is the distance along the gaze, w the length that a pixel's height covers at d, both in the
/// scene's units: d / w is a depth in pixels, which is the same for the same picture of the same
/// surface in perspective and in parallel projection, near and far. Pixels that show no opaque
/// instance are infinitely far. Radii are shares of the picture's diagonal, so that a larger
/// picture of the scene looks the same. Hulls and translucent instances have no cues; as occluders
/// hulls count as what they are.
namespace limn {

/// Eye-dome lighting (Boucheny 2009): the more of what is around a point lies before it, the
/// darker it is. For a ring of eight directions at the distance r the response is the mean of
/// clamp((d - d_i) / (r w), 0, kEyeDomeSlope), the slope by which each neighbour is nearer. The
/// fine scale is a ring at the radius, at least a pixel; the coarse one the mean of rings at 2, 3
/// and 4 times that. Colours are multiplied by exp(-strength (fine + coarse) / 2).
struct EyeDomeLighting {
  float strength = 0;     ///< 0: none; 0 to kMaxCueStrength
  float radius = 0.001f;  ///< above 0 to kMaxEyeDomeRadius
};

/// Unsharp masking of the depth (Luft, Colditz, Deussen 2006): G is a Gaussian of the standard
/// deviation sigma = radius times the diagonal, over pixels that show a surface, g = (G d - d) /
/// (sigma w) and x = g / (1 + |g|), so that deep steps fade as shallow ones do. What lies behind
/// the mean of its surroundings, x < 0, is multiplied by 1 + strength x; what lies before it goes
/// towards white by strength x if `lightens` is set. G is evaluated for blocks of max(1,
/// floor(sigma / 8)) pixels, up to 3 sigma, and interpolated between their centres.
struct DepthUnsharp {
  float strength = 0;    ///< 0: none; 0 to 1
  float radius = 0.02f;  ///< above 0 to kMaxUnsharpRadius
  bool lightens = false;
};

/// The instance cuts a gap into what lies behind it, other instances and parts of itself, along
/// its border (after Appel, Rohlf, Stein 1979). Where that is deeper by s the gap is as wide as
/// width t^2 (3 - 2 t), t = min(1, s / (depth width w)) (after Everts and others 2009): surfaces
/// that touch have none.
/// It cuts lines of what lies behind, too: image outlines and creases there; strokes of other
/// instances as it would cut a surface as far away, also over the background, hidden ones by all
/// of the width; those of its own instance where they lie behind by more than the depth of the
/// whole width and the horizon of rounded surfaces, kHorizon times what the surface rises within
/// its last pixel times one and half the pixels from there to the stroke. Strokes that meet in a
/// pixel and are laid over it at once count as the nearest of them. Translucent surfaces behind it
/// are cut as opaque ones that lie as far, and keep their alpha: what is below them is cut by
/// itself; with Background::kKeepApart, where nobody knows that, they are not. The background is
/// not cut.
struct Halo {
  static constexpr float kHorizon = 3;
  float width = 0;          ///< pixels; 0: none; 0 to kMaxHaloWidth
  float depth = 4;          ///< in widths, above 0
  Vec3f color = {1, 1, 1};  ///< >= 0
};

struct DepthCues {
  EyeDomeLighting eyeDome;
  DepthUnsharp unsharp;
  Halo halo;

  bool any() const { return eyeDome.strength > 0 || unsharp.strength > 0 || halo.width > 0; }
};

inline constexpr float kMaxCueStrength = 100;
inline constexpr float kMaxEyeDomeRadius = 0.02f, kMaxUnsharpRadius = 0.1f;
inline constexpr float kMaxHaloWidth = 64;
/// A neighbour that is nearer by a steeper slope, as at a step, counts as this.
inline constexpr float kEyeDomeSlope = 4;

}  // namespace limn
