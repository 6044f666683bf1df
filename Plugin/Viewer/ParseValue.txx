// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ParseValue.h"
#include "UserError.h"

#include <algorithm>

namespace limn::viewer
{

template <typename Value>
Value parseChoice(const std::string& option, const std::string& text, const Choices<Value>& choices,
  const std::vector<std::string>& later)
{
  std::vector<std::string> names;
  for (const auto& [name, value] : choices)
  {
    if (name == text)
    {
      return value;
    }
    names.push_back(name);
  }
  if (std::find(later.begin(), later.end(), text) != later.end())
  {
    throw UserError(
      option + "=" + text + " is not served by this version; choose one of: " + joinWords(names));
  }
  const std::string small = inSmallLetters(text);
  if (std::find(names.begin(), names.end(), small) != names.end())
  {
    throw UserError(
      option + "=" + text + " is unknown; write it in small letters: " + option + "=" + small);
  }
  throw UserError(option + "=" + text + " is unknown; choose one of: " + joinWords(names));
}

} // namespace limn::viewer
