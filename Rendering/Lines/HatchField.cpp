// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/HatchField.h"

#include "Rendering/Base/ParallelStretches.h"
#include "Rendering/Mesh/LocalPosition.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

constexpr std::size_t kPerTask = 4096;

/// A direction without a sign in some plane with two axes: (cos 2a, sin 2a) of its angle a.
struct Doubled {
  double cosine, sine;
};

class FieldSmoother {
 public:
  FieldSmoother(const CurvedSurface& surface, int threads) : surface_(surface), threads_(threads)
  {
    gatherNeighbours();
  }

  std::vector<Vec3f> smooth()
  {
    const std::size_t count = surface_.mesh.vertexCount();
    trust_.assign(count, 0.0);
    principal_.resize(count);
    std::vector<Vec3d> field(count, Vec3d{0, 0, 0}), next(count, Vec3d{0, 0, 0});
    const double size = 40 * featureSize(surface_.mesh);
    parallelForEach(threads_, count, kPerTask, [&](std::size_t v) {
      if (first_[v] == first_[v + 1]) return;
      principal_[v] = principalOf(v);
      trust_[v] = isSharp_[v] != 0 ? 0.0 : trustOf(v, size);
      field[v] = mixed(v, doubledOf(v, alongAxis(v)), trust_[v]);
    });
    for (int round = 0; round < kFieldRounds; ++round) {
      parallelForEach(threads_, count, kPerTask, [&](std::size_t v) {
        if (first_[v] != first_[v + 1]) next[v] = mixed(v, meanAround(v, field), trust_[v]);
      });
      field.swap(next);
    }
    std::vector<Vec3f> result(count);
    parallelForEach(threads_, count, kPerTask,
                    [&](std::size_t v) { result[v] = vec3Cast<float>(field[v]); });
    return result;
  }

 private:
  void gatherNeighbours()
  {
    const MeshView& mesh = surface_.mesh;
    const std::size_t count = mesh.vertexCount();
    constexpr double kSharpCosine = 0.7071;
    first_.assign(count + 1, 0);
    isSharp_.assign(count, 0);
    const auto forEachProper = [&](const auto& visit) {
      for (const Triangle& triangle : mesh.triangles) {
        const auto& v = triangle.vertex;
        if (v[0] >= count || v[1] >= count || v[2] >= count) continue;
        const Vec3d p = mesh.position(v[0]);
        const Vec3d normal = cross(mesh.position(v[1]) - p, mesh.position(v[2]) - p);
        if (isFinite(normal) && dot(normal, normal) > 0) visit(v, normalized(normal));
      }
    };
    forEachProper([&](const auto& v, Vec3d normal) {
      for (int i = 0; i < 3; ++i) {
        first_[v[i] + 1] += 2;
        if (dot(normal, normalOf(v[i])) < kSharpCosine) isSharp_[v[i]] = 1;
      }
    });
    for (std::size_t v = 0; v < count; ++v)
      first_[v + 1] += first_[v];
    neighbour_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    forEachProper([&](const auto& v, Vec3d) {
      for (int i = 0; i < 3; ++i) {
        neighbour_[next[v[i]]++] = v[(i + 1) % 3];
        neighbour_[next[v[i]]++] = v[(i + 2) % 3];
      }
    });
  }

  Vec3d normalOf(std::size_t v) const { return vec3Cast<double>(surface_.normals[v]); }

  Vec3d axisU(std::size_t v) const
  {
    const Vec3d n = normalOf(v);
    return normalized(cross(n, std::fabs(n.x) > 0.7 ? Vec3d{0, 1, 0} : Vec3d{1, 0, 0}));
  }
  /// Where nothing bends: level lines of the height over x and y, but where these lie flat.
  Vec3d alongAxis(std::size_t v) const
  {
    const Vec3d n = normalOf(v);
    return normalized(cross(n, std::fabs(n.z) > 0.9 ? Vec3d{1, 1, 0} : Vec3d{0, 0, 1}));
  }
  Vec3d principalOf(std::size_t v) const
  {
    const VertexCurvature& c = surface_.curvature[v];
    return vec3Cast<double>(c.direction[c.curvature[0] >= c.curvature[1] ? 0 : 1]);
  }
  double trustOf(std::size_t v, double size) const
  {
    const VertexCurvature& c = surface_.curvature[v];
    const double bend =
        (static_cast<double>(c.curvature[0]) - static_cast<double>(c.curvature[1])) * size;
    return bend * bend / (bend * bend + 1);
  }

  Doubled doubledOf(std::size_t v, Vec3d direction) const
  {
    const Vec3d u = axisU(v), w = cross(normalOf(v), u);
    const double x = dot(direction, u), y = dot(direction, w), squared = x * x + y * y;
    if (!(squared > 0)) return {0, 0};
    return {(x * x - y * y) / squared, 2 * x * y / squared};
  }
  /// The principal direction by a share, the rest by what is around.
  Vec3d mixed(std::size_t v, Doubled around, double trust) const
  {
    const Doubled own = doubledOf(v, principal_[v]);
    const double x = own.cosine * trust + around.cosine * (1 - trust);
    const double y = own.sine * trust + around.sine * (1 - trust);
    const double length = std::sqrt(x * x + y * y);
    const Vec3d u = axisU(v), w = cross(normalOf(v), u);
    if (!(length > 0)) return u;
    // Half the angle.
    const double cosine = std::sqrt(std::max(0.0, 0.5 * (1 + x / length)));
    const double sine = std::sqrt(std::max(0.0, 0.5 * (1 - x / length)));
    return u * cosine + w * (y < 0 ? -sine : sine);
  }
  Doubled meanAround(std::size_t v, const std::vector<Vec3d>& field) const
  {
    const Vec3d n = normalOf(v);
    Doubled sum = {0, 0};
    for (std::size_t i = first_[v]; i < first_[v + 1]; ++i) {
      const std::uint32_t other = neighbour_[i];
      // Turned the shortest way, as its normal becomes this one.
      const Vec3d old = normalOf(other);
      const double cosine = dot(old, n);
      Vec3d direction = field[other];
      if (cosine > -1) direction = direction - (old + n) * (dot(direction, n) / (1 + cosine));
      const Doubled one = doubledOf(v, direction);
      sum = {sum.cosine + one.cosine, sum.sine + one.sine};
    }
    const double length = std::sqrt(sum.cosine * sum.cosine + sum.sine * sum.sine);
    return length > 0 ? Doubled{sum.cosine / length, sum.sine / length} : sum;
  }

  const CurvedSurface& surface_;
  int threads_;
  std::vector<std::size_t> first_;
  std::vector<std::uint32_t> neighbour_;
  std::vector<char> isSharp_;
  std::vector<double> trust_;
  std::vector<Vec3d> principal_;
};

}  // namespace

std::vector<Vec3f> hatchField(const CurvedSurface& surface, int threads)
{
  return FieldSmoother(surface, threads).smooth();
}

}  // namespace limn
