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

/// What fragments [i, i + Lanes) of `surfaces` are, as `shader` has them there.
template <class Lanes>
HWY_INLINE void describe(Shader<Lanes>& shader, const CornerWeights& weights, bool hasUv,
                         SurfaceArrays& surfaces, std::size_t i)
{
  const Surface surface = shader.surfaceAt(weights);
  store(surface.position, surfaces.position, i);
  store(shader.lanes().localPosition(), surfaces.modelPosition, i);
  store(surface.normal, surfaces.normal, i);
  store(surface.ambient, surfaces.ambient, i);
  store(surface.diffuse, surfaces.diffuse, i);
  store(surface.specular, surfaces.specular, i);
  if (!hasUv) return;
  const Lanes2 uv = shader.lanes().pixelUv();
  hn::Store(uv.x, D(), surfaces.u + i);
  hn::Store(uv.y, D(), surfaces.v + i);
}

bool hasUv(const ShadingContext& context)
{
  return !context.placed->instance->attributes.uv.empty();
}

void describeSurfacesKernel(const ShadingContext& context, const FragmentBatch& batch,
                            SurfaceArrays& surfaces)
{
  const auto count = static_cast<std::size_t>(batch.count);
  const Lighting lighting(context);
  for (std::size_t i = 0; i < count; i += hn::Lanes(D())) {
    Shader<BatchLanes> shader(lighting, context, batch, BatchLanes(i));
    describe(shader, weightsOf(batch, i), hasUv(context), surfaces, i);
  }
}

void finishSurfacesKernel(const ShadingContext& context, const SurfaceArrays& surfaces,
                          FragmentBatch& batch)
{
  const auto count = static_cast<std::size_t>(batch.count);
  const Lighting lighting(context);
  for (std::size_t i = 0; i < count; i += hn::Lanes(D())) {
    Shader<BatchLanes> shader(lighting, context, batch, BatchLanes(i));
    store(shader.finishAt(weightsOf(batch, i), load(surfaces.diffuse, i), load(batch.color, i)),
          batch.color, i);
  }
}

/// Shades fragments [first, first + count) of a triangle, of whose cell `surfaces` knows.
void runOverTriangle(const ShadingContext& context, const TileRectangle& pixels,
                     Shader<TriangleLanes>& shader, std::size_t first, std::size_t count,
                     SurfaceArrays& surfaces, TriangleFragments& fragments)
{
  const hn::ScalableTag<std::int32_t> di;
  for (std::size_t i = 0; i < count; i += hn::Lanes(di)) {
    describe(shader, fragments.weightsAt(first + i), hasUv(context), surfaces, i);
    const auto pixel = hn::Load(di, fragments.pixel + first + i);
    const auto column = hn::And(pixel, hn::Set(di, kTileSide - 1));
    hn::Store(hn::Add(column, hn::Set(di, pixels.x0)), di, surfaces.pixelX + i);
    hn::Store(hn::Add(hn::ShiftRight<6>(pixel), hn::Set(di, pixels.y0)), di, surfaces.pixelY + i);
  }
  FragmentVectors colors;
  callSurfaceShader(context, static_cast<int>(count), surfaces, colors);
  for (std::size_t i = 0; i < count; i += hn::Lanes(D())) {
    const Lanes3 color =
        shader.finishAt(fragments.weightsAt(first + i), load(surfaces.diffuse, i), load(colors, i));
    hn::Store(quantized(color), hn::RebindToUnsigned<D>(), fragments.color + first + i);
    fragments.storeRadiance(radianceOf(color), first + i);
  }
}

void runSurfaceShaderKernel(const ShadingContext& context, const TileClusters& clusters,
                            const TileRectangle& pixels, const FragmentList& list,
                            Span<const std::uint32_t> numbers, const FragmentBatch& batch,
                            TileColors& colors)
{
  constexpr std::size_t kMost = FragmentVectors::kCapacity;
  const bool footprint = UvUse(*context.placed->instance).footprint;
  TriangleFragments fragments;
  SurfaceArrays surfaces;
  const Lighting lighting(context);
  for (std::size_t t = 0; t < numbers.size(); ++t) {
    if (batch.needsClip[t] != 0) continue;
    const TriangleWeights weights(batch, t, pixels);
    Shader<TriangleLanes> shader(lighting, context, batch, TriangleLanes(t));
    std::fill_n(surfaces.cell, kMost, cellOf(clusters, batch.owner[t]));
    std::uint16_t run = list.firstRun[numbers[t]];
    while (run != FragmentRun::kNone) {
      const std::uint16_t start = run;
      run = fragments.take(list, run);
      fragments.namePixels(list, start, run);
      weights.weigh(list, start, run, footprint, fragments);
      for (std::size_t first = 0; first < fragments.count; first += kMost)
        runOverTriangle(context, pixels, shader, first, std::min(kMost, fragments.count - first),
                        surfaces, fragments);
      fragments.give(list, start, run, colors.pixel);
      if (colors.hasRadiance) fragments.giveRadiance(list, start, run, colors.pixelRadiance);
    }
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
  const bool fallsOff = context.placed->instance->style.fallOff;
  const auto count = static_cast<std::size_t>(fragments.count);
  for (std::size_t i = 0; i < count; i += hn::Lanes(D())) {
    const Arrival at = arrive(context.scene->lights[light], load(fragments.position, i), fallsOff);
    store(at.toward, towards, i);
    hn::StoreU(at.fall, D(), falls + i);
  }
}

}  // namespace limn::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
