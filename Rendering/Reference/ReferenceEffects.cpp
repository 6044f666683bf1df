// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Reference/ReferenceEffects.h"

#include "Rendering/Vertex/ThinLens.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace limn::reference {
namespace {

/// Colours of a rectangle of pixels, black outside.
class Image {
 public:
  Image(int width, int height)
      : width_(width),
        height_(height),
        pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
  {
  }

  int width() const { return width_; }
  int height() const { return height_; }
  bool holds(int x, int y) const { return x >= 0 && y >= 0 && x < width_ && y < height_; }
  Vec3f at(int x, int y) const { return holds(x, y) ? pixels_[index(x, y)] : Vec3f{0, 0, 0}; }
  void set(int x, int y, Vec3f color) { pixels_[index(x, y)] = color; }

  /// An image of width x height pixels with color(x, y) in each.
  template <class Color>
  static Image of(int width, int height, Color color)
  {
    Image image(width, height);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        image.set(x, y, color(x, y));
    return image;
  }

 private:
  std::size_t index(int x, int y) const
  {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(x);
  }

  int width_, height_;
  std::vector<Vec3f> pixels_;
};

float clamped(float x, float low, float high)
{
  return x > low ? (x < high ? x : high) : low;
}

std::uint8_t toByte(float x)
{
  return static_cast<std::uint8_t>(std::nearbyint(clamped(x, 0.0f, 1.0f) * 255.0f));
}

std::ptrdiff_t indexOf(const FrameView& frame, int x, int y)
{
  return y * frame.rowStride + x;
}

Image exposed(const FrameView& frame, float exposure)
{
  return Image::of(frame.width, frame.height, [&](int x, int y) {
    const std::ptrdiff_t i = indexOf(frame, x, y);
    const auto channel = [&](const float* plane) {
      return clamped(plane[i] * exposure, 0.0f, kMaxRadiance);
    };
    return Vec3f{channel(frame.radiance.r), channel(frame.radiance.g), channel(frame.radiance.b)};
  });
}

/// The disc of a pixel on the film.
struct Disc {
  float depth, radius;
  float share;  ///< of its light that each pixel gets: 1 / area
};

class LensBlur {
 public:
  LensBlur(const DepthOfField& depthOfField, const Camera& camera, const FrameView& frame)
      : lens_(thinLens(depthOfField, camera, frame.height)),
        largest_(static_cast<float>(depthOfField.maxRadius)),
        frame_(frame)
  {
    for (int y = 0; y < frame.height; ++y)
      for (int x = 0; x < frame.width; ++x) {
        discs_.push_back(makeDisc(frame.depth[indexOf(frame, x, y)]));
        alpha_.push_back(frame.color[indexOf(frame, x, y)].a);
      }
  }

  Image blur(const Image& sharp) const
  {
    return Image::of(sharp.width(), sharp.height(),
                     [&](int x, int y) { return gather(sharp, x, y); });
  }

 private:
  Disc makeDisc(float depth) const
  {
    const float r = clamped(std::fabs(lens_.slope * depth + lens_.offset), 0.5f, largest_);
    return {depth, r, 1.0f / (1.0f + 3.14159265f * (r * r - 0.25f))};
  }
  std::size_t place(int x, int y) const
  {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(frame_.width) +
           static_cast<std::size_t>(x);
  }

  Vec3f gather(const Image& sharp, int x, int y) const
  {
    const Disc here = discs_[place(x, y)];
    const int reach = static_cast<int>(largest_);
    Vec3f sum = {0, 0, 0};
    float alpha = 0, weights = 0;
    for (int dy = -reach; dy <= reach; ++dy)
      for (int dx = -reach; dx <= reach; ++dx) {
        if (!sharp.holds(x + dx, y + dy)) continue;
        Disc disc = discs_[place(x + dx, y + dy)];
        if (disc.depth > here.depth && here.radius < disc.radius)
          disc = {disc.depth, here.radius, here.share};
        const float distance = std::sqrt(static_cast<float>(dx * dx + dy * dy));
        const float covered = clamped((disc.radius + 0.5f) - distance, 0.0f, 1.0f);
        const float weight = covered * disc.share;
        weights = weights + weight;
        sum = sum + sharp.at(x + dx, y + dy) * weight;
        alpha = alpha + weight * alpha_[place(x + dx, y + dy)];
      }
    frame_.color[indexOf(frame_, x, y)].a =
        static_cast<std::uint8_t>(std::nearbyint(alpha / weights));
    return {sum.x / weights, sum.y / weights, sum.z / weights};
  }

  ThinLens lens_;
  float largest_;
  const FrameView& frame_;
  std::vector<Disc> discs_;
  std::vector<float> alpha_;
};

Vec3f brightPart(Vec3f color, float threshold)
{
  const float largest = std::max({color.x, color.y, color.z});
  return largest > threshold ? color * ((largest - threshold) / largest) : Vec3f{0, 0, 0};
}

Vec3f binomial(Vec3f a, Vec3f b, Vec3f c, Vec3f d, Vec3f e)
{
  return (((a + e) + (b + d) * 4.0f) + c * 6.0f) * (1.0f / 16);
}

/// Half as large: columns first, then rows.
Image reduced(const Image& fine)
{
  const auto column = [&](int x, int y) {
    return binomial(fine.at(x, y - 2), fine.at(x, y - 1), fine.at(x, y), fine.at(x, y + 1),
                    fine.at(x, y + 2));
  };
  return Image::of((fine.width() + 1) / 2, (fine.height() + 1) / 2, [&](int i, int j) {
    const int x = 2 * i, y = 2 * j;
    return binomial(column(x - 2, y), column(x - 1, y), column(x, y), column(x + 1, y),
                    column(x + 2, y));
  });
}

/// What a pixel of the next finer level has of this one. Columns first, then rows.
Vec3f expanded(const Image& coarse, int x, int y)
{
  const auto between = [](bool isEven, Vec3f a, Vec3f b, Vec3f c) {
    return isEven ? ((a + c) + b * 6.0f) * (1.0f / 8) : (b + c) * 0.5f;
  };
  const auto column = [&](int i) {
    const int j = y / 2;
    return between(y % 2 == 0, coarse.at(i, j - 1), coarse.at(i, j), coarse.at(i, j + 1));
  };
  return between(x % 2 == 0, column(x / 2 - 1), column(x / 2), column(x / 2 + 1));
}

Image added(const Image& fine, const Image& coarse, float scale)
{
  return Image::of(fine.width(), fine.height(),
                   [&](int x, int y) { return fine.at(x, y) + expanded(coarse, x, y) * scale; });
}

Image bloomed(const Image& image, const Bloom& bloom)
{
  std::vector<Image> levels;
  levels.push_back(Image::of(image.width(), image.height(), [&](int x, int y) {
    return brightPart(image.at(x, y), bloom.threshold);
  }));
  for (int level = 1; level <= bloom.levels; ++level)
    levels.push_back(reduced(levels.back()));
  Image sum = levels.back();
  for (int level = bloom.levels - 1; level >= 1; --level)
    sum = added(levels[static_cast<std::size_t>(level)], sum, 1);
  return added(image, sum, bloom.strength / static_cast<float>(bloom.levels));
}

Vec3f divided(Vec3f color, float by)
{
  return {color.x / by, color.y / by, color.z / by};
}

Vec3f toneMapped(Vec3f c, const PostEffects& effects)
{
  const float luminance = dot(c, Vec3f{0.2126f, 0.7152f, 0.0722f});
  const auto academy = [](float x) {
    return (x * (2.51f * x + 0.03f)) / (x * (2.43f * x + 0.59f) + 0.14f);
  };
  switch (effects.toneMapping) {
    case ToneMapping::kReinhard:
      return divided(c, 1.0f + luminance);
    case ToneMapping::kReinhardExtended:
      return divided(c * (1.0f + luminance / (effects.whitePoint * effects.whitePoint)),
                     1.0f + luminance);
    case ToneMapping::kAces:
      return {academy(c.x), academy(c.y), academy(c.z)};
    default:
      return c;
  }
}

void writeBytes(const Image& image, const PostEffects& effects, const FrameView& frame)
{
  for (int y = 0; y < frame.height; ++y)
    for (int x = 0; x < frame.width; ++x) {
      const Vec3f color = toneMapped(image.at(x, y), effects);
      Rgba8& out = frame.color[indexOf(frame, x, y)];
      out = {toByte(color.x), toByte(color.y), toByte(color.z), out.a};
    }
}

/// FXAA with the comments' names: C is the pixel, N S W E its neighbours, HC the neighbour across
/// the edge. N is below, as VTK's textures lie.
class EdgeSmoothing {
 public:
  EdgeSmoothing(const Fxaa& fxaa, const FrameView& frame) : fxaa_(fxaa), frame_(frame)
  {
    for (int y = 0; y < frame.height; ++y)
      for (int x = 0; x < frame.width; ++x)
        old_.push_back(frame.color[indexOf(frame, x, y)]);
  }

  void smoothAll() const
  {
    for (int y = 0; y < frame_.height; ++y)
      for (int x = 0; x < frame_.width; ++x)
        if (standsOut(x, y)) frame_.color[indexOf(frame_, x, y)] = smooth(x, y);
  }

 private:
  Rgba8 old(int x, int y) const
  {
    const int column = std::min(std::max(x, 0), frame_.width - 1);
    const int row = std::min(std::max(y, 0), frame_.height - 1);
    return old_[static_cast<std::size_t>(row) * static_cast<std::size_t>(frame_.width) +
                static_cast<std::size_t>(column)];
  }
  Vec3f color(int x, int y) const
  {
    const Rgba8 c = old(x, y);
    return {static_cast<float>(c.r), static_cast<float>(c.g), static_cast<float>(c.b)};
  }
  float luma(int x, int y) const
  {
    return dot(color(x, y), Vec3f{0.299f, 0.587f, 0.114f}) * (1.0f / 255);
  }
  float range(int x, int y, float& most) const
  {
    const float c = luma(x, y), n = luma(x, y - 1), s = luma(x, y + 1), w = luma(x - 1, y),
                e = luma(x + 1, y);
    most = std::max({c, n, s, w, e});
    return most - std::min({c, n, s, w, e});
  }
  bool standsOut(int x, int y) const
  {
    float most;
    const float contrast = range(x, y, most);
    return contrast >=
           std::max(fxaa_.hardContrastThreshold, fxaa_.relativeContrastThreshold * most);
  }

  Rgba8 smooth(int x, int y) const
  {
    const float c = luma(x, y), n = luma(x, y - 1), s = luma(x, y + 1), w = luma(x - 1, y),
                e = luma(x + 1, y);
    const float nw = luma(x - 1, y - 1), ne = luma(x + 1, y - 1), sw = luma(x - 1, y + 1),
                se = luma(x + 1, y + 1);

    float most;
    const float contrast = range(x, y, most);
    const float average = 0.25f * ((n + s) + (w + e));
    const float excess = std::fabs(average - c) / contrast - fxaa_.subpixelContrastThreshold;
    const float blend = excess > 0.0f
                            ? std::min(excess * (1.0f / (1.0f - fxaa_.subpixelContrastThreshold)),
                                       fxaa_.subpixelBlendLimit)
                            : 0.0f;
    Vec3f mean = {0, 0, 0};
    for (int j = y - 1; j <= y + 1; ++j)
      for (int i = x - 1; i <= x + 1; ++i)
        mean = mean + color(i, j);
    mean = mean * (1.0f / 9);

    const float vertical =
        ((2.0f * std::fabs(-2.0f * c + (w + e)) + std::fabs(-2.0f * n + (nw + ne))) +
         std::fabs(-2.0f * s + (sw + se))) /
        12.0f;
    const float horizontal =
        ((2.0f * std::fabs(-2.0f * c + (n + s)) + std::fabs(-2.0f * w + (nw + sw))) +
         std::fabs(-2.0f * e + (ne + se))) /
        12.0f;
    Edge edge = {x, y, c, 0, 0, 0, 0, 0};
    if (horizontal >= vertical) {
      edge.alongX = 1;
      edge.acrossY = std::fabs(c - n) >= std::fabs(c - s) ? -1 : 1;
    } else {
      edge.alongY = 1;
      edge.acrossX = std::fabs(c - w) >= std::fabs(c - e) ? -1 : 1;
    }
    edge.lumaAcross = luma(x + edge.acrossX, y + edge.acrossY);

    const float offset = fxaa_.highQualityEndpoints ? offsetByPixels(edge) : offsetByMeans(edge);
    const Vec3f moved =
        color(x, y) * (1.0f - offset) + color(x + edge.acrossX, y + edge.acrossY) * offset;
    const Vec3f result = moved * (1.0f - blend) + mean * blend;
    const auto byte = [](float v) { return static_cast<std::uint8_t>(std::nearbyint(v)); };
    return {byte(result.x), byte(result.y), byte(result.z), old(x, y).a};
  }

  struct Edge {
    int x, y;
    float luma, lumaAcross;
    int alongX, alongY, acrossX, acrossY;
  };
  float sideLuma(const Edge& e, int step) const
  {
    return luma(e.x + step * e.alongX, e.y + step * e.alongY);
  }
  float acrossLuma(const Edge& e, int step) const
  {
    return luma(e.x + step * e.alongX + e.acrossX, e.y + step * e.alongY + e.acrossY);
  }
  static float offsetAt(int nearer, int farther)
  {
    return 0.5f - static_cast<float>(nearer) / static_cast<float>(nearer + farther);
  }

  /// VTK's search for the ends of the edge. `direction` is -1 or 1; returns the pixels to the end.
  int endByPixels(const Edge& e, int direction, float& end) const
  {
    for (int step = 1; step <= fxaa_.endpointSearchIterations; ++step) {
      end = sideLuma(e, direction * step);
      const float across = acrossLuma(e, direction * step);
      if (std::fabs(across - e.lumaAcross) > std::fabs(across - e.luma) ||
          std::fabs(end - e.luma) > std::fabs(end - e.lumaAcross))
        return step;
    }
    return fxaa_.endpointSearchIterations + 1;
  }
  float offsetByPixels(const Edge& e) const
  {
    float lumaBefore = 0, lumaAfter = 0;
    const int before = endByPixels(e, -1, lumaBefore), after = endByPixels(e, 1, lumaAfter);
    const float end = before < after ? lumaBefore : lumaAfter;
    const bool isMoved = fxaa_.endpointSearchIterations > 0 &&
                         std::fabs(end - e.lumaAcross) < std::fabs(end - e.luma);
    return isMoved ? offsetAt(std::min(before, after), std::max(before, after)) : 0.0f;
  }

  /// Lottes's search: by the mean of both sides.
  int endByMeans(const Edge& e, int direction, float& end) const
  {
    const float mean = 0.5f * (e.luma + e.lumaAcross);
    for (int step = 1; step <= fxaa_.endpointSearchIterations; ++step) {
      end = 0.5f * (sideLuma(e, direction * step) + acrossLuma(e, direction * step));
      if (std::fabs(end - mean) >= std::fabs(e.luma - e.lumaAcross) / 4.0f) return step;
    }
    return fxaa_.endpointSearchIterations + 1;
  }
  float offsetByMeans(const Edge& e) const
  {
    const float mean = 0.5f * (e.luma + e.lumaAcross);
    float meanBefore = 0, meanAfter = 0;
    const int before = endByMeans(e, -1, meanBefore), after = endByMeans(e, 1, meanAfter);
    const float end = before < after ? meanBefore : meanAfter;
    const bool isMoved = fxaa_.endpointSearchIterations > 0 && (e.luma < mean) != (end < mean);
    return isMoved ? offsetAt(std::min(before, after), std::max(before, after)) : 0.0f;
  }

  const Fxaa& fxaa_;
  const FrameView& frame_;
  std::vector<Rgba8> old_;
};

}  // namespace

void applyEffects(const PostEffects& effects, const Camera& camera, const FrameView& frame)
{
  if (effects.needRadiance()) {
    Image image = exposed(frame, effects.exposure);
    if (effects.depthOfField.aperture > 0)
      image = LensBlur(effects.depthOfField, camera, frame).blur(image);
    if (effects.bloom.strength > 0) image = bloomed(image, effects.bloom);
    writeBytes(image, effects, frame);
  }
  if (effects.fxaa.enabled) EdgeSmoothing(effects.fxaa, frame).smoothAll();
}

}  // namespace limn::reference
