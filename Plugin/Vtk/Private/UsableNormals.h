// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef UsableNormals_h
#define UsableNormals_h

#include "Rendering/Mesh/MeshView.h"

#include "vtkType.h"

#include <cstddef>
#include <vector>

namespace limn::bridge
{

/// Given normals, of points or of cells, with the mesh's own in place of those whose length is not
/// a finite number, as light on these would be none. None if all are such. Normals without a length
/// stay: they are how filters say that there is none.
class UsableNormals
{
public:
  /// Borrows `given`. Looks at it, on at most `threads` threads, only where it is another span or
  /// `version` than last time.
  void look(Span<const Vec3f> given, vtkMTimeType version, int threads);
  /// Whether replace() has to be called before span() is of a mesh with this geometry.
  bool lacksOwn(vtkIdType geometry) const;
  /// `own`: as many as are given, of the mesh with this geometry.
  void replace(std::vector<Vec3f> own, vtkIdType geometry);

  Span<const Vec3f> span() const;
  /// How many of those given are not in span(), those apart that no surface has.
  vtkIdType replaced() const { return replaced_; }

private:
  bool areNone() const { return unusable_ == given_.size(); }

  Span<const Vec3f> given_;
  vtkMTimeType version_ = 0;
  std::size_t unusable_ = 0;
  vtkIdType replaced_ = 0;
  std::vector<Vec3f> mended_;
  vtkIdType geometry_ = -1; ///< of the above
};

} // namespace limn::bridge

#endif
