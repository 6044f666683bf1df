// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Array.h"
#include "Rendering/Raster/VisibilityTile.h"

#include <array>
#include <cstdint>

namespace limn {

/// Pixels next to each other in a row that show one triangle in all their samples.
struct FragmentRun {
  static constexpr int kShortest = 5;
  static constexpr std::uint16_t kNone = 0xFFFF;

  std::uint16_t pixel;   ///< the first: row * kTileSide + column, within the tile
  std::uint16_t length;  ///< at least kShortest; 0: listed as fragments after all
  std::uint16_t next;    ///< number of another run of the same triangle, or kNone
};

/// Triangles seen in the pixels of a tile; each is shaded once a pixel, whatever number of the
/// pixel's samples show it. Large triangles are listed by runs, so that what is true of all their
/// fragments is worked out once, all else as fragments.
struct FragmentList {
  static constexpr std::size_t kMaxRuns = kTilePixels / FragmentRun::kShortest;

  std::size_t count = 0;       ///< of fragments
  Array<std::uint32_t> owner;  ///< TileOwner
  Array<std::uint32_t> pixel;  ///< row * kTileSide + column, within the tile
  Array<std::uint16_t>
      coverage;  ///< bit s set: sample s shows it; not filled with one sample a pixel

  std::size_t runCount = 0;
  std::array<FragmentRun, kMaxRuns> run;
  std::size_t triangleCount = 0;  ///< of those that have runs
  std::array<std::uint32_t, kMaxRuns> triangleOwner;
  std::array<std::uint16_t, kMaxRuns> firstRun;  ///< by triangle

  /// Makes room for all that `samples` samples can show, and for a vector more.
  void reserve(int samples);
  void addRun(std::uint32_t owner, int pixel, int length);
  /// Lists a triangle's runs as fragments instead.
  void breakRuns(std::size_t triangle, int samples);

 private:
  static constexpr int kPlaceBits = 11;
  static constexpr std::size_t kPlaces = std::size_t{1} << kPlaceBits;
  static_assert(kPlaces > 2 * kMaxRuns, "more than half of the places stay free");
  /// Open hashing of owners: numbers of triangles. Valid while triangleCount is not 0.
  std::array<std::uint16_t, kPlaces> place_;
};

/// Lists the fragments of a tile, pixel by pixel, those of large triangles by runs if `byRuns`.
/// Within a pixel they follow their first sample.
void collectFragments(const VisibilityTile& tile, const TileRectangle& pixels, int samples,
                      bool byRuns, FragmentList& fragments);

}  // namespace limn
