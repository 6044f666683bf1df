// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Program.h"

#include <gtest/gtest.h>

namespace limn::testing
{
namespace
{

using Words = std::vector<std::string>;

const char* const kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

std::string xmlTriangle(const std::string& lastPoint, const std::string& connectivity)
{
  return R"(<?xml version="1.0"?>
<VTKFile type="PolyData" version="0.1" byte_order="LittleEndian"><PolyData>
<Piece NumberOfPoints="3" NumberOfVerts="0" NumberOfLines="0" NumberOfStrips="0" NumberOfPolys="1">
<Points><DataArray type="Float32" NumberOfComponents="3" format="ascii">0 0 0 1 0 0 )" +
         lastPoint + R"(</DataArray></Points>
<Polys><DataArray type="Int32" Name="connectivity" format="ascii">)" +
         connectivity + R"(</DataArray>
<DataArray type="Int32" Name="offsets" format="ascii">3</DataArray></Polys>
</Piece></PolyData></VTKFile>
)";
}

std::string xmlTetrahedron(const std::string& connectivity, const std::string& type = "10")
{
  return R"(<?xml version="1.0"?>
<VTKFile type="UnstructuredGrid" version="0.1" byte_order="LittleEndian"><UnstructuredGrid>
<Piece NumberOfPoints="4" NumberOfCells="1">
<Points><DataArray type="Float32" NumberOfComponents="3" format="ascii">
0 0 0 1 0 0 0 1 0 0 0 1</DataArray></Points>
<Cells><DataArray type="Int32" Name="connectivity" format="ascii">)" +
         connectivity + R"(</DataArray>
<DataArray type="Int32" Name="offsets" format="ascii">4</DataArray>
<DataArray type="UInt8" Name="types" format="ascii">)" +
         type + R"(</DataArray></Cells>
</Piece></UnstructuredGrid></VTKFile>
)";
}

/// Every error has exit status 2, says so on one line that begins as promised, names the thing, and
/// leaves no file behind.
class RenderErrors : public ::testing::Test
{
protected:
  void expectError(const std::string& mesh, const Words& named, const Words& options = {})
  {
    Words arguments = { "render", mesh, "--output=" + folder_.file("out.png") };
    arguments.insert(arguments.end(), options.begin(), options.end());
    expectErrorOf(arguments, named);
  }

  void expectErrorOf(const Words& arguments, const Words& named)
  {
    const Words before = folder_.names();
    const Outcome outcome = runLimn(arguments);
    EXPECT_EQ(outcome.status, 2) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_NE(outcome.err.find("limn: error: "), std::string::npos) << outcome.err;
    EXPECT_EQ(lastLineStart(outcome.err), "limn: error: ") << outcome.err;
    for (const std::string& word : named)
    {
      EXPECT_NE(outcome.err.find(word), std::string::npos) << word << " in " << outcome.err;
    }
    EXPECT_EQ(folder_.names(), before);
  }

  static std::string lastLineStart(const std::string& text)
  {
    const std::size_t end = text.find_last_not_of('\n');
    const std::size_t newline = text.rfind('\n', end);
    const std::size_t start = newline == std::string::npos ? 0 : newline + 1;
    return text.substr(start, std::string("limn: error: ").size());
  }

  std::string triangle() const { return folder_.write("triangle.obj", kTriangle); }

  Folder folder_;
};

TEST_F(RenderErrors, CommandLine)
{
  expectErrorOf({}, { "no verb" });
  expectErrorOf({ "draw" }, { "unknown verb draw" });
  const std::string mesh = triangle();
  expectError(mesh, { "unknown option --foo", "limn help render" }, { "--foo" });
  expectError(mesh, { "--line-width is not served by this version" }, { "--line-width=3" });
  expectError(mesh, { "no texture coordinates", "--procedural" }, { "--texture=a.png" });
  expectError(mesh, { "--opacity=1.5", "from 0 to 1" }, { "--opacity=1.5" });
  expectError(mesh, { "--shading=fong", "flat, gouraud, phong" }, { "--shading=fong" });
  expectError(mesh, { "--light=point:0,0,nan:1,1,1" }, { "--light=point:0,0,nan:1,1,1" });
  expectError(mesh, { "--resolution=0,0" }, { "--resolution=0,0" });
}

TEST_F(RenderErrors, MissingFile)
{
  expectError(folder_.file("none.obj"), { "none.obj", "No such file" });
}

TEST_F(RenderErrors, DirectoryInPlaceOfAMesh)
{
  const std::string path = folder_.file("sub.obj");
  std::filesystem::create_directory(path);
  expectError(path, { "sub.obj", "is a directory" });
}

TEST_F(RenderErrors, UnknownFormat)
{
  expectError(folder_.write("mesh.xyz", kTriangle), { "mesh.xyz", "unknown mesh format", ".obj" });
  expectError(folder_.write("mesh", kTriangle), { "mesh", "unknown mesh format" });
}

TEST_F(RenderErrors, EmptyFile)
{
  expectError(folder_.write("empty.obj", ""), { "empty.obj is empty" });
  expectError(folder_.write("empty.vtp", ""), { "empty.vtp is empty" });
}

TEST_F(RenderErrors, FileWithoutFaces)
{
  expectError(folder_.write("points.obj", "v 0 0 0\nv 1 0 0\n"), { "points.obj" });
  expectError(
    folder_.write("points.vtk", "# vtk DataFile Version 3.0\npoints\nASCII\nDATASET POLYDATA\n"
                                "POINTS 1 float\n0 0 0\nVERTICES 1 2\n1 0\n"),
    { "points.vtk", "no faces" });
}

TEST_F(RenderErrors, FacesWithoutAnAreaAreOfAFile)
{
  const std::string flat = folder_.write("flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n");
  const std::string good = folder_.write("good.obj", kTriangle);
  const Outcome outcome = runLimn({ "render", good, flat, "--output=" + folder_.file("out.png") });
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("limn: warning: " + flat +
                             ": Nothing of the input is drawn. None of "
                             "its faces has an area"),
    std::string::npos)
    << outcome.err;
  EXPECT_EQ(outcome.err.find(good + ":"), std::string::npos) << outcome.err;
}

TEST_F(RenderErrors, MalformedFiles)
{
  const std::string noise = "not a mesh at all\n";
  for (const std::string extension : { "obj", "off", "ply", "stl", "om", "vtk", "vtp", "vtu" })
  {
    const std::string name = "noise." + extension;
    expectError(folder_.write(name, noise), { name });
  }
}

TEST_F(RenderErrors, PointsThatAreNotFinite)
{
  expectError(folder_.write("nan.obj", "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n"), { "nan.obj" });
  expectError(
    folder_.write("nan.vtp", xmlTriangle("0 nan 0", "0 1 2")), { "nan.vtp", "point 2", "NaN" });
}

TEST_F(RenderErrors, CellsWhosePointsDoNotExist)
{
  expectError(folder_.write("range.vtp", xmlTriangle("0 1 0", "0 1 7")),
    { "range.vtp", "point 7", "3 points" });
  expectError(folder_.write("range.vtu", xmlTetrahedron("0 1 2 99")),
    { "range.vtu", "point 99", "4 points" });
  expectError(folder_.write("type.vtu", xmlTetrahedron("0 1 2 3", "12")),
    { "type.vtu", "cell 0 of type 12", "fewer than 8 points" });
  expectError(folder_.write("unknown.vtu", xmlTetrahedron("0 1 2 3", "99")),
    { "unknown.vtu", "no cell type 99" });
  expectError(
    folder_.write("range.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 9\n"), { "range.off" });
}

TEST_F(RenderErrors, ArrayThatTheMeshLacks)
{
  expectError(triangle(), { "--coloring-array=height", "triangle.obj", "no such array" },
    { "--coloring-array=height" });
}

TEST_F(RenderErrors, CellDataForLinesThatNoMeshHas)
{
  expectError(triangle(), { "--ids-array=part", "no mesh has such cell data" },
    { "--lines=ids", "--ids-array=part" });
  expectError(triangle(), { "--lines=ids", "--ids-array" }, { "--lines=ids" });
  expectError(
    triangle(), { "--outline-ids", "--ids-array" }, { "--outline=image", "--outline-ids" });
}

TEST_F(RenderErrors, OneBadMeshAmongGoodOnes)
{
  expectError(triangle(), { "none.obj" }, { folder_.file("none.obj") });
}

TEST_F(RenderErrors, OutputThatCannotBe)
{
  const std::string mesh = triangle();
  expectErrorOf({ "render", mesh, "--output=" + folder_.file("x.jpg") }, { "x.jpg", "x.png" });
  expectErrorOf(
    { "render", mesh, "--output=" + folder_.file("no/x.png") }, { "x.png", "no folder" });
  std::filesystem::create_directory(folder_.file("folder.png"));
  expectErrorOf({ "render", mesh, "--output=" + folder_.file("folder.png") },
    { "folder.png", "is a directory" });
  // Nobody, not even root, can make a file here.
  expectErrorOf(
    { "render", mesh, "--output=/proc/self/x.png" }, { "/proc/self/x.png", "cannot write" });
}

TEST_F(RenderErrors, ADiskThatIsFullKeepsTheOlderPictureAndLeavesNoPart)
{
  const std::string mesh = triangle();
  const std::string output = folder_.write("out.png", "older picture");
  const Words before = folder_.names();
  const Outcome outcome = runLimnWithFileLimit({ "render", mesh, "--output=" + output }, 1000);
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.err, "limn: error: cannot write " + output + ": File too large\n");
  EXPECT_EQ(bytesOf(output), "older picture");
  EXPECT_EQ(folder_.names(), before);
}

TEST_F(RenderErrors, WindowThatNeedsADisplay)
{
  expectError(triangle(), { "display", "--window=cpu" }, { "--window=gl" });
  expectErrorOf({ "view", triangle() }, { "display" });
}

TEST_F(RenderErrors, DisplayThatIsNotThere)
{
  const Outcome outcome =
    runLimn({ "render", triangle(), "--window=gl", "--output=" + folder_.file("out.png") },
      { { "DISPLAY", ":4711" } });
  EXPECT_EQ(outcome.status, 2) << outcome.err;
  EXPECT_NE(outcome.err.find("limn: error: "), std::string::npos) << outcome.err;
}

TEST_F(RenderErrors, AnErrorKeepsTheOlderPicture)
{
  const std::string output = folder_.write("out.png", "older picture");
  const Outcome outcome = runLimn({ "render", folder_.file("none.obj"), "--output=" + output });
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(bytesOf(output), "older picture");
}

} // namespace
} // namespace limn::testing
