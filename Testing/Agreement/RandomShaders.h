// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Power.h"
#include "Rendering/Mesh/VertexShader.h"
#include "Rendering/SurfaceShader.h"
#include "Testing/Agreement/RandomScene.h"

#include <cmath>
#include <limits>

namespace limn::testing {

/// Reads all that a surface shader is given and asks for all that it may ask for.
class RandomSurfaceShader final : public SurfaceShader {
 public:
  explicit RandomSurfaceShader(Random& random)
      : tint_(random.color()),
        stripes_(static_cast<float>(random.between(1, 20))),
        dent_(random.chance(2) ? static_cast<float>(random.between(0, 1)) : 0.0f),
        hasHoles_(random.chance(4))
  {
  }

  void shade(const SurfaceFragments& fragments, const SurfaceLighting& lighting,
             FragmentVectors& colors) const override
  {
    FragmentVectors normal, diffuse;
    for (int i = 0; i < fragments.count; ++i) {
      const Vec3f p = fragments.modelPosition[i], n = fragments.normal[i];
      const float height = (p.x + p.y * 2.0f) * stripes_;
      const float stripe = height - std::floor(height);
      normal.set(i, normalized(n + Vec3f{dent_, -dent_, 0.0f} * stripe));
      diffuse.set(i, fragments.diffuse[i] * stripe + tint_ * (1.0f - stripe));
    }
    SurfaceFragments changed = fragments;
    changed.normal = normal;
    changed.diffuse = diffuse;
    lighting.light(changed, colors);
    addLights(fragments, lighting, colors);
    for (int i = 0; i < fragments.count; ++i)
      colors.set(i, colors[i] + traces(fragments, lighting, i));
  }

 private:
  static void addLights(const SurfaceFragments& fragments, const SurfaceLighting& lighting,
                        FragmentVectors& colors)
  {
    for (std::size_t l = 0; l < lighting.lights.size(); ++l) {
      FragmentVectors towards;
      float falls[FragmentVectors::kCapacity];
      lighting.arrive(l, fragments, towards, falls);
      for (int i = 0; i < fragments.count; ++i) {
        const float facing = dot(towards[i], fragments.normal[i]) * falls[i];
        colors.set(i, colors[i] + lighting.lights[l].color * (facing * facing * 0.1f));
      }
    }
  }
  /// Something of everything else.
  Vec3f traces(const SurfaceFragments& fragments, const SurfaceLighting& lighting, int i) const
  {
    const auto bits = static_cast<std::uint32_t>(fragments.pixelX[i] * 3 + fragments.pixelY[i]) +
                      fragments.cell[i] * 5 + lighting.instance.id;
    const Vec3f v =
        lighting.scene.camera.parallel ? Vec3f{0, 0, 1} : normalized(-fragments.position[i]);
    const float rim = power(1.0f - std::fabs(dot(v, fragments.normal[i])), 3.0f);
    const float number = static_cast<float>(bits % 7) * 0.02f;
    if (hasHoles_ && bits % 5 == 0) return {std::numeric_limits<float>::quiet_NaN(), -1e30f, rim};
    const float uv =
        fragments.u == nullptr ? 0.0f : fragments.u[i] * 0.03f + fragments.v[i] * 0.05f;
    return Vec3f{rim, number, uv} + (fragments.ambient[i] + fragments.specular[i]) * 0.2f;
  }

  Vec3f tint_;
  float stripes_, dent_;
  bool hasHoles_;
};

/// Twists about an axis through a point, and may throw a vertex out of the world.
class RandomVertexShader final : public VertexShader {
 public:
  RandomVertexShader(Random& random, Vec3d centre)
      : centre_(centre),
        twist_(random.between(-1, 1)),
        squash_(random.between(0.3, 1)),
        movesNormals_(random.chance(2)),
        losesVertices_(random.chance(4))
  {
  }

  bool movesNormals() const override { return movesNormals_; }
  void move(VertexBatch& vertices) const override
  {
    for (int i = 0; i < vertices.count; ++i) {
      const double x = vertices.x[i] - centre_.x, y = vertices.y[i] - centre_.y;
      // Not an angle but its tangent: no libm.
      const double t = twist_ * (vertices.z[i] - centre_.z);
      const double scale = squash_ / std::sqrt(1 + t * t);
      vertices.x[i] = centre_.x + (x - y * t) * scale;
      vertices.y[i] = centre_.y + (y + x * t) * scale;
      const std::uint32_t number = vertices.first + static_cast<std::uint32_t>(i);
      if (losesVertices_ && number % 97 == 13)
        vertices.z[i] = std::numeric_limits<double>::quiet_NaN();
      if (!movesNormals_ || !vertices.hasNormals) continue;
      const auto turn = static_cast<float>(t);
      const float nx = vertices.normalX[i], ny = vertices.normalY[i];
      vertices.normalX[i] = nx - ny * turn;
      vertices.normalY[i] = ny + nx * turn;
    }
  }

 private:
  Vec3d centre_;
  double twist_, squash_;
  bool movesNormals_, losesVertices_;
};

}  // namespace limn::testing
