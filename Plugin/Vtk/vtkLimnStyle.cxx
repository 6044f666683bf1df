// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLimnStyle.h"

#include "Private/StyleMemory.h"

#include "vtkLimnPolyDataMapper.h"
#include "vtkLimnProperty.h"

#include "vtkActor.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleKey.h"
#include "vtkInformationDoubleVectorKey.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <set>
#include <string>

namespace
{
using Rgb = std::array<double, 3>;

/// Shades from `dark` to `light`, without highlights, for light from the upper right.
void SetShades(vtkLimnProperty* property, const Rgb& dark, const Rgb& light)
{
  property->SetToneToGooch();
  property->SetToneLightToUpperRight();
  property->SetToneHighlightToNone();
  property->SetCoolColor(dark[0], dark[1], dark[2]);
  property->SetWarmColor(light[0], light[1], light[2]);
  property->SetCoolSurface(0);
  property->SetWarmSurface(0);
}

/// Shades of the surface's own colours, from the share `dark` of them to all.
void SetOwnShades(vtkLimnProperty* property, double dark)
{
  SetShades(property, { 0, 0, 0 }, { 0, 0, 0 });
  property->SetCoolSurface(dark);
  property->SetWarmSurface(1);
  property->SetToneOverDataToLegendSafe();
}

/// Creases of fewer edges are bumps of rough surfaces.
constexpr int kShortestCrease = 8;

/// Contours, creases, borders, and where surfaces run into each other.
void SetLines(vtkLimnProperty* property, const Rgb& color, double width, double outer)
{
  property->ContourLinesOn();
  property->CreaseLinesOn();
  property->SetShortestCrease(kShortestCrease);
  property->BorderLinesOn();
  property->IntersectionLinesOn();
  property->SetStrokeColor(color[0], color[1], color[2]);
  property->SetStrokeWidth(width);
  property->SetOuterWidthFactor(outer);
}

void SetTechnical(vtkLimnProperty* property)
{
  property->SetGoochTo1998();
  property->SetToneLightToUpperRight();
  property->SetToneOverDataToLegendSafe();
  SetLines(property, { 0.1, 0.1, 0.13 }, 1.1, 2);
}

void SetGooch(vtkLimnProperty* property)
{
  property->SetGoochTo1998();
  property->SetToneLightToUpperRight();
  property->SetToneOverDataToLegendSafe();
  SetLines(property, { 0, 0, 0 }, 1.6, 1);
  property->CreaseLinesOff();
}

void SetToon(vtkLimnProperty* property)
{
  SetOwnShades(property, 0.35);
  property->SetToonBands(3);
  SetLines(property, { 0, 0, 0 }, 2, 1.6);
}

void SetBlueprint(vtkLimnProperty* property)
{
  const Rgb fill = { 0.08, 0.22, 0.46 };
  SetShades(property, fill, fill);
  SetLines(property, { 0.92, 0.96, 1 }, 1.1, 1.8);
  property->SetHiddenLinesToDashed();
}

/// Strokes along the curvature, by the light that SetShades() has.
void SetStrokes(vtkLimnProperty* property, double spacing, double width)
{
  property->HatchLinesOn();
  property->SetHatchSpacing(spacing);
  property->SetHatchWidth(width);
  property->SetHatchDarkest(0.9);
}

void SetPencil(vtkLimnProperty* property)
{
  SetShades(property, { 0.7, 0.7, 0.7 }, { 0.98, 0.97, 0.94 });
  SetLines(property, { 0.24, 0.24, 0.26 }, 1.4, 1.5);
  property->SetStrokeOpacity(0.8);
  property->SetStrokeTaper(6);
  SetStrokes(property, 5, 0.5);
}

void SetInk(vtkLimnProperty* property)
{
  SetShades(property, { 1, 1, 1 }, { 1, 1, 1 });
  SetLines(property, { 0, 0, 0 }, 1.5, 1.8);
  property->SetStrokeTaper(4);
  SetStrokes(property, 4.5, 0.5);
}

void SetAnatomy(vtkLimnProperty* property)
{
  SetOwnShades(property, 0.45);
  property->SetCoolColor(0.1, 0.03, 0.05);
  property->SetWarmColor(0.06, 0.03, 0);
  SetLines(property, { 0.28, 0.12, 0.07 }, 1, 1.6);
  property->CreaseLinesOff();
}

void SetMetal(vtkLimnProperty* property)
{
  property->SetMetalToSteel();
  property->SetToneLightToUpperRight();
  SetLines(property, { 0.05, 0.05, 0.07 }, 1.1, 1.8);
}

/// A lit sphere that is bright at its border alone.
vtkSmartPointer<vtkImageData> GlowingBorder()
{
  constexpr int kSide = 128;
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(kSide, kSide, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* texel = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int y = 0; y < kSide; ++y)
  {
    for (int x = 0; x < kSide; ++x)
    {
      // From the middle, twice, in texels: whole numbers up to the root.
      const int dx = 2 * x + 1 - kSide;
      const int dy = 2 * y + 1 - kSide;
      const double r = std::min(std::sqrt(static_cast<double>(dx * dx + dy * dy)) / kSide, 1.0);
      const double glow = 0.06 + 0.94 * (r * r) * (r * r);
      *texel++ = static_cast<unsigned char>(255 * 0.8 * glow + 0.5);
      *texel++ = static_cast<unsigned char>(255 * 0.92 * glow + 0.5);
      *texel++ = static_cast<unsigned char>(255 * glow + 0.5);
    }
  }
  return image;
}

void SetXray(vtkLimnProperty* property)
{
  property->SetToneToMatCap();
  property->SetMatCapImage(GlowingBorder());
  property->SetOpacity(0.45);
}

void SetPrint(vtkLimnProperty* property)
{
  SetShades(property, { 0.78, 0.78, 0.78 }, { 1, 1, 1 });
  property->SetToonBands(2);
  SetLines(property, { 0, 0, 0 }, 0.75, 2);
  property->SetStrokeUnitToPoints();
}

struct Style
{
  const char* Name;
  void (*Set)(vtkLimnProperty*); ///< nullptr: the defaults
  const Rgb* Background;         ///< nullptr: any
};

const Rgb BlueprintPaper = { 0.05, 0.16, 0.38 };
const Rgb PencilPaper = { 0.98, 0.97, 0.94 };
const Rgb White = { 1, 1, 1 };
const Rgb Black = { 0, 0, 0 };

const Style Styles[] = {
  { "plain", nullptr, nullptr },
  { "technical", SetTechnical, nullptr },
  { "gooch", SetGooch, nullptr },
  { "toon", SetToon, nullptr },
  { "blueprint", SetBlueprint, &BlueprintPaper },
  { "pencil", SetPencil, &PencilPaper },
  { "ink", SetInk, &White },
  { "anatomy", SetAnatomy, nullptr },
  { "metal", SetMetal, nullptr },
  { "xray", SetXray, &Black },
  { "print", SetPrint, &White },
};

const Style* Find(const char* name)
{
  const auto found = std::find_if(std::begin(Styles), std::end(Styles),
    [name](const Style& style) { return name && std::strcmp(style.Name, name) == 0; });
  return found == std::end(Styles) ? nullptr : found;
}

const Style* FindOrReport(const char* name)
{
  const Style* const style = Find(name);
  if (!style)
  {
    std::string names;
    for (const Style& one : Styles)
    {
      names += std::string(names.empty() ? "" : ", ") + one.Name;
    }
    vtkGenericWarningMacro(
      "There is no style " << (name ? name : "(null)") << "; take one of " << names << ".");
  }
  return style;
}

// What was there before the first style.
vtkInformationDoubleKey* OpacityKey()
{
  return limn::bridge::opacityBeforeStyles();
}
vtkInformationDoubleVectorKey* BackgroundKey()
{
  static auto* const key = vtkInformationDoubleVectorKey::MakeKey("BACKGROUND", "vtkLimnStyle", 3);
  return key;
}

double FirstOpacity(vtkProperty* property)
{
  vtkInformation* const information = property->GetInformation();
  if (!information->Has(OpacityKey()))
  {
    information->Set(OpacityKey(), property->GetOpacity());
  }
  return information->Get(OpacityKey());
}

/// The defaults, but for what no style has a say in.
void Reset(vtkLimnProperty* property)
{
  // VTK 9.1 copies pointers to textures without counting them: they stay where they are.
  std::map<std::string, vtkTexture*> textures;
  property->GetAllTextures().swap(textures);
  vtkNew<vtkLimnProperty> fresh;
  fresh->vtkProperty::DeepCopy(property); // nothing that is Limn's
  const double opacity = FirstOpacity(property);
  fresh->SetOpacity(opacity);
  fresh->SetShadingFrequency(property->GetShadingFrequency());
  fresh->SetFlatPoint(property->GetFlatPoint());
  fresh->SetVertexNormals(property->GetVertexNormals());
  fresh->SetFeatureAngle(property->GetFeatureAngle());
  fresh->SetTextureRole(property->GetTextureRole());
  fresh->SetTextureMode(property->GetTextureMode());
  fresh->SetProceduralTexture(property->GetProceduralTexture());
  fresh->SetProceduralSpace(property->GetProceduralSpace());
  fresh->SetProceduralColorA(property->GetProceduralColorA());
  fresh->SetProceduralColorB(property->GetProceduralColorB());
  fresh->SetProceduralScale(property->GetProceduralScale());
  fresh->SetProceduralTurbulence(property->GetProceduralTurbulence());
  fresh->SetLightmapTexture(property->GetLightmapTexture());
  fresh->SetLightmapIntensity(property->GetLightmapIntensity());
  fresh->SetLightmapTCoords(property->GetLightmapTCoords());
  fresh->SetBumpTexture(property->GetBumpTexture());
  fresh->SetBumpScale(property->GetBumpScale());
  property->DeepCopy(fresh);
  property->GetInformation()->Set(OpacityKey(), opacity);
  property->GetAllTextures().swap(textures);
}

void Apply(vtkLimnProperty* property, const Style& style)
{
  Reset(property);
  if (style.Set)
  {
    style.Set(property);
  }
  else
  {
    property->GetInformation()->Remove(OpacityKey());
  }
}

void SetBackground(vtkRenderer* renderer, const Style& style)
{
  vtkInformation* const information = renderer->GetInformation();
  if (!information->Has(BackgroundKey()))
  {
    const double* const rgb = renderer->GetBackground();
    information->Set(BackgroundKey(), rgb[0], rgb[1], rgb[2]);
  }
  const double* const rgb =
    style.Background ? style.Background->data() : information->Get(BackgroundKey());
  renderer->SetBackground(rgb[0], rgb[1], rgb[2]);
  if (!style.Set)
  {
    information->Remove(BackgroundKey());
  }
}

/// Those that Limn draws, each once, the parts of assemblies too.
std::set<vtkActor*> ActorsOf(vtkRenderer* renderer)
{
  std::set<vtkActor*> actors;
  vtkCollectionSimpleIterator place;
  vtkPropCollection* const props = renderer->GetViewProps();
  props->InitTraversal(place);
  while (vtkProp* const prop = props->GetNextProp(place))
  {
    prop->InitPathTraversal();
    while (vtkAssemblyPath* const path = prop->GetNextPath())
    {
      vtkActor* const actor = vtkActor::SafeDownCast(path->GetLastNode()->GetViewProp());
      if (actor && vtkLimnPolyDataMapper::SafeDownCast(actor->GetMapper()))
      {
        actors.insert(actor);
      }
    }
  }
  return actors;
}
}

namespace limn::bridge
{

vtkInformationDoubleKey* opacityBeforeStyles()
{
  static auto* const key = vtkInformationDoubleKey::MakeKey("OPACITY", "vtkLimnStyle");
  return key;
}

} // namespace limn::bridge

vtkStandardNewMacro(vtkLimnStyle);

//------------------------------------------------------------------------------
vtkLimnStyle::vtkLimnStyle() = default;

//------------------------------------------------------------------------------
vtkLimnStyle::~vtkLimnStyle() = default;

//------------------------------------------------------------------------------
int vtkLimnStyle::GetNumberOfStyles()
{
  return static_cast<int>(std::size(Styles));
}

//------------------------------------------------------------------------------
const char* vtkLimnStyle::GetStyleName(int index)
{
  return index >= 0 && index < GetNumberOfStyles() ? Styles[index].Name : nullptr;
}

//------------------------------------------------------------------------------
bool vtkLimnStyle::Apply(vtkRenderer* renderer, const char* name)
{
  const Style* const style = FindOrReport(name);
  if (!style || !renderer)
  {
    return false;
  }
  std::map<vtkProperty*, vtkSmartPointer<vtkLimnProperty>> replacements;
  std::set<vtkLimnProperty*> properties;
  for (vtkActor* const actor : ActorsOf(renderer))
  {
    vtkProperty* const property = actor->GetProperty();
    vtkLimnProperty* limn = vtkLimnProperty::SafeDownCast(property);
    if (!limn)
    {
      vtkSmartPointer<vtkLimnProperty>& replacement = replacements[property];
      if (!replacement)
      {
        replacement = vtkSmartPointer<vtkLimnProperty>::New();
        replacement->DeepCopy(property);
      }
      limn = replacement;
      actor->SetProperty(limn);
    }
    properties.insert(limn);
  }
  for (vtkLimnProperty* const property : properties)
  {
    ::Apply(property, *style);
  }
  SetBackground(renderer, *style);
  return true;
}

//------------------------------------------------------------------------------
bool vtkLimnStyle::Apply(vtkLimnProperty* property, const char* name)
{
  const Style* const style = FindOrReport(name);
  if (!style || !property)
  {
    return false;
  }
  ::Apply(property, *style);
  return true;
}

//------------------------------------------------------------------------------
bool vtkLimnStyle::GetBackground(const char* name, double rgb[3])
{
  const Style* const style = Find(name);
  if (!style || !style->Background)
  {
    return false;
  }
  std::copy(style->Background->begin(), style->Background->end(), rgb);
  return true;
}

//------------------------------------------------------------------------------
void vtkLimnStyle::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  for (const Style& style : Styles)
  {
    os << indent << "Style: " << style.Name << "\n";
  }
}
