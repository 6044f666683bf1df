// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Compiled once per instruction set by TextureLanes.cpp.
#include "Rendering/Texture/Procedural-inl.h"
#include "Rendering/Texture/SampleTexture-inl.h"

HWY_BEFORE_NAMESPACE();
namespace limn::HWY_NAMESPACE {

using testing::TexturePoint;

/// Numbers of the points of one vector, in turn.
struct Columns {
  static constexpr std::size_t kRoom = HWY_MAX_BYTES / sizeof(float);

  /// The last of `points` again where they end.
  template <class Points, class Read>
  V column(const Points& points, std::size_t first, Read read) const
  {
    alignas(HWY_MAX_BYTES) float values[kRoom];
    for (std::size_t i = 0; i < kRoom; ++i)
      values[i] = read(points[std::min(first + i, points.size() - 1)]);
    return hn::Load(D(), values);
  }
  template <class Results, class Place>
  void put(V lanes, std::size_t first, Results& results, Place place) const
  {
    alignas(HWY_MAX_BYTES) float values[kRoom];
    hn::Store(lanes, D(), values);
    for (std::size_t i = 0; i < hn::Lanes(D()) && first + i < results.size(); ++i)
      place(results[first + i]) = values[i];
  }
};

template <class Points>
Lanes2 pairs(const Points& points, std::size_t first, Vec2f TexturePoint::*member)
{
  const Columns columns;
  return {columns.column(points, first, [&](const TexturePoint& p) { return (p.*member).x; }),
          columns.column(points, first, [&](const TexturePoint& p) { return (p.*member).y; })};
}

void putColor(Lanes4 color, std::size_t first, std::vector<Vec4f>& results)
{
  const Columns columns;
  columns.put(color.x, first, results, [](Vec4f& v) -> float& { return v.x; });
  columns.put(color.y, first, results, [](Vec4f& v) -> float& { return v.y; });
  columns.put(color.z, first, results, [](Vec4f& v) -> float& { return v.z; });
  columns.put(color.w, first, results, [](Vec4f& v) -> float& { return v.w; });
}

void sampleKernel(const TextureImage& image, const TextureSampler& sampler,
                  const std::vector<TexturePoint>& points, std::vector<Vec4f>& results)
{
  for (std::size_t i = 0; i < points.size(); i += hn::Lanes(D()))
    putColor(
        sampleTexture(image, sampler, pairs(points, i, &TexturePoint::uv),
                      pairs(points, i, &TexturePoint::ddx), pairs(points, i, &TexturePoint::ddy)),
        i, results);
}

void gradientKernel(const TextureImage& image, const TextureSampler& sampler,
                    const std::vector<TexturePoint>& points, std::vector<Vec2f>& results)
{
  const Columns columns;
  for (std::size_t i = 0; i < points.size(); i += hn::Lanes(D())) {
    const Lanes2 gradient =
        heightGradient(image, sampler, pairs(points, i, &TexturePoint::uv),
                       pairs(points, i, &TexturePoint::ddx), pairs(points, i, &TexturePoint::ddy));
    columns.put(gradient.x, i, results, [](Vec2f& v) -> float& { return v.x; });
    columns.put(gradient.y, i, results, [](Vec2f& v) -> float& { return v.y; });
  }
}

void proceduralKernel(const ProceduralTexture& texture, const std::vector<Vec3f>& points,
                      std::vector<Vec4f>& results)
{
  const Columns columns;
  for (std::size_t i = 0; i < points.size(); i += hn::Lanes(D())) {
    const Lanes3 at = {columns.column(points, i, [](Vec3f p) { return p.x; }),
                       columns.column(points, i, [](Vec3f p) { return p.y; }),
                       columns.column(points, i, [](Vec3f p) { return p.z; })};
    putColor(proceduralColor(texture, at), i, results);
  }
}

}  // namespace limn::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
