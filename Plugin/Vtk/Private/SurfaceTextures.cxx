// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceTextures.h"

#include "Complaints.h"
#include "LoadedTextures.h"
#include "MapperInternals.h"
#include "TextureSettings.h"

#include "vtkLimnProperty.h"

#include "vtkActor.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkTexture.h"
#include "vtkUnsignedCharArray.h"

#include <sstream>
#include <utility>

namespace limn::bridge
{
namespace
{

bool hasFrequencyAsVtk(vtkLimnProperty* property)
{
  return !property || property->GetShadingFrequency() == vtkLimnProperty::FREQUENCY_AS_VTK;
}

/// Whether VTK's shaders would bend the surface's normals.
bool hasTangents(vtkPolyData* data, const Instance& instance)
{
  return instance.style.normals == NormalSource::kVertex && data->GetPointData()->GetTangents() &&
         data->GetPointData()->GetTangents()->GetNumberOfComponents() == 3;
}

/// Lists the layers of one instance.
class LayerList
{
public:
  LayerList(vtkPolyData* data, MapperTextures& kept, Instance& instance)
    : data_(data), kept_(kept), instance_(instance)
  {
  }

  void setMatrix(const double* matrix) { matrix_ = matrix; }

  /// The input's texture coordinates are read without a texture.
  void requireCoordinates(const char* loss)
  {
    TextureLayer none;
    this->setActive(none, loss, "Make some, for example with vtkTextureMapToPlane.");
  }

  /// By the input's texture coordinates.
  void add(vtkTexture* texture, TextureLayer layer)
  {
    if (this->setActive(layer, "a texture is left out",
          "Make some, for example with "
          "vtkTextureMapToPlane."))
    {
      this->push(texture, layer);
    }
  }

  /// Textures that are put over the surface as one.
  void join(const std::vector<vtkTexture*>& textures, TextureLayer layer)
  {
    const std::size_t first = list_.size();
    for (vtkTexture* const texture : textures)
    {
      // One that could not be loaded leaves its place to the next.
      layer.join = list_.size() == first ? TextureJoin::kNone : joinOf(texture);
      this->add(texture, layer);
    }
  }

  /// By a point array of that name.
  void add(vtkTexture* texture, TextureLayer layer, const std::string& tcoords)
  {
    TCoordArray& array = kept_.named[tcoords];
    array.update(data_->GetPointData()->GetArray(tcoords.c_str()), data_->GetNumberOfPoints());
    if (array.span().empty())
    {
      this->complain("a texture is left out: the input has no point array '" + tcoords +
                     "' of one or two components to read it by.");
    }
    else if (this->setCoordinates(array, layer))
    {
      this->push(texture, layer);
    }
  }

  void add(const ProceduralTexture& procedural, TextureLayer layer)
  {
    layer.procedural = &procedural;
    if (procedural.space == ProceduralSpace::kObject ||
        this->setActive(
          layer, "the procedural texture is left out", "Make some, or use the space Object."))
    {
      list_.push_back(layer);
    }
  }

  /// Scalars that are interpolated before they are mapped. Texels are nearest, at the ends the
  /// last.
  void addScalars(vtkFloatArray* coordinates, vtkImageData* colors)
  {
    kept_.scalars.update(coordinates, data_->GetNumberOfPoints());
    if (const Status status = kept_.colors.update(colors); !status.ok())
    {
      this->complain("the colours of scalars cannot be looked up, and the surface is drawn without "
                     "them. " +
                     status.message + " Use a table of fewer colours.");
      return;
    }
    TextureLayer layer;
    layer.role = TextureRole::kSurface;
    layer.mode = TextureMode::kReplace;
    layer.isData = true;
    layer.image = &kept_.colors.image();
    layer.sampler.filter = TextureFilter::kNearest;
    layer.sampler.wrapU = layer.sampler.wrapV = TextureWrap::kClamp;
    if (this->setCoordinates(kept_.scalars, layer))
    {
      list_.push_back(layer);
    }
  }

  std::vector<TextureLayer> take() { return std::move(list_); }
  const std::string& complaint() const { return complaint_; }

private:
  bool setActive(TextureLayer& layer, const char* loss, const char* mend)
  {
    kept_.active.update(data_->GetPointData()->GetTCoords(), data_->GetNumberOfPoints());
    if (kept_.active.span().empty())
    {
      this->complain(std::string(loss) +
                     ": the input has no texture coordinates of one or two components. " + mend);
      return false;
    }
    if (matrix_)
    {
      setTransform(matrix_, layer);
    }
    return this->setCoordinates(kept_.active, layer);
  }

  bool setCoordinates(const TCoordArray& array, TextureLayer& layer)
  {
    Attributes& attributes = instance_.attributes;
    for (Span<const Vec2f>* set : { &attributes.uv, &attributes.uv2 })
    {
      if (set->empty())
      {
        *set = array.span();
        this->complainOf(array);
      }
      if (set->data() == array.span().data())
      {
        layer.uvSet = set == &attributes.uv ? 0 : 1;
        return true;
      }
    }
    this->complain("a texture is left out: it would be the third to read texture coordinates of "
                   "its own. Interpolated scalars and lightmaps do.");
    return false;
  }

  void complainOf(const TCoordArray& array)
  {
    if (array.notFinite() > 0)
    {
      std::ostringstream text;
      text << array.notFinite() << " texture coordinates are not finite numbers; they count as 0.";
      this->complain(text.str());
    }
  }

  void push(vtkTexture* texture, TextureLayer& layer)
  {
    const LoadedTexture& loaded = loadedTextureOf(texture);
    if (!loaded.image.empty())
    {
      layer.image = &loaded.image;
      layer.sampler = samplerOf(texture, loaded);
      list_.push_back(layer);
    }
  }

  void complain(const std::string& text)
  {
    if (complaint_.find(text) == std::string::npos)
    {
      complaint_ += (complaint_.empty() ? "" : " Also ") + text;
    }
  }

  vtkPolyData* data_;
  MapperTextures& kept_;
  Instance& instance_;
  const double* matrix_ = nullptr;
  std::vector<TextureLayer> list_;
  std::string complaint_;
};

void addScalars(vtkLimnPolyDataMapper* mapper, LayerList& list)
{
  mapper->MapScalars(1.0);
  if (mapper->GetColorCoordinates() && mapper->GetColorTextureMap())
  {
    list.addScalars(mapper->GetColorCoordinates(), mapper->GetColorTextureMap());
  }
}

/// VTK's textures, and those of the same role.
void addColors(
  vtkActor* actor, const Instance& instance, ProceduralTexture& procedural, LayerList& list)
{
  vtkProperty* const property = actor->GetProperty();
  vtkLimnProperty* const limn = vtkLimnProperty::SafeDownCast(property);
  const Reflection reflection = instance.style.reflection;
  TextureLayer layer;
  layer.role = TextureRole::kSurface;
  vtkTexture* const albedo = property->GetTexture("albedoTex");
  if (albedo && reflection != Reflection::kAsVtk && reflection != Reflection::kNone)
  {
    list.add(albedo, layer);
  }
  layer.role = roleOf(limn);
  layer.mode = modeOf(limn);
  layer.onBackFaces = property->GetShowTexturesOnBackface();
  if (reflection != Reflection::kMetallicRoughnessAsVtk)
  {
    list.join(ordinaryTexturesOf(actor), layer);
  }
  if (limn && limn->GetProceduralTexture() != vtkLimnProperty::PROCEDURAL_NONE)
  {
    procedural = proceduralOf(limn);
    list.add(procedural, layer);
  }
}

void addLight(vtkLimnProperty* property, LayerList& list)
{
  if (!property || !property->GetLightmapTexture())
  {
    return;
  }
  TextureLayer layer;
  layer.role = TextureRole::kLight;
  layer.amount = static_cast<float>(property->GetLightmapIntensity());
  const char* const tcoords = property->GetLightmapTCoords();
  if (tcoords && *tcoords)
  {
    list.add(property->GetLightmapTexture(), layer, tcoords);
  }
  else
  {
    list.add(property->GetLightmapTexture(), layer);
  }
}

void addBumps(vtkProperty* property, vtkPolyData* data, const Instance& instance, LayerList& list)
{
  vtkLimnProperty* const limn = vtkLimnProperty::SafeDownCast(property);
  TextureLayer layer;
  vtkTexture* const normals = property->GetTexture("normalTex");
  if (normals && (!hasFrequencyAsVtk(limn) || hasTangents(data, instance)))
  {
    layer.role = TextureRole::kNormal;
    layer.amount = static_cast<float>(property->GetNormalScale());
    list.add(normals, layer);
  }
  if (limn && limn->GetBumpTexture())
  {
    layer.role = TextureRole::kBump;
    layer.amount = static_cast<float>(limn->GetBumpScale());
    list.add(limn->GetBumpTexture(), layer);
  }
}

} // namespace

Status ColorTable::update(vtkImageData* colors)
{
  if (colors == colors_ && colors->GetMTime() == time_)
  {
    return status_;
  }
  colors_ = colors;
  time_ = colors->GetMTime();
  auto* const bytes = vtkUnsignedCharArray::SafeDownCast(colors->GetPointData()->GetScalars());
  TextureView view;
  view.width = colors->GetDimensions()[0];
  view.height = colors->GetDimensions()[1];
  view.components = bytes->GetNumberOfComponents();
  view.texels = bytes->GetPointer(0);
  view.byteCount = static_cast<std::size_t>(bytes->GetNumberOfValues());
  status_ = image_.build(view, MipChain::kNone);
  return status_;
}

void FrameTextures::apply(vtkActor* actor, vtkLimnPolyDataMapper* mapper, vtkPolyData* data,
  Instance& instance, Complaints& complaints)
{
  const bool hasScalars = interpolatesScalars(mapper, data, instance.style.frequency);
  const bool hatchesTexture =
    instance.style.tone == Tone::kHatching && instance.style.hatching.place == HatchPlace::kTexture;
  if (!hasScalars && !hasTextures(actor) && !hatchesTexture)
  {
    return;
  }
  MapperTextures& kept = mapper->GetInternals().Textures;
  auto layers = std::make_unique<Layers>();
  LayerList list(data, kept, instance);
  if (hatchesTexture)
  {
    list.requireCoordinates("hatching lies on the model");
  }
  if (hasScalars)
  {
    addScalars(mapper, list);
  }
  list.setMatrix(textureMatrixOf(actor));
  vtkProperty* const property = actor->GetProperty();
  addColors(actor, instance, layers->procedural, list);
  addLight(vtkLimnProperty::SafeDownCast(property), list);
  addBumps(property, data, instance, list);
  if (!list.complaint().empty() && list.complaint() != kept.complaint)
  {
    complaints.add(mapper, "Of its textures: " + list.complaint());
  }
  kept.complaint = list.complaint();
  layers->list = list.take();
  instance.layers = layers->list;
  layers_.push_back(std::move(layers));
}

bool interpolatesScalars(
  vtkLimnPolyDataMapper* mapper, vtkPolyData* data, ShadingFrequency frequency)
{
  // With colours of corners there is nothing to look up in a pixel.
  return mapper->GetScalarVisibility() && mapper->GetInterpolateScalarsBeforeMapping() &&
         frequency != ShadingFrequency::kGouraud && mapper->CanUseTextureMapForColoring(data);
}

} // namespace limn::bridge
