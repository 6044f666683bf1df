// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef limn_viewer_InfoCommand_h
#define limn_viewer_InfoCommand_h

#include "UserError.h" // for ExitStatus

#include <string> // for file names
#include <vector> // for several meshes

namespace limn::viewer
{

/// Prints for each mesh its format, counts, bounds, normals, colours, texture coordinates and
/// arrays with their ranges. Throws UserError for a file that loadMesh() refuses.
ExitStatus info(const std::vector<std::string>& meshes);

} // namespace limn::viewer

#endif
