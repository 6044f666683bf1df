// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Mesh/Io/MeshFile.h"
#include "Rendering/Base/Status.h"

#include <functional>
#include <string>

namespace limn {

/// Reads a mesh file, recognised by its extension in either case: OBJ, OFF (ASCII), PLY (ASCII,
/// binary of both byte orders), STL (ASCII, binary) and OM.
///
/// OpenMesh's parsers do not check what they read, so each file is checked first and brought into
/// the form that they read faithfully. What that means for a user:
///  - OBJ: corners keep their own normals and texture coordinates; a corner without a normal in a
///    file that has some gets its polygon's. Kd of a material becomes the face's colour; a missing
///    .mtl file is no error. Lines, points, curves, groups and the w of coordinates are left out.
///  - OFF: one vertex or face a line; colour map indices are left out.
///  - PLY: elements other than vertex and face, and properties without a meaning for drawing, are
///    left out, among them the texture coordinates of a face's corners.
///  - STL: coordinates are float. A file has no connectivity, so vertices of equal coordinates
///    become one, which allows smooth normals. The facets' normals and attributes are left out.
///  - OM: custom properties and status bits are left out.
/// Colours become 8 bits a channel. A mesh without polygons (a point cloud) is no error.
///
/// `progress` gets the done part, 0 to 1, in rising order; false from it cancels.
/// Errors: kFile for a file that is missing, unreadable, empty, malformed, cancelled ("cancelled")
/// or too large for memory; kIndexOutOfRange; kNotFinite for NaN, infinity and numbers beyond
/// float. The message starts with the path, and tells line or byte where there is one. After an
/// error `out` is empty. Never prints. Calls from several threads wait for each other.
Status readMesh(const std::string& path, MeshFile& out,
                const std::function<bool(double fraction)>& progress = {});

/// Whether readMesh() knows the extension of this path. The file need not exist.
bool isMeshFileName(const std::string& path);

}  // namespace limn
