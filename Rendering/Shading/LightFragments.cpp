// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Shading/Fragments.h"

#include "Rendering/Base/Power.h"
#include "Rendering/Shading/RunSurfaceShader.h"
#include "Rendering/Shading/ShadingOffsets.h"

#include <algorithm>
#include <cstring>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Rendering/Shading/LightFragments.cpp"
#include <hwy/foreach_target.h>

// clang-format off: the second builds on the first
#include "Rendering/Shading/LightFragments-inl.h"
#include "Rendering/Shading/SurfaceShaders-inl.h"
// clang-format on

#if HWY_ONCE
namespace limn {

HWY_EXPORT(lightFragmentsKernel);
HWY_EXPORT(fadeFragmentsKernel);
HWY_EXPORT(quantizeFragmentsKernel);
HWY_EXPORT(boundRadianceKernel);
HWY_EXPORT(shadeTrianglesKernel);
HWY_EXPORT(findNormalsKernel);
HWY_EXPORT(findPlanesKernel);
HWY_EXPORT(findRunNormalsKernel);
HWY_EXPORT(describeSurfacesKernel);
HWY_EXPORT(runSurfaceShaderKernel);
HWY_EXPORT(lightSurfacesKernel);
HWY_EXPORT(arriveAtSurfacesKernel);
HWY_EXPORT(finishSurfacesKernel);
HWY_EXPORT(shadeRunsKernel);

void lightFragments(const ShadingContext& context, FragmentBatch& batch)
{
  HWY_DYNAMIC_DISPATCH(lightFragmentsKernel)(context, batch);
}

void fadeFragments(const ShadingContext& context, FragmentBatch& batch)
{
  HWY_DYNAMIC_DISPATCH(fadeFragmentsKernel)(context, batch);
}

void shadeTriangles(const ShadingContext& context, const TileRectangle& pixels,
                    const FragmentList& fragments, Span<const std::uint32_t> numbers,
                    const FragmentBatch& batch, TileColors& colors)
{
  HWY_DYNAMIC_DISPATCH(shadeTrianglesKernel)(context, pixels, fragments, numbers, batch, colors);
}

void findNormals(const ShadingContext& context, FragmentBatch& batch)
{
  HWY_DYNAMIC_DISPATCH(findNormalsKernel)(context, batch);
}

void findPlanes(const ShadingContext& context, FragmentBatch& batch)
{
  HWY_DYNAMIC_DISPATCH(findPlanesKernel)(context, batch);
}

void findNormals(const ShadingContext& context, const TileRectangle& pixels,
                 const FragmentList& fragments, Span<const std::uint32_t> numbers,
                 const FragmentBatch& batch, TileColors& colors)
{
  HWY_DYNAMIC_DISPATCH(findRunNormalsKernel)(context, pixels, fragments, numbers, batch, colors);
}

void shadeRuns(const ShadingContext& context, const TileRectangle& pixels, int samples,
               Span<const std::uint32_t> numbers, const FragmentBatch& batch,
               TranslucentFragments& fragments)
{
  HWY_DYNAMIC_DISPATCH(shadeRunsKernel)(context, pixels, samples, numbers, batch, fragments);
}

void quantizeFragments(const FragmentBatch& batch, Rgba8* colors)
{
  HWY_DYNAMIC_DISPATCH(quantizeFragmentsKernel)(batch, colors);
}

void boundRadiance(FragmentBatch& batch)
{
  HWY_DYNAMIC_DISPATCH(boundRadianceKernel)(batch);
}

void describeSurfaces(const ShadingContext& context, const FragmentBatch& batch,
                      SurfaceArrays& surfaces)
{
  HWY_DYNAMIC_DISPATCH(describeSurfacesKernel)(context, batch, surfaces);
}

void runSurfaceShader(const ShadingContext& context, const TileClusters& clusters,
                      const TileRectangle& pixels, const FragmentList& fragments,
                      Span<const std::uint32_t> numbers, const FragmentBatch& batch,
                      TileColors& colors)
{
  HWY_DYNAMIC_DISPATCH(runSurfaceShaderKernel)
  (context, clusters, pixels, fragments, numbers, batch, colors);
}

void lightSurfaces(const ShadingContext& context, const SurfaceFragments& fragments,
                   FragmentVectors& colors)
{
  HWY_DYNAMIC_DISPATCH(lightSurfacesKernel)(context, fragments, colors);
}

void arriveAtSurfaces(const ShadingContext& context, std::size_t light,
                      const SurfaceFragments& fragments, FragmentVectors& towards, float* falls)
{
  HWY_DYNAMIC_DISPATCH(arriveAtSurfacesKernel)(context, light, fragments, towards, falls);
}

void finishSurfaces(const ShadingContext& context, const SurfaceArrays& surfaces,
                    FragmentBatch& batch)
{
  HWY_DYNAMIC_DISPATCH(finishSurfacesKernel)(context, surfaces, batch);
}

}  // namespace limn
#endif  // HWY_ONCE
