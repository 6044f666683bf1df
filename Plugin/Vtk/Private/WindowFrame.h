// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef WindowFrame_h
#define WindowFrame_h

#include "EngineState.h"

#include "vtkActor.h"
#include "vtkLimnRenderWindow.h"
#include "vtkWeakPointer.h"

#include "Rendering/Base/Array.h"
#include "Rendering/Base/Executor.h"
#include "Rendering/FrameView.h"

#include <algorithm>
#include <vector>

/// The pixels of a Limn window, row 0 at the bottom; empty until the window is rendered.
class vtkLimnRenderWindow::vtkFrame
{
public:
  /// Pixels [X, X + Width) x [Y, Y + Height) of the window; may reach beyond its borders.
  struct Region
  {
    int X;
    int Y;
    int Width;
    int Height;

    /// From the corners that VTK's read-back functions take, in any order, both included. Empty if
    /// the region is larger than any image.
    static Region FromCorners(int x1, int y1, int x2, int y2);
    bool IsEmpty() const { return this->Width <= 0 || this->Height <= 0; }
    size_t GetSize() const
    {
      return this->IsEmpty() ? 0 : static_cast<size_t>(this->Width) * this->Height;
    }
  };

  /// Keeps the content if the size stays the same, else starts with zeros and the farthest depth.
  void Resize(int width, int height);
  bool IsEmpty() const { return this->Color.empty(); }
  int GetWidth() const { return this->Width; }
  int GetHeight() const { return this->Height; }
  limn::Array<limn::Rgba8>& GetColor();
  limn::Array<float>& GetDepth();

  /// Whether there are planes of normals and names besides; switched on they start as empty.
  void SetMaps(bool maps);
  bool HasMaps() const { return this->Maps; }
  /// In view space; (0, 0, 0) where nothing is seen. Only with maps, as the next two.
  limn::Array<float>& GetNormal(int axis);
  /// An actor's number, or limn::kNobody.
  limn::Array<std::uint32_t>& GetActor();
  limn::Array<std::uint32_t>& GetCell();
  /// The number of an actor in the picture. Numbers start anew when all of it is cleared.
  std::uint32_t NumberOf(vtkActor* actor);
  /// Null for numbers that are none, and for actors that are gone.
  vtkActor* ActorOf(vtkIdType number) const;

  /// The part of `region` that lies in the window.
  Region Clip(const Region& region) const;
  /// Fills the region with one colour and the farthest depth, when next somebody asks for pixels:
  /// mostly that is View(), whose user can do it for less.
  void ClearLater(const Region& inside, limn::Rgba8 color);
  /// The region to be drawn to. If it is the one to be cleared, that is left to the user of the
  /// view.
  limn::FrameView View(const Region& inside);

  /// Calls visit(pixel of the frame, or nullptr outside; index in the region) for each pixel of
  /// the region, row by row from below.
  template <class Planes, class Visit>
  void ForEach(Planes& plane, const Region& region, Visit visit)
  {
    size_t index = 0;
    for (int y = region.Y; y < region.Y + region.Height; ++y)
    {
      for (int x = region.X; x < region.X + region.Width; ++x, ++index)
      {
        const bool isInside = x >= 0 && x < this->Width && y >= 0 && y < this->Height;
        visit(isInside ? &plane[static_cast<size_t>(y) * this->Width + x] : nullptr, index);
      }
    }
  }

  /// Calls visit(first pixel of the frame, number of pixels, index of the first in the region) for
  /// the part of each row of the region that lies in the window; rows in any order, on several
  /// threads.
  template <class Planes, class Visit>
  void ForEachRow(Planes& plane, const Region& region, Visit visit) const
  {
    const Region inside = this->Clip(region);
    if (inside.IsEmpty())
    {
      return;
    }
    constexpr int RowsPerTask = 64;
    const int tasks = (inside.Height + RowsPerTask - 1) / RowsPerTask;
    limn::parallelFor(limn::bridge::EngineState::instance().options.threads, tasks,
      [&](size_t task)
      {
        const int first = inside.Y + static_cast<int>(task) * RowsPerTask;
        const int end = std::min(first + RowsPerTask, inside.Y + inside.Height);
        for (int y = first; y < end; ++y)
        {
          visit(&plane[static_cast<size_t>(y) * this->Width + inside.X],
            static_cast<size_t>(inside.Width),
            static_cast<size_t>(y - region.Y) * region.Width + (inside.X - region.X));
        }
      });
  }

private:
  void ClearNow();
  void ResizeMaps();

  int Width = 0;
  int Height = 0;
  limn::Array<limn::Rgba8> Color;
  limn::Array<float> Depth;
  bool Maps = false;
  limn::Array<float> Normal[3];
  limn::Array<std::uint32_t> Actor;
  limn::Array<std::uint32_t> Cell;
  std::vector<vtkWeakPointer<vtkActor>> Actors; ///< by number
  Region RegionToClear = { 0, 0, 0, 0 };        ///< empty if none is
  limn::Rgba8 ClearColor = { 0, 0, 0, 0 };
};

#endif
