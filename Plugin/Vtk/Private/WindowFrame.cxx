// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "WindowFrame.h"

#include <algorithm>

vtkLimnRenderWindow::vtkFrame::Region vtkLimnRenderWindow::vtkFrame::Region::FromCorners(
  int x1, int y1, int x2, int y2)
{
  const long long width = std::abs(static_cast<long long>(x2) - x1) + 1;
  const long long height = std::abs(static_cast<long long>(y2) - y1) + 1;
  // A window is never larger; four times that leaves room for callers who ask for too much.
  constexpr long long kLargestSide = 4LL * limn::kMaxImageSide;
  if (width > kLargestSide || height > kLargestSide)
  {
    return { 0, 0, 0, 0 };
  }
  return { std::min(x1, x2), std::min(y1, y2), static_cast<int>(width), static_cast<int>(height) };
}

void vtkLimnRenderWindow::vtkFrame::Resize(int width, int height)
{
  if (width == this->Width && height == this->Height)
  {
    return;
  }
  const size_t pixels = static_cast<size_t>(width) * height;
  this->Width = width;
  this->Height = height;
  this->Color.assign(pixels, limn::Rgba8{ 0, 0, 0, 0 });
  this->Depth.assign(pixels, 1.0f);
  // A window that became smaller should not hold on to the memory of the large one.
  this->Color.shrink_to_fit();
  this->Depth.shrink_to_fit();
}

vtkLimnRenderWindow::vtkFrame::Region vtkLimnRenderWindow::vtkFrame::Clip(
  const Region& region) const
{
  const int x0 = std::max(region.X, 0);
  const int y0 = std::max(region.Y, 0);
  const int x1 = std::min(region.X + region.Width, this->Width);
  const int y1 = std::min(region.Y + region.Height, this->Height);
  return { x0, y0, std::max(x1 - x0, 0), std::max(y1 - y0, 0) };
}

limn::FrameView vtkLimnRenderWindow::vtkFrame::View(const Region& inside)
{
  const size_t corner = static_cast<size_t>(inside.Y) * this->Width + inside.X;
  limn::FrameView view;
  view.width = inside.Width;
  view.height = inside.Height;
  view.rowStride = this->Width;
  view.color = this->Color.data() + corner;
  view.depth = this->Depth.data() + corner;
  view.background = limn::Background::kBlend;
  return view;
}
