// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef StyleFromProperty_h
#define StyleFromProperty_h

#include "SurfaceMesh.h"

#include "Rendering/Scene.h"

class vtkLimnProperty;
class vtkProperty;

namespace limn::bridge
{

Material materialOf(vtkProperty* property);

/// How the property wants `mesh` shaded; the rules of VTK's shaders unless it is a vtkLimnProperty
/// that chooses something else.
Style styleOf(vtkProperty* property, const SurfaceMesh& mesh);

/// Of vtkLimnProperty::StrokeUnits.
double pixelsPerUnit(int unit, double pixelsPerInch);
/// Its HatchSpacing, bounded to what Hatching::spacing may be. styleOf() has it for 72 pixels an
/// inch.
double hatchSpacingOf(vtkLimnProperty* property, double pixelsPerInch);

/// Fails if the property asks for an outline by image that is too wide: styleOf() leaves that out.
Status checkOutlineWidth(vtkProperty* property);

/// Whether the property asks for an inverted hull that can be seen.
bool hasHull(vtkProperty* property);

/// How it wants that drawn.
Style hullStyleOf(vtkProperty* property);

/// Whether styleOf() is to shade by the data's normals of points, if there are any.
bool readsPointNormals(vtkProperty* property);

/// What styleOf() and the hull will read that is not in the data.
SurfaceNeeds needsOf(vtkProperty* property);

} // namespace limn::bridge

#endif
