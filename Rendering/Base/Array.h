// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/HugePages.h"

#include <cstddef>
#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace limn {

inline constexpr std::size_t kCacheLine = 64;  ///< bytes
/// Arrays from this size on are made of huge pages, of which the last is hardly ever full; bytes.
inline constexpr std::size_t kHugeArray = 8 * kHugePage;

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
    const std::size_t bytes = count * sizeof(T);
    void* const memory = ::operator new(bytes, alignmentOf(bytes));
    if (bytes >= kHugeArray) preferHugePages(memory, bytes);
    return static_cast<T*>(memory);
  }
  void deallocate(T* p, std::size_t count) { ::operator delete(p, alignmentOf(count * sizeof(T))); }

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

 private:
  static std::align_val_t alignmentOf(std::size_t bytes)
  {
    return std::align_val_t(bytes >= kHugeArray ? kHugePage : kCacheLine);
  }
};

/// A vector whose resize() sets no value.
template <class T>
using Array = std::vector<T, UninitializedAllocator<T>>;

}  // namespace limn
