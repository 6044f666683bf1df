// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TextureSettings_h
#define TextureSettings_h

#include "Rendering/Texture/TextureLayer.h"

#include <string>
#include <vector>

class vtkActor;
class vtkLimnPolyDataMapper;
class vtkLimnProperty;
class vtkTexture;

namespace limn::bridge
{

struct LoadedTexture;

/// Whether the actor or its property asks for any texture.
bool hasTextures(vtkActor* actor);

/// Those that VTK multiplies into the lit colour, in its order. Of the first the blending mode does
/// not count; later ones without a mode are left out, as VTK does.
std::vector<vtkTexture*> ordinaryTexturesOf(vtkActor* actor);

/// kNone for the modes that leave the textures before it as they are.
TextureJoin joinOf(vtkTexture* texture);

TextureSampler samplerOf(vtkTexture* texture, const LoadedTexture& loaded);

/// The 4 x 4 matrix, by rows, that moves the actor's texture coordinates; nullptr if none does.
const double* textureMatrixOf(vtkActor* actor);

/// Requires: the matrix is affine.
void setTransform(const double* matrix, TextureLayer& layer);

/// Of vtkProperty's own textures; as VTK if `property` is nullptr.
TextureRole roleOf(vtkLimnProperty* property);
TextureMode modeOf(vtkLimnProperty* property);

ProceduralTexture proceduralOf(vtkLimnProperty* property);

/// What of an actor's textures Limn cannot draw yet, in words; empty if nothing.
std::vector<std::string> missingTextures(vtkActor* actor, vtkLimnPolyDataMapper* mapper);

} // namespace limn::bridge

#endif
