// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Mesh/Io/PlyHeader.h"

#include "Rendering/Mesh/Io/TextLines.h"

#include <charconv>
#include <map>
#include <optional>
#include <string_view>

namespace limn::meshio {
namespace {

std::optional<PlyType> typeNamed(std::string_view name)
{
  static const std::map<std::string_view, PlyType> types = {
      {"char", PlyType::kInt8},      {"int8", PlyType::kInt8},       {"uchar", PlyType::kUint8},
      {"uint8", PlyType::kUint8},    {"short", PlyType::kInt16},     {"int16", PlyType::kInt16},
      {"ushort", PlyType::kUint16},  {"uint16", PlyType::kUint16},   {"int", PlyType::kInt32},
      {"int32", PlyType::kInt32},    {"uint", PlyType::kUint32},     {"uint32", PlyType::kUint32},
      {"float", PlyType::kFloat32},  {"float32", PlyType::kFloat32}, {"double", PlyType::kFloat64},
      {"float64", PlyType::kFloat64}};
  const auto found = types.find(name);
  return found == types.end() ? std::nullopt : std::optional<PlyType>(found->second);
}

class HeaderReader {
 public:
  explicit HeaderReader(const Source& source) : source_(source) {}

  PlyHeader read()
  {
    nextLine();
    if (words_.size() != 1 || (words_[0] != "ply" && words_[0] != "PLY")) {
      fail("a PLY file starts with the word ply, this one does not");
    }
    bool hasFormat = false;
    for (;;) {
      nextLine();
      if (words_.empty() || words_[0] == "comment" || words_[0] == "obj_info") continue;
      if (words_[0] == "end_header") break;
      if (words_[0] == "format") {
        readFormat();
        hasFormat = true;
      } else if (words_[0] == "element") {
        readElement();
      } else if (words_[0] == "property") {
        readProperty();
      } else {
        fail("unknown keyword " + quoted(words_[0]) + " in the header");
      }
    }
    if (!hasFormat) fail("the header has no format line");
    header_.size = byte_;
    checkCounts();
    return std::move(header_);
  }

 private:
  void nextLine()
  {
    const std::string& bytes = source_.bytes();
    ++header_.lineCount;
    const std::size_t newline = bytes.find('\n', byte_);
    if (newline == std::string::npos) fail("the file ends before end_header; it is truncated");
    words_.clear();
    std::string_view line(bytes.data() + byte_, newline - byte_);
    while (!line.empty()) {
      const std::size_t begin = line.find_first_not_of(" \t\r");
      if (begin == std::string_view::npos) break;
      line.remove_prefix(begin);
      const std::size_t length = std::min(line.find_first_of(" \t\r"), line.size());
      words_.push_back(line.substr(0, length));
      line.remove_prefix(length);
    }
    byte_ = newline + 1;
  }

  void readFormat()
  {
    if (words_.size() != 3 || words_[2] != "1.0") fail("the format must be 'format NAME 1.0'");
    if (words_[1] == "ascii") {
      header_.encoding = PlyEncoding::kAscii;
    } else if (words_[1] == "binary_little_endian") {
      header_.encoding = PlyEncoding::kLittleEndian;
    } else if (words_[1] == "binary_big_endian") {
      header_.encoding = PlyEncoding::kBigEndian;
    } else {
      fail("unknown format " + quoted(words_[1]));
    }
  }

  void readElement()
  {
    if (words_.size() != 3) fail("an element is 'element NAME COUNT'");
    PlyElement element;
    element.name = words_[1];
    const char* const end = words_[2].data() + words_[2].size();
    const std::from_chars_result result = std::from_chars(words_[2].data(), end, element.count);
    if (result.ec != std::errc() || result.ptr != end) {
      fail("the count of element " + quoted(words_[1]) + " is " + quoted(words_[2]) +
           " instead of a whole number");
    }
    header_.elements.push_back(std::move(element));
    elementLines_.push_back(header_.lineCount);
  }

  void readProperty()
  {
    if (header_.elements.empty()) fail("a property stands before the first element");
    PlyProperty property;
    property.isList = words_.size() > 1 && words_[1] == "list";
    if (words_.size() != (property.isList ? 5u : 3u)) {
      fail("a property is 'property TYPE NAME' or 'property list TYPE TYPE NAME'");
    }
    if (property.isList) {
      property.countType = requireType(words_[2]);
      if (property.countType == PlyType::kFloat32 || property.countType == PlyType::kFloat64) {
        fail("the count of a list cannot be " + quoted(words_[2]));
      }
    }
    property.type = requireType(words_[words_.size() - 2]);
    property.name = words_.back();
    header_.elements.back().properties.push_back(std::move(property));
  }

  PlyType requireType(std::string_view name) const
  {
    const std::optional<PlyType> type = typeNamed(name);
    if (!type) fail("unknown type " + quoted(name));
    return *type;
  }

  void checkCounts() const
  {
    const std::size_t rest = source_.bytes().size() - header_.size;
    for (std::size_t i = 0; i < header_.elements.size(); ++i) {
      const PlyElement& element = header_.elements[i];
      const std::size_t smallest = smallestSize(element);
      // The last value of an ASCII file needs no end of line.
      if (smallest > 0 && element.count > (rest + 1) / smallest) {
        source_.failAtLine(elementLines_[i], std::to_string(element.count) + " of element " +
                                                 quoted(element.name) + " do not fit into the " +
                                                 std::to_string(rest) +
                                                 " bytes after the header; the file is truncated "
                                                 "or the count is wrong");
      }
    }
  }

  std::size_t smallestSize(const PlyElement& element) const
  {
    std::size_t size = 0;
    for (const PlyProperty& property : element.properties) {
      const std::size_t binary = sizeOf(property.isList ? property.countType : property.type);
      size += header_.encoding == PlyEncoding::kAscii ? 2 : binary;
    }
    return size;
  }

  [[noreturn]] void fail(const std::string& what) const
  {
    source_.failAtLine(header_.lineCount, what);
  }

  const Source& source_;
  PlyHeader header_;
  std::vector<std::size_t> elementLines_;
  std::size_t byte_ = 0;
  std::vector<std::string_view> words_;
};

}  // namespace

std::size_t sizeOf(PlyType type)
{
  constexpr std::size_t kSizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return kSizes[static_cast<std::size_t>(type)];
}

PlyHeader readPlyHeader(const Source& source)
{
  return HeaderReader(source).read();
}

}  // namespace limn::meshio
