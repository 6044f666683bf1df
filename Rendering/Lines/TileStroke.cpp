// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/TileStroke.h"

#include <algorithm>
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Rendering/Lines/TileStroke.cpp"
#include <hwy/foreach_target.h>

#include "Rendering/Lines/TileStroke-inl.h"

#if HWY_ONCE
namespace limn {

HWY_EXPORT(coverStrokeKernel);

namespace {

/// Of a direction along an axis the quadratic part has no width, and its factor no bound.
constexpr double kSmallestShare = 1e-4;
constexpr float kFarAway = 1e30f;

void setPixelShares(double normalX, double normalY, TileStroke& stroke)
{
  const double x = std::fabs(normalX), y = std::fabs(normalY);
  const double more = std::max(x, y), less = std::max(std::min(x, y), kSmallestShare);
  stroke.inner = static_cast<float>(0.5 * (more - less));
  stroke.outer = static_cast<float>(0.5 * (more + less));
  stroke.linear = static_cast<float>(1.0 / more);
  stroke.quadratic = static_cast<float>(1.0 / (2.0 * more * less));
}

/// Pixels of the tile in [low, high], from its corner.
void clampToTile(double low, double high, int size, int& first, int& end)
{
  first = static_cast<int>(std::min(std::max(std::floor(low), 0.0), static_cast<double>(size)));
  end = static_cast<int>(std::min(std::max(std::ceil(high), 0.0), static_cast<double>(size)));
}

}  // namespace

TileStroke strokeInTile(const StrokePiece& piece, const TileRectangle& tile)
{
  const double dx = piece.x1 - piece.x0, dy = piece.y1 - piece.y0;
  const double length = std::sqrt(dx * dx + dy * dy);
  const double alongX = length > 0 ? dx / length : 1.0, alongY = length > 0 ? dy / length : 0.0;
  const double normalX = -alongY, normalY = alongX;
  const double toCornerX = tile.x0 - piece.x0, toCornerY = tile.y0 - piece.y0;
  TileStroke stroke;
  stroke.distance = static_cast<float>(toCornerX * normalX + toCornerY * normalY);
  stroke.normalX = static_cast<float>(normalX);
  stroke.normalY = static_cast<float>(normalY);
  stroke.along = static_cast<float>(toCornerX * alongX + toCornerY * alongY);
  stroke.alongX = static_cast<float>(alongX);
  stroke.alongY = static_cast<float>(alongY);
  stroke.length = static_cast<float>(length);
  stroke.inverseLength = length > 0 ? static_cast<float>(1.0 / length) : 0.0f;
  stroke.half = piece.half0;
  stroke.halfGrowth = piece.half1 - piece.half0;
  stroke.startLimit = piece.round0 ? -kFarAway : 0.0f;
  stroke.endLimit = piece.round1 ? kFarAway : stroke.length;
  stroke.round0 = piece.round0 ? 1.0f : 0.0f;
  stroke.round1 = piece.round1 ? 1.0f : 0.0f;
  stroke.nearest = piece.depth0;
  stroke.depthGrowth = piece.depth1 - piece.depth0;
  setPixelShares(normalX, normalY, stroke);
  const double reach = static_cast<double>(std::max(piece.half0, piece.half1)) + 1.0;
  stroke.reach = static_cast<float>(reach);
  clampToTile(std::min(piece.x0, piece.x1) - reach - tile.x0,
              std::max(piece.x0, piece.x1) + reach - tile.x0, tile.x1 - tile.x0, stroke.x0,
              stroke.x1);
  clampToTile(std::min(piece.y0, piece.y1) - reach - tile.y0,
              std::max(piece.y0, piece.y1) + reach - tile.y0, tile.y1 - tile.y0, stroke.y0,
              stroke.y1);
  return stroke;
}

void coverStroke(const TileStroke& stroke, StrokeTile& tile)
{
  HWY_DYNAMIC_DISPATCH(coverStrokeKernel)(stroke, tile);
}

}  // namespace limn
#endif  // HWY_ONCE
