// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace limn {

inline constexpr std::size_t kCacheLine = 64;  ///< bytes

/// Memory from the start of a cache line on. Leaves new numbers as they are: the threads that fill
/// a large array shall be the first to touch its pages, and nobody twice.
template <class T>
struct UninitializedAllocator : std::allocator<T> {
  template <class U>
  struct rebind {
    using other = UninitializedAllocator<U>;
  };
  using std::allocator<T>::allocator;

  T* allocate(std::size_t count)
  {
    return static_cast<T*>(::operator new(count * sizeof(T), std::align_val_t(kCacheLine)));
  }
  void deallocate(T* p, std::size_t) { ::operator delete(p, std::align_val_t(kCacheLine)); }

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
