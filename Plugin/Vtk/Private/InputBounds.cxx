// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "InputBounds.h"

#include "EngineState.h"
#include "MovedPoints.h"

#include "Rendering/Base/Executor.h"

#include "vtkCellArray.h"
#include "vtkDataArrayRange.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace limn::bridge
{
namespace
{

vtkMTimeType meshTime(vtkPolyData* data)
{
  vtkMTimeType time = std::max(data->vtkObject::GetMTime(), data->GetPoints()->GetMTime());
  time = std::max(time, data->GetPoints()->GetData()->GetMTime());
  for (vtkCellArray* cells :
    { data->GetVerts(), data->GetLines(), data->GetPolys(), data->GetStrips() })
  {
    time = std::max({ time, cells->GetMTime(), cells->GetConnectivityArray()->GetMTime() });
  }
  return time;
}

template <class Visit>
void forEachPointId(vtkPolyData* data, Visit visit)
{
  for (vtkCellArray* cells :
    { data->GetVerts(), data->GetLines(), data->GetPolys(), data->GetStrips() })
  {
    const auto visitAll = [&](auto* ids)
    {
      std::for_each(ids->GetPointer(0), ids->GetPointer(0) + ids->GetNumberOfValues(),
        [&](auto id) { visit(static_cast<vtkIdType>(id)); });
    };
    if (cells->IsStorage64Bit())
    {
      visitAll(cells->GetConnectivityArray64());
    }
    else
    {
      visitAll(cells->GetConnectivityArray32());
    }
  }
}

/// Whether test(value) holds for all values, asked on all cores.
template <class Value, class Test>
bool allOf(const Value* values, vtkIdType count, Test test)
{
  constexpr std::size_t kChunk = 1 << 18;
  const auto size = static_cast<std::size_t>(count);
  std::atomic<bool> all = true;
  parallelFor(EngineState::instance().options.threads, (size + kChunk - 1) / kChunk,
    [&](std::size_t chunk)
    {
      const Value* const first = values + chunk * kChunk;
      if (!std::all_of(first, first + std::min(kChunk, size - chunk * kChunk), test))
      {
        all = false;
      }
    });
  return all;
}

bool allPointsExist(vtkPolyData* data)
{
  const vtkIdType points = data->GetNumberOfPoints();
  const auto exist = [points](auto* ids)
  {
    return allOf(ids->GetPointer(0), ids->GetNumberOfValues(),
      [points](auto id) { return id >= 0 && id < points; });
  };
  for (vtkCellArray* cells :
    { data->GetVerts(), data->GetLines(), data->GetPolys(), data->GetStrips() })
  {
    if (!(cells->IsStorage64Bit() ? exist(cells->GetConnectivityArray64())
                                  : exist(cells->GetConnectivityArray32())))
    {
      return false;
    }
  }
  return true;
}

bool allCoordinatesAreFinite(vtkPolyData* data)
{
  const auto isFinite = [](auto value) { return std::isfinite(value); };
  vtkDataArray* const array = data->GetPoints()->GetData();
  if (vtkFloatArray* const floats = vtkFloatArray::FastDownCast(array))
  {
    return allOf(floats->GetPointer(0), floats->GetNumberOfValues(), isFinite);
  }
  if (vtkDoubleArray* const doubles = vtkDoubleArray::FastDownCast(array))
  {
    return allOf(doubles->GetPointer(0), doubles->GetNumberOfValues(), isFinite);
  }
  const auto values = vtk::DataArrayValueRange<3>(array);
  return std::all_of(values.begin(), values.end(), isFinite);
}

std::array<double, 6> boundsOfGoodPoints(vtkPolyData* data, const MovedPoints& moved)
{
  const MeshView movedView = moved.areMoved() ? moved.view({}) : MeshView{};
  std::array<double, 6> bounds = { 1, -1, 1, -1, 1, -1 };
  const vtkIdType points = data->GetNumberOfPoints();
  forEachPointId(data,
    [&](vtkIdType id)
    {
      double p[3] = { NAN, NAN, NAN };
      if (id >= 0 && id < points)
      {
        if (moved.areMoved())
        {
          const Vec3d position = movedView.position(static_cast<std::size_t>(id));
          p[0] = position.x;
          p[1] = position.y;
          p[2] = position.z;
        }
        else
        {
          data->GetPoint(id, p);
        }
      }
      if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
      {
        return;
      }
      const bool isFirst = bounds[0] > bounds[1];
      for (int axis = 0; axis < 3; ++axis)
      {
        bounds[2 * axis] = isFirst ? p[axis] : std::min(bounds[2 * axis], p[axis]);
        bounds[2 * axis + 1] = isFirst ? p[axis] : std::max(bounds[2 * axis + 1], p[axis]);
      }
    });
  return bounds;
}

} // namespace

bool InputBounds::update(vtkPolyData* data, const MovedPoints& moved)
{
  if (!data || !data->GetPoints())
  {
    *this = {};
    return true;
  }
  const vtkMTimeType time = meshTime(data);
  if (data == data_ && time == time_ && moved.version() == moved_)
  {
    return false;
  }
  data_ = data;
  time_ = time;
  moved_ = moved.version();
  areSafe_ = !moved.areMoved() && allPointsExist(data) && allCoordinatesAreFinite(data);
  bounds_ = areSafe_ ? std::array<double, 6>{} : boundsOfGoodPoints(data, moved);
  return true;
}

} // namespace limn::bridge
