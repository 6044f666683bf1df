// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Shading/RunSurfaceShader.h"

namespace limn {
namespace {

class BatchLighting final : public SurfaceLighting {
 public:
  explicit BatchLighting(const ShadingContext& context)
      : SurfaceLighting(*context.scene->scene, *context.placed->instance, context.scene->lights),
        context_(context)
  {
  }

  void light(const SurfaceFragments& fragments, FragmentVectors& colors) const override
  {
    lightSurfaces(context_, fragments, colors);
  }
  void arrive(std::size_t i, const SurfaceFragments& fragments, FragmentVectors& towards,
              float* falls) const override
  {
    arriveAtSurfaces(context_, i, fragments, towards, falls);
  }

 private:
  const ShadingContext& context_;
};

void nameCells(const TileClusters& clusters, const FragmentBatch& batch, SurfaceArrays& surfaces)
{
  for (int i = 0; i < batch.count; ++i) {
    const PlacedCluster& cluster = clusters.at(TileOwner::slot(batch.owner[i]));
    const std::uint32_t triangle = cluster.meshTriangle(TileOwner::triangle(batch.owner[i]));
    const Span<const std::uint32_t> cells = cluster.placed->instance->attributes.cells;
    surfaces.cell[i] = cells.empty() ? triangle : cells[triangle];
  }
}

void namePixels(const TileRectangle& pixels, const FragmentBatch& batch, SurfaceArrays& surfaces)
{
  for (int i = 0; i < batch.count; ++i) {
    surfaces.pixelX[i] = pixels.x0 + batch.pixel[i] % kTileSide;
    surfaces.pixelY[i] = pixels.y0 + batch.pixel[i] / kTileSide;
  }
}

void addOrigin(Vec3d origin, int count, FragmentVectors& positions)
{
  if (origin == Vec3d{0, 0, 0}) return;
  for (int i = 0; i < count; ++i)
    positions.set(i, vec3Cast<float>(origin + vec3Cast<double>(positions[i])));
}

}  // namespace

void runSurfaceShader(const ShadingContext& context, const TileClusters& clusters,
                      const TileRectangle& pixels, FragmentBatch& batch)
{
  SurfaceArrays surfaces;
  describeSurfaces(context, batch, surfaces);
  addOrigin(context.placed->mesh().origin, batch.count, surfaces.modelPosition);
  nameCells(clusters, batch, surfaces);
  namePixels(pixels, batch, surfaces);
  const SurfaceFragments fragments = {batch.count,       surfaces.position, surfaces.modelPosition,
                                      surfaces.normal,   surfaces.ambient,  surfaces.diffuse,
                                      surfaces.specular, surfaces.pixelX,   surfaces.pixelY,
                                      surfaces.cell};
  const Style& style = context.placed->instance->style;
  style.surfaceShader->shade(fragments, BatchLighting(context), batch.color);
  if (style.outlineThreshold > 0.0f) outlineSurfaces(context, fragments, batch.color);
}

}  // namespace limn
