// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Surface_h
#define Surface_h

#include "SurfaceLines.h"
#include "SurfaceTextures.h"
#include "WhatIsMissing.h"

#include "Rendering/Mesh/VertexNormals.h"
#include "Rendering/Scene.h"

#include <memory>
#include <vector>

class vtkActor;
class vtkLimnPolyDataMapper;
class vtkRenderer;

namespace limn::bridge
{

class Complaints;

/// One thing to draw: a mapper's surface, as an actor wants it to look, at a place.
struct Surface
{
  vtkActor* actor;
  vtkLimnPolyDataMapper* mapper;
  Mat4d modelToWorld;
  std::vector<Missing> missing = {}; ///< found when the surface was collected
  bool isTranslucent = false;        ///< of the translucent pass
};

/// At the actor's own place.
Surface surfaceOf(vtkActor* actor, vtkLimnPolyDataMapper* mapper, bool isTranslucent);

enum class Assemblies
{
  kLeaveOut,
  kTraverse, ///< not while an assembly of the renderer is rendering: that changes what it traverses
};

struct CollectedSurfaces
{
  std::vector<Surface> surfaces; ///< in drawing order, their input brought up to date
  /// No other visible prop of the renderer may draw surfaces of Limn, as followers do.
  bool areAll = false;
};

/// The surfaces of the renderer's visible actors that Limn draws.
CollectedSurfaces surfacesOf(vtkRenderer* renderer, Assemblies assemblies);

/// Normals and ids of cells that instances borrow while another actor of the same mapper may have
/// other ones made.
using FrameNormals = std::vector<std::shared_ptr<const void>>;

/// The surface as an instance of a scene, borrowing from the mapper, from `normals`, to which this
/// adds, and from `textures`, without textures if that is nullptr. False, with a message, if there
/// is nothing to draw or something is wrong with the mesh. With `needsTriangles` the instance has
/// its MeshView's triangles, whatever draws it.
bool describe(const Surface& surface, Instance& instance, FrameNormals& normals,
  FrameTextures* textures, Complaints& complaints, bool needsTriangles = false);

/// Gives the instance, as describe() made it, the lines that its property asks for. False, with a
/// message, if something is wrong with them.
bool describeLines(
  const Surface& surface, const LineView& view, Instance& instance, FrameLines& lines);

/// Says, once, if no face of the surface has an area: that nothing is drawn of it, or only the
/// instance's `lines`.
void complainOfFlatness(const Surface& surface, Span<const LineSet> lines, Complaints& complaints);

/// The inverted hull of the surface as an instance of its own, borrowing from the mapper. False if
/// its property asks for none.
/// Requires: describe() of the surface was the last of its mapper.
bool describeHull(const Surface& surface, Instance& hull);

} // namespace limn::bridge

#endif
