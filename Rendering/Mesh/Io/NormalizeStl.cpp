// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Mesh/Io/NormalForm.h"

#include "Rendering/Mesh/Io/PlyForm.h"
#include "Rendering/Mesh/Io/TextLines.h"

#include <hwy/cache_control.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>
#include <vector>

namespace limn::meshio {
namespace {

constexpr std::size_t kTitleSize = 80;
constexpr std::size_t kHeaderSize = kTitleSize + 4;
constexpr std::size_t kNormalSize = 12;
constexpr std::size_t kFacetSize = 50;

std::uint32_t uint32At(const std::string& bytes, std::size_t byte)
{
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;)
    value = value << 8 | static_cast<std::uint8_t>(bytes[byte + i]);
  return value;
}

float floatAt(const std::string& bytes, std::size_t byte)
{
  const std::uint32_t bits = uint32At(bytes, byte);
  float value = 0;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

std::string lowered(std::string_view word)
{
  std::string text(word);
  std::transform(text.begin(), text.end(), text.begin(), [](char letter) {
    return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
  });
  return text;
}

bool startsWithSolid(const std::string& bytes)
{
  const std::size_t begin = std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size());
  return lowered(std::string_view(bytes).substr(begin, 5)) == "solid";
}

Vec3f cornerAt(const std::string& bytes, std::size_t facet, std::size_t corner)
{
  const std::size_t byte = kHeaderSize + facet * kFacetSize + kNormalSize + 12 * corner;
  return {floatAt(bytes, byte), floatAt(bytes, byte + 4), floatAt(bytes, byte + 8)};
}

/// Numbers places in the order in which they are first met. Open addressing; at most half full, so
/// that probes stay short.
class PlaceTable {
 public:
  explicit PlaceTable(std::size_t places)
  {
    while ((std::size_t{1} << bits_) < 2 * places)
      ++bits_;
    slots_.resize(std::size_t{1} << bits_);
  }

  /// To be called for a place some time before its number is asked for: facets in random order
  /// would else wait for memory at each corner.
  void prefetch(Vec3f place) const { hwy::Prefetch(&slots_[firstSlotOf(place)]); }

  /// The next number for a place not met before; appends it to `places` then.
  std::uint32_t numberOf(Vec3f place, std::vector<Vec3f>& places)
  {
    Slot& slot = slots_[slotOf(place)];
    if (slot.number != kFree) return slot.number;
    const std::uint32_t number = static_cast<std::uint32_t>(places.size());
    slot = {place, number};
    places.push_back(place);
    if (2 * places.size() > slots_.size()) grow();
    return number;
  }

 private:
  static constexpr std::uint32_t kFree = std::numeric_limits<std::uint32_t>::max();
  struct Slot {
    Vec3f place{};
    std::uint32_t number = kFree;
  };

  std::size_t firstSlotOf(Vec3f place) const
  {
    constexpr std::uint64_t kGoldenRatio = 0x9e3779b97f4a7c15u;
    std::uint64_t hash = 0;
    for (const float value : {place.x, place.y, place.z}) {
      // Adding 0 makes 0 of -0, which is equal.
      const float positive = value + 0.0f;
      std::uint32_t bits = 0;
      std::memcpy(&bits, &positive, sizeof bits);
      hash = (hash ^ bits) * kGoldenRatio;
      hash ^= hash >> 32;
    }
    return static_cast<std::size_t>(hash * kGoldenRatio >> (64 - bits_));
  }
  /// Where the place is, or where it belongs.
  std::size_t slotOf(Vec3f place) const
  {
    std::size_t slot = firstSlotOf(place);
    while (slots_[slot].number != kFree && !(slots_[slot].place == place))
      slot = (slot + 1) & (slots_.size() - 1);
    return slot;
  }
  void grow()
  {
    ++bits_;
    std::vector<Slot> old(std::size_t{1} << bits_);
    old.swap(slots_);
    for (const Slot& slot : old)
      if (slot.number != kFree) slots_[slotOf(slot.place)] = slot;
  }

  unsigned bits_ = 4;
  std::vector<Slot> slots_;
};

/// Whether OpenMesh's parser for STL may take different coordinates for equal: it does where they
/// are no more than the least normal float apart.
bool hasTinyCoordinates(const std::string& bytes, std::size_t facets)
{
  const auto isTiny = [](float value) { return value != 0 && std::fabs(value) < 0x1p-100f; };
  for (std::size_t facet = 0; facet < facets; ++facet)
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Vec3f p = cornerAt(bytes, facet, corner);
      if (isTiny(p.x) || isTiny(p.y) || isTiny(p.z)) return true;
    }
  return false;
}

/// Welds the facets' corners as OpenMesh's parser for STL does, which searches a tree for each of
/// them: with facets in random order that takes most of the time of reading.
NormalForm weldedForm(const std::string& bytes, std::size_t facets)
{
  constexpr std::size_t kAhead = 8;
  PlaceTable table(facets / 2);
  std::vector<Vec3f> places;
  std::vector<std::uint32_t> corners;
  corners.reserve(3 * facets);
  for (std::size_t facet = 0; facet < facets; ++facet) {
    for (std::size_t corner = 0; corner < 3 && facet + kAhead < facets; ++corner)
      table.prefetch(cornerAt(bytes, facet + kAhead, corner));
    for (std::size_t corner = 0; corner < 3; ++corner)
      corners.push_back(table.numberOf(cornerAt(bytes, facet, corner), places));
  }
  PlyForm form({});
  for (const Vec3f& place : places)
    form.addVertex({vec3Cast<double>(place)});
  for (std::size_t facet = 0; facet < facets; ++facet)
    form.addFace({corners.data() + 3 * facet, 3}, {});
  return form.finish();
}

NormalForm stlForm(std::string bytes, std::size_t facets)
{
  if (!hasTinyCoordinates(bytes, facets)) return weldedForm(bytes, facets);
  NormalForm form;
  form.parser = Parser::kStl;
  form.bytes = std::move(bytes);
  form.faceCount = facets;
  return form;
}

NormalForm normalizeBinary(Source& source)
{
  const std::string& bytes = source.bytes();
  if (bytes.size() < kHeaderSize) {
    source.fail("neither 'solid' nor a whole binary header; the file is truncated or no STL");
  }
  const std::size_t facets = uint32At(bytes, kTitleSize);
  const std::size_t available = (bytes.size() - kHeaderSize) / kFacetSize;
  if (facets > available) {
    source.failAtByte(kTitleSize, "the header announces " + std::to_string(facets) +
                                      " triangles, but the file ends after " +
                                      std::to_string(available) + "; it is truncated");
  }
  if (facets == 0) source.fail("the file has no triangles");
  for (std::size_t facet = 0; facet < facets; ++facet) {
    const std::size_t first = kHeaderSize + facet * kFacetSize + kNormalSize;
    for (std::size_t byte = first; byte < first + 36; byte += 4) {
      if (std::isfinite(floatAt(bytes, byte))) continue;
      source.failAtByte(byte,
                        "a coordinate of triangle " + std::to_string(facet) + " is NaN or infinite",
                        Error::kNotFinite);
    }
    source.reportChecked(first);
  }
  return stlForm(source.takeBytes(), facets);
}

/// Brings ASCII STL to binary: OpenMesh's parser for ASCII takes any line that has "outer" in it,
/// be it a name, for the start of a facet.
class AsciiStlNormalizer {
 public:
  explicit AsciiStlNormalizer(Source& source) : source_(source), lines_(source, {}) {}

  NormalForm normalize()
  {
    bytes_.assign(kHeaderSize, ' ');
    while (lines_.next())
      readLine(lowered(lines_.word(0)));
    if (place_ != Place::kOutside) {
      lines_.fail("the file ends inside a solid; it is truncated or lacks endsolid");
    }
    if (facets_ == 0) source_.fail("the file has no triangles");
    if (facets_ > std::numeric_limits<std::int32_t>::max()) source_.fail("too many triangles");
    std::string count;
    appendUint32(count, static_cast<std::uint32_t>(facets_));
    bytes_.replace(kTitleSize, count.size(), count);
    return stlForm(std::move(bytes_), facets_);
  }

 private:
  enum class Place { kOutside, kSolid, kFacet, kLoop, kAfterLoop };

  void readLine(const std::string& keyword)
  {
    if (keyword == "solid") {
      move(Place::kOutside, Place::kSolid, keyword);
    } else if (keyword == "facet") {
      move(Place::kSolid, Place::kFacet, keyword);
      bytes_.append(kNormalSize, '\0');
    } else if (keyword == "outer") {
      move(Place::kFacet, Place::kLoop, keyword);
      corners_ = 0;
    } else if (keyword == "vertex") {
      move(Place::kLoop, Place::kLoop, keyword);
      readVertex();
    } else if (keyword == "endloop") {
      move(Place::kLoop, Place::kAfterLoop, keyword);
      if (corners_ != 3) lines_.fail("a facet of STL has 3 vertices, this one has fewer");
    } else if (keyword == "endfacet") {
      move(Place::kAfterLoop, Place::kSolid, keyword);
      bytes_.append(2, '\0');
      ++facets_;
    } else if (keyword == "endsolid") {
      move(Place::kSolid, Place::kOutside, keyword);
    } else {
      lines_.fail("unknown keyword " + quoted(keyword));
    }
  }

  void move(Place from, Place to, const std::string& keyword)
  {
    if (place_ != from) lines_.fail(quoted(keyword) + " is out of place");
    place_ = to;
  }

  void readVertex()
  {
    if (corners_ == 3) lines_.fail("a facet of STL has 3 vertices, this one has more");
    ++corners_;
    for (std::size_t i = 1; i <= 3; ++i) {
      appendFloat(bytes_, static_cast<float>(lines_.number(i, "a coordinate")));
    }
  }

  Source& source_;
  TextLines lines_;
  std::string bytes_;
  Place place_ = Place::kOutside;
  int corners_ = 0;
  std::size_t facets_ = 0;
};

}  // namespace

NormalForm normalizeStl(Source& source)
{
  // Some writers of binary STL start their title with "solid", too.
  const std::string& bytes = source.bytes();
  const bool fitsBinary = bytes.size() >= kHeaderSize &&
                          bytes.size() == kHeaderSize + kFacetSize * uint32At(bytes, kTitleSize);
  if (startsWithSolid(bytes) && !fitsBinary) return AsciiStlNormalizer(source).normalize();
  return normalizeBinary(source);
}

}  // namespace limn::meshio
