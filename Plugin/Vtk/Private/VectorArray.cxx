// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VectorArray.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkDataArray.h"

#include <algorithm>
#include <cmath>

namespace limn::bridge
{
namespace
{

/// The packed values of the array, or an empty span if it is of another type or layout.
template <class T>
Span<const Vec3<T>> packed(vtkDataArray* array)
{
  vtkAOSDataArrayTemplate<T>* const values = vtkAOSDataArrayTemplate<T>::FastDownCast(array);
  if (!values)
  {
    return {};
  }
  static_assert(sizeof(Vec3<T>) == 3 * sizeof(T), "a Vec3 is three packed numbers");
  return { reinterpret_cast<const Vec3<T>*>(values->GetPointer(0)),
    static_cast<std::size_t>(array->GetNumberOfTuples()) };
}

template <class T>
std::vector<Vec3<T>> copied(vtkDataArray* array)
{
  std::vector<Vec3<T>> copy(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (std::size_t i = 0; i < copy.size(); ++i)
  {
    double tuple[3];
    array->GetTuple(static_cast<vtkIdType>(i), tuple);
    copy[i] = vec3Cast<T>(Vec3d{ tuple[0], tuple[1], tuple[2] });
  }
  return copy;
}

Span<const Vec2f> packedPairs(vtkDataArray* array)
{
  auto* const values = vtkAOSDataArrayTemplate<float>::FastDownCast(array);
  if (!values || array->GetNumberOfComponents() != 2)
  {
    return {};
  }
  static_assert(sizeof(Vec2f) == 2 * sizeof(float), "a Vec2f is two packed numbers");
  return { reinterpret_cast<const Vec2f*>(values->GetPointer(0)),
    static_cast<std::size_t>(array->GetNumberOfTuples()) };
}

std::vector<Vec2f> copiedPairs(vtkDataArray* array)
{
  const bool hasV = array->GetNumberOfComponents() == 2;
  std::vector<Vec2f> copy(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (std::size_t i = 0; i < copy.size(); ++i)
  {
    const auto tuple = static_cast<vtkIdType>(i);
    copy[i].x = static_cast<float>(array->GetComponent(tuple, 0));
    copy[i].y = hasV ? static_cast<float>(array->GetComponent(tuple, 1)) : 0.0f;
  }
  return copy;
}

} // namespace

void VectorArray::update(vtkDataArray* array, vtkIdType tuples)
{
  if (!array || array->GetNumberOfComponents() != 3 || array->GetNumberOfTuples() != tuples)
  {
    *this = {};
    return;
  }
  const bool isKnown = array == array_ && array->GetMTime() == time_;
  array_ = array;
  time_ = array->GetMTime();
  span_ = packed<float>(array);
  if (!span_.empty())
  {
    copy_ = std::vector<Vec3f>();
    return;
  }
  if (!isKnown)
  {
    copy_ = copied<float>(array);
  }
  span_ = copy_;
}

void TCoordArray::update(vtkDataArray* array, vtkIdType tuples)
{
  const int components = array ? array->GetNumberOfComponents() : 0;
  if (components < 1 || components > 2 || array->GetNumberOfTuples() != tuples)
  {
    *this = {};
    return;
  }
  if (array == array_ && array->GetMTime() == time_)
  {
    return;
  }
  array_ = array;
  time_ = array->GetMTime();
  span_ = packedPairs(array);
  copy_ = span_.empty() ? copiedPairs(array) : std::vector<Vec2f>();
  if (span_.empty())
  {
    span_ = copy_;
  }
  notFinite_ = std::count_if(span_.begin(), span_.end(),
    [](const Vec2f& uv) { return !std::isfinite(uv.x) || !std::isfinite(uv.y); });
}

void PointArray::set(vtkDataArray* array)
{
  array_ = array;
  copy_ = std::vector<Vec3d>();
  floats_ = packed<float>(array);
  doubles_ = packed<double>(array);
  if (floats_.empty() && doubles_.empty())
  {
    copy_ = copied<double>(array);
    doubles_ = copy_;
  }
}

void PointArray::clear()
{
  *this = {};
}

} // namespace limn::bridge
