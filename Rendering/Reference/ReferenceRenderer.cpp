// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Reference/ReferenceRenderer.h"

#include "Rendering/Base/ResolveTable.h"
#include "Rendering/Base/SamplePositions.h"
#include "Rendering/Base/TranslucencyBound.h"
#include "Rendering/Mesh/LocalPosition.h"
#include "Rendering/Reference/ReferenceCues.h"
#include "Rendering/Reference/ReferenceHull.h"
#include "Rendering/Reference/ReferenceOutline.h"
#include "Rendering/Reference/ReferenceStrokes.h"
#include "Rendering/Reference/ReferenceShading.h"
#include "Rendering/Vertex/ClipTriangle.h"
#include "Rendering/Vertex/PlaceLights.h"
#include "Rendering/Vertex/ViewSpace.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <vector>

namespace limn::reference {
namespace {

/// Position on the screen, in subpixels.
struct Point {
  std::int64_t x, y;
};

/// Twice the signed area of (a, b, p): positive if p lies to the left of a -> b.
std::int64_t edge(Point a, Point b, Point p)
{
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

/// A triangle on the screen, turned counter-clockwise.
struct ScreenTriangle {
  ScreenVertex vertex[3];
  double weight[3][3];  ///< of the original corners in each vertex
  bool clipped;
  bool clockwise;  ///< as it came
  std::int64_t area;

  Point point(int i) const { return {vertex[i].x, vertex[i].y}; }
  /// Edge function opposite to vertex i.
  std::int64_t edgeValue(int i, Point p) const
  {
    return edge(point((i + 1) % 3), point((i + 2) % 3), p);
  }
  bool covers(Point p) const
  {
    for (int i = 0; i < 3; ++i) {
      const Point a = point((i + 1) % 3), b = point((i + 2) % 3);
      // A sample on an edge belongs to the triangle whose left or top edge it is. Corners run
      // counter-clockwise and y points up: left edges go down, top edges go left.
      const bool topLeft = b.y < a.y || (b.y == a.y && b.x < a.x);
      const std::int64_t e = edge(a, b, p);
      if (topLeft ? e < 0 : e <= 0) return false;
    }
    return true;
  }
  /// Window depth, linear on the screen: z0 + e1/area (z1 - z0) + e2/area (z2 - z0).
  float depth(Point p) const
  {
    const float inverse = 1.0f / static_cast<float>(area);
    const float z1 = (vertex[1].depth - vertex[0].depth) * inverse;
    const float z2 = (vertex[2].depth - vertex[0].depth) * inverse;
    const float e1 = static_cast<float>(edgeValue(1, p));
    const float e2 = static_cast<float>(edgeValue(2, p));
    return vertex[0].depth + (e1 * z1 + e2 * z2);
  }
};

std::optional<ScreenTriangle> orient(ScreenTriangle triangle)
{
  triangle.area = edge(triangle.point(0), triangle.point(1), triangle.point(2));
  if (triangle.area == 0) return std::nullopt;
  triangle.clockwise = triangle.area < 0;
  if (triangle.clockwise) {
    triangle.area = -triangle.area;
    std::swap(triangle.vertex[1], triangle.vertex[2]);
    std::swap(triangle.weight[1], triangle.weight[2]);
  }
  return triangle;
}

/// What the winner of a sample was.
struct Owner {
  std::uint32_t instance = kNobody;
  std::uint32_t triangle = 0;

  bool operator==(const Owner& o) const { return instance == o.instance && triangle == o.triangle; }
  /// In draw order.
  bool operator<(const Owner& o) const
  {
    return instance != o.instance ? instance < o.instance : triangle < o.triangle;
  }
  bool exists() const { return instance != kNobody; }
};

struct Sample {
  float depth;
  Owner owner;
};

bool isNearer(const Sample& a, const Sample& b)
{
  return a.depth != b.depth ? a.depth < b.depth : b.owner < a.owner;
}

/// A triangle in a pixel, and how many of the pixel's samples show it.
struct SeenTriangle {
  Owner owner;
  Vec3f radiance;
  std::size_t samples;
};

/// A pixel of which the opaque surfaces' picture is drawn first, and what translucent ones make of
/// it is kept.
struct Veiled {
  std::ptrdiff_t index;
  Rgba8 below, seen;
  Vec3f belowRadiance, seenRadiance;
  float rest;  ///< the share of what lies below, mean over the samples
};

/// Box of the finite corners of all triangles whose corners are there.
Box boxOfTriangles(const MeshView& mesh)
{
  Box box;
  for (const Triangle& triangle : mesh.triangles) {
    const auto [a, b, c] = triangle.vertex;
    if (std::max({a, b, c}) >= mesh.vertexCount()) continue;
    for (const std::uint32_t v : triangle.vertex)
      if (const Vec3d p = mesh.position(v); isFinite(p)) box.add(p);
  }
  return box;
}

/// An instance with its transform, and its triangles on the screen.
class PlacedInstance {
 public:
  PlacedInstance(const Scene& scene, const Instance& instance, const FrameView& frame)
      : instance_(instance)
  {
    frame_.origin = localOrigin(boxOfTriangles(instance.mesh));
    frame_.hasLowParts = false;
    frame_.low = frame_.high = {0, 0, 0};
    Box box;
    for (std::size_t t = 0; t < instance.mesh.triangles.size(); ++t) {
      if (!drawable(t)) continue;
      for (const std::uint32_t v : instance.mesh.triangles[t].vertex) {
        const LocalPosition p = local(v);
        box.add(vec3Cast<double>(p.high));
        if (!(p.low == Vec3f{0, 0, 0})) frame_.hasLowParts = true;
      }
    }
    if (!box.empty()) {
      frame_.low = vec3Cast<float>(box.low);
      frame_.high = vec3Cast<float>(box.high);
    }
    transform_ = makeInstanceTransform(scene.camera, instance.modelToWorld, frame_, frame.width,
                                       frame.height);
  }

  const Instance& instance() const { return instance_; }
  const InstanceTransform& transform() const { return transform_; }
  Vec3d origin() const { return frame_.origin; }

  bool drawable(std::size_t t) const
  {
    for (const std::uint32_t v : instance_.mesh.triangles[t].vertex)
      if (v >= instance_.mesh.vertexCount() || !isFinite(instance_.mesh.position(v)) ||
          !isFinite(local(v).high))
        return false;
    return true;
  }

  /// The triangle's pieces on the screen after clipping, culled ones left out.
  std::vector<ScreenTriangle> screenTriangles(std::size_t t) const
  {
    ClipPoint clip[3];
    ScreenVertex corner[3];
    bool needsClip = false;
    for (int i = 0; i < 3; ++i) {
      clip[i] = clipPoint(transform_, local(instance_.mesh.triangles[t].vertex[i]));
      corner[i] = screenVertex(transform_, clip[i]);
      needsClip = needsClip || corner[i].needsClip;
    }
    std::vector<ScreenTriangle> result;
    if (!needsClip) {
      add(result,
          {{corner[0], corner[1], corner[2]}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, false, false, 0});
      return result;
    }
    const ClippedTriangle polygon = clipTriangle(transform_, clip, corner);
    for (int i = 1; i + 1 < polygon.count; ++i) {
      ScreenTriangle piece = {};
      const int fan[3] = {0, i, i + 1};
      for (int k = 0; k < 3; ++k) {
        piece.vertex[k] = polygon.vertex[fan[k]];
        std::copy(polygon.weight[fan[k]], polygon.weight[fan[k]] + 3, piece.weight[k]);
      }
      piece.clipped = true;
      add(result, piece);
    }
    return result;
  }

 private:
  LocalPosition local(std::uint32_t v) const
  {
    return toLocal(instance_.mesh.position(v), frame_.origin);
  }
  void add(std::vector<ScreenTriangle>& result, const ScreenTriangle& piece) const
  {
    const auto oriented = orient(piece);
    if (!oriented) return;
    if (oriented->clockwise ? instance_.cullBackFaces : instance_.cullFrontFaces) return;
    result.push_back(*oriented);
  }

  const Instance& instance_;
  LocalFrame frame_;
  InstanceTransform transform_;
};

/// (12.4): each linear weight times 1/w, divided by their sum.
void perspectiveWeights(const float (&share)[3], float (&weight)[3])
{
  const float inverse = 1.0f / ((share[0] + share[1]) + share[2]);
  for (int i = 0; i < 3; ++i)
    weight[i] = share[i] * inverse;
}

void cornerWeights(const ScreenTriangle& piece, Point p, float (&weight)[3])
{
  float share[3];
  for (int i = 0; i < 3; ++i) {
    // Turning the triangle counter-clockwise has swapped its second and third vertex; sums run in
    // the mesh's order.
    const int corner = !piece.clipped && piece.clockwise && i != 0 ? 3 - i : i;
    share[corner] = static_cast<float>(piece.edgeValue(i, p)) * piece.vertex[i].inverseW;
  }
  if (!piece.clipped) {
    perspectiveWeights(share, weight);
    return;
  }
  float b[3];
  perspectiveWeights(share, b);
  for (int corner = 0; corner < 3; ++corner) {
    const auto w = [&](int k) { return static_cast<float>(piece.weight[k][corner]); };
    weight[corner] = (b[0] * w(0) + b[1] * w(1)) + b[2] * w(2);
  }
}

SurfacePoint surfacePoint(const ScreenTriangle& piece, std::uint32_t triangle, bool mirrored,
                          Point p)
{
  SurfacePoint point = {triangle, {}, {}, {}, piece.clockwise != mirrored, 0, 0};
  cornerWeights(piece, p, point.weight);
  cornerWeights(piece, {p.x + kSubpixels, p.y}, point.rightWeight);
  cornerWeights(piece, {p.x, p.y + kSubpixels}, point.aboveWeight);
  return point;
}

std::uint8_t toByte(float x)
{
  const float bounded = x > 0.0f ? (x < 1.0f ? x : 1.0f) : 0.0f;
  return static_cast<std::uint8_t>(std::nearbyint(bounded * 255.0f));
}

float radiance(float x)
{
  return x > 0.0f ? (x < kMaxRadiance ? x : kMaxRadiance) : 0.0f;
}

std::uint8_t meanByte(const std::uint8_t* bytes, int count, Resolve resolve)
{
  std::uint32_t sum = 0;
  for (int i = 0; i < count; ++i)
    sum += resolve == Resolve::kGamma22 ? ResolveTable::gamma22().linear(bytes[i]) : bytes[i];
  const auto n = static_cast<std::uint32_t>(std::max(count, 1));
  return resolve == Resolve::kGamma22 ? ResolveTable::gamma22().byteOfMean(sum, n)
                                      : static_cast<std::uint8_t>((sum + n / 2) / n);
}

Rgba8 meanColor(const std::vector<Rgba8>& colors, Resolve resolve)
{
  std::uint8_t channel[4][kMaxSamples] = {};
  const int count = static_cast<int>(colors.size());
  for (int i = 0; i < count; ++i) {
    const Rgba8 c = colors[static_cast<std::size_t>(i)];
    channel[0][i] = c.r;
    channel[1][i] = c.g;
    channel[2][i] = c.b;
    channel[3][i] = c.a;
  }
  return {meanByte(channel[0], count, resolve), meanByte(channel[1], count, resolve),
          meanByte(channel[2], count, resolve), meanByte(channel[3], count, Resolve::kLinear)};
}

class Picture {
 public:
  /// With so many pixels more on all sides, which show what is opaque.
  Picture(const Scene& scene, const FrameView& frame, int apron)
      : scene_(scene),
        frame_(frame),
        apron_(apron),
        offsets_(samplePositions(scene.samples)),
        lights_(placeLights(scene.lights, scene.camera))
  {
    for (const Instance& instance : scene.instances) {
      if (instance.hull != nullptr) makeHull(scene, instance, frame, hulls_.emplace_back());
      placed_.emplace_back(scene, instance.hull != nullptr ? hulls_.back().instance : instance,
                           frame);
    }
    samples_.resize(static_cast<std::size_t>(frame.width + 2 * apron) *
                    static_cast<std::size_t>(frame.height + 2 * apron) * offsets_.size());
    for (int y = -apron; y < frame.height + apron; ++y)
      for (int x = -apron; x < frame.width + apron; ++x)
        for (std::size_t s = 0; s < offsets_.size(); ++s)
          sample(x, y, s) = {depthBefore(x, y), {}};
  }

  void findVisible()
  {
    for (std::uint32_t i = 0; i < placed_.size(); ++i)
      if (!placed_[i].instance().isTranslucent()) drawInstance(i);
  }

  /// Requires: findVisible(). Returns the number of truncated pixels.
  std::size_t findTranslucent()
  {
    bool isAny = false;
    for (const PlacedInstance& placed : placed_)
      isAny = isAny || placed.instance().isTranslucent();
    if (!isAny) return 0;
    layers_.resize(samples_.size());
    for (std::uint32_t i = 0; i < placed_.size(); ++i)
      if (placed_[i].instance().isTranslucent()) drawInstance(i);
    const std::size_t truncated = truncate();
    for (std::vector<Sample>& layers : layers_) {
      std::sort(layers.begin(), layers.end(), isNearer);
      // A clipped triangle whose pieces rounding has laid over each other counts once.
      std::vector<Sample> once;
      for (const Sample& layer : layers)
        if (std::none_of(once.begin(), once.end(),
                         [&](const Sample& other) { return other.owner == layer.owner; }))
          once.push_back(layer);
      layers.assign(once.rbegin(), once.rend());
    }
    return truncated;
  }

  /// What each pixel of the frame and around it shows first, row by row.
  std::vector<Layer> layersOfAll()
  {
    std::vector<Layer> result;
    for (int y = -apron_; y < frame_.height + apron_; ++y)
      for (int x = -apron_; x < frame_.width + apron_; ++x)
        result.push_back(layerOf(x, y));
    return result;
  }

  /// The nearest ones by now, those around the frame, too.
  WiderDepths depths()
  {
    WiderDepths result = {apron_, {}};
    for (int y = -apron_; y < frame_.height + apron_; ++y)
      for (int x = -apron_; x < frame_.width + apron_; ++x) {
        float nearest = sample(x, y, 0).depth;
        for (std::size_t s = 1; s < offsets_.size(); ++s)
          nearest = std::min(nearest, sample(x, y, s).depth);
        result.depth.push_back(isInFrame(x, y) ? frame_.depth[frameIndex(x, y)] : nearest);
      }
    return result;
  }

  /// With `isVeiled` translucent surfaces are left to layVeil().
  void shadeAll(bool isVeiled)
  {
    isVeiled_ = isVeiled;
    for (int y = 0; y < frame_.height; ++y)
      for (int x = 0; x < frame_.width; ++x)
        resolve(x, y);
  }

  /// Translucent surfaces behind these halos, which live as long, have their colours from here on.
  void setHalos(const HalosOverPanes* halos) { halos_ = halos; }

  /// A line of an instance behind the translucent surfaces of others.
  SeenLine behindPanes(int x, int y, Vec3f line, float depth, std::uint32_t instance)
  {
    if (!hasLayers(x, y)) return {full(line), line};
    const std::map<Owner, Vec4f> shaded = shadeLayers(x, y);
    // Where all samples show the same, the first one's depths are those of all.
    const std::size_t samples = haveSameLayers(x, y) ? 1 : offsets_.size();
    Vec3f colors = {0, 0, 0}, bright = {0, 0, 0};
    for (std::size_t s = 0; s < samples; ++s) {
      Vec3f color = full(line), radiance = line;
      for (const Sample& layer : layers(x, y, s)) {
        if (layer.depth > depth || layer.owner.instance == instance) continue;
        const Vec4f c = shaded.at(layer.owner);
        const Vec3f own = haloed(x, y, layer.depth, {c.x, c.y, c.z});
        color = full(own) * c.w + color * (1.0f - c.w);
        radiance = own * c.w + radiance * (1.0f - c.w);
      }
      colors = colors + color;
      bright = bright + radiance;
    }
    const auto count = static_cast<float>(samples);
    return {{colors.x / count, colors.y / count, colors.z / count},
            {bright.x / count, bright.y / count, bright.z / count}};
  }

  /// Lays the translucent surfaces over what is below them by now: what is seen changes by the
  /// share of what is below times its change, and by what halos make of the surfaces.
  void layVeil()
  {
    for (const Veiled& veiled : veiled_) {
      const SeenLine halo = changeByHalos(static_cast<int>(veiled.index % frame_.rowStride),
                                          static_cast<int>(veiled.index / frame_.rowStride));
      const auto share = [&](std::uint8_t seen, float more, std::uint8_t below, std::uint8_t now) {
        const float change = static_cast<float>(now) - static_cast<float>(below);
        const float sum = static_cast<float>(seen) + more * 255.0f + veiled.rest * change;
        return static_cast<std::uint8_t>(std::nearbyint(std::clamp(sum, 0.0f, 255.0f)));
      };
      Rgba8& pixel = frame_.color[veiled.index];
      pixel = {share(veiled.seen.r, halo.color.x, veiled.below.r, pixel.r),
               share(veiled.seen.g, halo.color.y, veiled.below.g, pixel.g),
               share(veiled.seen.b, halo.color.z, veiled.below.b, pixel.b),
               share(veiled.seen.a, 0, veiled.below.a, pixel.a)};
      const Vec3f now = radianceAt(veiled.index);
      const Vec3f seen = veiled.seenRadiance + halo.radiance, below = veiled.belowRadiance;
      setRadiance(veiled.index, {radiance(seen.x + veiled.rest * (now.x - below.x)),
                                 radiance(seen.y + veiled.rest * (now.y - below.y)),
                                 radiance(seen.z + veiled.rest * (now.z - below.z))});
    }
  }

 private:
  static Vec3f full(Vec3f c)
  {
    return {std::min(c.x, 1.0f), std::min(c.y, 1.0f), std::min(c.z, 1.0f)};
  }

  /// The colour of a translucent surface at a depth.
  Vec3f haloed(int x, int y, float depth, Vec3f color) const
  {
    if (halos_ == nullptr) return color;
    const HaloOverPane halo = halos_->at(x, y, depth);
    return halo.share > 0 ? color + (halo.color - color) * halo.share : color;
  }

  /// What halos change in what is seen of the translucent surfaces of a pixel.
  SeenLine changeByHalos(int x, int y)
  {
    SeenLine sum = {{0, 0, 0}, {0, 0, 0}};
    if (halos_ == nullptr) return sum;
    const std::map<Owner, Vec4f> shaded = shadeLayers(x, y);
    const std::size_t samples = haveSameLayers(x, y) ? 1 : offsets_.size();
    for (std::size_t s = 0; s < samples; ++s) {
      Vec3f color = {0, 0, 0}, bright = {0, 0, 0};
      for (const Sample& layer : layers(x, y, s)) {
        const Vec4f c = shaded.at(layer.owner);
        const Vec3f before = {c.x, c.y, c.z}, after = haloed(x, y, layer.depth, before);
        color = (full(after) - full(before)) * c.w + color * (1.0f - c.w);
        bright = (after - before) * c.w + bright * (1.0f - c.w);
      }
      sum.color = sum.color + color;
      sum.radiance = sum.radiance + bright;
    }
    const auto n = static_cast<float>(samples);
    return {{sum.color.x / n, sum.color.y / n, sum.color.z / n},
            {sum.radiance.x / n, sum.radiance.y / n, sum.radiance.z / n}};
  }

  std::ptrdiff_t frameIndex(int x, int y) const { return y * frame_.rowStride + x; }
  /// Around the frame that of its border.
  float depthBefore(int x, int y) const
  {
    return frame_
        .depth[frameIndex(std::clamp(x, 0, frame_.width - 1), std::clamp(y, 0, frame_.height - 1))];
  }
  bool isInFrame(int x, int y) const
  {
    return x >= 0 && y >= 0 && x < frame_.width && y < frame_.height;
  }
  Sample& sample(int x, int y, std::size_t s)
  {
    const std::size_t pixel =
        static_cast<std::size_t>(y + apron_) * static_cast<std::size_t>(frame_.width + 2 * apron_) +
        static_cast<std::size_t>(x + apron_);
    return samples_[pixel * offsets_.size() + s];
  }
  /// Translucent triangles in a sample, in the end without repetition and farthest first.
  std::vector<Sample>& layers(int x, int y, std::size_t s)
  {
    return layers_[static_cast<std::size_t>(&sample(x, y, s) - samples_.data())];
  }
  Point position(int x, int y, SampleOffset offset) const
  {
    return {static_cast<std::int64_t>(x) * kSubpixels + offset.x,
            static_cast<std::int64_t>(y) * kSubpixels + offset.y};
  }

  void drawInstance(std::uint32_t i)
  {
    for (std::uint32_t t = 0; t < placed_[i].instance().mesh.triangles.size(); ++t)
      if (placed_[i].drawable(t))
        for (const ScreenTriangle& piece : placed_[i].screenTriangles(t))
          draw(piece, {i, t});
  }

  void draw(const ScreenTriangle& triangle, Owner owner)
  {
    const bool isTranslucent = placed_[owner.instance].instance().isTranslucent();
    const auto [left, right] =
        std::minmax({triangle.vertex[0].x, triangle.vertex[1].x, triangle.vertex[2].x});
    const auto [bottom, top] =
        std::minmax({triangle.vertex[0].y, triangle.vertex[1].y, triangle.vertex[2].y});
    const int apron = isTranslucent ? 0 : apron_;
    const int x0 = std::max(-apron, left >> kSubpixelBits);
    const int x1 = std::min(frame_.width + apron - 1, right >> kSubpixelBits);
    const int y0 = std::max(-apron, bottom >> kSubpixelBits);
    const int y1 = std::min(frame_.height + apron - 1, top >> kSubpixelBits);
    for (int y = y0; y <= y1; ++y)
      for (int x = x0; x <= x1; ++x)
        for (std::size_t s = 0; s < offsets_.size(); ++s) {
          const Point p = position(x, y, offsets_[s]);
          if (!triangle.covers(p)) continue;
          const float z = triangle.depth(p);
          if (z > 1.0f) continue;
          const float depth = z > 0.0f ? z : 0.0f;
          // Less or equal: of equal depths the triangle drawn later is seen.
          if (depth > sample(x, y, s).depth) continue;
          if (isTranslucent)
            layers(x, y, s).push_back({depth, owner});
          else
            sample(x, y, s) = {depth, owner};
        }
  }

  /// Rows of 64 pixels with too many layers keep the nearest; see kMaxTranslucentSamples.
  std::size_t truncate()
  {
    std::size_t pixels = 0;
    for (int y = 0; y < frame_.height; ++y)
      for (int x0 = 0; x0 < frame_.width; x0 += kTranslucentRowPixels) {
        const int x1 = std::min(x0 + kTranslucentRowPixels, frame_.width);
        std::size_t count = 0;
        for (int x = x0; x < x1; ++x)
          for (std::size_t s = 0; s < offsets_.size(); ++s)
            count += layers(x, y, s).size();
        for (int x = x0; count > kMaxTranslucentSamples && x < x1; ++x)
          pixels += truncatePixel(x, y) ? 1 : 0;
      }
    return pixels;
  }

  bool truncatePixel(int x, int y)
  {
    const std::size_t most = translucentLayersKept(scene_.samples);
    bool isTruncated = false;
    for (std::size_t s = 0; s < offsets_.size(); ++s) {
      std::vector<Sample>& all = layers(x, y, s);
      if (all.size() <= most) continue;
      std::sort(all.begin(), all.end(), isNearer);
      all.resize(most);
      isTruncated = true;
    }
    return isTruncated;
  }

  /// Where in the pixel an owner is shaded: at the centre if it has all samples, which surround the
  /// centre, else at its first sample; so never outside the triangle.
  SampleOffset shadingOffset(const std::vector<bool>& coverage) const
  {
    const auto first = std::find(coverage.begin(), coverage.end(), true);
    const bool isWhole = std::find(first, coverage.end(), false) == coverage.end();
    return isWhole && first == coverage.begin()
               ? kPixelCentre
               : offsets_[static_cast<std::size_t>(first - coverage.begin())];
  }

  /// Where an opaque triangle is shaded.
  SurfacePoint shadedPoint(int x, int y, Owner owner)
  {
    std::vector<bool> coverage;
    for (std::size_t s = 0; s < offsets_.size(); ++s)
      coverage.push_back(sample(x, y, s).owner == owner);
    return pointOf(x, y, shadingOffset(coverage), owner);
  }

  Vec3f normalOf(int x, int y, Owner owner)
  {
    const PlacedInstance& placed = placed_[owner.instance];
    return normalAt(scene_, placed.instance(), placed.transform(), placed.origin(),
                    shadedPoint(x, y, owner));
  }

  Vec3f radianceAt(std::ptrdiff_t index) const
  {
    const RadianceView& planes = frame_.radiance;
    if (planes.empty()) return {0, 0, 0};
    return {planes.r[index], planes.g[index], planes.b[index]};
  }
  void setRadiance(std::ptrdiff_t index, Vec3f value) const
  {
    const RadianceView& planes = frame_.radiance;
    if (planes.empty()) return;
    planes.r[index] = value.x;
    planes.g[index] = value.y;
    planes.b[index] = value.z;
  }

  /// Draws the opaque surfaces of a pixel with translucent ones.
  void resolveVeiled(int x, int y, bool hasOpaque)
  {
    const std::ptrdiff_t index = frameIndex(x, y);
    Veiled veiled = {};
    veiled.index = index;
    const Rgba8 old = frame_.color[index];
    const Vec3f oldRadiance = radianceAt(index);
    resolveLayers(x, y);
    veiled.seen = frame_.color[index];
    veiled.seenRadiance = radianceAt(index);
    const std::uint8_t coverage = frame_.coverage != nullptr ? frame_.coverage[index] : 0;
    frame_.color[index] = old;
    setRadiance(index, oldRadiance);
    if (hasOpaque) resolveOpaque(x, y);
    if (frame_.coverage != nullptr) frame_.coverage[index] = coverage;
    veiled.below = frame_.color[index];
    veiled.belowRadiance = radianceAt(index);
    const std::map<Owner, Vec4f> shaded = shadeLayers(x, y);
    for (std::size_t s = 0; s < offsets_.size(); ++s) {
      float rest = 1;
      for (const Sample& layer : layers(x, y, s))
        rest = rest * (1.0f - shaded.at(layer.owner).w);
      veiled.rest += rest;
    }
    veiled.rest /= static_cast<float>(offsets_.size());
    veiled_.push_back(veiled);
  }

  Vec3f shadeOwner(int x, int y, Owner owner)
  {
    const SurfacePoint point = shadedPoint(x, y, owner);
    const PlacedInstance& placed = placed_[owner.instance];
    return shade(scene_, placed.instance(), placed.transform(), placed.origin(), lights_, point);
  }

  SurfacePoint pointOf(int x, int y, SampleOffset offset, Owner owner) const
  {
    const Point p = position(x, y, offset);
    const PlacedInstance& placed = placed_[owner.instance];
    const auto pieces = placed.screenTriangles(owner.triangle);
    // The pieces of a clipped triangle are watertight but for rounding at their outer border.
    auto piece = std::find_if(pieces.begin(), pieces.end(),
                              [&](const ScreenTriangle& t) { return t.covers(p); });
    if (piece == pieces.end()) piece = pieces.begin();
    SurfacePoint point = surfacePoint(*piece, owner.triangle, placed.transform().mirrored, p);
    point.pixelX = x;
    point.pixelY = y;
    return point;
  }

  /// Colours and alphas of the translucent triangles in a pixel.
  std::map<Owner, Vec4f> shadeLayers(int x, int y)
  {
    std::map<Owner, std::vector<bool>> coverage;
    for (std::size_t s = 0; s < offsets_.size(); ++s)
      for (const Sample& layer : layers(x, y, s)) {
        coverage[layer.owner].resize(offsets_.size());
        coverage[layer.owner][s] = true;
      }
    std::map<Owner, Vec4f> colors;
    for (const auto& [owner, samples] : coverage) {
      const PlacedInstance& placed = placed_[owner.instance];
      const SurfacePoint point = pointOf(x, y, shadingOffset(samples), owner);
      const Vec3f c =
          shade(scene_, placed.instance(), placed.transform(), placed.origin(), lights_, point);
      const float a =
          alphaAt(scene_, placed.instance(), placed.transform(), placed.origin(), point);
      colors[owner] = {radiance(c.x), radiance(c.y), radiance(c.z), a};
    }
    return colors;
  }

  /// The same triangles in the same order in all samples.
  bool haveSameLayers(int x, int y)
  {
    const std::vector<Sample>& first = layers(x, y, 0);
    for (std::size_t s = 1; s < offsets_.size(); ++s) {
      const std::vector<Sample>& other = layers(x, y, s);
      if (!std::equal(first.begin(), first.end(), other.begin(), other.end(),
                      [](const Sample& a, const Sample& b) { return a.owner == b.owner; }))
        return false;
    }
    return true;
  }

  bool hasLayers(int x, int y)
  {
    for (std::size_t s = 0; !layers_.empty() && s < offsets_.size(); ++s)
      if (!layers(x, y, s).empty()) return true;
    return false;
  }

  /// The colours of a pixel with translucent triangles.
  void resolveLayers(int x, int y)
  {
    const std::ptrdiff_t index = frameIndex(x, y);
    const RadianceView& planes = frame_.radiance;
    const bool hasRadiance = !planes.empty();
    const std::map<Owner, Vec4f> shaded = shadeLayers(x, y);
    std::vector<Rgba8> colors;
    Vec3f sum = {0, 0, 0};
    std::uint32_t coverage = 0;
    for (std::size_t s = 0; s < offsets_.size(); ++s) {
      const Owner owner = sample(x, y, s).owner;
      const std::vector<Sample>& above = layers(x, y, s);
      Rgba8 color = {0, 0, 0, 0};
      Vec3f bright = {0, 0, 0};
      if (owner.exists()) {
        const Vec3f c = shadeOwner(x, y, owner);
        color = {toByte(c.x), toByte(c.y), toByte(c.z), 255};
        bright = {radiance(c.x), radiance(c.y), radiance(c.z)};
      } else if (frame_.background == Background::kBlend) {
        color = frame_.color[index];
        if (hasRadiance) bright = {planes.r[index], planes.g[index], planes.b[index]};
      } else if (above.empty()) {
        continue;
      }
      Vec4f below = {static_cast<float>(color.r) / 255.0f, static_cast<float>(color.g) / 255.0f,
                     static_cast<float>(color.b) / 255.0f, static_cast<float>(color.a) / 255.0f};
      for (const Sample& layer : above) {
        const Vec4f c = shaded.at(layer.owner);
        const float a = c.w;
        const Vec4f full = {std::min(c.x, 1.0f), std::min(c.y, 1.0f), std::min(c.z, 1.0f), 1.0f};
        below = full * a + below * (1.0f - a);
        bright = Vec3f{c.x, c.y, c.z} * a + bright * (1.0f - a);
      }
      colors.push_back({toByte(below.x), toByte(below.y), toByte(below.z), toByte(below.w)});
      sum = sum + bright;
      if (owner.exists() || !above.empty()) coverage |= 1u << s;
    }
    frame_.color[index] = meanColor(colors, scene_.resolve);
    if (frame_.coverage != nullptr) frame_.coverage[index] = static_cast<std::uint8_t>(coverage);
    if (!hasRadiance) return;
    const auto count = static_cast<float>(colors.size());
    planes.r[index] = sum.x / count;
    planes.g[index] = sum.y / count;
    planes.b[index] = sum.z / count;
  }

  const Sample* nearestSample(int x, int y)
  {
    const Sample* nearest = nullptr;
    for (std::size_t s = 0; s < offsets_.size(); ++s) {
      const Sample& here = sample(x, y, s);
      if (here.owner.exists() && (nearest == nullptr || isNearer(here, *nearest))) nearest = &here;
    }
    return nearest;
  }

  /// Where a sample is, on which triangle and how that is shaded.
  Layer layerAt(int x, int y, std::size_t s, const ScreenToView& toView)
  {
    const Sample& here = sample(x, y, s);
    const Point p = position(x, y, offsets_[s]);
    Layer layer;
    layer.instance = here.owner.instance;
    layer.depth = here.depth;
    layer.place = {static_cast<float>(p.x) / kSubpixels, static_cast<float>(p.y) / kSubpixels};
    layer.point = toView.at(layer.place.x, layer.place.y, here.depth);
    layer.normal = normalOf(x, y, here.owner);
    const PlacedInstance& placed = placed_[here.owner.instance];
    layer.plane = planeNormalAt(scene_, placed.instance(), placed.transform(), placed.origin(),
                                shadedPoint(x, y, here.owner));
    return layer;
  }

  /// What the triangle is a part of.
  std::uint32_t idOf(const Owner& owner) const
  {
    const Instance& instance = placed_[owner.instance].instance();
    const Attributes& a = instance.attributes;
    if (!instance.style.imageOutline.ids || a.cellIds.empty() || instance.hull != nullptr) return 0;
    return a.cellIds[a.cells.empty() ? owner.triangle : a.cells[owner.triangle]];
  }

  Layer layerOf(int x, int y)
  {
    const Sample* const nearest = nearestSample(x, y);
    if (nearest == nullptr) {
      Layer nobody;
      nobody.depth = sample(x, y, 0).depth;
      return nobody;
    }
    const ScreenToView toView(scene_.camera, frame_.width, frame_.height);
    const auto first = static_cast<std::size_t>(nearest - &sample(x, y, 0));
    Layer layer = layerAt(x, y, first, toView);
    std::vector<Rgba8> colors;
    std::vector<SeenTriangle> triangles;
    std::map<Owner, bool> isSame;
    std::vector<std::uint32_t> ids;
    int covered = 0;
    for (std::size_t s = 0; s < offsets_.size(); ++s) {
      const Owner owner = sample(x, y, s).owner;
      if (!owner.exists()) continue;
      ++covered;
      // By the triangle's first sample in the pixel.
      if (isSame.count(owner) == 0)
        isSame[owner] = owner == nearest->owner || (owner.instance == layer.instance &&
                                                    areOneSurface(layer, layerAt(x, y, s, toView),
                                                                  toleranceAt(scene_, layer)));
      if (!isSame[owner]) {
        if (layer.other == kNobody) layer.other = owner.instance;
        continue;
      }
      ids.push_back(idOf(owner));
      const Vec3f color = isInFrame(x, y) ? shadeOwner(x, y, owner) : Vec3f{0, 0, 0};
      colors.push_back({toByte(color.x), toByte(color.y), toByte(color.z), 255});
      note(triangles, owner, color);
    }
    layer.count = static_cast<int>(colors.size());
    for (const std::uint32_t id : ids) {
      const auto samples = static_cast<int>(std::count(ids.begin(), ids.end(), id));
      if (samples <= layer.idSamples) continue;
      layer.id = id;
      layer.idSamples = samples;
    }
    layer.covered = covered;
    layer.shared = frame_.background == Background::kKeepApart ? covered : scene_.samples;
    layer.color = meanColor(colors, scene_.resolve);
    Vec3f sum = {0, 0, 0};
    for (const SeenTriangle& triangle : triangles)
      sum = sum + triangle.radiance * static_cast<float>(triangle.samples);
    const auto n = static_cast<float>(layer.count);
    layer.radiance = {sum.x / n, sum.y / n, sum.z / n};
    return layer;
  }

  void resolve(int x, int y)
  {
    const Sample* const nearest = nearestSample(x, y);
    if (hasLayers(x, y) && isVeiled_)
      resolveVeiled(x, y, nearest != nullptr);
    else if (hasLayers(x, y))
      resolveLayers(x, y);
    else if (nearest != nullptr)
      resolveOpaque(x, y);
    if (nearest == nullptr) return;
    writeNearest(*nearest, frameIndex(x, y));
    if (frame_.normal.empty()) return;
    const Vec3f n = normalOf(x, y, nearest->owner);
    frame_.normal.x[frameIndex(x, y)] = n.x;
    frame_.normal.y[frameIndex(x, y)] = n.y;
    frame_.normal.z[frameIndex(x, y)] = n.z;
  }

  void writeNearest(const Sample& nearest, std::ptrdiff_t index)
  {
    frame_.depth[index] = nearest.depth;
    const Instance& instance = placed_[nearest.owner.instance].instance();
    if (frame_.instance != nullptr) frame_.instance[index] = instance.id;
    if (frame_.cell != nullptr)
      frame_.cell[index] = instance.attributes.cells.empty()
                               ? nearest.owner.triangle
                               : instance.attributes.cells[nearest.owner.triangle];
  }

  void resolveOpaque(int x, int y)
  {
    const std::ptrdiff_t index = frameIndex(x, y);
    std::vector<Rgba8> colors;
    std::vector<SeenTriangle> triangles;
    std::uint32_t coverage = 0;
    for (std::size_t s = 0; s < offsets_.size(); ++s) {
      const Sample& here = sample(x, y, s);
      if (!here.owner.exists()) {
        if (frame_.background == Background::kBlend) colors.push_back(frame_.color[index]);
        continue;
      }
      const Vec3f color = shadeOwner(x, y, here.owner);
      colors.push_back({toByte(color.x), toByte(color.y), toByte(color.z), 255});
      note(triangles, here.owner, color);
      coverage |= 1u << s;
    }
    frame_.color[index] = meanColor(colors, scene_.resolve);
    if (!frame_.radiance.empty()) writeRadiance(triangles, index);
    if (frame_.coverage != nullptr) frame_.coverage[index] = static_cast<std::uint8_t>(coverage);
  }

  static void note(std::vector<SeenTriangle>& triangles, Owner owner, Vec3f color)
  {
    const auto seen =
        std::find_if(triangles.begin(), triangles.end(),
                     [&](const SeenTriangle& triangle) { return triangle.owner == owner; });
    if (seen != triangles.end())
      ++seen->samples;
    else
      triangles.push_back({owner, {radiance(color.x), radiance(color.y), radiance(color.z)}, 1});
  }

  void writeRadiance(const std::vector<SeenTriangle>& triangles, std::ptrdiff_t index)
  {
    Vec3f sum = {0, 0, 0};
    std::size_t covered = 0;
    for (const SeenTriangle& triangle : triangles) {
      sum = sum + triangle.radiance * static_cast<float>(triangle.samples);
      covered += triangle.samples;
    }
    const RadianceView& out = frame_.radiance;
    if (covered < offsets_.size() && frame_.background == Background::kBlend) {
      sum = sum + Vec3f{out.r[index], out.g[index], out.b[index]} *
                      static_cast<float>(offsets_.size() - covered);
      covered = offsets_.size();
    }
    const auto count = static_cast<float>(covered);
    out.r[index] = sum.x / count;
    out.g[index] = sum.y / count;
    out.b[index] = sum.z / count;
  }

  const Scene& scene_;
  const FrameView& frame_;
  int apron_;
  Span<const SampleOffset> offsets_;
  std::vector<ViewLight> lights_;
  std::deque<Hull> hulls_;  ///< which do not move
  std::vector<PlacedInstance> placed_;
  std::vector<Sample> samples_;
  std::vector<std::vector<Sample>> layers_;  ///< empty if nothing is translucent
  bool isVeiled_ = false;
  std::vector<Veiled> veiled_;
  const HalosOverPanes* halos_ = nullptr;
};

/// Whether outlines or cues change what translucent surfaces lie before.
bool isVeiled(const Scene& scene, const FrameView& frame)
{
  bool isBelow = false, isAbove = false;
  for (const Instance& instance : scene.instances)
    if (instance.isTranslucent())
      isAbove = true;
    else if (hasCues(instance) || instance.style.imageOutline.detector != OutlineDetector::kNone)
      isBelow = true;
  return isBelow && isAbove && frame.background == Background::kBlend;
}

/// Whether a translucent instance may lie before a line of another one.
bool hasPanes(const Scene& scene, const FrameView& frame)
{
  for (const Instance& lined : scene.instances)
    for (const Instance& pane : scene.instances)
      if (!lined.lines.empty() && pane.isTranslucent() && &pane != &lined)
        return frame.background == Background::kBlend;
  return false;
}

}  // namespace

std::size_t render(const Scene& scene, const FrameView& frame)
{
  const int apron = std::max({outlineApron(scene), haloApron(scene), strokeApron(scene)});
  Picture picture(scene, frame, apron);
  picture.findVisible();
  const std::size_t truncated = picture.findTranslucent();
  const bool hasVeil = isVeiled(scene, frame);
  picture.shadeAll(hasVeil);
  const auto& all = scene.instances;
  const bool areCued = std::any_of(all.begin(), all.end(), hasCues);
  const bool areOutlined = std::any_of(all.begin(), all.end(), [](const Instance& instance) {
    return instance.style.imageOutline.detector != OutlineDetector::kNone;
  });
  std::vector<Layer> layers;
  if (areCued || areOutlined) layers = picture.layersOfAll();
  if (areCued) drawCues(scene, frame, layers, apron);
  if (areOutlined) drawOutlines(scene, frame, layers, apron);
  const HalosOverPanes halos(scene, frame, layers, apron);
  if (hasVeil && areCued) picture.setHalos(&halos);
  if (hasVeil) picture.layVeil();
  PanesOver panes;
  if (hasPanes(scene, frame))
    panes = [&](int x, int y, Vec3f color, float depth, std::uint32_t instance) {
      return picture.behindPanes(x, y, color, depth, instance);
    };
  drawStrokes(scene, frame, picture.depths(), layers, panes);
  return truncated;
}

}  // namespace limn::reference
