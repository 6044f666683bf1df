// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Limit_h
#define Limit_h

#include "Rendering/Scene.h"

#include <cstddef>
#include <vector>

/// What a frame cannot do without, if some of the scene's clusters are drawn.
///
/// Each datum comes from memory once and each pixel goes there once, at the bandwidth measured
/// just before. Each step of the pipeline is done once, by its own code, on data that lies in the
/// processor's caches already; its time is the best of some runs. There are no lists of clusters
/// by tile and no waiting, and the work is shared out evenly. What is left is a bound for any
/// renderer built of these kernels.
struct Floor
{
  std::size_t Clusters = 0, Triangles = 0;
  double GeometryBytes = 0; ///< positions and corner numbers of these, boxes of all
  double ReadBytesPerMillisecond = 0;

  // Milliseconds of one thread, had it to do all.
  double Sift = 0;  ///< vertices to the screen, triangles that cover no sample dropped; each once
  double Cover = 0; ///< the rest of drawing: depth and owner of samples
};

struct Limit
{
  int Threads = 0;
  Floor Full;   ///< all clusters whose boxes meet the picture
  Floor Oracle; ///< those of which something is seen in the end, as if one knew

  double AttributeBytes = 0; ///< normals and numbers of the vertices of triangles seen
  double PictureBytes = 0;   ///< colour and depth, 4 bytes each, of all pixels
  double WriteBytesPerMillisecond = 0;
  // Milliseconds of one thread, had it to do all.
  double Bound = 0;   ///< boxes of all clusters on the screen
  double Shade = 0;   ///< fragments listed and lit
  double Resolve = 0; ///< tiles cleared, and written to the picture
  std::size_t Fragments = 0;

  // What a machine of many cores cannot get below: one thread draws a tile.
  std::size_t Tiles = 0;  ///< that clusters meet
  double LargestTile = 0; ///< milliseconds, with the clusters that are seen

  double MemoryMilliseconds(const Floor& floor) const;
  double ProcessorMilliseconds(const Floor& floor) const;
  /// The larger of the two: memory and processor may work at the same time.
  double Milliseconds(const Floor& floor) const;
};

struct ReplayedFrame
{
  limn::Scene Scene;
  int Width, Height;
  int Threads;
};

/// Measures, and draws the picture over `color`, bottom row first.
Limit MeasureLimit(const ReplayedFrame& frame, std::vector<limn::Rgba8>& color);

#endif
