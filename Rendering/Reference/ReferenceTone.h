// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Scene.h"

/// The formulas of ToneStyle.h and of outlines by normals, each from numbers of one point.
namespace limn::reference {

/// A value at a point, and a pixel to the right and above.
struct ScreenValues {
  float here, right, above;
};
/// |grad| of it, per pixel.
float slopeOf(ScreenValues values);

/// From 0 to 1 as x does, and level there.
float smoothStep(float x);

/// Style::toonBands of t.
float stepped(float t, float slope, int bands);
/// A highlight, all or nothing.
float onOff(float highlight, float slope);
/// How much of a pixel the line of Style::evenOutline covers, g = n.v, f that of the triangle.
float evenLine(ScreenValues g, float f, float width);

/// Tone::kMetal's grey.
float metalGrey(Vec3f n, Vec3f l);

/// c of Tone::kExaggerated.
struct ExaggeratedPoint {
  Vec3f l, n;                ///< n_0
  Span<const Vec3f> smooth;  ///< n_1 to n_L
  float ratio;               ///< Attributes::smoothRatio
};
float exaggerated(const Exaggeration& exaggeration, const ExaggeratedPoint& point);

/// D of Tone::kRamp.
struct DetailOf {
  float depth;  ///< z
  float nv, rv;
};
float rampDetail(const ToneRamp& ramp, const Camera& camera, const DetailOf& point);
Vec3f rampColor(const ToneRamp& ramp, float u, float v);
/// Tone::kMatCap's.
Vec3f matCapColor(const ToneRamp& ramp, Vec3f n, Vec3f v);

}  // namespace limn::reference
