// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Base/Prefetch.h"
#include "Rendering/Mesh/MeshView.h"

#include <cstddef>

namespace limn {

/// Begins to read where a vertex lies.
inline void fetchPosition(const MeshView& mesh, std::size_t vertex)
{
  if (mesh.positions.empty())
    prefetch(mesh.precisePositions.data() + vertex);
  else
    prefetch(mesh.positions.data() + vertex);
}

}  // namespace limn
