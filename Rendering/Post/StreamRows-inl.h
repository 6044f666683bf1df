// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Compiled once per instruction set by TileFrame.cpp.
#include "Rendering/Base/Simd.h"

#include <hwy/cache_control.h>

#include <cstdint>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace limn::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Whole cache lines go past the caches: a part of one would have to be read first.
void streamRow(const std::uint8_t* from, std::uint8_t* to, std::size_t bytes)
{
  const hn::ScalableTag<std::uint8_t> d;
  constexpr std::size_t kLine = 64;
  const std::size_t toLine = (kLine - reinterpret_cast<std::uintptr_t>(to) % kLine) % kLine;
  std::size_t i = toLine < bytes ? toLine : bytes;
  if (i > 0) std::memcpy(to, from, i);
  for (; i + kLine <= bytes; i += kLine)
    for (std::size_t part = 0; part < kLine; part += hn::Lanes(d))
      hn::Stream(hn::LoadU(d, from + i + part), d, to + i + part);
  if (i < bytes) std::memcpy(to + i, from + i, bytes - i);
}

void streamRowsKernel(const StreamedRows& rows)
{
  const auto* from = static_cast<const std::uint8_t*>(rows.from);
  auto* to = static_cast<std::uint8_t*>(rows.to);
  for (int y = 0; y < rows.count; ++y, from += rows.fromStride, to += rows.toStride)
    if (hn::MaxLanes(hn::ScalableTag<std::uint8_t>()) == 1)
      std::memcpy(to, from, rows.bytes);
    else
      streamRow(from, to, rows.bytes);
  // What was streamed is seen by other threads in no certain order else.
  hwy::FlushStream();
}

}  // namespace limn::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
