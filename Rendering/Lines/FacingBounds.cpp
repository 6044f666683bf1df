// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/FacingBounds.h"

#include "Rendering/Base/ParallelStretches.h"
#include "Rendering/Mesh/EdgesAhead.h"
#include "Rendering/Mesh/FetchPosition.h"
#include "Rendering/Mesh/LocalPosition.h"
#include "Rendering/Mesh/RecentValues.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace limn {
namespace {

constexpr std::size_t kBoxesPerTask = 512;

/// Lower triangles than this share of the mesh's reach may turn over by rounding.
constexpr double kLeastHeight = 1e-7;
/// By how much rounding may turn a plane of a triangle of that height, with room to spare.
constexpr double kTurn = 1e-5;
/// What a box' float may lack of a double, with room to spare.
constexpr double kFloatSlack = 1e-6;

class BoxBuilder {
 public:
  void add(Vec3d n, double distance)
  {
    const double values[4] = {n.x, n.y, n.z, distance};
    for (int i = 0; i < 4; ++i) {
      low_[i] = std::min(low_[i], values[i]);
      high_[i] = std::max(high_[i], values[i]);
      isKnown_ = isKnown_ && std::fabs(values[i]) < std::numeric_limits<float>::max();
    }
  }
  void addUnknown() { isKnown_ = false; }

  PlaneBox box() const
  {
    PlaneBox result = {};
    for (int i = 0; i < 4; ++i) {
      if (!isKnown_ || !(low_[i] <= high_[i])) {
        result.half[i] = std::numeric_limits<float>::infinity();
        continue;
      }
      const double size = std::max(std::fabs(low_[i]), std::fabs(high_[i]));
      result.middle[i] = static_cast<float>(0.5 * (low_[i] + high_[i]));
      result.half[i] = static_cast<float>(0.5 * (high_[i] - low_[i]) + kFloatSlack * size);
    }
    return result;
  }

 private:
  static constexpr double kFar = std::numeric_limits<double>::infinity();
  double low_[4] = {kFar, kFar, kFar, kFar}, high_[4] = {-kFar, -kFar, -kFar, -kFar};
  bool isKnown_ = true;
};

double lengthOf(Vec3d v)
{
  return std::sqrt(dot(v, v));
}

FacingBounds boundsOf(const Box& box)
{
  FacingBounds bounds;
  if (box.empty()) return bounds;
  bounds.center = (box.low + box.high) * 0.5;
  bounds.radius = lengthOf(box.high - bounds.center);
  bounds.reach = lengthOf(bounds.center) + bounds.radius;
  return bounds;
}

/// A plane that a box is about.
struct Plane {
  Vec3d normal;
  double distance;
  bool isKnown;
};

void add(const Plane& plane, BoxBuilder& box)
{
  if (plane.isKnown)
    box.add(plane.normal, plane.distance);
  else
    box.addUnknown();
}

/// Adder(source) makes what adds the planes of edges, one for each task: fetchFirst(edge) and
/// fetchThen(edge) are for forEachEdgeAhead(), add(edge's number, box) for each edge.
template <class Adder, class Source>
void fillBoxes(const EdgeTable& table, int threads, const Source& source, FacingBounds& bounds)
{
  bounds.boxes.resize(stretchCount(table.edges.size(), kEdgesPerBound));
  constexpr std::size_t kEdgesPerTask = kBoxesPerTask * kEdgesPerBound;
  parallelForStretches(threads, table.edges.size(), kEdgesPerTask,
                       [&](std::size_t, std::size_t first, std::size_t end) {
                         Adder adder(source);
                         BoxBuilder box;
                         forEachEdgeAhead(
                             table, first, end,
                             [&](const MeshEdge& edge) { adder.fetchFirst(edge); },
                             [&](const MeshEdge& edge) { adder.fetchThen(edge); },
                             [&](std::size_t e) {
                               adder.add(e, box);
                               if ((e + 1) % kEdgesPerBound != 0 && e + 1 != end) return;
                               bounds.boxes[e / kEdgesPerBound] = box.box();
                               box = {};
                             });
                       });
}

/// What planes are made of.
struct PlaneSource {
  const MeshView& mesh;
  const EdgeTable& table;
  Span<const Vec3f> normals;
  Span<const std::uint32_t> normalOfCorner;
  Vec3d center;
  double leastHeight;
};

/// Through a vertex.
Plane planeOf(const PlaneSource& source, std::uint32_t normal, std::uint32_t vertex)
{
  const Vec3d n = vec3Cast<double>(source.normals[normal]);
  const double length = lengthOf(n);
  if (!(length > 0)) return {{0, 0, 0}, 0, false};
  const Vec3d unit = n * (1 / length);
  return {unit, dot(unit, source.mesh.position(vertex) - source.center), true};
}

class FaceAdder {
 public:
  explicit FaceAdder(const PlaneSource& source) : source_(source) {}

  void fetchFirst(const MeshEdge& edge) const
  {
    forEachUnknown(edge, [](const Triangle* triangle) { prefetch(triangle); });
  }
  void fetchThen(const MeshEdge& edge) const
  {
    forEachUnknown(edge, [this](const Triangle* triangle) {
      for (const std::uint32_t vertex : triangle->vertex)
        fetchPosition(source_.mesh, vertex);
    });
  }
  void add(std::size_t e, BoxBuilder& box)
  {
    const MeshEdge& edge = source_.table.edges[e];
    if (!edge.isShared()) return;
    for (int f = 0; f < 2; ++f) {
      Plane plane = planes_.at(edge.corner[f] / 3, [this](std::uint32_t t) { return planeOf(t); });
      if (f == 1 && source_.table.woundAlike[e] == 0)
        plane = {-plane.normal, -plane.distance, plane.isKnown};
      limn::add(plane, box);
    }
  }

 private:
  template <class Body>
  void forEachUnknown(const MeshEdge& edge, const Body& body) const
  {
    forEachFace(edge, [&](std::uint32_t corner) {
      if (!planes_.has(corner / 3)) body(source_.mesh.triangles.data() + corner / 3);
    });
  }
  Plane planeOf(std::uint32_t triangle) const
  {
    const MeshView& mesh = source_.mesh;
    const auto [a, b, c] = mesh.triangles[triangle].vertex;
    const Vec3d p = mesh.position(a), ab = mesh.position(b) - p, ac = mesh.position(c) - p;
    const Vec3d bc = ac - ab, n = cross(ab, ac);
    const double length = lengthOf(n);
    const double longest = std::sqrt(std::max({dot(ab, ab), dot(ac, ac), dot(bc, bc)}));
    if (!(length > source_.leastHeight * longest)) return {{0, 0, 0}, 0, false};
    const Vec3d unit = n * (1 / length);
    return {unit, dot(unit, p - source_.center), true};
  }

  const PlaneSource& source_;
  RecentValues<Plane> planes_;  ///< by triangle
};

class NormalAdder {
 public:
  explicit NormalAdder(const PlaneSource& source) : source_(source) {}

  void fetchFirst(const MeshEdge& edge) const
  {
    forEachFace(edge, [this](std::uint32_t corner) {
      prefetch(source_.mesh.triangles.data() + corner / 3);
      if (!source_.normalOfCorner.empty()) prefetch(source_.normalOfCorner.data() + corner);
    });
  }
  void fetchThen(const MeshEdge& edge) const
  {
    forEachFace(edge, [this](std::uint32_t corner) {
      fetchAt(corner);
      fetchAt(nextCorner(corner));
    });
  }
  void add(std::size_t e, BoxBuilder& box)
  {
    const MeshEdge& edge = source_.table.edges[e];
    const VertexNormal first = at(edge.corner[0]), second = at(nextCorner(edge.corner[0]));
    add(first, box);
    add(second, box);
    if (!edge.isShared()) return;
    // The second face has the same ones where the surface is smooth.
    for (const std::uint32_t corner : {edge.corner[1], nextCorner(edge.corner[1])})
      if (const VertexNormal one = at(corner); !(one == first) && !(one == second)) add(one, box);
  }

 private:
  struct VertexNormal {
    std::uint32_t vertex, number;

    bool operator==(const VertexNormal& other) const
    {
      return vertex == other.vertex && number == other.number;
    }
  };
  struct VertexPlane {
    std::uint32_t vertex;
    Plane plane;
  };

  std::uint32_t vertexOf(std::uint32_t corner) const
  {
    return source_.mesh.triangles[corner / 3].vertex[corner % 3];
  }
  std::uint32_t numberOf(std::uint32_t corner) const
  {
    return source_.normalOfCorner.empty() ? vertexOf(corner) : source_.normalOfCorner[corner];
  }
  void fetchAt(std::uint32_t corner) const
  {
    const std::uint32_t number = numberOf(corner);
    if (planes_.has(number)) return;
    prefetch(source_.normals.data() + number);
    fetchPosition(source_.mesh, vertexOf(corner));
  }
  VertexNormal at(std::uint32_t corner) const { return {vertexOf(corner), numberOf(corner)}; }
  void add(const VertexNormal& one, BoxBuilder& box)
  {
    const auto plane = [&] { return planeOf(source_, one.number, one.vertex); };
    const VertexPlane& known = planes_.at(one.number, [&](std::uint32_t) {
      return VertexPlane{one.vertex, plane()};
    });
    // A normal may be that of several vertices.
    limn::add(known.vertex == one.vertex ? known.plane : plane(), box);
  }

  const PlaneSource& source_;
  RecentValues<VertexPlane> planes_;  ///< by normal
};

/// By the normals of the edges' ends themselves.
class EndAdder {
 public:
  explicit EndAdder(const PlaneSource& source) : source_(source) {}

  void fetchFirst(const MeshEdge& edge) const
  {
    for (const std::uint32_t vertex : edge.vertex) {
      if (planes_.has(vertex)) continue;
      prefetch(source_.normals.data() + vertex);
      fetchPosition(source_.mesh, vertex);
    }
  }
  void fetchThen(const MeshEdge&) const {}
  void add(std::size_t e, BoxBuilder& box)
  {
    forEachNewEnd(source_.table, e, [&](std::uint32_t vertex) {
      limn::add(planes_.at(vertex, [this](std::uint32_t v) { return planeOf(source_, v, v); }),
                box);
    });
  }

 private:
  const PlaneSource& source_;
  RecentValues<Plane> planes_;  ///< by vertex
};

/// Frobenius norm.
double sizeOf(const Mat4d& a)
{
  double sum = 0;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      sum += a.m[row][column] * a.m[row][column];
  return std::sqrt(sum);
}

}  // namespace

FacingBounds boundFaces(const MeshView& mesh, const EdgeTable& table, int threads)
{
  FacingBounds bounds = boundsOf(finiteBox(mesh, threads));
  const PlaneSource source = {mesh, table, {}, {}, bounds.center, kLeastHeight * bounds.reach};
  fillBoxes<FaceAdder>(table, threads, source, bounds);
  return bounds;
}

FacingBounds boundNormals(const MeshView& mesh, const EdgeTable& table, const FeatureArrays& arrays,
                          int threads)
{
  FacingBounds bounds = boundsOf(finiteBox(mesh, threads));
  const PlaneSource source = {mesh,          table, arrays.vertexNormals, arrays.normalOfCorner,
                              bounds.center, 0};
  fillBoxes<NormalAdder>(table, threads, source, bounds);
  return bounds;
}

FacingBounds boundEnds(const MeshView& mesh, const Box& box, const EdgeTable& table,
                       Span<const Vec3f> normals, int threads)
{
  FacingBounds bounds = boundsOf(box);
  const PlaneSource source = {mesh, table, normals, {}, bounds.center, 0};
  fillBoxes<EndAdder>(table, threads, source, bounds);
  return bounds;
}

ModelEye::ModelEye(const Camera& camera, const Mat4d& modelToWorld) : isParallel(camera.parallel)
{
  const Mat4d toView = camera.worldToView * modelToWorld;
  place = ModelDirections(toView)(
      isParallel ? Vec3d{0, 0, 1} : Vec3d{-toView.m[0][3], -toView.m[1][3], -toView.m[2][3]});
}

BoundedFacing::BoundedFacing(const FacingBounds& bounds, const Camera& camera,
                             const Mat4d& modelToWorld)
    : boxes_(bounds.boxes)
{
  const Mat4d toView = camera.worldToView * modelToWorld;
  const ModelEye eye(camera, modelToWorld);
  // Of a parallel camera, too: coordinates are rounded by where its view begins.
  const ModelEye origin({camera.worldToView, camera.viewToClip, false}, modelToWorld);
  const double condition =
      sizeOf(toView) * sizeOf(cofactor3(toView)) / std::fabs(determinant3(toView));
  const Vec3d direction = eye.isParallel ? eye.place : eye.place - bounds.center;
  const double values[4] = {direction.x, direction.y, direction.z, eye.isParallel ? 0.0 : -1.0};
  for (int i = 0; i < 4; ++i) {
    eye_[i] = values[i];
    size_[i] = std::fabs(values[i]);
  }
  const double length = lengthOf(direction) + (eye.isParallel ? 0 : bounds.radius);
  margin_ = kTurn * condition * (1 + lengthOf(origin.place) / bounds.reach) * length;
}

}  // namespace limn
