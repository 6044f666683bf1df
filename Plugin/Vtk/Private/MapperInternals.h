// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef MapperInternals_h
#define MapperInternals_h

#include "CellIds.h"
#include "InputBounds.h"
#include "KnownInput.h"
#include "MovedPoints.h"
#include "ReadBack.h"
#include "SurfaceLines.h"
#include "SurfaceMesh.h"
#include "SurfaceTextures.h"

#include "vtkLimnPolyDataMapper.h"

#include <array>

class vtkLimnPolyDataMapper::vtkInternals
{
public:
  limn::bridge::MovedPoints Moved;
  limn::bridge::SurfaceMesh Mesh;
  limn::bridge::SurfaceLines Lines;
  limn::bridge::CellIds Ids;
  limn::bridge::InputBounds InputBounds;
  limn::bridge::KnownInput Input;
  limn::bridge::MapperTextures Textures;
  limn::bridge::LegendSafeBound LegendSafeRange;
  vtkIdType LookedAtBuild = 0; ///< of which geometry what was left out was said
  /// When the normals were modified of which was said that some cannot be used.
  struct
  {
    vtkMTimeType OfPoints = 0;
    vtkMTimeType OfCells = 0;
  } NormalsSaid;
  /// Of a geometry whose faces have no area: whether it was said of actors without lines and of
  /// those with some.
  struct
  {
    vtkIdType Build = 0;
    std::array<bool, 2> IsSaid = {};
  } Flatness;
};

#endif
