// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Reference/ReferenceDataTone.h"

#include "Rendering/Base/Power.h"

namespace limn::reference {
namespace {

/// (f(X / X_n), f(Y / Y_n), f(Z / Z_n)) of CIE 15. L* = 116 f_y - 16, a* = 500 (f_x - f_y) and b* =
/// 200 (f_y - f_z): with a* and b* kept, another L* adds the same number to all three.
using LabRoots = Vec3f;

float bounded(float x)
{
  return x > 0.0f ? (x < 1.0f ? x : 1.0f) : 0.0f;
}
Vec3f bounded(Vec3f color)
{
  return {bounded(color.x), bounded(color.y), bounded(color.z)};
}

/// IEC 61966-2-1.
float decoded(float c)
{
  return c > 0.04045f ? power((c + 0.055f) / 1.055f, 2.4f) : c / 12.92f;
}
float encoded(float c)
{
  return c > 0.0031308f ? 1.055f * power(c, 1.0f / 2.4f) - 0.055f : 12.92f * c;
}

/// CIE 15: the cube root, and its tangent from (6/29)^3 down.
float root(float t)
{
  return t > 0.00885645167f ? power(t, 1.0f / 3.0f) : 7.78703704f * t + 0.137931034f;
}
float cube(float f)
{
  return f > 0.206896552f ? f * f * f : (f - 0.137931034f) * 0.128418549f;
}

/// By the primaries of sRGB, each line divided by the white point, so that its sum is 1.
LabRoots rootsOf(Vec3f rgb)
{
  const float r = decoded(rgb.x), g = decoded(rgb.y), b = decoded(rgb.z);
  return {root((0.433949941f * r + 0.376209770f * g) + 0.189840289f * b),
          root((0.212672874f * r + 0.715152135f * g) + 0.0721749903f * b),
          root((0.0177565759f * r + 0.109467955f * g) + 0.872775469f * b)};
}

/// Linear RGB; the inverse of the lines above.
Vec3f linearOf(LabRoots f)
{
  const float x = cube(f.x), y = cube(f.y), z = cube(f.z);
  return {(3.07995511f * x - 1.53713900f * y) - 0.542816110f * z,
          (-0.921258630f * x + 1.87601112f * y) + 0.0452475100f * z,
          (0.0528874000f * x - 0.204025870f * y) + 1.15113847f * z};
}

LabRoots moved(LabRoots f, float by)
{
  return f + Vec3f{by, by, by};
}

bool isInGamut(LabRoots f)
{
  // A share of a byte, for colours on the gamut's edge.
  constexpr float kSlack = 1e-5f;
  const Vec3f c = linearOf(f);
  const auto fits = [](float v) { return v >= -kSlack && v <= 1.0f + kSlack; };
  return fits(c.x) && fits(c.y) && fits(c.z);
}

/// Along the line each of linear red, green and blue grows with L*, so that what fits is one piece
/// about the colour: halving finds its end.
float room(LabRoots f, float step)
{
  if (isInGamut(moved(f, step))) return 1.0f;
  float most = 0.0f, half = 0.5f;
  for (int i = 0; i < 10; ++i) {
    if (isInGamut(moved(f, step * (most + half)))) most = most + half;
    half = half * 0.5f;
  }
  return most;
}

constexpr float kRootsOfLightness = 1.0f / 116.0f;

Vec3f legendSafe(Vec3f color, float range, float cosine)
{
  const LabRoots f = rootsOf(bounded(color));
  const float most = range * kRootsOfLightness;
  const float share = room(f, cosine < 0.0f ? -most : most);
  const Vec3f linear = bounded(linearOf(moved(f, (most * share) * cosine)));
  return {encoded(linear.x), encoded(linear.y), encoded(linear.z)};
}

Vec3f undertone(const Style& style, Vec3f color, float cosine)
{
  const auto ofGrey = [](Vec3f tone, float surface) {
    const float grey = 0.5f * surface;
    return tone + Vec3f{grey, grey, grey};
  };
  const bool isExaggerated = style.tone == Tone::kExaggerated;
  const Vec3f cool = isExaggerated ? Vec3f{0, 0, 0} : ofGrey(style.toneCool, style.coolSurface);
  const Vec3f warm =
      isExaggerated ? ofGrey({0, 0, 0}, 1) : ofGrey(style.toneWarm, style.warmSurface);
  const float facing = (1.0f + cosine) * 0.5f, averted = (1.0f - cosine) * 0.5f;
  return bounded(color) * (1.0f - style.undertone) +
         (warm * facing + cool * averted) * style.undertone;
}

}  // namespace

Vec3f labOf(Vec3f rgb)
{
  const LabRoots f = rootsOf(rgb);
  return {116.0f * f.y - 16.0f, 500.0f * (f.x - f.y), 200.0f * (f.y - f.z)};
}

float roomInGamut(Vec3f rgb, float step)
{
  return room(rootsOf(rgb), step * kRootsOfLightness);
}

Vec3f dataTone(const Style& style, Vec3f color, float cosine)
{
  return style.toneOverData == ToneOverData::kUndertone
             ? undertone(style, color, cosine)
             : legendSafe(color, style.legendSafeRange, cosine);
}

}  // namespace limn::reference
