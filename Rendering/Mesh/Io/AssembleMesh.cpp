// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Mesh/Io/AssembleMesh.h"

#include "Rendering/Mesh/Io/CountNonManifold.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <unordered_map>
#include <utility>

namespace limn::meshio {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// Newell's normal of a polygon: a sum over its edges, so concave and bent ones have one, too.
/// `origins` are the vertices that corners come from, where they have been split already.
Vec3f normalOfPolygon(const RawMesh& raw, const std::vector<std::uint32_t>& origins,
                      std::size_t face)
{
  const std::size_t begin = static_cast<std::size_t>(raw.offsets[face]);
  const std::size_t end = static_cast<std::size_t>(raw.offsets[face + 1]);
  const auto position = [&](std::size_t corner) {
    return vec3Cast<double>(raw.positions[origins[raw.corners[corner]]]);
  };
  const Vec3d base = position(begin);
  Vec3d sum{};
  for (std::size_t i = begin + 1; i + 1 < end; ++i) {
    sum = sum + cross(position(i) - base, position(i + 1) - base);
  }
  return vec3Cast<float>(normalized(sum));
}

/// Gives each different pair of normal and texture coordinates at a vertex a vertex of its own.
class VertexSplitter {
 public:
  VertexSplitter(const Source& source, const NormalForm& form, RawMesh& raw)
      : source_(source), form_(form), raw_(raw)
  {
  }

  /// The vertex that each vertex comes from.
  std::vector<std::uint32_t> split()
  {
    const std::size_t count = raw_.positions.size();
    for (std::size_t i = 0; i < count; ++i)
      origins_.push_back(static_cast<std::uint32_t>(i));
    firstVariant_ = count;
    isTaken_.assign(count, false);
    if (hasNormals()) raw_.normals.resize(count);
    if (form_.hasTexCoords) raw_.texCoords.resize(count);
    for (std::size_t face = 0; face < raw_.faceCount(); ++face)
      splitCornersOf(face);
    return std::move(origins_);
  }

 private:
  bool hasNormals() const { return form_.parser == Parser::kObj && form_.hasNormals; }

  void splitCornersOf(std::size_t face)
  {
    for (std::size_t i = static_cast<std::size_t>(raw_.offsets[face]);
         i < static_cast<std::size_t>(raw_.offsets[face + 1]); ++i) {
      CornerAttributes& corner = raw_.cornerAttributes[i];
      if (hasNormals() && !corner.hasNormal) corner.normal = normalOf(face);
      raw_.corners[i] = variantOf(raw_.corners[i], corner);
    }
  }

  Vec3f normalOf(std::size_t face)
  {
    if (normalFace_ != face) normal_ = normalOfPolygon(raw_, origins_, face);
    normalFace_ = face;
    return normal_;
  }

  std::uint32_t variantOf(std::uint32_t vertex, const CornerAttributes& corner)
  {
    if (!isTaken_[vertex]) {
      isTaken_[vertex] = true;
      store(vertex, corner);
    }
    if (isEqual(vertex, corner)) return vertex;
    const auto [first, isNew] = firstVariants_.try_emplace(hashOf(vertex, corner), kNone);
    for (std::uint32_t i = first->second; i != kNone; i = nextVariants_[i - firstVariant_]) {
      if (origins_[i] == vertex && isEqual(i, corner)) return i;
    }
    nextVariants_.push_back(first->second);
    first->second = addVariant(vertex, corner);
    return first->second;
  }

  static std::uint64_t hashOf(std::uint32_t vertex, const CornerAttributes& corner)
  {
    constexpr std::uint64_t kGoldenRatio = 0x9e3779b97f4a7c15u;
    std::uint64_t hash = vertex;
    for (const float value : {corner.normal.x, corner.normal.y, corner.normal.z, corner.texCoord.u,
                              corner.texCoord.v}) {
      // Adding 0 makes 0 of -0, which is equal.
      const float positive = value + 0.0f;
      std::uint32_t bits = 0;
      std::memcpy(&bits, &positive, sizeof bits);
      hash = (hash ^ bits) * kGoldenRatio;
      hash ^= hash >> 32;
    }
    return hash;
  }

  std::uint32_t addVariant(std::uint32_t vertex, const CornerAttributes& corner)
  {
    if (origins_.size() >= kNone) source_.fail("more than 2^32 - 1 vertices; split the mesh");
    const std::uint32_t variant = static_cast<std::uint32_t>(origins_.size());
    origins_.push_back(vertex);
    if (hasNormals()) raw_.normals.emplace_back();
    if (form_.hasTexCoords) raw_.texCoords.emplace_back();
    store(variant, corner);
    return variant;
  }

  void store(std::uint32_t vertex, const CornerAttributes& corner)
  {
    if (hasNormals()) raw_.normals[vertex] = corner.normal;
    if (form_.hasTexCoords) raw_.texCoords[vertex] = corner.texCoord;
  }

  bool isEqual(std::uint32_t vertex, const CornerAttributes& corner) const
  {
    if (hasNormals() && !(raw_.normals[vertex] == corner.normal)) return false;
    return !form_.hasTexCoords || (raw_.texCoords[vertex].u == corner.texCoord.u &&
                                   raw_.texCoords[vertex].v == corner.texCoord.v);
  }

  const Source& source_;
  const NormalForm& form_;
  RawMesh& raw_;
  std::vector<std::uint32_t> origins_;
  std::size_t firstVariant_ = 0;  ///< vertices from here on are variants of those before
  std::unordered_map<std::uint64_t, std::uint32_t> firstVariants_;  ///< by hash
  std::vector<std::uint32_t> nextVariants_;                         ///< of the same hash
  std::vector<bool> isTaken_;  ///< by a corner's attributes, of a file's vertex
  std::size_t normalFace_ = std::numeric_limits<std::size_t>::max();
  Vec3f normal_{};
};

template <class T>
void appendVariants(std::vector<T>& values, const std::vector<std::uint32_t>& origins)
{
  if (values.empty()) return;
  values.reserve(origins.size());
  for (std::size_t i = values.size(); i < origins.size(); ++i)
    values.push_back(values[origins[i]]);
}

/// Whether rounding to float moves a point by more than 2^-20 of the diagonal of the bounding box:
/// a float has 24 bits, so by more than 4 bits' worth of distance from the origin.
bool needsDouble(const std::vector<Vec3d>& positions)
{
  if (positions.empty()) return false;
  Vec3d low = positions.front();
  Vec3d high = low;
  double farthest = 0;
  bool isFloat = true;
  for (const Vec3d& p : positions) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    farthest = std::max({farthest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    isFloat = isFloat && vec3Cast<double>(vec3Cast<float>(p)) == p;
  }
  const Vec3d diagonal = high - low;
  return !isFloat && farthest > 16 * std::sqrt(dot(diagonal, diagonal));
}

}  // namespace

MeshFile assembleMesh(const Source& source, NormalForm form, RawMesh raw)
{
  MeshFile mesh;
  mesh.droppedFaces = form.faceCount - std::min(form.faceCount, raw.faceCount());
  mesh.nonManifoldFaces = countNonManifoldFaces(raw);
  if (!needsDouble(form.positions)) form.positions.clear();

  if (!raw.cornerAttributes.empty()) {
    const std::size_t before = raw.positions.size();
    const std::vector<std::uint32_t> origins = VertexSplitter(source, form, raw).split();
    appendVariants(raw.positions, origins);
    appendVariants(form.positions, origins);
    appendVariants(raw.vertexColors, origins);
    if (raw.normals.size() == before) appendVariants(raw.normals, origins);
    mesh.splitVertices = origins.size() - before;
  }

  if (form.positions.empty()) {
    mesh.positions = std::move(raw.positions);
  } else {
    mesh.precisePositions = std::move(form.positions);
  }
  mesh.normals = std::move(raw.normals);
  mesh.texCoords = std::move(raw.texCoords);
  mesh.vertexColors = std::move(raw.vertexColors);
  mesh.faceColors = std::move(raw.faceColors);
  mesh.polygonOffsets = std::move(raw.offsets);
  mesh.polygonCorners = std::move(raw.corners);
  return mesh;
}

}  // namespace limn::meshio
