// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Vec.h"

namespace limn {

/// Luma as VTK's FXAA has it (Rec. 601).
inline constexpr Vec3f kLumaShares = {0.299f, 0.587f, 0.114f};

/// A row of luma and its neighbours. Rows go on beyond their ends.
struct LumaRows {
  const float* below;
  const float* here;
  const float* above;
};

}  // namespace limn
