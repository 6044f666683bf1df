// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Span.h"
#include "Rendering/Base/Vec.h"
#include "Rendering/Scene.h"
#include "Rendering/Vertex/ViewSpace.h"

#include <cstddef>
#include <cstdint>

namespace limn {

/// A vector for each fragment, an array a component.
struct alignas(64) FragmentVectors {
  static constexpr int kCapacity = 64;

  float x[kCapacity], y[kCapacity], z[kCapacity];

  Vec3f operator[](int i) const { return {x[i], y[i], z[i]}; }
  void set(int i, Vec3f v)
  {
    x[i] = v.x;
    y[i] = v.y;
    z[i] = v.z;
  }
};

/// The same, borrowed. Each array has FragmentVectors::kCapacity elements.
struct FragmentVectorsView {
  const float *x, *y, *z;

  FragmentVectorsView(const float* xs, const float* ys, const float* zs) : x(xs), y(ys), z(zs) {}
  FragmentVectorsView(const FragmentVectors& v) : x(v.x), y(v.y), z(v.z) {}
  Vec3f operator[](int i) const { return {x[i], y[i], z[i]}; }
};

/// Fragments of one instance: visible points of its triangles, one for each triangle that a pixel
/// shows.
struct SurfaceFragments {
  int count;                     ///< 1 to FragmentVectors::kCapacity
  FragmentVectorsView position;  ///< view space: the eye at the origin, looking along -z
  /// Model coordinates, as the mesh has them, to the precision of a float relative to the mesh's
  /// place.
  FragmentVectorsView modelPosition;
  /// Unit, view space, turned to the eye; of the face if flat, else with the bumps of textures.
  FragmentVectorsView normal;
  /// k_a, k_d, k_s: the material's, with the data's colours where there are any, under the textures
  /// of TextureRole::kSurface.
  FragmentVectorsView ambient, diffuse, specular;
  const float *u, *v;                   ///< Attributes::uv; null if the mesh has none
  const std::int32_t *pixelX, *pixelY;  ///< from the frame's lower left corner
  const std::uint32_t* cell;            ///< of the mesh; see Attributes::cells
};

/// What lights the fragments that a shader is given.
class SurfaceLighting {
 public:
  const Scene& scene;
  const Instance& instance;
  Span<const ViewLight> lights;

  /// The built-in model: what the instance's reflection or tone makes of these fragments, lit pixel
  /// by pixel. They may be others than those the shader got: with another normal, say, or other
  /// reflectances. `colors` may not be among their arrays.
  virtual void light(const SurfaceFragments& fragments, FragmentVectors& colors) const = 0;

  /// From where lights[i] comes to each fragment, a unit vector, and by what factor its colour has
  /// fallen off on its way. Of a fragment only the position is read. `falls` has
  /// FragmentVectors::kCapacity elements.
  virtual void arrive(std::size_t i, const SurfaceFragments& fragments, FragmentVectors& towards,
                      float* falls) const = 0;

 protected:
  SurfaceLighting(const Scene& of, const Instance& on, Span<const ViewLight> by)
      : scene(of), instance(on), lights(by)
  {
  }
  ~SurfaceLighting() = default;
  SurfaceLighting(const SurfaceLighting&) = delete;
  void operator=(const SurfaceLighting&) = delete;
};

/// A program for the colour of visible points, in place of the light equation: the fragment shader
/// of a GPU's pipeline. Style::surfaceShader says which instances it serves. It runs once for each
/// pixel and triangle seen in it, whatever the number of samples and Style::frequency. What
/// textures do after the light equation they do to what it gives, and outlines are drawn over that.
class SurfaceShader {
 public:
  virtual ~SurfaceShader() = default;

  /// Sets colors[0] to colors[fragments.count - 1]; 1 is full, and more is bounded when the picture
  /// is done. What is not a number counts as 0.
  ///
  /// Called by several threads at once. How fragments are put together is not defined, nor how
  /// often it is done: the colour of one shall depend on that fragment and on the shader's own
  /// constants only. It may not throw. For the same bytes everywhere keep to + - * /, std::sqrt and
  /// Base/Power.h, and compile with -ffp-contract=off.
  virtual void shade(const SurfaceFragments& fragments, const SurfaceLighting& lighting,
                     FragmentVectors& colors) const = 0;
};

}  // namespace limn
