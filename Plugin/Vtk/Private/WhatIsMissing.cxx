// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "WhatIsMissing.h"

#include "TextureSettings.h"

#include "vtkLimnPolyDataMapper.h"

#include "vtkActor.h"
#include "vtkObjectFactory.h"
#include "vtkPlaneCollection.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkShaderProperty.h"

#include <utility>

namespace limn::bridge
{
namespace
{

bool isShifted(vtkLimnPolyDataMapper* mapper)
{
  switch (vtkMapper::GetResolveCoincidentTopology())
  {
    case VTK_RESOLVE_SHIFT_ZBUFFER:
      return true;
    case VTK_RESOLVE_POLYGON_OFFSET:
    {
      // VTK 9.1 ignores the factor.
      double factor = 0;
      double units = 0;
      mapper->GetCoincidentTopologyPolygonOffsetParameters(factor, units);
      return units != 0;
    }
    default:
      return false;
  }
}

bool hasShaderCode(vtkActor* actor)
{
  // Without a backend that makes one, only a vtkLimnActor has a shader property.
  if (!actor->IsA("vtkLimnActor") && !vtkObjectFactory::HasOverrideAny("vtkShaderProperty"))
  {
    return false;
  }
  vtkShaderProperty* const shaders = actor->GetShaderProperty();
  return shaders &&
         (shaders->GetNumberOfShaderReplacements() > 0 || shaders->HasVertexShaderCode() ||
           shaders->HasFragmentShaderCode() || shaders->HasGeometryShaderCode());
}

/// VTK blends by opacity in the opaque pass, too.
bool isForcedOpaque(vtkActor* actor, vtkLimnPolyDataMapper* mapper)
{
  return actor->GetForceOpaque() &&
         (actor->GetProperty()->GetOpacity() < 1 || !mapper->HasOpaqueGeometry());
}

/// What of VTK's physically based materials goes beyond metals and roughness.
bool isBeyondMetals(vtkProperty* property)
{
  return property->GetInterpolation() == VTK_PBR &&
         (property->GetCoatStrength() > 0 || property->GetAnisotropy() > 0);
}

} // namespace

std::vector<Missing> whatIsMissing(
  vtkActor* actor, vtkLimnPolyDataMapper* mapper, vtkPolyData* input)
{
  vtkProperty* const property = actor->GetProperty();
  const bool hasPlanes =
    mapper->GetClippingPlanes() && mapper->GetClippingPlanes()->GetNumberOfItems() > 0;
  const struct
  {
    bool asked;
    const char* feature;
    bool surfaceIsDrawn;
  } features[] = {
    { isForcedOpaque(actor, mapper), "blending in the opaque pass", true },
    { property->GetRepresentation() == VTK_WIREFRAME, "wireframes", false },
    { property->GetRepresentation() == VTK_POINTS, "surfaces as points", false },
    { hasPlanes, "clipping planes", false },
    { input->GetNumberOfVerts() > 0, "vertex cells", true },
    { input->GetNumberOfLines() > 0, "line cells", true },
    { property->GetEdgeVisibility() != 0, "edges on surfaces", true },
    { actor->GetBackfaceProperty() != nullptr, "back face properties", true },
    { isBeyondMetals(property), "coats and anisotropy of materials", true },
    { isShifted(mapper), "shifts of coincident topology", true },
    { mapper->GetSelection() != nullptr, "marked selections", true },
    { hasShaderCode(actor), "shader replacements", true },
  };
  std::vector<Missing> missing;
  for (const auto& feature : features)
  {
    if (feature.asked)
    {
      missing.push_back({ feature.feature, feature.surfaceIsDrawn });
    }
  }
  for (std::string& feature : missingTextures(actor, mapper))
  {
    missing.push_back({ std::move(feature), true });
  }
  return missing;
}

} // namespace limn::bridge
