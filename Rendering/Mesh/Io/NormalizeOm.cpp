// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Mesh/Io/NormalForm.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

namespace limn::meshio {
namespace {

constexpr std::size_t kHeaderSize = 16;
constexpr std::size_t kStatusSize = 4;

enum Entity : unsigned {
  kVertex = 0,
  kMesh = 1,
  kFace = 2,
  kEdge = 4,
  kHalfedge = 6,
  kSentinel = 7
};
enum Type : unsigned {
  kPosition = 0,
  kNormal = 1,
  kTexCoord = 2,
  kStatus = 3,
  kColor = 4,
  kCustom = 6,
  kTopology = 7
};

/// The 16 bits before each chunk.
struct ChunkHeader {
  explicit ChunkHeader(unsigned bits)
      : named((bits >> 1 & 1u) != 0),
        entity(bits >> 2 & 7u),
        type(bits >> 5 & 15u),
        dimension((bits >> 11 & 7u) + 1),
        sizeCode(bits >> 14 & 3u)
  {
  }

  std::size_t integerSize() const { return std::size_t{1} << sizeCode; }
  /// 4 or 8, or 0 if OpenMesh has no such real number.
  std::size_t realSize() const { return sizeCode == 0 ? 4 : sizeCode == 1 ? 8 : 0; }

  bool named;
  unsigned entity;
  unsigned type;
  unsigned dimension;
  unsigned sizeCode;
};

/// Copies the chunks that hold what is drawn; custom properties make OpenMesh allocate whatever
/// their content demands.
class OmNormalizer {
 public:
  explicit OmNormalizer(Source& source) : source_(source), bytes_(source.bytes()) {}

  NormalForm normalize()
  {
    readHeader();
    while (byte_ < bytes_.size() && readChunk())
      source_.reportChecked(byte_);
    if (!hasPositions_) source_.fail("the file has no vertex positions; it is truncated");
    if (form_.faceCount > 0 && !hasFaces_) source_.fail("the file has no faces; it is truncated");
    if (form_.faceCount > 0 && isHalfedgeMesh() && !hasHalfedges_) {
      source_.fail("the file has no edges; it is truncated");
    }
    return std::move(form_);
  }

 private:
  std::uint64_t unsignedAt(std::size_t byte, std::size_t size) const
  {
    std::uint64_t value = 0;
    for (std::size_t i = size; i-- > 0;) {
      value = value << 8 | static_cast<std::uint8_t>(bytes_[byte + i]);
    }
    return value;
  }

  void requireBytes(std::uint64_t count) const
  {
    if (bytes_.size() - byte_ >= count) return;
    source_.failAtByte(byte_, std::to_string(count) + " bytes should follow, but the file has " +
                                  std::to_string(bytes_.size() - byte_) + "; it is truncated");
  }

  void readHeader()
  {
    if (bytes_.compare(0, 2, "OM") != 0) source_.fail("an OM file starts with the letters OM");
    requireBytes(kHeaderSize);
    kind_ = bytes_[2];
    if (kind_ != 'T' && kind_ != 'Q' && kind_ != 'P') {
      source_.failAtByte(2, "the kind of mesh is none of T, Q and P");
    }
    version_ = static_cast<std::uint8_t>(bytes_[3]);
    if (version_ > kNewestVersion) {
      source_.failAtByte(3, "version " + std::to_string(version_ >> 5) + "." +
                                std::to_string(version_ & 31) +
                                " of the format is newer than this program");
    }
    form_.parser = Parser::kOm;
    form_.vertexCount = unsignedAt(4, 4);
    form_.faceCount = unsignedAt(8, 4);
    edgeCount_ = unsignedAt(12, 4);
    if (form_.vertexCount == 0) source_.fail("the file has no vertices");
    constexpr std::size_t kMost = std::numeric_limits<std::int32_t>::max();
    if (std::max({form_.vertexCount, form_.faceCount, 2 * edgeCount_}) > kMost) {
      source_.failAtByte(4, "more vertices, faces or edges than 2^31 - 1");
    }
    form_.bytes = bytes_.substr(0, kHeaderSize);
    byte_ = kHeaderSize;
  }

  bool isHalfedgeMesh() const { return version_ >= kFirstHalfedgeVersion; }

  bool readChunk()
  {
    const std::size_t begin = byte_;
    requireBytes(2);
    const ChunkHeader chunk(static_cast<unsigned>(unsignedAt(byte_, 2)));
    byte_ += 2;
    if (chunk.entity == kSentinel) return false;
    if (chunk.named) skipString();
    if (chunk.type == kCustom) {
      skipCustom();
      return true;
    }
    const bool isDrawn = readKnown(chunk);
    if (isDrawn) form_.bytes.append(bytes_, begin, byte_ - begin);
    return true;
  }

  void skipString()
  {
    requireBytes(1);
    const std::size_t length = unsignedAt(byte_, 1);
    ++byte_;
    skip(1, length);
  }

  void skipCustom()
  {
    if (version_ > kLastUntypedVersion) skipString();
    requireBytes(4);
    const std::size_t size = unsignedAt(byte_, 4);
    byte_ += 4;
    skip(1, size);
  }

  /// Checks and passes over a chunk that is not custom; returns whether it is drawn.
  bool readKnown(const ChunkHeader& chunk)
  {
    if (chunk.named) source_.failAtByte(byte_, "a property with a name must be a custom one");
    if (chunk.type == kStatus) {
      skip(countOf(chunk), kStatusSize);
      return false;
    }
    if (chunk.type == kTopology) {
      readTopology(chunk);
      return chunk.entity != kVertex;
    }
    if (chunk.entity == kVertex && chunk.type == kPosition) {
      readPositions(chunk);
      return true;
    }
    if (chunk.entity == kVertex || chunk.entity == kFace) return readAttribute(chunk);
    if (chunk.entity == kHalfedge && chunk.type == kTexCoord) {
      readTexCoords(chunk, 2 * edgeCount_);
      return true;
    }
    failUnknown();
  }

  bool readAttribute(const ChunkHeader& chunk)
  {
    if (!hasPositions_) source_.failAtByte(byte_, "attributes stand before the positions");
    const std::size_t count = countOf(chunk);
    if (chunk.type == kColor) {
      requireDimension(chunk, 3);
      if (chunk.integerSize() != 1) source_.failAtByte(byte_, "colours must have 8 bits a channel");
      if (chunk.entity == kFace && !hasFaces_) failUnknown();
      skip(count, 3);
      (chunk.entity == kVertex ? form_.hasVertexColors : form_.hasFaceColors) = true;
      return true;
    }
    if (chunk.type == kNormal) {
      readReals(chunk, count, 3);
      form_.hasNormals = form_.hasNormals || chunk.entity == kVertex;
      return chunk.entity == kVertex;
    }
    if (chunk.type == kTexCoord && chunk.entity == kVertex) {
      readTexCoords(chunk, count);
      return true;
    }
    failUnknown();
  }

  std::size_t countOf(const ChunkHeader& chunk) const
  {
    switch (chunk.entity) {
      case kVertex:
        return form_.vertexCount;
      case kFace:
        return form_.faceCount;
      case kEdge:
        return edgeCount_;
      case kHalfedge:
        return 2 * edgeCount_;
      default:
        failUnknown();
    }
  }

  void requireDimension(const ChunkHeader& chunk, unsigned dimension) const
  {
    if (chunk.dimension == dimension) return;
    source_.failAtByte(byte_, "an attribute of dimension " + std::to_string(chunk.dimension) +
                                  ", which must be " + std::to_string(dimension));
  }

  void skip(std::uint64_t count, std::size_t size)
  {
    requireBytes(count * size);
    byte_ += static_cast<std::size_t>(count) * size;
  }

  double realAt(std::size_t byte, std::size_t size) const
  {
    const std::uint64_t bits = unsignedAt(byte, size);
    if (size == sizeof(double)) {
      double value = 0;
      std::memcpy(&value, &bits, sizeof value);
      return value;
    }
    const std::uint32_t narrow = static_cast<std::uint32_t>(bits);
    float value = 0;
    std::memcpy(&value, &narrow, sizeof value);
    return static_cast<double>(value);
  }

  double readReal(std::size_t size)
  {
    const double value = realAt(byte_, size);
    if (!(std::abs(value) <= static_cast<double>(std::numeric_limits<float>::max()))) {
      source_.failAtByte(byte_, "a number is NaN, infinite or beyond float's range",
                         Error::kNotFinite);
    }
    byte_ += size;
    return value;
  }

  std::size_t requireReals(const ChunkHeader& chunk, std::uint64_t count, unsigned dimension)
  {
    requireDimension(chunk, dimension);
    const std::size_t size = chunk.realSize();
    if (size == 0) source_.failAtByte(byte_, "real numbers must have 32 or 64 bits");
    requireBytes(count * dimension * size);
    return size;
  }

  void readReals(const ChunkHeader& chunk, std::uint64_t count, unsigned dimension)
  {
    const std::size_t size = requireReals(chunk, count, dimension);
    for (std::uint64_t i = 0; i < count * dimension; ++i)
      readReal(size);
  }

  void readTexCoords(const ChunkHeader& chunk, std::uint64_t count)
  {
    if (chunk.realSize() != 4) source_.failAtByte(byte_, "texture coordinates must be float");
    readReals(chunk, count, 2);
    form_.hasTexCoords = true;
  }

  void readPositions(const ChunkHeader& chunk)
  {
    if (hasPositions_) source_.failAtByte(byte_, "the file has positions twice");
    const std::size_t size = requireReals(chunk, form_.vertexCount, 3);
    form_.positions.resize(form_.vertexCount);
    for (Vec3d& position : form_.positions) {
      position.x = readReal(size);
      position.y = readReal(size);
      position.z = readReal(size);
    }
    hasPositions_ = true;
  }

  void readTopology(const ChunkHeader& chunk)
  {
    const std::size_t size = chunk.integerSize();
    switch (chunk.entity) {
      case kVertex:
        skip(form_.vertexCount, size);
        break;
      case kHalfedge:
        if (hasHalfedges_) source_.failAtByte(byte_, "the file has edges twice");
        hasHalfedges_ = true;
        skip(2 * edgeCount_, 3 * size);
        break;
      case kFace:
        if (hasFaces_) source_.failAtByte(byte_, "the file has faces twice");
        hasFaces_ = true;
        skipFaces(size);
        break;
      default:
        failUnknown();
    }
  }

  void skipFaces(std::size_t size)
  {
    if (isHalfedgeMesh() || kind_ != 'P') {
      skip(form_.faceCount, isHalfedgeMesh() ? size : size * (kind_ == 'T' ? 3 : 4));
      return;
    }
    for (std::size_t face = 0; face < form_.faceCount; ++face) {
      requireBytes(2);
      const std::uint64_t corners = unsignedAt(byte_, 2);
      byte_ += 2;
      skip(corners, size);
    }
  }

  [[noreturn]] void failUnknown() const
  {
    source_.failAtByte(byte_, "a chunk of unknown kind, or out of place; the file is damaged");
  }

  // Major version in the upper 3 bits, minor in the lower 5.
  static constexpr unsigned kFirstHalfedgeVersion = 2u << 5;
  static constexpr unsigned kLastUntypedVersion = 2u << 5 | 1u;
  static constexpr unsigned kNewestVersion = 2u << 5 | 2u;

  Source& source_;
  const std::string& bytes_;
  std::size_t byte_ = 0;
  char kind_ = 'P';
  unsigned version_ = 0;
  std::uint64_t edgeCount_ = 0;
  bool hasPositions_ = false;
  bool hasHalfedges_ = false;
  bool hasFaces_ = false;
  NormalForm form_;
};

}  // namespace

NormalForm normalizeOm(Source& source)
{
  return OmNormalizer(source).normalize();
}

}  // namespace limn::meshio
