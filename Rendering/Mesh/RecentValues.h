// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>

namespace limn {

/// Values by number, found anew unless found a short while ago: edges that come one after another
/// share vertices and faces. One for each thread.
template <class Value>
class RecentValues {
 public:
  RecentValues() { std::fill(number_, number_ + kCount, kNone); }

  /// Whether at() knows it without finding it.
  bool has(std::uint32_t number) const { return number_[number % kCount] == number; }
  /// What `find(number)` gave or gives. Until the next call.
  template <class Find>
  const Value& at(std::uint32_t number, const Find& find)
  {
    const std::uint32_t slot = number % kCount;
    if (number_[slot] != number) {
      value_[slot] = find(number);
      number_[slot] = number;
    }
    return value_[slot];
  }

 private:
  static constexpr std::uint32_t kCount = 128, kNone = 0xFFFFFFFFu;

  std::uint32_t number_[kCount];
  Value value_[kCount];
};

}  // namespace limn
