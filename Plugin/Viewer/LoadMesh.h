// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef limn_viewer_LoadMesh_h
#define limn_viewer_LoadMesh_h

#include <vtkPolyData.h>     // for Mesh::surface
#include <vtkSmartPointer.h> // for Mesh::surface

#include <string> // for file names
#include <vector> // for several files

namespace limn::viewer
{

struct Mesh
{
  std::string file;
  std::string format; ///< "OBJ", "VTU", ...
  vtkSmartPointer<vtkPolyData> surface;
  vtkIdType nonManifoldFaces = 0; ///< in the file, and kept
  vtkIdType droppedFaces = 0;     ///< in the file, and left out
};

/// Reads a mesh in the format that the file's extension names, in either case; the surface of a
/// volume mesh. Faces that are dropped or not manifold are told as a warning.
/// Throws UserError for a file that is missing, unreadable, malformed or of an unknown format, a
/// coordinate that is not finite, and a cell whose point does not exist.
Mesh loadMesh(const std::string& file);

std::vector<Mesh> loadMeshes(const std::vector<std::string>& files);

} // namespace limn::viewer

#endif
