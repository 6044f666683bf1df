// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ClearViewport.h"

#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

namespace limn::bridge
{
namespace
{

using Frame = vtkLimnRenderWindow::vtkFrame;

// As llvmpipe makes bytes of a clear colour: in float, halves to even.
std::uint8_t toByte(double value)
{
  const float bounded = static_cast<float>(std::clamp(value, 0.0, 1.0));
  return static_cast<std::uint8_t>(std::nearbyint(bounded * 255.0f));
}

/// The colour of one row of the window.
class RowColor
{
public:
  RowColor(vtkRenderer* renderer, const Frame::Region& viewport) : renderer_(renderer)
  {
    double tile[4];
    renderer->GetRenderWindow()->GetTileViewport(tile);
    // Heights of the whole picture, of which the window may be just one tile.
    const double pictureHeight = renderer->GetRenderWindow()->GetSize()[1];
    const double* const part = renderer->GetViewport();
    bottom_ = (part[1] - std::max(tile[1], 0.0)) * pictureHeight;
    height_ = std::max((part[3] - part[1]) * pictureHeight, 1.0);
    if (tile[1] <= part[1] && tile[3] >= part[3])
    {
      bottom_ = viewport.Y;
      height_ = viewport.Height;
    }
  }

  Rgba8 at(int y) const
  {
    const double* const low = renderer_->GetBackground();
    if (!renderer_->GetGradientBackground())
    {
      return { toByte(low[0]), toByte(low[1]), toByte(low[2]),
        toByte(renderer_->GetBackgroundAlpha()) };
    }
    const double* const high = renderer_->GetBackground2();
    const double t = (y + 0.5 - bottom_) / height_;
    // VTK cuts the two ends to bytes before it interpolates.
    const auto mix = [t](double from, double to)
    {
      const double a = std::floor(std::clamp(from, 0.0, 1.0) * 255.0);
      const double b = std::floor(std::clamp(to, 0.0, 1.0) * 255.0);
      return toByte((a + (b - a) * t) / 255.0);
    };
    return { mix(low[0], high[0]), mix(low[1], high[1]), mix(low[2], high[2]), 255 };
  }

private:
  vtkRenderer* renderer_;
  double bottom_;
  double height_;
};

} // namespace

Frame::Region viewportOf(vtkRenderer* renderer, const Frame& frame)
{
  Frame::Region region;
  renderer->GetTiledSizeAndOrigin(&region.Width, &region.Height, &region.X, &region.Y);
  return frame.Clip(region);
}

void clearViewport(vtkRenderer* renderer, Frame& frame)
{
  const Frame::Region viewport = viewportOf(renderer, frame);
  if (viewport.IsEmpty())
  {
    return;
  }
  const RowColor color(renderer, viewport);
  const bool keepsColor = renderer->Transparent();
  const bool keepsDepth = renderer->GetPreserveDepthBuffer();
  if (!keepsColor && !keepsDepth && !renderer->GetGradientBackground())
  {
    frame.ClearLater(viewport, color.at(viewport.Y));
    return;
  }
  if (!keepsColor)
  {
    frame.ForEachRow(frame.GetColor(), viewport,
      [&](Rgba8* row, size_t count, size_t index) {
        std::fill_n(row, count, color.at(viewport.Y + static_cast<int>(index / viewport.Width)));
      });
  }
  if (!keepsDepth)
  {
    frame.ForEachRow(frame.GetDepth(), viewport,
      [](float* row, size_t count, size_t) { std::fill_n(row, count, 1.0f); });
  }
}

} // namespace limn::bridge
