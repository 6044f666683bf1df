// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/Intersections.h"

#include "Rendering/Base/Executor.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace limn {
namespace {

constexpr std::size_t kTrianglesPerTask = 4096;

bool overlap(const Box& a, const Box& b)
{
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y &&
         a.low.z <= b.high.z && b.low.z <= a.high.z;
}

Box grown(Box box, double by)
{
  const Vec3d far = {by, by, by};
  box.low = box.low - far;
  box.high = box.high + far;
  return box;
}

double sumOfSizes(Vec3d v)
{
  return (std::fabs(v.x) + std::fabs(v.y)) + std::fabs(v.z);
}
/// The sign of a product that is a distance times `scale`, at most, and grows by `slope` times the
/// move of what is moved.
bool isPositive(double product, double scale, double rounding, Vec3d slope, bool isMoved)
{
  if (std::fabs(product) > rounding * scale) return product > 0;
  return (dot(slope, kCutMove) >= 0) == isMoved;
}

/// A triangle's corners by their numbers, so that what is computed of an edge does not depend on
/// the triangle.
struct Corners {
  std::uint32_t number[3];
  Vec3d place[3];
  Vec3d normal;
  double scale;     ///< of side()
  double rounding;  ///< of distances

  Corners(const WorldMesh& world, std::uint32_t triangle)
  {
    std::copy_n(world.triangles[triangle].vertex, 3, number);
    std::sort(number, number + 3);
    for (int k = 0; k < 3; ++k)
      place[k] = world.points[number[k]];
    normal = cross(place[1] - place[0], place[2] - place[0]);
    scale = sumOfSizes(place[1] - place[0]) * sumOfSizes(place[2] - place[0]);
    rounding = kCutRounding * world.size;
  }
  double side(Vec3d p) const { return dot(normal, p - place[0]); }
};

class Cutter {
 public:
  Cutter(const WorldMesh& world, const TriangleTree& tree, Span<const std::uint8_t> isWanted)
      : world_(world), tree_(tree), isWanted_(isWanted)
  {
  }

  /// With all triangles after it.
  void cut(std::uint32_t first, std::vector<CutPiece>& pieces)
  {
    if (world_.isBroken(first)) return;
    const Corners a(world_, first);
    const Box box = grown(boxOf(first), kCutBoxRoundings * a.rounding);
    found_.clear();
    tree_.visit([&](const Box& other) { return overlap(box, other); },
                [&](std::uint32_t t) {
                  if (t > first && overlap(box, boxOf(t)) && mayCut(first, t)) found_.push_back(t);
                });
    std::sort(found_.begin(), found_.end());
    for (const std::uint32_t second : found_) {
      const Corners b(world_, second);
      CutPiece piece = {{first, second}, {}};
      int count = 0;
      const bool isFirstMoved = world_.body[first] > world_.body[second];
      addEdges(a, b, second, isFirstMoved, piece, count);
      addEdges(b, a, first, !isFirstMoved, piece, count);
      if (count == 2) pieces.push_back(piece);
    }
  }

 private:
  Box boxOf(std::uint32_t triangle) const
  {
    Box box;
    for (int k = 0; k < 3; ++k)
      box.add(world_.corner(triangle, k));
    return box;
  }
  bool mayCut(std::uint32_t first, std::uint32_t second) const
  {
    const std::uint32_t bodies[2] = {world_.body[first], world_.body[second]};
    if (isWanted_[bodies[0]] == 0 && isWanted_[bodies[1]] == 0) return false;
    if (bodies[0] != bodies[1]) return true;
    for (const std::uint32_t p : world_.triangles[first].vertex)
      for (const std::uint32_t q : world_.triangles[second].vertex)
        if (p == q) return false;
    return true;
  }

  /// Where edges of one go through the other, whose number is `number`.
  static void addEdges(const Corners& one, const Corners& other, std::uint32_t number, bool isMoved,
                       CutPiece& piece, int& count)
  {
    double side[3];
    bool isAbove[3];
    for (int k = 0; k < 3; ++k) {
      side[k] = other.side(one.place[k]);
      isAbove[k] = isPositive(side[k], other.scale, other.rounding, other.normal, isMoved);
    }
    constexpr int kEnds[3][2] = {{0, 1}, {0, 2}, {1, 2}};
    for (const auto& [i, j] : kEnds) {
      if (isAbove[i] == isAbove[j]) continue;
      const Vec3d p = one.place[i], q = one.place[j];
      if (!passes(p, q, other, isMoved)) continue;
      if (count < 2)
        piece.end[count] = {
            {one.number[i], one.number[j]}, number, p + (q - p) * (side[i] / (side[i] - side[j]))};
      ++count;
    }
  }
  /// Whether the straight line through p and q runs inside of all edges.
  static bool passes(Vec3d p, Vec3d q, const Corners& other, bool isMoved)
  {
    const Vec3d r[3] = {other.place[0] - p, other.place[1] - p, other.place[2] - p};
    const auto isLeft = [&](int i, int j) {
      const Vec3d along = r[j] - r[i];
      return isPositive(dot(q - p, cross(r[i], r[j])), sumOfSizes(q - p) * sumOfSizes(along),
                        other.rounding, cross(q - p, along), isMoved);
    };
    const bool left01 = isLeft(0, 1), left12 = isLeft(1, 2), left02 = isLeft(0, 2);
    return left01 == left12 && left12 != left02;
  }

  const WorldMesh& world_;
  const TriangleTree& tree_;
  Span<const std::uint8_t> isWanted_;
  std::vector<std::uint32_t> found_;
};

bool isBefore(const CutPoint& a, const CutPoint& b)
{
  return std::tie(a.point[0], a.point[1], a.triangle) <
         std::tie(b.point[0], b.point[1], b.triangle);
}

}  // namespace

std::vector<CutPiece> intersections(const WorldMesh& world, const TriangleTree& tree,
                                    Span<const std::uint8_t> isWanted, int threads)
{
  const std::size_t count = world.triangles.size();
  const std::size_t tasks = (count + kTrianglesPerTask - 1) / kTrianglesPerTask;
  std::vector<std::vector<CutPiece>> found(tasks);
  parallelFor(threads, tasks, [&](std::size_t task) {
    Cutter cutter(world, tree, isWanted);
    const std::size_t end = std::min(count, (task + 1) * kTrianglesPerTask);
    for (std::size_t t = task * kTrianglesPerTask; t < end; ++t)
      cutter.cut(static_cast<std::uint32_t>(t), found[task]);
  });
  std::vector<CutPiece> pieces;
  for (const std::vector<CutPiece>& some : found)
    pieces.insert(pieces.end(), some.begin(), some.end());
  return pieces;
}

ContourLines intersectionLines(const WorldMesh& world, Span<const CutPiece> pieces,
                               Span<const std::uint8_t> isWanted, std::size_t body,
                               const Mat4d& worldToModel)
{
  std::vector<const CutPiece*> own;
  std::vector<CutPoint> ends;
  for (const CutPiece& piece : pieces) {
    const std::uint32_t first = world.body[piece.triangle[0]];
    if ((isWanted[first] != 0 ? first : world.body[piece.triangle[1]]) != body) continue;
    own.push_back(&piece);
    ends.insert(ends.end(), piece.end, piece.end + 2);
  }
  std::sort(ends.begin(), ends.end(), isBefore);
  ends.erase(std::unique(ends.begin(), ends.end(),
                         [](const CutPoint& a, const CutPoint& b) {
                           return !isBefore(a, b) && !isBefore(b, a);
                         }),
             ends.end());
  const auto numberOf = [&](const CutPoint& end) {
    return static_cast<std::uint32_t>(std::lower_bound(ends.begin(), ends.end(), end, isBefore) -
                                      ends.begin());
  };
  std::vector<LineLink> links;
  links.reserve(own.size());
  for (const CutPiece* const piece : own)
    links.push_back({numberOf(piece->end[0]), numberOf(piece->end[1]), piece->triangle[0]});
  ContourLines lines;
  chainLinks(links, ends.size(), lines.chains, nullptr);
  lines.points.reserve(ends.size());
  for (const CutPoint& end : ends)
    lines.points.push_back(transformPoint(worldToModel, end.place));
  return lines;
}

}  // namespace limn
