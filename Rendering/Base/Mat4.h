// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Vec.h"

#include <cmath>

namespace limn {

/// 4x4 matrix in rows, for column vectors: p' = M p, as vtkMatrix4x4 stores it. m[row][column].
template <class T>
struct Mat4 {
  T m[4][4];

  static constexpr Mat4 identity()
  {
    return {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
  }
};
using Mat4f = Mat4<float>;
using Mat4d = Mat4<double>;

template <class T>
constexpr Mat4<T> operator*(const Mat4<T>& a, const Mat4<T>& b)
{
  Mat4<T> product{};
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column)
      product.m[row][column] = (a.m[row][0] * b.m[0][column] + a.m[row][1] * b.m[1][column]) +
                               (a.m[row][2] * b.m[2][column] + a.m[row][3] * b.m[3][column]);
  return product;
}

constexpr Mat4d translation(Vec3d t)
{
  return {{{1, 0, 0, t.x}, {0, 1, 0, t.y}, {0, 0, 1, t.z}, {0, 0, 0, 1}}};
}

/// The first three rows applied to a point; no divide.
template <class T>
constexpr Vec3<T> transformPoint(const Mat4<T>& m, Vec3<T> p)
{
  const auto row = [&](int r) {
    return (m.m[r][0] * p.x + m.m[r][1] * p.y) + (m.m[r][2] * p.z + m.m[r][3]);
  };
  return {row(0), row(1), row(2)};
}
/// The upper left 3x3 applied to a direction.
template <class T>
constexpr Vec3<T> transformDirection(const Mat4<T>& m, Vec3<T> d)
{
  return {(m.m[0][0] * d.x + m.m[0][1] * d.y) + m.m[0][2] * d.z,
          (m.m[1][0] * d.x + m.m[1][1] * d.y) + m.m[1][2] * d.z,
          (m.m[2][0] * d.x + m.m[2][1] * d.y) + m.m[2][2] * d.z};
}

/// The upper left 3x3's determinant; its sign tells whether m mirrors.
constexpr double determinant3(const Mat4d& a)
{
  return a.m[0][0] * (a.m[1][1] * a.m[2][2] - a.m[1][2] * a.m[2][1]) -
         a.m[0][1] * (a.m[1][0] * a.m[2][2] - a.m[1][2] * a.m[2][0]) +
         a.m[0][2] * (a.m[1][0] * a.m[2][1] - a.m[1][1] * a.m[2][0]);
}

/// Adjugate transposed of the upper left 3x3, that is determinant times inverse transpose: takes
/// normals where the matrix takes points, up to length (and, when mirrored, up to sign).
constexpr Mat4d cofactor3(const Mat4d& a)
{
  const auto c = [&](int i, int j) {
    const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
    return a.m[i1][j1] * a.m[i2][j2] - a.m[i1][j2] * a.m[i2][j1];
  };
  return {{{c(0, 0), c(0, 1), c(0, 2), 0},
           {c(1, 0), c(1, 1), c(1, 2), 0},
           {c(2, 0), c(2, 1), c(2, 2), 0},
           {0, 0, 0, 1}}};
}

/// The inverse, by cofactors; false, and `result` as it was, where there is none or it is not
/// finite.
inline bool invert(const Mat4d& a, Mat4d& result)
{
  // Determinants of the upper two rows and of the lower two, by their columns.
  const auto minor = [&](int row, int i, int j) {
    return a.m[row][i] * a.m[row + 1][j] - a.m[row][j] * a.m[row + 1][i];
  };
  const double s01 = minor(0, 0, 1), s02 = minor(0, 0, 2), s03 = minor(0, 0, 3),
               s12 = minor(0, 1, 2), s13 = minor(0, 1, 3), s23 = minor(0, 2, 3);
  const double c01 = minor(2, 0, 1), c02 = minor(2, 0, 2), c03 = minor(2, 0, 3),
               c12 = minor(2, 1, 2), c13 = minor(2, 1, 3), c23 = minor(2, 2, 3);
  const double determinant =
      ((s01 * c23 - s02 * c13) + s03 * c12) + ((s12 * c03 - s13 * c02) + s23 * c01);
  const double scale = 1.0 / determinant;
  const auto& m = a.m;
  Mat4d inverse = {{{(m[1][1] * c23 - m[1][2] * c13) + m[1][3] * c12,
                     -((m[0][1] * c23 - m[0][2] * c13) + m[0][3] * c12),
                     (m[3][1] * s23 - m[3][2] * s13) + m[3][3] * s12,
                     -((m[2][1] * s23 - m[2][2] * s13) + m[2][3] * s12)},
                    {-((m[1][0] * c23 - m[1][2] * c03) + m[1][3] * c02),
                     (m[0][0] * c23 - m[0][2] * c03) + m[0][3] * c02,
                     -((m[3][0] * s23 - m[3][2] * s03) + m[3][3] * s02),
                     (m[2][0] * s23 - m[2][2] * s03) + m[2][3] * s02},
                    {(m[1][0] * c13 - m[1][1] * c03) + m[1][3] * c01,
                     -((m[0][0] * c13 - m[0][1] * c03) + m[0][3] * c01),
                     (m[3][0] * s13 - m[3][1] * s03) + m[3][3] * s01,
                     -((m[2][0] * s13 - m[2][1] * s03) + m[2][3] * s01)},
                    {-((m[1][0] * c12 - m[1][1] * c02) + m[1][2] * c01),
                     (m[0][0] * c12 - m[0][1] * c02) + m[0][2] * c01,
                     -((m[3][0] * s12 - m[3][1] * s02) + m[3][2] * s01),
                     (m[2][0] * s12 - m[2][1] * s02) + m[2][2] * s01}}};
  bool finite = true;
  for (auto& row : inverse.m)
    for (double& value : row) {
      value *= scale;
      finite = finite && std::isfinite(value);
    }
  if (finite) result = inverse;
  return finite;
}

inline Mat4f toFloat(const Mat4d& a)
{
  Mat4f result{};
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column)
      result.m[row][column] = static_cast<float>(a.m[row][column]);
  return result;
}

}  // namespace limn
