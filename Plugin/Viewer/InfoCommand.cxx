// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "InfoCommand.h"

#include "ColorByArray.h"
#include "LoadMesh.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <algorithm>
#include <iomanip>
#include <iostream>

namespace limn::viewer
{
namespace
{

std::ostream& startLine(const std::string& label)
{
  constexpr int kLabelWidth = 22;
  return std::cout << "  " << std::left << std::setw(kLabelWidth) << label;
}

/// A polygon of n corners is n - 2 triangles, and so is a strip.
vtkIdType trianglesIn(vtkCellArray& cells)
{
  vtkIdType triangles = 0;
  for (vtkIdType i = 0; i < cells.GetNumberOfCells(); ++i)
  {
    triangles += std::max<vtkIdType>(cells.GetCellSize(i) - 2, 0);
  }
  return triangles;
}

std::string nameOf(vtkAbstractArray& array)
{
  return array.GetName() ? array.GetName() : "(no name)";
}

/// "point normals" or what else of the kind there is.
void printAttribute(const std::string& label, vtkPolyData& surface, int attribute)
{
  std::string found;
  if (vtkAbstractArray* array = surface.GetPointData()->GetAbstractAttribute(attribute))
  {
    found = "per point (" + nameOf(*array) + ")";
  }
  if (vtkAbstractArray* array = surface.GetCellData()->GetAbstractAttribute(attribute))
  {
    found += (found.empty() ? "" : ", ") + ("per cell (" + nameOf(*array) + ")");
  }
  startLine(label) << (found.empty() ? "none" : found) << '\n';
}

void printColors(vtkPolyData& surface)
{
  const bool perPoint = areColors(surface.GetPointData()->GetScalars());
  const bool perCell = areColors(surface.GetCellData()->GetScalars());
  startLine("colours") << (perPoint ? "per point" : perCell ? "per cell" : "none") << '\n';
}

void printArrays(const std::string& owner, vtkFieldData& arrays)
{
  for (int i = 0; i < arrays.GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* const array = arrays.GetAbstractArray(i);
    startLine(owner + " array") << nameOf(*array) << ": " << array->GetDataTypeAsString() << ", "
                                << array->GetNumberOfComponents() << " component"
                                << (array->GetNumberOfComponents() == 1 ? "" : "s");
    if (auto* const numbers = vtkDataArray::SafeDownCast(array))
    {
      constexpr int kLength = -1;
      double range[2];
      numbers->GetFiniteRange(range, numbers->GetNumberOfComponents() > 1 ? kLength : 0);
      std::cout << ", " << (numbers->GetNumberOfComponents() > 1 ? "length " : "") << range[0]
                << " to " << range[1];
    }
    std::cout << '\n';
  }
}

void printBounds(vtkPolyData& surface)
{
  if (surface.GetNumberOfPoints() == 0)
  {
    startLine("bounds") << "none\n";
    return;
  }
  const double* const bounds = surface.GetBounds();
  for (int axis = 0; axis < 3; ++axis)
  {
    startLine(axis == 0 ? "bounds" : "")
      << "xyz"[axis] << " from " << bounds[2 * axis] << " to " << bounds[2 * axis + 1] << '\n';
  }
}

void printMesh(const Mesh& mesh)
{
  vtkPolyData& surface = *mesh.surface;
  vtkCellArray& polygons = *surface.GetPolys();
  vtkCellArray& strips = *surface.GetStrips();
  std::cout << mesh.file << '\n';
  startLine("format") << mesh.format << '\n';
  startLine("points") << surface.GetNumberOfPoints() << '\n';
  startLine("polygons") << polygons.GetNumberOfCells() << '\n';
  startLine("strips") << strips.GetNumberOfCells() << '\n';
  startLine("triangles") << trianglesIn(polygons) + trianglesIn(strips) << '\n';
  startLine("lines and vertices") << surface.GetNumberOfLines() + surface.GetNumberOfVerts()
                                  << '\n';
  startLine("non-manifold faces") << mesh.nonManifoldFaces << '\n';
  startLine("dropped faces") << mesh.droppedFaces << '\n';
  printBounds(surface);
  printAttribute("normals", surface, vtkDataSetAttributes::NORMALS);
  printAttribute("texture coordinates", surface, vtkDataSetAttributes::TCOORDS);
  printColors(surface);
  printArrays("point", *surface.GetPointData());
  printArrays("cell", *surface.GetCellData());
}

} // namespace

ExitStatus info(const std::vector<std::string>& meshes)
{
  for (const std::string& file : meshes)
  {
    printMesh(loadMesh(file));
  }
  return ExitSuccess;
}

} // namespace limn::viewer
