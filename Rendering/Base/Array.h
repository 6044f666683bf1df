// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <utility>
#include <vector>

namespace limn {

/// Leaves new numbers as they are: the threads that fill a large array shall be the first to touch
/// its pages, and nobody twice.
template <class T>
struct UninitializedAllocator : std::allocator<T> {
  template <class U>
  struct rebind {
    using other = UninitializedAllocator<U>;
  };
  using std::allocator<T>::allocator;

  template <class U>
  void construct(U* p)
  {
    ::new (static_cast<void*>(p)) U;
  }
  template <class U, class First, class... Rest>
  void construct(U* p, First&& first, Rest&&... rest)
  {
    ::new (static_cast<void*>(p)) U(std::forward<First>(first), std::forward<Rest>(rest)...);
  }
};

/// A vector whose resize() sets no value.
template <class T>
using Array = std::vector<T, UninitializedAllocator<T>>;

}  // namespace limn
