// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace limn {

/// Numbered things, those that hang together, and how many these are.
class Components {
 public:
  explicit Components(std::size_t count) : parent_(count), size_(count, 1)
  {
    for (std::size_t i = 0; i < count; ++i)
      parent_[i] = static_cast<std::uint32_t>(i);
  }
  void join(std::size_t a, std::size_t b)
  {
    std::size_t first = rootOf(a), second = rootOf(b);
    if (first == second) return;
    if (size_[first] < size_[second]) std::swap(first, second);
    parent_[second] = static_cast<std::uint32_t>(first);
    size_[first] += size_[second];
  }
  /// As if `more` others hung together with it.
  void grow(std::size_t i, std::uint32_t more) { size_[rootOf(i)] += more; }
  std::uint32_t sizeAt(std::size_t i) { return size_[rootOf(i)]; }

 private:
  std::size_t rootOf(std::size_t i)
  {
    while (parent_[i] != i) {
      parent_[i] = parent_[parent_[i]];
      i = parent_[i];
    }
    return i;
  }

  std::vector<std::uint32_t> parent_, size_;
};

}  // namespace limn
