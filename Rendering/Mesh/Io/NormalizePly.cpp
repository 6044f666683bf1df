// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Mesh/Io/NormalForm.h"

#include "Rendering/Mesh/Io/PlyForm.h"
#include "Rendering/Mesh/Io/PlyValues.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string_view>

namespace limn::meshio {
namespace {

/// What a property of a vertex or a face means to us.
enum Role : std::size_t { kX, kY, kZ, kNx, kNy, kNz, kU, kV, kRed, kGreen, kBlue, kAlpha, kRoles };
using Values = std::array<double, kRoles>;

constexpr Values kDefaults = {0, 0, 0, 0, 0, 0, 0, 0, 255, 255, 255, 255};
constexpr double kFloatMax = static_cast<double>(std::numeric_limits<float>::max());

std::optional<Role> roleOf(const PlyProperty& property)
{
  static const std::map<std::string_view, Role> roles = {
      {"x", kX},         {"y", kY},
      {"z", kZ},         {"nx", kNx},
      {"ny", kNy},       {"nz", kNz},
      {"u", kU},         {"s", kU},
      {"texture_u", kU}, {"v", kV},
      {"t", kV},         {"texture_v", kV},
      {"red", kRed},     {"diffuse_red", kRed},
      {"green", kGreen}, {"diffuse_green", kGreen},
      {"blue", kBlue},   {"diffuse_blue", kBlue},
      {"alpha", kAlpha}};
  const auto found = roles.find(property.name);
  if (property.isList || found == roles.end()) return std::nullopt;
  return found->second;
}

bool isVertexIndices(const PlyProperty& property)
{
  return property.isList && (property.name == "vertex_indices" || property.name == "vertex_index");
}

bool has(const PlyElement* element, Role role)
{
  return element != nullptr &&
         std::any_of(element->properties.begin(), element->properties.end(),
                     [role](const PlyProperty& property) { return roleOf(property) == role; });
}

/// A colour channel as 0 to 255: real numbers run from 0 to 1, whole ones over their type's range.
double channelIn255(PlyType type, double value)
{
  if (type == PlyType::kFloat32 || type == PlyType::kFloat64) value *= 255;
  if (type == PlyType::kUint16) value /= 257;
  return std::isnan(value) ? 0 : std::clamp(std::round(value), 0.0, 255.0);
}

Rgba8 colorOf(const Values& values)
{
  const auto channel = [&values](Role role) { return static_cast<std::uint8_t>(values[role]); };
  return {channel(kRed), channel(kGreen), channel(kBlue), channel(kAlpha)};
}

class PlyNormalizer {
 public:
  explicit PlyNormalizer(Source& source)
      : source_(source),
        header_(readPlyHeader(source)),
        vertices_(find("vertex")),
        faces_(find("face")),
        values_(source, header_),
        form_(attributes())
  {
  }

  NormalForm normalize()
  {
    if (vertices_ == nullptr || vertices_->count == 0) source_.fail("the file has no vertices");
    if (!has(vertices_, kX) || !has(vertices_, kY) || !has(vertices_, kZ)) {
      source_.fail("the vertices lack one of the properties x, y and z");
    }
    if (vertices_->count > std::numeric_limits<std::int32_t>::max()) {
      source_.fail("more vertices than 2^31 - 1; split the mesh");
    }
    requireFaces();
    for (const PlyElement& element : header_.elements) {
      // One without properties has no bytes, but may announce any count.
      const std::uint64_t count = element.properties.empty() ? 0 : element.count;
      for (std::uint64_t i = 0; i < count; ++i)
        readItem(element);
    }
    return form_.finish();
  }

 private:
  const PlyElement* find(std::string_view name) const
  {
    const PlyElement* found = nullptr;
    for (const PlyElement& element : header_.elements) {
      if (element.name != name) continue;
      if (found != nullptr) source_.fail("the header announces element " + element.name + " twice");
      found = &element;
    }
    return found;
  }

  PlyForm::Attributes attributes() const
  {
    return {has(vertices_, kNx) && has(vertices_, kNy) && has(vertices_, kNz),
            has(vertices_, kU) && has(vertices_, kV),
            has(vertices_, kRed) || has(vertices_, kGreen) || has(vertices_, kBlue),
            has(faces_, kRed) || has(faces_, kGreen) || has(faces_, kBlue)};
  }

  void requireFaces() const
  {
    if (faces_ == nullptr && find("tristrips") != nullptr) {
      source_.fail("the file has triangle strips; save it with faces instead");
    }
    if (faces_ == nullptr) return;
    const auto lists =
        std::count_if(faces_->properties.begin(), faces_->properties.end(), isVertexIndices);
    if (lists != 1) source_.fail("the faces need one list property called vertex_indices");
  }

  void readItem(const PlyElement& element)
  {
    Values values = kDefaults;
    corners_.clear();
    for (const PlyProperty& property : element.properties) {
      const std::optional<Role> role = roleOf(property);
      if (&element == faces_ && isVertexIndices(property)) {
        readCorners(property);
      } else if (role && (&element == vertices_ || &element == faces_)) {
        values[*role] = readRole(*role, property.type);
      } else {
        skip(property);
      }
    }
    if (&element == vertices_) addVertex(values);
    if (&element == faces_) form_.addFace(corners_, colorOf(values));
  }

  double readRole(Role role, PlyType type)
  {
    const double value = values_.next(type);
    if (role >= kRed) return channelIn255(type, value);
    if (!(std::abs(value) <= kFloatMax)) {
      values_.fail("a coordinate is NaN, infinite or beyond float's range", Error::kNotFinite);
    }
    return value;
  }

  void readCorners(const PlyProperty& property)
  {
    const std::uint32_t count =
        values_.nextLength(property.countType, "corners", sizeOf(property.type));
    const std::size_t last = static_cast<std::size_t>(vertices_->count) - 1;
    for (std::uint32_t i = 0; i < count; ++i) {
      corners_.push_back(values_.nextCount(property.type, "a corner's vertex", last));
    }
  }

  void skip(const PlyProperty& property)
  {
    std::uint32_t count = 1;
    if (property.isList) {
      count = values_.nextLength(property.countType, "values of a list", sizeOf(property.type));
    }
    for (std::uint32_t i = 0; i < count; ++i)
      values_.skip(property.type);
  }

  void addVertex(const Values& values)
  {
    PlyForm::Vertex vertex;
    vertex.position = {values[kX], values[kY], values[kZ]};
    vertex.normal = vec3Cast<float>(Vec3d{values[kNx], values[kNy], values[kNz]});
    vertex.texCoord = {static_cast<float>(values[kU]), static_cast<float>(values[kV])};
    vertex.color = colorOf(values);
    form_.addVertex(vertex);
  }

  Source& source_;
  PlyHeader header_;
  const PlyElement* vertices_;
  const PlyElement* faces_;
  PlyValues values_;
  PlyForm form_;
  std::vector<std::uint32_t> corners_;
};

}  // namespace

NormalForm normalizePly(Source& source)
{
  return PlyNormalizer(source).normalize();
}

}  // namespace limn::meshio
