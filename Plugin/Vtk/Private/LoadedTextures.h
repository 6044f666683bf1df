// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LoadedTextures_h
#define LoadedTextures_h

#include "Rendering/Texture/TextureImage.h"

class vtkTexture;

namespace limn::bridge
{

/// A vtkTexture's image as Limn samples it.
struct LoadedTexture
{
  TextureImage image;      ///< empty if it cannot be had
  bool hasAlpha = false;   ///< four components; else alpha is 1, of the border too
  bool isOpaque = true;    ///< no texel lets anything through
  bool isFiltered = false; ///< by VTK's rules: with a mip chain
};

/// The texture's input, brought up to date and mapped through its lookup table as VTK's OpenGL
/// does: three or four bytes are colours, as are, where ColorMode says so, unsigned shorts and
/// floats; all else is mapped. UseSRGBColorSpace decodes bytes. Loaded anew when the texture, its
/// input or its table was modified. Why an image cannot be had is said once, as an error of the
/// texture. The result lives as long as the texture.
const LoadedTexture& loadedTextureOf(vtkTexture* texture);

} // namespace limn::bridge

#endif
