// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What surface shaders are given and may ask for. Compiled once per instruction set by
// LightFragments.cpp, behind LightFragments-inl.h.
HWY_BEFORE_NAMESPACE();
namespace limn::HWY_NAMESPACE {

/// Arrays of a user's need not be aligned.
HWY_INLINE Lanes3 load(const FragmentVectorsView& v, std::size_t i)
{
  return {hn::LoadU(D(), v.x + i), hn::LoadU(D(), v.y + i), hn::LoadU(D(), v.z + i)};
}

void describeSurfacesKernel(const ShadingContext& context, const FragmentBatch& batch,
                            SurfaceArrays& surfaces)
{
  const bool isFlat = context.placed->instance->style.frequency == ShadingFrequency::kFlat;
  const auto count = static_cast<std::size_t>(batch.count);
  for (std::size_t i = 0; i < count; i += hn::Lanes(D())) {
    FragmentLanes<BatchLanes> lanes(context, batch, BatchLanes(i));
    lanes.setWeights(batch.weight[0] + i, batch.weight[1] + i, batch.weight[2] + i);
    const Lanes3 color = lanes.colored() ? lanes.pixelColor() : set(Vec3f{0, 0, 0});
    const Surface surface =
        lanes.surface(lanes.pixelPosition(), isFlat ? lanes.faceNormal() : lanes.pixelNormal(),
                      lanes.colored() ? &color : nullptr);
    store(surface.position, surfaces.position, i);
    store(lanes.localPosition(), surfaces.modelPosition, i);
    store(surface.normal, surfaces.normal, i);
    store(surface.ambient, surfaces.ambient, i);
    store(surface.diffuse, surfaces.diffuse, i);
    store(surface.specular, surfaces.specular, i);
  }
}

void lightSurfacesKernel(const ShadingContext& context, const SurfaceFragments& fragments,
                         FragmentVectors& colors)
{
  const Lighting lighting(context);
  const float power = context.placed->instance->material.specularPower;
  const auto count = static_cast<std::size_t>(fragments.count);
  for (std::size_t i = 0; i < count; i += hn::Lanes(D())) {
    const Surface surface = {load(fragments.position, i), load(fragments.normal, i),
                             load(fragments.ambient, i),  load(fragments.diffuse, i),
                             load(fragments.specular, i), power};
    store(lighting.light(surface), colors, i);
  }
}

void arriveAtSurfacesKernel(const ShadingContext& context, std::size_t light,
                            const SurfaceFragments& fragments, FragmentVectors& towards,
                            float* falls)
{
  const auto count = static_cast<std::size_t>(fragments.count);
  for (std::size_t i = 0; i < count; i += hn::Lanes(D())) {
    const Arrival at = arrive(context.scene->lights[light], load(fragments.position, i));
    store(at.toward, towards, i);
    hn::StoreU(at.fall, D(), falls + i);
  }
}

void outlineSurfacesKernel(const ShadingContext& context, const SurfaceFragments& fragments,
                           FragmentVectors& colors)
{
  const Lighting lighting(context);
  const Style& style = context.placed->instance->style;
  const auto count = static_cast<std::size_t>(fragments.count);
  for (std::size_t i = 0; i < count; i += hn::Lanes(D())) {
    const Lanes3 v = lighting.towardEye(load(fragments.position, i));
    const M isOutline =
        hn::Lt(hn::Abs(dot(load(fragments.normal, i), v)), set(style.outlineThreshold));
    store(choose(isOutline, set(style.outlineColor), load(colors, i)), colors, i);
  }
}

}  // namespace limn::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
