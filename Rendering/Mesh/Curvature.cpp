// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Mesh/Curvature.h"

#include "Rendering/Base/Array.h"
#include "Rendering/Base/ParallelStretches.h"
#include "Rendering/Mesh/CornerLists.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace limn {
namespace {

constexpr std::size_t kPerTask = 4096;
/// Of more triangles the planes, 72 bytes each, are computed anew wherever they are needed.
constexpr std::size_t kMostKept = std::size_t{1} << 22;

/// Two unit vectors that span a plane.
struct Frame {
  Vec3d u, v;

  Vec3d normal() const { return cross(u, v); }
};

/// The frame turned the shortest way, so that its normal becomes `normal`.
Frame turned(const Frame& frame, Vec3d normal)
{
  const Vec3d old = frame.normal();
  const double cosine = dot(old, normal);
  if (cosine <= -1) return {-frame.u, -frame.v};
  // What lies along the part of the new normal in the old plane is turned, the rest stays.
  const Vec3d aside = normal - old * cosine;
  const Vec3d change = (old + normal) * (1.0 / (1.0 + cosine));
  return {frame.u - change * dot(frame.u, aside), frame.v - change * dot(frame.v, aside)};
}

/// e, f, g of the symmetric tensor ((e, f), (f, g)) in some frame.
using Tensor = std::array<double, 3>;
/// Derivative of a tensor, symmetric in three indices: uuu, uuv, uvv, vvv.
using TensorSlope = std::array<double, 4>;

Tensor inFrame(const Tensor& t, const Frame& from, const Frame& to)
{
  const Frame in = turned(to, from.normal());
  const double u1 = dot(in.u, from.u), v1 = dot(in.u, from.v);
  const double u2 = dot(in.v, from.u), v2 = dot(in.v, from.v);
  return {t[0] * u1 * u1 + t[1] * (2 * u1 * v1) + t[2] * v1 * v1,
          t[0] * u1 * u2 + t[1] * (u1 * v2 + u2 * v1) + t[2] * v1 * v2,
          t[0] * u2 * u2 + t[1] * (2 * u2 * v2) + t[2] * v2 * v2};
}

TensorSlope inFrame(const TensorSlope& s, const Frame& from, const Frame& to)
{
  const Frame in = turned(to, from.normal());
  const double u1 = dot(in.u, from.u), v1 = dot(in.u, from.v);
  const double u2 = dot(in.v, from.u), v2 = dot(in.v, from.v);
  return {
      s[0] * u1 * u1 * u1 + s[1] * 3 * u1 * u1 * v1 + s[2] * 3 * u1 * v1 * v1 + s[3] * v1 * v1 * v1,
      s[0] * u1 * u1 * u2 + s[1] * (u1 * u1 * v2 + 2 * u2 * u1 * v1) +
          s[2] * (u2 * v1 * v1 + 2 * u1 * v1 * v2) + s[3] * v1 * v1 * v2,
      s[0] * u1 * u2 * u2 + s[1] * (u2 * u2 * v1 + 2 * u1 * u2 * v2) +
          s[2] * (u1 * v2 * v2 + 2 * u2 * v2 * v1) + s[3] * v1 * v2 * v2,
      s[0] * u2 * u2 * u2 + s[1] * 3 * u2 * u2 * v2 + s[2] * 3 * u2 * v2 * v2 +
          s[3] * v2 * v2 * v2};
}

/// Solves the symmetric system a x = b, which is positive where the equations settle all; zeros
/// where they do not. By Gauss's elimination without pivots.
template <std::size_t n>
std::array<double, n> solved(std::array<std::array<double, n>, n> a, std::array<double, n> b)
{
  double largest = 0;
  for (std::size_t i = 0; i < n; ++i)
    largest = std::max(largest, a[i][i]);
  for (std::size_t i = 0; i < n; ++i) {
    constexpr double kTooSmall = 1e-12;
    if (!(a[i][i] > kTooSmall * largest)) return {};
    for (std::size_t r = i + 1; r < n; ++r) {
      const double factor = a[r][i] / a[i][i];
      for (std::size_t c = i; c < n; ++c)
        a[r][c] -= factor * a[i][c];
      b[r] -= factor * b[i];
    }
  }
  std::array<double, n> x = {};
  for (std::size_t i = n; i-- > 0;) {
    double rest = b[i];
    for (std::size_t c = i + 1; c < n; ++c)
      rest -= a[i][c] * x[c];
    x[i] = rest / a[i][i];
  }
  return x;
}

/// Where a triangle lies.
struct FacePlane {
  Frame frame;
  double share[3];  ///< of its area, nearest to each vertex
};
/// A triangle in its own frame.
struct Face {
  std::uint32_t vertex[3];
  Frame frame;
  double u[3], v[3];  ///< the edges opposite to each vertex, from the next one to the one before
};

class CurvatureEstimator {
 public:
  CurvatureEstimator(const MeshView& mesh, Span<const Vec3f> normals, int threads)
      : mesh_(mesh),
        normals_(normals),
        threads_(threads),
        isProper_(properFaces(mesh, threads)),
        corners_(mesh, threads, [this](std::size_t t) { return isProper_[t] != 0; })
  {
    if (mesh.triangles.size() > kMostKept) return;
    kept_.resize(mesh.triangles.size());
    parallelForEach(threads, kept_.size(), kPerTask, [&](std::size_t t) {
      if (isProper_[t]) kept_[t] = planeOf(t);
    });
  }

  std::vector<VertexCurvature> estimate()
  {
    const std::size_t vertices = mesh_.vertexCount();
    frames_.resize(vertices);
    tensors_.assign(vertices, Tensor{});
    std::vector<Tensor> ofFace(mesh_.triangles.size());
    parallelForEach(threads_, ofFace.size(), kPerTask, [&](std::size_t t) {
      if (isProper_[t]) ofFace[t] = fit(t);
    });
    parallelForEach(threads_, vertices, kPerTask, [&](std::size_t v) {
      frames_[v] = firstFrame(v);
      tensors_[v] = mean<Tensor>(v, ofFace);
      turnToPrincipal(v);
    });
    std::vector<TensorSlope> slopeOfFace(mesh_.triangles.size());
    parallelForEach(threads_, slopeOfFace.size(), kPerTask, [&](std::size_t t) {
      if (isProper_[t]) slopeOfFace[t] = fitSlope(t);
    });
    std::vector<VertexCurvature> result(vertices);
    parallelForEach(threads_, vertices, kPerTask, [&](std::size_t v) {
      const TensorSlope slope = mean<TensorSlope>(v, slopeOfFace);
      VertexCurvature& out = result[v];
      out.direction[0] = vec3Cast<float>(frames_[v].u);
      out.direction[1] = vec3Cast<float>(frames_[v].v);
      out.curvature[0] = static_cast<float>(tensors_[v][0]);
      out.curvature[1] = static_cast<float>(tensors_[v][2]);
      for (std::size_t i = 0; i < 4; ++i)
        out.derivative[i] = static_cast<float>(slope[i]);
    });
    return result;
  }

 private:
  static std::vector<char> properFaces(const MeshView& mesh, int threads)
  {
    std::vector<char> proper(mesh.triangles.size());
    parallelForEach(threads, proper.size(), kPerTask,
                    [&](std::size_t t) { proper[t] = isProper(mesh, t) ? 1 : 0; });
    return proper;
  }
  static bool isProper(const MeshView& mesh, std::size_t t)
  {
    const auto [a, b, c] = mesh.triangles[t].vertex;
    const std::size_t count = mesh.vertexCount();
    if (a >= count || b >= count || c >= count) return false;
    const Vec3d p = mesh.position(a);
    const Vec3d area = cross(mesh.position(b) - p, mesh.position(c) - p);
    return isFinite(area) && dot(area, area) > 0;
  }

  using Edges = std::array<Vec3d, 3>;  ///< as in Face, in the mesh's space

  Edges edgesOf(std::size_t t) const
  {
    Vec3d p[3];
    for (int i = 0; i < 3; ++i)
      p[i] = mesh_.position(mesh_.triangles[t].vertex[i]);
    return {p[2] - p[1], p[0] - p[2], p[1] - p[0]};
  }
  FacePlane planeOf(std::size_t t) const
  {
    const Edges edge = edgesOf(t);
    FacePlane plane;
    const Vec3d normal = normalized(cross(edge[0], edge[1]));
    plane.frame.u = normalized(edge[0]);
    plane.frame.v = cross(normal, plane.frame.u);
    setShares(edge, plane.share);
    return plane;
  }
  FacePlane keptPlane(std::size_t t) const { return kept_.empty() ? planeOf(t) : kept_[t]; }
  Face faceOf(std::size_t t) const
  {
    const Edges edge = edgesOf(t);
    Face face;
    face.frame = keptPlane(t).frame;
    for (std::size_t i = 0; i < 3; ++i) {
      face.vertex[i] = mesh_.triangles[t].vertex[i];
      face.u[i] = dot(edge[i], face.frame.u);
      face.v[i] = dot(edge[i], face.frame.v);
    }
    return face;
  }
  /// Of acute triangles the part about the circumcentre; obtuse ones are cut at their sides'
  /// middles.
  static void setShares(const Edges& edge, double share[3])
  {
    const Vec3d doubleArea = cross(edge[0], edge[1]);
    const double area = 0.5 * std::sqrt(dot(doubleArea, doubleArea));
    double squared[3], weight[3];
    for (int i = 0; i < 3; ++i)
      squared[i] = dot(edge[static_cast<std::size_t>(i)], edge[static_cast<std::size_t>(i)]);
    for (int i = 0; i < 3; ++i)
      weight[i] = squared[i] * (squared[(i + 1) % 3] + squared[(i + 2) % 3] - squared[i]);
    for (int i = 0; i < 3; ++i)
      if (weight[i] <= 0) {
        for (int k = 0; k < 3; ++k)
          share[k] = k == i ? 0.5 * area : 0.25 * area;
        return;
      }
    const double sum = weight[0] + weight[1] + weight[2];
    for (int i = 0; i < 3; ++i)
      share[i] = 0.5 * area * (weight[(i + 1) % 3] + weight[(i + 2) % 3]) / sum;
  }

  Vec3d normal(std::uint32_t v) const { return vec3Cast<double>(normals_[v]); }

  Tensor fit(std::size_t t) const
  {
    const Face face = faceOf(t);
    std::array<std::array<double, 3>, 3> a = {};
    std::array<double, 3> b = {};
    for (int i = 0; i < 3; ++i) {
      const Vec3d change = normal(face.vertex[(i + 2) % 3]) - normal(face.vertex[(i + 1) % 3]);
      const double du = dot(change, face.frame.u), dv = dot(change, face.frame.v);
      const double u = face.u[i], v = face.v[i];
      add<3>({u, v, 0}, du, a, b);
      add<3>({0, u, v}, dv, a, b);
    }
    return solved<3>(a, b);
  }
  TensorSlope fitSlope(std::size_t t) const
  {
    const Face face = faceOf(t);
    Tensor at[3];
    for (int i = 0; i < 3; ++i)
      at[i] = inFrame(tensors_[face.vertex[i]], frames_[face.vertex[i]], face.frame);
    std::array<std::array<double, 4>, 4> a = {};
    std::array<double, 4> b = {};
    for (int i = 0; i < 3; ++i) {
      const double u = face.u[i], v = face.v[i];
      const Tensor &from = at[(i + 1) % 3], &to = at[(i + 2) % 3];
      add<4>({u, v, 0, 0}, to[0] - from[0], a, b);
      // f stands twice in the tensor.
      add<4>({0, u, v, 0}, to[1] - from[1], a, b);
      add<4>({0, u, v, 0}, to[1] - from[1], a, b);
      add<4>({0, 0, u, v}, to[2] - from[2], a, b);
    }
    return solved<4>(a, b);
  }
  /// One equation of the least squares.
  template <std::size_t n>
  static void add(const std::array<double, n>& row, double right,
                  std::array<std::array<double, n>, n>& a, std::array<double, n>& b)
  {
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t k = 0; k < n; ++k)
        a[i][k] += row[i] * row[k];
      b[i] += row[i] * right;
    }
  }

  /// Any frame about the vertex' normal.
  Frame firstFrame(std::size_t v) const
  {
    const Vec3d n = vec3Cast<double>(normals_[v]);
    const bool isAlongX = std::fabs(n.x) > 0.7;
    const Vec3d u = normalized(cross(n, isAlongX ? Vec3d{0, 1, 0} : Vec3d{1, 0, 0}));
    return {u, cross(n, u)};
  }

  template <class Quantity>
  Quantity mean(std::size_t v, const std::vector<Quantity>& ofFace) const
  {
    Quantity sum = {};
    double weight = 0;
    for (const std::uint32_t corner : corners_.of(v)) {
      const FacePlane plane = keptPlane(corner / 3);
      const Quantity here = inFrame(ofFace[corner / 3], plane.frame, frames_[v]);
      const double share = plane.share[corner % 3];
      for (std::size_t k = 0; k < sum.size(); ++k)
        sum[k] += share * here[k];
      weight += share;
    }
    for (double& one : sum)
      one = weight > 0 ? one / weight : 0.0;
    return sum;
  }

  /// Makes the tensor diagonal, the larger curvature first.
  void turnToPrincipal(std::size_t v)
  {
    Tensor& t = tensors_[v];
    double c = 1, s = 0, tangent = 0;
    if (t[1] != 0) {
      const double h = 0.5 * (t[2] - t[0]) / t[1];
      tangent = (h < 0 ? -1.0 : 1.0) / (std::fabs(h) + std::sqrt(1 + h * h));
      c = 1 / std::sqrt(1 + tangent * tangent);
      s = tangent * c;
    }
    double k1 = t[0] - tangent * t[1], k2 = t[2] + tangent * t[1];
    Frame frame = {frames_[v].u * c - frames_[v].v * s, frames_[v].u * s + frames_[v].v * c};
    if (std::fabs(k1) < std::fabs(k2)) {
      std::swap(k1, k2);
      frame = {frame.v, -frame.u};
    }
    t = {k1, 0, k2};
    frames_[v] = frame;
  }

  const MeshView& mesh_;
  Span<const Vec3f> normals_;
  int threads_;
  std::vector<char> isProper_;
  CornerLists corners_;
  Array<FacePlane> kept_;  ///< by triangle; none of a mesh with too many
  std::vector<Frame> frames_;
  std::vector<Tensor> tensors_;
};

}  // namespace

std::vector<VertexCurvature> vertexCurvature(const MeshView& mesh, Span<const Vec3f> normals,
                                             int threads)
{
  return CurvatureEstimator(mesh, normals, threads).estimate();
}

}  // namespace limn
