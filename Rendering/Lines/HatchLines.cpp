// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/HatchLines.h"

#include "Rendering/Base/ParallelStretches.h"
#include "Rendering/Base/Power.h"
#include "Rendering/Vertex/PlaceLights.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

constexpr std::size_t kPerTask = 4096;

double bounded(double x)
{
  return x > 0 ? (x < 1 ? x : 1.0) : 0.0;
}

double strongest(Vec3d color)
{
  return std::max({color.x, color.y, color.z});
}

/// Of strokes, in a view.
class RankLimits {
 public:
  RankLimits(const HatchStrokes& strokes, const Mat4d& modelToWorld, const HatchView& view)
      : strokes_(strokes),
        view_(view),
        lights_(placeLights(view.lights, view.camera)),
        toView_(view.camera.worldToView * modelToWorld),
        normalToView_(cofactor3(toView_)),
        side_(determinant3(toView_) < 0 ? -1.0 : 1.0)
  {
  }

  /// The rank below which strokes of a family are drawn at a point.
  double limit(std::uint32_t point, bool isCross) const
  {
    const Vec3d p = transformPoint(toView_, strokes_.points[point]);
    const Vec3d toEye = view_.camera.parallel ? Vec3d{0, 0, 1} : normalized(-p);
    Vec3d n =
        normalized(transformDirection(normalToView_, vec3Cast<double>(strokes_.normals[point]))) *
        side_;
    if (dot(n, toEye) < 0) n = -n;
    const double dark = static_cast<double>(view_.darkest) * (1 - bounded(lightAt(p, n)));
    const double share = isCross ? bounded(2 * dark - 1) : bounded(2 * dark);
    // What a unit of the model across the stroke is on the screen.
    const Vec3d across = transformDirection(toView_, vec3Cast<double>(strokes_.across[point]));
    const Vec3d seen = across - toEye * dot(across, toEye);
    const double pixels = std::sqrt(dot(seen, seen)) * pixelsPerUnit(p);
    return share * (pixels * strokes_.spacing / static_cast<double>(view_.spacing));
  }
  /// Strokes cut corners of the mesh by about so much, in view units.
  double slack() const
  {
    const Vec3d x = transformDirection(toView_, Vec3d{1, 0, 0});
    return 0.5 * strokes_.step * std::sqrt(dot(x, x));
  }

 private:
  double pixelsPerUnit(Vec3d p) const
  {
    const double scale = view_.camera.viewToClip.m[1][1] * view_.height / 2;
    if (view_.camera.parallel) return scale;
    return p.z < 0 ? scale / -p.z : 0.0;
  }
  double lightAt(Vec3d p, Vec3d n) const
  {
    const double sqrtHalf = std::sqrt(0.5);
    if (view_.toneLight == ToneLight::kUpperRight)
      return 0.5 * (1 + dot(n, Vec3d{sqrtHalf, sqrtHalf, 0}));
    Vec3d sum = vec3Cast<double>(view_.ambientLight);
    for (const ViewLight& light : lights_) {
      Vec3d toward = vec3Cast<double>(light.towardLight);
      const double fall = light.positional() ? fallAt(light, p, toward) : 1.0;
      const double nl = dot(n, toward);
      if (nl > 0) sum = sum + vec3Cast<double>(light.color) * (fall * nl);
    }
    return strongest(sum);
  }
  /// And the direction to the light.
  double fallAt(const ViewLight& light, Vec3d p, Vec3d& toward) const
  {
    const Vec3d way = vec3Cast<double>(light.position) - p, axis = toward;
    const double squared = dot(way, way), distance = std::sqrt(squared);
    toward = normalized(way);
    const Vec3d a = vec3Cast<double>(light.attenuation);
    const double denominator = a.x + a.y * distance + a.z * squared;
    double fall = !view_.fallOff ? 1.0 : denominator > 0 ? 1 / denominator : 0.0;
    const double cosine = dot(toward, axis);
    if (light.kind == LightKind::kRectangle) return fall * std::max(0.0, cosine);
    if (light.kind != LightKind::kSpot) return fall;
    if (cosine < static_cast<double>(light.coneCosine)) return 0;
    fall *= static_cast<double>(power(static_cast<float>(cosine), light.exponent));
    const double soft = bounded((cosine - static_cast<double>(light.coneCosine)) *
                                static_cast<double>(light.softScale));
    return light.softScale > 0 ? fall * (soft * soft * (3 - 2 * soft)) : fall;
  }

  const HatchStrokes& strokes_;
  const HatchView& view_;
  std::vector<ViewLight> lights_;
  Mat4d toView_, normalToView_;
  double side_;
};

/// Puts together what is drawn.
class PartWriter {
 public:
  PartWriter(const HatchStrokes& strokes, float slack, ContourLines& lines)
      : strokes_(strokes), slack_(slack), lines_(lines)
  {
    lines_.chains.first.push_back(0);
  }

  /// `width` is that of each of the stroke's points in turn, in widths; below 0 it is not drawn.
  void write(std::size_t stroke, const std::vector<float>& width)
  {
    const std::uint32_t first = strokes_.first[stroke], end = strokes_.first[stroke + 1];
    const auto isDrawn = [&](std::uint32_t i) { return width[i] > 0; };
    const bool isRing = end - first > 3 && strokes_.vertex[first] == strokes_.vertex[end - 1];
    if (!isRing) {
      for (std::uint32_t i = first; i < end; ++i)
        step(i, i > first ? i - 1 : i, width);
    } else {
      // From a point that is not drawn, so that no piece is cut where the ring happens to begin.
      const std::uint32_t count = end - first - 1;
      std::uint32_t start = 0;
      while (start < count && isDrawn(first + start))
        ++start;
      for (std::uint32_t k = 0; k <= count; ++k)
        step(first + (start + k) % count, first + (start + (k > 0 ? k - 1 : 0)) % count, width);
      std::vector<std::uint32_t>& vertex = lines_.chains.vertex;
      // One that is drawn as a whole has no ends.
      if (isOpen_ && start == count) vertex.back() = vertex[lines_.chains.first.back()];
    }
    if (isOpen_) close();
    isOpen_ = false;
  }

 private:
  /// From a point to the next; the first comes from itself.
  void step(std::uint32_t to, std::uint32_t from, const std::vector<float>& width)
  {
    const double here = static_cast<double>(width[to]), before = static_cast<double>(width[from]);
    const bool isDrawn = here > 0;
    if ((before > 0) != isDrawn) {
      const Vec3d a = pointOf(from), b = pointOf(to);
      put(a + (b - a) * (before / (before - here)), 0);
    }
    if (isDrawn) put(pointOf(to), here);
    if (isOpen_ && !isDrawn) close();
    isOpen_ = isDrawn;
  }
  Vec3d pointOf(std::uint32_t i) const { return strokes_.points[strokes_.vertex[i]]; }
  void put(Vec3d p, double width)
  {
    lines_.chains.vertex.push_back(static_cast<std::uint32_t>(lines_.points.size()));
    lines_.points.push_back(p);
    lines_.slack.push_back(slack_);
    lines_.share.push_back(static_cast<float>(std::min(width, kHatchSwell) / kHatchSwell));
  }
  void close()
  {
    lines_.chains.first.push_back(static_cast<std::uint32_t>(lines_.chains.vertex.size()));
  }

  const HatchStrokes& strokes_;
  float slack_;
  ContourLines& lines_;
  bool isOpen_ = false;
};

/// The width of a stroke among others that end where it gets lighter; what is negative grows as it
/// would.
double swollen(double limit, double rank)
{
  const double width = (limit / rank - kRankBegins) / (kRankIsWhole - kRankBegins);
  return width < 1 ? width : 1.0;
}

/// The width of a flat face's stroke where all of the face need the same.
double evenWidth(double limit, double rank)
{
  // Of flat faces' strokes ranks are sqrt(1/2) times a power of two.
  double high = 1;
  while (high > limit && high > rank)
    high *= 0.5;
  const double need = limit / high;
  const double begin = kHatchSwell, end = 1.55;
  const double share = high < 1 ? bounded((need - begin) / (end - begin)) : 0.0;
  const double next = 0.5 * need * share;
  if (rank < high) return std::min(need - next, kHatchSwell);
  return rank < 2 * high && next > 0 ? next : -1.0;
}

/// Strokes of flat faces on which what is needed varies by perspective alone, and what they need:
/// lines that get nearer to each other, as those of a floor do, look better than every other one
/// that ends half way.
class EvenFaces {
 public:
  EvenFaces(const HatchStrokes& strokes, const std::vector<double>& limit)
  {
    for (std::size_t s = 0; s < strokes.strokeCount(); ++s) {
      const std::uint32_t face = strokes.face[s];
      if (face == HatchStrokes::kNoFace) continue;
      if (face >= bounds_.size()) bounds_.resize(face + std::size_t{1});
      Bounds& bounds = bounds_[face];
      for (std::uint32_t i = strokes.first[s]; i < strokes.first[s + 1]; ++i) {
        bounds.low = std::min(bounds.low, limit[i]);
        bounds.high = std::max(bounds.high, limit[i]);
      }
    }
  }
  bool isEven(std::uint32_t face) const
  {
    constexpr double kMostPerspective = 3;
    return face != HatchStrokes::kNoFace &&
           bounds_[face].high <= kMostPerspective * bounds_[face].low;
  }
  double limit(std::uint32_t face) const
  {
    return std::sqrt(bounds_[face].low * bounds_[face].high);
  }

 private:
  struct Bounds {
    double low = 1e300, high = 0;
  };
  std::vector<Bounds> bounds_;
};

}  // namespace

ContourLines hatchLines(const HatchStrokes& strokes, const Mat4d& modelToWorld,
                        const HatchView& view, int threads)
{
  const RankLimits limits(strokes, modelToWorld, view);
  std::vector<double> limit(strokes.vertex.size());
  std::vector<std::uint32_t> strokeOf(strokes.vertex.size());
  for (std::size_t s = 0; s < strokes.strokeCount(); ++s)
    std::fill(strokeOf.begin() + strokes.first[s], strokeOf.begin() + strokes.first[s + 1],
              static_cast<std::uint32_t>(s));
  parallelForEach(threads, limit.size(), kPerTask, [&](std::size_t i) {
    limit[i] = limits.limit(strokes.vertex[i], strokes.isCross[strokeOf[i]] != 0);
  });
  const EvenFaces faces(strokes, limit);
  std::vector<float> width(limit.size());
  parallelForEach(threads, width.size(), kPerTask, [&](std::size_t i) {
    const std::uint32_t face = strokes.face[strokeOf[i]];
    const auto rank = static_cast<double>(strokes.rank[strokeOf[i]]);
    width[i] = static_cast<float>(faces.isEven(face) ? evenWidth(faces.limit(face), rank)
                                                     : swollen(limit[i], rank));
  });
  ContourLines lines;
  PartWriter writer(strokes, static_cast<float>(limits.slack()), lines);
  for (std::size_t s = 0; s < strokes.strokeCount(); ++s)
    writer.write(s, width);
  return lines;
}

}  // namespace limn
