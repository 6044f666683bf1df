// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause

// The reader's output, errors, warnings, progress and abort. Opens no window.

#include "vtkLimnMeshReader.h"

#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>

#include <unistd.h>

namespace
{

int Failures = 0;

void Check(bool condition, const char* what)
{
  if (!condition)
  {
    std::cerr << "FAILED: " << what << std::endl;
    ++Failures;
  }
}

/// What a reader says.
struct Messages
{
  explicit Messages(vtkObject* object)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback(&Messages::Note);
    object->AddObserver(vtkCommand::ErrorEvent, this->Command);
    object->AddObserver(vtkCommand::WarningEvent, this->Command);
  }
  static void Note(vtkObject*, unsigned long event, void* self, void* text)
  {
    Messages* const messages = static_cast<Messages*>(self);
    (event == vtkCommand::ErrorEvent ? messages->Errors : messages->Warnings) +=
      static_cast<const char*>(text);
  }

  vtkNew<vtkCallbackCommand> Command;
  std::string Errors;
  std::string Warnings;
};

std::string Write(const std::filesystem::path& path, const std::string& content)
{
  std::ofstream(path, std::ios::binary) << content;
  return path.string();
}

void TestOutput(const std::filesystem::path& folder)
{
  const std::string path = Write(folder / "square.obj",
    "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 1 1 0 0 0 1\nv 0 1 0 1 1 1\nvt 0 0\nvt 1 0.5\nvn 0 0 1\n"
    "f 1/1/1 2/2/1 3/2/1 4/1/1\nf 1/1/1 2/2/1 3/2/1\nf 1 1 2\n");
  Check(vtkLimnMeshReader::CanReadFile(path.c_str()) == 1, "OBJ can be read");
  vtkNew<vtkLimnMeshReader> reader;
  Messages messages(reader);
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkPolyData* const output = reader->GetOutput();
  Check(output->GetNumberOfPoints() == 4, "4 points");
  Check(output->GetPoints()->GetDataType() == VTK_FLOAT, "float points");
  Check(output->GetNumberOfPolys() == 2, "2 polygons");
  vtkNew<vtkIdList> corners;
  output->GetCellPoints(0, corners);
  Check(corners->GetNumberOfIds() == 4 && corners->GetId(3) == 3, "the square stays a square");
  vtkDataArray* const normals = output->GetPointData()->GetNormals();
  Check(normals && normals->GetName() == std::string("Normals"), "active normals");
  Check(normals && normals->GetComponent(3, 2) == 1, "normal of the last point");
  vtkDataArray* const texCoords = output->GetPointData()->GetTCoords();
  Check(texCoords && texCoords->GetName() == std::string("TCoords"), "active TCoords");
  Check(texCoords && texCoords->GetNumberOfComponents() == 2, "two texture coordinates");
  Check(texCoords && texCoords->GetComponent(1, 1) == 0.5, "TCoords of point 1");
  auto* const colors = vtkUnsignedCharArray::SafeDownCast(output->GetPointData()->GetScalars());
  Check(colors && colors->GetName() == std::string("Colors"), "active colours");
  Check(colors && colors->GetNumberOfComponents() == 4, "RGBA");
  Check(colors && colors->GetTypedComponent(2, 2) == 255, "colour of point 2");
  Check(messages.Errors.empty(), "no error");
  Check(messages.Warnings.find("1 face has fewer") != std::string::npos, "dropped face");
  Check(messages.Warnings.find("1 face is non-manifold") != std::string::npos, "repeated edge");
  Check(reader->GetNumberOfDroppedFaces() == 1, "1 dropped");
  Check(reader->GetNumberOfNonManifoldFaces() == 1, "1 non-manifold");
}

void TestCellColorsAndDouble(const std::filesystem::path& folder)
{
  vtkNew<vtkLimnMeshReader> reader;
  Messages messages(reader);
  reader->SetFileName(
    Write(folder / "far.off", "OFF\n3 1 0\n1e7 0 0\n10000000.001 0 0\n1e7 0.001 0\n3 0 1 2 9 8 7\n")
      .c_str());
  reader->Update();
  vtkPolyData* const output = reader->GetOutput();
  Check(output->GetPoints()->GetDataType() == VTK_DOUBLE, "double points");
  Check(output->GetPoint(1)[0] == 10000000.001, "double precision");
  auto* const colors = vtkUnsignedCharArray::SafeDownCast(output->GetCellData()->GetScalars());
  Check(colors && colors->GetTypedComponent(0, 2) == 7, "cell colours");
  Check(!output->GetPointData()->GetScalars(), "no point colours");
  Check((messages.Errors + messages.Warnings).empty(), "nothing to say");
}

void TestErrors(const std::filesystem::path& folder)
{
  struct Case
  {
    std::string File;
    unsigned long Code;
    const char* Message;
  };
  const Case cases[] = {
    { "", vtkErrorCode::NoFileNameError, "SetFileName" },
    { (folder / "gone.ply").string(), vtkErrorCode::FileNotFoundError, "no such file" },
    { Write(folder / "a.xyz", "1 2 3\n"), vtkErrorCode::UnrecognizedFileTypeError, "unknown" },
    { Write(folder / "bad.obj", "v 0 0 0\nf 1 2 3\n"), vtkErrorCode::FileFormatError,
      "bad.obj: line 2: a face names vertex 3" },
  };
  vtkNew<vtkLimnMeshReader> reader;
  Messages messages(reader);
  vtkNew<vtkCallbackCommand> silence;
  silence->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
  reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, silence);
  for (const Case& c : cases)
  {
    messages.Errors.clear();
    reader->SetFileName(c.File.c_str());
    reader->Update();
    Check(reader->GetErrorCode() == c.Code, c.Message);
    Check(messages.Errors.find(c.Message) != std::string::npos, c.Message);
    Check(reader->GetOutput()->GetNumberOfPoints() == 0, "empty output");
  }
  reader->SetFileName(Write(folder / "good.obj", "v 0 0 0\nf 1 1 1\n").c_str());
  reader->Update();
  Check(reader->GetErrorCode() == vtkErrorCode::NoError, "the error does not last");
  Check(vtkLimnMeshReader::CanReadFile(nullptr) == 0, "no name");
  Check(vtkLimnMeshReader::CanReadFile((folder / "gone.ply").string().c_str()) == 0, "no file");
  Check(vtkLimnMeshReader::CanReadFile((folder / "a.xyz").string().c_str()) == 0, "no format");
  Check(vtkLimnMeshReader::CanReadFile(folder.string().c_str()) == 0, "a folder");
}

void TestAbort(const std::filesystem::path& folder)
{
  std::string content;
  for (int i = 0; i < 5000; ++i)
  {
    content += "v 0 0 " + std::to_string(i) + "\n";
  }
  vtkNew<vtkLimnMeshReader> reader;
  Messages messages(reader);
  reader->SetFileName(Write(folder / "many.obj", content).c_str());
  vtkNew<vtkCallbackCommand> abort;
  int progressEvents = 0;
  abort->SetClientData(&progressEvents);
  abort->SetCallback(
    [](vtkObject* caller, unsigned long, void* count, void*)
    {
      auto* const algorithm = static_cast<vtkAlgorithm*>(caller);
      ++*static_cast<int*>(count);
      algorithm->SetAbortExecute(algorithm->GetProgress() > 0.3 ? 1 : 0);
    });
  const unsigned long observer = reader->AddObserver(vtkCommand::ProgressEvent, abort);
  reader->Update();
  Check(progressEvents > 10, "progress events");
  Check(progressEvents < 60, "the abort stops the reading");
  Check(messages.Errors.empty(), "an abort is no error");
  Check(messages.Warnings.empty(), "an abort needs no warning");
  Check(reader->GetOutput()->GetNumberOfPoints() == 0, "nothing of an aborted mesh");
  reader->RemoveObserver(observer);
  reader->Modified();
  reader->Update();
  Check(reader->GetOutput()->GetNumberOfPoints() == 5000, "the whole mesh afterwards");
  Check(messages.Warnings.find("no faces") != std::string::npos, "points only");
}

/// What of a mesh without an area is left is told once, not also that there were no faces.
void TestFacesThatAreDropped(const std::filesystem::path& folder)
{
  vtkNew<vtkLimnMeshReader> reader;
  Messages messages(reader);
  reader->SetFileName(Write(folder / "lines.obj", "v 0 0 0\nv 1 0 0\nf 1 2 1\nf 1 1 2\n").c_str());
  reader->Update();
  Check(reader->GetNumberOfDroppedFaces() == 2, "2 dropped");
  Check(messages.Warnings.find("no face has three different points") != std::string::npos,
    "why there are none");
  Check(messages.Warnings.find("left out") == std::string::npos &&
          messages.Warnings.find("points only and no faces") == std::string::npos,
    "no second warning");
}

} // namespace

int TestLimnMeshReader(int, char*[])
{
  const std::filesystem::path folder =
    std::filesystem::temp_directory_path() / ("limn-reader-" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  TestOutput(folder);
  TestCellColorsAndDouble(folder);
  TestErrors(folder);
  TestAbort(folder);
  TestFacesThatAreDropped(folder);
  std::filesystem::remove_all(folder);
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
