// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <type_traits>
#include <vector>

namespace limn {

/// A borrowed run of equal elements: pointer and count. The C++20 std::span, as far as we need it.
/// The owner must outlive the view.
template <class T>
class Span {
 public:
  constexpr Span() = default;
  constexpr Span(T* data, std::size_t size) : data_(data), size_(size) {}

  template <class U, class A, class = std::enable_if_t<std::is_same_v<T, const U>>>
  Span(const std::vector<U, A>& owner) : data_(owner.data()), size_(owner.size())
  {
  }
  template <class U, class A, class = std::enable_if_t<std::is_same_v<std::remove_const_t<T>, U>>>
  Span(std::vector<U, A>& owner) : data_(owner.data()), size_(owner.size())
  {
  }

  constexpr T* data() const { return data_; }
  constexpr std::size_t size() const { return size_; }
  constexpr bool empty() const { return size_ == 0; }
  constexpr T& operator[](std::size_t i) const { return data_[i]; }
  constexpr T* begin() const { return data_; }
  constexpr T* end() const { return data_ + size_; }

 private:
  T* data_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace limn
