// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellIds.h"

#include "vtkLimnProperty.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkPolyData.h"

#include <cstring>

namespace limn::bridge
{

vtkDataArray* idArrayOf(vtkLimnProperty* property, vtkPolyData* data)
{
  const char* const name = property->GetIdArrayName();
  vtkCellData* const cells = data->GetCellData();
  vtkDataArray* const ids = name && *name ? cells->GetArray(name) : cells->GetScalars();
  return ids && ids->GetNumberOfTuples() == data->GetNumberOfCells() ? ids : nullptr;
}

std::vector<std::uint32_t> numbersOf(vtkDataArray* ids)
{
  std::vector<std::uint32_t> numbers(static_cast<std::size_t>(ids->GetNumberOfTuples()));
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    const double value = ids->GetComponent(static_cast<vtkIdType>(i), 0) + 0.0;
    std::uint64_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    constexpr std::uint64_t kOdd = 0x9E3779B97F4A7C15u;
    numbers[i] = static_cast<std::uint32_t>(bits * kOdd >> 32);
  }
  return numbers;
}

std::shared_ptr<const std::vector<std::uint32_t>> CellIds::of(
  vtkLimnProperty* property, vtkPolyData* data)
{
  vtkDataArray* const array = idArrayOf(property, data);
  if (!array)
  {
    return nullptr;
  }
  const vtkMTimeType time = array->GetMTime();
  if (!numbers_ || array != array_ || time != time_)
  {
    numbers_ = std::make_shared<const std::vector<std::uint32_t>>(numbersOf(array));
    array_ = array;
    time_ = time;
  }
  return numbers_;
}

} // namespace limn::bridge
