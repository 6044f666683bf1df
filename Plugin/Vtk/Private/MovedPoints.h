// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef MovedPoints_h
#define MovedPoints_h

#include "VectorArray.h"

#include "Rendering/Mesh/MoveVertices.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <string>

class vtkLimnVertexShader;
class vtkPolyData;

namespace limn::bridge
{

/// When the points of a vtkPolyData were last other ones; of attributes it knows nothing.
vtkMTimeType pointsTimeOf(vtkPolyData* data);

/// The points of a mapper's input where its vertex shader has moved them; kept until either
/// changes.
class MovedPoints
{
public:
  /// `shader` may be null: then nothing is moved. `data` has points.
  void update(vtkLimnVertexShader* shader, vtkPolyData* data, int threads);

  bool areMoved() const { return shader_ != nullptr; }
  /// Changes when the points do; 0 while they are not moved.
  vtkMTimeType version() const { return this->areMoved() ? runs_ : 0; }

  // Only while areMoved():
  MeshView view(Span<const Triangle> triangles) const { return moved_.view(triangles); }
  /// Of the points; empty if they have to be computed.
  Span<const Vec3f> normals() const { return moved_.normals; }
  /// Points that got lost, in words; empty if none.
  std::string complaint() const;

private:
  struct Key
  {
    const void* shader;
    vtkMTimeType shaderTime;
    const void* points;
    vtkMTimeType pointsTime;
    const void* normals;
    vtkMTimeType normalsTime;

    bool operator==(const Key& other) const;
  };
  static Key keyOf(vtkLimnVertexShader* shader, vtkPolyData* data);

  vtkSmartPointer<vtkLimnVertexShader> shader_;
  Key key_ = {};
  MovedVertices moved_;
  vtkMTimeType runs_ = 0;
};

} // namespace limn::bridge

#endif
