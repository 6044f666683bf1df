// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Mat4.h"
#include "Rendering/Base/SamplePositions.h"
#include "Rendering/Mesh/LocalPosition.h"
#include "Rendering/Scene.h"
#include "Rendering/Vertex/ScreenVertex.h"

namespace limn {

/// What a mesh must tell before its vertices can be placed.
struct LocalFrame {
  Vec3d origin;
  Vec3f low, high;   ///< box of the used vertices
  bool hasLowParts;  ///< some position needs its low part
};

/// The way of one instance's vertices to the screen, fixed for a frame. Matrices are composed in
/// double, relative to the mesh's origin, and rounded once.
struct InstanceTransform {
  Mat4d toClip;  ///< local to clip space
  Mat4f toClipFloat;
  Mat4d toView;  ///< local to view space
  Mat4f toViewFloat;
  Mat4f normalToView;             ///< upper left 3x3; outward normals stay outward, length changes
  double subpixelsX, subpixelsY;  ///< screen = ndc * subpixels + subpixels
  /// Vertices are transformed in double: some need their low part, or float arithmetic could miss
  /// the screen position by more than 1/32 pixel somewhere in the view.
  bool precise;
  bool hasLowParts;  ///< positions are brought to view space in double too
  /// A power of two that makes very large and very small meshes' boxes about 1 in size, or 1: edges
  /// times it have cross products whose square a float holds, whatever the mesh's unit.
  float edgeScale;
  bool mirrored;  ///< counter-clockwise triangles look clockwise from outside
};

InstanceTransform makeInstanceTransform(const Camera& camera, const Mat4d& modelToWorld,
                                        const LocalFrame& frame, int width, int height);

/// Homogeneous coordinates before the divide. Floats of the fast path fit exactly.
struct ClipPoint {
  double x, y, z, w;
};
ClipPoint clipPoint(const InstanceTransform& transform, LocalPosition p);

/// Where a point is lit: in float, unless the mesh has low parts.
Vec3f viewPosition(const InstanceTransform& transform, LocalPosition p);

/// Divide, viewport and snap; in float or double as the transform says.
ScreenVertex screenVertex(const InstanceTransform& transform, ClipPoint clip);

/// A light in view space, ready to be evaluated in float. Of a rectangle's or sphere's samples each
/// is one: of kRectangle, or kPoint.
struct ViewLight {
  LightKind kind;
  Vec3f position;     ///< of all but headlight and directional
  Vec3f towardLight;  ///< unit; headlight and directional: constant; else against its axis
  Vec3f color;
  Vec3f attenuation;
  float coneCosine;
  float softScale;  ///< spot: 1 / (cosine where its soft band ends - coneCosine); 0: a hard edge
  float exponent;

  bool positional() const
  {
    return kind != LightKind::kHeadlight && kind != LightKind::kDirectional;
  }
};

}  // namespace limn
