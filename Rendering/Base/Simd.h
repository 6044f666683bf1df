// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The one way in to Highway. Include after foreach_target.h, outside of any include guard's reach.
//
// Kernels must give the same bits for every instruction set, so they use only operations that IEEE
// 754 defines exactly: + - * / sqrt, comparisons, conversions of values known to be in range,
// integer arithmetic, shuffles. Never MulAdd and its kin (fused on some targets only),
// Approximate*, Min/Max (NaN and zero signs differ), or sums across lanes of floats.
#include <hwy/highway.h>
