// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CompareCommand.h"

#include "Picture.h"

#include <algorithm>
#include <cstdlib>
#include <iostream>

namespace limn::viewer
{
namespace
{

constexpr std::size_t kChannels = 4;

struct Difference
{
  std::size_t pixels = 0, differing = 0; ///< differing: by more than the tolerance
  int largest = 0;                       ///< of any channel
  double sum = 0;                        ///< over all channels of all pixels
};

Difference differenceOf(const Picture& a, const Picture& b, int tolerance)
{
  Difference difference;
  difference.pixels = a.rgba.size() / kChannels;
  for (std::size_t pixel = 0; pixel < difference.pixels; ++pixel)
  {
    int largest = 0;
    for (std::size_t i = pixel * kChannels; i < (pixel + 1) * kChannels; ++i)
    {
      const int apart = std::abs(a.rgba[i] - b.rgba[i]);
      largest = std::max(largest, apart);
      difference.sum += apart;
    }
    difference.largest = std::max(difference.largest, largest);
    difference.differing += largest > tolerance ? 1 : 0;
  }
  return difference;
}

std::string sizeOf(const Picture& picture)
{
  return std::to_string(picture.width) + " x " + std::to_string(picture.height);
}

} // namespace

ExitStatus compare(const CompareSettings& settings)
{
  const Picture a = readPicture(settings.pictures[0]);
  const Picture b = readPicture(settings.pictures[1]);
  if (sizeOf(a) != sizeOf(b))
  {
    throw UserError("the pictures have different sizes: " + settings.pictures[0] + " is " +
                    sizeOf(a) + ", " + settings.pictures[1] + " is " + sizeOf(b));
  }
  const Difference difference = differenceOf(a, b, settings.tolerance);
  const double mean = difference.sum / static_cast<double>(a.rgba.size());
  std::cout << difference.differing << " of " << difference.pixels << " pixels differ";
  if (settings.tolerance > 0)
  {
    std::cout << " by more than " << settings.tolerance;
  }
  std::cout << "; largest difference " << difference.largest << ", mean " << mean << '\n';
  return difference.differing == 0 ? ExitSuccess : ExitPicturesDiffer;
}

} // namespace limn::viewer
