// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Program.h"

#include <gtest/gtest.h>

#include <regex>

namespace limn::testing
{
namespace
{

/// The text behind a label at the start of a line; "" if there is no such line.
std::string valueOf(const std::string& label, const std::string& text)
{
  std::smatch match;
  const std::regex line("(^|\n)  " + label + " +([^\n]*)");
  return std::regex_search(text, match, line) ? match[2].str() : "";
}

TEST(Info, CubeHasEightPointsAndSixPolygons)
{
  const Outcome outcome = runLimn({ "info", meshFile("cube.obj") });
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(valueOf("format", outcome.out), "OBJ");
  EXPECT_EQ(valueOf("points", outcome.out), "8");
  EXPECT_EQ(valueOf("polygons", outcome.out), "6");
  EXPECT_EQ(valueOf("triangles", outcome.out), "12");
}

TEST(Info, TellsBoundsAttributesAndArrays)
{
  const Folder folder;
  const std::string file =
    folder.write("square.vtk", "# vtk DataFile Version 3.0\nsquare\nASCII\n"
                               "DATASET POLYDATA\nPOINTS 4 float\n"
                               "0 0 0 2 0 0 2 1 0 0 1 0\nPOLYGONS 1 5\n4 0 1 2 3\n"
                               "POINT_DATA 4\nSCALARS height float 1\n"
                               "LOOKUP_TABLE default\n-1 0 2 5\n"
                               "NORMALS up float\n0 0 1 0 0 1 0 0 1 0 0 1\n"
                               "CELL_DATA 1\nVECTORS wind float\n3 4 0\n");
  const Outcome outcome = runLimn({ "info", file });
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(valueOf("format", outcome.out), "VTK");
  EXPECT_EQ(valueOf("bounds", outcome.out), "x from 0 to 2");
  EXPECT_EQ(valueOf("triangles", outcome.out), "2");
  EXPECT_EQ(valueOf("normals", outcome.out), "per point (up)");
  EXPECT_EQ(valueOf("texture coordinates", outcome.out), "none");
  EXPECT_EQ(valueOf("colours", outcome.out), "none");
  EXPECT_NE(outcome.out.find("height: float, 1 component, -1 to 5"), std::string::npos);
  EXPECT_NE(outcome.out.find("wind: float, 3 components, length 5 to 5"), std::string::npos);
}

TEST(Info, CountsFacesThatAreNotManifoldOrDropped)
{
  const Folder folder;
  const std::string file = folder.write("fins.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\n"
                                                    "f 1 2 3\nf 1 2 4\nf 1 2 5\nf 1 1 2\n");
  const Outcome outcome = runLimn({ "info", file });
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(valueOf("polygons", outcome.out), "3");
  EXPECT_EQ(valueOf("non-manifold faces", outcome.out), "2");
  EXPECT_EQ(valueOf("dropped faces", outcome.out), "1");
  EXPECT_NE(outcome.err.find("limn: warning: "), std::string::npos) << outcome.err;
}

TEST(Info, TellsOfEachFile)
{
  const Outcome outcome = runLimn({ "info", meshFile("cube.obj"), meshFile("sphere.ply") });
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("cube.obj\n"), std::string::npos);
  EXPECT_NE(outcome.out.find("sphere.ply\n"), std::string::npos);
}

TEST(Info, AFileThatIsNotThereIsAnError)
{
  const Outcome outcome = runLimn({ "info", "none.obj" });
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.err, "limn: error: cannot read none.obj: No such file or directory\n");
}

} // namespace
} // namespace limn::testing
