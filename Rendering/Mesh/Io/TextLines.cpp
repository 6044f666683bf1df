// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Mesh/Io/TextLines.h"

#include <charconv>
#include <cmath>
#include <limits>

namespace limn::meshio {
namespace {

bool isBlank(char letter)
{
  return letter == ' ' || letter == '\t' || letter == '\r' || letter == '\v' || letter == '\f';
}

/// Of a number that no double can hold: is it so near to 0, or so large?
bool isTiny(std::string_view word)
{
  const std::size_t exponent = word.find_first_of("eE");
  if (exponent != std::string_view::npos) return word.substr(exponent + 1, 1) == "-";
  const std::size_t digit = word.find_first_of("123456789");
  return word.find('.') < digit;
}

}  // namespace

std::optional<double> parseNumber(std::string_view word)
{
  if (!word.empty() && word.front() == '+') word.remove_prefix(1);
  if (word.empty() || word.front() == '+') return std::nullopt;
  double value = 0;
  const char* const end = word.data() + word.size();
  const std::from_chars_result result = std::from_chars(word.data(), end, value);
  if (result.ptr != end || result.ec == std::errc::invalid_argument) return std::nullopt;
  if (result.ec == std::errc::result_out_of_range) {
    return isTiny(word) ? 0.0 : std::numeric_limits<double>::infinity();
  }
  return value;
}

std::string quoted(std::string_view word)
{
  constexpr std::size_t kLongest = 40;
  std::string text = "'";
  for (const char letter : word.substr(0, kLongest)) {
    text += letter >= ' ' && letter <= '~' ? letter : '?';
  }
  return text + (word.size() > kLongest ? "...'" : "'");
}

bool TextLines::next()
{
  words_.clear();
  while (words_.empty()) {
    if (byte_ == source_.bytes().size()) return false;
    appendWordsOfOneLine();
    while (endsInContinuation() && byte_ < source_.bytes().size())
      appendWordsOfOneLine();
  }
  source_.reportChecked(byte_);
  return true;
}

void TextLines::appendWordsOfOneLine()
{
  ++line_;
  const std::string& bytes = source_.bytes();
  const std::size_t newline = bytes.find('\n', byte_);
  const std::size_t end = newline == std::string::npos ? bytes.size() : newline;
  std::size_t i = byte_;
  while (i < end) {
    while (i < end && isBlank(bytes[i]))
      ++i;
    const std::size_t begin = i;
    while (i < end && !isBlank(bytes[i]))
      ++i;
    if (begin == i) break;
    if (syntax_.comment != '\0' && bytes[begin] == syntax_.comment) break;
    words_.emplace_back(bytes.data() + begin, i - begin);
  }
  byte_ = newline == std::string::npos ? end : end + 1;
}

bool TextLines::endsInContinuation()
{
  if (!syntax_.continuation || words_.empty() || words_.back().back() != '\\') return false;
  words_.back().remove_suffix(1);
  if (words_.back().empty()) words_.pop_back();
  return true;
}

std::string_view TextLines::require(std::size_t i, const char* what) const
{
  if (i >= words_.size()) fail(std::string("the line ends before ") + what + "; complete it");
  return words_[i];
}

double TextLines::number(std::size_t i, const char* what) const
{
  const std::string_view text = require(i, what);
  const std::optional<double> value = parseNumber(text);
  if (!value) fail(std::string(what) + " is " + quoted(text) + " instead of a number");
  if (!(std::abs(*value) <= static_cast<double>(std::numeric_limits<float>::max()))) {
    fail(std::string(what) + " is " + quoted(text) + ", but must be finite and in float's range",
         Error::kNotFinite);
  }
  return *value;
}

std::uint32_t TextLines::count(std::size_t i, const char* what, std::size_t largest) const
{
  const std::string_view text = require(i, what);
  std::uint64_t value = 0;
  const char* const end = text.data() + text.size();
  const std::from_chars_result result = std::from_chars(text.data(), end, value);
  if (result.ptr != end || result.ec == std::errc::invalid_argument) {
    fail(std::string(what) + " is " + quoted(text) + " instead of a whole number");
  }
  if (result.ec != std::errc() || value > largest) {
    fail(std::string(what) + " is " + quoted(text) + ", but can be " + std::to_string(largest) +
             " at most",
         Error::kIndexOutOfRange);
  }
  return static_cast<std::uint32_t>(value);
}

void TextLines::fail(const std::string& what, Error error) const
{
  source_.failAtLine(line_, what, error);
}

}  // namespace limn::meshio
