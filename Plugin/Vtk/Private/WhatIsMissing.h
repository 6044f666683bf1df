// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef WhatIsMissing_h
#define WhatIsMissing_h

#include <string>
#include <vector>

class vtkActor;
class vtkLimnPolyDataMapper;
class vtkPolyData;
class vtkRenderer;

namespace limn::bridge
{

/// What an actor asks for that Limn cannot draw yet.
struct Missing
{
  std::string feature; ///< "wireframes", ...
  bool surfaceIsDrawn; ///< without the feature the surface still is what the user expects
};

/// Empty if Limn draws all of it. Requires: the mapper's input is up to date.
std::vector<Missing> whatIsMissing(
  vtkActor* actor, vtkLimnPolyDataMapper* mapper, vtkPolyData* input);

} // namespace limn::bridge

#endif
