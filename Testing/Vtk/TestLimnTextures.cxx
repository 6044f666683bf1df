// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkTexture's on surfaces, and the maps of vtkLimnProperty.
#include "Check.h"
#include "Messages.h"
#include "Picture.h"
#include "Stage.h"

#include "vtkLimnProperty.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkLookupTable.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkTexture.h"
#include "vtkTransform.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace
{
using Values = std::vector<double>;

/// Texels from the lower left one.
vtkSmartPointer<vtkTexture> makeTexture(
  int width, int height, int components, const Values& values, int type = VTK_UNSIGNED_CHAR)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(type, components);
  for (size_t i = 0; i < values.size(); ++i)
  {
    image->GetPointData()->GetScalars()->SetComponent(
      static_cast<vtkIdType>(i) / components, static_cast<int>(i) % components, values[i]);
  }
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  return texture;
}

vtkSmartPointer<vtkTexture> makeFloats(int width, int height, const Values& values)
{
  vtkSmartPointer<vtkTexture> texture = makeTexture(width, height, 3, values, VTK_FLOAT);
  texture->SetColorModeToDirectScalars();
  return texture;
}

/// Red grows by column, green by row.
vtkSmartPointer<vtkTexture> makeNumbered(int width, int height)
{
  Values values;
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      values.insert(values.end(), { 10.0 + x, 20.0 + y, 200.0 });
    }
  }
  return makeTexture(width, height, 3, values);
}

vtkSmartPointer<vtkFloatArray> makeTCoords(double most)
{
  auto tcoords = vtkSmartPointer<vtkFloatArray>::New();
  tcoords->SetNumberOfComponents(2);
  for (int square = 0; square < 2; ++square)
  {
    tcoords->InsertNextTuple2(0, 0);
    tcoords->InsertNextTuple2(most, 0);
    tcoords->InsertNextTuple2(most, most);
    tcoords->InsertNextTuple2(0, most);
  }
  return tcoords;
}

/// A square of 20 x 20 pixels from (10, 10) on, and another; coordinates go from 0 to `most`.
vtkSmartPointer<vtkPolyData> makeSquares(double most = 1)
{
  vtkSmartPointer<vtkPolyData> squares = twoSquares();
  squares->GetPointData()->SetTCoords(makeTCoords(most));
  return squares;
}

/// A stage that looks flat at unlit white squares.
struct TexturedStage : Stage
{
  explicit TexturedStage(double most = 1)
  {
    this->LookFlat();
    this->Data = makeSquares(most);
    this->Mapper->SetInputData(this->Data);
    this->Property = vtkLimnProperty::SafeDownCast(this->Actor->GetProperty());
  }
  /// One light from the eye, on n = (0, 0, 1).
  void Light()
  {
    this->Property->LightingOn();
    this->Property->SetShadingFrequencyToPhong();
    this->Property->SetReflectionModelToLambert();
  }
  Pixel Center() { return render(this->Window).At(20, 20); }

  vtkSmartPointer<vtkPolyData> Data;
  vtkLimnProperty* Property = nullptr;
};

bool isNear(const Pixel& pixel, double red, double green, double blue)
{
  return std::abs(pixel[0] - red) <= 0.51 && std::abs(pixel[1] - green) <= 0.51 &&
         std::abs(pixel[2] - blue) <= 0.51;
}

/// Half a level off, for rounding.
#define CHECK_NEAR(actual, red, green, blue)                                                       \
  do                                                                                               \
  {                                                                                                \
    const Pixel shown = actual;                                                                    \
    if (!isNear(shown, red, green, blue))                                                          \
    {                                                                                              \
      CHECK_EQUAL(shown, (Pixel{ int(red), int(green), int(blue) }));                              \
    }                                                                                              \
  } while (false)

// Texels of a whole number of pixels: each pixel shows its own.
void checkTexels()
{
  TexturedStage stage;
  stage.Actor->SetTexture(makeNumbered(5, 4));
  const Picture picture = render(stage.Window);
  for (int y = 0; y < 20; ++y)
  {
    for (int x = 0; x < 20; ++x)
    {
      CHECK_EQUAL(picture.At(10 + x, 10 + y), (Pixel{ 10 + x / 4, 20 + y / 5, 200 }));
    }
  }
  CHECK_EQUAL(picture.At(40, 10), (Pixel{ 10, 20, 200 }));
}

void checkRepetition()
{
  TexturedStage stage(4);
  stage.Actor->SetTexture(makeNumbered(5, 5));
  const Picture picture = render(stage.Window);
  for (int x = 0; x < 20; ++x)
  {
    CHECK_EQUAL(picture.At(10 + x, 10), (Pixel{ 10 + x % 5, 20, 200 }));
  }
  stage.Actor->GetTexture()->SetWrap(vtkTexture::ClampToEdge);
  CHECK_EQUAL(render(stage.Window).At(29, 29), (Pixel{ 14, 24, 200 }));
  stage.Actor->GetTexture()->SetWrap(vtkTexture::MirroredRepeat);
  CHECK_EQUAL(render(stage.Window).At(15, 10), (Pixel{ 14, 20, 200 }));
  stage.Actor->GetTexture()->SetWrap(vtkTexture::ClampToBorder);
  stage.Actor->GetTexture()->SetBorderColor(1, 0, 1, 1);
  CHECK_EQUAL(render(stage.Window).At(15, 10), (Pixel{ 255, 0, 255 }));
}

// Halfway between two texels.
void checkFilter()
{
  TexturedStage stage;
  stage.Actor->SetTexture(makeTexture(2, 1, 3, { 0, 100, 200, 100, 100, 0 }));
  stage.Actor->GetTexture()->InterpolateOn();
  stage.Actor->GetTexture()->SetWrap(vtkTexture::ClampToEdge);
  const Picture picture = render(stage.Window);
  // Texel centres are at 5 and 15 of 20 pixels, pixels' at n + 1/2.
  CHECK_NEAR(picture.At(10 + 12, 20), 75, 100, 50);
  CHECK_EQUAL(picture.At(10 + 3, 20), (Pixel{ 0, 100, 200 }));

  stage.Actor->GetTexture()->MipmapOn();
  stage.Data->GetPointData()->SetTCoords(makeTCoords(40));
  CHECK_NEAR(stage.Center(), 50, 100, 100);
}

void checkTransform()
{
  TexturedStage stage;
  stage.Actor->SetTexture(makeNumbered(20, 20));
  vtkNew<vtkTransform> transform;
  transform->Translate(0.25, 0.5, 0);
  transform->Scale(0.5, 0.25, 1);
  stage.Actor->GetTexture()->SetTransform(transform);
  CHECK_EQUAL(render(stage.Window).At(10 + 8, 10 + 4), (Pixel{ 10 + 5 + 4, 20 + 10 + 1, 200 }));
  // A move that is not the texture's own shows as well.
  transform->Identity();
  CHECK_EQUAL(render(stage.Window).At(10 + 8, 10 + 4), (Pixel{ 10 + 8, 20 + 4, 200 }));
}

// Bytes as they are, other numbers by the table or, where asked, as they are.
void checkImages()
{
  TexturedStage stage;
  stage.Actor->SetTexture(makeTexture(1, 1, 1, { 77 }));
  CHECK_EQUAL(stage.Center(), (Pixel{ 77, 77, 77 }));
  stage.Actor->SetTexture(makeTexture(1, 1, 2, { 77, 255 }));
  CHECK_EQUAL(stage.Center(), (Pixel{ 77, 77, 77 }));
  stage.Actor->SetTexture(makeTexture(1, 1, 4, { 1, 2, 3, 255 }));
  CHECK_EQUAL(stage.Center(), (Pixel{ 1, 2, 3 }));
  stage.Actor->SetTexture(makeTexture(1, 1, 3, { 257, 514, 65535 }, VTK_UNSIGNED_SHORT));
  stage.Actor->GetTexture()->SetColorModeToDirectScalars();
  CHECK_EQUAL(stage.Center(), (Pixel{ 1, 2, 255 }));
  stage.Actor->SetTexture(makeFloats(1, 1, { 0.2, 0.4, 1.5 }));
  CHECK_EQUAL(stage.Center(), (Pixel{ 51, 102, 255 }));

  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(2);
  table->SetRange(0, 1);
  table->SetTableValue(0, 1, 0, 0);
  table->SetTableValue(1, 0, 1, 0);
  stage.Actor->SetTexture(makeTexture(1, 1, 1, { 0.9 }, VTK_DOUBLE));
  stage.Actor->GetTexture()->SetLookupTable(table);
  CHECK_EQUAL(stage.Center(), (Pixel{ 0, 255, 0 }));

  // sRGB 188 is 0.5028865 of full light (IEC 61966-2-1).
  stage.Actor->SetTexture(makeTexture(1, 1, 3, { 188, 10, 255 }));
  stage.Actor->GetTexture()->UseSRGBColorSpaceOn();
  CHECK_NEAR(stage.Center(), 0.5028865 * 255, 10 / 12.92, 255);
}

void checkModes()
{
  TexturedStage stage;
  stage.Property->SetColor(0.6, 0.2, 1.0);
  stage.Actor->SetTexture(makeTexture(1, 1, 3, { 51, 153, 102 }));
  CHECK_NEAR(stage.Center(), 0.6 * 51, 0.2 * 153, 102);
  stage.Property->SetTextureModeToReplace();
  CHECK_NEAR(stage.Center(), 51, 153, 102);
  stage.Property->SetTextureModeToAdd();
  CHECK_NEAR(stage.Center(), 0.6 * 255 + 51, 0.2 * 255 + 153, 255);
  stage.Property->SetTextureModeToDecal();
  CHECK_NEAR(stage.Center(), 51, 153, 102);
  stage.Actor->SetTexture(makeTexture(1, 1, 4, { 51, 153, 102, 51 }));
  CHECK_NEAR(
    stage.Center(), 0.8 * 0.6 * 255 + 0.2 * 51, 0.8 * 0.2 * 255 + 0.2 * 153, 0.8 * 255 + 0.2 * 102);
}

// Textures are blended with each other first.
void checkBlending()
{
  const struct
  {
    int mode;
    Pixel expected;
  } cases[] = {
    { vtkTexture::VTK_TEXTURE_BLENDING_MODE_NONE, { 40, 100, 60 } },
    { vtkTexture::VTK_TEXTURE_BLENDING_MODE_INTERPOLATE, { 40, 100, 60 } },
    { vtkTexture::VTK_TEXTURE_BLENDING_MODE_REPLACE, { 30, 25, 75 } },
    { vtkTexture::VTK_TEXTURE_BLENDING_MODE_MODULATE, { 40 * 60 / 255, 20, 60 * 150 / 255 } },
    { vtkTexture::VTK_TEXTURE_BLENDING_MODE_ADD, { 70, 125, 135 } },
    { vtkTexture::VTK_TEXTURE_BLENDING_MODE_ADD_SIGNED, { 6, 61, 71 } },
    { vtkTexture::VTK_TEXTURE_BLENDING_MODE_SUBTRACT, { 10, 75, 0 } },
  };
  for (const auto& one : cases)
  {
    TexturedStage stage;
    stage.Property->SetColor(0.5, 0.5, 0.5);
    stage.Actor->SetTexture(makeTexture(1, 1, 3, { 80, 200, 120 }));
    stage.Property->SetTexture("second", makeTexture(1, 1, 3, { 60, 51, 150 }));
    stage.Property->GetTexture("second")->SetBlendingMode(one.mode);
    const Pixel shown = stage.Center();
    for (int i = 0; i < 3; ++i)
    {
      CHECK(std::abs(shown[i] - one.expected[i]) <= 1);
    }
  }
}

// k_d t and k_s against (k_d + k_s) t, with a light from the eye.
void checkRoles()
{
  TexturedStage stage;
  stage.Light();
  stage.Property->SetReflectionModelToPhong();
  stage.Property->SetDiffuse(0.5);
  stage.Property->SetSpecular(0.3);
  stage.Property->SetSpecularPower(2);
  stage.Actor->SetTexture(makeTexture(1, 1, 3, { 51, 153, 102 }));
  CHECK_NEAR(stage.Center(), 0.8 * 51, 0.8 * 153, 0.8 * 102);
  stage.Property->SetTextureRoleToSurface();
  const double highlight = 0.3 * 255;
  CHECK_NEAR(stage.Center(), 0.5 * 51 + highlight, 0.5 * 153 + highlight, 0.5 * 102 + highlight);
  stage.Property->SetTextureModeToReplace();
  stage.Property->SetDiffuseColor(0.1, 0.1, 0.1);
  CHECK_NEAR(stage.Center(), 0.5 * 51 + highlight, 0.5 * 153 + highlight, 0.5 * 102 + highlight);
}

// On a second set of coordinates: added to what the lamp gives.
void checkLightmap()
{
  TexturedStage stage;
  stage.Light();
  stage.Property->SetColor(0.5, 0.4, 0.2);
  stage.Property->SetLightmapTexture(makeFloats(2, 1, { 0, 0, 0, 0.4, 0.6, 1.0 }));
  stage.Property->SetLightmapIntensity(0.5);
  vtkSmartPointer<vtkFloatArray> baked = makeTCoords(1);
  baked->SetName("baked");
  baked->FillComponent(0, 0.75);
  stage.Data->GetPointData()->AddArray(baked);
  stage.Data->GetPointData()->GetTCoords()->FillComponent(0, 0.25);
  CHECK_NEAR(stage.Center(), 0.5 * 255, 0.4 * 255, 0.2 * 255);
  stage.Property->SetLightmapTCoords("baked");
  CHECK_NEAR(stage.Center(), 0.5 * 1.2 * 255, 0.4 * 1.3 * 255, 0.2 * 1.5 * 255);

  Messages messages;
  stage.Property->SetLightmapTCoords("no such array");
  CHECK_NEAR(stage.Center(), 0.5 * 255, 0.4 * 255, 0.2 * 255);
  CHECK_NEAR(stage.Center(), 0.5 * 255, 0.4 * 255, 0.2 * 255);
  CHECK_EQUAL(messages.Count("no point array 'no such array'"), 1);
}

// A ramp of heights tilts the normal by its slope.
void checkBumps()
{
  TexturedStage stage;
  stage.Light();
  Values heights;
  for (int x = 0; x < 8; ++x)
  {
    heights.insert(heights.end(), { 0.5 * (x + 0.5) / 8, 0, 0 });
  }
  stage.Property->SetBumpTexture(makeFloats(8, 1, heights));
  stage.Property->SetBumpScale(1.5);
  const double slope = 1.5 * 0.5;
  const double cosine = 1 / std::sqrt(1 + slope * slope);
  CHECK_NEAR(stage.Center(), 255 * cosine, 255 * cosine, 255 * cosine);
  stage.Property->SetBumpScale(0);
  CHECK_EQUAL(stage.Center(), (Pixel{ 255, 255, 255 }));
}

// (0.6, 0, 0.8) at all points; its cosine is 0.8.
void checkNormalMap()
{
  TexturedStage stage;
  stage.Light();
  stage.Property->SetNormalTexture(makeFloats(1, 1, { 0.8, 0.5, 0.9 }));
  CHECK_NEAR(stage.Center(), 0.8 * 255, 0.8 * 255, 0.8 * 255);
  // As VTK, which needs tangents for it.
  stage.Property->SetShadingFrequencyToAsVTK();
  CHECK_EQUAL(stage.Center(), (Pixel{ 255, 255, 255 }));
  vtkNew<vtkFloatArray> vectors;
  vectors->SetNumberOfComponents(3);
  vectors->SetNumberOfTuples(8);
  vectors->FillComponent(0, 0);
  vectors->FillComponent(1, 0);
  vectors->FillComponent(2, 1);
  stage.Data->GetPointData()->SetNormals(vectors);
  vtkNew<vtkFloatArray> tangents;
  tangents->DeepCopy(vectors);
  stage.Data->GetPointData()->SetTangents(tangents);
  CHECK_NEAR(stage.Center(), 0.8 * 255, 0.8 * 255, 0.8 * 255);
}

// Cubes of ten pixels, without texture coordinates.
void checkProcedural()
{
  TexturedStage stage;
  stage.Data->GetPointData()->SetTCoords(nullptr);
  stage.Property->SetProceduralTextureToChecker();
  stage.Property->SetProceduralScale(0.1);
  stage.Property->SetProceduralColorA(1, 0, 0);
  stage.Property->SetProceduralColorB(0, 0, 1);
  const Picture picture = render(stage.Window);
  CHECK_EQUAL(picture.At(15, 15), (Pixel{ 255, 0, 0 }));
  CHECK_EQUAL(picture.At(25, 15), (Pixel{ 0, 0, 255 }));
  CHECK_EQUAL(picture.At(25, 25), (Pixel{ 255, 0, 0 }));
  for (int kind : { vtkLimnProperty::PROCEDURAL_WOOD, vtkLimnProperty::PROCEDURAL_MARBLE })
  {
    stage.Property->SetProceduralTexture(kind);
    stage.Property->SetProceduralTurbulence(0.5);
    CHECK(!(render(stage.Window) == picture));
  }
  Messages messages;
  stage.Property->SetProceduralSpaceToUv();
  CHECK_EQUAL(stage.Center(), (Pixel{ 255, 255, 255 }));
  CHECK_EQUAL(messages.Count("use the space Object"), 1);
  stage.Data->GetPointData()->SetTCoords(makeTCoords(2));
  stage.Property->SetProceduralTextureToChecker();
  stage.Property->SetProceduralScale(1);
  const Picture byUv = render(stage.Window);
  CHECK_EQUAL(byUv.At(15, 15), (Pixel{ 255, 0, 0 }));
  CHECK_EQUAL(byUv.At(25, 15), (Pixel{ 0, 0, 255 }));
}

// A pixel between a point of 0 and one of 1 has the colour of its own scalar, under a texture that
// has coordinates of its own.
void checkScalars()
{
  TexturedStage stage;
  vtkNew<vtkFloatArray> scalars;
  for (int i = 0; i < 8; ++i)
  {
    scalars->InsertNextValue(i % 4 == 1 || i % 4 == 2 ? 4.0f : 0.0f);
  }
  stage.Data->GetPointData()->SetScalars(scalars);
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(4);
  for (int i = 0; i < 4; ++i)
  {
    table->SetTableValue(i, 0.2 * i, 0.2 * (i % 2), 1);
  }
  stage.Mapper->SetLookupTable(table);
  stage.Mapper->SetScalarRange(0, 4);
  stage.Mapper->InterpolateScalarsBeforeMappingOn();
  Messages messages;
  const Picture picture = render(stage.Window);
  for (int x = 0; x < 20; ++x)
  {
    const int value = x / 5;
    CHECK_EQUAL(picture.At(10 + x, 20), (Pixel{ 51 * value, 51 * (value % 2), 255 }));
  }
  stage.Actor->SetTexture(
    makeTexture(2, 2, 3, { 255, 255, 255, 255, 255, 255, 255, 0, 0, 255, 0, 0 }));
  CHECK_EQUAL(render(stage.Window).At(27, 15), (Pixel{ 153, 51, 255 }));
  CHECK_EQUAL(render(stage.Window).At(27, 25), (Pixel{ 153, 0, 0 }));
  table->SetTableValue(3, 1, 1, 1);
  CHECK_EQUAL(render(stage.Window).At(27, 15), (Pixel{ 255, 255, 255 }));
  CHECK_EQUAL(messages.GetText(), std::string());

  // Lightmaps on a third set have no place left.
  vtkNew<vtkFloatArray> baked;
  baked->DeepCopy(stage.Data->GetPointData()->GetTCoords());
  baked->SetName("baked");
  stage.Data->GetPointData()->AddArray(baked);
  stage.Property->SetLightmapTexture(makeTexture(1, 1, 1, { 255 }));
  stage.Property->SetLightmapTCoords("baked");
  stage.Center();
  CHECK_EQUAL(messages.Count("the third to read texture coordinates"), 1);

  // Interpolated colours, where light is interpolated too.
  stage.Property->SetLightmapTexture(nullptr);
  stage.Actor->SetTexture(nullptr);
  stage.Property->SetShadingFrequencyToGouraud();
  const Pixel mixed = stage.Center();
  stage.Mapper->InterpolateScalarsBeforeMappingOff();
  CHECK_EQUAL(stage.Center(), mixed);
}

// Images are loaded again when something was modified, and only then.
void checkCaching()
{
  TexturedStage stage;
  const vtkSmartPointer<vtkTexture> texture = makeTexture(1, 1, 1, { 10 });
  stage.Actor->SetTexture(texture);
  CHECK_EQUAL(stage.Center(), (Pixel{ 10, 10, 10 }));
  vtkUnsignedCharArray* const mapped = texture->GetMappedScalars();
  CHECK_EQUAL(stage.Center(), (Pixel{ 10, 10, 10 }));
  CHECK(texture->GetMappedScalars() == mapped);

  vtkImageData* const image = texture->GetInput();
  image->SetScalarComponentFromDouble(0, 0, 0, 0, 30);
  image->GetPointData()->GetScalars()->Modified();
  CHECK_EQUAL(stage.Center(), (Pixel{ 30, 30, 30 }));
  vtkNew<vtkLookupTable> table;
  table->SetRange(0, 255);
  table->SetTableRange(0, 255);
  table->SetHueRange(0, 0);
  table->SetSaturationRange(0, 0);
  table->SetValueRange(0, 1);
  texture->SetLookupTable(table);
  texture->SetColorModeToMapScalars();
  const Pixel grey = stage.Center();
  table->SetValueRange(1, 0);
  CHECK(stage.Center() != grey);

  // Another texture at the same place in memory is another texture.
  for (int value : { 1, 2, 3, 4, 5 })
  {
    stage.Actor->SetTexture(makeTexture(1, 1, 1, { double(value) }));
    CHECK_EQUAL(stage.Center(), (Pixel{ value, value, value }));
  }
}

// Two actors of one mapper, each with its own texture, and what a selection sees.
void checkSharedMapper()
{
  TexturedStage stage;
  stage.Actor->SetTexture(makeTexture(1, 1, 1, { 10 }));
  vtkNew<vtkLimnActor> other;
  other->SetMapper(stage.Mapper);
  other->GetProperty()->LightingOff();
  other->SetTexture(makeTexture(1, 1, 1, { 20 }));
  other->SetPosition(0, 40, 0);
  stage.Renderer->AddActor(other);
  const Picture picture = render(stage.Window);
  CHECK_EQUAL(picture.At(20, 20), (Pixel{ 10, 10, 10 }));
  CHECK_EQUAL(picture.At(20, 60), (Pixel{ 20, 20, 20 }));
}

void checkTCoords()
{
  TexturedStage stage;
  stage.Actor->SetTexture(makeNumbered(5, 4));
  const Picture expected = render(stage.Window);
  vtkNew<vtkDoubleArray> doubles;
  doubles->DeepCopy(stage.Data->GetPointData()->GetTCoords());
  stage.Data->GetPointData()->SetTCoords(doubles);
  CHECK(render(stage.Window) == expected);

  // One component is u.
  vtkNew<vtkFloatArray> single;
  single->SetNumberOfComponents(1);
  single->SetNumberOfTuples(8);
  single->CopyComponent(0, doubles, 0);
  stage.Data->GetPointData()->SetTCoords(single);
  CHECK_EQUAL(render(stage.Window).At(14, 28), (Pixel{ 11, 20, 200 }));

  Messages messages;
  doubles->SetComponent(1, 0, vtkMath::Nan());
  doubles->SetComponent(2, 1, vtkMath::Inf());
  stage.Data->GetPointData()->SetTCoords(doubles);
  CHECK_EQUAL(render(stage.Window).At(50, 20), expected.At(50, 20));
  render(stage.Window);
  CHECK_EQUAL(messages.Count("2 texture coordinates are not finite numbers"), 1);

  messages.Forget();
  stage.Data->GetPointData()->SetTCoords(nullptr);
  CHECK_EQUAL(stage.Center(), (Pixel{ 255, 255, 255 }));
  CHECK_EQUAL(stage.Center(), (Pixel{ 255, 255, 255 }));
  CHECK_EQUAL(messages.Count("vtkTextureMapToPlane"), 1);
}

// The surface is drawn without, and the texture says why, once.
void checkBrokenImages()
{
  vtkNew<vtkImageData> empty;
  vtkNew<vtkImageData> bare;
  bare->SetDimensions(2, 2, 1);
  vtkNew<vtkImageData> solid;
  solid->SetDimensions(2, 2, 2);
  solid->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  vtkNew<vtkImageData> truncated;
  truncated->SetDimensions(4, 4, 1);
  vtkNew<vtkUnsignedCharArray> few;
  few->SetNumberOfComponents(3);
  few->SetNumberOfTuples(5);
  truncated->GetPointData()->SetScalars(few);
  vtkNew<vtkImageData> wild;
  wild->SetDimensions(1, 1, 1);
  wild->AllocateScalars(VTK_FLOAT, 3);
  wild->SetScalarComponentFromDouble(0, 0, 0, 1, vtkMath::Nan());
  const struct
  {
    vtkImageData* image;
    const char* complaint;
  } cases[] = {
    { nullptr, "It has no image" },
    { empty, "no scalars" },
    { bare, "no scalars" },
    { solid, "three dimensions" },
    { truncated, "15 bytes of 48" },
    { wild, "texel (0, 0)" },
  };
  for (const auto& one : cases)
  {
    TexturedStage stage;
    vtkNew<vtkTexture> texture;
    texture->SetColorModeToDirectScalars();
    if (one.image)
    {
      texture->SetInputData(one.image);
    }
    stage.Actor->SetTexture(texture);
    stage.Actor->ForceOpaqueOn();
    Messages messages;
    CHECK_EQUAL(stage.Center(), (Pixel{ 255, 255, 255 }));
    CHECK_EQUAL(stage.Center(), (Pixel{ 255, 255, 255 }));
    CHECK_EQUAL(messages.Count("drawn without this texture"), 1);
    CHECK_EQUAL(messages.Count(one.complaint), 1);
  }
}

void checkValues()
{
  const double nan = vtkMath::Nan();
  const std::pair<const char*, std::function<void(vtkLimnProperty*)>> cases[] = {
    { "BumpScale", [nan](vtkLimnProperty* property) { property->SetBumpScale(nan); } },
    { "LightmapIntensity",
      [nan](vtkLimnProperty* property) { property->SetLightmapIntensity(nan); } },
    { "NormalScale", [nan](vtkLimnProperty* property) { property->SetNormalScale(nan); } },
    { "ProceduralScale",
      [](vtkLimnProperty* property)
      {
        property->SetProceduralTextureToWood();
        property->SetProceduralScale(0);
      } },
  };
  for (const auto& [name, spoil] : cases)
  {
    TexturedStage stage;
    spoil(stage.Property);
    Messages messages;
    CHECK_EQUAL(stage.Center(), (Pixel{ 0, 0, 0 }));
    CHECK_EQUAL(messages.Count("Not drawn:"), 1);
    CHECK(messages.Count(name) >= 1);
  }
}

void checkMissing()
{
  const std::pair<const char*, std::function<void(TexturedStage&)>> cases[] = {
    { "textures with transparent texels",
      [](TexturedStage& stage)
      {
        stage.Actor->ForceOpaqueOn();
        stage.Actor->SetTexture(makeTexture(1, 1, 4, { 255, 255, 255, 128 }));
      } },
    { "seamless texture coordinates", [](TexturedStage& stage) { stage.Mapper->SeamlessUOn(); } },
    { "projective texture transforms",
      [](TexturedStage& stage)
      {
        vtkNew<vtkTransform> transform;
        const double rows[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 1 };
        transform->SetMatrix(rows);
        stage.Actor->GetTexture()->SetTransform(transform);
      } },
    { "textures of roughness and emission",
      [](TexturedStage& stage)
      {
        stage.Property->SetInterpolationToPBR();
        stage.Property->SetORMTexture(makeTexture(1, 1, 3, { 9, 9, 9 }));
      } },
  };
  for (const auto& [feature, ask] : cases)
  {
    TexturedStage stage;
    stage.Actor->SetTexture(makeTexture(1, 1, 1, { 255 }));
    ask(stage);
    Messages messages;
    CHECK(render(stage.Window).CountOtherThan({ 0, 0, 0 }) == 800);
    CHECK_EQUAL(messages.Count(std::string("asks for ") + feature), 1);
  }
}

void checkCopy()
{
  const vtkSmartPointer<vtkTexture> texture = makeTexture(1, 1, 1, { 9 });
  const int references = texture->GetReferenceCount();
  {
    vtkNew<vtkLimnProperty> original;
    original->SetTexture("any", texture);
    original->SetBumpTexture(texture);
    original->SetLightmapTCoords("baked");
    vtkNew<vtkLimnProperty> copy;
    copy->DeepCopy(original);
    CHECK(copy->GetTexture("any") == texture);
    CHECK(copy->GetBumpTexture() == texture);
    CHECK_EQUAL(std::string(copy->GetLightmapTCoords()), "baked");
    CHECK_EQUAL(texture->GetReferenceCount(), references + 4);
  }
  CHECK_EQUAL(texture->GetReferenceCount(), references);
}
}

int TestLimnTextures(int, char*[])
{
  checkTexels();
  checkRepetition();
  checkFilter();
  checkTransform();
  checkImages();
  checkModes();
  checkBlending();
  checkRoles();
  checkLightmap();
  checkBumps();
  checkNormalMap();
  checkProcedural();
  checkScalars();
  checkCaching();
  checkSharedMapper();
  checkTCoords();
  checkBrokenImages();
  checkValues();
  checkMissing();
  checkCopy();
  return result();
}
