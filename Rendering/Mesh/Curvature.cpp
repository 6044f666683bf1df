// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Mesh/Curvature.h"

#include "Rendering/Base/Array.h"
#include "Rendering/Base/ParallelStretches.h"
#include "Rendering/Mesh/CornerLists.h"
#include "Rendering/Mesh/FetchPosition.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace limn {
namespace {

constexpr std::size_t kPerTask = 4096;
/// Of more triangles the planes, 96 bytes each, are computed anew wherever they are needed.
constexpr std::size_t kMostKept = std::size_t{1} << 22;

/// Two unit vectors that span a plane.
struct Frame {
  Vec3d u, v;

  Vec3d normal() const { return cross(u, v); }
};

/// The frame, of the normal `old`, turned the shortest way, so that its normal becomes `normal`.
inline Frame turned(const Frame& frame, Vec3d old, Vec3d normal)
{
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

/// Of a tensor in the frame `from`; `in` is the other frame, turned into its plane.
inline Tensor inFrame(const Tensor& t, const Frame& from, const Frame& in)
{
  const double u1 = dot(in.u, from.u), v1 = dot(in.u, from.v);
  const double u2 = dot(in.v, from.u), v2 = dot(in.v, from.v);
  return {t[0] * u1 * u1 + t[1] * (2 * u1 * v1) + t[2] * v1 * v1,
          t[0] * u1 * u2 + t[1] * (u1 * v2 + u2 * v1) + t[2] * v1 * v2,
          t[0] * u2 * u2 + t[1] * (2 * u2 * v2) + t[2] * v2 * v2};
}

inline TensorSlope inFrame(const TensorSlope& s, const Frame& from, const Frame& in)
{
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

/// The least squares of equations that tie two unknowns in a row: u x[i] + v x[i + 1] = right. So
/// their matrix has nothing but its diagonal and what is beside it.
template <std::size_t n>
class LeastSquares {
 public:
  void add(std::size_t i, double u, double v, double right)
  {
    diagonal_[i] += u * u;
    beside_[i] += u * v;
    diagonal_[i + 1] += v * v;
    right_[i] += u * right;
    right_[i + 1] += v * right;
  }

  /// By Gauss's elimination without pivots, as the matrix is positive where the equations settle
  /// all; zeros where they do not.
  std::array<double, n> solution() const
  {
    double largest = 0;
    for (const double one : diagonal_)
      largest = std::max(largest, one);
    std::array<double, n> diagonal = diagonal_, x = right_;
    for (std::size_t i = 0; i < n; ++i) {
      constexpr double kTooSmall = 1e-12;
      if (!(diagonal[i] > kTooSmall * largest)) return {};
      if (i + 1 == n) break;
      const double factor = beside_[i] / diagonal[i];
      diagonal[i + 1] -= factor * beside_[i];
      x[i + 1] -= factor * x[i];
    }
    x[n - 1] /= diagonal[n - 1];
    for (std::size_t i = n - 1; i-- > 0;)
      x[i] = (x[i] - beside_[i] * x[i + 1]) / diagonal[i];
    return x;
  }

 private:
  std::array<double, n> diagonal_ = {}, right_ = {};
  std::array<double, n - 1> beside_ = {};
};

/// Where a triangle lies, and what is fitted to it: a Tensor and then a TensorSlope. Two cache
/// lines, as vertices ask for the triangles about them one by one.
struct alignas(kCacheLine) Face {
  Frame frame;
  Vec3d normal;     ///< of the frame
  double share[3];  ///< of its area, nearest to each vertex
  std::array<double, 4> fitted;
};

/// How a surface bends at a vertex.
struct alignas(kCacheLine) Bend {
  Frame frame;
  double curvature[2];  ///< along u and v, between which there is none
};

class CurvatureEstimator {
 public:
  CurvatureEstimator(const MeshView& mesh, Span<const Vec3f> normals, int threads)
      : mesh_(mesh),
        normals_(normals),
        threads_(threads),
        isProper_(mesh.triangles.size()),
        bends_(mesh.vertexCount())
  {
    if (mesh.triangles.size() <= kMostKept)
      kept_.resize(mesh.triangles.size());
    else
      fitted_.resize(mesh.triangles.size());
  }

  Array<VertexCurvature> estimate()
  {
    const std::size_t vertices = mesh_.vertexCount();
    forEachTriangle([&](std::uint32_t v) { prefetch(normals_.data() + v); },
                    [&](std::size_t t) { fitTensor(t); });
    const CornerLists corners(mesh_, threads_, [this](std::size_t t) { return isProper_[t] != 0; });
    forEachVertex(corners, [&](std::size_t v) {
      Bend& bend = bends_[v];
      bend.frame = firstFrame(v);
      turnToPrincipal(mean<Tensor>(corners.of(v), bend.frame), bend);
    });
    forEachTriangle([&](std::uint32_t v) { prefetch(bends_.data() + v); },
                    [&](std::size_t t) {
                      if (isProper_[t] != 0) fitSlope(t);
                    });
    Array<VertexCurvature> result(vertices);
    forEachVertex(corners, [&](std::size_t v) {
      const Bend& bend = bends_[v];
      const TensorSlope slope = mean<TensorSlope>(corners.of(v), bend.frame);
      VertexCurvature& out = result[v];
      out.direction[0] = vec3Cast<float>(bend.frame.u);
      out.direction[1] = vec3Cast<float>(bend.frame.v);
      out.curvature[0] = static_cast<float>(bend.curvature[0]);
      out.curvature[1] = static_cast<float>(bend.curvature[1]);
      for (std::size_t i = 0; i < 4; ++i)
        out.derivative[i] = static_cast<float>(slope[i]);
    });
    return result;
  }

 private:
  /// Calls visit(number), and a while before fetches where its vertices lie, and fetch(vertex).
  template <class Fetch, class Visit>
  void forEachTriangle(const Fetch& fetch, const Visit& visit) const
  {
    constexpr std::size_t kAhead = 12;
    const std::size_t vertices = mesh_.vertexCount();
    parallelForStretches(threads_, mesh_.triangles.size(), kPerTask,
                         [&](std::size_t, std::size_t begin, std::size_t end) {
                           for (std::size_t t = begin; t < end; ++t) {
                             if (t + kAhead < end)
                               for (const std::uint32_t v : mesh_.triangles[t + kAhead].vertex)
                                 if (v < vertices) {
                                   fetchPosition(mesh_, v);
                                   fetch(v);
                                 }
                             visit(t);
                           }
                         });
  }
  /// Calls visit(number); what is kept of the triangles there is fetched a while before.
  template <class Visit>
  void forEachVertex(const CornerLists& corners, const Visit& visit) const
  {
    constexpr std::size_t kAhead = 4;
    const auto fetch = [&](std::size_t t) {
      if (kept_.empty()) {
        prefetch(mesh_.triangles.data() + t);
        prefetch(fitted_.data() + t);
        return;
      }
      const auto* const line = reinterpret_cast<const char*>(kept_.data() + t);
      prefetch(line);
      prefetch(line + kCacheLine);
    };
    parallelForStretches(threads_, mesh_.vertexCount(), kPerTask,
                         [&](std::size_t, std::size_t begin, std::size_t end) {
                           for (std::size_t v = begin; v < end; ++v) {
                             if (v + kAhead < end)
                               for (const std::uint32_t corner : corners.of(v + kAhead))
                                 fetch(corner / 3);
                             visit(v);
                           }
                         });
  }

  using Corners = std::array<Vec3d, 3>;

  Corners cornersOf(std::size_t t) const
  {
    const auto [a, b, c] = mesh_.triangles[t].vertex;
    return {mesh_.position(a), mesh_.position(b), mesh_.position(c)};
  }
  /// Of a triangle whose corners all exist, and that has an area.
  bool isProper(std::size_t t) const
  {
    const auto [a, b, c] = mesh_.triangles[t].vertex;
    const std::size_t count = mesh_.vertexCount();
    if (a >= count || b >= count || c >= count) return false;
    const Corners p = cornersOf(t);
    const Vec3d area = cross(p[1] - p[0], p[2] - p[0]);
    return isFinite(area) && dot(area, area) > 0;
  }

  /// Opposite to each vertex, from the next one to the one before.
  using Edges = std::array<Vec3d, 3>;

  static Edges edgesOf(const Corners& p) { return {p[2] - p[1], p[0] - p[2], p[1] - p[0]}; }
  static Face planeOf(const Edges& edge)
  {
    Face face = {};
    const Vec3d normal = normalized(cross(edge[0], edge[1]));
    face.frame.u = normalized(edge[0]);
    face.frame.v = cross(normal, face.frame.u);
    face.normal = face.frame.normal();
    setShares(edge, face.share);
    return face;
  }
  /// Of a proper triangle.
  Face faceOf(std::size_t t) const
  {
    if (!kept_.empty()) return kept_[t];
    Face face = planeOf(edgesOf(cornersOf(t)));
    face.fitted = fitted_[t];
    return face;
  }
  std::array<double, 4>& fittedTo(std::size_t t)
  {
    return kept_.empty() ? fitted_[t] : kept_[t].fitted;
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

  void fitTensor(std::size_t t)
  {
    isProper_[t] = isProper(t) ? 1 : 0;
    if (isProper_[t] == 0) return;
    const Edges edge = edgesOf(cornersOf(t));
    const Face face = planeOf(edge);
    if (!kept_.empty()) kept_[t] = face;
    const auto& vertex = mesh_.triangles[t].vertex;
    const Vec3d n[3] = {normal(vertex[0]), normal(vertex[1]), normal(vertex[2])};
    LeastSquares<3> equations;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3d change = n[(i + 2) % 3] - n[(i + 1) % 3];
      const double u = dot(edge[i], face.frame.u), v = dot(edge[i], face.frame.v);
      equations.add(0, u, v, dot(change, face.frame.u));
      equations.add(1, u, v, dot(change, face.frame.v));
    }
    const Tensor tensor = equations.solution();
    fittedTo(t) = {tensor[0], tensor[1], tensor[2], 0};
  }
  void fitSlope(std::size_t t)
  {
    const Edges edge = edgesOf(cornersOf(t));
    const Face face = faceOf(t);
    Tensor at[3];
    for (std::size_t i = 0; i < 3; ++i) {
      const Bend& bend = bends_[mesh_.triangles[t].vertex[i]];
      at[i] = inFrame(Tensor{bend.curvature[0], 0, bend.curvature[1]}, bend.frame,
                      turned(face.frame, face.normal, bend.frame.normal()));
    }
    LeastSquares<4> equations;
    for (std::size_t i = 0; i < 3; ++i) {
      const double u = dot(edge[i], face.frame.u), v = dot(edge[i], face.frame.v);
      const Tensor &from = at[(i + 1) % 3], &to = at[(i + 2) % 3];
      equations.add(0, u, v, to[0] - from[0]);
      // f stands twice in the tensor.
      equations.add(1, u, v, to[1] - from[1]);
      equations.add(1, u, v, to[1] - from[1]);
      equations.add(2, u, v, to[2] - from[2]);
    }
    fittedTo(t) = equations.solution();
  }

  /// Any frame about the vertex' normal.
  Frame firstFrame(std::size_t v) const
  {
    const Vec3d n = vec3Cast<double>(normals_[v]);
    const bool isAlongX = std::fabs(n.x) > 0.7;
    const Vec3d u = normalized(cross(n, isAlongX ? Vec3d{0, 1, 0} : Vec3d{1, 0, 0}));
    return {u, cross(n, u)};
  }

  /// What is fitted to the triangles of these corners, in the frame of their vertex.
  template <class Quantity>
  Quantity mean(Span<const std::uint32_t> corners, const Frame& frame) const
  {
    const Vec3d normal = frame.normal();
    Quantity sum = {};
    double weight = 0;
    const auto add = [&](const Face& face, std::size_t k) {
      Quantity fitted;
      std::copy_n(face.fitted.begin(), fitted.size(), fitted.begin());
      const Quantity here = inFrame(fitted, face.frame, turned(frame, normal, face.normal));
      const double share = face.share[k];
      for (std::size_t i = 0; i < sum.size(); ++i)
        sum[i] += share * here[i];
      weight += share;
    };
    for (const std::uint32_t corner : corners)
      if (kept_.empty())
        add(faceOf(corner / 3), corner % 3);
      else
        add(kept_[corner / 3], corner % 3);
    for (double& one : sum)
      one = weight > 0 ? one / weight : 0.0;
    return sum;
  }

  /// Makes the tensor diagonal, the larger curvature first.
  static void turnToPrincipal(const Tensor& t, Bend& bend)
  {
    double c = 1, s = 0, tangent = 0;
    if (t[1] != 0) {
      const double h = 0.5 * (t[2] - t[0]) / t[1];
      tangent = (h < 0 ? -1.0 : 1.0) / (std::fabs(h) + std::sqrt(1 + h * h));
      c = 1 / std::sqrt(1 + tangent * tangent);
      s = tangent * c;
    }
    double k1 = t[0] - tangent * t[1], k2 = t[2] + tangent * t[1];
    Frame frame = {bend.frame.u * c - bend.frame.v * s, bend.frame.u * s + bend.frame.v * c};
    if (std::fabs(k1) < std::fabs(k2)) {
      std::swap(k1, k2);
      frame = {frame.v, -frame.u};
    }
    bend = {frame, {k1, k2}};
  }

  const MeshView& mesh_;
  Span<const Vec3f> normals_;
  int threads_;
  Array<std::uint8_t> isProper_;         ///< by triangle
  Array<Face> kept_;                     ///< by triangle; none of a mesh with too many
  Array<std::array<double, 4>> fitted_;  ///< then what is fitted to them alone
  Array<Bend> bends_;
};

}  // namespace

Array<VertexCurvature> vertexCurvature(const MeshView& mesh, Span<const Vec3f> normals, int threads)
{
  return CurvatureEstimator(mesh, normals, threads).estimate();
}

}  // namespace limn
