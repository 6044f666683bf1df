// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ApplyTextures.h"

#include "LoadMesh.h"
#include "Messages.h"
#include "UserError.h"

#include "vtkLimnProperty.h"

#include <vtkActor.h>
#include <vtkImageData.h>
#include <vtkImageReader2.h>
#include <vtkImageReader2Factory.h>
#include <vtkPointData.h>

#include <filesystem>

namespace limn::viewer
{
namespace
{

vtkSmartPointer<vtkImageData> readImage(const std::string& file)
{
  if (!std::filesystem::exists(file))
  {
    throw UserError(file + " is not there");
  }
  const auto reader = vtkSmartPointer<vtkImageReader2>::Take(
    vtkImageReader2Factory::CreateImageReader2(file.c_str()));
  throwCollectedErrors(file);
  if (!reader)
  {
    throw UserError(file + " is not an image that limn reads; save it as PNG, JPEG, TIFF, BMP, PNM "
                           "or HDR");
  }
  reader->SetFileName(file.c_str());
  reader->Update();
  throwCollectedErrors(file);
  vtkImageData* const image = reader->GetOutput();
  if (image->GetNumberOfPoints() == 0 || !image->GetPointData()->GetScalars())
  {
    throw UserError(file + " is an image without pixels");
  }
  return image;
}

int wrapOf(TextureWrap wrap)
{
  switch (wrap)
  {
    case TextureWrap::Mirror:
      return vtkTexture::MirroredRepeat;
    case TextureWrap::Clamp:
      return vtkTexture::ClampToEdge;
    case TextureWrap::Border:
      return vtkTexture::ClampToBorder;
    case TextureWrap::Repeat:
      break;
  }
  return vtkTexture::Repeat;
}

vtkSmartPointer<vtkTexture> loadTexture(const TextureSettings& settings, const std::string& file)
{
  if (file.empty())
  {
    return nullptr;
  }
  const TextureFilter filter = settings.filter.value_or(TextureFilter::Trilinear);
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(readImage(file));
  // An image is a colour as it stands, whatever its type.
  texture->SetColorModeToDirectScalars();
  texture->SetWrap(wrapOf(settings.wrap.value_or(TextureWrap::Repeat)));
  texture->SetInterpolate(filter != TextureFilter::Nearest);
  texture->SetMipmap(filter == TextureFilter::Trilinear);
  texture->SetMaximumAnisotropicFiltering(static_cast<float>(settings.anisotropy.value_or(1)));
  return texture;
}

vtkSmartPointer<vtkTexture> loadPicture(const std::string& file)
{
  if (file.empty())
  {
    return nullptr;
  }
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(readImage(file));
  texture->SetColorModeToDirectScalars();
  return texture;
}

int roleOf(TextureRole role)
{
  return role == TextureRole::Shaded ? vtkLimnProperty::TEXTURE_SHADED
                                     : vtkLimnProperty::TEXTURE_SURFACE;
}

int modeOf(TextureMode mode)
{
  switch (mode)
  {
    case TextureMode::Replace:
      return vtkLimnProperty::TEXTURE_REPLACE;
    case TextureMode::Decal:
      return vtkLimnProperty::TEXTURE_DECAL;
    case TextureMode::Add:
      return vtkLimnProperty::TEXTURE_ADD;
    case TextureMode::Modulate:
      break;
  }
  return vtkLimnProperty::TEXTURE_MODULATE;
}

int proceduralOf(Procedural procedural)
{
  switch (procedural)
  {
    case Procedural::Checker:
      return vtkLimnProperty::PROCEDURAL_CHECKER;
    case Procedural::Wood:
      return vtkLimnProperty::PROCEDURAL_WOOD;
    case Procedural::Marble:
      return vtkLimnProperty::PROCEDURAL_MARBLE;
    case Procedural::None:
      break;
  }
  return vtkLimnProperty::PROCEDURAL_NONE;
}

/// Wood and marble in their own colours and with some noise, the checker in black and white.
void applyProcedural(const TextureSettings& settings, vtkLimnProperty& property)
{
  property.SetProceduralTexture(proceduralOf(settings.procedural));
  property.SetProceduralScale(settings.proceduralScale.value_or(1));
  if (settings.procedural == Procedural::Wood)
  {
    property.SetProceduralColorA(0.35, 0.2, 0.1);
    property.SetProceduralColorB(0.75, 0.5, 0.28);
    property.SetProceduralTurbulence(0.4);
  }
  if (settings.procedural == Procedural::Marble)
  {
    property.SetProceduralColorA(0.35, 0.35, 0.42);
    property.SetProceduralColorB(0.97, 0.96, 0.93);
    property.SetProceduralTurbulence(0.9);
  }
}

} // namespace

Textures loadTextures(const TextureSettings& settings, const std::vector<Mesh>& meshes)
{
  for (const Mesh& mesh : meshes)
  {
    if (settings.hasImage() && !mesh.surface->GetPointData()->GetTCoords())
    {
      throw UserError(mesh.file + " has no texture coordinates, which an image needs; give a mesh "
                                  "that has them, or use --procedural");
    }
  }
  return { loadTexture(settings, settings.image), loadTexture(settings, settings.bump),
    loadTexture(settings, settings.normalMap), loadTexture(settings, settings.lightmap) };
}

TonePictures loadTonePictures(const MaterialSettings& settings)
{
  return { loadPicture(settings.toonRamp), loadPicture(settings.matCap) };
}

void applyTextures(const TextureSettings& settings, const Textures& textures, vtkActor& actor,
  vtkLimnProperty& property)
{
  actor.SetTexture(textures.image);
  property.SetBumpTexture(textures.bump);
  property.SetBumpScale(settings.bumpScale.value_or(1));
  if (textures.normalMap)
  {
    property.SetNormalTexture(textures.normalMap);
  }
  property.SetLightmapTexture(textures.lightmap);
  property.SetTextureRole(roleOf(settings.role.value_or(TextureRole::Surface)));
  property.SetTextureMode(modeOf(settings.mode.value_or(TextureMode::Modulate)));
  applyProcedural(settings, property);
}

} // namespace limn::viewer
