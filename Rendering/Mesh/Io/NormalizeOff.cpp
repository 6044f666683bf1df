// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Mesh/Io/NormalForm.h"

#include "Rendering/Mesh/Io/PlyForm.h"
#include "Rendering/Mesh/Io/TextLines.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>

namespace limn::meshio {
namespace {

struct Face {
  std::size_t firstCorner;
  std::optional<Rgba8> color;
};

bool takePrefix(std::string_view& word, std::string_view prefix)
{
  if (word.substr(0, prefix.size()) != prefix) return false;
  word.remove_prefix(prefix.size());
  return true;
}

bool isReal(std::string_view word)
{
  return word.find_first_of(".eE") != std::string_view::npos;
}

class OffNormalizer {
 public:
  explicit OffNormalizer(Source& source) : lines_(source, {'#', false}) {}

  NormalForm normalize()
  {
    readHeader();
    for (std::size_t i = 0; i < vertexCount_; ++i)
      readVertex();
    for (std::size_t i = 0; i < faceCount_; ++i)
      readFace();
    return write();
  }

 private:
  void readHeader()
  {
    requireLine("the word OFF");
    std::string_view word = lines_.word(0);
    hasTexCoords_ = takePrefix(word, "ST");
    takePrefix(word, "C");
    hasNormals_ = takePrefix(word, "N");
    if (takePrefix(word, "4") || takePrefix(word, "n")) {
      lines_.fail("only vertices of dimension 3 can be read; save the mesh as OFF");
    }
    if (word != "OFF") lines_.fail("an OFF file starts with the word OFF, this one does not");
    if (lines_.size() > 1 && lines_.word(1) == "BINARY") {
      lines_.fail("binary OFF cannot be read; save the mesh as ASCII OFF, or as PLY");
    }
    const std::size_t first = lines_.size() > 1 ? 1 : 0;
    if (first == 0) requireLine("the counts of vertices, faces and edges");
    constexpr std::size_t kMost = std::numeric_limits<std::int32_t>::max();
    vertexCount_ = lines_.count(first, "the number of vertices", kMost);
    faceCount_ = lines_.count(first + 1, "the number of faces", kMost);
    if (vertexCount_ == 0) lines_.fail("the file has no vertices");
    // A vertex has at least the 5 letters "0 0 0", a face "0", and an end of line each.
    if (vertexCount_ * 6 + faceCount_ * 2 > lines_.remainingBytes() + 1) {
      lines_.fail(
          "the vertices and faces announced here do not fit into the rest of the file; it "
          "is truncated or the counts are wrong");
    }
  }

  void requireLine(const char* what)
  {
    if (!lines_.next()) lines_.fail(std::string("the file ends before ") + what);
  }

  void readVertex()
  {
    requireLine("its last vertex");
    PlyForm::Vertex vertex;
    vertex.position = {number(0), number(1), number(2)};
    std::size_t used = 3;
    if (hasNormals_) {
      vertex.normal = vec3Cast<float>(Vec3d{number(3), number(4), number(5)});
      used = 6;
    }
    std::size_t end = lines_.size();
    if (hasTexCoords_) {
      end = std::max(end, used + 2) - 2;
      vertex.texCoord = {static_cast<float>(number(end)), static_cast<float>(number(end + 1))};
    }
    if (const std::optional<Rgba8> color = readColor(used, end)) {
      vertex.color = *color;
      hasVertexColors_ = true;
    }
    vertices_.push_back(vertex);
  }

  void readFace()
  {
    requireLine("its last face");
    const std::size_t count = lines_.count(0, "the number of corners", lines_.size() - 1);
    Face face{corners_.size(), readColor(count + 1, lines_.size())};
    for (std::size_t i = 1; i <= count; ++i) {
      corners_.push_back(lines_.count(i, "a corner's vertex", vertexCount_ - 1));
    }
    hasFaceColors_ = hasFaceColors_ || face.color;
    faces_.push_back(face);
  }

  double number(std::size_t i) const { return lines_.number(i, "a coordinate"); }

  /// The colour in the words from `begin` to `end`; none where they are a colour map index.
  std::optional<Rgba8> readColor(std::size_t begin, std::size_t end) const
  {
    const std::size_t channels = end - begin;
    if (channels < 2) return std::nullopt;
    if (channels != 3 && channels != 4) {
      lines_.fail("a colour has 3 or 4 channels, here are " + std::to_string(channels) +
                  " words after the coordinates or corners");
    }
    double scale = 1;
    for (std::size_t i = begin; i < end; ++i) {
      if (isReal(lines_.word(i))) scale = 255;
    }
    std::uint8_t color[4] = {0, 0, 0, 255};
    for (std::size_t i = 0; i < channels; ++i) {
      const double value = std::round(scale * lines_.number(begin + i, "a colour channel"));
      color[i] = static_cast<std::uint8_t>(std::clamp(value, 0.0, 255.0));
    }
    return Rgba8{color[0], color[1], color[2], color[3]};
  }

  NormalForm write() const
  {
    PlyForm form({hasNormals_, hasTexCoords_, hasVertexColors_, hasFaceColors_});
    for (const PlyForm::Vertex& vertex : vertices_)
      form.addVertex(vertex);
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      const std::size_t begin = faces_[i].firstCorner;
      const std::size_t end = i + 1 < faces_.size() ? faces_[i + 1].firstCorner : corners_.size();
      form.addFace({corners_.data() + begin, end - begin},
                   faces_[i].color.value_or(Rgba8{255, 255, 255, 255}));
    }
    return form.finish();
  }

  TextLines lines_;
  bool hasNormals_ = false;
  bool hasTexCoords_ = false;
  bool hasVertexColors_ = false;
  bool hasFaceColors_ = false;
  std::size_t vertexCount_ = 0;
  std::size_t faceCount_ = 0;
  std::vector<PlyForm::Vertex> vertices_;
  std::vector<Face> faces_;
  std::vector<std::uint32_t> corners_;
};

}  // namespace

NormalForm normalizeOff(Source& source)
{
  return OffNormalizer(source).normalize();
}

}  // namespace limn::meshio
