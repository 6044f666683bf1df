// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Post/DrawCues.h"

#include "Rendering/Lines/PaintLayer.h"
#include "Rendering/Post/DepthMean.h"
#include "Rendering/Post/EffectPass.h"
#include "Rendering/Post/EyeDome.h"
#include "Rendering/Post/FindHalos.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace limn {
namespace {

/// The cues' strengths by instance, and their radii, of which a scene has few.
struct CueSettings {
  static constexpr std::size_t kNone = ~std::size_t{0};
  struct OfInstance {
    float eyeDome = 0, darken = 0, lighten = 0;
    std::size_t eyeDomeRadius = kNone, unsharpRadius = kNone;  ///< places in the lists below
  };

  explicit CueSettings(const Scene& scene)
  {
    for (const Instance& instance : scene.instances) {
      OfInstance one;
      const DepthCues cues = hasCues(instance) ? instance.style.cues : DepthCues{};
      if (cues.eyeDome.strength > 0.0f) {
        one.eyeDome = cues.eyeDome.strength;
        one.eyeDomeRadius = placeOf(cues.eyeDome.radius, eyeDomeRadii);
      }
      if (cues.unsharp.strength > 0.0f) {
        one.darken = cues.unsharp.strength;
        one.lighten = cues.unsharp.lightens ? cues.unsharp.strength : 0.0f;
        one.unsharpRadius = placeOf(cues.unsharp.radius, unsharpRadii);
      }
      of.push_back(one);
    }
  }

  static std::size_t placeOf(float radius, std::vector<float>& radii)
  {
    const auto found = std::find(radii.begin(), radii.end(), radius);
    const auto place = static_cast<std::size_t>(found - radii.begin());
    if (found == radii.end()) radii.push_back(radius);
    return place;
  }

  std::vector<OfInstance> of;
  std::vector<float> eyeDomeRadii, unsharpRadii;
};

/// What kernels read of one row.
struct RowInput {
  std::vector<float> pixel, strength, lighten;
};

/// The change of a layer's colour.
struct Cue {
  float factor, light, halo;
  Vec3f haloColor;

  bool isNone() const { return factor == 1.0f && light == 0.0f && halo == 0.0f; }

  /// `white` is the value of full intensity.
  float of(float c, float white, float haloed) const
  {
    c = c * factor;
    if (light < 0.0f) c = c * (1.0f + light);
    if (light > 0.0f && c < white) c = c + (white - c) * light;
    return c + (haloed * white - c) * halo;
  }
};

/// Kept from frame to frame for its memory.
struct CueMemory {
  DistancePlane distances;
  Array<float> factor, light;  ///< by rows of paddedWidth()
  Array<float> ofHalos;        ///< HaloFinder's
};

class CueDrawer {
 public:
  CueDrawer(const CuePass& pass, CueMemory& memory)
      : pass_(pass),
        settings_(pass.scene),
        memory_(memory),
        distances_(memory.distances),
        rowSize_(paddedWidth(pass.frame.width)),
        halos_(pass, memory.distances, memory.ofHalos)
  {
    const auto width = static_cast<float>(pass.frame.width),
               height = static_cast<float>(pass.frame.height);
    const float diagonal = std::sqrt(width * width + height * height);
    int reach = 1;
    for (const float share : settings_.eyeDomeRadii) {
      const float radius = std::max(1.0f, share * diagonal);
      taps_.emplace_back(radius);
      reach = std::max(reach, eyeDomeReach(radius));
    }
    distances_.resize(pass.frame.width, pass.frame.height, reach);
    forEachRow(pass.threads, pass.frame.height, [&](int y) { fillDistances(y); });
    for (const float share : settings_.unsharpRadii)
      means_.emplace_back(distances_, share * diagonal, pass.threads);
    if (halos_.any()) halos_.find();
  }

  void draw() const
  {
    const auto forTouchedRows = [&](const auto& body) {
      forEachRow(pass_.threads, pass_.touched.y1 - pass_.touched.y0,
                 [&](int row) { body(pass_.touched.y0 + row); });
    };
    memory_.factor.resize(rowSize_ * static_cast<std::size_t>(pass_.frame.height));
    memory_.light.resize(memory_.factor.size());
    forTouchedRows([&](int y) { shadeRow(y); });
    forTouchedRows([&](int y) { paintRow(y); });
  }

 private:
  void fillDistances(int y)
  {
    DistancePlane& plane = distances_;
    const SurfaceLayers& layers = pass_.layers;
    float* const row = plane.row(y);
    std::fill_n(row - plane.pad, plane.stride, DistancePlane::kFar);
    const std::size_t first = layers.indexOf(0, y);
    for (int x = 0; x < plane.width; ++x) {
      const std::size_t index = first + static_cast<std::size_t>(x);
      if (layers.instance[index] != kNobody) row[x] = -layers.pointAt(x, y).position.z;
    }
  }

  float* factorsOf(int y) const
  {
    return memory_.factor.data() + rowSize_ * static_cast<std::size_t>(y);
  }
  float* lightsOf(int y) const
  {
    return memory_.light.data() + rowSize_ * static_cast<std::size_t>(y);
  }

  void paintRow(int y) const
  {
    static const std::vector<HaloFinder::Column> none;
    const std::vector<HaloFinder::Column>& borders = halos_.any() ? halos_.bordersOf(y) : none;
    auto border = std::find_if(borders.begin(), borders.end(),
                               [&](const auto& one) { return one.x >= pass_.touched.x0; });
    const SurfaceLayers& layers = pass_.layers;
    for (int x = pass_.touched.x0; x < pass_.touched.x1; ++x) {
      const std::size_t index = layers.indexOf(x, y);
      if (layers.instance[index] == kNobody) continue;
      const bool isBorder = border != borders.end() && border->x == x;
      if (layers.covered[index] > layers.count[index])
        paintRest(x, y, isBorder ? halos_.shareBehind(*border, y) : 0.0f);
      if (isBorder) ++border;
      Cue cue = {factorsOf(y)[x], lightsOf(y)[x], 0, {0, 0, 0}};
      if (halos_.any()) cue.halo = layers.halo[index];
      if (cue.isNone()) continue;
      if (cue.halo > 0.0f) cue.haloColor = halos_.colorAt(index);
      paint(x, y, cue);
    }
  }

  /// Eye-dome lighting and unsharp masks, radius after radius.
  void shadeRow(int y) const
  {
    float* const factor = factorsOf(y);
    float* const light = lightsOf(y);
    std::fill_n(factor, rowSize_, 1.0f);
    std::fill_n(light, rowSize_, 0.0f);
    if (taps_.empty() && means_.empty()) return;
    thread_local RowInput row;
    row.pixel.assign(rowSize_, 1.0f);
    const SurfaceLayers& layers = pass_.layers;
    const std::size_t first = layers.indexOf(0, y);
    const auto width = static_cast<std::size_t>(layers.width);
    const auto settingsAt = [&](std::size_t x) -> const CueSettings::OfInstance* {
      const std::uint32_t instance = layers.instance[first + x];
      return instance == kNobody ? nullptr : &settings_.of[instance];
    };
    for (int x = 0; x < layers.width; ++x)
      if (layers.instance[layers.indexOf(x, y)] != kNobody)
        row.pixel[static_cast<std::size_t>(x)] = layers.pointAt(x, y).pixel;
    for (std::size_t radius = 0; radius < taps_.size(); ++radius) {
      row.strength.assign(row.pixel.size(), 0.0f);
      for (std::size_t x = 0; x < width; ++x)
        if (const auto* one = settingsAt(x); one != nullptr && one->eyeDomeRadius == radius)
          row.strength[x] = one->eyeDome;
      shadeEyeDome(taps_[radius], {distances_, y, row.pixel.data(), row.strength.data(), factor});
    }
    for (std::size_t radius = 0; radius < means_.size(); ++radius) {
      row.strength.assign(row.pixel.size(), 0.0f);
      row.lighten.assign(row.pixel.size(), 0.0f);
      for (std::size_t x = 0; x < width; ++x)
        if (const auto* one = settingsAt(x); one != nullptr && one->unsharpRadius == radius) {
          row.strength[x] = one->darken;
          row.lighten[x] = one->lighten;
        }
      means_[radius].shade(
          y, {distances_.row(y), row.pixel.data(), row.strength.data(), row.lighten.data(), light});
    }
  }

  void paint(int x, int y, const Cue& cue) const
  {
    const std::size_t index = pass_.layers.indexOf(x, y);
    const std::uint8_t count = pass_.layers.count[index], shared = pass_.layers.shared[index];
    Rgba8& color = pass_.layers.color[index];
    const std::ptrdiff_t place = y * pass_.frame.rowStride + x;
    const Resolve resolve = pass_.scene.resolve;
    const bool isWhole = count == shared;
    const auto paintByte = [&](std::uint8_t& pixel, std::uint8_t& own, float haloed) {
      const std::uint8_t to = toByte(cue.of(static_cast<float>(own), 255.0f, haloed));
      // The mean of all samples, if nothing translucent is over them.
      pixel = isWhole && pixel == own
                  ? to
                  : changed({pixel, own, to}, static_cast<double>(count), shared, resolve);
      own = to;
    };
    Rgba8& pixel = pass_.frame.color[place];
    paintByte(pixel.r, color.r, cue.haloColor.x);
    paintByte(pixel.g, color.g, cue.haloColor.y);
    paintByte(pixel.b, color.b, cue.haloColor.z);
    const RadianceView& radiance = pass_.frame.radiance;
    if (radiance.empty()) return;
    const float part = static_cast<float>(count) / static_cast<float>(shared);
    const auto paintRadiance = [&](float& value, float& own, float haloed) {
      const float to = cue.of(own, 1.0f, haloed);
      value = boundedRadiance(value + (to - own) * part);
      own = to;
    };
    Vec3f& own = pass_.layers.radiance[index];
    paintRadiance(radiance.r[place], own.x, cue.haloColor.x);
    paintRadiance(radiance.g[place], own.y, cue.haloColor.y);
    paintRadiance(radiance.b[place], own.z, cue.haloColor.z);
  }

  /// Of the farthest pixel around that is behind this one and shows what its other samples do.
  Cue cueBehind(int x, int y) const
  {
    const SurfaceLayers& layers = pass_.layers;
    const std::uint32_t wanted = layers.other[layers.indexOf(x, y)];
    Cue cue = {1, 0, 0, {0, 0, 0}};
    float farthest = distances_.row(y)[x];
    const int x1 = std::min(x + 1, distances_.width - 1);
    const int y1 = std::min(y + 1, distances_.height - 1);
    for (int row = std::max(y - 1, 0); row <= y1; ++row)
      for (int column = std::max(x - 1, 0); column <= x1; ++column) {
        const float other = distances_.row(row)[column];
        if (layers.instance[layers.indexOf(column, row)] != wanted || !(other > farthest)) continue;
        farthest = other;
        cue.factor = factorsOf(row)[column];
        cue.light = lightsOf(row)[column];
      }
    return cue;
  }

  /// The other surfaces that share the layer's pixel, and lie behind it.
  void paintRest(int x, int y, float haloShare) const
  {
    const std::size_t index = pass_.layers.indexOf(x, y);
    const SurfaceLayer layer = pass_.layers.at(x, y);
    const int others = layer.covered - layer.count;
    Cue cue = cueBehind(x, y);
    cue.halo = haloShare;
    if (cue.isNone()) return;
    cue.haloColor = pass_.scene.instances[pass_.layers.instance[index]].style.cues.halo.color;
    const RestOfPixel rest = {layer.count, layer.shared, pass_.scene.resolve};
    const std::ptrdiff_t place = y * pass_.frame.rowStride + x;
    const auto paintByte = [&](std::uint8_t& pixel, std::uint8_t own, float haloed) {
      const std::uint8_t from = rest.of(pixel, own);
      const std::uint8_t to = toByte(cue.of(static_cast<float>(from), 255.0f, haloed));
      pixel = changed({pixel, from, to}, static_cast<double>(others), layer.shared,
                      pass_.scene.resolve);
    };
    Rgba8& pixel = pass_.frame.color[place];
    paintByte(pixel.r, layer.color.r, cue.haloColor.x);
    paintByte(pixel.g, layer.color.g, cue.haloColor.y);
    paintByte(pixel.b, layer.color.b, cue.haloColor.z);
    const RadianceView& radiance = pass_.frame.radiance;
    if (radiance.empty()) return;
    const float part = static_cast<float>(others) / static_cast<float>(layer.shared);
    const auto paintRadiance = [&](float& value, float own, float haloed) {
      const float old = rest.ofRadiance(value, own);
      value = boundedRadiance(value + (cue.of(old, 1.0f, haloed) - old) * part);
    };
    const Vec3f own = pass_.layers.radiance[index];
    paintRadiance(radiance.r[place], own.x, cue.haloColor.x);
    paintRadiance(radiance.g[place], own.y, cue.haloColor.y);
    paintRadiance(radiance.b[place], own.z, cue.haloColor.z);
  }

  const CuePass& pass_;
  CueSettings settings_;
  CueMemory& memory_;
  DistancePlane& distances_;
  std::size_t rowSize_;
  HaloFinder halos_;
  std::vector<EyeDomeTaps> taps_;  ///< by CueSettings::eyeDomeRadii
  std::vector<DepthMean> means_;   ///< by CueSettings::unsharpRadii
};

}  // namespace

void drawCues(const CuePass& pass)
{
  thread_local CueMemory memory;
  CueDrawer(pass, memory).draw();
}

}  // namespace limn
