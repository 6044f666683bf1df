// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef limn_viewer_ColorByArray_h
#define limn_viewer_ColorByArray_h

#include "LoadMesh.h"       // for Mesh
#include "RenderSettings.h" // for SceneSettings

#include <vector> // for several meshes

class vtkDataArray;
class vtkMapper;

namespace limn::viewer
{

/// Makes `mapper`, which draws `mesh`, colour it by the array that the settings name, with one
/// range for all meshes; else by the mesh's own colours if the settings name no colour; else not at
/// all. Throws UserError if `mesh` has no numeric array of that name; the error lists what it has.
void chooseColors(const SceneSettings& settings, const std::vector<Mesh>& meshes, const Mesh& mesh,
  vtkMapper& mapper);

/// Active scalars are colours, not values to be mapped, if they are bytes with three or four
/// components. False for none.
bool areColors(vtkDataArray* scalars);

} // namespace limn::viewer

#endif
