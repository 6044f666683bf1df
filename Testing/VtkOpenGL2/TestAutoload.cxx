// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Programs that know nothing of Limn, run with and without VTK_AUTOLOAD_PATH.
#include "Picture.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <string>

namespace
{
const std::string Autoload = "VTK_AUTOLOAD_PATH=" LIMN_AUTOLOAD_DIR " ";

struct Outcome
{
  int Status = -1;
  std::string Output;
  Picture Shown;
};

Picture ReadPng(const std::string& path)
{
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  Picture picture;
  picture.Width = image->GetDimensions()[0];
  picture.Height = image->GetDimensions()[1];
  const auto* rgb = static_cast<const unsigned char*>(image->GetScalarPointer());
  for (size_t pixel = 0; pixel < size_t(picture.Width) * picture.Height; ++pixel)
  {
    picture.Bytes.insert(picture.Bytes.end(), rgb + 3 * pixel, rgb + 3 * pixel + 3);
    picture.Bytes.push_back(255);
  }
  return picture;
}

/// Runs a program with settings of its environment ("-u DISPLAY A=b "), which takes the name of the
/// PNG file to write as its last argument.
Outcome RunProgram(const std::string& environment, const std::string& program)
{
  const std::string png = testing::TempDir() + "limn_autoload.png";
  std::remove(png.c_str());
  const std::string command = "env " + environment + program + " " + png + " 2>&1";
  Outcome outcome;
  FILE* pipe = popen(command.c_str(), "r");
  std::array<char, 256> line;
  while (pipe && std::fgets(line.data(), int(line.size()), pipe))
  {
    outcome.Output += line.data();
  }
  outcome.Status = pclose(pipe);
  outcome.Shown = ReadPng(png);
  return outcome;
}

bool Says(const Outcome& outcome, const std::string& line)
{
  return outcome.Output.find(line + "\n") != std::string::npos;
}

/// What TestLimnInGLWindow finds for scenes, as a bound for these programs: rounding with one
/// sample per pixel, and a few levels on edges (more where surfaces cross) with several.
void ExpectAlike(const Outcome& expected, const Outcome& outcome, int multiSamples)
{
  const int pixels = expected.Shown.Width * expected.Shown.Height;
  EXPECT_GT(pixels, 0);
  if (multiSamples == 0)
  {
    EXPECT_EQ(CountDifferent(expected.Shown, outcome.Shown, 1), 0);
  }
  else
  {
    EXPECT_LT(CountDifferent(expected.Shown, outcome.Shown, 3), 0.003 * pixels);
  }
}
} // namespace

class PlainProgramTest : public testing::TestWithParam<int>
{
protected:
  std::string Cone = std::string(LIMN_PLAIN_CONE) + " " + std::to_string(GetParam());
};

TEST_P(PlainProgramTest, IsDrawnByLimnInAnOpenGLWindow)
{
  const Outcome vtk = RunProgram("", this->Cone);
  ASSERT_EQ(vtk.Status, 0) << vtk.Output;
  EXPECT_TRUE(Says(vtk, "mapper=vtkOpenGLPolyDataMapper")) << vtk.Output;
  const Outcome limn = RunProgram(Autoload, this->Cone);
  ASSERT_EQ(limn.Status, 0) << limn.Output;
  EXPECT_TRUE(Says(limn, "mapper=vtkLimnPolyDataMapper")) << limn.Output;
  EXPECT_TRUE(Says(limn, "actor=vtkLimnOpenGLActor")) << limn.Output;
  EXPECT_TRUE(Says(limn, "property=vtkLimnProperty")) << limn.Output;
  EXPECT_TRUE(Says(limn, "window=vtkXOpenGLRenderWindow")) << limn.Output;
  ExpectAlike(vtk, limn, GetParam());
}

TEST_P(PlainProgramTest, IsLeftAloneWhenLimnIsDisabled)
{
  const Outcome vtk = RunProgram("", this->Cone);
  const Outcome disabled = RunProgram(Autoload + "LIMN_DISABLE=1 ", this->Cone);
  EXPECT_EQ(disabled.Status, 0);
  EXPECT_EQ(vtk.Output, disabled.Output);
  EXPECT_EQ(CountDifferent(vtk.Shown, disabled.Shown), 0);
}

TEST_P(PlainProgramTest, NeedsNoDisplayInAWindowOfLimns)
{
  const Outcome vtk = RunProgram("", this->Cone);
  const Outcome limn = RunProgram("-u DISPLAY " + Autoload + "LIMN_WINDOW=cpu ", this->Cone);
  ASSERT_EQ(limn.Status, 0) << limn.Output;
  EXPECT_TRUE(Says(limn, "window=vtkLimnRenderWindow")) << limn.Output;
  ExpectAlike(vtk, limn, GetParam());
}
INSTANTIATE_TEST_SUITE_P(MultiSamples, PlainProgramTest, testing::Values(0, 4));

// A program that does not bring OpenGL does not get it from us.
TEST(Autoload, BringsNoGraphicsLibrary)
{
  const Outcome limn =
    RunProgram("-u DISPLAY " + Autoload + "LIMN_WINDOW=cpu ", LIMN_HEADLESS_CONE " 4");
  ASSERT_EQ(limn.Status, 0) << limn.Output;
  EXPECT_TRUE(Says(limn, "window=vtkLimnRenderWindow")) << limn.Output;
  EXPECT_TRUE(Says(limn, "graphics libraries=no")) << limn.Output;
}

// VTK's example with nothing changed but class names, in a window on the (virtual) screen.
TEST_P(PlainProgramTest, TakesLimnsClassesByName)
{
  const std::string samples = " " + std::to_string(GetParam());
  const Outcome vtk = RunProgram("", LIMN_CONE_AND_SPHERE + samples);
  const Outcome limn = RunProgram("", LIMN_CONE_AND_SPHERE_BY_NAME + samples);
  ASSERT_EQ(limn.Status, 0) << limn.Output;
  EXPECT_TRUE(Says(vtk, "mapper=vtkOpenGLPolyDataMapper")) << vtk.Output;
  EXPECT_TRUE(Says(limn, "mapper=vtkLimnPolyDataMapper")) << limn.Output;
  ExpectAlike(vtk, limn, GetParam());
}
