// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Vertex/ScreenToView.h"

#include <cmath>
#include <utility>

namespace limn {
namespace {

/// By Gauss and Jordan, with row pivots. Of a singular matrix, which shows nothing, itself.
Mat4d inverseOf(const Mat4d& matrix)
{
  Mat4d left = matrix, right = Mat4d::identity();
  for (int column = 0; column < 4; ++column) {
    int pivot = column;
    for (int row = column + 1; row < 4; ++row)
      if (std::fabs(left.m[row][column]) > std::fabs(left.m[pivot][column])) pivot = row;
    if (left.m[pivot][column] == 0) return matrix;
    for (int k = 0; k < 4; ++k) {
      std::swap(left.m[pivot][k], left.m[column][k]);
      std::swap(right.m[pivot][k], right.m[column][k]);
    }
    const double inverse = 1.0 / left.m[column][column];
    for (int k = 0; k < 4; ++k) {
      left.m[column][k] *= inverse;
      right.m[column][k] *= inverse;
    }
    for (int row = 0; row < 4; ++row) {
      const double factor = left.m[row][column];
      if (row == column || factor == 0) continue;
      for (int k = 0; k < 4; ++k) {
        left.m[row][k] -= factor * left.m[column][k];
        right.m[row][k] -= factor * right.m[column][k];
      }
    }
  }
  return right;
}

}  // namespace

ScreenToView::ScreenToView(const Camera& camera, int width, int height)
{
  const Mat4d windowToClip = {
      {{2.0 / width, 0, 0, -1}, {0, 2.0 / height, 0, -1}, {0, 0, 2, -1}, {0, 0, 0, 1}}};
  m_ = toFloat(inverseOf(camera.viewToClip) * windowToClip);
}

}  // namespace limn
