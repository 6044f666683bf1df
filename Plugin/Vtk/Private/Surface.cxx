// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Surface.h"

#include "Complaints.h"
#include "EngineState.h"
#include "MapperInternals.h"
#include "SceneFromRenderer.h"
#include "StyleFromProperty.h"
#include "UnusableValues.h"

#include "vtkLimnActor.h"
#include "vtkLimnProperty.h"
#include "vtkLimnRenderWindow.h"

#include "vtkAssembly.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkCommand.h"
#include "vtkMatrix4x4.h"
#include "vtkPolyData.h"
#include "vtkPropAssembly.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace limn::bridge
{
namespace
{

/// Actors that render their mapper as themselves. Others, such as vtkFollower, pass another actor.
bool rendersAsItself(vtkActor* actor)
{
  return vtkLimnActor::SafeDownCast(actor) ||
         std::strcmp(actor->GetClassName(), "vtkLimnOpenGLActor") == 0 ||
         std::strcmp(actor->GetClassName(), "vtkOpenGLActor") == 0;
}

/// Returns the input; nullptr if there is none.
vtkPolyData* updateInput(vtkLimnPolyDataMapper* mapper)
{
  KnownInput& known = mapper->GetInternals().Input;
  mapper->InvokeEvent(vtkCommand::StartEvent);
  if (!known.get(mapper))
  {
    mapper->Update();
    known.remember(mapper);
  }
  mapper->InvokeEvent(vtkCommand::EndEvent);
  return inputOf(mapper);
}

bool isDrawn(const std::vector<Missing>& missing, vtkRenderer* renderer)
{
  // In windows of another backend that one draws the whole actor.
  const bool isOurWindow = vtkLimnRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  return std::all_of(missing.begin(), missing.end(),
    [isOurWindow](const Missing& one) { return isOurWindow && one.surfaceIsDrawn; });
}

class SurfaceCollector
{
public:
  explicit SurfaceCollector(vtkRenderer* renderer) : renderer_(renderer) {}

  void add(vtkProp* prop, vtkMatrix4x4* matrix)
  {
    if (!prop->GetVisibility())
    {
      return;
    }
    vtkActor* const actor = vtkActor::SafeDownCast(prop);
    if (!actor || !rendersAsItself(actor))
    {
      collected_.areAll = false;
      return;
    }
    vtkLimnPolyDataMapper* const mapper = vtkLimnPolyDataMapper::SafeDownCast(actor->GetMapper());
    if (!mapper || mapper->GetNumberOfInputConnections(0) == 0 ||
        mapper->GetNumberOfSubPieces() != 1)
    {
      collected_.areAll = false;
      return;
    }
    vtkPolyData* const input = updateInput(mapper);
    if (!input)
    {
      return;
    }
    std::vector<Missing> missing = whatIsMissing(actor, mapper, input);
    if (!isDrawn(missing, renderer_))
    {
      return;
    }
    Surface surface = surfaceOf(actor, mapper, !actor->HasOpaqueGeometry());
    surface.missing = std::move(missing);
    if (matrix)
    {
      surface.modelToWorld = toMat4(matrix);
    }
    collected_.surfaces.push_back(std::move(surface));
  }

  void addPaths(vtkProp* assembly)
  {
    assembly->InitPathTraversal();
    while (vtkAssemblyPath* const path = assembly->GetNextPath())
    {
      vtkAssemblyNode* const node = path->GetLastNode();
      this->add(node->GetViewProp(), node->GetMatrix());
    }
  }

  void reserve(std::size_t surfaces) { collected_.surfaces.reserve(surfaces); }
  CollectedSurfaces take() { return std::move(collected_); }

private:
  vtkRenderer* renderer_;
  CollectedSurfaces collected_ = { {}, true };
};

/// Colours surface and instance by the mapper's scalars, if they are visible and textures do not
/// show them.
void setColors(vtkLimnPolyDataMapper* mapper, vtkPolyData* data, Instance& instance)
{
  SurfaceMesh& mesh = mapper->GetInternals().Mesh;
  int cellFlag = 0;
  const bool isColored =
    mapper->GetScalarVisibility() && !interpolatesScalars(mapper, data, instance.style.frequency);
  vtkUnsignedCharArray* colors = isColored ? mapper->MapScalarsToColors(cellFlag) : nullptr;
  const vtkIdType tuple = mapper->GetFieldDataTupleId();
  constexpr int kFieldData = 2;
  if (colors && cellFlag == kFieldData && tuple >= 0 && tuple < colors->GetNumberOfTuples())
  {
    const unsigned char* const rgba = colors->GetPointer(4 * tuple);
    instance.material.diffuseColor = { rgba[0] / 255.0f, rgba[1] / 255.0f, rgba[2] / 255.0f };
    instance.material.ambientColor = instance.material.diffuseColor;
    instance.material.opacity = rgba[3] / 255.0f;
    colors = nullptr;
  }
  mesh.setColors(colors, cellFlag);
}

/// Whether the mapper's table makes its colours, rather than that they are the scalars.
bool usesTable(vtkLimnPolyDataMapper* mapper, vtkPolyData* data)
{
  int cellFlag = 0;
  vtkAbstractArray* const scalars =
    vtkAbstractMapper::GetAbstractScalars(data, mapper->GetScalarMode(),
      mapper->GetArrayAccessMode(), mapper->GetArrayId(), mapper->GetArrayName(), cellFlag);
  const bool areColors = mapper->GetColorMode() == VTK_COLOR_MODE_DIRECT_SCALARS ||
                         (mapper->GetColorMode() == VTK_COLOR_MODE_DEFAULT &&
                           vtkUnsignedCharArray::SafeDownCast(scalars));
  return mapper->GetScalarVisibility() && scalars && !areColors;
}

void boundLegendSafeRange(vtkLimnPolyDataMapper* mapper, vtkPolyData* data, Style& style)
{
  if (style.tone == Tone::kNone || style.toneOverData != ToneOverData::kLegendSafe ||
      !usesTable(mapper, data))
  {
    return;
  }
  style.legendSafeRange = static_cast<float>(
    mapper->GetInternals().LegendSafeRange(mapper->GetLookupTable(), style.legendSafeRange));
}

/// As VTK's shaders: opacity times the alphas of data and textures. Of surfaces of the opaque pass
/// none counts.
void setTransparency(const Surface& surface, Instance& instance)
{
  Material& material = instance.material;
  material.opacity =
    surface.isTranslucent
      ? material.opacity * static_cast<float>(surface.actor->GetProperty()->GetOpacity())
      : 1.0f;
  instance.style.readsAlpha =
    surface.isTranslucent && (material.opacity >= 1 || !instance.attributes.vertexColors.empty() ||
                               !instance.attributes.cellColors.empty() || !instance.layers.empty());
}

/// For outlines of the picture between parts.
void setIds(const Surface& surface, vtkPolyData* data, Instance& instance, FrameNormals& kept)
{
  if (!instance.style.imageOutline.ids)
  {
    return;
  }
  vtkLimnProperty* const property = vtkLimnProperty::SafeDownCast(surface.actor->GetProperty());
  if (auto ids = surface.mapper->GetInternals().Ids.of(property, data))
  {
    instance.attributes.cellIds = *ids;
    kept.push_back(std::move(ids));
  }
}

void complainOnce(vtkLimnPolyDataMapper* mapper, Complaints& complaints)
{
  vtkLimnPolyDataMapper::vtkInternals& internals = mapper->GetInternals();
  if (internals.LookedAtBuild == internals.Mesh.geometryBuilds())
  {
    return;
  }
  internals.LookedAtBuild = internals.Mesh.geometryBuilds();
  const std::string complaint = internals.Mesh.complaint();
  if (!complaint.empty())
  {
    complaints.add(mapper, "Not all of the input is drawn.", complaint);
  }
}

/// Once for each array of normals; `said` is of which it was.
void complainOfNormals(vtkLimnPolyDataMapper* mapper, const std::string& whose,
  SurfaceMesh::UnusableCount unusable, vtkMTimeType& said, Complaints& complaints)
{
  if (unusable.count == 0 || unusable.time == said)
  {
    return;
  }
  said = unusable.time;
  complaints.add(mapper,
    "Not all " + whose +
      " normals of the input can be used: they are NaN, infinite or too long, and the mesh's own "
      "are drawn in their place.",
    " It is so with " + std::to_string(unusable.count) + " of them.");
}

/// Of those that are drawn.
void complainOfNormals(const Surface& surface, const Instance& instance, Complaints& complaints)
{
  vtkLimnPolyDataMapper::vtkInternals& internals = surface.mapper->GetInternals();
  const NormalSource source = instance.style.normals;
  if (readsPointNormals(surface.actor->GetProperty()))
  {
    complainOfNormals(surface.mapper, "point", internals.Mesh.unusablePointNormals(),
      internals.NormalsSaid.OfPoints, complaints);
  }
  // Triangles' are drawn where all of the cells' cannot be.
  if (source == NormalSource::kCell || source == NormalSource::kTriangle)
  {
    complainOfNormals(surface.mapper, "cell", internals.Mesh.unusableCellNormals(),
      internals.NormalsSaid.OfCells, complaints);
  }
}

} // namespace

Surface surfaceOf(vtkActor* actor, vtkLimnPolyDataMapper* mapper, bool isTranslucent)
{
  actor->ComputeMatrix();
  return { actor, mapper, toMat4(actor->GetMatrix()), {}, isTranslucent };
}

CollectedSurfaces surfacesOf(vtkRenderer* renderer, Assemblies assemblies)
{
  SurfaceCollector collector(renderer);
  vtkPropCollection* const props = renderer->GetViewProps();
  collector.reserve(static_cast<std::size_t>(props->GetNumberOfItems()));
  vtkCollectionSimpleIterator iterator;
  props->InitTraversal(iterator);
  while (vtkProp* const prop = props->GetNextProp(iterator))
  {
    const bool isAssembly = vtkAssembly::SafeDownCast(prop) || vtkPropAssembly::SafeDownCast(prop);
    if (!isAssembly)
    {
      collector.add(prop, nullptr);
    }
    else if (prop->GetVisibility() && assemblies == Assemblies::kTraverse)
    {
      collector.addPaths(prop);
    }
  }
  return collector.take();
}

bool describe(const Surface& surface, Instance& instance, FrameNormals& normals,
  FrameTextures* textures, Complaints& complaints, bool needsTriangles)
{
  vtkPolyData* const data = inputOf(surface.mapper);
  if (!data->GetPoints() || data->GetNumberOfPoints() == 0)
  {
    return false;
  }
  const RenderOptions& options = EngineState::instance().options;
  vtkProperty* const property = surface.actor->GetProperty();
  if (const std::string unusable = unusableValueOf(property); !unusable.empty())
  {
    vtkErrorWithObjectMacro(surface.actor, "Not drawn: " << unusable);
    return false;
  }
  MovedPoints& moved = surface.mapper->GetInternals().Moved;
  moved.update(surface.mapper->GetVertexShader(), data, options.threads);
  SurfaceMesh& mesh = surface.mapper->GetInternals().Mesh;
  SurfaceNeeds needs = needsOf(property);
  needs.triangles =
    options.backend == Backend::kReference || needsTriangles || wantsLines(property);
  if (const Status status = mesh.update(data, moved, needs, options.threads); !status.ok())
  {
    vtkErrorWithObjectMacro(surface.mapper, << status.message);
    return false;
  }
  if (!wantsLines(property))
  {
    surface.mapper->GetInternals().Lines.releaseAllBut(mesh.geometryChanges());
  }
  complainOnce(surface.mapper, complaints);
  if (mesh.isEmpty())
  {
    complainOfFlatness(surface, {}, complaints);
    return false;
  }
  instance.modelToWorld = surface.modelToWorld;
  instance.material = materialOf(property);
  instance.style = styleOf(property, mesh);
  instance.cullBackFaces = property->GetBackfaceCulling() != 0;
  instance.cullFrontFaces = property->GetFrontfaceCulling() && !property->GetBackfaceCulling();
  setColors(surface.mapper, data, instance);
  boundLegendSafeRange(surface.mapper, data, instance.style);
  mesh.describe(instance);
  complainOfNormals(surface, instance, complaints);
  setIds(surface, data, instance, normals);
  if (auto computed = mesh.computedNormals())
  {
    normals.push_back(std::move(computed));
  }
  if (auto smooth = mesh.smoothNormals())
  {
    normals.push_back(std::move(smooth));
  }
  if (textures)
  {
    textures->apply(surface.actor, surface.mapper, data, instance, complaints);
  }
  if (instance.attributes.uv.empty())
  {
    // That there are no coordinates has been said.
    instance.style.hatching.place = HatchPlace::kModel;
  }
  setTransparency(surface, instance);
  return true;
}

bool describeLines(
  const Surface& surface, const LineView& view, Instance& instance, FrameLines& lines)
{
  vtkProperty* const property = surface.actor->GetProperty();
  if (!wantsLines(property))
  {
    return true;
  }
  vtkLimnPolyDataMapper::vtkInternals& internals = surface.mapper->GetInternals();
  const Status status = internals.Lines.add(vtkLimnProperty::SafeDownCast(property),
    inputOf(surface.mapper), internals.Mesh.geometryChanges(), view, instance, lines);
  if (!status.ok())
  {
    vtkErrorWithObjectMacro(surface.mapper, "Its lines are not drawn: " << status.message);
  }
  return status.ok();
}

void complainOfFlatness(const Surface& surface, Span<const LineSet> lines, Complaints& complaints)
{
  vtkLimnPolyDataMapper::vtkInternals& internals = surface.mapper->GetInternals();
  if (!internals.Mesh.isFlattened())
  {
    return;
  }
  auto& said = internals.Flatness;
  if (said.Build != internals.Mesh.geometryBuilds())
  {
    said = { internals.Mesh.geometryBuilds(), {} };
  }
  const bool hasLines = std::any_of(
    lines.begin(), lines.end(), [](const LineSet& set) { return set.chainCount() > 0; });
  if (!std::exchange(said.IsSaid[hasLines ? 1 : 0], true))
  {
    complaints.add(surface.mapper,
      std::string(
        hasLines ? "Only lines of the input are drawn." : "Nothing of the input is drawn.") +
        " None of its faces has an area: the corners of each lie on a line or in a point.");
  }
}

bool describeHull(const Surface& surface, Instance& hull)
{
  vtkProperty* const property = surface.actor->GetProperty();
  if (!hasHull(property))
  {
    return false;
  }
  surface.mapper->GetInternals().Mesh.describeHull(hull);
  hull.modelToWorld = surface.modelToWorld;
  hull.style = hullStyleOf(property);
  return true;
}

} // namespace limn::bridge
