// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLimnMeshReader
 * @brief   reads OBJ, OFF, PLY, STL and OM files
 *
 * vtkLimnMeshReader reads polygon meshes through OpenMesh's parsers. It keeps polygons of any size
 * and non-manifold ones; see GetNumberOfNonManifoldFaces() and GetNumberOfDroppedFaces(). The
 * format is recognised by the extension of the file name.
 *
 * The output has points (double only where float would lose the shape), polygons, and where the
 * file has them: point normals called "Normals", texture coordinates called "TCoords", and colours
 * called "Colors", unsigned char RGBA, as the active scalars of the points or the cells. Where
 * vertices and faces have colours, those of the faces are the cells' active scalars.
 *
 * A file that cannot be read gives an error with the place of the fault, the error code (see
 * vtkErrorCode) and an empty output. Dropped and non-manifold faces give a warning, and so does a
 * mesh without faces. Progress events are sent while reading; an observer that sets AbortExecute
 * stops it, with an empty output.
 *
 * @sa
 * vtkOBJReader vtkPLYReader vtkSTLReader
 */

#ifndef vtkLimnMeshReader_h
#define vtkLimnMeshReader_h

#include "vtkLimnModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

class VTKLIMN_EXPORT vtkLimnMeshReader : public vtkPolyDataAlgorithm
{
public:
  static vtkLimnMeshReader* New();
  vtkTypeMacro(vtkLimnMeshReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file to read. Default: none.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /**
   * Whether the file exists and has an extension that this class knows: 1 or 0. The content is
   * checked while reading only.
   */
  static int CanReadFile(VTK_FILEPATH const char* fileName);

  ///@{
  /**
   * Of the file read last: faces that share a directed edge with one before them, which are kept,
   * and faces with fewer than three different points, which are left out.
   */
  vtkGetMacro(NumberOfNonManifoldFaces, vtkIdType);
  vtkGetMacro(NumberOfDroppedFaces, vtkIdType);
  ///@}

protected:
  vtkLimnMeshReader();
  ~vtkLimnMeshReader() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  char* FileName = nullptr;
  vtkIdType NumberOfNonManifoldFaces = 0;
  vtkIdType NumberOfDroppedFaces = 0;

private:
  vtkLimnMeshReader(const vtkLimnMeshReader&) = delete;
  void operator=(const vtkLimnMeshReader&) = delete;

  void WarnAboutFaces(vtkIdType numberOfFaces);
};

#endif
