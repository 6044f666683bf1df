// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef CellIds_h
#define CellIds_h

#include "vtkType.h"

#include <cstdint>
#include <memory>
#include <vector>

class vtkDataArray;
class vtkLimnProperty;
class vtkPolyData;

namespace limn::bridge
{

/// What cells are parts of: the array of cell data that a property names, or the cell scalars;
/// nullptr if there is none with a value for each cell.
vtkDataArray* idArrayOf(vtkLimnProperty* property, vtkPolyData* data);

/// One a tuple. Equal values have equal numbers.
std::vector<std::uint32_t> numbersOf(vtkDataArray* ids);

/// The numbers of one mapper's cells, kept between frames until the array changes.
class CellIds
{
public:
  /// nullptr: none.
  std::shared_ptr<const std::vector<std::uint32_t>> of(
    vtkLimnProperty* property, vtkPolyData* data);

private:
  const void* array_ = nullptr;
  vtkMTimeType time_ = 0;
  std::shared_ptr<const std::vector<std::uint32_t>> numbers_;
};

} // namespace limn::bridge

#endif
