// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Executor.h on plain threads, for builds with the thread sanitizer: it does not see how oneTBB's
// library, which is not instrumented, keeps its threads apart, and reports each task as a race.
#include "Rendering/Base/Executor.h"

#include "Rendering/Base/FloatMode.h"

#include <algorithm>
#include <atomic>
#include <thread>

namespace limn {

int resolveThreadCount(int requested)
{
  return requested > 0 ? requested : static_cast<int>(std::thread::hardware_concurrency());
}

void parallelFor(int threads, std::size_t count, const std::function<void(std::size_t)>& body)
{
  const FloatMode callerMode;
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    const FloatMode workerMode;
    for (std::size_t i = next++; i < count; i = next++)
      body(i);
  };
  const auto wanted = static_cast<std::size_t>(resolveThreadCount(threads));
  std::vector<std::thread> helpers;
  for (std::size_t t = 1; t < std::min(wanted, count); ++t)
    helpers.emplace_back(work);
  work();
  for (std::thread& helper : helpers)
    helper.join();
}

}  // namespace limn
