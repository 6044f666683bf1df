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
  alignas(64) float u[FragmentVectors::kCapacity], v[FragmentVectors::kCapacity];
  alignas(64) std::int32_t pixelX[FragmentVectors::kCapacity], pixelY[FragmentVectors::kCapacity];
  alignas(64) std::uint32_t cell[FragmentVectors::kCapacity];
};

/// Fills the batch's `color` by its instance's surface shader.
/// Requires: as lightFragments().
void runSurfaceShader(const ShadingContext& context, const TileClusters& clusters,
                      const TileRectangle& pixels, FragmentBatch& batch);
/// shadeTriangles() by the instance's surface shader.
void runSurfaceShader(const ShadingContext& context, const TileClusters& clusters,
                      const TileRectangle& pixels, const FragmentList& fragments,
                      Span<const std::uint32_t> numbers, const FragmentBatch& batch,
                      TileColors& colors);

// The parts of these:

/// Cell of the triangle that an owner of the tile names.
std::uint32_t cellOf(const TileClusters& clusters, std::uint32_t owner);
/// Fills all vectors, modelPosition relative to the mesh's origin, and u and v if it has any.
void describeSurfaces(const ShadingContext& context, const FragmentBatch& batch,
                      SurfaceArrays& surfaces);
/// Moves modelPosition to its place and calls the shader.
/// Requires: all of `surfaces`.
void callSurfaceShader(const ShadingContext& context, int count, SurfaceArrays& surfaces,
                       FragmentVectors& colors);
/// Does to the batch's colours what textures do after the light equation, and draws the outline.
void finishSurfaces(const ShadingContext& context, const SurfaceArrays& surfaces,
                    FragmentBatch& batch);
/// SurfaceLighting::light().
void lightSurfaces(const ShadingContext& context, const SurfaceFragments& fragments,
                   FragmentVectors& colors);
/// SurfaceLighting::arrive().
void arriveAtSurfaces(const ShadingContext& context, std::size_t light,
                      const SurfaceFragments& fragments, FragmentVectors& towards, float* falls);

}  // namespace limn
