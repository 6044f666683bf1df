// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// From cells and arrays of a vtkPolyData to pixels.
#include "Check.h"
#include "Picture.h"
#include "Stage.h"

#include "vtkLimnProperty.h"

#include "vtkCellData.h"
#include "vtkCubeSource.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLookupTable.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <set>

namespace
{
const Pixel Black = { 0, 0, 0 };
const Pixel White = { 255, 255, 255 };

vtkSmartPointer<vtkUnsignedCharArray> rgbArray(std::initializer_list<Pixel> colors)
{
  auto array = vtkSmartPointer<vtkUnsignedCharArray>::New();
  array->SetNumberOfComponents(3);
  for (const Pixel& color : colors)
  {
    array->InsertNextTuple3(color[0], color[1], color[2]);
  }
  return array;
}

vtkSmartPointer<vtkFloatArray> vectorArray(std::initializer_list<std::array<double, 3>> vectors)
{
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetNumberOfComponents(3);
  for (const auto& v : vectors)
  {
    array->InsertNextTuple3(v[0], v[1], v[2]);
  }
  return array;
}

Picture draw(vtkPolyData* data, void (*arrange)(Stage&) = nullptr)
{
  Stage stage;
  stage.LookFlat();
  stage.Mapper->SetInputData(data);
  if (arrange)
  {
    arrange(stage);
  }
  return render(stage.Window);
}

void checkPolygonsAndStrips()
{
  CHECK_EQUAL(draw(twoSquares()).CountOtherThan(Black), 800);

  // The same squares as strips; all of their triangles face the eye.
  vtkSmartPointer<vtkPolyData> strips = twoSquares();
  strips->SetPolys(nullptr);
  vtkNew<vtkCellArray> cells;
  addCell(cells, { 0, 1, 3, 2 });
  addCell(cells, { 4, 5, 7, 6 });
  strips->SetStrips(cells);
  const auto cullBack = [](Stage& stage) { stage.Actor->GetProperty()->BackfaceCullingOn(); };
  const auto cullFront = [](Stage& stage) { stage.Actor->GetProperty()->FrontfaceCullingOn(); };
  CHECK_EQUAL(draw(strips, cullBack).CountOtherThan(Black), 800);
  CHECK_EQUAL(draw(strips, cullFront).CountOtherThan(Black), 0);

  // A fan from the first point: of this dart only what the fan covers, as VTK does.
  vtkNew<vtkPolyData> pentagon;
  pentagon->SetPoints(flatPoints({ { 10, 10 }, { 50, 10 }, { 50, 30 }, { 30, 50 }, { 10, 30 } }));
  vtkNew<vtkCellArray> one;
  addCell(one, { 0, 1, 2, 3, 4 });
  pentagon->SetPolys(one);
  // 40 x 20 pixels, and a triangle of 40 x 20 / 2 whose edges run through pixel corners.
  const int pixels = draw(pentagon).CountOtherThan(Black);
  CHECK(std::abs(pixels - (800 + 400)) <= 20);
}

void checkPointTypes()
{
  const Picture expected = draw(twoSquares());
  for (int type : { VTK_DOUBLE, VTK_INT, VTK_SHORT })
  {
    vtkSmartPointer<vtkPolyData> data = twoSquares();
    vtkNew<vtkPoints> points;
    points->SetDataType(type);
    points->DeepCopy(data->GetPoints());
    data->SetPoints(points);
    CHECK(draw(data) == expected);
  }
  vtkSmartPointer<vtkPolyData> narrow = twoSquares();
  narrow->GetPolys()->ConvertTo32BitStorage();
  CHECK(draw(narrow) == expected);
}

// Of coplanar polygons the later one is seen.
void checkOrder()
{
  vtkSmartPointer<vtkPolyData> data = twoSquares();
  data->GetPoints()->SetPoint(4, 10, 10, 0);
  data->GetPoints()->SetPoint(5, 30, 10, 0);
  data->GetPoints()->SetPoint(6, 30, 30, 0);
  data->GetPoints()->SetPoint(7, 10, 30, 0);
  data->GetCellData()->SetScalars(rgbArray({ { 255, 0, 0 }, { 0, 255, 0 } }));
  const Picture picture = draw(data);
  CHECK_EQUAL(picture.CountOtherThan(Black), 400);
  CHECK_EQUAL(picture.At(20, 20), (Pixel{ 0, 255, 0 }));
}

void checkCellColors()
{
  vtkSmartPointer<vtkPolyData> data = twoSquares();
  data->GetCellData()->SetScalars(rgbArray({ { 255, 0, 0 }, { 10, 20, 30 } }));
  Picture picture = draw(data);
  CHECK_EQUAL(picture.At(20, 20), (Pixel{ 255, 0, 0 }));
  CHECK_EQUAL(picture.At(50, 20), (Pixel{ 10, 20, 30 }));

  // Vertices and lines come first in VTK's numbering, and a dropped triangle keeps its number.
  vtkNew<vtkCellArray> vertices;
  addCell(vertices, { 0 });
  data->SetVerts(vertices);
  vtkNew<vtkCellArray> polys;
  addCell(polys, { 0, 0, 1 });
  addCell(polys, { 0, 1, 2, 3 });
  addCell(polys, { 4, 5, 6, 7 });
  data->SetPolys(polys);
  data->GetCellData()->SetScalars(
    rgbArray({ { 1, 1, 1 }, { 2, 2, 2 }, { 255, 0, 0 }, { 10, 20, 30 } }));
  picture = draw(data);
  CHECK_EQUAL(picture.At(20, 20), (Pixel{ 255, 0, 0 }));
  CHECK_EQUAL(picture.At(50, 20), (Pixel{ 10, 20, 30 }));
}

void checkPointColors()
{
  vtkSmartPointer<vtkPolyData> data = twoSquares();
  vtkNew<vtkFloatArray> values;
  for (double value : { 0.0, 1.0, 1.0, 0.0, 0.5, 0.5, 0.5, 0.5 })
  {
    values->InsertNextValue(static_cast<float>(value));
  }
  data->GetPointData()->SetScalars(values);
  const auto grey = [](Stage& stage)
  {
    vtkNew<vtkLookupTable> table;
    table->SetNumberOfTableValues(256);
    table->SetValueRange(0, 1);
    table->SetSaturationRange(0, 0);
    table->SetRampToLinear();
    stage.Mapper->SetLookupTable(table);
  };
  const Picture picture = draw(data, grey);
  for (int x = 10; x < 30; ++x)
  {
    const double expected = 255 * (x + 0.5 - 10) / 20;
    CHECK(std::abs(picture.At(x, 20)[0] - expected) <= 1);
  }
  CHECK(std::abs(picture.At(50, 20)[1] - 128) <= 1);
  const auto off = [](Stage& stage) { stage.Mapper->ScalarVisibilityOff(); };
  CHECK_EQUAL(draw(data, off).At(20, 20), White);
}

void checkFieldColor()
{
  vtkSmartPointer<vtkPolyData> data = twoSquares();
  vtkSmartPointer<vtkUnsignedCharArray> colors = rgbArray({ { 1, 2, 3 }, { 40, 50, 60 } });
  colors->SetName("colors");
  data->GetFieldData()->AddArray(colors);
  const auto useField = [](Stage& stage)
  {
    stage.Mapper->SetScalarModeToUseFieldData();
    stage.Mapper->SelectColorArray("colors");
    stage.Mapper->SetFieldDataTupleId(1);
  };
  const Picture picture = draw(data, useField);
  CHECK_EQUAL(picture.At(20, 20), (Pixel{ 40, 50, 60 }));
  CHECK_EQUAL(picture.At(50, 20), (Pixel{ 40, 50, 60 }));
}

// A headlight shows n.z: which normals are used can be read off.
void checkNormals()
{
  vtkSmartPointer<vtkPolyData> data = twoSquares();
  const auto shadeWith = [&](void (*arrange)(Stage&))
  {
    Stage stage;
    stage.LookFlat();
    stage.Actor->GetProperty()->LightingOn();
    stage.Mapper->SetInputData(data);
    arrange(stage);
    return render(stage.Window).At(20, 20)[0];
  };
  const auto smooth = [](Stage&) {};
  const auto flat = [](Stage& stage) { stage.Actor->GetProperty()->SetInterpolationToFlat(); };
  const auto chapterPhong = [](Stage& stage)
  { vtkLimnProperty::SafeDownCast(stage.Actor->GetProperty())->SetShadingFrequencyToPhong(); };
  CHECK_EQUAL(shadeWith(smooth), 255);
  data->GetCellData()->SetNormals(vectorArray({ { 0, 0.6, 0.8 }, { 0, 0, 1 } }));
  CHECK_EQUAL(shadeWith(smooth), 204);
  CHECK_EQUAL(shadeWith(flat), 204);
  // The chapter's Phong interpolates normals of vertices, computed if there are none.
  CHECK_EQUAL(shadeWith(chapterPhong), 255);
  const std::array<double, 3> n = { 0.8, 0, 0.6 };
  data->GetPointData()->SetNormals(vectorArray({ n, n, n, n, n, n, n, n }));
  CHECK_EQUAL(shadeWith(smooth), 153);
  CHECK_EQUAL(shadeWith(flat), 204);
  CHECK_EQUAL(shadeWith(chapterPhong), 153);
  // Arrays that do not fit are not normals.
  data->GetPointData()->SetNormals(vectorArray({ n, n }));
  CHECK_EQUAL(shadeWith(smooth), 204);
}

void checkStyles()
{
  vtkSmartPointer<vtkPolyData> data = twoSquares();
  const auto colorWith = [&](void (*arrange)(vtkLimnProperty*))
  {
    Stage stage;
    stage.LookFlat();
    stage.Mapper->SetInputData(data);
    vtkLimnProperty* property = vtkLimnProperty::SafeDownCast(stage.Actor->GetProperty());
    property->LightingOn();
    property->SetColor(0.4, 0.4, 0.4);
    arrange(property);
    return render(stage.Window).At(20, 20);
  };
  // n = l = v = (0, 0, 1): all warm, (0.4, 0.4, 0) + 0.6 k_d, or all cool, (0, 0, 0.4) + 0.2 k_d.
  CHECK_EQUAL(colorWith([](vtkLimnProperty* p) { p->SetToneToGooch(); }), (Pixel{ 163, 163, 61 }));
  CHECK_EQUAL(
    colorWith([](vtkLimnProperty* p) { p->SetToneToGoochChapter(); }), (Pixel{ 20, 20, 122 }));
  const auto dim = [](vtkLimnProperty* p)
  {
    p->SetReflectionModelToNone();
    p->SetAmbient(0.2);
  };
  // Unlit: k_a + k_d, 0.2 x 0.4 + 0.4.
  CHECK_EQUAL(colorWith(dim), (Pixel{ 122, 122, 122 }));
  const auto shiny = [](vtkLimnProperty* p)
  {
    p->SetReflectionModelToBlinnPhong();
    p->SetSpecular(0.4);
    p->SetSpecularPower(10);
  };
  // n.h = 1: k_d + k_s; SetColor() set the colour of highlights, too.
  CHECK_EQUAL(colorWith(shiny), (Pixel{ 143, 143, 143 }));
  const auto outlined = [](vtkLimnProperty* p)
  {
    p->SetOutlineToNormal();
    p->SetOutlineThreshold(1.0);
    p->SetOutlineColor(0, 1, 0);
  };
  // Only where |n.v| is below the threshold, and here it is 1.
  CHECK_EQUAL(colorWith(outlined), (Pixel{ 102, 102, 102 }));
}

/// A plane that looks at the eye, through what steps and paints its tone.
void checkTones()
{
  vtkNew<vtkImageData> picture;
  picture->SetDimensions(1, 1, 1);
  picture->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  const Pixel ink = { 200, 100, 50 };
  std::copy(ink.begin(), ink.end(), static_cast<unsigned char*>(picture->GetScalarPointer()));
  vtkSmartPointer<vtkPolyData> data = twoSquares();
  const auto colorWith = [&](double light, const std::function<void(vtkLimnProperty*)>& arrange)
  {
    Stage stage;
    stage.LookFlat();
    stage.Mapper->SetInputData(data);
    stage.Renderer->AutomaticLightCreationOff();
    vtkNew<vtkLight> lamp;
    lamp->SetLightTypeToHeadlight();
    lamp->SetIntensity(light);
    stage.Renderer->AddLight(lamp);
    auto* const property = vtkLimnProperty::SafeDownCast(stage.Actor->GetProperty());
    property->LightingOn();
    property->SetColor(1, 0.6, 0.2);
    arrange(property);
    return render(stage.Window).At(20, 20);
  };
  const auto toon = [](vtkLimnProperty* property) { property->SetToneToToon(); };
  const auto toon4 = [](vtkLimnProperty* property)
  {
    property->SetToneToToon();
    property->SetToonBands(4);
  };
  // Three steps from 1/3 and 2/3 on, and four.
  CHECK_EQUAL(colorWith(0.3, toon), (Pixel{ 0, 0, 0 }));
  CHECK_EQUAL(colorWith(0.4, toon), (Pixel{ 128, 76, 26 }));
  CHECK_EQUAL(colorWith(0.7, toon), (Pixel{ 255, 153, 51 }));
  CHECK_EQUAL(colorWith(0.3, toon4), (Pixel{ 85, 51, 17 }));
  const auto ramp = [&](vtkLimnProperty* property)
  {
    property->SetToneToRamp();
    property->SetToonRampImage(picture);
    property->SetColor(1, 1, 1);
  };
  CHECK_EQUAL(colorWith(1, ramp), ink);
  const auto matCap = [&](vtkLimnProperty* property)
  {
    property->SetToneToMatCap();
    property->SetMatCapImage(picture);
    property->SetColor(1, 1, 1);
  };
  CHECK_EQUAL(colorWith(1, matCap), ink);
  const auto hatching = [](vtkLimnProperty* property)
  {
    property->SetToneToHatching();
    property->SetHatchPaper(1, 0.5, 1);
    property->SetHatchDarkest(0);
    property->SetColor(1, 1, 1);
  };
  CHECK_EQUAL(colorWith(1, hatching), (Pixel{ 255, 128, 255 }));
  const auto inked = [](vtkLimnProperty* property)
  {
    property->SetToneToHatching();
    property->SetHatchInk(0.2, 0, 0.4);
    property->SetHatchDarkest(1);
  };
  CHECK_EQUAL(colorWith(0, inked), (Pixel{ 51, 0, 102 }));
  // The plane has no detail, and its light is 1/2 + n.l / 2.
  const auto detail = [](vtkLimnProperty* property)
  {
    property->SetToneToExaggerated();
    property->SetExaggerationBase(0);
  };
  CHECK_EQUAL(colorWith(1, detail), (Pixel{ 128, 76, 26 }));
  const auto base = [](vtkLimnProperty* property)
  {
    property->SetToneToExaggerated();
    property->SetExaggerationBase(1);
  };
  CHECK_EQUAL(colorWith(1, base), (Pixel{ 255, 153, 51 }));
  const auto aside = [](vtkLimnProperty* property)
  {
    property->SetToneToGooch();
    property->SetToneLightToUpperRight();
  };
  // n.l = 0: the mean of (1, 0.76, 0.12) and (0.2, 0.12, 0.44).
  CHECK_EQUAL(colorWith(1, aside), (Pixel{ 153, 112, 71 }));
}

// One property, looked at through all of them in turn: none leaves a trace in the next.
void checkLocalModels()
{
  Stage stage;
  stage.LookFlat();
  stage.Mapper->SetInputData(twoSquares());
  stage.Renderer->SetAmbient(0.5, 0.5, 0.5);
  stage.Renderer->AutomaticLightCreationOff();
  vtkNew<vtkLight> lamp;
  lamp->SetLightTypeToSceneLight();
  lamp->PositionalOn();
  lamp->SetConeAngle(180);
  lamp->SetPosition(20, 20, 1000);
  lamp->SetAttenuationValues(4, 0, 0);
  stage.Renderer->AddLight(lamp);
  auto* const property = vtkLimnProperty::SafeDownCast(stage.Actor->GetProperty());
  property->LightingOn();
  property->SetAmbient(1);
  property->SetColor(0, 0.4, 0);
  property->SetAmbientColor(0.4, 0.2, 0);
  property->SetSpecular(1);
  property->SetSpecularColor(0, 0, 1);
  property->SetFresnel(true);
  property->SetRimColor(1, 1, 1);
  property->SetRimPower(0);
  const auto shows = [&](int model, double r, double g, double b)
  {
    property->SetReflectionModel(model);
    const Pixel pixel = render(stage.Window).At(20, 20);
    const double expected[3] = { r, g, b };
    for (int i = 0; i < 3; ++i)
    {
      CHECK(std::abs(pixel[i] - 255 * expected[i]) < 1.0);
    }
  };
  const double ambient = 0.5 * (0.2126 * 0.4 + 0.7152 * 0.2);
  const double matt = 0.7152 * 0.4;
  const double glossy = 0.0722;
  for (int round = 0; round < 2; ++round)
  {
    const double two = ambient + matt;
    const double three = ambient + matt / 4;
    const double four = ambient + (matt + glossy) / 4;
    shows(vtkLimnProperty::REFLECTION_LOCAL_1, ambient, ambient, ambient);
    shows(vtkLimnProperty::REFLECTION_LOCAL_2, two, two, two);
    shows(vtkLimnProperty::REFLECTION_LOCAL_3, three, three, three);
    shows(vtkLimnProperty::REFLECTION_LOCAL_4, four, four, four);
    shows(
      vtkLimnProperty::REFLECTION_LOCAL_5, 0.2 + glossy / 4, 0.1 + (0.4 + glossy) / 4, glossy / 4);
  }
}

/// A roof of two slopes that meet at x = 50, 45 degrees to the eye each, over the whole window.
vtkSmartPointer<vtkPolyData> roof()
{
  vtkNew<vtkPoints> points;
  const double corners[][3] = { { 0, 0, -0.5 }, { 50, 0, 0.5 }, { 100, 0, -0.5 }, { 0, 80, -0.5 },
    { 50, 80, 0.5 }, { 100, 80, -0.5 } };
  for (const auto& corner : corners)
  {
    points->InsertNextPoint(corner[0], corner[1], 50 * corner[2]);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  vtkNew<vtkCellArray> polys;
  addCell(polys, { 0, 1, 4, 3 });
  addCell(polys, { 1, 2, 5, 4 });
  data->SetPolys(polys);
  return data;
}

/// Six faces on eight points.
vtkSmartPointer<vtkPolyData> sharedCube()
{
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 8; ++i)
  {
    points->InsertNextPoint(i & 1, i >> 1 & 1, i >> 2);
  }
  vtkNew<vtkCellArray> cells;
  for (const std::array<vtkIdType, 4>& face : { std::array<vtkIdType, 4>{ 0, 2, 3, 1 },
         { 4, 5, 7, 6 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 }, { 0, 4, 6, 2 }, { 1, 3, 7, 5 } })
  {
    addCell(cells, { face[0], face[1], face[2], face[3] });
  }
  vtkSmartPointer<vtkPolyData> data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(cells);
  return data;
}

/// Where edges are sharp each face has one colour, whether points are shared and have normals or
/// not.
void checkExaggerationEndsAtSharpEdges()
{
  vtkNew<vtkCubeSource> source;
  source->Update();
  const auto colorsOf = [](vtkPolyData* data, double crease, double feature)
  {
    Stage stage;
    stage.Window->SetMultiSamples(0);
    stage.Mapper->SetInputData(data);
    stage.Renderer->GetActiveCamera()->SetPosition(3, 2, 4);
    stage.Renderer->ResetCamera();
    auto* const property = vtkLimnProperty::SafeDownCast(stage.Actor->GetProperty());
    property->SetShadingFrequencyToPhong();
    property->SetToneToExaggerated();
    property->SetToneLightToUpperRight();
    property->SetCreaseAngle(crease);
    property->SetFeatureAngle(feature);
    const Picture picture = render(stage.Window);
    std::set<Pixel> colors;
    for (int y = 0; y < picture.Height; ++y)
    {
      for (int x = 0; x < picture.Width; ++x)
      {
        colors.insert(picture.At(x, y));
      }
    }
    return static_cast<int>(colors.size());
  };
  const vtkSmartPointer<vtkPolyData> shared = sharedCube();
  for (vtkPolyData* data : { shared.Get(), source->GetOutput() })
  {
    CHECK_EQUAL(colorsOf(data, 40, 180), 4);
    CHECK_EQUAL(colorsOf(data, 180, 40), 4);
  }
  CHECK(colorsOf(shared, 100, 180) > 10);
  CHECK(colorsOf(shared, 40, 100) > 10);
  // Normals of the data say where an edge is smooth.
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < 8; ++i)
  {
    const double* const p = shared->GetPoint(i);
    normals->InsertNextTuple3(p[0] - 0.5, p[1] - 0.5, p[2] - 0.5);
  }
  shared->GetPointData()->SetNormals(normals);
  CHECK(colorsOf(shared, 40, 180) > 10);
  CHECK_EQUAL(colorsOf(shared, 180, 40), 4);
}

int ridgeOf(vtkPolyData* data, void (*arrange)(vtkLimnProperty*))
{
  Stage stage;
  stage.LookFlat();
  stage.Renderer->GetActiveCamera()->SetPosition(50, 40, 60);
  stage.Renderer->GetActiveCamera()->SetClippingRange(1, 100);
  stage.Mapper->SetInputData(data);
  auto* property = vtkLimnProperty::SafeDownCast(stage.Actor->GetProperty());
  property->LightingOn();
  arrange(property);
  return render(stage.Window).At(50, 40)[0];
}

// At the ridge a headlight gives 1 to the mean normal and 0.707 to those of the slopes.
void checkVertexNormals()
{
  const auto phong = [](vtkLimnProperty* property) { property->SetShadingFrequencyToPhong(); };
  const auto sharp = [](vtkLimnProperty* property)
  {
    property->SetShadingFrequencyToPhong();
    property->SetFeatureAngle(89);
  };
  const auto blunt = [](vtkLimnProperty* property)
  {
    property->SetShadingFrequencyToPhong();
    property->SetFeatureAngle(91);
  };
  const auto angle = [](vtkLimnProperty* property)
  {
    property->SetShadingFrequencyToPhong();
    property->SetVertexNormalsToByAngle();
  };
  CHECK(ridgeOf(roof(), phong) >= 253);
  CHECK_EQUAL(ridgeOf(roof(), sharp), 180);
  CHECK(ridgeOf(roof(), blunt) >= 253);

  // Normals of the data win unless others are asked for, then also as VTK shades.
  vtkSmartPointer<vtkPolyData> data = roof();
  vtkSmartPointer<vtkFloatArray> normals = vectorArray({ { 0.6, 0, 0.8 }, { 0.6, 0, 0.8 },
    { 0.6, 0, 0.8 }, { 0.6, 0, 0.8 }, { 0.6, 0, 0.8 }, { 0.6, 0, 0.8 } });
  data->GetPointData()->SetNormals(normals);
  CHECK_EQUAL(ridgeOf(data, phong), 204);
  CHECK(ridgeOf(data, angle) >= 253);
  CHECK_EQUAL(ridgeOf(data, sharp), 180);
  const auto asVtk = [](vtkLimnProperty*) {};
  const auto asVtkByArea = [](vtkLimnProperty* property) { property->SetVertexNormalsToByArea(); };
  CHECK_EQUAL(ridgeOf(data, asVtk), 204);
  CHECK(ridgeOf(data, asVtkByArea) >= 253);
}

// More looks of one surface than are kept from frame to frame.
void checkManyNormalsOfOneMapper()
{
  Stage stage;
  stage.LookFlat();
  stage.Mapper->SetInputData(roof());
  stage.Renderer->GetActiveCamera()->SetPosition(50, 40, 60);
  stage.Renderer->GetActiveCamera()->SetClippingRange(1, 100);
  stage.Actor->VisibilityOff();
  std::vector<vtkSmartPointer<vtkLimnActor>> actors;
  for (int i = 0; i < 12; ++i)
  {
    auto actor = vtkSmartPointer<vtkLimnActor>::New();
    actor->SetMapper(stage.Mapper);
    auto* property = vtkLimnProperty::SafeDownCast(actor->GetProperty());
    property->SetShadingFrequencyToPhong();
    property->SetFeatureAngle(i == 0 ? 89 : 91 + i);
    actor->SetPosition(0, 0, -i);
    stage.Renderer->AddActor(actor);
    actors.push_back(actor);
  }
  CHECK_EQUAL(render(stage.Window).At(50, 40)[0], 180);
  CHECK_EQUAL(render(stage.Window).At(50, 40)[0], 180);
}

// A point light over the corner that comes first, and one over the centre.
void checkFlatPoints()
{
  const auto greyOf = [](double x, double y, int flatPoint)
  {
    Stage stage;
    stage.LookFlat();
    stage.Mapper->SetInputData(twoSquares());
    auto* property = vtkLimnProperty::SafeDownCast(stage.Actor->GetProperty());
    property->LightingOn();
    property->SetShadingFrequencyToFlat();
    property->SetFlatPoint(flatPoint);
    vtkNew<vtkLight> light;
    light->PositionalOn();
    light->SetConeAngle(180);
    light->SetPosition(x, y, 1);
    stage.Renderer->AddLight(light);
    return int{ render(stage.Window).At(20, 20)[0] };
  };
  CHECK_EQUAL(greyOf(10, 10, vtkLimnProperty::FLAT_AT_FIRST_VERTEX), 255);
  CHECK(greyOf(20, 20, vtkLimnProperty::FLAT_AT_FIRST_VERTEX) < 30);
  CHECK_EQUAL(greyOf(20, 20, vtkLimnProperty::FLAT_AT_CENTROID), 255);
}

// As wide as it says around the outside, whatever the camera does; made once for the mesh, and anew
// when its points move.
void checkHull()
{
  Stage stage;
  stage.LookFlat();
  vtkNew<vtkCubeSource> cube;
  cube->SetXLength(20);
  cube->SetYLength(20);
  cube->SetZLength(0.5);
  cube->Update();
  vtkNew<vtkPolyData> data;
  data->DeepCopy(cube->GetOutput());
  stage.Mapper->SetInputData(data);
  stage.Actor->SetPosition(50, 40, 0);
  auto* const property = vtkLimnProperty::SafeDownCast(stage.Actor->GetProperty());
  property->SetColor(1, 0, 0);
  const Picture without = render(stage.Window);
  const int inside = without.CountOtherThan(Black);
  CHECK_EQUAL(inside, 400);
  property->SetOutlineToHull();
  property->SetOutlineColor(0, 1, 0);
  property->SetOutlineWidth(3);
  const auto check = [&](int width)
  {
    const Picture now = render(stage.Window);
    CHECK_EQUAL(now.CountOtherThan(Black), (20 + 2 * width) * (20 + 2 * width));
    CHECK_EQUAL(now.At(50, 40), (Pixel{ 255, 0, 0 }));
    CHECK_EQUAL(now.At(60, 40), (Pixel{ 0, 255, 0 }));
    CHECK_EQUAL(now.At(59 + width, 49 + width), (Pixel{ 0, 255, 0 }));
    CHECK_EQUAL(now.At(60 + width, 40), Black);
  };
  check(3);
  property->SetOutlineWidth(5);
  check(5);
  stage.Renderer->GetActiveCamera()->SetParallelScale(20);
  CHECK_EQUAL(render(stage.Window).CountOtherThan(Black), 50 * 50);
  stage.Renderer->GetActiveCamera()->SetParallelScale(40);
  check(5);
  CHECK_EQUAL(stage.Mapper->GetNumberOfGeometryBuilds(), 1);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    double point[3];
    data->GetPoint(i, point);
    data->GetPoints()->SetPoint(i, 2 * point[0], point[1], point[2]);
  }
  data->GetPoints()->Modified();
  CHECK_EQUAL(render(stage.Window).CountOtherThan(Black), 50 * 30);
  property->SetOutlineOpacity(0.5);
  CHECK_EQUAL(render(stage.Window).At(50, 52), (Pixel{ 0, 128, 0 }));
  property->SetOutlineOpacity(0);
  CHECK_EQUAL(render(stage.Window).CountOtherThan(Black), 40 * 20);
}
}

int TestLimnSurfaces(int, char*[])
{
  checkHull();
  checkVertexNormals();
  checkManyNormalsOfOneMapper();
  checkFlatPoints();
  checkTones();
  checkExaggerationEndsAtSharpEdges();
  checkLocalModels();
  checkPolygonsAndStrips();
  checkPointTypes();
  checkOrder();
  checkCellColors();
  checkPointColors();
  checkFieldColor();
  checkNormals();
  checkStyles();
  return result();
}
