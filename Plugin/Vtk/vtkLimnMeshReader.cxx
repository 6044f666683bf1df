// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLimnMeshReader.h"

#include "Rendering/Mesh/Io/ReadMesh.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>

vtkStandardNewMacro(vtkLimnMeshReader);

namespace
{

/// Copies tuples that lie packed in memory; `Array` holds their scalar type.
template <typename Array, typename Tuple>
void CopyTuples(const std::vector<Tuple>& tuples, Array* array, const char* name)
{
  using Scalar = typename Array::ValueType;
  static_assert(sizeof(Tuple) % sizeof(Scalar) == 0, "tuples have no padding");
  array->SetName(name);
  array->SetNumberOfComponents(static_cast<int>(sizeof(Tuple) / sizeof(Scalar)));
  array->SetNumberOfTuples(static_cast<vtkIdType>(tuples.size()));
  std::memcpy(array->GetPointer(0), tuples.data(), tuples.size() * sizeof(Tuple));
}

void AddPoints(const limn::MeshFile& mesh, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  if (mesh.precisePositions.empty())
  {
    vtkNew<vtkFloatArray> coordinates;
    CopyTuples(mesh.positions, coordinates.Get(), "Points");
    points->SetData(coordinates);
  }
  else
  {
    vtkNew<vtkDoubleArray> coordinates;
    CopyTuples(mesh.precisePositions, coordinates.Get(), "Points");
    points->SetData(coordinates);
  }
  output->SetPoints(points);
}

void AddPolygons(const limn::MeshFile& mesh, vtkPolyData* output)
{
  vtkNew<vtkTypeInt64Array> offsets;
  offsets->SetNumberOfValues(static_cast<vtkIdType>(mesh.polygonOffsets.size()));
  std::copy(mesh.polygonOffsets.begin(), mesh.polygonOffsets.end(), offsets->GetPointer(0));
  vtkNew<vtkTypeInt64Array> corners;
  corners->SetNumberOfValues(static_cast<vtkIdType>(mesh.polygonCorners.size()));
  std::copy(mesh.polygonCorners.begin(), mesh.polygonCorners.end(), corners->GetPointer(0));
  vtkNew<vtkCellArray> polygons;
  polygons->SetData(offsets, corners);
  output->SetPolys(polygons);
}

void AddColors(const std::vector<limn::Rgba8>& values, vtkDataSetAttributes* attributes)
{
  if (values.empty())
  {
    return;
  }
  vtkNew<vtkUnsignedCharArray> colors;
  CopyTuples(values, colors.Get(), "Colors");
  attributes->SetScalars(colors);
}

void AddAttributes(const limn::MeshFile& mesh, vtkPolyData* output)
{
  if (!mesh.normals.empty())
  {
    vtkNew<vtkFloatArray> normals;
    CopyTuples(mesh.normals, normals.Get(), "Normals");
    output->GetPointData()->SetNormals(normals);
  }
  if (!mesh.texCoords.empty())
  {
    vtkNew<vtkFloatArray> texCoords;
    CopyTuples(mesh.texCoords, texCoords.Get(), "TCoords");
    output->GetPointData()->SetTCoords(texCoords);
  }
  AddColors(mesh.vertexColors, output->GetPointData());
  AddColors(mesh.faceColors, output->GetCellData());
}

unsigned long ErrorCodeOf(const char* fileName)
{
  std::error_code ignored;
  if (!std::filesystem::exists(fileName, ignored))
  {
    return vtkErrorCode::FileNotFoundError;
  }
  if (!limn::isMeshFileName(fileName))
  {
    return vtkErrorCode::UnrecognizedFileTypeError;
  }
  if (!std::filesystem::is_regular_file(fileName, ignored) || !std::ifstream(fileName))
  {
    return vtkErrorCode::CannotOpenFileError;
  }
  return vtkErrorCode::FileFormatError;
}

} // namespace

//------------------------------------------------------------------------------
vtkLimnMeshReader::vtkLimnMeshReader()
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
vtkLimnMeshReader::~vtkLimnMeshReader()
{
  this->SetFileName(nullptr);
}

//------------------------------------------------------------------------------
int vtkLimnMeshReader::CanReadFile(const char* fileName)
{
  std::error_code ignored;
  const bool canRead = fileName && limn::isMeshFileName(fileName) &&
                       std::filesystem::is_regular_file(fileName, ignored);
  return canRead ? 1 : 0;
}

//------------------------------------------------------------------------------
int vtkLimnMeshReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkPolyData* const output = vtkPolyData::GetData(outputVector);
  this->NumberOfNonManifoldFaces = 0;
  this->NumberOfDroppedFaces = 0;
  this->SetErrorCode(vtkErrorCode::NoError);
  if (!this->FileName || !*this->FileName)
  {
    vtkErrorMacro("No mesh to read: call SetFileName() first.");
    this->SetErrorCode(vtkErrorCode::NoFileNameError);
    return 0;
  }

  limn::MeshFile mesh;
  const limn::Status status = limn::readMesh(this->FileName, mesh,
    [this](double fraction)
    {
      this->UpdateProgress(fraction);
      return !this->GetAbortExecute();
    });
  if (this->GetAbortExecute())
  {
    return 1;
  }
  if (!status.ok())
  {
    vtkErrorMacro(<< status.message);
    this->SetErrorCode(ErrorCodeOf(this->FileName));
    return 0;
  }

  AddPoints(mesh, output);
  AddPolygons(mesh, output);
  AddAttributes(mesh, output);
  this->NumberOfNonManifoldFaces = static_cast<vtkIdType>(mesh.nonManifoldFaces);
  this->NumberOfDroppedFaces = static_cast<vtkIdType>(mesh.droppedFaces);
  this->WarnAboutFaces(output->GetNumberOfPolys());
  return 1;
}

//------------------------------------------------------------------------------
void vtkLimnMeshReader::WarnAboutFaces(vtkIdType numberOfFaces)
{
  const vtkIdType dropped = this->NumberOfDroppedFaces;
  const vtkIdType nonManifold = this->NumberOfNonManifoldFaces;
  if (numberOfFaces == 0 && dropped == 0)
  {
    vtkWarningMacro(<< this->FileName << ": the mesh has points only and no faces.");
  }
  else if (numberOfFaces == 0)
  {
    vtkWarningMacro(<< this->FileName << ": no face has three different points or more; only the"
                    << " points are left.");
  }
  else if (dropped > 0)
  {
    vtkWarningMacro(<< this->FileName << ": " << dropped
                    << (dropped == 1
                           ? " face has fewer than three different points and is left out."
                           : " faces have fewer than three different points and are left"
                             " out."));
  }
  if (nonManifold > 0)
  {
    vtkWarningMacro(<< this->FileName << ": " << nonManifold
                    << (nonManifold == 1
                           ? " face is non-manifold or wound against its neighbours; it is kept."
                           : " faces are non-manifold or wound against their neighbours; they are"
                             " kept."));
  }
}

//------------------------------------------------------------------------------
void vtkLimnMeshReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "NumberOfNonManifoldFaces: " << this->NumberOfNonManifoldFaces << "\n";
  os << indent << "NumberOfDroppedFaces: " << this->NumberOfDroppedFaces << "\n";
}
