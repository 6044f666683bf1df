// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Mesh/SmoothNormals.h"

#include "Rendering/Base/Array.h"
#include "Rendering/Base/ParallelStretches.h"
#include "Rendering/Base/Power.h"
#include "Rendering/Mesh/EdgeTable.h"

#include <algorithm>
#include <memory>
#include <numeric>
#include <utility>

namespace limn {
namespace {

constexpr std::size_t kPerTask = 4096;
constexpr float kSqrtTwo = 1.41421356f, kMostDistances = 32;
/// Of a rate that every vertex of a net of equal triangles has, 2 sqrt(3) / area: the fastest one.
/// Vertices with little area about them would otherwise ask for steps without number.
constexpr double kFastestRate = 6;
/// Chebyshev's coefficients that are left out, by their sum.
constexpr double kLeftOut = 1e-3;

/// Which corners of triangles share their normals, by numbers: those in one place do, but for
/// where creases part them.
class Numbering {
 public:
  Numbering(const SmoothedSurface& surface, const EdgeTable& table, double creaseDegrees,
            int threads)
      : mesh_(surface.mesh), table_(table), count_(surface.mesh.vertexCount())
  {
    if (creaseDegrees >= 180) return;
    FeatureArrays arrays;
    arrays.cells = surface.cells;
    arrays.vertexNormals = surface.normals;
    const unsigned wanted = surface.normals.empty() ? kCreaseEdge : kCreaseEdge | kNormalEdge;
    std::vector<std::uint8_t> kinds = edgeKinds(mesh_, table, arrays, creaseDegrees, threads);
    bool isAny = false;
    for (std::uint8_t& one : kinds) {
      one = (one & wanted) == wanted ? 1 : 0;
      isAny = isAny || one != 0;
    }
    if (isAny) part(kinds);
  }

  bool isParted() const { return !ofCorner_.empty(); }
  std::size_t count() const { return count_; }
  /// Requires: the corner's vertex is there.
  std::uint32_t operator()(std::uint32_t corner) const
  {
    return isParted() ? ofCorner_[corner]
                      : table_.place[mesh_.triangles[corner / 3].vertex[corner % 3]];
  }
  /// The corner of an edge's second face where its first one sets out along it.
  std::uint32_t facing(std::size_t e) const
  {
    const std::uint32_t other = table_.edges[e].corner[1];
    return table_.woundAlike[e] != 0 ? nextCorner(other) : other;
  }
  /// Likewise where the first one arrives.
  std::uint32_t facingEnd(std::size_t e) const
  {
    const std::uint32_t other = table_.edges[e].corner[1];
    return table_.woundAlike[e] != 0 ? other : nextCorner(other);
  }
  std::vector<std::uint32_t> take() { return std::move(ofCorner_); }

 private:
  /// Joins corners over edges that are no creases.
  void part(const std::vector<std::uint8_t>& isCrease)
  {
    ofCorner_.resize(3 * mesh_.triangles.size());
    std::iota(ofCorner_.begin(), ofCorner_.end(), 0u);
    for (std::size_t e = 0; e < table_.edges.size(); ++e) {
      const MeshEdge& edge = table_.edges[e];
      if (!edge.isShared() || isCrease[e] != 0) continue;
      join(edge.corner[0], facing(e));
      join(nextCorner(edge.corner[0]), facingEnd(e));
    }
    // A root is the lowest of its corners, so that those before have their number.
    std::uint32_t number = 0;
    for (std::uint32_t corner = 0; corner < ofCorner_.size(); ++corner) {
      const std::uint32_t root = ofCorner_[corner];
      ofCorner_[corner] = root == corner ? number++ : ofCorner_[root];
    }
    count_ = number;
  }
  std::uint32_t rootOf(std::uint32_t corner)
  {
    while (ofCorner_[corner] != corner) {
      ofCorner_[corner] = ofCorner_[ofCorner_[corner]];
      corner = ofCorner_[corner];
    }
    return corner;
  }
  void join(std::uint32_t a, std::uint32_t b)
  {
    const std::uint32_t x = rootOf(a), y = rootOf(b);
    ofCorner_[std::max(x, y)] = std::min(x, y);
  }

  const MeshView& mesh_;
  const EdgeTable& table_;
  std::size_t count_;
  std::vector<std::uint32_t> ofCorner_;  ///< empty: by place
};

/// One step towards the mean of the neighbours: B = 1 - L / fastest rate.
struct Stencil {
  std::vector<std::uint32_t> first;  ///< by number
  Array<std::uint32_t> neighbour;
  Array<float> weight;  ///< of neighbours; the vertex has what is missing to 1
};

/// What of the heat flow a mesh is.
class HeatFlow {
 public:
  HeatFlow(const MeshView& mesh, const EdgeTable& table, const Numbering& numbering, int threads)
      : mesh_(mesh), table_(table), numbering_(numbering), threads_(threads)
  {
    addAreas();
    addLinks();
    makeStencil();
  }

  Stencil takeStencil() { return std::move(stencil_); }
  /// Vertices, those that share their normals counted once.
  std::size_t count() const { return count_; }

 private:
  /// What lets heat flow between two numbers.
  struct Link {
    std::uint32_t end[2];
    double conductance;
  };

  Vec3d cornerPosition(std::uint32_t corner) const
  {
    return mesh_.position(mesh_.triangles[corner / 3].vertex[corner % 3]);
  }

  void addAreas()
  {
    area_.assign(numbering_.count(), 0.0);
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      const auto [a, b, c] = mesh_.triangles[t].vertex;
      const std::size_t vertices = mesh_.vertexCount();
      if (a >= vertices || b >= vertices || c >= vertices) continue;
      const Vec3d p = mesh_.position(a);
      const Vec3d across = cross(mesh_.position(b) - p, mesh_.position(c) - p);
      if (!isFinite(across)) continue;
      const double area = 0.5 * std::sqrt(dot(across, across));
      total_ += area;
      for (std::uint32_t k = 0; k < 3; ++k)
        area_[numbering_(static_cast<std::uint32_t>(3 * t) + k)] += area / 3;
    }
    for (const double area : area_)
      count_ += area > 0;
  }

  /// Half of the cotangent of the angle that faces an edge, in the triangle that sets out along the
  /// edge at a corner.
  double halfCotangent(std::uint32_t corner) const
  {
    const std::uint32_t first = corner / 3 * 3, k = corner % 3;
    const Vec3d p = cornerPosition(first + (k + 2) % 3);
    const Vec3d u = cornerPosition(corner) - p, v = cornerPosition(first + (k + 1) % 3) - p;
    const Vec3d across = cross(u, v);
    const double sine = std::sqrt(dot(across, across));
    constexpr double kMost = 1e6;
    if (!(sine > 0) || !std::isfinite(sine)) return 0;
    const double cotangent = dot(u, v) / sine;
    return 0.5 * std::min(std::max(cotangent, -kMost), kMost);
  }
  /// Negative ones, across edges that another cut of the surface would not have, count as none.
  static double conducting(double sum) { return sum > 0 ? sum : 0; }
  /// One an edge, and one more for the second side of each where the two are apart.
  void addLinks()
  {
    links_.resize(table_.edges.size());
    parallelForEach(threads_, links_.size(), kPerTask, [&](std::size_t e) {
      const std::uint32_t corner = table_.edges[e].corner[0];
      double sum = halfCotangent(corner);
      if (table_.edges[e].isShared() && !isApart(e))
        sum += halfCotangent(table_.edges[e].corner[1]);
      links_[e] = {{numbering_(corner), numbering_(nextCorner(corner))}, conducting(sum)};
    });
    if (!numbering_.isParted()) return;
    for (std::size_t e = 0; e < table_.edges.size(); ++e)
      if (table_.edges[e].isShared() && isApart(e))
        links_.push_back({{numbering_(numbering_.facing(e)), numbering_(numbering_.facingEnd(e))},
                          conducting(halfCotangent(table_.edges[e].corner[1]))});
  }
  bool isApart(std::size_t e) const
  {
    if (!numbering_.isParted()) return false;
    const std::uint32_t corner = table_.edges[e].corner[0];
    return numbering_(corner) != numbering_(numbering_.facing(e)) ||
           numbering_(nextCorner(corner)) != numbering_(numbering_.facingEnd(e));
  }

  void makeStencil()
  {
    const std::size_t numbers = numbering_.count();
    std::vector<double> sum(numbers, 0.0);
    stencil_.first.assign(numbers + 1, 0);
    for (const Link& link : links_)
      for (const std::uint32_t v : link.end) {
        sum[v] += link.conductance;
        ++stencil_.first[v + 1];
      }
    std::partial_sum(stencil_.first.begin(), stencil_.first.end(), stencil_.first.begin());
    stencil_.neighbour.resize(stencil_.first.back());
    stencil_.weight.resize(stencil_.first.back());
    const double mean = total_ / static_cast<double>(std::max<std::size_t>(count_, 1));
    // What a step takes from all neighbours together, at most 1.
    const auto share = [&](std::uint32_t v) {
      const double rate = area_[v] > 0 ? sum[v] / area_[v] * mean / kFastestRate : 0.0;
      return rate < 1.0 ? rate : 1.0;
    };
    std::vector<std::uint32_t> next(stencil_.first.begin(), stencil_.first.end() - 1);
    for (const Link& link : links_)
      for (int side = 0; side < 2; ++side) {
        const std::uint32_t v = link.end[side];
        stencil_.neighbour[next[v]] = link.end[1 - side];
        stencil_.weight[next[v]] =
            sum[v] > 0 ? static_cast<float>(share(v) * (link.conductance / sum[v])) : 0.0f;
        ++next[v];
      }
  }

  const MeshView& mesh_;
  const EdgeTable& table_;
  const Numbering& numbering_;
  int threads_;
  double total_ = 0;
  std::size_t count_ = 0;
  std::vector<double> area_;
  std::vector<Link> links_;
  Stencil stencil_;
};

/// Coefficients of exp(-z (1 - x)) in Chebyshev's polynomials of x in [-1, 1]: I_j(z), but twice
/// for j > 0, divided by their sum, exp(z). By Miller's recurrence from above.
std::vector<double> heatCoefficients(double z)
{
  // I_j(z) / exp(z) is about exp(-j^2 / 2 z): nothing from here on.
  const auto most = static_cast<std::size_t>(12 * std::sqrt(z) + 24);
  std::vector<double> bessel(most + 2, 0.0);
  bessel[most] = 1e-250;
  for (std::size_t j = most; j > 0; --j)
    bessel[j - 1] = bessel[j + 1] + 2.0 * static_cast<double>(j) / z * bessel[j];
  double sum = bessel[0];
  for (std::size_t j = 1; j <= most; ++j)
    sum += 2.0 * bessel[j];
  for (std::size_t j = 0; j <= most; ++j)
    bessel[j] = (j > 0 ? 2.0 : 1.0) * (bessel[j] / sum);
  std::size_t count = most + 1;
  for (double left = bessel[count - 1]; count > 1 && left < kLeftOut; left += bessel[count - 1])
    --count;
  bessel.resize(count);
  return bessel;
}

using Field = Array<Vec3f>;

/// Unit, by number.
Field normalsByNumber(const SmoothedSurface& surface, const EdgeTable& table,
                      const Numbering& numbering)
{
  const MeshView& mesh = surface.mesh;
  const std::size_t vertices = mesh.vertexCount();
  Field field(numbering.count(), Vec3f{0, 0, 0});
  if (!surface.normals.empty() && !numbering.isParted())
    for (std::size_t v = 0; v < vertices; ++v)
      field[table.place[v]] = field[table.place[v]] + normalized(surface.normals[v]);
  std::vector<Vec3d> areas(surface.normals.empty() ? field.size() : 0, Vec3d{0, 0, 0});
  const bool readsCorners = !areas.empty() || numbering.isParted();
  for (std::size_t t = 0; readsCorners && t < mesh.triangles.size(); ++t) {
    const auto [a, b, c] = mesh.triangles[t].vertex;
    if (a >= vertices || b >= vertices || c >= vertices) continue;
    const Vec3d p = mesh.position(a);
    const Vec3d area = cross(mesh.position(b) - p, mesh.position(c) - p);
    if (!isFinite(area)) continue;
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t number = numbering(static_cast<std::uint32_t>(3 * t) + k);
      if (areas.empty())
        field[number] = field[number] + normalized(surface.normals[mesh.triangles[t].vertex[k]]);
      else
        areas[number] = areas[number] + area;
    }
  }
  for (std::size_t i = 0; i < areas.size(); ++i)
    field[i] = normalized(vec3Cast<float>(normalized(areas[i])));
  for (Vec3f& normal : field)
    normal = isFinite(normal) ? normalized(normal) : Vec3f{0, 0, 0};
  return field;
}

Vec3f stepped(const Stencil& stencil, const Field& field, std::size_t v)
{
  const Vec3f own = field[v];
  Vec3f result = own;
  for (std::uint32_t i = stencil.first[v]; i < stencil.first[v + 1]; ++i)
    result = result + (field[stencil.neighbour[i]] - own) * stencil.weight[i];
  return result;
}

/// Sums c_j T_j(B) n for several lists of coefficients, T_j+1 = 2 B T_j - T_j-1.
std::vector<Field> spread(const Stencil& stencil, Field field,
                          const std::vector<std::vector<double>>& coefficients, int threads)
{
  const std::size_t vertices = field.size();
  std::vector<Field> sums(coefficients.size(), Field(vertices, Vec3f{0, 0, 0}));
  std::size_t longest = 0;
  for (const std::vector<double>& list : coefficients)
    longest = std::max(longest, list.size());
  Field before = field;
  for (std::size_t j = 0; j < longest; ++j) {
    Field next(j + 1 < longest ? vertices : 0);
    parallelForEach(threads, vertices, kPerTask, [&](std::size_t v) {
      for (std::size_t i = 0; i < sums.size(); ++i)
        if (j < coefficients[i].size())
          sums[i][v] = sums[i][v] + field[v] * static_cast<float>(coefficients[i][j]);
      if (next.empty()) return;
      const Vec3f step = stepped(stencil, field, v);
      next[v] = j == 0 ? step : step * 2.0f - before[v];
    });
    before.swap(field);
    field.swap(next);
  }
  return sums;
}

/// Of a mesh of `count` vertices, those in one place counted once.
float ratioOf(const SmoothScales& scales, std::size_t count)
{
  // In distances of neighbours, sqrt(2 / sqrt(3) area / count): the root of the area is
  // sqrt(sqrt(3) / 2 count) of these.
  const double side = std::sqrt(0.866025403784438647 * static_cast<double>(count));
  const auto distances = static_cast<float>(scales.coarsest * side);
  const float most = distances < kMostDistances ? distances : kMostDistances;
  const float even =
      scales.levels > 1 ? power(most, 1.0f / static_cast<float>(scales.levels - 1)) : 1.0f;
  return even > kSqrtTwo ? (even < kMaxSmoothRatio ? even : kMaxSmoothRatio) : kSqrtTwo;
}

}  // namespace

std::uint32_t packedNormal(Vec3d normal)
{
  const double sum = std::fabs(normal.x) + std::fabs(normal.y) + std::fabs(normal.z);
  if (!(sum > 0)) return 0;
  double x = normal.x / sum, y = normal.y / sum;
  if (normal.z < 0) {
    const double outX = 1 - std::fabs(y), outY = 1 - std::fabs(x);
    x = x < 0 ? -outX : outX;
    y = y < 0 ? -outY : outY;
  }
  const auto bits = [](double value) {
    return static_cast<std::uint32_t>(static_cast<std::int32_t>(std::nearbyint(value * 32767.0))) &
           0xFFFFu;
  };
  return bits(x) | bits(y) << 16;
}

Status smoothNormals(const SmoothedSurface& surface, const SmoothScales& scales, int threads,
                     SmoothNormals& smooth)
{
  smooth = {};
  const MeshView& mesh = surface.mesh;
  EdgeTable table;
  if (Status status = buildEdgeTable(mesh, 0, threads, table); !status.ok()) return status;
  Numbering numbering(surface, table, scales.creaseDegrees, threads);
  auto flow = std::make_unique<HeatFlow>(mesh, table, numbering, threads);
  const std::size_t count = flow->count();
  const Stencil stencil = flow->takeStencil();
  flow.reset();
  // An empty list of initializers would keep the memory.
  table.edges = Array<MeshEdge>();
  smooth.ratio = ratioOf(scales, count);
  const auto levels = static_cast<std::size_t>(scales.levels);
  std::vector<std::vector<double>> coefficients(levels);
  double sigma = 1;
  for (std::vector<double>& list : coefficients) {
    // t times the fastest rate, where sigma^2 is 2 / sqrt(3) areas.
    list = heatCoefficients(0.5 * sigma * sigma * 1.15470053837925153 * kFastestRate);
    sigma *= static_cast<double>(smooth.ratio);
  }
  const std::vector<Field> fields =
      spread(stencil, normalsByNumber(surface, table, numbering), coefficients, threads);
  smooth.levels = scales.levels;
  const bool isParted = numbering.isParted();
  smooth.ofCorner = numbering.take();
  const std::size_t numbers = isParted ? numbering.count() : mesh.vertexCount();
  smooth.packed.resize(numbers * levels);
  parallelForEach(threads, numbers, kPerTask, [&](std::size_t v) {
    const std::size_t number = isParted ? v : table.place[v];
    for (std::size_t i = 0; i < levels; ++i)
      smooth.packed[v * levels + i] = packedNormal(vec3Cast<double>(fields[i][number]));
  });
  return {};
}

}  // namespace limn
