// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef InputBounds_h
#define InputBounds_h

#include "vtkType.h"

#include <algorithm>
#include <array>

class vtkPolyData;

namespace limn::bridge
{
class MovedPoints;
}

namespace limn::bridge
{

/// The box of what a vtkPolyData shows. vtkPolyData::GetCellsBounds() reads beyond the points where
/// a cell names one that does not exist, takes over coordinates that are not finite numbers, and
/// knows nothing of points that are moved.
class InputBounds
{
public:
  /// Of `data` where its points are `moved` to. False if the bounds are those of the last call:
  /// neither has changed since.
  bool update(vtkPolyData* data, const MovedPoints& moved);

  /// True if VTK can be left to compute the bounds.
  bool areSafe() const { return areSafe_; }

  /// What VTK has computed.
  void remember(const double* bounds) { std::copy_n(bounds, bounds_.size(), bounds_.begin()); }

  /// Of the existing, finite points of cells, as xmin, xmax, ymin, ymax, zmin, zmax; (1, -1) on
  /// each axis if there are none. If areSafe(), call remember() first.
  const std::array<double, 6>& values() const { return bounds_; }

private:
  const void* data_ = nullptr;
  vtkMTimeType time_ = 0;
  vtkMTimeType moved_ = 0;
  bool areSafe_ = true;
  std::array<double, 6> bounds_ = { 1, -1, 1, -1, 1, -1 };
};

} // namespace limn::bridge

#endif
