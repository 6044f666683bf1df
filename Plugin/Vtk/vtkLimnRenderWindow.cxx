// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLimnRenderWindow.h"

#include "Private/WindowFrame.h"

#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkLimnRenderWindowInteractor.h"
#include "vtkLimnRenderer.h"
#include "vtkObjectFactory.h"
#include "vtkRendererCollection.h"
#include "vtkUnsignedCharArray.h"

#include <cstdlib>
#include <cstring>

namespace
{
constexpr int DefaultMultiSamples = 4;

using Region = vtkLimnRenderWindow::vtkFrame::Region;

unsigned char ToByte(float value)
{
  const float clamped = value > 0.0f ? (value < 1.0f ? value : 1.0f) : 0.0f;
  return static_cast<unsigned char>(clamped * 255.0f + 0.5f);
}

/// `over` drawn with its own alpha on `under`, as OpenGL blends.
limn::Rgba8 Blend(limn::Rgba8 over, limn::Rgba8 under)
{
  const int alpha = over.a;
  const auto mix = [alpha](int top, int bottom)
  { return static_cast<unsigned char>((top * alpha + bottom * (255 - alpha) + 127) / 255); };
  return { mix(over.r, under.r), mix(over.g, under.g), mix(over.b, under.b), mix(over.a, under.a) };
}

/// Makes `array` hold `components` values for each pixel of `region`. False if it is no array, or
/// the region is no region.
template <class Array>
bool Fit(Array* array, const Region& region, int components)
{
  if (!array || region.IsEmpty())
  {
    return false;
  }
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(region.GetSize()));
  return true;
}

template <class Array>
bool Holds(Array* array, const Region& region, int components)
{
  return array && !region.IsEmpty() && array->GetNumberOfComponents() == components &&
         array->GetNumberOfTuples() >= static_cast<vtkIdType>(region.GetSize());
}

// Pixels outside the window are black and transparent, or the farthest.
template <class Planes, class Value, class ReadRow>
void Read(const vtkLimnRenderWindow::vtkFrame& frame, const Planes& plane, const Region& region,
  int components, Value outside, Value* out, ReadRow readRow)
{
  const Region inside = frame.Clip(region);
  if (inside.Width != region.Width || inside.Height != region.Height)
  {
    std::fill_n(out, components * region.GetSize(), outside);
  }
  frame.ForEachRow(plane, region,
    [&](const auto* pixels, size_t count, size_t index)
    { readRow(pixels, count, out + components * index); });
}

void ReadRgb(vtkLimnRenderWindow::vtkFrame& frame, const Region& region, unsigned char* out)
{
  Read(frame, frame.GetColor(), region, 3, static_cast<unsigned char>(0), out,
    [](const limn::Rgba8* pixels, size_t count, unsigned char* row)
    {
      for (size_t i = 0; i < count; ++i)
      {
        row[3 * i] = pixels[i].r;
        row[3 * i + 1] = pixels[i].g;
        row[3 * i + 2] = pixels[i].b;
      }
    });
}

void ReadRgba(vtkLimnRenderWindow::vtkFrame& frame, const Region& region, unsigned char* out)
{
  Read(frame, frame.GetColor(), region, 4, static_cast<unsigned char>(0), out,
    [](const limn::Rgba8* pixels, size_t count, unsigned char* row)
    { std::memcpy(row, pixels, 4 * count); });
}

void ReadFloats(vtkLimnRenderWindow::vtkFrame& frame, const Region& region, float* out)
{
  Read(frame, frame.GetColor(), region, 4, 0.0f, out,
    [](const limn::Rgba8* pixels, size_t count, float* row)
    {
      for (size_t i = 0; i < count; ++i)
      {
        row[4 * i] = pixels[i].r / 255.0f;
        row[4 * i + 1] = pixels[i].g / 255.0f;
        row[4 * i + 2] = pixels[i].b / 255.0f;
        row[4 * i + 3] = pixels[i].a / 255.0f;
      }
    });
}

void ReadDepth(vtkLimnRenderWindow::vtkFrame& frame, const Region& region, float* out)
{
  Read(frame, frame.GetDepth(), region, 1, 1.0f, out,
    [](const float* depths, size_t count, float* row)
    { std::memcpy(row, depths, count * sizeof(float)); });
}

/// A component of the tuples of an array.
struct Component
{
  int Number;
  int Count;
};

template <class Planes, class Value, class Convert>
void ReadComponent(vtkLimnRenderWindow::vtkFrame& frame, Planes& plane, const Region& region,
  Component component, Value outside, Value* out, Convert convert)
{
  frame.ForEach(plane, region,
    [&](const auto* pixel, size_t index)
    { out[index * component.Count + component.Number] = pixel ? convert(*pixel) : outside; });
}

/// Writes colorAt(index) to the pixels of the region.
template <class ColorAt>
void Write(vtkLimnRenderWindow::vtkFrame& frame, const Region& region, int blend, ColorAt colorAt)
{
  frame.ForEach(frame.GetColor(), region,
    [&](limn::Rgba8* pixel, size_t index)
    {
      if (pixel)
      {
        *pixel = blend ? Blend(colorAt(index), *pixel) : colorAt(index);
      }
    });
}
}

vtkStandardNewMacro(vtkLimnRenderWindow);

//------------------------------------------------------------------------------
vtkLimnRenderWindow::vtkLimnRenderWindow() : Pixels(new vtkFrame)
{
  // As VTK's other windows: baselines of tests are made without.
  this->MultiSamples = std::getenv("VTK_TESTING") ? 0 : DefaultMultiSamples;
  this->SetWindowName("Limn");
}

//------------------------------------------------------------------------------
vtkLimnRenderWindow::~vtkLimnRenderWindow()
{
  this->Finalize();
}

//------------------------------------------------------------------------------
const char* vtkLimnRenderWindow::ReportCapabilities()
{
  return "Limn: drawn on the CPU, in memory; RGBA with 8 bits each, 32 bit depth, 1, 2, 4 or 8 "
         "samples per pixel";
}

//------------------------------------------------------------------------------
void vtkLimnRenderWindow::AddRenderer(vtkRenderer* renderer)
{
  if (!vtkLimnRenderer::SafeDownCast(renderer))
  {
    vtkErrorMacro("A " << (renderer ? renderer->GetClassName() : "null pointer")
                       << " cannot draw here. Make it with vtkLimnRenderer::New(), or set "
                          "LIMN_WINDOW=cpu, so that vtkRenderer::New() makes one.");
    return;
  }
  this->Superclass::AddRenderer(renderer);
}

//------------------------------------------------------------------------------
void vtkLimnRenderWindow::SetInteractor(vtkRenderWindowInteractor* interactor)
{
  for (const char* name : { "vtkXRenderWindowInteractor", "vtkWin32RenderWindowInteractor",
         "vtkCocoaRenderWindowInteractor" })
  {
    if (interactor && interactor->IsA(name))
    {
      vtkErrorMacro("A " << name
                         << " needs a window on a screen. Make it with "
                            "vtkLimnRenderWindowInteractor::New(), or set LIMN_WINDOW=cpu, so that "
                            "vtkRenderWindowInteractor::New() makes one.");
      interactor->SetRenderWindow(nullptr);
      return;
    }
  }
  this->Superclass::SetInteractor(interactor);
}

//------------------------------------------------------------------------------
vtkRenderWindowInteractor* vtkLimnRenderWindow::MakeRenderWindowInteractor()
{
  this->Interactor = vtkLimnRenderWindowInteractor::New();
  this->Interactor->SetRenderWindow(this);
  return this->Interactor;
}

//------------------------------------------------------------------------------
void vtkLimnRenderWindow::Start()
{
  const int width = this->Size[0];
  const int height = this->Size[1];
  const auto isSide = [](int side) { return side > 0 && side <= limn::kMaxImageSide; };
  if (!isSide(width) || !isSide(height))
  {
    vtkErrorMacro("A window of " << width << " x " << height
                                 << " pixels cannot be drawn: each side has to be from 1 to "
                                 << limn::kMaxImageSide << ". Call SetSize() with such a size.");
    this->Pixels->Resize(0, 0);
    return;
  }
  this->Pixels->Resize(width, height);
  this->Mapped = 1;
}

//------------------------------------------------------------------------------
void vtkLimnRenderWindow::Finalize()
{
  vtkCollectionSimpleIterator iterator;
  this->Renderers->InitTraversal(iterator);
  while (vtkRenderer* renderer = this->Renderers->GetNextRenderer(iterator))
  {
    renderer->ReleaseGraphicsResources(this);
  }
  this->Pixels->Resize(0, 0);
  this->Mapped = 0;
}

//------------------------------------------------------------------------------
void vtkLimnRenderWindow::ReleaseGraphicsResources(vtkWindow* vtkNotUsed(window))
{
  this->Finalize();
}

//------------------------------------------------------------------------------
int* vtkLimnRenderWindow::GetScreenSize()
{
  // There is no screen; programs that fill it get this.
  static int size[2];
  size[0] = 1920;
  size[1] = 1080;
  return size;
}

//------------------------------------------------------------------------------
void vtkLimnRenderWindow::SetFullScreen(vtkTypeBool fullScreen)
{
  if (fullScreen)
  {
    this->SetSize(this->GetScreenSize());
  }
}

//------------------------------------------------------------------------------
int vtkLimnRenderWindow::GetColorBufferSizes(int* rgba)
{
  if (!rgba)
  {
    return 0;
  }
  rgba[0] = rgba[1] = rgba[2] = rgba[3] = 8;
  return 32;
}

//------------------------------------------------------------------------------
int vtkLimnRenderWindow::GetSamplesPerPixel()
{
  int samples = 1;
  while (samples < 16 && samples < this->MultiSamples)
  {
    samples *= 2;
  }
  return samples;
}

//------------------------------------------------------------------------------
unsigned char* vtkLimnRenderWindow::GetPixelData(int x, int y, int x2, int y2, int, int)
{
  const Region region = Region::FromCorners(x, y, x2, y2);
  unsigned char* data = new unsigned char[3 * region.GetSize()];
  ReadRgb(*this->Pixels, region, data);
  return data;
}

//------------------------------------------------------------------------------
int vtkLimnRenderWindow::GetPixelData(
  int x, int y, int x2, int y2, int, vtkUnsignedCharArray* data, int)
{
  const Region region = Region::FromCorners(x, y, x2, y2);
  if (!Fit(data, region, 3))
  {
    return VTK_ERROR;
  }
  ReadRgb(*this->Pixels, region, data->GetPointer(0));
  return VTK_OK;
}

//------------------------------------------------------------------------------
int vtkLimnRenderWindow::SetPixelData(int x, int y, int x2, int y2, unsigned char* data, int, int)
{
  const Region region = Region::FromCorners(x, y, x2, y2);
  if (!data || region.IsEmpty())
  {
    return VTK_ERROR;
  }
  Write(*this->Pixels, region, 0,
    [data](size_t i) {
      return limn::Rgba8{ data[3 * i], data[3 * i + 1], data[3 * i + 2], 255 };
    });
  return VTK_OK;
}

//------------------------------------------------------------------------------
int vtkLimnRenderWindow::SetPixelData(
  int x, int y, int x2, int y2, vtkUnsignedCharArray* data, int front, int right)
{
  if (!Holds(data, Region::FromCorners(x, y, x2, y2), 3))
  {
    vtkErrorMacro("The array has to hold three values for each pixel.");
    return VTK_ERROR;
  }
  return this->SetPixelData(x, y, x2, y2, data->GetPointer(0), front, right);
}

//------------------------------------------------------------------------------
float* vtkLimnRenderWindow::GetRGBAPixelData(int x, int y, int x2, int y2, int, int)
{
  const Region region = Region::FromCorners(x, y, x2, y2);
  float* data = new float[4 * region.GetSize()];
  ReadFloats(*this->Pixels, region, data);
  return data;
}

//------------------------------------------------------------------------------
int vtkLimnRenderWindow::GetRGBAPixelData(
  int x, int y, int x2, int y2, int, vtkFloatArray* data, int)
{
  const Region region = Region::FromCorners(x, y, x2, y2);
  if (!Fit(data, region, 4))
  {
    return VTK_ERROR;
  }
  ReadFloats(*this->Pixels, region, data->GetPointer(0));
  return VTK_OK;
}

//------------------------------------------------------------------------------
int vtkLimnRenderWindow::SetRGBAPixelData(
  int x, int y, int x2, int y2, float* data, int, int blend, int)
{
  const Region region = Region::FromCorners(x, y, x2, y2);
  if (!data || region.IsEmpty())
  {
    return VTK_ERROR;
  }
  Write(*this->Pixels, region, blend,
    [data](size_t i)
    {
      return limn::Rgba8{ ToByte(data[4 * i]), ToByte(data[4 * i + 1]), ToByte(data[4 * i + 2]),
        ToByte(data[4 * i + 3]) };
    });
  return VTK_OK;
}

//------------------------------------------------------------------------------
int vtkLimnRenderWindow::SetRGBAPixelData(
  int x, int y, int x2, int y2, vtkFloatArray* data, int front, int blend, int right)
{
  if (!Holds(data, Region::FromCorners(x, y, x2, y2), 4))
  {
    vtkErrorMacro("The array has to hold four values for each pixel.");
    return VTK_ERROR;
  }
  return this->SetRGBAPixelData(x, y, x2, y2, data->GetPointer(0), front, blend, right);
}

//------------------------------------------------------------------------------
void vtkLimnRenderWindow::ReleaseRGBAPixelData(float* data)
{
  delete[] data;
}

//------------------------------------------------------------------------------
unsigned char* vtkLimnRenderWindow::GetRGBACharPixelData(int x, int y, int x2, int y2, int, int)
{
  const Region region = Region::FromCorners(x, y, x2, y2);
  unsigned char* data = new unsigned char[4 * region.GetSize()];
  ReadRgba(*this->Pixels, region, data);
  return data;
}

//------------------------------------------------------------------------------
int vtkLimnRenderWindow::GetRGBACharPixelData(
  int x, int y, int x2, int y2, int, vtkUnsignedCharArray* data, int)
{
  const Region region = Region::FromCorners(x, y, x2, y2);
  if (!Fit(data, region, 4))
  {
    return VTK_ERROR;
  }
  ReadRgba(*this->Pixels, region, data->GetPointer(0));
  return VTK_OK;
}

//------------------------------------------------------------------------------
int vtkLimnRenderWindow::SetRGBACharPixelData(
  int x, int y, int x2, int y2, unsigned char* data, int, int blend, int)
{
  const Region region = Region::FromCorners(x, y, x2, y2);
  if (!data || region.IsEmpty())
  {
    return VTK_ERROR;
  }
  Write(*this->Pixels, region, blend,
    [data](size_t i) {
      return limn::Rgba8{ data[4 * i], data[4 * i + 1], data[4 * i + 2], data[4 * i + 3] };
    });
  return VTK_OK;
}

//------------------------------------------------------------------------------
int vtkLimnRenderWindow::SetRGBACharPixelData(
  int x, int y, int x2, int y2, vtkUnsignedCharArray* data, int front, int blend, int right)
{
  if (!Holds(data, Region::FromCorners(x, y, x2, y2), 4))
  {
    vtkErrorMacro("The array has to hold four values for each pixel.");
    return VTK_ERROR;
  }
  return this->SetRGBACharPixelData(x, y, x2, y2, data->GetPointer(0), front, blend, right);
}

//------------------------------------------------------------------------------
float* vtkLimnRenderWindow::GetZbufferData(int x, int y, int x2, int y2)
{
  const Region region = Region::FromCorners(x, y, x2, y2);
  float* z = new float[region.GetSize()];
  ReadDepth(*this->Pixels, region, z);
  return z;
}

//------------------------------------------------------------------------------
int vtkLimnRenderWindow::GetZbufferData(int x, int y, int x2, int y2, float* z)
{
  const Region region = Region::FromCorners(x, y, x2, y2);
  if (!z || region.IsEmpty())
  {
    return VTK_ERROR;
  }
  ReadDepth(*this->Pixels, region, z);
  return VTK_OK;
}

//------------------------------------------------------------------------------
int vtkLimnRenderWindow::GetZbufferData(int x, int y, int x2, int y2, vtkFloatArray* z)
{
  return Fit(z, Region::FromCorners(x, y, x2, y2), 1)
           ? this->GetZbufferData(x, y, x2, y2, z->GetPointer(0))
           : VTK_ERROR;
}

//------------------------------------------------------------------------------
int vtkLimnRenderWindow::SetZbufferData(int x, int y, int x2, int y2, float* z)
{
  const Region region = Region::FromCorners(x, y, x2, y2);
  if (!z || region.IsEmpty())
  {
    return VTK_ERROR;
  }
  this->Pixels->ForEach(this->Pixels->GetDepth(), region,
    [z](float* depth, size_t index)
    {
      if (depth)
      {
        *depth = z[index];
      }
    });
  return VTK_OK;
}

//------------------------------------------------------------------------------
int vtkLimnRenderWindow::SetZbufferData(int x, int y, int x2, int y2, vtkFloatArray* z)
{
  if (!Holds(z, Region::FromCorners(x, y, x2, y2), 1))
  {
    vtkErrorMacro("The array has to hold one value for each pixel.");
    return VTK_ERROR;
  }
  return this->SetZbufferData(x, y, x2, y2, z->GetPointer(0));
}

//------------------------------------------------------------------------------
void vtkLimnRenderWindow::SetMaps(bool maps)
{
  if (maps != this->GetMaps())
  {
    this->Pixels->SetMaps(maps);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkLimnRenderWindow::GetMaps()
{
  return this->Pixels->HasMaps();
}

//------------------------------------------------------------------------------
int vtkLimnRenderWindow::GetNormalData(int x, int y, int x2, int y2, vtkFloatArray* data)
{
  const Region region = Region::FromCorners(x, y, x2, y2);
  if (!this->GetMaps())
  {
    vtkErrorMacro("There are no normals without MapsOn() before the window is rendered.");
    return VTK_ERROR;
  }
  if (!Fit(data, region, 3))
  {
    return VTK_ERROR;
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    ReadComponent(*this->Pixels, this->Pixels->GetNormal(axis), region, { axis, 3 }, 0.0f,
      data->GetPointer(0), [](float value) { return value; });
  }
  return VTK_OK;
}

//------------------------------------------------------------------------------
int vtkLimnRenderWindow::GetIdData(int x, int y, int x2, int y2, vtkIdTypeArray* data)
{
  const Region region = Region::FromCorners(x, y, x2, y2);
  if (!this->GetMaps())
  {
    vtkErrorMacro("There are no ids without MapsOn() before the window is rendered.");
    return VTK_ERROR;
  }
  if (!Fit(data, region, 2))
  {
    return VTK_ERROR;
  }
  const auto toId = [](std::uint32_t number)
  { return number == limn::kNobody ? vtkIdType{ -1 } : static_cast<vtkIdType>(number); };
  ReadComponent(*this->Pixels, this->Pixels->GetActor(), region, { 0, 2 }, vtkIdType{ -1 },
    data->GetPointer(0), toId);
  ReadComponent(*this->Pixels, this->Pixels->GetCell(), region, { 1, 2 }, vtkIdType{ -1 },
    data->GetPointer(0), toId);
  return VTK_OK;
}

//------------------------------------------------------------------------------
vtkActor* vtkLimnRenderWindow::GetMappedActor(vtkIdType number)
{
  return this->Pixels->ActorOf(number);
}

//------------------------------------------------------------------------------
void vtkLimnRenderWindow::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SamplesPerPixel: " << this->GetSamplesPerPixel() << "\n";
  os << indent << "Maps: " << (this->GetMaps() ? "On" : "Off") << "\n";
  os << indent << "Frame: " << this->Pixels->GetWidth() << " x " << this->Pixels->GetHeight()
     << "\n";
}
