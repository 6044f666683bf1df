// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TrianglesFromPolyData.h"

#include "Rendering/Base/Executor.h"

#include "vtkCellArray.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <atomic>

namespace limn::bridge
{
namespace
{

constexpr std::uint32_t kNoVertex = 0xFFFFFFFFu;

/// Numbers of points, checked.
class PointNumbers
{
public:
  explicit PointNumbers(std::size_t count) : count_(count) {}

  template <class Id>
  std::uint32_t vertex(Id id) const
  {
    const bool exists = id >= 0 && static_cast<std::size_t>(id) < count_;
    return exists ? static_cast<std::uint32_t>(id) : kNoVertex;
  }

private:
  std::size_t count_;
};

class TriangleCutter
{
public:
  TriangleCutter(PointNumbers points, SurfaceTriangles& out) : points_(points), out_(out) {}

  template <class Id>
  void addFan(const Id* ids, std::size_t count, std::uint32_t cell)
  {
    for (std::size_t i = 2; i < count; ++i)
    {
      this->add({ { this->vertex(ids[0]), this->vertex(ids[i - 1]), this->vertex(ids[i]) } }, cell);
    }
  }

  template <class Id>
  void addStrip(const Id* ids, std::size_t count, std::uint32_t cell)
  {
    for (std::size_t i = 2; i < count; ++i)
    {
      // Every second triangle of a strip runs the other way round.
      const std::size_t odd = i % 2;
      this->add({ { this->vertex(ids[i - 2]), this->vertex(ids[i - 1 + odd]),
                  this->vertex(ids[i - odd]) } },
        cell);
    }
  }

private:
  template <class Id>
  std::uint32_t vertex(Id id) const
  {
    return points_.vertex(id);
  }

  void add(Triangle t, std::uint32_t cell)
  {
    out_.triangles.push_back(t);
    out_.cells.push_back(cell);
  }

  PointNumbers points_;
  SurfaceTriangles& out_;
};

/// Calls visit(ids of the cell's points, their number, number of the cell in the array).
template <class Offsets, class Connectivity, class Visit>
std::size_t forEachCell(const Offsets& offsets, const Connectivity& connectivity, Visit visit)
{
  const auto* const ids = connectivity->GetPointer(0);
  const vtkIdType idCount = connectivity->GetNumberOfValues();
  const auto* const offset = offsets->GetPointer(0);
  const vtkIdType cells = offsets->GetNumberOfValues() - 1;
  std::size_t malformed = 0;
  for (vtkIdType cell = 0; cell < cells; ++cell)
  {
    const vtkIdType first = offset[cell];
    const vtkIdType last = offset[cell + 1];
    if (first < 0 || last < first || last > idCount)
    {
      ++malformed;
      continue;
    }
    visit(ids + first, static_cast<std::size_t>(last - first), cell);
  }
  return malformed;
}

template <class Visit>
std::size_t forEachCell(vtkCellArray* cells, Visit visit)
{
  return cells->IsStorage64Bit()
           ? forEachCell(cells->GetOffsetsArray64(), cells->GetConnectivityArray64(), visit)
           : forEachCell(cells->GetOffsetsArray32(), cells->GetConnectivityArray32(), visit);
}

/// The common case: nothing but triangles, none of them left out, and cell t is triangle t. False,
/// with `triangles` spoilt, if it is another.
template <class Offsets, class Connectivity>
bool copyPlainTriangles(const Offsets& offsets, const Connectivity& connectivity,
  PointNumbers points, int threads, Array<Triangle>& triangles)
{
  constexpr std::size_t kChunk = 1 << 16;
  const auto cells = static_cast<std::size_t>(offsets->GetNumberOfValues() - 1);
  if (connectivity->GetNumberOfValues() != static_cast<vtkIdType>(3 * cells))
  {
    return false;
  }
  const auto* const ids = connectivity->GetPointer(0);
  const auto* const offset = offsets->GetPointer(0);
  triangles.resize(cells);
  std::atomic<bool> plain = true;
  parallelFor(threads, (cells + kChunk - 1) / kChunk,
    [&](std::size_t chunk)
    {
      for (std::size_t t = chunk * kChunk; t < std::min(cells, (chunk + 1) * kChunk); ++t)
      {
        triangles[t] = { { points.vertex(ids[3 * t]), points.vertex(ids[3 * t + 1]),
          points.vertex(ids[3 * t + 2]) } };
        const bool isPlain = offset[t] == static_cast<vtkIdType>(3 * t) &&
                             offset[t + 1] == static_cast<vtkIdType>(3 * t + 3);
        if (!isPlain)
        {
          plain = false;
          return;
        }
      }
    });
  return plain;
}

bool copyPlainTriangles(
  vtkPolyData* data, PointNumbers points, int threads, Array<Triangle>& triangles)
{
  vtkCellArray* const polys = data->GetPolys();
  if (polys->GetNumberOfCells() == 0 || polys->GetNumberOfCells() != data->GetNumberOfCells())
  {
    return false;
  }
  return polys->IsStorage64Bit() ? copyPlainTriangles(polys->GetOffsetsArray64(),
                                     polys->GetConnectivityArray64(), points, threads, triangles)
                                 : copyPlainTriangles(polys->GetOffsetsArray32(),
                                     polys->GetConnectivityArray32(), points, threads, triangles);
}

bool isIdentity(const std::vector<std::uint32_t>& cells, vtkIdType cellCount)
{
  if (static_cast<vtkIdType>(cells.size()) != cellCount)
  {
    return false;
  }
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    if (cells[i] != i)
    {
      return false;
    }
  }
  return true;
}

} // namespace

SurfaceTriangles trianglesFromPolyData(vtkPolyData* data, int threads)
{
  const PointNumbers points(static_cast<std::size_t>(data->GetNumberOfPoints()));
  SurfaceTriangles surface;
  if (copyPlainTriangles(data, points, threads, surface.triangles))
  {
    return surface;
  }
  surface.triangles.clear();
  TriangleCutter cutter(points, surface);
  vtkCellArray* const polys = data->GetPolys();
  vtkCellArray* const strips = data->GetStrips();
  // A polygon of no points makes less than none.
  const auto expected = static_cast<std::size_t>(
    std::max<vtkIdType>(polys->GetNumberOfConnectivityIds() - 2 * polys->GetNumberOfCells() +
                          strips->GetNumberOfConnectivityIds(),
      0));
  surface.triangles.reserve(expected);
  surface.cells.reserve(expected);

  // VTK numbers the cells of a vtkPolyData in this order: vertices, lines, polygons, strips.
  const vtkIdType firstPoly = data->GetNumberOfVerts() + data->GetNumberOfLines();
  const vtkIdType firstStrip = firstPoly + polys->GetNumberOfCells();
  surface.malformedCells =
    forEachCell(polys, [&](const auto* ids, std::size_t count, vtkIdType cell)
      { cutter.addFan(ids, count, static_cast<std::uint32_t>(firstPoly + cell)); });
  surface.malformedCells +=
    forEachCell(strips, [&](const auto* ids, std::size_t count, vtkIdType cell)
      { cutter.addStrip(ids, count, static_cast<std::uint32_t>(firstStrip + cell)); });
  if (isIdentity(surface.cells, data->GetNumberOfCells()))
  {
    surface.cells = std::vector<std::uint32_t>();
  }
  return surface;
}

} // namespace limn::bridge
