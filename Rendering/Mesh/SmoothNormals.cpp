// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Mesh/SmoothNormals.h"

#include "Rendering/Base/Array.h"
#include "Rendering/Base/ParallelStretches.h"
#include "Rendering/Base/Power.h"
#include "Rendering/Mesh/EdgeTable.h"
#include "Rendering/Mesh/VertexNormals.h"

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

/// One step towards the mean of the neighbours: B = 1 - L / fastest rate.
struct Stencil {
  std::vector<std::uint32_t> first;  ///< by vertex
  Array<std::uint32_t> neighbour;
  Array<float> weight;  ///< of neighbours; the vertex has what is missing to 1
};

/// What of the heat flow a mesh is.
class HeatFlow {
 public:
  HeatFlow(const MeshView& mesh, const EdgeTable& table, int threads)
      : mesh_(mesh), table_(table), threads_(threads)
  {
    addAreas();
    addConductances();
    makeStencil();
  }

  Stencil takeStencil() { return std::move(stencil_); }
  /// Vertices, those in one place counted once.
  std::size_t count() const { return count_; }

 private:
  std::uint32_t placeOf(std::uint32_t corner) const
  {
    return table_.place[mesh_.triangles[corner / 3].vertex[corner % 3]];
  }
  Vec3d cornerPosition(std::uint32_t corner) const
  {
    return mesh_.position(mesh_.triangles[corner / 3].vertex[corner % 3]);
  }

  void addAreas()
  {
    area_.assign(mesh_.vertexCount(), 0.0);
    for (const Triangle& triangle : mesh_.triangles) {
      const auto [a, b, c] = triangle.vertex;
      const std::size_t vertices = mesh_.vertexCount();
      if (a >= vertices || b >= vertices || c >= vertices) continue;
      const Vec3d p = mesh_.position(a);
      const Vec3d across = cross(mesh_.position(b) - p, mesh_.position(c) - p);
      if (!isFinite(across)) continue;
      const double area = 0.5 * std::sqrt(dot(across, across));
      total_ += area;
      for (const std::uint32_t v : triangle.vertex)
        area_[table_.place[v]] += area / 3;
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
  void addConductances()
  {
    conductance_.assign(table_.edges.size(), 0.0);
    parallelForEach(threads_, conductance_.size(), kPerTask, [&](std::size_t e) {
      const MeshEdge& edge = table_.edges[e];
      double sum = halfCotangent(edge.corner[0]);
      if (edge.isShared()) sum += halfCotangent(edge.corner[1]);
      conductance_[e] = sum > 0 ? sum : 0;
    });
  }

  void makeStencil()
  {
    const std::size_t vertices = mesh_.vertexCount();
    std::vector<double> sum(vertices, 0.0);
    stencil_.first.assign(vertices + 1, 0);
    for (std::size_t e = 0; e < conductance_.size(); ++e)
      for (const std::uint32_t v : table_.edges[e].vertex) {
        sum[v] += conductance_[e];
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
    for (std::size_t e = 0; e < conductance_.size(); ++e)
      for (int side = 0; side < 2; ++side) {
        const std::uint32_t v = table_.edges[e].vertex[side];
        stencil_.neighbour[next[v]] = table_.edges[e].vertex[1 - side];
        stencil_.weight[next[v]] =
            sum[v] > 0 ? static_cast<float>(share(v) * (conductance_[e] / sum[v])) : 0.0f;
        ++next[v];
      }
  }

  const MeshView& mesh_;
  const EdgeTable& table_;
  int threads_;
  double total_ = 0;
  std::size_t count_ = 0;
  std::vector<double> area_, conductance_;
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

/// Unit, by place.
Field normalsOfPlaces(const MeshView& mesh, Span<const Vec3f> normals,
                      const std::vector<std::uint32_t>& place)
{
  std::vector<Vec3f> own;
  if (normals.empty()) {
    std::vector<Triangle> welded(mesh.triangles.begin(), mesh.triangles.end());
    for (Triangle& triangle : welded)
      for (std::uint32_t& v : triangle.vertex)
        v = v < place.size() ? place[v] : v;
    own = vertexNormals({mesh.positions, mesh.precisePositions, welded}, NormalWeight::kArea);
    normals = own;
  }
  Field field(mesh.vertexCount(), Vec3f{0, 0, 0});
  for (std::size_t v = 0; v < field.size(); ++v)
    field[place[v]] = field[place[v]] + normalized(normals[v]);
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

Status smoothNormals(const MeshView& mesh, Span<const Vec3f> normals, const SmoothScales& scales,
                     int threads, SmoothNormals& smooth)
{
  smooth = {};
  EdgeTable table;
  if (Status status = buildEdgeTable(mesh, 0, threads, table); !status.ok()) return status;
  auto flow = std::make_unique<HeatFlow>(mesh, table, threads);
  const std::size_t count = flow->count();
  const Stencil stencil = flow->takeStencil();
  flow.reset();
  // An empty list of initializers would keep the memory.
  table.edges = std::vector<MeshEdge>();
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
      spread(stencil, normalsOfPlaces(mesh, normals, table.place), coefficients, threads);
  smooth.levels = scales.levels;
  smooth.packed.resize(mesh.vertexCount() * levels);
  parallelForEach(threads, mesh.vertexCount(), kPerTask, [&](std::size_t v) {
    for (std::size_t i = 0; i < levels; ++i)
      smooth.packed[v * levels + i] = packedNormal(vec3Cast<double>(fields[i][table.place[v]]));
  });
  return {};
}

}  // namespace limn
