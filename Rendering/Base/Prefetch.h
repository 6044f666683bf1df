// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hwy/cache_control.h>

namespace limn {

/// Begins to read what will be asked for soon.
template <class T>
inline void prefetch(const T* place)
{
  hwy::Prefetch(place);
  // GCC takes a function that does nothing else to be one without effect, and drops calls of it.
#if defined(__GNUC__)
  asm volatile("");
#endif
}

}  // namespace limn
