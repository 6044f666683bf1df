// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef limn_viewer_ApplyTextures_h
#define limn_viewer_ApplyTextures_h

#include "RenderSettings.h" // for TextureSettings and MaterialSettings

#include <vtkSmartPointer.h> // for the images
#include <vtkTexture.h>      // for the images

#include <vector> // for the meshes

class vtkActor;
class vtkLimnProperty;

namespace limn::viewer
{

struct Mesh;

/// The images that the settings name, read once for all meshes.
struct Textures
{
  vtkSmartPointer<vtkTexture> image, bump, normalMap, lightmap; ///< nullptr: none
};

/// Throws UserError for a file that is missing or not an image, and for a mesh without texture
/// coordinates if there is an image.
Textures loadTextures(const TextureSettings& settings, const std::vector<Mesh>& meshes);

/// Of the tones that are pictures.
struct TonePictures
{
  vtkSmartPointer<vtkTexture> ramp, matCap; ///< nullptr: none
};

/// Throws UserError for a file that is missing or not an image.
TonePictures loadTonePictures(const MaterialSettings& settings);

void applyTextures(const TextureSettings& settings, const Textures& textures, vtkActor& actor,
  vtkLimnProperty& property);

} // namespace limn::viewer

#endif
