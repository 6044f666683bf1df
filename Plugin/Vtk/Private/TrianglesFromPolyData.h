// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TrianglesFromPolyData_h
#define TrianglesFromPolyData_h

#include "Rendering/Base/Array.h"
#include "Rendering/Mesh/MeshView.h"

#include <vector>

class vtkPolyData;

namespace limn::bridge
{

/// Triangles of a vtkPolyData, in the order in which VTK draws them: polygons, then strips.
struct SurfaceTriangles
{
  Array<Triangle> triangles;
  std::vector<std::uint32_t> cells; ///< VTK's cell of each triangle; empty if triangle t is cell t
  std::size_t malformedCells = 0;   ///< left out: they reach beyond the cell array
};

/// Cuts polygons into fans around their first point and strips into triangles of one winding.
/// Does not read the points: triangles without an area are kept. Points that do not exist become a
/// number that is out of range for any mesh.
/// `threads`: at most so many, 0 all; the result does not depend on it.
SurfaceTriangles trianglesFromPolyData(vtkPolyData* data, int threads);

} // namespace limn::bridge

#endif
