// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Mesh/Io/PlyValues.h"

#include "Rendering/Mesh/Io/TextLines.h"

#include <cmath>
#include <cstring>
#include <limits>

namespace limn::meshio {
namespace {

template <class T, class Bits>
double valueOfBits(std::uint64_t bits)
{
  static_assert(sizeof(T) == sizeof(Bits));
  const Bits narrow = static_cast<Bits>(bits);
  T value;
  std::memcpy(&value, &narrow, sizeof value);
  return static_cast<double>(value);
}

double valueOfBits(PlyType type, std::uint64_t bits)
{
  switch (type) {
    case PlyType::kInt8:
      return valueOfBits<std::int8_t, std::uint8_t>(bits);
    case PlyType::kInt16:
      return valueOfBits<std::int16_t, std::uint16_t>(bits);
    case PlyType::kInt32:
      return valueOfBits<std::int32_t, std::uint32_t>(bits);
    case PlyType::kFloat32:
      return valueOfBits<float, std::uint32_t>(bits);
    case PlyType::kFloat64:
      return valueOfBits<double, std::uint64_t>(bits);
    default:
      return static_cast<double>(bits);
  }
}

bool isBlank(char letter)
{
  return letter == ' ' || letter == '\t' || letter == '\r' || letter == '\n';
}

}  // namespace

PlyValues::PlyValues(Source& source, const PlyHeader& header)
    : source_(source), encoding_(header.encoding), byte_(header.size), line_(header.lineCount + 1)
{
}

double PlyValues::next(PlyType type)
{
  if (encoding_ != PlyEncoding::kAscii) return nextBinary(type);
  const std::string_view word = nextWord();
  const std::optional<double> value = parseNumber(word);
  if (!value) fail("here is " + quoted(word) + " instead of a number");
  return *value;
}

void PlyValues::skip(PlyType type)
{
  if (encoding_ == PlyEncoding::kAscii) {
    nextWord();
  } else {
    nextBinary(type);
  }
}

std::uint32_t PlyValues::nextCount(PlyType type, const char* what, std::size_t largest)
{
  const double value = next(type);
  if (!(value >= 0 && value <= static_cast<double>(largest) && std::floor(value) == value)) {
    fail(std::string(what) + " is not a whole number from 0 to " + std::to_string(largest),
         Error::kIndexOutOfRange);
  }
  return static_cast<std::uint32_t>(value);
}

std::uint32_t PlyValues::nextLength(PlyType type, const char* what, std::size_t size)
{
  constexpr std::size_t kMost = std::numeric_limits<std::uint32_t>::max();
  const std::uint32_t length =
      nextCount(type, (std::string("the number of ") + what).c_str(), kMost);
  const std::size_t smallest = encoding_ == PlyEncoding::kAscii ? 1 : size;
  if (length > remainingBytes() / smallest) {
    fail(std::to_string(length) + " " + what +
         " do not fit into the rest of the file; it is truncated or the number is wrong");
  }
  return length;
}

std::string_view PlyValues::nextWord()
{
  const std::string& bytes = source_.bytes();
  while (byte_ < bytes.size() && isBlank(bytes[byte_])) {
    if (bytes[byte_] == '\n') ++line_;
    ++byte_;
  }
  valueByte_ = byte_;
  while (byte_ < bytes.size() && !isBlank(bytes[byte_]))
    ++byte_;
  if (valueByte_ == byte_) fail("the file ends before all that its header announces");
  source_.reportChecked(byte_);
  return {bytes.data() + valueByte_, byte_ - valueByte_};
}

double PlyValues::nextBinary(PlyType type)
{
  const std::size_t size = sizeOf(type);
  valueByte_ = byte_;
  if (remainingBytes() < size) fail("the file ends before all that its header announces");
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t place = encoding_ == PlyEncoding::kLittleEndian ? size - 1 - i : i;
    bits = bits << 8 | static_cast<std::uint8_t>(source_.bytes()[byte_ + place]);
  }
  byte_ += size;
  source_.reportChecked(byte_);
  return valueOfBits(type, bits);
}

void PlyValues::fail(const std::string& what, Error error) const
{
  if (encoding_ == PlyEncoding::kAscii) source_.failAtLine(line_, what, error);
  source_.failAtByte(valueByte_, what, error);
}

}  // namespace limn::meshio
