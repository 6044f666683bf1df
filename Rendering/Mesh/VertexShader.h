// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace limn {

/// Vertices of one mesh, an array a component, in model coordinates.
struct alignas(64) VertexBatch {
  static constexpr int kCapacity = 256;

  double x[kCapacity], y[kCapacity], z[kCapacity];
  float normalX[kCapacity], normalY[kCapacity], normalZ[kCapacity];
  bool hasNormals;      ///< else the three above mean nothing
  std::uint32_t first;  ///< number of vertex 0 in the mesh; the others follow
  int count;            ///< 1 to kCapacity
};

/// A program that moves vertices before they are placed in the world: the vertex shader of a GPU's
/// pipeline.
class VertexShader {
 public:
  virtual ~VertexShader() = default;

  /// Moves the vertices in place. Positions are rounded to floats where the mesh's are floats.
  ///
  /// Called by several threads at once. How vertices are put together is not defined: where one
  /// goes shall depend on its position, normal and number, and on the shader's own constants only.
  /// It may not throw. For the same bytes everywhere keep to + - * /, std::sqrt and Base/Power.h,
  /// and compile with -ffp-contract=off.
  virtual void move(VertexBatch& vertices) const = 0;

  /// Whether move() turns the normals too; they need not be unit. Where it does not, they have to
  /// be computed anew from what the triangles have become.
  virtual bool movesNormals() const { return false; }
};

}  // namespace limn
