// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Mesh/Io/NormalForm.h"

#include "Rendering/Mesh/Io/TextLines.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <limits>

namespace limn::meshio {
namespace {

/// OpenMesh's parser looks for repeated vertices of a face by comparing all with all.
constexpr std::size_t kMostCorners = 1 << 14;
constexpr std::uintmax_t kLargestMaterialFile = 1 << 24;

/// One of the three lists that faces refer to.
struct References {
  const char* name;
  std::size_t count = 0;
  std::size_t largest = 0;      ///< that a face has named so far; faces may stand before vertices
  std::size_t largestLine = 0;  ///< where
};

void appendIndex(std::string& bytes, std::size_t index)
{
  char digits[24];
  const std::to_chars_result end = std::to_chars(digits, digits + sizeof digits, index);
  bytes.append(digits, end.ptr);
}

/// Writes OBJ anew: only what is drawn, positive indices, no comments or joined lines. Each vertex
/// gets a colour, because OpenMesh's parser then tells the importer about each corner of a face.
class ObjNormalizer {
 public:
  explicit ObjNormalizer(Source& source) : source_(source), lines_(source, {'#', true}) {}

  NormalForm normalize()
  {
    while (lines_.next())
      readLine();
    for (const References& references : lists_)
      requireTargets(references);
    if (lists_[kVertices].count == 0) source_.fail("the file has no vertices");
    if (lists_[kVertices].count > std::numeric_limits<std::int32_t>::max()) {
      source_.fail("more vertices than 2^31 - 1; split the mesh");
    }
    form_.parser = Parser::kObj;
    form_.vertexCount = lists_[kVertices].count;
    form_.hasTexCoords = lists_[kTexCoords].largest > 0;
    form_.hasNormals = lists_[kNormals].largest > 0;
    return std::move(form_);
  }

 private:
  enum List { kVertices, kTexCoords, kNormals };

  void readLine()
  {
    const std::string_view keyword = lines_.word(0);
    if (keyword == "v") {
      readVertex();
    } else if (keyword == "vt") {
      ++lists_[kTexCoords].count;
      // The second number is optional in OBJ, but not in OpenMesh's parser.
      readNumbers("vt", lines_.size() > 2 ? 2 : 1);
      form_.bytes += lines_.size() > 2 ? "\n" : " 0\n";
    } else if (keyword == "vn") {
      ++lists_[kNormals].count;
      readNumbers("vn", 3);
      form_.bytes += '\n';
    } else if (keyword == "f" || keyword == "fo") {
      readFace();
    } else if (keyword == "mtllib" && lines_.size() > 1) {
      readMaterialFile();
    } else if (keyword == "usemtl" && lines_.size() > 1 && hasMaterials_) {
      form_.bytes += "usemtl ";
      form_.bytes += lines_.word(1);
      form_.bytes += '\n';
    }
  }

  void readNumbers(const char* keyword, std::size_t count)
  {
    form_.bytes += keyword;
    for (std::size_t i = 1; i <= count; ++i) {
      lines_.number(i, "a coordinate");
      form_.bytes += ' ';
      form_.bytes += lines_.word(i);
    }
  }

  void readVertex()
  {
    ++lists_[kVertices].count;
    readNumbers("v", 3);
    const auto coordinate = [this](std::size_t i) { return lines_.number(i, "a coordinate"); };
    form_.positions.push_back({coordinate(1), coordinate(2), coordinate(3)});
    const bool hasColor = lines_.size() >= 7;
    for (std::size_t i = 4; i < 7; ++i) {
      form_.bytes += ' ';
      if (hasColor) lines_.number(i, "a colour channel");
      form_.bytes += hasColor ? lines_.word(i) : "1";
    }
    form_.bytes += '\n';
    form_.hasVertexColors = form_.hasVertexColors || hasColor;
  }

  void readFace()
  {
    ++form_.faceCount;
    if (lines_.size() - 1 > kMostCorners) {
      lines_.fail("a face of " + std::to_string(lines_.size() - 1) +
                  " corners; split it into some "
                  "of " +
                  std::to_string(kMostCorners) + " at most");
    }
    const std::size_t begin = form_.bytes.size();
    std::array<std::size_t, 3> distinct{};
    std::size_t distinctCount = 0;
    form_.bytes += 'f';
    for (std::size_t i = 1; i < lines_.size(); ++i) {
      form_.bytes += ' ';
      const std::size_t vertex = readCorner(lines_.word(i));
      const auto end = distinct.begin() + static_cast<std::ptrdiff_t>(distinctCount);
      if (distinctCount < 3 && std::find(distinct.begin(), end, vertex) == end) {
        distinct[distinctCount++] = vertex;
      }
    }
    form_.bytes += '\n';
    // OpenMesh's parser passes over such a face, but not without naming its corners.
    if (distinctCount < 3) form_.bytes.resize(begin);
  }

  /// "7", "7/2", "7//3" or "7/2/3". Returns the vertex.
  std::size_t readCorner(std::string_view word)
  {
    std::size_t vertex = 0;
    for (int list = kVertices; list <= kNormals; ++list) {
      const std::size_t slash = std::min(word.find('/'), word.size());
      const std::string_view part = word.substr(0, slash);
      if (list != kVertices) form_.bytes += '/';
      if (!part.empty() || list == kVertices) {
        const std::size_t index = resolve(lists_[static_cast<std::size_t>(list)], part);
        if (list == kVertices) vertex = index;
        appendIndex(form_.bytes, index);
      }
      if (slash == word.size()) return vertex;
      word.remove_prefix(slash + 1);
    }
    lines_.fail("a corner of a face has more than two slashes");
  }

  std::size_t resolve(References& references, std::string_view part)
  {
    if (!part.empty() && part.front() == '+') part.remove_prefix(1);
    std::int64_t index = 0;
    const char* const end = part.data() + part.size();
    const std::from_chars_result result = std::from_chars(part.data(), end, index);
    if (result.ec != std::errc() || result.ptr != end) {
      lines_.fail("a corner of a face names " + quoted(part) + " instead of a whole number");
    }
    const std::int64_t count = static_cast<std::int64_t>(references.count);
    if (index == 0 || index < -count || index > std::numeric_limits<std::int32_t>::max()) {
      failIndex(references, lines_.line(), std::to_string(index));
    }
    const std::size_t target = static_cast<std::size_t>(index < 0 ? count + index + 1 : index);
    if (target > references.largest) {
      references.largest = target;
      references.largestLine = lines_.line();
    }
    return target;
  }

  void requireTargets(const References& references) const
  {
    if (references.largest <= references.count) return;
    failIndex(references, references.largestLine, std::to_string(references.largest));
  }

  [[noreturn]] void failIndex(const References& references, std::size_t line,
                              const std::string& index) const
  {
    source_.failAtLine(line,
                       "a face names " + std::string(references.name) + " " + index +
                           ", but there are " + std::to_string(references.count) +
                           " and they count from 1",
                       Error::kIndexOutOfRange);
  }

  /// OpenMesh opens the file itself: only a regular one of a sane size is named to it.
  void readMaterialFile()
  {
    namespace fs = std::filesystem;
    const char* const begin = lines_.word(1).data();
    const std::string_view last = lines_.word(lines_.size() - 1);
    const std::string name(begin, last.data() + last.size());
    std::error_code error;
    const fs::path path = fs::absolute(fs::path(source_.path()).parent_path() / name, error);
    if (error || !fs::is_regular_file(path, error)) return;
    if (fs::file_size(path, error) > kLargestMaterialFile || error) return;
    hasMaterials_ = true;
    form_.hasFaceColors = true;
    form_.bytes += "mtllib " + path.string() + "\n";
  }

  Source& source_;
  TextLines lines_;
  std::array<References, 3> lists_ = {References{"vertex"}, References{"texture coordinate"},
                                      References{"normal"}};
  bool hasMaterials_ = false;
  NormalForm form_;
};

}  // namespace

NormalForm normalizeObj(Source& source)
{
  return ObjNormalizer(source).normalize();
}

}  // namespace limn::meshio
