// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Rendering/Mesh/EdgeTable.h"

#include <gtest/gtest.h>

namespace limn::testing {

/// A mesh with its edges and normals, of which lines are found.
struct EdgedMesh {
  MeshView mesh;
  EdgeTable table;
  FeatureArrays arrays;

  EdgedMesh(const MeshView& view, Span<const Vec3f> normals) : mesh(view)
  {
    EXPECT_TRUE(buildEdgeTable(mesh, 0, 2, table).ok());
    arrays.vertexNormals = normals;
  }
};

}  // namespace limn::testing
