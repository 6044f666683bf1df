// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VectorArray.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkDataArray.h"

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
