// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Base/Executor.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cfenv>
#include <memory>
#include <mutex>
#include <set>
#include <thread>

namespace limn {
namespace {

bool roundsToNearest()
{
  volatile float one = 1.0f, tiny = 1e-30f;
  return one + tiny == 1.0f;
}

TEST(ParallelFor, VisitsEachIndexOnce)
{
  for (const int threads : {0, 1, 2, 8})
    for (const std::size_t count : {0u, 1u, 2u, 7u, 10000u}) {
      const auto visits = std::make_unique<std::atomic<int>[]>(count + 1);
      parallelFor(threads, count, [&](std::size_t i) { ++visits[i]; });
      for (std::size_t i = 0; i < count; ++i)
        ASSERT_EQ(visits[i], 1) << i << " of " << count << ", " << threads << " threads";
      EXPECT_EQ(visits[count], 0);
    }
}

TEST(ParallelFor, MayBeNested)
{
  std::atomic<int> visits{0};
  parallelFor(4, 20, [&](std::size_t) { parallelFor(4, 30, [&](std::size_t) { ++visits; }); });
  EXPECT_EQ(visits, 600);
}

TEST(ParallelFor, OneThreadIsTheCallersOwn)
{
  std::set<std::thread::id> threads;
  parallelFor(1, 100, [&](std::size_t) { threads.insert(std::this_thread::get_id()); });
  EXPECT_EQ(threads, std::set<std::thread::id>{std::this_thread::get_id()});
}

TEST(ParallelFor, UsesNoMoreThreadsThanAsked)
{
  std::mutex mutex;
  std::set<std::thread::id> threads;
  parallelFor(2, 500, [&](std::size_t) {
    const std::lock_guard<std::mutex> lock(mutex);
    threads.insert(std::this_thread::get_id());
  });
  EXPECT_LE(threads.size(), 2u);
}

TEST(ParallelFor, EveryThreadRoundsToNearestAndTheCallersModeComesBack)
{
  std::fesetround(FE_UPWARD);
  std::atomic<int> others{0};
  for (const int threads : {1, 2, 8})
    parallelFor(threads, 200, [&](std::size_t) { others += !roundsToNearest(); });
  const bool after = roundsToNearest();
  std::fesetround(FE_TONEAREST);
  EXPECT_EQ(others, 0);
  EXPECT_FALSE(after);
}

TEST(ThreadCount, ZeroMeansAll)
{
  EXPECT_EQ(resolveThreadCount(3), 3);
  EXPECT_GE(resolveThreadCount(0), 1);
}

}  // namespace
}  // namespace limn
