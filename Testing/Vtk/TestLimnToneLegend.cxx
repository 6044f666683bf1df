// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The legend of value and tone has the colours of surfaces, and tones find colours of data however
// they are mapped.
#include "Check.h"
#include "Messages.h"
#include "Picture.h"
#include "Stage.h"

#include "vtkLimnProperty.h"
#include "vtkLimnToneLegend.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkLookupTable.h"
#include "vtkPointData.h"
#include "vtkSphereSource.h"

#include <cmath>
#include <limits>

namespace
{
constexpr int Side = 200;
constexpr double Radius = 90; // in pixels

vtkSmartPointer<vtkLookupTable> makeTable()
{
  vtkSmartPointer<vtkLookupTable> table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(4);
  table->SetTableValue(0, 0.2, 0.4, 0.7);
  table->SetTableValue(1, 0.5, 0.5, 0.5);
  table->SetTableValue(2, 0.8, 0.3, 0.2);
  table->SetTableValue(3, 1, 1, 1);
  table->SetTableRange(0, 4);
  return table;
}

/// A sphere of one value, lit from the eye.
struct ToneStage : Stage
{
  vtkNew<vtkLimnProperty> Property;
  vtkSmartPointer<vtkPolyData> Sphere;
  vtkSmartPointer<vtkLookupTable> Table = makeTable();

  ToneStage()
  {
    vtkNew<vtkSphereSource> source;
    source->SetRadius(1);
    source->SetThetaResolution(200);
    source->SetPhiResolution(200);
    source->Update();
    this->Sphere = source->GetOutput();
    vtkNew<vtkFloatArray> values;
    values->SetNumberOfValues(this->Sphere->GetNumberOfPoints());
    this->Sphere->GetPointData()->SetScalars(values);
    this->Mapper->SetInputData(this->Sphere);
    this->Mapper->SetLookupTable(this->Table);
    this->Mapper->UseLookupTableScalarRangeOn();
    this->Actor->SetProperty(this->Property);
    this->Window->SetSize(Side, Side);
    this->Window->SetMultiSamples(0);
    vtkCamera* const camera = this->Renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(Side / (2 * Radius));
    camera->SetPosition(0, 0, 5);
    this->Renderer->ResetCameraClippingRange();
  }
  /// Of the table, 0 to 3.
  void SetValue(int entry)
  {
    auto* values = vtkFloatArray::SafeDownCast(this->Sphere->GetPointData()->GetScalars());
    values->FillComponent(0, entry + 0.5);
    values->Modified();
  }
};

int worst(const Pixel& a, const Pixel& b)
{
  int most = 0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    most = std::max(most, std::abs(a[i] - b[i]));
  }
  return most;
}

Pixel pixelOf(vtkImageData* image, int x, int y)
{
  const auto* const c = static_cast<const unsigned char*>(image->GetScalarPointer(x, y, 0));
  return { c[0], c[1], c[2] };
}

/// Every pixel of the sphere, but for the steepest, is in the legend at its value and its l.n.
void checkColorsOfASphere(ToneStage& stage)
{
  constexpr int Tones = 1000;
  vtkNew<vtkLimnToneLegend> legend;
  legend->SetLookupTable(stage.Table);
  legend->SetSurfaceProperty(stage.Property);
  legend->SetNumberOfValues(4);
  legend->SetNumberOfTones(Tones);
  vtkImageData* const image = legend->GetImage();
  CHECK(image != nullptr);
  CHECK_EQUAL(image->GetDimensions()[0], 4);
  CHECK_EQUAL(image->GetDimensions()[1], Tones);
  for (int entry = 0; entry < 4; ++entry)
  {
    stage.SetValue(entry);
    const Picture picture = render(stage.Window);
    int compared = 0;
    int most = 0;
    for (int y = 0; y < Side; ++y)
    {
      for (int x = 0; x < Side; ++x)
      {
        const double px = (x + 0.5 - Side / 2) / Radius;
        const double py = (y + 0.5 - Side / 2) / Radius;
        const double cosine = std::sqrt(1 - std::min(1.0, px * px + py * py));
        if (cosine < 0.3)
        {
          continue;
        }
        const int row = static_cast<int>((cosine + 1) / 2 * Tones);
        most =
          std::max(most, worst(picture.At(x, y), pixelOf(image, entry, std::min(row, Tones - 1))));
        ++compared;
      }
    }
    CHECK(compared > 20000);
    CHECK(most <= 1);
  }
}

void checkEachMode()
{
  ToneStage stage;
  stage.Property->SetToneToGooch();
  checkColorsOfASphere(stage);
  stage.Property->SetToneOverDataToUndertone();
  checkColorsOfASphere(stage);
  stage.Property->SetToneOverDataToLegendSafe();
  checkColorsOfASphere(stage);
  stage.Property->SetToneToGoochChapter();
  checkColorsOfASphere(stage);
  // A legend has no detail.
  stage.Property->SetToneToExaggerated();
  stage.Property->SetExaggerationBase(1);
  checkColorsOfASphere(stage);
}

/// Scalars that are interpolated before they are mapped come as a texture.
void checkInterpolatedScalars()
{
  ToneStage stage;
  stage.SetValue(2);
  stage.Property->SetToneToGooch();
  stage.Property->SetToneOverDataToLegendSafe();
  const Picture mapped = render(stage.Window);
  stage.Mapper->InterpolateScalarsBeforeMappingOn();
  const Picture looked = render(stage.Window);
  // A mixture of three equal bytes may be a rounding off them.
  CHECK_EQUAL(looked.CountDifferent(mapped, 1), 0);
  stage.Property->SetToneOverDataToClassic();
  CHECK(render(stage.Window).CountDifferent(mapped, 4) > 10000);
}

void checkUpdates()
{
  vtkNew<vtkLimnToneLegend> legend;
  vtkNew<vtkLimnProperty> property;
  const vtkSmartPointer<vtkLookupTable> table = makeTable();
  legend->SetLookupTable(table);
  legend->SetSurfaceProperty(property);
  property->SetToneToGooch();
  vtkImageData* const image = legend->GetImage();
  CHECK_EQUAL(image->GetDimensions()[0], 256);
  CHECK_EQUAL(image->GetDimensions()[1], 64);
  const vtkMTimeType time = image->GetMTime();
  CHECK(legend->GetImage()->GetMTime() == time);
  const Pixel classic = pixelOf(image, 0, 63);
  property->SetToneOverDataToLegendSafe();
  CHECK(worst(pixelOf(legend->GetImage(), 0, 63), classic) > 0);
  const Pixel before = pixelOf(image, 0, 63);
  table->SetTableValue(0, 0, 0.5, 0);
  CHECK(worst(pixelOf(legend->GetImage(), 0, 63), before) > 0);
  // What a legend has none of.
  property->SetToneOverDataToClassic();
  const Pixel plain = pixelOf(legend->GetImage(), 100, 32);
  property->SetOpacity(0.5);
  property->SetSpecular(1);
  property->SetOutlineToNormal();
  property->SetOutlineThreshold(1);
  CHECK_EQUAL(pixelOf(legend->GetImage(), 100, 32), plain);
  legend->SetNumberOfTones(0);
  CHECK_EQUAL(legend->GetNumberOfTones(), 1);
  CHECK_EQUAL(legend->GetImage()->GetDimensions()[1], 1);
}

/// A row shows what is in its middle: of two rows l.n of -1/2 and 1/2.
void checkRows()
{
  vtkNew<vtkLimnProperty> property;
  property->SetToneToGooch();
  vtkNew<vtkLimnToneLegend> fine;
  vtkNew<vtkLimnToneLegend> coarse;
  for (vtkLimnToneLegend* const legend : { fine.Get(), coarse.Get() })
  {
    legend->SetLookupTable(makeTable());
    legend->SetSurfaceProperty(property);
    legend->SetNumberOfValues(4);
  }
  fine->SetNumberOfTones(1000);
  coarse->SetNumberOfTones(2);
  for (int entry = 0; entry < 4; ++entry)
  {
    const Pixel averted = pixelOf(coarse->GetImage(), entry, 0);
    const Pixel facing = pixelOf(coarse->GetImage(), entry, 1);
    CHECK(worst(averted, pixelOf(fine->GetImage(), entry, 250)) <= 1);
    CHECK(worst(facing, pixelOf(fine->GetImage(), entry, 750)) <= 1);
  }
}

/// The lightest that the legend has of grey, with entries from `dark` to `light` in the table.
int lightestGrey(double dark, double light, double range)
{
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(256);
  for (int i = 0; i < 256; ++i)
  {
    const double grey = dark + (light - dark) * i / 255;
    table->SetTableValue(i, grey, grey, grey);
  }
  vtkNew<vtkLimnProperty> property;
  property->SetToneToGooch();
  property->SetToneOverDataToLegendSafe();
  property->SetLegendSafeRange(range);
  vtkNew<vtkLimnToneLegend> legend;
  legend->SetLookupTable(table);
  legend->SetSurfaceProperty(property);
  return pixelOf(legend->GetImage(), 128, 63)[0];
}

/// One grey alone is misread without a tone, too; of a scale the tone may add but a little.
void checkBound()
{
  CHECK(lightestGrey(0.5, 0.5, 24) > lightestGrey(0.5, 0.5, 12) + 20);
  CHECK(lightestGrey(0, 1, 12) > lightestGrey(0, 1, 2));
  CHECK(lightestGrey(0, 1, 24) <= lightestGrey(0, 1, 12) + 1);
}

void checkErrors()
{
  Messages messages;
  vtkNew<vtkLimnToneLegend> legend;
  CHECK(legend->GetImage() == nullptr);
  CHECK(messages.GetText().find("LookupTable and a SurfaceProperty") != std::string::npos);
  CHECK(legend->GetReadBackError() < 0);
  vtkNew<vtkLimnProperty> property;
  property->SetUndertone(std::numeric_limits<double>::quiet_NaN());
  legend->SetLookupTable(makeTable());
  legend->SetSurfaceProperty(property);
  CHECK(legend->GetImage() == nullptr);
  CHECK(messages.GetText().find("Undertone") != std::string::npos);
  CHECK_EQUAL(vtkLimnToneLegend::FindLegendSafeRange(nullptr, 0.04), 0.0);
  for (const double error :
    { std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), -0.01 })
  {
    CHECK_EQUAL(vtkLimnToneLegend::FindLegendSafeRange(makeTable(), error), 0.0);
  }
  CHECK_EQUAL(messages.Count("No range of lightness"), 3);
}

void checkCopy()
{
  vtkNew<vtkLimnToneLegend> legend;
  vtkNew<vtkLimnProperty> property;
  legend->SetLookupTable(makeTable());
  legend->SetSurfaceProperty(property);
  legend->SetNumberOfValues(7);
  legend->SetPosition(0.3, 0.4);
  vtkNew<vtkLimnToneLegend> copy;
  copy->ShallowCopy(legend);
  CHECK(copy->GetLookupTable() == legend->GetLookupTable());
  CHECK(copy->GetSurfaceProperty() == property.Get());
  CHECK_EQUAL(copy->GetNumberOfValues(), 7);
  CHECK_EQUAL(copy->GetPosition()[0], 0.3);
}
}

int TestLimnToneLegend(int, char*[])
{
  checkEachMode();
  checkInterpolatedScalars();
  checkUpdates();
  checkRows();
  checkBound();
  checkErrors();
  checkCopy();
  return result();
}
