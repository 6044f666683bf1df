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
  this->RegionToClear = { 0, 0, 0, 0 };
  this->Color.assign(pixels, limn::Rgba8{ 0, 0, 0, 0 });
  this->Depth.assign(pixels, 1.0f);
  // A window that became smaller should not hold on to the memory of the large one.
  this->Color.shrink_to_fit();
  this->Depth.shrink_to_fit();
  this->ResizeMaps();
}

void vtkLimnRenderWindow::vtkFrame::SetMaps(bool maps)
{
  if (maps != this->Maps)
  {
    this->Maps = maps;
    this->ResizeMaps();
  }
}

void vtkLimnRenderWindow::vtkFrame::ResizeMaps()
{
  const size_t pixels = this->Maps ? this->Color.size() : 0;
  for (limn::Array<float>& plane : this->Normal)
  {
    plane.assign(pixels, 0.0f);
    plane.shrink_to_fit();
  }
  for (limn::Array<std::uint32_t>* plane : { &this->Actor, &this->Cell })
  {
    plane->assign(pixels, limn::kNobody);
    plane->shrink_to_fit();
  }
  this->Actors.clear();
}

limn::Array<float>& vtkLimnRenderWindow::vtkFrame::GetNormal(int axis)
{
  this->ClearNow();
  return this->Normal[axis];
}

limn::Array<std::uint32_t>& vtkLimnRenderWindow::vtkFrame::GetActor()
{
  this->ClearNow();
  return this->Actor;
}

limn::Array<std::uint32_t>& vtkLimnRenderWindow::vtkFrame::GetCell()
{
  this->ClearNow();
  return this->Cell;
}

std::uint32_t vtkLimnRenderWindow::vtkFrame::NumberOf(vtkActor* actor)
{
  const auto known = std::find_if(this->Actors.begin(), this->Actors.end(),
    [actor](const vtkWeakPointer<vtkActor>& other) { return other.GetPointer() == actor; });
  const auto number = static_cast<std::uint32_t>(known - this->Actors.begin());
  if (known == this->Actors.end())
  {
    this->Actors.emplace_back(actor);
  }
  return number;
}

vtkActor* vtkLimnRenderWindow::vtkFrame::ActorOf(vtkIdType number) const
{
  return number >= 0 && number < static_cast<vtkIdType>(this->Actors.size())
           ? this->Actors[static_cast<size_t>(number)].GetPointer()
           : nullptr;
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

limn::Array<limn::Rgba8>& vtkLimnRenderWindow::vtkFrame::GetColor()
{
  this->ClearNow();
  return this->Color;
}

limn::Array<float>& vtkLimnRenderWindow::vtkFrame::GetDepth()
{
  this->ClearNow();
  return this->Depth;
}

void vtkLimnRenderWindow::vtkFrame::ClearLater(const Region& inside, limn::Rgba8 color)
{
  this->ClearNow();
  this->RegionToClear = inside;
  this->ClearColor = color;
  if (inside.GetSize() == this->Color.size())
  {
    this->Actors.clear();
  }
}

void vtkLimnRenderWindow::vtkFrame::ClearNow()
{
  const Region region = this->RegionToClear;
  if (region.IsEmpty())
  {
    return;
  }
  this->RegionToClear = { 0, 0, 0, 0 };
  // Rows are copies of a filled one: the compiler's own loops do not go by vectors here.
  const std::vector<limn::Rgba8> colors(region.Width, this->ClearColor);
  const std::vector<float> depths(region.Width, 1.0f);
  this->ForEachRow(this->Color, region,
    [&](limn::Rgba8* row, size_t count, size_t) { std::copy_n(colors.begin(), count, row); });
  this->ForEachRow(this->Depth, region,
    [&](float* row, size_t count, size_t) { std::copy_n(depths.begin(), count, row); });
  if (!this->Maps)
  {
    return;
  }
  for (limn::Array<float>& plane : this->Normal)
  {
    this->ForEachRow(
      plane, region, [](float* row, size_t count, size_t) { std::fill_n(row, count, 0.0f); });
  }
  for (limn::Array<std::uint32_t>* plane : { &this->Actor, &this->Cell })
  {
    this->ForEachRow(*plane, region,
      [](std::uint32_t* row, size_t count, size_t) { std::fill_n(row, count, limn::kNobody); });
  }
}

limn::FrameView vtkLimnRenderWindow::vtkFrame::View(const Region& inside)
{
  limn::FrameView view;
  const Region& toClear = this->RegionToClear;
  if (toClear.X == inside.X && toClear.Y == inside.Y && toClear.Width == inside.Width &&
      toClear.Height == inside.Height)
  {
    view.clear = { limn::FrameClear::Extent::kAll, this->ClearColor, 1.0f };
    this->RegionToClear = { 0, 0, 0, 0 };
  }
  const size_t corner = static_cast<size_t>(inside.Y) * this->Width + inside.X;
  view.width = inside.Width;
  view.height = inside.Height;
  view.rowStride = this->Width;
  view.color = this->GetColor().data() + corner;
  view.depth = this->GetDepth().data() + corner;
  view.background = limn::Background::kBlend;
  if (this->Maps)
  {
    view.normal = { this->Normal[0].data() + corner, this->Normal[1].data() + corner,
      this->Normal[2].data() + corner };
    view.instance = this->Actor.data() + corner;
    view.cell = this->Cell.data() + corner;
  }
  return view;
}
