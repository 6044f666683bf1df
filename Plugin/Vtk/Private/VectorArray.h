// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef VectorArray_h
#define VectorArray_h

#include "Rendering/Mesh/MeshView.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <vector>

class vtkDataArray;

namespace limn::bridge
{

/// Three floats per tuple of a VTK array: its own memory where that is packed floats, else a copy.
class VectorArray
{
public:
  /// Views `array`, or nothing if it is null or has not three components and `tuples` tuples. A
  /// copy is made only if the array is another one or was modified.
  void update(vtkDataArray* array, vtkIdType tuples);
  Span<const Vec3f> span() const { return this->span_; }
  /// When the array was modified last, as update() saw it; 0 if there is none.
  vtkMTimeType time() const { return this->time_; }

private:
  vtkSmartPointer<vtkDataArray> array_;
  vtkMTimeType time_ = 0;
  std::vector<Vec3f> copy_;
  Span<const Vec3f> span_;
};

/// Texture coordinates: two floats per tuple of a VTK array, its own memory where that is packed
/// floats, else a copy. Of one component: that and 0, as VTK.
class TCoordArray
{
public:
  /// Views `array`, or nothing if it is null or has neither one nor two components or not `tuples`
  /// tuples. What it keeps is made anew only if the array is another one or was modified.
  void update(vtkDataArray* array, vtkIdType tuples);
  Span<const Vec2f> span() const { return this->span_; }
  /// Tuples with a value that is not a finite number.
  vtkIdType notFinite() const { return this->notFinite_; }

private:
  vtkSmartPointer<vtkDataArray> array_;
  vtkMTimeType time_ = 0;
  std::vector<Vec2f> copy_;
  Span<const Vec2f> span_;
  vtkIdType notFinite_ = 0;
};

/// Coordinates of points: floats and doubles in place, other types as doubles.
class PointArray
{
public:
  /// Requires: `array` has three components.
  void set(vtkDataArray* array);
  void clear();
  /// A view without triangles.
  MeshView view() const { return { this->floats_, this->doubles_, {} }; }

private:
  vtkSmartPointer<vtkDataArray> array_;
  std::vector<Vec3d> copy_;
  Span<const Vec3f> floats_;
  Span<const Vec3d> doubles_;
};

} // namespace limn::bridge

#endif
