// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SceneFromRenderer_h
#define SceneFromRenderer_h

#include "Rendering/Scene.h"

#include <vector>

class vtkMatrix4x4;
class vtkRenderer;

namespace limn::bridge
{

Mat4d toMat4(vtkMatrix4x4* matrix);

/// The active camera, for the renderer's viewport of the current tile.
Camera cameraOf(vtkRenderer* renderer);

/// The lights that are switched on and reach something.
std::vector<Light> lightsOf(vtkRenderer* renderer);

/// Whether no light of the renderer is switched on: VTK then draws its surfaces unlit.
bool isUnlit(vtkRenderer* renderer);

/// I_a of the chapter's reflection models.
Vec3f ambientLightOf(vtkRenderer* renderer);

} // namespace limn::bridge

#endif
