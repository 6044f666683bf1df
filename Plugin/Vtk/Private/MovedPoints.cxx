// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MovedPoints.h"

#include "vtkLimnVertexShader.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <sstream>

namespace limn::bridge
{
namespace
{

/// The shader as the core calls it.
class ShaderAdapter final : public VertexShader
{
public:
  explicit ShaderAdapter(const vtkLimnVertexShader* shader) : shader_(shader) {}

  void move(VertexBatch& batch) const override
  {
    const bool normals = batch.hasNormals;
    shader_->Move({ batch.count, static_cast<vtkIdType>(batch.first), { batch.x, batch.y, batch.z },
      { normals ? batch.normalX : nullptr, normals ? batch.normalY : nullptr,
        normals ? batch.normalZ : nullptr } });
  }
  bool movesNormals() const override { return shader_->MovesNormals(); }

private:
  const vtkLimnVertexShader* shader_;
};

vtkDataArray* normalsFor(vtkLimnVertexShader* shader, vtkPolyData* data)
{
  return shader->MovesNormals() ? data->GetPointData()->GetNormals() : nullptr;
}

} // namespace

vtkMTimeType pointsTimeOf(vtkPolyData* data)
{
  vtkPoints* const points = data->GetPoints();
  // Of the data set only its own time: with its attributes' times, which GetMTime() includes, other
  // scalars would look like another geometry.
  return std::max(
    { data->vtkObject::GetMTime(), points->GetMTime(), points->GetData()->GetMTime() });
}

bool MovedPoints::Key::operator==(const Key& other) const
{
  return shader == other.shader && shaderTime == other.shaderTime && points == other.points &&
         pointsTime == other.pointsTime && normals == other.normals &&
         normalsTime == other.normalsTime;
}

MovedPoints::Key MovedPoints::keyOf(vtkLimnVertexShader* shader, vtkPolyData* data)
{
  vtkDataArray* const normals = normalsFor(shader, data);
  return { shader, shader->GetMTime(), data->GetPoints()->GetData(), pointsTimeOf(data), normals,
    normals ? normals->GetMTime() : 0 };
}

void MovedPoints::update(vtkLimnVertexShader* shader, vtkPolyData* data, int threads)
{
  if (!shader)
  {
    if (shader_)
    {
      shader_ = nullptr;
      key_ = {};
      moved_ = {};
    }
    return;
  }
  const Key key = keyOf(shader, data);
  if (shader == shader_ && key == key_)
  {
    return;
  }
  shader_ = shader;
  key_ = key;
  ++runs_;
  PointArray points;
  points.set(data->GetPoints()->GetData());
  VectorArray normals;
  normals.update(normalsFor(shader, data), data->GetNumberOfPoints());
  moveVertices(ShaderAdapter(shader), points.view(), normals.span(), threads, moved_);
}

std::string MovedPoints::complaint() const
{
  if (!this->areMoved() || moved_.lostVertices == 0)
  {
    return {};
  }
  std::ostringstream text;
  text << " Its " << shader_->GetClassName() << " moves " << moved_.lostVertices
       << " points, the first of them point " << moved_.firstLost
       << ", to coordinates that are not finite numbers.";
  return text.str();
}

} // namespace limn::bridge
