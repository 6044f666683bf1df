// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <vector>

/// What a window shows, RGBA, row 0 at the bottom.
struct Picture
{
  int Width = 0;
  int Height = 0;
  std::vector<unsigned char> Bytes;

  const unsigned char* At(int x, int y) const
  {
    return this->Bytes.data() + 4 * (static_cast<size_t>(y) * this->Width + x);
  }
};

/// The number of pixels of which a channel differs by more than `tolerance`; all if the sizes
/// differ.
inline int CountDifferent(const Picture& a, const Picture& b, int tolerance = 0)
{
  if (a.Width != b.Width || a.Height != b.Height || a.Bytes.size() != b.Bytes.size())
  {
    return std::max(a.Width * a.Height, b.Width * b.Height);
  }
  int count = 0;
  for (size_t pixel = 0; pixel < a.Bytes.size(); pixel += 4)
  {
    bool differs = false;
    for (size_t channel = pixel; channel < pixel + 4; ++channel)
    {
      differs |= std::abs(int(a.Bytes[channel]) - int(b.Bytes[channel])) > tolerance;
    }
    count += differs;
  }
  return count;
}
