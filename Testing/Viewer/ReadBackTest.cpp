// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How well values can be read off a toned surface, by its legend: a sphere whose faces have random
// values is drawn, and each pixel's value is that of the nearest of 128 colours of the map, in
// CIELAB by double precision. The table that this prints is in Rendering/MODELS.md.
#include "Colormap.h"

#include "vtkLimnActor.h"
#include "vtkLimnPolyDataMapper.h"
#include "vtkLimnProperty.h"
#include "vtkLimnRenderWindow.h"
#include "vtkLimnRenderer.h"
#include "vtkLimnToneLegend.h"

#include <gtest/gtest.h>

#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <memory>
#include <random>
#include <vector>

namespace limn::viewer
{
namespace
{

using Lab = std::array<double, 3>;

Lab labOf(const unsigned char* bytes)
{
  constexpr double kToXyz[3][3] = { { 0.4124564, 0.3575761, 0.1804375 },
    { 0.2126729, 0.7151522, 0.0721750 }, { 0.0193339, 0.1191920, 0.9503041 } };
  double root[3];
  for (int i = 0; i < 3; ++i)
  {
    double value = 0;
    double white = 0;
    for (int k = 0; k < 3; ++k)
    {
      const double c = bytes[k] / 255.0;
      value += kToXyz[i][k] * (c > 0.04045 ? std::pow((c + 0.055) / 1.055, 2.4) : c / 12.92);
      white += kToXyz[i][k];
    }
    const double t = value / white;
    root[i] = t > std::pow(6.0 / 29, 3) ? std::cbrt(t) : t * 841 / 108 + 4.0 / 29;
  }
  return { 116 * root[1] - 16, 500 * (root[0] - root[1]), 200 * (root[1] - root[2]) };
}

double distance2(const Lab& a, const Lab& b)
{
  return (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) +
         (a[2] - b[2]) * (a[2] - b[2]);
}

/// The unit sphere, a value of its own in each face of about a pixel.
vtkSmartPointer<vtkPolyData> speckledSphere()
{
  constexpr int kRings = 120;
  constexpr int kSectors = 240;
  const double pi = std::acos(-1.0);
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  for (int j = 0; j <= kRings; ++j)
  {
    for (int i = 0; i < kSectors; ++i)
    {
      const double u = 2 * pi * i / kSectors;
      const double v = pi * j / kRings;
      const double p[3] = { std::sin(v) * std::cos(u), std::cos(v), -std::sin(v) * std::sin(u) };
      points->InsertNextPoint(p);
      normals->InsertNextTuple(p);
    }
  }
  std::mt19937 random(5);
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkFloatArray> values;
  for (vtkIdType j = 0; j < kRings; ++j)
  {
    for (vtkIdType i = 0; i < kSectors; ++i)
    {
      const vtkIdType next = (i + 1) % kSectors;
      const vtkIdType quad[4] = { j * kSectors + i, (j + 1) * kSectors + i,
        (j + 1) * kSectors + next, j * kSectors + next };
      cells->InsertNextCell(4, quad);
      values->InsertNextValue(static_cast<float>(static_cast<double>(random()) / 4294967296.0));
    }
  }
  vtkSmartPointer<vtkPolyData> sphere = vtkSmartPointer<vtkPolyData>::New();
  sphere->SetPoints(points);
  sphere->SetPolys(cells);
  sphere->GetPointData()->SetNormals(normals);
  sphere->GetCellData()->SetScalars(values);
  return sphere;
}

enum class Lit
{
  FromTheEye,
  From45Degrees
};

/// Looks at the sphere in parallel projection, 90 pixels in radius.
class SpeckledSphere : public ::testing::Test
{
protected:
  static constexpr int kSide = 200;

  SpeckledSphere()
  {
    window_->SetSize(kSide, kSide);
    window_->SetMultiSamples(0);
    window_->AddRenderer(renderer_);
    mapper_->SetInputData(sphere_);
    actor_->SetMapper(mapper_);
    actor_->SetProperty(property_);
    renderer_->AddActor(actor_);
    vtkCamera* const camera = renderer_->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(kSide / 180.0);
    camera->SetPosition(0, 0, 5);
    camera->SetFocalPoint(0, 0, 0);
    renderer_->ResetCameraClippingRange();
    renderer_->AutomaticLightCreationOff();
    property_->SetShadingFrequencyToPhong();
    findFaces();
  }

  /// How far off the values are on average that are read off the picture.
  double error(const std::string& map, Lit lit)
  {
    const auto table = makeColormap(map, { 0, 1 });
    mapper_->SetLookupTable(table);
    mapper_->UseLookupTableScalarRangeOn();
    light(lit);
    std::vector<Lab> legend;
    for (int i = 0; i < 128; ++i)
    {
      legend.push_back(labOf(table->MapValue(i / 127.0)));
    }
    const std::vector<unsigned char> picture = draw();
    double sum = 0;
    int count = 0;
    for (std::size_t pixel = 0; pixel < faces_.size(); ++pixel)
    {
      if (faces_[pixel] < 0)
      {
        continue;
      }
      const Lab seen = labOf(&picture[3 * pixel]);
      const auto nearest = std::min_element(legend.begin(), legend.end(),
        [&](const Lab& a, const Lab& b) { return distance2(a, seen) < distance2(b, seen); });
      const double value = static_cast<double>(nearest - legend.begin()) / 127;
      sum +=
        std::fabs(value - sphere_->GetCellData()->GetScalars()->GetComponent(faces_[pixel], 0));
      ++count;
    }
    EXPECT_GT(count, 20000);
    return sum / count;
  }

  vtkNew<vtkLimnProperty> property_;

private:
  void light(Lit lit)
  {
    renderer_->RemoveAllLights();
    vtkNew<vtkLight> light;
    if (lit == Lit::FromTheEye)
    {
      light->SetLightTypeToHeadlight();
    }
    else
    {
      light->SetLightTypeToSceneLight();
      light->SetPosition(0, 1, 1);
      light->SetFocalPoint(0, 0, 0);
    }
    renderer_->AddLight(light);
  }

  std::vector<unsigned char> draw()
  {
    window_->Render();
    const std::unique_ptr<unsigned char[]> bytes(
      window_->GetPixelData(0, 0, kSide - 1, kSide - 1, 1));
    return { bytes.get(), bytes.get() + 3 * kSide * kSide };
  }

  /// Which face each pixel shows, by a picture whose colours are their numbers.
  void findFaces()
  {
    const vtkIdType count = sphere_->GetNumberOfCells();
    vtkSmartPointer<vtkDataArray> values = sphere_->GetCellData()->GetScalars();
    vtkNew<vtkUnsignedCharArray> numbers;
    numbers->SetNumberOfComponents(3);
    for (vtkIdType i = 1; i <= count; ++i)
    {
      for (const vtkIdType byte : { i % 256, i / 256 % 256, i / 65536 })
      {
        numbers->InsertNextValue(static_cast<unsigned char>(byte));
      }
    }
    sphere_->GetCellData()->SetScalars(numbers);
    property_->LightingOff();
    light(Lit::FromTheEye);
    const std::vector<unsigned char> picture = draw();
    for (std::size_t pixel = 0; 3 * pixel < picture.size(); ++pixel)
    {
      const unsigned char* const c = &picture[3 * pixel];
      faces_.push_back(c[0] + 256 * c[1] + 65536 * c[2] - 1);
    }
    property_->LightingOn();
    sphere_->GetCellData()->SetScalars(values);
  }

  vtkSmartPointer<vtkPolyData> sphere_ = speckledSphere();
  vtkNew<vtkLimnPolyDataMapper> mapper_;
  vtkNew<vtkLimnActor> actor_;
  vtkNew<vtkLimnRenderer> renderer_;
  vtkNew<vtkLimnRenderWindow> window_;
  std::vector<int> faces_; ///< by pixel; -1: none
};

struct Mode
{
  const char* name;
  void (*set)(vtkLimnProperty*);
};

void setUndertone(vtkLimnProperty* property, double share)
{
  property->SetToneToGooch();
  property->SetToneOverDataToUndertone();
  property->SetUndertone(share);
}
void setLegendSafe(vtkLimnProperty* property, double range)
{
  property->SetToneToGooch();
  property->SetToneOverDataToLegendSafe();
  property->SetLegendSafeRange(range);
}

const Mode kModes[] = {
  { "unlit", [](vtkLimnProperty* p) { p->SetReflectionModelToNone(); } },
  { "Lambert", [](vtkLimnProperty* p) { p->SetReflectionModelToLambert(); } },
  { "Gooch, classic", [](vtkLimnProperty* p) { p->SetToneToGooch(); } },
  { "undertone 25 %", [](vtkLimnProperty* p) { setUndertone(p, 0.25); } },
  { "undertone 12 %", [](vtkLimnProperty* p) { setUndertone(p, 0.12); } },
  { "legend-safe 12", [](vtkLimnProperty* p) { setLegendSafe(p, 12); } },
  { "legend-safe 6", [](vtkLimnProperty* p) { setLegendSafe(p, 6); } },
};

const char* const kMaps[] = { "viridis", "cool-warm", "rainbow", "black-body", "grayscale" };

TEST_F(SpeckledSphere, LegendSafeTonesKeepValuesReadable)
{
  std::cout << "| map, light |";
  for (const Mode& mode : kModes)
  {
    std::cout << ' ' << mode.name << " |";
  }
  std::cout << '\n' << std::fixed << std::setprecision(1);
  for (const std::string map : kMaps)
  {
    for (const Lit lit : { Lit::FromTheEye, Lit::From45Degrees })
    {
      std::cout << "| " << map << (lit == Lit::FromTheEye ? ", headlight |" : ", 45 degrees |");
      for (const Mode& mode : kModes)
      {
        vtkNew<vtkLimnProperty> fresh;
        property_->DeepCopy(fresh);
        property_->SetShadingFrequencyToPhong();
        mode.set(property_);
        const double found = error(map, lit);
        std::cout << ' ' << 100 * found << " % |";
        const std::string name = mode.name;
        const bool isSafe = name == "legend-safe 12" || name == "legend-safe 6";
        if (isSafe)
        {
          EXPECT_LE(found, 0.04) << map << ' ' << name;
        }
        if (name == "Gooch, classic" && (map == "viridis" || map == "cool-warm"))
        {
          EXPECT_GE(found, 0.16) << map;
          EXPECT_LE(found, 0.21) << map;
        }
        if (name == "unlit")
        {
          EXPECT_LT(found, 0.005) << map;
        }
      }
      std::cout << '\n';
    }
  }
}

/// The values of a grey scale are its lightness, so that tone and value are told apart by nothing:
/// w = 12 would be 12 % of the range at the most and 8 % on average.
TEST_F(SpeckledSphere, AGreyScaleHasRoomForHalfTheTone)
{
  const double range =
    vtkLimnToneLegend::FindLegendSafeRange(makeColormap("grayscale", { 0, 1 }), 0.038);
  EXPECT_GE(range, 5);
  EXPECT_LE(range, 7);
  for (const Lit lit : { Lit::FromTheEye, Lit::From45Degrees })
  {
    setLegendSafe(property_, range);
    const double bounded = error("grayscale", lit);
    setLegendSafe(property_, 50);
    EXPECT_NEAR(error("grayscale", lit), bounded, 0.002);
    setLegendSafe(property_, range / 2);
    EXPECT_LT(error("grayscale", lit), 0.7 * bounded);
  }
}

/// The prediction is of the legend's own colours, 128 values and 32 tones; it holds for the
/// picture.
TEST_F(SpeckledSphere, TheLegendPredictsTheError)
{
  std::cout << std::fixed << std::setprecision(1);
  for (const std::string map : kMaps)
  {
    const auto table = makeColormap(map, { 0, 1 });
    std::cout << "| " << map << " | " << vtkLimnToneLegend::FindLegendSafeRange(table, 0.04)
              << " |\n";
    for (const double range : { 6, 12, 20 })
    {
      setLegendSafe(property_, range);
      vtkNew<vtkLimnToneLegend> legend;
      legend->SetLookupTable(table);
      legend->SetSurfaceProperty(property_);
      EXPECT_NEAR(legend->GetReadBackError(), error(map, Lit::FromTheEye), 0.004) << map << range;
    }
  }
}

} // namespace
} // namespace limn::viewer
