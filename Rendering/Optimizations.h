// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace limn {

/// Ways of the pipeline to the same picture that cost less. For developers, who may switch them off
/// one by one to see what each is worth, and for the tests, which hold on == off.
struct Optimizations {
  /// Clusters are drawn from front to back, and left out where the tile is nearer already.
  bool occlusionCulling = true;
  /// Clusters below 112 pixels are set up in 16-bit arithmetic, and their triangles that meet 4 x 4
  /// pixels or fewer drawn a vector of triangles at a time.
  bool smallClusters = true;
  /// Pixels next to each other that show one triangle are shaded by what the triangle is.
  bool fragmentRuns = true;
};

}  // namespace limn
