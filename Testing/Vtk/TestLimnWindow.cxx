// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Viewports, layers, backgrounds, sizes, cameras and what can be asked of the window.
#include "Check.h"
#include "Messages.h"
#include "Picture.h"
#include "Stage.h"

#include "vtkLimnCamera.h"
#include "vtkLimnRenderWindowInteractor.h"

#include "vtkPNGReader.h"
#include "vtkPNGWriter.h"
#include "vtkImageData.h"
#include "vtkRendererCollection.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkSphereSource.h"
#include "vtkWindowToImageFilter.h"

#include <algorithm>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

namespace
{
const Pixel White = { 255, 255, 255 };

void checkBackground()
{
  Stage stage;
  stage.Renderer->RemoveAllViewProps();
  // 0.5 is 127.5 of 255, and rounds to nearest.
  stage.Renderer->SetBackground(0.5, 0.25, 1.0);
  Picture picture = render(stage.Window);
  CHECK_EQUAL(picture.At(0, 0), (Pixel{ 128, 64, 255 }));
  CHECK_EQUAL(picture.CountOtherThan({ 128, 64, 255 }), 0);

  stage.Renderer->GradientBackgroundOn();
  stage.Renderer->SetBackground(0, 0, 0);
  stage.Renderer->SetBackground2(0.8, 0.8, 0.8);
  picture = render(stage.Window);
  // 204 at the top edge; row y has its centre at y + 1/2 of 80 rows.
  for (int y = 0; y < 80; ++y)
  {
    const int expected = static_cast<int>(204 * (y + 0.5) / 80 + 0.5);
    CHECK_EQUAL(picture.At(50, y), (Pixel{ expected, expected, expected }));
  }
}

/// A clear is put off until pixels are asked for.
void checkClearIsSeen()
{
  Stage stage;
  stage.Renderer->SetBackground(0, 1, 0);
  render(stage.Window);
  stage.Renderer->SetBackground(0, 0, 1);
  stage.Renderer->Clear();
  const std::unique_ptr<unsigned char[]> rgb(stage.Window->GetPixelData(0, 0, 0, 0, 0));
  CHECK_EQUAL((Pixel{ rgb[0], rgb[1], rgb[2] }), (Pixel{ 0, 0, 255 }));
  stage.Renderer->SetBackground(1, 0, 0);
  stage.Renderer->Clear();
  float depth = 0;
  stage.Window->GetZbufferData(50, 40, 50, 40, &depth);
  CHECK_EQUAL(depth, 1.0f);
  // A window of another size does not remember.
  stage.Renderer->Clear();
  stage.Window->SetSize(30, 30);
  CHECK_EQUAL(render(stage.Window).At(0, 0), (Pixel{ 255, 0, 0 }));
}

void checkViewports()
{
  Stage stage;
  stage.LookFlat();
  stage.Mapper->SetInputData(twoSquares());
  stage.Renderer->SetViewport(0, 0, 0.5, 1);
  stage.Renderer->SetBackground(0, 0, 1);
  vtkNew<vtkLimnRenderer> right;
  right->SetViewport(0.5, 0, 1, 1);
  right->SetBackground(0, 1, 0);
  right->AddActor(stage.Actor);
  right->SetActiveCamera(stage.Renderer->GetActiveCamera());
  stage.Window->AddRenderer(right);
  const Picture picture = render(stage.Window);
  CHECK_EQUAL(picture.At(0, 79), (Pixel{ 0, 0, 255 }));
  CHECK_EQUAL(picture.At(49, 79), (Pixel{ 0, 0, 255 }));
  CHECK_EQUAL(picture.At(50, 79), (Pixel{ 0, 255, 0 }));
  int equal = 0;
  int white = 0;
  for (int y = 0; y < 80; ++y)
  {
    for (int x = 0; x < 50; ++x)
    {
      const bool isLeft = picture.At(x, y) == White;
      white += isLeft;
      equal += isLeft == (picture.At(x + 50, y) == White);
    }
  }
  CHECK_EQUAL(equal, 50 * 80);
  CHECK(white > 300);
}

void checkLayers()
{
  Stage stage;
  stage.LookFlat();
  stage.Mapper->SetInputData(twoSquares());
  vtkNew<vtkLimnRenderer> above;
  above->SetLayer(1);
  above->SetBackground(1, 0, 0);
  vtkNew<vtkLimnActor> actor;
  actor->SetMapper(stage.Mapper);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetColor(0, 1, 0);
  // Behind the first layer's actor, were they in one layer.
  actor->SetPosition(10, 0, -0.5);
  above->AddActor(actor);
  above->SetActiveCamera(stage.Renderer->GetActiveCamera());
  stage.Window->SetNumberOfLayers(2);
  stage.Window->AddRenderer(above);
  const Picture picture = render(stage.Window);
  CHECK_EQUAL(picture.At(5, 5), (Pixel{ 0, 0, 0 }));
  CHECK_EQUAL(picture.At(12, 20), White);
  CHECK_EQUAL(picture.At(25, 20), (Pixel{ 0, 255, 0 }));
}

void checkErase()
{
  Stage stage;
  stage.LookFlat();
  stage.Mapper->SetInputData(twoSquares());
  render(stage.Window);
  stage.Window->EraseOff();
  stage.Actor->SetPosition(0, 30, 0);
  stage.Actor->RotateZ(10);
  const Picture picture = render(stage.Window);
  CHECK_EQUAL(picture.At(20, 20), White);
  CHECK_EQUAL(picture.At(20, 50), White);
  CHECK(render(stage.Window) == picture);
}

void checkSizes()
{
  Stage stage;
  stage.LookFlat();
  stage.Mapper->SetInputData(twoSquares());
  const Picture before = render(stage.Window);
  CHECK_EQUAL(before.CountOtherThan({ 0, 0, 0 }), 800);
  stage.Window->SetSize(200, 160);
  CHECK_EQUAL(render(stage.Window).CountOtherThan({ 0, 0, 0 }), 3200);
  stage.Window->SetSize(100, 80);
  CHECK(render(stage.Window) == before);

  Messages messages;
  stage.Window->SetSize(100, 0);
  stage.Window->Render();
  CHECK_EQUAL(messages.Count("100 x 0 pixels cannot be drawn"), 1);
  messages.Forget();
  stage.Window->SetSize(16385, 10);
  stage.Window->Render();
  CHECK_EQUAL(messages.Count("16385 x 10 pixels cannot be drawn"), 1);
  CHECK_EQUAL(messages.Count("16384"), 1);
  stage.Window->SetSize(100, 80);
  messages.Forget();
  CHECK(render(stage.Window) == before);
  CHECK_EQUAL(messages.GetText(), "");

  vtkNew<vtkLimnRenderWindow> untouched;
  untouched->Render();
  CHECK_EQUAL(untouched->GetSize()[0], 300);
}

void checkMultiSamples()
{
  Stage stage;
  CHECK_EQUAL(stage.Window->GetMultiSamples(), 4);
  const int asked[] = { 0, 1, 2, 3, 4, 5, 8, 9, 100 };
  const int used[] = { 1, 1, 2, 4, 4, 8, 8, 16, 16 };
  for (int i = 0; i < 9; ++i)
  {
    stage.Window->SetMultiSamples(asked[i]);
    CHECK_EQUAL(stage.Window->GetSamplesPerPixel(), used[i]);
  }
}

// vtkRenderer lets the near plane be this close for depth buffers of more than 16 bits.
void checkNearPlane()
{
  Stage stage;
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(100);
  stage.Mapper->SetInputConnection(sphere->GetOutputPort());
  stage.Renderer->ResetCamera();
  stage.Renderer->GetActiveCamera()->SetPosition(0, 0, 50);
  stage.Renderer->ResetCameraClippingRange();
  CHECK_EQUAL(stage.Renderer->GetNearClippingPlaneTolerance(), 0.001);
  const double* range = stage.Renderer->GetActiveCamera()->GetClippingRange();
  CHECK(std::abs(range[0] / range[1] - 0.001) < 1e-9);
  CHECK(vtkLimnCamera::SafeDownCast(stage.Renderer->GetActiveCamera()) != nullptr);
}

void checkQuestions()
{
  Stage stage;
  CHECK_EQUAL(std::string(stage.Window->GetRenderingBackend()), "Limn");
  CHECK_EQUAL(stage.Window->SupportsOpenGL(), 0);
  CHECK_EQUAL(stage.Window->GetDepthBufferSize(), 32);
  int bits[4] = { 0, 0, 0, 0 };
  stage.Window->GetColorBufferSizes(bits);
  CHECK_EQUAL(bits[0] + bits[1] + bits[2] + bits[3], 32);
  CHECK(std::strstr(stage.Window->ReportCapabilities(), "CPU") != nullptr);
  CHECK(stage.Window->IsCurrent());
}

void checkInteractor()
{
  Stage stage;
  vtkNew<vtkLimnRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(stage.Window);
  stage.Mapper->SetInputData(twoSquares());
  interactor->Initialize();
  CHECK(interactor->GetInitialized());
  CHECK_EQUAL(stage.Renderer->GetActiveCamera()->GetPosition()[2], 1);
  stage.Renderer->ResetCamera();
  interactor->Start();
  CHECK_EQUAL(interactor->GetSize()[0], 100);
  CHECK_EQUAL(read(stage.Window).CountOtherThan({ 0, 0, 0 }) > 0, true);

  vtkNew<vtkLimnRenderWindow> window;
  vtkRenderWindowInteractor* made = window->MakeRenderWindowInteractor();
  CHECK_EQUAL(std::string(made->GetClassName()), "vtkLimnRenderWindowInteractor");
}

/// Which timers came, in turn; ends the loop at the last one it waits for.
struct TimerLog
{
  vtkRenderWindowInteractor* Interactor;
  std::vector<int> Ids;
  std::size_t Enough;

  void Note(vtkObject*, unsigned long, void* timerId)
  {
    this->Ids.push_back(*static_cast<int*>(timerId));
    if (this->Ids.size() == this->Enough)
    {
      this->Interactor->TerminateApp();
    }
  }
};

void checkTimers()
{
  Stage stage;
  vtkNew<vtkLimnRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(stage.Window);
  interactor->Initialize();
  TimerLog log{ interactor, {}, 4 };
  interactor->AddObserver(vtkCommand::TimerEvent, &log, &TimerLog::Note);
  const int repeating = interactor->CreateRepeatingTimer(20);
  const int once = interactor->CreateOneShotTimer(30);
  const int never = interactor->CreateOneShotTimer(1);
  CHECK(repeating > 0 && once > 0 && never > 0);
  CHECK_EQUAL(interactor->DestroyTimer(never), 1);
  interactor->Start();
  CHECK_EQUAL(log.Ids.size(), 4u);
  CHECK_EQUAL(std::count(log.Ids.begin(), log.Ids.end(), repeating), 3);
  CHECK_EQUAL(std::count(log.Ids.begin(), log.Ids.end(), once), 1);

  // It goes on where it was stopped, and ends by itself when no timer is left.
  log.Enough = 6;
  interactor->Start();
  CHECK_EQUAL(log.Ids.size(), 6u);
  interactor->DestroyTimer(repeating);
  interactor->Start();
  CHECK_EQUAL(log.Ids.size(), 6u);
  interactor->ResetTimer(once);
  interactor->Start();
  CHECK_EQUAL(log.Ids.size(), 7u);
  CHECK_EQUAL(log.Ids.back(), once);
}

void checkImageFile(const char* file)
{
  Stage stage;
  stage.LookFlat();
  stage.Mapper->SetInputData(twoSquares());
  vtkNew<vtkWindowToImageFilter> grabber;
  grabber->SetInput(stage.Window);
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(file);
  writer->SetInputConnection(grabber->GetOutputPort());
  writer->Write();
  const Picture shown = read(stage.Window);
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(file);
  reader->Update();
  Picture stored;
  stored.Width = reader->GetOutput()->GetDimensions()[0];
  stored.Height = reader->GetOutput()->GetDimensions()[1];
  const auto* bytes = static_cast<unsigned char*>(reader->GetOutput()->GetScalarPointer());
  stored.Bytes.assign(bytes, bytes + 3 * static_cast<size_t>(stored.Width) * stored.Height);
  CHECK(stored == shown);
  CHECK_EQUAL(shown.CountOtherThan({ 0, 0, 0 }), 800);
}

// Twice the size in four tiles is what a window of twice the size shows.
void checkTiles()
{
  Stage stage;
  stage.LookFlat();
  stage.Mapper->SetInputData(twoSquares());
  stage.Renderer->GradientBackgroundOn();
  stage.Renderer->SetBackground2(1, 0, 0);
  vtkNew<vtkWindowToImageFilter> grabber;
  grabber->SetInput(stage.Window);
  grabber->SetScale(2);
  grabber->Update();
  vtkImageData* image = grabber->GetOutput();
  Picture tiled;
  tiled.Width = image->GetDimensions()[0];
  tiled.Height = image->GetDimensions()[1];
  const auto* bytes = static_cast<unsigned char*>(image->GetScalarPointer());
  tiled.Bytes.assign(bytes, bytes + 3 * static_cast<size_t>(tiled.Width) * tiled.Height);
  stage.Window->SetSize(200, 160);
  const Picture whole = render(stage.Window);
  CHECK_EQUAL(tiled.Width, 200);
  CHECK_EQUAL(tiled.Height, 160);
  CHECK_EQUAL(tiled.CountDifferent(whole, 0), 0);
}

// Fewer samples while the user drags, if the time is short; the still picture has all.
void checkDesiredUpdateRate()
{
  Stage stage;
  vtkNew<vtkSphereSource> sphere;
  stage.Mapper->SetInputConnection(sphere->GetOutputPort());
  stage.Window->SetMultiSamples(0);
  const Picture coarse = render(stage.Window);
  stage.Window->SetMultiSamples(8);
  const Picture still = render(stage.Window);
  CHECK(!(coarse == still));
  stage.Window->SetDesiredUpdateRate(15);
  CHECK(render(stage.Window) == still);
  stage.Window->SetDesiredUpdateRate(1e6);
  CHECK(render(stage.Window) == coarse);
  stage.Window->SetDesiredUpdateRate(0.0001);
  CHECK(render(stage.Window) == still);

  // Time for 80,000 triangles, unless all of them show.
  sphere->SetThetaResolution(200);
  sphere->SetPhiResolution(200);
  for (const double opacity : { 1.0, 0.5 })
  {
    stage.Actor->GetProperty()->SetOpacity(opacity);
    const Picture fine = render(stage.Window);
    stage.Window->SetDesiredUpdateRate(200);
    CHECK_EQUAL(render(stage.Window) == fine, opacity == 1);
    stage.Window->SetDesiredUpdateRate(0.0001);
  }
}

// Red and blue eyes are composed by VTK from pictures that it reads back.
void checkStereo()
{
  Stage stage;
  stage.Mapper->SetInputData(twoSquares());
  // The eyes see the same of what lies as far away as the focal point, so here it does not.
  stage.Actor->RotateY(60);
  stage.Renderer->ResetCamera();
  stage.Renderer->GetActiveCamera()->SetEyeAngle(10);
  const Picture mono = render(stage.Window);
  stage.Window->SetStereoTypeToRedBlue();
  stage.Window->StereoRenderOn();
  const Picture stereo = render(stage.Window);
  CHECK(!(stereo == mono));
  int red = 0;
  int blue = 0;
  for (int x = 0; x < 100; ++x)
  {
    const Pixel pixel = stereo.At(x, 40);
    red += pixel[0] > 100 && pixel[2] < 50;
    blue += pixel[2] > 100 && pixel[0] < 50;
  }
  CHECK(red > 0);
  CHECK(blue > 0);
  stage.Window->StereoRenderOff();
  CHECK(render(stage.Window) == mono);
}

class OtherRenderer : public vtkRenderer
{
public:
  static OtherRenderer* New() { VTK_STANDARD_NEW_BODY(OtherRenderer); }
  vtkTypeMacro(OtherRenderer, vtkRenderer)
};

void checkForeignRenderer()
{
  Messages messages;
  vtkNew<vtkLimnRenderWindow> window;
  vtkNew<OtherRenderer> renderer;
  window->AddRenderer(renderer);
  CHECK_EQUAL(messages.Count("A OtherRenderer cannot draw here."), 1);
  CHECK_EQUAL(window->GetRenderers()->GetNumberOfItems(), 0);
}
}

int TestLimnWindow(int argc, char* argv[])
{
  checkBackground();
  checkClearIsSeen();
  checkViewports();
  checkLayers();
  checkErase();
  checkSizes();
  checkMultiSamples();
  checkDesiredUpdateRate();
  checkNearPlane();
  checkQuestions();
  checkInteractor();
  checkTimers();
  checkImageFile(argc > 1 ? argv[1] : "TestLimnWindow.png");
  checkTiles();
  checkStereo();
  checkForeignRenderer();
  return result();
}
