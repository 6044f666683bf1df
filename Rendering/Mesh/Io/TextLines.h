// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Mesh/Io/Source.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace limn::meshio {

/// The decimal number that `word` is, without regard to the user's locale; infinity if it is too
/// large for a double; nothing if it is none.
std::optional<double> parseNumber(std::string_view word);

/// The lines of a text file as words between blanks. Ends of lines may be LF or CR LF.
class TextLines {
 public:
  struct Syntax {
    char comment = '\0';        ///< a word starting with this ends the line; '\0': no comments
    bool continuation = false;  ///< a last word '\' joins the next line
  };

  TextLines(Source& source, Syntax syntax) : source_(source), syntax_(syntax) {}

  /// Goes to the next line that has a word; false at the end of the file.
  bool next();
  std::size_t size() const { return words_.size(); }
  std::string_view word(std::size_t i) const { return words_[i]; }

  /// Word i as a finite number in float's range. `what` names it in the Fault thrown otherwise,
  /// also if there is no such word.
  double number(std::size_t i, const char* what) const;
  /// Word i as a whole number from 0 to `largest`.
  std::uint32_t count(std::size_t i, const char* what, std::size_t largest) const;

  std::size_t line() const { return line_; }
  std::size_t remainingBytes() const { return source_.bytes().size() - byte_; }
  Source& source() const { return source_; }
  [[noreturn]] void fail(const std::string& what, Error error = Error::kFile) const;

 private:
  void appendWordsOfOneLine();
  bool endsInContinuation();
  std::string_view require(std::size_t i, const char* what) const;

  Source& source_;
  Syntax syntax_;
  std::size_t byte_ = 0;
  std::size_t line_ = 0;
  std::vector<std::string_view> words_;
};

/// The word in quotes, without what a terminal cannot show, and not longer than a message bears.
std::string quoted(std::string_view word);

}  // namespace limn::meshio
