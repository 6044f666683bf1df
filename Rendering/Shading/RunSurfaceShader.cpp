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

void addOrigin(Vec3d origin, int count, FragmentVectors& positions)
{
  if (origin == Vec3d{0, 0, 0}) return;
  for (int i = 0; i < count; ++i)
    positions.set(i, vec3Cast<float>(origin + vec3Cast<double>(positions[i])));
}

}  // namespace

std::uint32_t cellOf(const TileClusters& clusters, std::uint32_t owner)
{
  const PlacedCluster& cluster = clusters.at(TileOwner::slot(owner));
  const std::uint32_t triangle = cluster.meshTriangle(TileOwner::triangle(owner));
  const Span<const std::uint32_t> cells = cluster.placed->instance->attributes.cells;
  return cells.empty() ? triangle : cells[triangle];
}

void callSurfaceShader(const ShadingContext& context, int count, SurfaceArrays& surfaces,
                       FragmentVectors& colors)
{
  const Instance& instance = *context.placed->instance;
  const bool hasUv = !instance.attributes.uv.empty();
  addOrigin(context.placed->mesh().origin, count, surfaces.modelPosition);
  instance.style.surfaceShader->shade(
      {count, surfaces.position, surfaces.modelPosition, surfaces.normal, surfaces.ambient,
       surfaces.diffuse, surfaces.specular, hasUv ? surfaces.u : nullptr,
       hasUv ? surfaces.v : nullptr, surfaces.pixelX, surfaces.pixelY, surfaces.cell},
      BatchLighting(context), colors);
}

void runSurfaceShader(const ShadingContext& context, const TileClusters& clusters,
                      const TileRectangle& pixels, FragmentBatch& batch)
{
  SurfaceArrays surfaces;
  describeSurfaces(context, batch, surfaces);
  for (int i = 0; i < batch.count; ++i) {
    surfaces.pixelX[i] = pixels.x0 + batch.pixel[i] % kTileSide;
    surfaces.pixelY[i] = pixels.y0 + batch.pixel[i] / kTileSide;
    surfaces.cell[i] = cellOf(clusters, batch.owner[i]);
  }
  callSurfaceShader(context, batch.count, surfaces, batch.color);
  finishSurfaces(context, surfaces, batch);
}

}  // namespace limn
