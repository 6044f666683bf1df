// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Executor.h"

#include <algorithm>
#include <cstddef>

namespace limn {

/// Stretches of `size` elements in [0, count); the last may be shorter.
inline std::size_t stretchCount(std::size_t count, std::size_t size)
{
  return (count + size - 1) / size;
}

/// parallelFor() over stretches: calls body(stretch, first, end) for the elements [first, end) of
/// each, numbered from 0.
template <class Body>
void parallelForStretches(int threads, std::size_t count, std::size_t size, const Body& body)
{
  parallelFor(threads, stretchCount(count, size), [&](std::size_t stretch) {
    body(stretch, stretch * size, std::min(count, (stretch + 1) * size));
  });
}

/// parallelFor() of elements of which one alone is too little for a task: calls body(i), `size` in
/// a row on one thread.
template <class Body>
void parallelForEach(int threads, std::size_t count, std::size_t size, const Body& body)
{
  parallelForStretches(threads, count, size, [&](std::size_t, std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i)
      body(i);
  });
}

}  // namespace limn
