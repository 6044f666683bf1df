// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LoadMesh.h"

#include "Messages.h"
#include "ParseValue.h"
#include "ProgressLine.h"
#include "UserError.h"

#include "vtkLimnMeshReader.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkDataSetReader.h>
#include <vtkDataSetSurfaceFilter.h>
#include <vtkGenericCell.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>

namespace limn::viewer
{
namespace
{

template <typename Reader>
vtkSmartPointer<vtkDataSet> update(Reader& reader, const std::string& file)
{
  reader.SetFileName(file.c_str());
  {
    const ProgressLine progress(reader, "reading " + file);
    reader.Update();
  }
  throwCollectedErrors(file);
  return vtkDataSet::SafeDownCast(reader.GetOutputDataObject(0));
}

struct Content
{
  vtkSmartPointer<vtkDataSet> data;
  vtkIdType nonManifoldFaces = 0, droppedFaces = 0;
};

template <typename Reader>
Content readWith(const std::string& file)
{
  vtkNew<Reader> reader;
  return { update(*reader, file) };
}

Content readPolygons(const std::string& file)
{
  vtkNew<vtkLimnMeshReader> reader;
  const auto data = update(*reader, file);
  return { data, reader->GetNumberOfNonManifoldFaces(), reader->GetNumberOfDroppedFaces() };
}

using ReadFile = Content (*)(const std::string& file);

const std::map<std::string, ReadFile>& readers()
{
  static const std::map<std::string, ReadFile> byFormat = {
    { "OBJ", readPolygons },
    { "OFF", readPolygons },
    { "OM", readPolygons },
    { "PLY", readPolygons },
    { "STL", readPolygons },
    { "VTK", readWith<vtkDataSetReader> },
    { "VTP", readWith<vtkXMLPolyDataReader> },
    { "VTU", readWith<vtkXMLUnstructuredGridReader> },
  };
  return byFormat;
}

/// "OBJ" of "a/teapot.obj".
std::string formatOf(const std::string& file)
{
  const std::string extension = std::filesystem::path(file).extension().string();
  std::string format = extension.empty() ? extension : extension.substr(1);
  std::transform(format.begin(), format.end(), format.begin(),
    [](unsigned char letter) { return static_cast<char>(std::toupper(letter)); });
  return format;
}

ReadFile readerOf(const std::string& file)
{
  const auto reader = readers().find(formatOf(file));
  if (reader != readers().end())
  {
    return reader->second;
  }
  std::vector<std::string> extensions;
  for (const auto& [format, read] : readers())
  {
    extensions.push_back("." + format);
    for (char& letter : extensions.back())
    {
      letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    }
  }
  throw UserError(
    file + ": unknown mesh format; the file's name must end in one of: " + joinWords(extensions));
}

void requireReadable(const std::string& file)
{
  if (std::filesystem::is_directory(file))
  {
    throw UserError(file + " is a directory; name a mesh file in it");
  }
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream)
  {
    throw UserError("cannot read " + file + ": " + std::strerror(errno));
  }
  if (stream.peek() == std::ifstream::traits_type::eof())
  {
    throw UserError(file + " is empty");
  }
}

void requireFinitePoints(const std::string& file, vtkPointSet& mesh)
{
  const vtkIdType count = mesh.GetNumberOfPoints();
  for (vtkIdType i = 0; i < count; ++i)
  {
    double point[3];
    mesh.GetPoint(i, point);
    if (!std::all_of(point, point + 3, [](double value) { return std::isfinite(value); }))
    {
      throw UserError(file + ": point " + std::to_string(i) +
                      " has a coordinate that is NaN or infinite; mend the file");
    }
  }
}

[[noreturn]] void refuseCells(const std::string& file, const std::string& fault)
{
  throw UserError(file + ": " + fault + "; mend the file");
}

/// VTK's filters read out of bounds where a cell names a point that does not exist.
void requirePointsOf(const std::string& file, vtkCellArray* cells, vtkIdType pointCount)
{
  if (!cells)
  {
    return;
  }
  if (!cells->IsValid())
  {
    refuseCells(file, "the offsets of the cells do not rise from 0 to the number of their points");
  }
  const auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    iterator->GetCurrentCell(size, points);
    const auto* const missing = std::find_if(points, points + size,
      [pointCount](vtkIdType point) { return point < 0 || point >= pointCount; });
    if (missing != points + size)
    {
      refuseCells(file, "a cell names point " + std::to_string(*missing) + ", but there are " +
                          std::to_string(pointCount) + " points");
    }
  }
}

/// How many points a cell of this type has at least. Throws UserError if there is no such type.
vtkIdType pointsOfType(const std::string& file, int type)
{
  const auto cell = vtk::TakeSmartPointer(vtkGenericCell::InstantiateCell(type));
  if (!cell)
  {
    refuseCells(file, "there is no cell type " + std::to_string(type));
  }
  return cell->GetNumberOfPoints();
}

void requireCellSizes(const std::string& file, vtkUnstructuredGrid& grid)
{
  std::map<int, vtkIdType> smallestSizes;
  for (vtkIdType i = 0; i < grid.GetNumberOfCells(); ++i)
  {
    const int type = grid.GetCellType(i);
    const auto known = smallestSizes.find(type);
    const vtkIdType smallest =
      known != smallestSizes.end()
        ? known->second
        : smallestSizes.emplace(type, pointsOfType(file, type)).first->second;
    if (grid.GetCells()->GetCellSize(i) < smallest)
    {
      refuseCells(file, "cell " + std::to_string(i) + " of type " + std::to_string(type) +
                          " has fewer than " + std::to_string(smallest) + " points");
    }
  }
}

void requireValid(const std::string& file, vtkDataSet& mesh)
{
  const vtkIdType points = mesh.GetNumberOfPoints();
  if (auto* const pointSet = vtkPointSet::SafeDownCast(&mesh))
  {
    requireFinitePoints(file, *pointSet);
  }
  if (auto* const surface = vtkPolyData::SafeDownCast(&mesh))
  {
    requirePointsOf(file, surface->GetPolys(), points);
    requirePointsOf(file, surface->GetStrips(), points);
    requirePointsOf(file, surface->GetLines(), points);
    requirePointsOf(file, surface->GetVerts(), points);
  }
  if (auto* const grid = vtkUnstructuredGrid::SafeDownCast(&mesh))
  {
    requirePointsOf(file, grid->GetCells(), points);
    requireCellSizes(file, *grid);
  }
}

vtkSmartPointer<vtkPolyData> surfaceOf(const std::string& file, vtkDataSet& mesh)
{
  if (auto* const surface = vtkPolyData::SafeDownCast(&mesh))
  {
    return surface;
  }
  vtkNew<vtkDataSetSurfaceFilter> filter;
  // The filter that this one would delegate to orders its output by the scheduling of its threads.
  filter->DelegationOff();
  filter->SetInputData(&mesh);
  filter->Update();
  throwCollectedErrors(file);
  return filter->GetOutput();
}

} // namespace

Mesh loadMesh(const std::string& file)
{
  const ReadFile read = readerOf(file);
  requireReadable(file);
  const Content content = read(file);
  if (!content.data)
  {
    throw UserError(file + " holds no mesh; save it as one of VTK's data sets");
  }
  requireValid(file, *content.data);
  return { file, formatOf(file), surfaceOf(file, *content.data), content.nonManifoldFaces,
    content.droppedFaces };
}

std::vector<Mesh> loadMeshes(const std::vector<std::string>& files)
{
  std::vector<Mesh> meshes;
  for (const std::string& file : files)
  {
    meshes.push_back(loadMesh(file));
  }
  return meshes;
}

} // namespace limn::viewer
