// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Vertex/LightRays.h"

#include "Rendering/Base/Power.h"

namespace limn {

LightRays lightRays(const Light& light, const Camera& camera)
{
  LightRays rays = {false, light.position, false, {0, 0, 0}, 0};
  if (light.kind == LightKind::kHeadlight) {
    const auto& row = camera.worldToView.m[2];
    rays.isParallel = true;
    rays.source = normalized(Vec3d{row[0], row[1], row[2]});
  } else if (light.kind == LightKind::kDirectional) {
    rays.isParallel = true;
    rays.source = normalized(-light.direction);
  } else if (light.kind == LightKind::kSpot) {
    rays.isCone = true;
    rays.axis = normalized(light.direction);
    rays.cosine = cosineOfDegrees(static_cast<double>(light.coneDegrees));
  }
  return rays;
}

bool operator==(const LightRays& a, const LightRays& b)
{
  return a.isParallel == b.isParallel && a.source == b.source && a.isCone == b.isCone &&
         a.axis == b.axis && a.cosine == b.cosine;
}

}  // namespace limn
