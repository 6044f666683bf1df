// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Bandwidth_h
#define Bandwidth_h

#include <cstddef>

/// Bytes per millisecond that all of `threads` threads together get through a buffer of this size
/// that they go over again and again: the best of some passes. A small buffer lies in the caches,
/// as the mesh of that size would.
struct Bandwidth
{
  static double OfReading(std::size_t bytes, int threads);
  /// By stores that go past the caches.
  static double OfWriting(std::size_t bytes, int threads);
};

#endif
