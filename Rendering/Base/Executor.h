// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace limn {

/// Threads to use when the caller asks for `requested`: all that the process may use for 0.
int resolveThreadCount(int requested);

/// Calls body(i) once for each i in [0, count), on at most `threads` threads at once (0: all), in
/// any order, and returns when all are done. Each thread runs in the float mode of
/// Base/FloatMode.h. Nested calls are allowed. Built on oneTBB, which VTK uses too, so the two
/// share one set of threads.
void parallelFor(int threads, std::size_t count, const std::function<void(std::size_t)>& body);

}  // namespace limn
