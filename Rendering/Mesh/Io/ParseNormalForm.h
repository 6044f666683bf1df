// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Mesh/Io/NormalForm.h"
#include "Rendering/Mesh/Io/RawMesh.h"

namespace limn::meshio {

/// Runs OpenMesh's parser over the normal form, silently; one parser at a time in the process, for
/// they keep their state in global objects. Throws Fault if the mesh is inconsistent in a way that
/// the check of its format cannot see, or if the user cancels.
RawMesh parseNormalForm(Source& source, const NormalForm& form);

}  // namespace limn::meshio
