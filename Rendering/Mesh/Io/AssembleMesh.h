// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Mesh/Io/NormalForm.h"
#include "Rendering/Mesh/Io/RawMesh.h"

namespace limn::meshio {

/// Splits vertices whose corners disagree, decides between float and double coordinates, and counts
/// what MeshFile counts. Throws Fault if there are more vertices then than 32 bits can number.
MeshFile assembleMesh(const Source& source, NormalForm form, RawMesh raw);

}  // namespace limn::meshio
