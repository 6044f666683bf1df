// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceLines.h"

#include "CellIds.h"
#include "StyleFromProperty.h"

#include "vtkLimnProperty.h"

#include "Rendering/Base/ParallelStretches.h"
#include "Rendering/Lines/FollowFacets.h"
#include "Rendering/Lines/Terminator.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <sstream>
#include <utility>

namespace limn::bridge
{
namespace
{

unsigned kindsOf(vtkLimnProperty* property)
{
  unsigned kinds = 0;
  kinds |= property->GetCreaseLines() ? kCreaseEdge : 0;
  kinds |= property->GetBorderLines() ? kBorderEdge : 0;
  kinds |= property->GetNonManifoldLines() ? kNonManifoldEdge : 0;
  kinds |= property->GetIdLines() ? kIdEdge : 0;
  kinds |= property->GetNormalLines() ? kNormalEdge : 0;
  return kinds;
}

bool wantsCurves(vtkLimnProperty* property)
{
  return property->GetRidgeLines() || property->GetValleyLines() || property->GetSuggestiveLines();
}

} // namespace

LineStyle strokeStyleOf(vtkLimnProperty* property, double pixelsPerInch)
{
  LineStyle style;
  const double* const color = property->GetStrokeColor();
  style.color = vec3Cast<float>(Vec3d{ color[0], color[1], color[2] });
  style.opacity = static_cast<float>(property->GetStrokeOpacity());
  style.width = static_cast<float>(
    property->GetStrokeWidth() * pixelsPerUnit(property->GetStrokeUnit(), pixelsPerInch));
  style.outerFactor = static_cast<float>(property->GetOuterWidthFactor());
  style.taper = static_cast<float>(property->GetStrokeTaper());
  const auto dash = static_cast<float>(property->GetStrokeDash());
  const auto gap = static_cast<float>(property->GetStrokeGap());
  if (dash > 0 && gap > 0)
  {
    style.dash = dash;
    style.gap = gap;
  }
  switch (property->GetHiddenLines())
  {
    case vtkLimnProperty::HIDDEN_LINES_DASHED:
      style.hidden = HiddenLines::kDashed;
      break;
    case vtkLimnProperty::HIDDEN_LINES_THIN:
      style.hidden = HiddenLines::kThin;
      break;
    default:
      style.hidden = HiddenLines::kOff;
  }
  return style;
}

bool isSamePlace(const Mat4d& a, const Mat4d& b)
{
  for (int row = 0; row < 4; ++row)
  {
    if (!std::equal(std::begin(a.m[row]), std::end(a.m[row]), std::begin(b.m[row])))
    {
      return false;
    }
  }
  return true;
}

Status checkStroke(const LineStyle& style, const char* name)
{
  if (style.width > 0 && style.width <= kMaxLineWidth)
  {
    return {};
  }
  std::ostringstream text;
  text << name << " of its vtkLimnProperty is " << style.width
       << " pixels; it has to be above 0, at most " << kMaxLineWidth << ".";
  return { Error::kNotFinite, text.str() };
}

bool wantsLines(vtkProperty* property)
{
  vtkLimnProperty* const limn = vtkLimnProperty::SafeDownCast(property);
  return limn && (kindsOf(limn) != 0 || limn->GetContourLines() || limn->GetSilhouetteLines() ||
                   limn->GetTerminatorLines() || wantsCurves(limn) || limn->GetHatchLines());
}

bool SurfaceLines::NormalsVersion::operator==(const NormalsVersion& other) const
{
  return values == other.values && time == other.time && source == other.source &&
         featureDegrees == other.featureDegrees;
}

SurfaceLines::NormalsVersion SurfaceLines::normalsVersion(
  vtkLimnProperty* property, vtkPolyData* data, const Instance& instance)
{
  vtkDataArray* const array = data->GetPointData()->GetNormals();
  return { instance.attributes.vertexNormals.data(), array ? array->GetMTime() : 0,
    property->GetVertexNormals(), property->GetFeatureAngle() };
}

bool SurfaceLines::Choice::operator==(const Choice& other) const
{
  return kinds == other.kinds && creaseDegrees == other.creaseDegrees &&
         shortestCrease == other.shortestCrease && ids == other.ids && idsTime == other.idsTime &&
         normals == other.normals;
}

void SurfaceLines::releaseAllBut(vtkIdType geometry)
{
  if (geometry_ != -1 && geometry_ != geometry)
  {
    const vtkIdType builds = edgeBuilds_;
    *this = SurfaceLines();
    edgeBuilds_ = builds;
  }
}

Status SurfaceLines::update(vtkIdType geometry, const Instance& instance, int threads)
{
  if (geometry == geometry_)
  {
    return {};
  }
  geometry_ = -1;
  choice_ = {};
  features_.reset();
  normalsDegrees_ = -1;
  weldedTriangles_.clear();
  faceBounds_ = {};
  curvature_.clear();
  ridges_.reset();
  valleys_.reset();
  terminators_.clear();
  strokes_.reset();
  const Status status = buildEdgeTable(instance.mesh, 0, threads, table_);
  if (status.ok())
  {
    geometry_ = geometry;
    ++edgeBuilds_;
  }
  return status;
}

void SurfaceLines::updateFeatures(
  const Choice& choice, vtkDataArray* idArray, const Instance& instance, int threads)
{
  if (choice == choice_ && features_)
  {
    return;
  }
  const Attributes& attributes = instance.attributes;
  FeatureArrays arrays;
  arrays.cells = attributes.cells;
  if ((choice.kinds & kNormalEdge) != 0)
  {
    arrays.vertexNormals = attributes.vertexNormals;
    arrays.normalOfCorner = attributes.normalOfCorner;
  }
  std::vector<std::uint32_t> ids;
  if (idArray)
  {
    ids = numbersOf(idArray);
    arrays.ids = ids;
  }
  auto kinds = edgeKinds(instance.mesh, table_, arrays, choice.creaseDegrees, threads);
  if ((choice.kinds & kCreaseEdge) != 0)
  {
    dropLooseCreases(instance.mesh, table_, choice.kinds, choice.shortestCrease, kinds);
  }
  features_ = std::make_shared<const EdgeChains>(chainEdges(table_, kinds, choice.kinds));
  choice_ = choice;
}

MeshView SurfaceLines::weldedMesh(const MeshView& mesh) const
{
  return { mesh.positions, mesh.precisePositions, weldedTriangles_ };
}

void SurfaceLines::weld(const MeshView& mesh, int threads)
{
  if (!weldedTriangles_.empty())
  {
    return;
  }
  constexpr std::size_t kPerTask = 16384;
  Array<Triangle> welded(mesh.triangles.size());
  parallelForEach(threads, welded.size(), kPerTask,
    [&](std::size_t t)
    {
      Triangle& triangle = welded[t];
      triangle = mesh.triangles[t];
      for (std::uint32_t& vertex : triangle.vertex)
      {
        vertex = vertex < table_.place.size() ? table_.place[vertex] : vertex;
      }
    });
  weldedTriangles_ = std::move(welded);
}

void SurfaceLines::updateCurvature(
  const NormalsVersion& normals, const Instance& instance, int threads)
{
  const Attributes& attributes = instance.attributes;
  const bool hasNormals = attributes.normalOfCorner.empty() && !attributes.vertexNormals.empty();
  if (!curvature_.empty() && normals == curvedNormals_)
  {
    return;
  }
  // Until all of it is there, none counts: memory may run out.
  curvature_.clear();
  ridges_.reset();
  valleys_.reset();
  strokes_.reset();
  this->weld(instance.mesh, threads);
  const MeshView mesh = this->weldedMesh(instance.mesh);
  if (hasNormals)
  {
    smoothNormals_.resize(mesh.vertexCount());
    bool areUsable = true;
    const auto isUsable = [](Vec3f unit) { return dot(unit, unit) > 0; };
    for (std::size_t v = 0; v < smoothNormals_.size(); ++v)
    {
      smoothNormals_[v] = normalized(attributes.vertexNormals[v]);
      areUsable = areUsable && isUsable(smoothNormals_[v]);
    }
    if (!areUsable)
    {
      const std::vector<Vec3f> own = limn::vertexNormals(mesh, NormalWeight::kArea);
      for (std::size_t v = 0; v < own.size(); ++v)
      {
        smoothNormals_[v] = isUsable(smoothNormals_[v]) ? smoothNormals_[v] : own[v];
      }
    }
  }
  else
  {
    smoothNormals_ = limn::vertexNormals(mesh, NormalWeight::kArea);
  }
  curveBounds_ = {};
  featureSize_ = featureSize(mesh, threads);
  curvature_ = vertexCurvature(mesh, smoothNormals_, threads);
  curvedNormals_ = normals;
}

CurvedSurface SurfaceLines::curved(const MeshView& mesh) const
{
  return { this->weldedMesh(mesh), smoothNormals_, curvature_ };
}

Status SurfaceLines::updateNormals(double creaseDegrees, const Instance& instance, int threads)
{
  if (creaseDegrees == normalsDegrees_)
  {
    return {};
  }
  // Until all of it is there, none counts.
  normalsDegrees_ = -1;
  this->weld(instance.mesh, threads);
  const Status status =
    splitVertexNormals(this->weldedMesh(instance.mesh), instance.attributes.cells,
      NormalWeight::kAngle, creaseDegrees, threads, normals_, &onlyNormals_);
  if (status.ok())
  {
    normalBounds_ =
      boundNormals(this->weldedMesh(instance.mesh), table_, this->contourArrays(), threads);
    normalsDegrees_ = creaseDegrees;
  }
  return status;
}

FeatureArrays SurfaceLines::contourArrays() const
{
  FeatureArrays arrays;
  arrays.vertexNormals = normals_.normals;
  arrays.normalOfCorner = normals_.ofCorner;
  arrays.normalOfVertex = onlyNormals_;
  return arrays;
}

void SurfaceLines::addFeatures(vtkLimnProperty* property, vtkPolyData* data, const LineView& view,
  const Instance& instance, FrameLines& frame)
{
  Choice choice;
  choice.kinds = kindsOf(property);
  vtkDataArray* const ids = property->GetIdLines() ? idArrayOf(property, data) : nullptr;
  choice.creaseDegrees = property->GetCreaseAngle();
  choice.shortestCrease = static_cast<std::uint32_t>(property->GetShortestCrease());
  choice.ids = ids;
  choice.idsTime = ids ? ids->GetMTime() : 0;
  if (property->GetNormalLines())
  {
    choice.normals = normalsVersion(property, data, instance);
  }
  this->updateFeatures(choice, ids, instance, view.threads);
  frame.edges.push_back(features_);
  if (property->GetOuterWidthFactor() != 1)
  {
    auto marked = std::make_shared<EdgeChains>(*features_);
    markOuterEdges(instance.mesh, table_, view.camera, instance.modelToWorld, *marked);
    frame.edges.back() = std::move(marked);
  }
}

/// What finds the lines that depend on the camera, all kinds at once: few of them keep all threads
/// at work alone.
class SurfaceLines::Finders
{
public:
  /// Of what comes next in `lines`.
  template <class Lines, class Find>
  void add(std::vector<std::shared_ptr<const Lines>>& lines, const Find& find)
  {
    const std::size_t place = lines.size();
    lines.emplace_back();
    finders_.emplace_back(
      [&lines, place, find] { lines[place] = std::make_shared<const Lines>(find()); });
  }
  void run(int threads) const
  {
    parallelFor(threads, finders_.size(), [this](std::size_t i) { finders_[i](); });
  }

private:
  std::vector<std::function<void()>> finders_;
};

Status SurfaceLines::addContours(vtkLimnProperty* property, const LineStyle& style,
  const LineView& view, const Instance& instance, Finders& finders, FrameLines& frame)
{
  if (Status status = this->updateNormals(property->GetCreaseAngle(), instance, view.threads);
      !status.ok())
  {
    return status;
  }
  finders.add(frame.contours,
    [this, &view, &instance, &style]
    {
      const MeshView mesh = this->weldedMesh(instance.mesh);
      ContourLines contours = smoothContours(mesh, table_, this->contourArrays(), normalBounds_,
        view.camera, instance.modelToWorld, view.threads);
      followFacets(mesh, table_, this->contourArrays(),
        { view.camera, instance.modelToWorld, view.width, view.height, style }, view.threads,
        contours);
      return contours;
    });
  return {};
}

Status SurfaceLines::addTerminators(
  vtkLimnProperty* property, const LineView& view, const Instance& instance, FrameLines& frame)
{
  const double creaseDegrees = property->GetCreaseAngle();
  if (Status status = this->updateNormals(creaseDegrees, instance, view.threads); !status.ok())
  {
    return status;
  }
  const bool isOfAll = property->GetLineLights() == vtkLimnProperty::LINE_LIGHTS_ALL;
  const std::size_t count = isOfAll ? view.rays.size() : std::min<std::size_t>(1, view.rays.size());
  std::vector<Terminator> terminators;
  for (std::size_t i = 0; i < count; ++i)
  {
    Terminator one = { view.rays[i], instance.modelToWorld, creaseDegrees, {} };
    const auto kept = std::find_if(terminators_.begin(), terminators_.end(),
      [&one](const Terminator& other)
      {
        return one.light == other.light && one.creaseDegrees == other.creaseDegrees &&
               isSamePlace(one.place, other.place);
      });
    one.lines =
      kept != terminators_.end()
        ? kept->lines
        : std::make_shared<const ContourLines>(terminatorLines(this->weldedMesh(instance.mesh),
            table_, this->contourArrays(), normalBounds_, one.light, one.place, view.threads));
    frame.contours.push_back(one.lines);
    terminators.push_back(std::move(one));
  }
  terminators_ = std::move(terminators);
  return {};
}

void SurfaceLines::addCurves(vtkLimnProperty* property, vtkPolyData* data, const LineView& view,
  const Instance& instance, Finders& finders, FrameLines& frame)
{
  this->updateCurvature(normalsVersion(property, data, instance), instance, view.threads);
  const CurvedSurface surface = this->curved(instance.mesh);
  const CurveThresholds thresholds = { property->GetRidgeThreshold(),
    property->GetSuggestiveThreshold() };
  if (thresholds.ridge != ridgeThreshold_)
  {
    ridges_.reset();
    valleys_.reset();
    ridgeThreshold_ = thresholds.ridge;
  }
  const auto extremes = [&](ExtremeKind kind, std::shared_ptr<const ContourLines>& kept)
  {
    if (!kept)
    {
      kept = std::make_shared<const ContourLines>(
        extremeLines(surface, table_, kind, thresholds, featureSize_, view.threads));
    }
    frame.contours.push_back(kept);
  };
  if (property->GetRidgeLines())
  {
    extremes(ExtremeKind::kRidge, ridges_);
  }
  if (property->GetValleyLines())
  {
    extremes(ExtremeKind::kValley, valleys_);
  }
  if (property->GetSuggestiveLines())
  {
    if (curveBounds_.boxes.empty())
    {
      curveBounds_ = boundCurves(surface, table_, view.threads);
    }
    finders.add(frame.contours,
      [this, &view, &instance, surface, thresholds]
      {
        return suggestiveContours(surface, table_, curveBounds_, view.camera, instance.modelToWorld,
          thresholds, view.threads);
      });
  }
}

double SurfaceLines::hatchCreaseDegrees(
  vtkLimnProperty* property, vtkPolyData* data, const Instance& instance) const
{
  if (property->GetFeatureAngle() < 180)
  {
    return property->GetFeatureAngle();
  }
  const bool isOfData = property->GetVertexNormals() == vtkLimnProperty::NORMALS_FROM_DATA &&
                        data->GetPointData()->GetNormals() != nullptr;
  const Span<const Vec3f> normals = instance.attributes.vertexNormals;
  if (!isOfData || normals.size() != table_.place.size())
  {
    return property->GetCreaseAngle();
  }
  // The data say where the surface is smooth, unless their normals are split somewhere.
  constexpr float kSplitCosine = 0.94f;
  constexpr double kSmooth = 60;
  for (std::size_t v = 0; v < normals.size(); ++v)
  {
    const Vec3f a = normalized(normals[v]);
    const Vec3f b = normalized(normals[table_.place[v]]);
    if (dot(a, b) < kSplitCosine && !(a == Vec3f{ 0, 0, 0 }) && !(b == Vec3f{ 0, 0, 0 }))
    {
      return property->GetCreaseAngle();
    }
  }
  return std::max(kSmooth, property->GetCreaseAngle());
}

Status SurfaceLines::updateStrokes(
  vtkLimnProperty* property, vtkPolyData* data, const Instance& instance, int threads)
{
  this->updateCurvature(normalsVersion(property, data, instance), instance, threads);
  const double creaseDegrees = strokes_ && property->GetCreaseAngle() == strokesCreaseAngle_
                                 ? strokesDegrees_
                                 : this->hatchCreaseDegrees(property, data, instance);
  strokesCreaseAngle_ = property->GetCreaseAngle();
  if (strokes_ && creaseDegrees == strokesDegrees_)
  {
    return {};
  }
  strokes_.reset();
  const std::vector<std::uint8_t> kinds =
    edgeKinds(this->weldedMesh(instance.mesh), table_, {}, creaseDegrees, threads);
  const HatchSurface whole = { this->curved(instance.mesh), table_, kinds };
  CutMesh cut;
  if (Status status = cutAtCreases(whole, creaseDegrees, threads, cut); !status.ok())
  {
    return status;
  }
  const HatchSurface surface = { cut.triangles.empty() ? whole.curved : cut.surface(), table_,
    kinds };
  strokes_ = std::make_unique<const HatchStrokes>(
    traceHatching(surface, hatchField(surface, threads), threads));
  strokesDegrees_ = creaseDegrees;
  return {};
}

LineSet SurfaceLines::hatchLinesOf(
  vtkLimnProperty* property, const LineView& view, const Instance& instance, FrameLines& frame)
{
  const Material& material = instance.material;
  const HatchView hatchView = { view.camera,
    material.ambientColor * material.ambient * view.ambientLight, view.lights,
    instance.style.fallOff, instance.style.toneLight, view.height, instance.style.hatching.spacing,
    instance.style.hatching.darkest };
  frame.hatches.push_back(std::make_unique<const ContourLines>(
    hatchLines(*strokes_, instance.modelToWorld, hatchView, view.threads)));
  LineStyle style = strokeStyleOf(property, view.pixelsPerInch);
  style.width *= static_cast<float>(property->GetHatchWidth());
  if (style.width <= kMaxLineWidth)
  {
    style.width = std::min(style.width * static_cast<float>(kHatchSwell), kMaxLineWidth);
  }
  style.taper = std::max(style.taper, hatchView.spacing);
  return frame.hatches.back()->lines(style);
}

Status SurfaceLines::add(vtkLimnProperty* property, vtkPolyData* data, vtkIdType geometry,
  const LineView& view, Instance& instance, FrameLines& frame)
{
  const LineStyle style = strokeStyleOf(property, view.pixelsPerInch);
  if (Status status = checkStroke(style); !status.ok())
  {
    return status;
  }
  if (Status status = this->update(geometry, instance, view.threads); !status.ok())
  {
    return status;
  }
  const std::size_t firstEdges = frame.edges.size();
  const std::size_t firstContours = frame.contours.size();
  Finders finders;
  if (kindsOf(property) != 0)
  {
    this->addFeatures(property, data, view, instance, frame);
  }
  if (property->GetSilhouetteLines())
  {
    if (faceBounds_.boxes.empty())
    {
      faceBounds_ = boundFaces(instance.mesh, table_, view.threads);
    }
    finders.add(frame.edges,
      [this, &view, &instance]
      {
        return silhouetteEdges(
          instance.mesh, table_, faceBounds_, view.camera, instance.modelToWorld, view.threads);
      });
  }
  if (property->GetContourLines())
  {
    if (Status status = this->addContours(property, style, view, instance, finders, frame);
        !status.ok())
    {
      return status;
    }
  }
  if (property->GetTerminatorLines())
  {
    if (Status status = this->addTerminators(property, view, instance, frame); !status.ok())
    {
      return status;
    }
  }
  if (wantsCurves(property))
  {
    this->addCurves(property, data, view, instance, finders, frame);
  }
  finders.run(view.threads);
  auto sets = std::make_unique<std::vector<LineSet>>();
  if (property->GetHatchLines())
  {
    if (Status status = this->updateStrokes(property, data, instance, view.threads); !status.ok())
    {
      return status;
    }
    sets->push_back(this->hatchLinesOf(property, view, instance, frame));
    if (Status status = checkStroke(sets->back().style, "HatchWidth times StrokeWidth");
        !status.ok())
    {
      return status;
    }
  }
  for (std::size_t i = firstEdges; i < frame.edges.size(); ++i)
  {
    sets->push_back(frame.edges[i]->chains.lines(instance.mesh, style));
  }
  for (std::size_t i = firstContours; i < frame.contours.size(); ++i)
  {
    sets->push_back(frame.contours[i]->lines(style));
  }
  instance.lines = *sets;
  frame.sets.push_back(std::move(sets));
  return {};
}

} // namespace limn::bridge
