// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace limn {

/// Three numbers: a point, a direction or an RGB colour. Aggregates, so arrays of them are the
/// packed xyzxyz layout of VTK's and OpenMesh's buffers.
template <class T>
struct Vec3 {
  T x, y, z;
};
using Vec3f = Vec3<float>;
using Vec3d = Vec3<double>;

template <class T>
constexpr Vec3<T> operator+(Vec3<T> a, Vec3<T> b)
{
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T>
constexpr Vec3<T> operator-(Vec3<T> a, Vec3<T> b)
{
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T>
constexpr Vec3<T> operator-(Vec3<T> a)
{
  return {-a.x, -a.y, -a.z};
}
template <class T>
constexpr Vec3<T> operator*(Vec3<T> a, Vec3<T> b)
{
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}
template <class T>
constexpr Vec3<T> operator*(Vec3<T> a, T s)
{
  return {a.x * s, a.y * s, a.z * s};
}
template <class T>
constexpr bool operator==(Vec3<T> a, Vec3<T> b)
{
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

/// Two numbers: a texture coordinate.
template <class T>
struct Vec2 {
  T x, y;
};
using Vec2f = Vec2<float>;

template <class T>
constexpr Vec2<T> operator+(Vec2<T> a, Vec2<T> b)
{
  return {a.x + b.x, a.y + b.y};
}
template <class T>
constexpr Vec2<T> operator-(Vec2<T> a, Vec2<T> b)
{
  return {a.x - b.x, a.y - b.y};
}
template <class T>
constexpr Vec2<T> operator*(Vec2<T> a, T s)
{
  return {a.x * s, a.y * s};
}
template <class T>
constexpr bool operator==(Vec2<T> a, Vec2<T> b)
{
  return a.x == b.x && a.y == b.y;
}
template <class T>
bool isFinite(Vec2<T> a)
{
  return std::isfinite(a.x) && std::isfinite(a.y);
}

/// Four numbers: an RGBA colour.
template <class T>
struct Vec4 {
  T x, y, z, w;
};
using Vec4f = Vec4<float>;

template <class T>
constexpr Vec4<T> operator+(Vec4<T> a, Vec4<T> b)
{
  return {a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w};
}
template <class T>
constexpr Vec4<T> operator-(Vec4<T> a, Vec4<T> b)
{
  return {a.x - b.x, a.y - b.y, a.z - b.z, a.w - b.w};
}
template <class T>
constexpr Vec4<T> operator*(Vec4<T> a, T s)
{
  return {a.x * s, a.y * s, a.z * s, a.w * s};
}
template <class T>
constexpr bool operator==(Vec4<T> a, Vec4<T> b)
{
  return a.x == b.x && a.y == b.y && a.z == b.z && a.w == b.w;
}
template <class T>
bool isFinite(Vec4<T> a)
{
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z) && std::isfinite(a.w);
}

/// (ax*bx + ay*by) + az*bz: the one order of operations, shared with the vector kernels.
template <class T>
constexpr T dot(Vec3<T> a, Vec3<T> b)
{
  return (a.x * b.x + a.y * b.y) + a.z * b.z;
}
template <class T>
constexpr Vec3<T> cross(Vec3<T> a, Vec3<T> b)
{
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
/// a scaled to length 1 by one division and three products; the zero vector stays zero.
template <class T>
Vec3<T> normalized(Vec3<T> a)
{
  const T squared = dot(a, a);
  const T scale = squared > T(0) ? T(1) / std::sqrt(squared) : T(0);
  return a * scale;
}
template <class T>
bool isFinite(Vec3<T> a)
{
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

template <class To, class From>
constexpr Vec3<To> vec3Cast(Vec3<From> a)
{
  return {static_cast<To>(a.x), static_cast<To>(a.y), static_cast<To>(a.z)};
}

}  // namespace limn
