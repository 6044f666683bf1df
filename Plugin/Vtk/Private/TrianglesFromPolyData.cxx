// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TrianglesFromPolyData.h"

#include "vtkCellArray.h"
#include "vtkPolyData.h"

namespace limn::bridge
{
namespace
{

constexpr std::uint32_t kNoVertex = 0xFFFFFFFFu;

class TriangleCutter
{
public:
  TriangleCutter(const MeshView& points, SurfaceTriangles& out) : points_(points), out_(out) {}

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
    const bool exists = id >= 0 && static_cast<std::size_t>(id) < points_.vertexCount();
    return exists ? static_cast<std::uint32_t>(id) : kNoVertex;
  }

  bool coincide(std::uint32_t a, std::uint32_t b) const
  {
    return a == b ||
           (a != kNoVertex && b != kNoVertex && points_.position(a) == points_.position(b));
  }

  void add(Triangle t, std::uint32_t cell)
  {
    const bool exists =
      t.vertex[0] != kNoVertex && t.vertex[1] != kNoVertex && t.vertex[2] != kNoVertex;
    if (exists &&
        (this->coincide(t.vertex[0], t.vertex[1]) || this->coincide(t.vertex[1], t.vertex[2]) ||
          this->coincide(t.vertex[2], t.vertex[0])))
    {
      return;
    }
    out_.triangles.push_back(t);
    out_.cells.push_back(cell);
  }

  const MeshView& points_;
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

SurfaceTriangles trianglesFromPolyData(vtkPolyData* data, const MeshView& points)
{
  SurfaceTriangles surface;
  TriangleCutter cutter(points, surface);
  vtkCellArray* const polys = data->GetPolys();
  vtkCellArray* const strips = data->GetStrips();
  const std::size_t expected =
    static_cast<std::size_t>(polys->GetNumberOfConnectivityIds() - 2 * polys->GetNumberOfCells() +
                             strips->GetNumberOfConnectivityIds());
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
    surface.cells = {};
  }
  return surface;
}

} // namespace limn::bridge
