// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/FrameView.h"
#include "Rendering/Scene.h"
#include "Rendering/Vertex/ScreenToView.h"

#include <cstdint>
#include <vector>

namespace limn::reference {

/// What a pixel shows of the surface that its nearest sample lies on.
struct Layer {
  std::uint32_t instance = kNobody;  ///< place in Scene::instances; kNobody: nothing is shown
  float depth = 1;                   ///< of the nearest sample, or of what was there before
  Vec2f place;                       ///< of that sample; pixels
  ViewPoint point;
  Vec3f normal;       ///< FrameView::normal
  Vec3f plane;        ///< that of the triangle's plane
  int count, shared;  ///< samples that show it, and samples that the pixel's colour is the mean of
  int covered;        ///< samples that show any opaque instance
  std::uint32_t other = kNobody;  ///< instance of the first sample that shows another surface
  Rgba8 color;                    ///< mean of those that show it
  Vec3f radiance;                 ///< likewise
  std::uint32_t id = 0;  ///< that of Attributes::cellIds that most of `count` show, or the first
  int idSamples = 0;     ///< how many of `count` show that
  float halo = 0;  ///< share of it that a halo has; of nobody's what it had of a layer far off
  std::size_t haloOf = 0;      ///< if that is not 0: the pixel whose surface has the halo
  std::size_t haloBeyond = 0;  ///< likewise: the pixel whose halo goes on farthest beyond this one
  bool endsHere = false;       ///< the surface has a halo and ends here
};

/// Whether two points lie on different surfaces of one instance: one is off the other's plane by
/// more than the tolerance, and not behind both.
bool isStep(const Layer& p, const Layer& q, float tolerance);
/// Of two samples of a pixel: no step, or the two sides of a groove.
bool areOneSurface(const Layer& p, const Layer& q, float tolerance);
/// What of a step at a layer is too little to be one.
float toleranceAt(const Scene& scene, const Layer& p);

/// The mean of the pixel's samples that the layer has not, of one channel.
std::uint8_t meanOfRest(std::uint8_t pixel, std::uint8_t own, const Layer& l, Resolve resolve);
float meanOfRest(float pixel, float own, const Layer& l);  ///< of radiance

/// How many pixels around the frame lines may come from.
int outlineApron(const Scene& scene);

/// Draws the lines of Style::imageOutline, pixel after pixel. `layers` are those of all pixels of
/// the frame and of so many around it, at least outlineApron(), row by row.
void drawOutlines(const Scene& scene, const FrameView& frame, const std::vector<Layer>& layers,
                  int apron);

}  // namespace limn::reference
