// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Scene.h"
#include "Rendering/Vertex/ViewSpace.h"

#include <cstdint>
#include <vector>

namespace limn::reference {

/// A visible point of a triangle: which, and how the corners mix there (perspective-correct).
struct SurfacePoint {
  std::uint32_t triangle;
  float weight[3];
  float rightWeight[3], aboveWeight[3];  ///< a pixel to the right, and above, in its plane
  bool backFacing;                       ///< seen from the inside; normals are turned to the eye
  int pixelX, pixelY;
};

/// The alpha of a visible point by the instance's opacity, colours and textures, 0 to 1.
float alphaAt(const Scene& scene, const Instance& instance, const InstanceTransform& transform,
              Vec3d meshOrigin, const SurfacePoint& point);

/// The normal of a triangle's plane in view space, turned to the eye with its face.
Vec3f planeNormalAt(const Scene& scene, const Instance& instance,
                    const InstanceTransform& transform, Vec3d meshOrigin,
                    const SurfacePoint& point);

/// The normal of a visible point as FrameView::normal has it.
Vec3f normalAt(const Scene& scene, const Instance& instance, const InstanceTransform& transform,
               Vec3d meshOrigin, const SurfacePoint& point);

/// The colour of a visible point by the instance's style, before clamping and rounding.
Vec3f shade(const Scene& scene, const Instance& instance, const InstanceTransform& transform,
            Vec3d meshOrigin, const std::vector<ViewLight>& lights, const SurfacePoint& point);

}  // namespace limn::reference
