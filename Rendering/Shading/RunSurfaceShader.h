// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Shading/Fragments.h"
#include "Rendering/SurfaceShader.h"

namespace limn {

/// What a surface shader is told of a batch's fragments.
struct SurfaceArrays {
  FragmentVectors position;
  FragmentVectors modelPosition;
  FragmentVectors normal;
  FragmentVectors ambient, diffuse, specular;
  alignas(64) std::int32_t pixelX[FragmentVectors::kCapacity], pixelY[FragmentVectors::kCapacity];
  alignas(64) std::uint32_t cell[FragmentVectors::kCapacity];
};

/// Fills the batch's `color` by its instance's surface shader, and its outline.
/// Requires: as lightFragments().
void runSurfaceShader(const ShadingContext& context, const TileClusters& clusters,
                      const TileRectangle& pixels, FragmentBatch& batch);

/// Fills all vectors; modelPosition relative to the mesh's origin.
void describeSurfaces(const ShadingContext& context, const FragmentBatch& batch,
                      SurfaceArrays& surfaces);
/// SurfaceLighting::light().
void lightSurfaces(const ShadingContext& context, const SurfaceFragments& fragments,
                   FragmentVectors& colors);
/// SurfaceLighting::arrive().
void arriveAtSurfaces(const ShadingContext& context, std::size_t light,
                      const SurfaceFragments& fragments, FragmentVectors& towards, float* falls);
/// Gives fragments on the instance's outline its colour.
void outlineSurfaces(const ShadingContext& context, const SurfaceFragments& fragments,
                     FragmentVectors& colors);

}  // namespace limn
