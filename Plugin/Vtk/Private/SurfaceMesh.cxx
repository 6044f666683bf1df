// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceMesh.h"

#include "Rendering/Mesh/BuildClusters.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <sstream>

namespace limn::bridge
{
namespace
{

vtkMTimeType timeOf(vtkCellArray* cells)
{
  return std::max({ cells->GetMTime(), cells->GetOffsetsArray()->GetMTime(),
    cells->GetConnectivityArray()->GetMTime() });
}

Span<const Rgba8> colorsOf(vtkUnsignedCharArray* colors)
{
  static_assert(sizeof(Rgba8) == 4, "a colour is four packed bytes");
  return { reinterpret_cast<const Rgba8*>(colors->GetPointer(0)),
    static_cast<std::size_t>(colors->GetNumberOfTuples()) };
}

bool hasArea(const MeshView& mesh, const Triangle& triangle)
{
  const auto [a, b, c] = triangle.vertex;
  const std::size_t vertices = mesh.vertexCount();
  if (a >= vertices || b >= vertices || c >= vertices)
  {
    return false;
  }
  const Vec3d origin = mesh.position(a);
  return !(cross(mesh.position(b) - origin, mesh.position(c) - origin) == Vec3d{ 0, 0, 0 });
}

// Of one surface with several looks, or one that is being chosen.
constexpr std::size_t kMostComputedNormals = 4;

} // namespace

bool NormalChoice::operator==(const NormalChoice& other) const
{
  return fromData == other.fromData && weight == other.weight &&
         featureDegrees == other.featureDegrees;
}

bool SurfaceMesh::CellsVersion::operator==(const CellsVersion& other) const
{
  return polys == other.polys && strips == other.strips && time == other.time &&
         pointCount == other.pointCount && cellCount == other.cellCount;
}

bool SurfaceMesh::PointsVersion::isOfSameArray(const PointsVersion& other) const
{
  return points == other.points && time == other.time && moved == other.moved;
}

bool SurfaceMesh::PointsVersion::operator==(const PointsVersion& other) const
{
  return this->isOfSameArray(other) && dataTime == other.dataTime;
}

// Cells edited in place have to be marked as modified themselves, as for VTK's own mapper.
SurfaceMesh::CellsVersion SurfaceMesh::cellsVersionOf(vtkPolyData* data)
{
  return { data->GetPolys(), data->GetStrips(),
    std::max(timeOf(data->GetPolys()), timeOf(data->GetStrips())), data->GetNumberOfPoints(),
    data->GetNumberOfCells() };
}

SurfaceMesh::PointsVersion SurfaceMesh::pointsVersionOf(vtkPolyData* data) const
{
  vtkPoints* const points = data->GetPoints();
  return { points->GetData(), std::max(points->GetMTime(), points->GetData()->GetMTime()),
    data->vtkObject::GetMTime(), moved_->version() };
}

Status SurfaceMesh::updateGeometry(vtkPolyData* data, int threads)
{
  const CellsVersion cells = cellsVersionOf(data);
  const PointsVersion points = this->pointsVersionOf(data);
  const bool sameCells = cells == cellsVersion_ && buildStatus_.ok();
  if (sameCells && points == pointsVersion_)
  {
    return buildStatus_;
  }
  points_.set(data->GetPoints()->GetData());
  // Filters hand on points and cells as they are in a data set that they modify.
  if (sameCells && points.isOfSameArray(pointsVersion_) &&
      areInPlace(this->view(), threads, clusters_))
  {
    pointsVersion_ = points;
    return buildStatus_;
  }
  cellsVersion_ = cells;
  pointsVersion_ = points;
  ++geometryChanges_;
  computed_.clear();
  normals_.reset();
  smoothed_.clear();
  smooth_.reset();
  faces_ = {};
  hull_ = {};
  hasHull_ = false;
  firstCorners_ = std::vector<Vec3d>();
  if (sameCells && !this->isRebuildDue() && refitClusters(this->view(), threads, clusters_))
  {
    ++geometryMoves_;
    return {};
  }
  return this->rebuild(data, threads);
}

bool SurfaceMesh::isRebuildDue()
{
  if (!areInDisorder(clusters_))
  {
    movesToWait_ = 1;
    movesLeft_ = 1;
    return false;
  }
  if (--movesLeft_ > 0)
  {
    return false;
  }
  movesToWait_ *= 2;
  movesLeft_ = movesToWait_;
  return true;
}

Status SurfaceMesh::update(
  vtkPolyData* data, const MovedPoints& moved, const SurfaceNeeds& needs, int threads)
{
  moved_ = &moved;
  buildStatus_ = this->updateGeometry(data, threads);
  if (!buildStatus_.ok())
  {
    return buildStatus_;
  }
  this->updateNormals(data, threads);
  return this->supply(data, needs, threads);
}

bool SurfaceMesh::isKept(const NormalChoice& choice) const
{
  return std::any_of(
    computed_.begin(), computed_.end(), [&](const Computed& one) { return one.choice == choice; });
}

Status SurfaceMesh::computeNormals(const NormalChoice& choice, int threads)
{
  auto normals = std::make_shared<SplitNormals>();
  if (choice.featureDegrees < 180)
  {
    const Status status = splitVertexNormals(
      this->view(), surface_.cells, choice.weight, choice.featureDegrees, threads, *normals);
    if (!status.ok())
    {
      return status;
    }
  }
  else
  {
    normals->normals = limn::vertexNormals(this->view(), choice.weight);
  }
  if (computed_.size() == kMostComputedNormals)
  {
    computed_.erase(computed_.begin());
  }
  computed_.push_back({ choice, std::move(normals) });
  return {};
}

bool SurfaceMesh::SmoothVersion::operator==(const SmoothVersion& other) const
{
  return scales == other.scales && normals == other.normals && time == other.time;
}

SurfaceMesh::SmoothVersion SurfaceMesh::smoothVersionOf(
  vtkPolyData* data, const SurfaceNeeds& needs) const
{
  vtkDataArray* const array = data->GetPointData()->GetNormals();
  const bool isGiven = needs.normals.fromData && !this->givenNormals().empty();
  return { needs.smoothScales, isGiven ? this->givenNormals().data() : nullptr,
    isGiven && array ? array->GetMTime() : 0 };
}

bool SurfaceMesh::isKept(const SmoothVersion& version) const
{
  return std::any_of(smoothed_.begin(), smoothed_.end(),
    [&](const Smoothed& one) { return one.version == version; });
}

Status SurfaceMesh::computeSmoothNormals(const SmoothVersion& version, int threads)
{
  auto smooth = std::make_shared<SmoothNormals>();
  const Span<const Vec3f> given = version.normals ? this->givenNormals() : Span<const Vec3f>();
  if (const Status status = limn::smoothNormals(
        { this->view(), given, surface_.cells }, version.scales, threads, *smooth);
      !status.ok())
  {
    return status;
  }
  if (smoothed_.size() == kMostComputedNormals)
  {
    smoothed_.erase(smoothed_.begin());
  }
  smoothed_.push_back({ version, std::move(smooth) });
  return {};
}

Status SurfaceMesh::supplySmoothNormals(vtkPolyData* data, const SurfaceNeeds& needs, int threads)
{
  smooth_.reset();
  if (!needs.smoothNormals)
  {
    return {};
  }
  const SmoothVersion version = this->smoothVersionOf(data, needs);
  if (!this->isKept(version))
  {
    this->keepTriangles(data, threads);
    if (const Status status = this->computeSmoothNormals(version, threads); !status.ok())
    {
      return status;
    }
  }
  const auto chosen = std::find_if(smoothed_.begin(), smoothed_.end(),
    [&](const Smoothed& one) { return one.version == version; });
  std::rotate(chosen, chosen + 1, smoothed_.end());
  smooth_ = smoothed_.back().normals;
  return {};
}

Status SurfaceMesh::supplyNormals(vtkPolyData* data, const SurfaceNeeds& needs, int threads)
{
  normals_.reset();
  // Points that were moved without their normals need new ones.
  const bool readsNormals = needs.vertexNormals || (this->isMoved() && this->hasPointNormals());
  if (!readsNormals || (needs.normals.fromData && !this->givenNormals().empty()))
  {
    return {};
  }
  NormalChoice choice = needs.normals;
  if (smooth_ && !smooth_->ofCorner.empty())
  {
    // Else what runs over an edge in these alone would show as detail.
    choice.featureDegrees = std::min(choice.featureDegrees, needs.smoothScales.creaseDegrees);
  }
  if (!this->isKept(choice))
  {
    this->keepTriangles(data, threads);
    if (const Status status = this->computeNormals(choice, threads); !status.ok())
    {
      return status;
    }
  }
  const auto chosen = std::find_if(
    computed_.begin(), computed_.end(), [&](const Computed& one) { return one.choice == choice; });
  std::rotate(chosen, chosen + 1, computed_.end());
  normals_ = computed_.back().normals;
  return {};
}

void SurfaceMesh::keepTriangles(vtkPolyData* data, int threads)
{
  if (surface_.triangles.empty() && !this->isEmpty())
  {
    surface_ = trianglesFromPolyData(data, threads);
  }
}

Status SurfaceMesh::supply(vtkPolyData* data, const SurfaceNeeds& needs, int threads)
{
  const bool lacksFaces = needs.faceGeometry && faces_.centroid.empty();
  const bool lacksCorners = needs.firstCorners && firstCorners_.empty();
  const bool keepsTriangles = needs.triangles || needs.hull;
  if (lacksFaces || lacksCorners || keepsTriangles)
  {
    this->keepTriangles(data, threads);
  }
  if (const Status status = this->supplySmoothNormals(data, needs, threads); !status.ok())
  {
    return status;
  }
  if (const Status status = this->supplyNormals(data, needs, threads); !status.ok())
  {
    return status;
  }
  if (lacksFaces)
  {
    faces_ = faceGeometry(this->view(), surface_.cells, cellCount_);
  }
  if (lacksCorners)
  {
    firstCorners_ = limn::firstCorners(this->view(), surface_.cells, cellCount_);
  }
  isLitAtFirstCorners_ = needs.firstCorners;
  if (needs.hull && !hasHull_)
  {
    if (const Status status = buildHullEdges(this->view(), threads, hull_); !status.ok())
    {
      return status;
    }
    hasHull_ = true;
  }
  if (!keepsTriangles && !this->isMoved())
  {
    // The pipeline reads clusters only, and of a large mesh these are hundreds of megabytes, which
    // an empty list of initializers would keep.
    surface_.triangles = Array<Triangle>();
  }
  return {};
}

Status SurfaceMesh::rebuild(vtkPolyData* data, int threads)
{
  ++geometryBuilds_;
  surface_ = trianglesFromPolyData(data, threads);
  cellCount_ = static_cast<std::size_t>(data->GetNumberOfCells());
  const MeshView mesh = this->view();
  isFlattened_ = data->GetNumberOfPolys() + data->GetNumberOfStrips() > 0 &&
                 std::none_of(surface_.triangles.begin(), surface_.triangles.end(),
                   [&mesh](const Triangle& triangle) { return hasArea(mesh, triangle); });
  clusters_ = {};
  return buildClusters(this->view(), threads, clusters_);
}

void SurfaceMesh::updateNormals(vtkPolyData* data, int threads)
{
  pointNormals_.update(data->GetPointData()->GetNormals(), data->GetNumberOfPoints());
  cellNormals_.update(data->GetCellData()->GetNormals(), data->GetNumberOfCells());
  usablePointNormals_.look(this->isMoved() ? moved_->normals() : pointNormals_.span(),
    this->isMoved() ? moved_->version() : pointNormals_.time(), threads);
  if (usablePointNormals_.lacksOwn(geometryChanges_))
  {
    this->keepTriangles(data, threads);
    usablePointNormals_.replace(
      limn::vertexNormals(this->view(), NormalWeight::kArea), geometryChanges_);
  }
  usableCellNormals_.look(cellNormals_.span(), cellNormals_.time(), threads);
  if (usableCellNormals_.lacksOwn(geometryChanges_))
  {
    this->keepTriangles(data, threads);
    usableCellNormals_.replace(
      faceGeometry(this->view(), surface_.cells, cellCount_).normal, geometryChanges_);
  }
}

SurfaceMesh::UnusableCount SurfaceMesh::unusablePointNormals() const
{
  return { usablePointNormals_.replaced(), pointNormals_.time() };
}

SurfaceMesh::UnusableCount SurfaceMesh::unusableCellNormals() const
{
  return { this->isMoved() ? 0 : usableCellNormals_.replaced(), cellNormals_.time() };
}

MeshView SurfaceMesh::view() const
{
  if (this->isMoved())
  {
    return moved_->view(surface_.triangles);
  }
  MeshView mesh = points_.view();
  mesh.triangles = surface_.triangles;
  return mesh;
}

Span<const Vec3f> SurfaceMesh::givenNormals() const
{
  return usablePointNormals_.span();
}

Span<const Vec3f> SurfaceMesh::cellNormals() const
{
  return this->isMoved() ? Span<const Vec3f>() : usableCellNormals_.span();
}

void SurfaceMesh::setColors(vtkUnsignedCharArray* colors, int cellFlag)
{
  const std::size_t expected = cellFlag == 0 ? points_.view().vertexCount() : cellCount_;
  const bool fits = colors && colors->GetNumberOfComponents() == 4 &&
                    static_cast<std::size_t>(colors->GetNumberOfTuples()) == expected;
  colors_ = fits ? colors : nullptr;
  colorCellFlag_ = cellFlag;
}

void SurfaceMesh::describe(Instance& instance) const
{
  instance.clusters = &clusters_;
  instance.mesh = this->view();
  Attributes& attributes = instance.attributes;
  attributes.vertexNormals = this->givenNormals();
  if (normals_)
  {
    attributes.vertexNormals = normals_->normals;
    attributes.normalOfCorner = normals_->ofCorner;
  }
  if (smooth_)
  {
    attributes.smoothNormals = smooth_->packed;
    attributes.smoothOfCorner = smooth_->ofCorner;
    attributes.smoothCount = smooth_->count();
    attributes.smoothLevels = smooth_->levels;
    attributes.smoothRatio = smooth_->ratio;
  }
  attributes.cellNormals = this->cellNormals();
  if (colors_)
  {
    (colorCellFlag_ == 0 ? attributes.vertexColors : attributes.cellColors) = colorsOf(colors_);
  }
  attributes.facePoints = isLitAtFirstCorners_ ? firstCorners_ : faces_.centroid;
  attributes.faceNormals = faces_.normal;
  attributes.cells = surface_.cells;
  attributes.cellCount = cellCount_;
}

void SurfaceMesh::describeHull(Instance& instance) const
{
  instance.hull = &hull_;
  instance.mesh = this->view();
  instance.attributes.cells = surface_.cells;
  instance.attributes.cellCount = cellCount_;
}

std::string SurfaceMesh::complaint() const
{
  std::ostringstream text;
  text << moved_->complaint();
  if (clusters_.notFiniteTriangles > 0)
  {
    text << " " << clusters_.notFiniteTriangles
         << " triangles use a point with a coordinate that is not a finite number.";
  }
  if (clusters_.outOfRangeTriangles > 0)
  {
    text << " " << clusters_.outOfRangeTriangles << " triangles name a point that does not exist.";
  }
  if (surface_.malformedCells > 0)
  {
    text << " " << surface_.malformedCells << " cells reach beyond the cell array.";
  }
  return text.str();
}

} // namespace limn::bridge
