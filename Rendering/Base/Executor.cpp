// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Base/Executor.h"

#include "Rendering/Base/FloatMode.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <optional>

namespace limn {

int resolveThreadCount(int requested)
{
  return requested > 0 ? requested : tbb::this_task_arena::max_concurrency();
}

namespace {

/// Calls `work` with at most `threads` threads (0: all) for the oneTBB algorithms in it.
void withThreads(int threads, const std::function<void()>& work)
{
  // An arena may hold more threads than the machine has cores; oneTBB makes them only when the
  // process-wide limit allows it, which the tests with 8 threads on 2 cores need.
  const int hardware = tbb::this_task_arena::max_concurrency();
  // Threads come to an arena of their own late, each time.
  if (threads <= 0 || threads == hardware) {
    work();
    return;
  }
  std::optional<tbb::global_control> limit;
  if (threads > hardware)
    limit.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  tbb::task_arena arena(threads);
  arena.execute(work);
}

}  // namespace

void parallelFor(int threads, std::size_t count, const std::function<void(std::size_t)>& body)
{
  const FloatMode callerMode;
  if (resolveThreadCount(threads) == 1 || count <= 1) {
    for (std::size_t i = 0; i < count; ++i)
      body(i);
    return;
  }
  const auto loop = [&] {
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, count, 1),
        [&](const tbb::blocked_range<std::size_t>& range) {
          const FloatMode workerMode;
          for (std::size_t i = range.begin(); i != range.end(); ++i)
            body(i);
        },
        tbb::simple_partitioner());
  };
  // A thread that waits for others helps with this loop alone: were it to take up a caller's next
  // iteration, which may draw, it would use the memory of the frame that it is waiting for.
  withThreads(threads, [&] { tbb::this_task_arena::isolate(loop); });
}

}  // namespace limn
