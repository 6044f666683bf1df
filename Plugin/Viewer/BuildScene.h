// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef limn_viewer_BuildScene_h
#define limn_viewer_BuildScene_h

#include "ApplyTextures.h"  // for TonePictures
#include "LoadMesh.h"       // for Mesh
#include "RenderSettings.h" // for SceneSettings

#include <vector> // for several meshes

class vtkLimnProperty;
class vtkRenderer;

namespace limn::viewer
{

/// Puts the meshes, their material, the lights, the background and the camera into `renderer`,
/// which must be in a window of the final size. The clipping range of the camera is set.
/// Throws UserError for a mesh without faces and an array that no mesh has.
void buildScene(
  const SceneSettings& settings, const std::vector<Mesh>& meshes, vtkRenderer& renderer);

/// Points the renderer's camera at the meshes as the settings say and sets its clipping range.
void pointCamera(
  const SceneSettings& settings, const std::vector<Mesh>& meshes, vtkRenderer& renderer);

/// Makes the property of a mesh look as the settings say: in the meaning of the chapter's
/// equations, or in a style.
void applyLook(const SceneSettings& settings, const Mesh& mesh, const TonePictures& pictures,
  vtkLimnProperty& property);

/// The user's, or the style's.
void setBackground(const SceneSettings& settings, vtkRenderer& renderer);

} // namespace limn::viewer

#endif
