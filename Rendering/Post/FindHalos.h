// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Post/CuePass.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace limn {

/// Which pixels of a frame have a halo over them, and whose.
class HaloFinder {
 public:
  /// Keeps its distances in `all`.
  HaloFinder(const CuePass& pass, const DistancePlane& distances, Array<float>& all);

  bool any() const { return reach_ > 0; }
  /// Fills SurfaceLayers::halo, haloOwner and ends.
  void find();

  /// Requires: SurfaceLayers::halo there is not 0.
  Vec3f colorAt(std::size_t index) const { return haloOf(pass_.layers.haloOwner[index]).color; }
  /// Where a surface with a halo ends: before others or the background; before itself, too.
  struct Column {
    int x;
    bool isBeforeItself;
  };
  /// Those of a row of the frame, in their order, with those of the apron on both sides.
  const std::vector<Column>& bordersOf(int y) const
  {
    return borders_[static_cast<std::size_t>(y + reach_)];
  }
  /// Of a pixel that is one of these: the share that its halo has of what its surface leaves of it,
  /// which lies behind.
  float shareBehind(Column end, int y) const;

 private:
  const Halo& haloOf(std::size_t index) const
  {
    return pass_.scene.instances[pass_.layers.instance[index]].style.cues.halo;
  }
  bool areOneSurface(std::size_t behind, std::size_t before, bool isBeforeItself) const;
  void fillDistances(int y);
  float distanceBeside(std::size_t index) const;
  float slopeTo(std::size_t index, float distance, std::uint32_t instance) const;
  enum class End : std::uint8_t { kNone, kBeforeOthers, kBeforeItself };
  End endAt(int x, int y) const;
  void findBorders(int y);
  void findShares(int y);
  void addHalo(int y, Column end, int row, std::vector<float>& farthest);
  bool isStep(std::size_t behind, std::size_t before) const;

  const CuePass& pass_;
  const DistancePlane& inFrame_;
  Array<float>& distance_;                    ///< by pixels of the layers: those of haloApron()
  int reach_ = 0;                             ///< of the widest halo, in pixels
  int apron_;                                 ///< haloApron()
  bool cutsPanes_ = false;                    ///< there are translucent surfaces
  bool cutsOverNobody_ = false;               ///< lines or translucent surfaces, which may be there
  std::vector<float> width_;                  ///< by instance; 0: none
  std::vector<std::vector<Column>> borders_;  ///< by rows of the frame and reach_ around it
};

}  // namespace limn
