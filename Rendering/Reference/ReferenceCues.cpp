// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Reference/ReferenceCues.h"

#include "Rendering/Base/Power.h"
#include "Rendering/Base/ResolveTable.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace limn::reference {
namespace {

struct Pixel {
  int x, y;
};

/// Of one channel, of the share of a pixel that some of its samples have.
struct Change {
  std::uint8_t from, to;
  double samples;
};

std::uint8_t toByte(float x)
{
  return static_cast<std::uint8_t>(std::nearbyint(std::clamp(x, 0.0f, 255.0f)));
}

/// exp(x).
float exponential(float x)
{
  return power_detail::exp2Clamped(x * 1.44269504f);
}

/// The mean of the distances around, by a Gaussian on blocks of pixels.
class Blocks {
 public:
  /// Of the frame; `layers` has so many pixels more on all sides.
  Blocks(const FrameView& frame, const std::vector<Layer>& layers, int apron, float sigma)
      : side_(std::max(1, static_cast<int>(std::floor(sigma / 8.0f)))),
        width_((frame.width + side_ - 1) / side_),
        height_((frame.height + side_ - 1) / side_)
  {
    distance_.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
    weight_.resize(distance_.size());
    for (int y = 0; y < frame.height; ++y)
      for (int x = 0; x < frame.width; ++x) {
        const int i = (y + apron) * (frame.width + 2 * apron) + x + apron;
        const Layer& layer = layers[static_cast<std::size_t>(i)];
        if (layer.instance == kNobody) continue;
        distance_[index(x / side_, y / side_)] += -layer.point.position.z;
        weight_[index(x / side_, y / side_)] += 1.0f;
      }
    const float s = sigma / static_cast<float>(side_);
    const int reach = static_cast<int>(std::ceil(3.0f * s));
    std::vector<float> kernel;
    for (int k = -reach; k <= reach; ++k)
      kernel.push_back(exponential(-static_cast<float>(k * k) / (2.0f * s * s)));
    for (std::vector<float>* plane : {&distance_, &weight_}) {
      *plane = convolved(*plane, kernel, 1, 0);
      *plane = convolved(*plane, kernel, 0, 1);
    }
  }

  float meanAt(Pixel p) const { return between(distance_, p) / between(weight_, p); }

 private:
  std::size_t index(int x, int y) const
  {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(x);
  }

  std::vector<float> convolved(const std::vector<float>& plane, const std::vector<float>& kernel,
                               int dx, int dy) const
  {
    const int reach = static_cast<int>(kernel.size() / 2);
    std::vector<float> result(plane.size());
    for (int y = 0; y < height_; ++y)
      for (int x = 0; x < width_; ++x) {
        float sum = 0;
        for (int k = -reach; k <= reach; ++k) {
          const int bx = x + k * dx, by = y + k * dy;
          if (bx < 0 || by < 0 || bx >= width_ || by >= height_) continue;
          sum += kernel[static_cast<std::size_t>(k + reach)] * plane[index(bx, by)];
        }
        result[index(x, y)] = sum;
      }
    return result;
  }

  /// Between the centres of four blocks; those at the border go on beyond it.
  float between(const std::vector<float>& plane, Pixel p) const
  {
    const auto side = static_cast<float>(side_);
    const float u = (static_cast<float>(p.x) + 0.5f) / side - 0.5f;
    const float v = (static_cast<float>(p.y) + 0.5f) / side - 0.5f;
    const float left = std::floor(u), below = std::floor(v);
    const float s = u - left, t = v - below;
    const auto at = [&](int dx, int dy) {
      return plane[index(std::clamp(static_cast<int>(left) + dx, 0, width_ - 1),
                         std::clamp(static_cast<int>(below) + dy, 0, height_ - 1))];
    };
    const float first = at(0, 0) + (at(0, 1) - at(0, 0)) * t;
    const float second = at(1, 0) + (at(1, 1) - at(1, 0)) * t;
    return first + (second - first) * s;
  }

  int side_, width_, height_;
  std::vector<float> distance_, weight_;
};

class Cues {
 public:
  Cues(const Scene& scene, const FrameView& frame, std::vector<Layer>& layers, int apron)
      : scene_(scene),
        frame_(frame),
        layers_(layers),
        apron_(apron),
        borders_(layers.size()),
        halos_(layers.size()),
        cues_(layers.size())
  {
    const auto width = static_cast<float>(frame.width), height = static_cast<float>(frame.height);
    diagonal_ = std::sqrt(width * width + height * height);
  }

  void draw()
  {
    for (const Instance& instance : scene_.instances)
      if (hasCues(instance) && instance.style.cues.unsharp.strength > 0)
        blocks_.try_emplace(instance.style.cues.unsharp.radius, frame_, layers_, apron_,
                            instance.style.cues.unsharp.radius * diagonal_);
    for (int y = -apron_; y < frame_.height + apron_; ++y)
      for (int x = -apron_; x < frame_.width + apron_; ++x) {
        const Pixel p = {x, y};
        if (!isSurface(p)) continue;
        borders_[index(p)] = borderAt(p);
        layers_[index(p)].endsHere = borders_[index(p)].overOthers;
      }
    for (int y = 0; y < frame_.height; ++y)
      for (int x = 0; x < frame_.width; ++x)
        findHalo({x, y});
    forEachPixel([&](Pixel p) { cues_[index(p)] = cueAt(p); });
    forEachPixel([&](Pixel p) {
      paintRest(p);
      paint(p);
    });
  }

 private:
  struct HaloAt {
    float share = 0;
    std::size_t of = 0;  ///< the pixel whose surface has it
  };

  /// Of a surface with a halo.
  struct Border {
    bool overOthers = false, overItself = false;
  };

  /// What changes a colour.
  struct Cue {
    float factor = 1, light = 0, halo = 0;
    Vec3f color = {0, 0, 0};  ///< of the halo

    bool isNone() const { return factor == 1 && light == 0 && halo == 0; }
  };

  Cue cueAt(Pixel p) const
  {
    const HaloAt& halo = halos_[index(p)];
    Cue cue = {eyeDomeAt(p), unsharpAt(p), halo.share, {0, 0, 0}};
    if (halo.share > 0)
      cue.color = scene_.instances[layers_[halo.of].instance].style.cues.halo.color;
    return cue;
  }

  /// Of the frame, those that show something.
  template <class Visit>
  void forEachPixel(Visit visit) const
  {
    for (int y = 0; y < frame_.height; ++y)
      for (int x = 0; x < frame_.width; ++x)
        if (layer({x, y}).instance != kNobody) visit(Pixel{x, y});
  }
  std::size_t index(Pixel p) const
  {
    return static_cast<std::size_t>((p.y + apron_) * (frame_.width + 2 * apron_) + p.x + apron_);
  }
  const Layer& layer(Pixel p) const { return layers_[index(p)]; }
  bool isInFrame(Pixel p) const
  {
    return p.x >= 0 && p.y >= 0 && p.x < frame_.width && p.y < frame_.height;
  }
  /// Of the frame and the apron.
  bool isInside(Pixel p) const
  {
    return p.x >= -apron_ && p.y >= -apron_ && p.x < frame_.width + apron_ &&
           p.y < frame_.height + apron_;
  }
  bool isSurface(Pixel p) const { return isInside(p) && layer(p).instance != kNobody; }
  const DepthCues& cuesAt(Pixel p) const
  {
    static const DepthCues none;
    const Instance& instance = scene_.instances[layer(p).instance];
    return hasCues(instance) ? instance.style.cues : none;
  }
  float distance(Pixel p) const { return -layer(p).point.position.z; }
  float pixelWidth(Pixel p) const { return layer(p).point.pixel; }

  /// The mean response of a ring of eight directions.
  float ring(Pixel p, float radius, bool isTurned) const
  {
    const float c = isTurned ? 0.923879533f : 1.0f, s = isTurned ? 0.382683432f : 0.0f;
    const float h = 0.707106781f;
    const Vec2f first = {c, s}, second = {h * (c - s), h * (c + s)};
    const float most = kEyeDomeSlope * pixelWidth(p);
    float sum = 0;
    for (Vec2f way : {first, second, Vec2f{-first.y, first.x}, Vec2f{-second.y, second.x},
                      Vec2f{-first.x, -first.y}, Vec2f{-second.x, -second.y},
                      Vec2f{first.y, -first.x}, Vec2f{second.y, -second.x}}) {
      const float dx = std::nearbyint(way.x * radius), dy = std::nearbyint(way.y * radius);
      const Pixel q = {p.x + static_cast<int>(dx), p.y + static_cast<int>(dy)};
      if (!isInFrame(q) || !isSurface(q)) continue;
      const float step = std::max(0.0f, distance(p) - distance(q));
      sum += std::min(step * (1.0f / std::sqrt(dx * dx + dy * dy)), most);
    }
    return sum;
  }

  float eyeDomeAt(Pixel p) const
  {
    const EyeDomeLighting& cue = cuesAt(p).eyeDome;
    if (cue.strength == 0) return 1;
    const float r = std::max(1.0f, cue.radius * diagonal_), w = pixelWidth(p);
    const float fine = ring(p, r, false);
    const float coarse =
        (ring(p, 2.0f * r, true) + ring(p, 3.0f * r, false)) + ring(p, 4.0f * r, true);
    const float mean = (fine / 8.0f + coarse / 24.0f) * 0.5f;
    return exponential(-cue.strength * (mean / w));
  }

  /// How much lighter; below 0 darker.
  float unsharpAt(Pixel p) const
  {
    const DepthUnsharp& cue = cuesAt(p).unsharp;
    if (cue.strength == 0) return 0;
    const float difference = blocks_.at(cue.radius).meanAt(p) - distance(p);
    const float g = difference / (cue.radius * diagonal_ * pixelWidth(p));
    const float x = g / (1.0f + std::fabs(g));
    return x > 0 && !cue.lightens ? 0.0f : cue.strength * x;
  }

  /// Whether the surface at q ends there and has a halo: over other instances, or over parts of
  /// its own, too.
  Border borderAt(Pixel q) const
  {
    const Halo& halo = cuesAt(q).halo;
    Border border;
    if (halo.width == 0) return border;
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const Pixel r = {q.x + dx, q.y + dy};
        if (!isInside(r) || (dx == 0 && dy == 0)) continue;
        const bool isSame = layer(r).instance == layer(q).instance;
        if (!isSurface(r)) {
          border.overOthers = true;
          continue;
        }
        const float jump = distance(r) - distance(q);
        if (!(jump > halo.depth * pixelWidth(q))) continue;
        // A rounded surface gets steep by and by.
        const float before = slopeTo({q.x - dx, q.y - dy}, q, q);
        const float after = slopeTo({r.x + dx, r.y + dy}, r, q);
        if (!isSame) border.overOthers = true;
        if (isSame && jump > 2.0f * std::max(before, after))
          border.overOthers = border.overItself = true;
      }
    return border;
  }

  /// How much the distance changes from pixel a to b, if both show the instance of q.
  float slopeTo(Pixel a, Pixel b, Pixel q) const
  {
    const bool isSame = isSurface(a) && layer(a).instance == layer(q).instance;
    return isSame ? std::fabs(distance(a) - distance(b)) : 0.0f;
  }

  /// How wide the halo of the surface at q is over what p shows.
  float haloWidth(Pixel p, Pixel q) const
  {
    const Halo& halo = cuesAt(q).halo;
    if (!isSurface(p)) return halo.width;  // of lines there, which may be as far
    const float behind = distance(p) - distance(q);
    if (!(behind > 0)) return 0;
    if (layer(p).instance == layer(q).instance &&
        !(borders_[index(q)].overItself &&
          isStep(layer(p), layer(q),
                 std::max(toleranceAt(scene_, layer(p)), toleranceAt(scene_, layer(q))))))
      return 0;
    const float full = halo.depth * halo.width * pixelWidth(q);
    const float t = std::min(1.0f, behind / full);
    return halo.width * ((t * t) * (3.0f - 2.0f * t));
  }

  /// How much of q its surface covers.
  float coveredShare(Pixel q) const
  {
    return static_cast<float>(layer(q).count) / static_cast<float>(scene_.samples);
  }

  /// How much of p is in the halo of the surface at q, and above 1 how far this goes on beyond p.
  float haloReach(Pixel p, Pixel q) const
  {
    const float width = haloWidth(p, q);
    if (width == 0) return 0;
    const auto dx = static_cast<float>(p.x - q.x), dy = static_cast<float>(p.y - q.y);
    const float fromBorder = std::sqrt(dx * dx + dy * dy) - (coveredShare(q) - 0.5f);
    return std::max(0.0f, width + 0.5f - fromBorder);
  }

  /// The widest halo over p; of equal ones that of the nearer surface, then of the first pixel.
  void findHalo(Pixel p)
  {
    int reach = 0;
    for (const Instance& instance : scene_.instances)
      if (hasCues(instance))
        reach = std::max(reach, static_cast<int>(std::ceil(instance.style.cues.halo.width)) + 1);
    HaloAt& best = halos_[index(p)];
    float farthest = 0;
    for (int y = p.y - reach; y <= p.y + reach; ++y)
      for (int x = p.x - reach; x <= p.x + reach; ++x) {
        const Pixel q = {x, y};
        if (!isInside(q) || !borders_[index(q)].overOthers) continue;
        const float beyond = haloReach(p, q), share = std::min(1.0f, beyond);
        if (beyond > farthest) {
          farthest = beyond;
          layers_[index(p)].haloBeyond = index(q);
        }
        const bool isBetter =
            share > best.share ||
            (share == best.share && share > 0 && distance(q) < -layers_[best.of].point.position.z);
        if (isBetter) best = {share, index(q)};
      }
    layers_[index(p)].halo = best.share;
    layers_[index(p)].haloOf = best.of;
  }

  /// The share that the halo of p has of what its surface leaves of it, which lies behind.
  float haloBehind(Pixel p) const
  {
    if (!borders_[index(p)].overOthers || layer(p).count == scene_.samples) return 0;
    float width = 0;
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const Pixel r = {p.x + dx, p.y + dy};
        if (isSurface(r)) width = std::max(width, haloWidth(r, p));
      }
    return std::min(1.0f, width / (1.0f - coveredShare(p)));
  }

  /// What becomes of a channel, of which `white` is full intensity.
  static float cued(float c, float white, const Cue& cue, float haloed)
  {
    c = c * cue.factor;
    if (cue.light < 0) c = c * (1.0f + cue.light);
    if (cue.light > 0 && c < white) c = c + (white - c) * cue.light;
    return c + (haloed * white - c) * cue.halo;
  }

  /// The samples of p that show other surfaces than its own, which lie behind that.
  void paintRest(Pixel p) const
  {
    const Layer& l = layer(p);
    const int others = l.covered - l.count;
    if (others == 0) return;
    Cue cue = cueBehind(p);
    cue.halo = haloBehind(p);
    cue.color = cuesAt(p).halo.color;
    if (cue.isNone()) return;
    const std::ptrdiff_t at = p.y * frame_.rowStride + p.x;
    Rgba8& pixel = frame_.color[at];
    const auto paintByte = [&](std::uint8_t& channel, std::uint8_t own, float halo) {
      const std::uint8_t from = meanOfRest(channel, own, l, scene_.resolve);
      const std::uint8_t to = toByte(cued(static_cast<float>(from), 255.0f, cue, halo));
      channel = changed(channel, {from, to, static_cast<double>(others)}, l);
    };
    paintByte(pixel.r, l.color.r, cue.color.x);
    paintByte(pixel.g, l.color.g, cue.color.y);
    paintByte(pixel.b, l.color.b, cue.color.z);
    if (frame_.radiance.empty()) return;
    const auto shared = static_cast<float>(l.shared);
    const auto mix = [&](float& value, float own, float halo) {
      const float old = meanOfRest(value, own, l);
      const float change = cued(old, 1.0f, cue, halo) - old;
      value =
          std::clamp(value + change * (static_cast<float>(others) / shared), 0.0f, kMaxRadiance);
    };
    mix(frame_.radiance.r[at], l.radiance.x, cue.color.x);
    mix(frame_.radiance.g[at], l.radiance.y, cue.color.y);
    mix(frame_.radiance.b[at], l.radiance.z, cue.color.z);
  }

  /// Of the farthest pixel around p that is behind it and shows the instance of p's other samples;
  /// of equal ones the first.
  Cue cueBehind(Pixel p) const
  {
    Pixel farthest = p;
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const Pixel r = {p.x + dx, p.y + dy};
        if (isInFrame(r) && isSurface(r) && layer(r).instance == layer(p).other &&
            distance(r) > distance(farthest))
          farthest = r;
      }
    return index(farthest) == index(p) ? Cue{} : cues_[index(farthest)];
  }

  void paint(Pixel p)
  {
    const Cue& cue = cues_[index(p)];
    if (cue.isNone()) return;
    Layer& l = layers_[index(p)];
    const std::ptrdiff_t at = p.y * frame_.rowStride + p.x;
    Rgba8& pixel = frame_.color[at];
    const auto paintByte = [&](std::uint8_t& channel, std::uint8_t& own, float haloed) {
      const std::uint8_t to = toByte(cued(static_cast<float>(own), 255.0f, cue, haloed));
      channel = changed(channel, {own, to, static_cast<double>(l.count)}, l);
      own = to;
    };
    paintByte(pixel.r, l.color.r, cue.color.x);
    paintByte(pixel.g, l.color.g, cue.color.y);
    paintByte(pixel.b, l.color.b, cue.color.z);
    if (frame_.radiance.empty()) return;
    const float part = static_cast<float>(l.count) / static_cast<float>(l.shared);
    const auto paintRadiance = [&](float& value, float& own, float haloed) {
      const float to = cued(own, 1.0f, cue, haloed);
      value = std::clamp(value + (to - own) * part, 0.0f, kMaxRadiance);
      own = to;
    };
    paintRadiance(frame_.radiance.r[at], l.radiance.x, cue.color.x);
    paintRadiance(frame_.radiance.g[at], l.radiance.y, cue.color.y);
    paintRadiance(frame_.radiance.b[at], l.radiance.z, cue.color.z);
  }

  /// A channel of a pixel some of whose samples go from one value to another.
  std::uint8_t changed(std::uint8_t pixel, Change change, const Layer& l) const
  {
    if (scene_.resolve == Resolve::kLinear)
      return toByte(
          static_cast<float>(pixel + change.samples * (change.to - change.from) / l.shared));
    const ResolveTable& table = ResolveTable::gamma22();
    const auto linear = [&](std::uint8_t byte) { return static_cast<double>(table.linear(byte)); };
    const double difference =
        std::nearbyint(change.samples * (linear(change.to) - linear(change.from)));
    const double sum =
        std::clamp(linear(pixel) * l.shared + difference, 0.0, linear(255) * l.shared);
    return table.byteOfMean(static_cast<std::uint32_t>(sum), static_cast<std::uint32_t>(l.shared));
  }

  const Scene& scene_;
  const FrameView& frame_;
  std::vector<Layer>& layers_;
  int apron_;
  std::vector<Border> borders_;
  std::vector<HaloAt> halos_;
  std::vector<Cue> cues_;
  std::map<float, Blocks> blocks_;  ///< by radius
  float diagonal_;
};

}  // namespace

bool hasCues(const Instance& instance)
{
  return instance.style.cues.any() && instance.hull == nullptr && !instance.isTranslucent();
}

const Halo& HalosOverPanes::haloOf(const Layer& border) const
{
  return scene_.instances[border.instance].style.cues.halo;
}

float HalosOverPanes::coveredShare(const Layer& border) const
{
  return static_cast<float>(border.count) / static_cast<float>(scene_.samples);
}

/// How wide the halo of a surface that ends somewhere is over what lies so far.
float HalosOverPanes::widthOver(float distance, const Layer& border) const
{
  const Halo& halo = haloOf(border);
  const float behind = distance - -border.point.position.z;
  if (!(behind > 0)) return 0;
  const float t = std::min(1.0f, behind / (halo.depth * halo.width * border.point.pixel));
  return halo.width * ((t * t) * (3.0f - 2.0f * t));
}

HaloOverPane HalosOverPanes::at(int x, int y, float depth) const
{
  const float middleX = static_cast<float>(x) + 0.5f, middleY = static_cast<float>(y) + 0.5f;
  const float distance = -toView_.at(middleX, middleY, depth).position.z;
  const int place = (y + apron_) * columns_ + x + apron_;
  const Layer& here = layers_[static_cast<std::size_t>(place)];
  HaloOverPane result;
  const auto add = [&](std::size_t pixel) {
    const Layer& border = layers_[pixel];
    const int column = static_cast<int>(pixel) % columns_, row = static_cast<int>(pixel) / columns_;
    const auto dx = static_cast<float>(x - (column - apron_));
    const auto dy = static_cast<float>(y - (row - apron_));
    const float beyond = std::sqrt(dx * dx + dy * dy) - (coveredShare(border) - 0.5f);
    const float width = widthOver(distance, border);
    const float share = width > 0 ? std::clamp(width + 0.5f - beyond, 0.0f, 1.0f) : 0.0f;
    if (share > result.share) result = {share, haloOf(border).color};
  };
  if (here.halo > 0) {
    add(here.haloOf);
    add(here.haloBeyond);
  }
  if (here.endsHere && here.count < scene_.samples) {
    const float left = 1.0f - coveredShare(here);
    const float share = std::min(1.0f, widthOver(distance, here) / left);
    if (share > result.share) result = {share, haloOf(here).color};
  }
  return result;
}

int haloApron(const Scene& scene)
{
  float widest = 0;
  for (const Instance& instance : scene.instances)
    if (hasCues(instance)) widest = std::max(widest, instance.style.cues.halo.width);
  // A halo goes a pixel beyond its width, and how the surface that has it ends, two pixels farther.
  return widest > 0 ? static_cast<int>(std::ceil(widest)) + 3 : 0;
}

void drawCues(const Scene& scene, const FrameView& frame, std::vector<Layer>& layers, int apron)
{
  Cues(scene, frame, layers, apron).draw();
}

}  // namespace limn::reference
