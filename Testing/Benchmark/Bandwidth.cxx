// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bandwidth.h"

#include "Stopwatch.h"

#include "Rendering/Base/Executor.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <memory>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Bandwidth.cxx"
#include <hwy/aligned_allocator.h>
#include <hwy/cache_control.h>
#include <hwy/foreach_target.h>

#include "Bandwidth-inl.h"

#if HWY_ONCE
namespace bandwidth
{
HWY_EXPORT(ReadKernel);
HWY_EXPORT(WriteKernel);

namespace
{
constexpr std::size_t kWordsPerChunk = 16 * 1024; // 128 KiB

/// Calls work(first word, count) for the chunks of a buffer, on all threads, for a while.
template <class Work>
double BestOf(std::size_t bytes, int threads, Work work)
{
  constexpr double kMilliseconds = 40;
  constexpr int kFewestPasses = 3;
  const std::size_t chunks = bytes / (kWordsPerChunk * sizeof(std::uint64_t)) + 1;
  const std::size_t words = chunks * kWordsPerChunk;
  const auto buffer = hwy::AllocateAligned<std::uint64_t>(words);
  const auto overChunks = [&](const auto& visit)
  {
    limn::parallelFor(threads, chunks,
      [&](std::size_t chunk) { visit(buffer.get() + chunk * kWordsPerChunk, kWordsPerChunk); });
  };
  overChunks([](std::uint64_t* first, std::size_t count) { std::fill_n(first, count, 1); });
  double best = 0;
  const Stopwatch all;
  for (int pass = 0; pass < kFewestPasses || all.Milliseconds() < kMilliseconds; ++pass)
  {
    const Stopwatch one;
    overChunks(work);
    best = std::max(best, words * sizeof(std::uint64_t) / one.Milliseconds());
  }
  return best;
}
}
}

double Bandwidth::OfReading(std::size_t bytes, int threads)
{
  std::atomic<std::uint64_t> sum = 0;
  const double best = bandwidth::BestOf(bytes, threads,
    [&sum](const std::uint64_t* first, std::size_t count)
    {
      using namespace bandwidth;
      sum += HWY_DYNAMIC_DISPATCH(ReadKernel)(first, count);
    });
  return best;
}

double Bandwidth::OfWriting(std::size_t bytes, int threads)
{
  return bandwidth::BestOf(bytes, threads,
    [](std::uint64_t* first, std::size_t count)
    {
      using namespace bandwidth;
      HWY_DYNAMIC_DISPATCH(WriteKernel)(first, count);
    });
}
#endif // HWY_ONCE
