// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Picture_h
#define Picture_h

#include "vtkRenderWindow.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <memory>
#include <ostream>
#include <vector>

using Pixel = std::array<int, 3>;

inline std::ostream& operator<<(std::ostream& os, const Pixel& pixel)
{
  return os << "(" << pixel[0] << ", " << pixel[1] << ", " << pixel[2] << ")";
}

/// What a window shows, row 0 at the bottom.
struct Picture
{
  int Width = 0;
  int Height = 0;
  std::vector<unsigned char> Bytes;

  Pixel At(int x, int y) const
  {
    const unsigned char* rgb = &this->Bytes[3 * (static_cast<size_t>(y) * this->Width + x)];
    return { rgb[0], rgb[1], rgb[2] };
  }
  bool operator==(const Picture& other) const
  {
    return this->Width == other.Width && this->Height == other.Height && this->Bytes == other.Bytes;
  }
  /// Pixels that are not `background`.
  int CountOtherThan(const Pixel& background) const
  {
    int count = 0;
    for (int y = 0; y < this->Height; ++y)
    {
      for (int x = 0; x < this->Width; ++x)
      {
        count += this->At(x, y) != background;
      }
    }
    return count;
  }
  /// Pixels that differ by more than `tolerance` in a channel.
  int CountDifferent(const Picture& other, int tolerance) const
  {
    int count = 0;
    for (size_t pixel = 0; 3 * pixel < this->Bytes.size(); ++pixel)
    {
      int most = 0;
      for (size_t i = 3 * pixel; i < 3 * pixel + 3; ++i)
      {
        most = std::max(most, std::abs(int(this->Bytes[i]) - int(other.Bytes[i])));
      }
      count += most > tolerance;
    }
    return count;
  }
};

inline Picture read(vtkRenderWindow* window)
{
  Picture picture;
  picture.Width = window->GetActualSize()[0];
  picture.Height = window->GetActualSize()[1];
  const std::unique_ptr<unsigned char[]> bytes(
    window->GetPixelData(0, 0, picture.Width - 1, picture.Height - 1, 1));
  picture.Bytes.assign(
    bytes.get(), bytes.get() + 3 * static_cast<size_t>(picture.Width) * picture.Height);
  return picture;
}

inline Picture render(vtkRenderWindow* window)
{
  window->Render();
  return read(window);
}

#endif
