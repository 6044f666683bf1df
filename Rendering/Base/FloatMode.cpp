// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Base/FloatMode.h"

#if defined(__x86_64__)
#include <xmmintrin.h>
#elif !defined(__aarch64__)
#error "Limn's same-bytes contract is proven on x86-64 and AArch64 only."
#endif

namespace limn {
namespace {

#if defined(__x86_64__)
// Exceptions masked, nearest-even, no flush-to-zero, no denormals-are-zero: the reset value.
constexpr std::uint64_t kMode = 0x1F80;
std::uint64_t readMode()
{
  return _mm_getcsr();
}
void writeMode(std::uint64_t mode)
{
  _mm_setcsr(static_cast<unsigned>(mode));
}
#else
constexpr std::uint64_t kMode = 0;
std::uint64_t readMode()
{
  std::uint64_t mode;
  asm volatile("mrs %0, fpcr" : "=r"(mode));
  return mode;
}
void writeMode(std::uint64_t mode)
{
  asm volatile("msr fpcr, %0" : : "r"(mode));
}
#endif

}  // namespace

FloatMode::FloatMode() : saved_(readMode())
{
  writeMode(kMode);
}
FloatMode::~FloatMode()
{
  writeMode(saved_);
}

}  // namespace limn
