// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TextureSettings.h"

#include "LoadedTextures.h"

#include "vtkLimnPolyDataMapper.h"
#include "vtkLimnProperty.h"

#include "vtkActor.h"
#include "vtkInformation.h"
#include "vtkMatrix4x4.h"
#include "vtkProperty.h"
#include "vtkTexture.h"
#include "vtkTransform.h"

#include <algorithm>

namespace limn::bridge
{
namespace
{

Vec3f toVec3f(const double* v)
{
  return vec3Cast<float>(Vec3d{ v[0], v[1], v[2] });
}

/// The names that VTK keeps for parts of its materials.
bool isPartOfMaterial(const std::string& name)
{
  static const char* const names[] = { "albedoTex", "normalTex", "materialTex", "brdfTex",
    "emissiveTex", "anisotropyTex", "coatNormalTex", "colortexture" };
  return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

TextureWrap wrapOf(vtkTexture* texture)
{
  switch (texture->GetWrap())
  {
    case vtkTexture::ClampToEdge:
      return TextureWrap::kClamp;
    case vtkTexture::MirroredRepeat:
      return TextureWrap::kMirror;
    case vtkTexture::ClampToBorder:
      return TextureWrap::kBorder;
    default:
      return TextureWrap::kRepeat;
  }
}

bool isProjective(const double* m)
{
  return m[12] != 0 || m[13] != 0;
}

ProceduralKind kindOf(vtkLimnProperty* property)
{
  switch (property->GetProceduralTexture())
  {
    case vtkLimnProperty::PROCEDURAL_WOOD:
      return ProceduralKind::kWood;
    case vtkLimnProperty::PROCEDURAL_MARBLE:
      return ProceduralKind::kMarble;
    default:
      return ProceduralKind::kChecker;
  }
}

/// Blended by alpha, or with holes, where the mode does not use alpha itself.
bool letsThrough(vtkTexture* texture)
{
  const LoadedTexture& loaded = loadedTextureOf(texture);
  const bool hasClearBorder = loaded.hasAlpha && texture->GetWrap() == vtkTexture::ClampToBorder &&
                              texture->GetBorderColor()[3] < 1;
  return !loaded.image.empty() && (!loaded.isOpaque || hasClearBorder);
}

} // namespace

TextureJoin joinOf(vtkTexture* texture)
{
  switch (texture->GetBlendingMode())
  {
    case vtkTexture::VTK_TEXTURE_BLENDING_MODE_REPLACE:
      return TextureJoin::kReplace;
    case vtkTexture::VTK_TEXTURE_BLENDING_MODE_MODULATE:
      return TextureJoin::kModulate;
    case vtkTexture::VTK_TEXTURE_BLENDING_MODE_ADD:
      return TextureJoin::kAdd;
    case vtkTexture::VTK_TEXTURE_BLENDING_MODE_ADD_SIGNED:
      return TextureJoin::kAddSigned;
    case vtkTexture::VTK_TEXTURE_BLENDING_MODE_SUBTRACT:
      return TextureJoin::kSubtract;
    default:
      return TextureJoin::kNone;
  }
}

std::vector<vtkTexture*> ordinaryTexturesOf(vtkActor* actor)
{
  std::vector<vtkTexture*> textures;
  if (vtkTexture* const texture = actor->GetTexture(); texture && !texture->GetCubeMap())
  {
    textures.push_back(texture);
  }
  for (const auto& [name, texture] : actor->GetProperty()->GetAllTextures())
  {
    const bool isSeen = textures.empty() || joinOf(texture) != TextureJoin::kNone;
    if (isSeen && !isPartOfMaterial(name) && !texture->GetCubeMap())
    {
      textures.push_back(texture);
    }
  }
  return textures;
}

bool hasTextures(vtkActor* actor)
{
  vtkProperty* const property = actor->GetProperty();
  vtkLimnProperty* const limn = vtkLimnProperty::SafeDownCast(property);
  return actor->GetTexture() || property->GetNumberOfTextures() > 0 ||
         (limn && (limn->GetProceduralTexture() != vtkLimnProperty::PROCEDURAL_NONE ||
                    limn->GetLightmapTexture() || limn->GetBumpTexture()));
}

TextureSampler samplerOf(vtkTexture* texture, const LoadedTexture& loaded)
{
  TextureSampler sampler;
  sampler.wrapU = sampler.wrapV = wrapOf(texture);
  sampler.filter = loaded.isFiltered           ? TextureFilter::kTrilinear
                   : texture->GetInterpolate() ? TextureFilter::kBilinear
                                               : TextureFilter::kNearest;
  const float most = TextureSampler::kMaxAnisotropy;
  const float anisotropy = texture->GetMaximumAnisotropicFiltering();
  sampler.maxAnisotropy = !(anisotropy > 1) ? 1 : static_cast<int>(std::min(anisotropy, most));
  const float* const border = texture->GetBorderColor();
  sampler.borderColor = { border[0], border[1], border[2], loaded.hasAlpha ? border[3] : 1.0f };
  return sampler;
}

const double* textureMatrixOf(vtkActor* actor)
{
  if (actor->GetTexture() && actor->GetTexture()->GetTransform())
  {
    return actor->GetTexture()->GetTransform()->GetMatrix()->GetData();
  }
  vtkInformation* const keys = actor->GetPropertyKeys();
  const bool hasMatrix = keys && keys->Has(vtkProp::GeneralTextureTransform()) &&
                         keys->Length(vtkProp::GeneralTextureTransform()) == 16;
  return hasMatrix ? keys->Get(vtkProp::GeneralTextureTransform()) : nullptr;
}

void setTransform(const double* m, TextureLayer& layer)
{
  const double rows[6] = { m[0], m[1], m[3], m[4], m[5], m[7] };
  std::transform(std::begin(rows), std::end(rows), layer.uvTransform,
    [m](double value) { return static_cast<float>(value / m[15]); });
}

TextureRole roleOf(vtkLimnProperty* property)
{
  return property && property->GetTextureRole() == vtkLimnProperty::TEXTURE_SURFACE
           ? TextureRole::kSurface
           : TextureRole::kShaded;
}

TextureMode modeOf(vtkLimnProperty* property)
{
  switch (property ? property->GetTextureMode() : vtkLimnProperty::TEXTURE_MODULATE)
  {
    case vtkLimnProperty::TEXTURE_REPLACE:
      return TextureMode::kReplace;
    case vtkLimnProperty::TEXTURE_DECAL:
      return TextureMode::kDecal;
    case vtkLimnProperty::TEXTURE_ADD:
      return TextureMode::kAdd;
    default:
      return TextureMode::kModulate;
  }
}

ProceduralTexture proceduralOf(vtkLimnProperty* property)
{
  ProceduralTexture texture;
  texture.kind = kindOf(property);
  texture.space = property->GetProceduralSpace() == vtkLimnProperty::PROCEDURAL_UV
                    ? ProceduralSpace::kUv
                    : ProceduralSpace::kObject;
  const Vec3f a = toVec3f(property->GetProceduralColorA());
  const Vec3f b = toVec3f(property->GetProceduralColorB());
  texture.colorA = { a.x, a.y, a.z, 1 };
  texture.colorB = { b.x, b.y, b.z, 1 };
  texture.scale = static_cast<float>(property->GetProceduralScale());
  texture.turbulence = static_cast<float>(property->GetProceduralTurbulence());
  return texture;
}

std::vector<std::string> missingTextures(vtkActor* actor, vtkLimnPolyDataMapper* mapper)
{
  std::vector<std::string> missing;
  if (!hasTextures(actor))
  {
    return missing;
  }
  vtkProperty* const property = actor->GetProperty();
  vtkLimnProperty* const limn = vtkLimnProperty::SafeDownCast(property);
  const std::vector<vtkTexture*> ordinary = ordinaryTexturesOf(actor);
  // VTK blends in the opaque pass, too.
  if (modeOf(limn) == TextureMode::kModulate && actor->HasOpaqueGeometry() &&
      std::any_of(ordinary.begin(), ordinary.end(), letsThrough))
  {
    missing.emplace_back("textures with transparent texels");
  }
  if (mapper->GetSeamlessU() || mapper->GetSeamlessV())
  {
    missing.emplace_back("seamless texture coordinates");
  }
  const double* const matrix = textureMatrixOf(actor);
  if (matrix && isProjective(matrix))
  {
    missing.emplace_back("projective texture transforms");
  }
  if (property->GetInterpolation() == VTK_PBR &&
      (property->GetTexture("materialTex") || property->GetTexture("emissiveTex")))
  {
    missing.emplace_back("textures of roughness and emission");
  }
  return missing;
}

} // namespace limn::bridge
