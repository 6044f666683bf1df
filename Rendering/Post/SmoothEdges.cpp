// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Post/EffectPass.h"

#include "Rendering/Post/LumaRows.h"
#include "Rendering/Base/Vec.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Rendering/Post/SmoothEdges.cpp"
#include <hwy/foreach_target.h>

#include "Rendering/Post/SmoothEdges-inl.h"

#if HWY_ONCE
namespace limn {
namespace {

HWY_EXPORT(lumaRowKernel);
HWY_EXPORT(findEdgesKernel);

/// A step from a pixel to a neighbour.
struct Step {
  int x, y;

  Step operator*(int times) const { return {x * times, y * times}; }
};

/// Where an edge ends, seen from a pixel on it.
struct EdgeEnds {
  int before = 1, after = 1;  ///< pixels to the ends
  float lumaBefore = 0, lumaAfter = 0;
};

/// One pixel that findEdgesKernel() found, and the picture around it.
class EdgePixel {
 public:
  EdgePixel(const EffectPass& pass, int x, int y)
      : fxaa_(pass.effects.fxaa), planes_(pass.planes), x_(x), y_(y)
  {
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx)
        luma_[dy + 1][dx + 1] = luma({dx, dy});
  }

  Rgba8 smooth() const
  {
    const Vec3f onEdge = alongEdge();
    const float blend = subpixelBlend();
    const Vec3f mixed = onEdge * (1.0f - blend) + neighbourhood() * blend;
    const auto byte = [](float v) { return static_cast<std::uint8_t>(std::nearbyint(v)); };
    return {byte(mixed.x), byte(mixed.y), byte(mixed.z), colorOf({0, 0}).a};
  }

 private:
  float near(int dx, int dy) const { return luma_[dy + 1][dx + 1]; }
  int column(Step step) const { return std::clamp(x_ + step.x, 0, planes_.luma.width() - 1); }
  int row(Step step) const { return std::clamp(y_ + step.y, 0, planes_.luma.height() - 1); }
  float luma(Step step) const { return planes_.luma.row(row(step))[column(step)]; }
  float luma(Step along, Step across) const
  {
    return luma({along.x + across.x, along.y + across.y});
  }
  Rgba8 colorOf(Step step) const
  {
    return planes_.jagged[static_cast<std::size_t>(row(step)) *
                              static_cast<std::size_t>(planes_.luma.width()) +
                          static_cast<std::size_t>(column(step))];
  }
  Vec3f color(Step step) const
  {
    const Rgba8 c = colorOf(step);
    return {static_cast<float>(c.r), static_cast<float>(c.g), static_cast<float>(c.b)};
  }

  /// The mean of the pixel and its eight neighbours.
  Vec3f neighbourhood() const
  {
    Vec3f sum = {0, 0, 0};
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx)
        sum = sum + color({dx, dy});
    return sum * (1.0f / 9);
  }

  /// How much of that mean to blend in: by how far the pixel differs from its four neighbours.
  float subpixelBlend() const
  {
    const auto [least, most] =
        std::minmax({near(0, 0), near(0, -1), near(0, 1), near(-1, 0), near(1, 0)});
    const float mean = 0.25f * ((near(0, -1) + near(0, 1)) + (near(-1, 0) + near(1, 0)));
    const float aliasing = std::fabs(mean - near(0, 0)) / (most - least);
    const float excess = aliasing - fxaa_.subpixelContrastThreshold;
    if (!(excess > 0.0f)) return 0.0f;
    const float scaled = excess * (1.0f / (1.0f - fxaa_.subpixelContrastThreshold));
    return scaled < fxaa_.subpixelBlendLimit ? scaled : fxaa_.subpixelBlendLimit;
  }

  bool isHorizontal() const
  {
    const auto bend = [](float a, float b, float c) { return std::fabs(-2.0f * b + (a + c)); };
    const auto strength = [](float side, float middle, float other) {
      return ((2.0f * middle + side) + other) / 12.0f;
    };
    const float vertical = strength(bend(near(-1, -1), near(0, -1), near(1, -1)),
                                    bend(near(-1, 0), near(0, 0), near(1, 0)),
                                    bend(near(-1, 1), near(0, 1), near(1, 1)));
    const float horizontal = strength(bend(near(-1, -1), near(-1, 0), near(-1, 1)),
                                      bend(near(0, -1), near(0, 0), near(0, 1)),
                                      bend(near(1, -1), near(1, 0), near(1, 1)));
    return horizontal >= vertical;
  }

  /// The pixel moved across its edge by as much as the edge's ends say.
  Vec3f alongEdge() const
  {
    const bool horizontal = isHorizontal();
    const Step along = horizontal ? Step{1, 0} : Step{0, 1};
    Step across = horizontal ? Step{0, -1} : Step{-1, 0};
    if (std::fabs(near(0, 0) - luma(across)) < std::fabs(near(0, 0) - luma(across * -1)))
      across = across * -1;
    if (fxaa_.endpointSearchIterations == 0) return color({0, 0});
    const EdgeEnds ends =
        fxaa_.highQualityEndpoints ? endsByPixels(along, across) : endsByMeans(along, across);
    const bool isBeforeNearer = ends.before < ends.after;
    const float end = isBeforeNearer ? ends.lumaBefore : ends.lumaAfter;
    if (!(fxaa_.highQualityEndpoints ? bendsHere(end, luma(across)) : leavesMean(end, across)))
      return color({0, 0});
    const int nearer = isBeforeNearer ? ends.before : ends.after;
    const float offset =
        0.5f - static_cast<float>(nearer) / static_cast<float>(ends.before + ends.after);
    return color({0, 0}) * (1.0f - offset) + color(across) * offset;
  }

  /// Walks both ways until isEnd(luma there), and looks at the luma by lumaAt(step).
  template <class LumaAt, class IsEnd>
  EdgeEnds walk(Step along, LumaAt lumaAt, IsEnd isEnd) const
  {
    EdgeEnds ends;
    bool isBeforeDone = false, isAfterDone = false;
    for (int i = 0; i < fxaa_.endpointSearchIterations; ++i) {
      if (!isBeforeDone) ends.lumaBefore = lumaAt(along * -ends.before);
      if (!isAfterDone) ends.lumaAfter = lumaAt(along * ends.after);
      isBeforeDone = isBeforeDone || isEnd(along * -ends.before, ends.lumaBefore);
      isAfterDone = isAfterDone || isEnd(along * ends.after, ends.lumaAfter);
      if (isBeforeDone && isAfterDone) break;
      if (!isBeforeDone) ++ends.before;
      if (!isAfterDone) ++ends.after;
    }
    return ends;
  }

  /// VTK's search: an edge ends where a pixel of one side looks more like the other side.
  EdgeEnds endsByPixels(Step along, Step across) const
  {
    const float here = near(0, 0), there = luma(across);
    return walk(
        along, [&](Step step) { return luma(step); },
        [&](Step step, float side) {
          const float opposite = luma(step, across);
          return std::fabs(opposite - there) > std::fabs(opposite - here) ||
                 std::fabs(side - here) > std::fabs(side - there);
        });
  }
  bool bendsHere(float end, float there) const
  {
    return std::fabs(end - there) < std::fabs(end - near(0, 0));
  }

  /// Lottes's search: an edge ends where the mean of its sides has changed.
  EdgeEnds endsByMeans(Step along, Step across) const
  {
    const float mean = 0.5f * (near(0, 0) + luma(across));
    const float threshold = std::fabs(near(0, 0) - luma(across)) / 4.0f;
    return walk(
        along, [&](Step step) { return 0.5f * (luma(step) + luma(step, across)); },
        [&](Step, float found) { return std::fabs(found - mean) >= threshold; });
  }
  bool leavesMean(float end, Step across) const
  {
    const float mean = 0.5f * (near(0, 0) + luma(across));
    return (near(0, 0) < mean) != (end < mean);
  }

  const Fxaa& fxaa_;
  const EffectPlanes& planes_;
  int x_, y_;
  float luma_[3][3];
};

void copyRow(const EffectPass& pass, int y)
{
  const FrameView& frame = pass.frame;
  const auto width = static_cast<std::size_t>(frame.width);
  const Rgba8* const color = frame.color + y * frame.rowStride;
  std::copy_n(color, width, pass.planes.jagged.data() + static_cast<std::size_t>(y) * width);
  float* const luma = pass.planes.luma.row(y);
  HWY_DYNAMIC_DISPATCH(lumaRowKernel)(color, width, luma);
  pass.planes.luma.padRow(y, luma[0], luma[frame.width - 1]);
}

void smoothRow(const EffectPass& pass, int y)
{
  const FrameView& frame = pass.frame;
  const PaddedPlane& luma = pass.planes.luma;
  thread_local std::vector<std::uint16_t> edges;
  edges.resize(static_cast<std::size_t>(frame.width));
  const LumaRows rows = {luma.row(std::max(y - 1, 0)), luma.row(y),
                         luma.row(std::min(y + 1, frame.height - 1))};
  const std::size_t count = HWY_DYNAMIC_DISPATCH(findEdgesKernel)(
      pass.effects.fxaa, rows, static_cast<std::size_t>(frame.width), edges.data());
  Rgba8* const color = frame.color + y * frame.rowStride;
  for (std::size_t i = 0; i < count; ++i)
    color[edges[i]] = EdgePixel(pass, edges[i], y).smooth();
}

}  // namespace

void smoothEdges(const EffectPass& pass)
{
  const FrameView& frame = pass.frame;
  pass.planes.luma.resize(frame.width, frame.height);
  pass.planes.jagged.resize(static_cast<std::size_t>(frame.width) *
                            static_cast<std::size_t>(frame.height));
  forEachRow(pass.threads, frame.height, [&](int y) { copyRow(pass, y); });
  forEachRow(pass.threads, frame.height, [&](int y) { smoothRow(pass, y); });
}

}  // namespace limn
#endif  // HWY_ONCE
