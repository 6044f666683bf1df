// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Styles by one word: what they set, what they leave, and that each looks like no other.
#include "Check.h"
#include "Messages.h"
#include "Picture.h"
#include "Stage.h"

#include "vtkLimnProperty.h"
#include "vtkLimnStyle.h"

#include "vtkAssembly.h"
#include "vtkMapper.h"
#include "vtkSphereSource.h"
#include "vtkTexture.h"

#include <set>
#include <string>
#include <vector>

namespace
{
/// Two spheres of a colour of their own, before grey.
struct Spheres : Stage
{
  vtkNew<vtkSphereSource> Source;
  vtkNew<vtkLimnActor> Other;

  Spheres()
  {
    this->Source->SetThetaResolution(24);
    this->Source->SetPhiResolution(16);
    this->Mapper->SetInputConnection(this->Source->GetOutputPort());
    this->Other->SetMapper(this->Mapper);
    this->Other->SetPosition(1.2, 0, 0);
    this->Renderer->AddActor(this->Other);
    this->Renderer->SetBackground(0.5, 0.5, 0.5);
    this->Actor->GetProperty()->SetColor(0.9, 0.4, 0.2);
    this->Actor->GetProperty()->SetOpacity(0.8);
    this->Renderer->ResetCamera();
  }
};

bool applied(vtkRenderer* renderer, const char* name)
{
  return vtkLimnStyle::Apply(renderer, name);
}

void checkNames()
{
  CHECK(vtkLimnStyle::GetNumberOfStyles() == 11);
  CHECK(std::string(vtkLimnStyle::GetStyleName(0)) == "plain");
  CHECK(std::string(vtkLimnStyle::GetStyleName(10)) == "print");
  CHECK(vtkLimnStyle::GetStyleName(-1) == nullptr);
  CHECK(vtkLimnStyle::GetStyleName(11) == nullptr);
}

void checkUnknown()
{
  Spheres spheres;
  const Messages messages;
  CHECK(!applied(spheres.Renderer, "baroque"));
  CHECK(messages.Count("no style baroque") == 1);
  CHECK(messages.Count("blueprint, pencil") == 1);
  CHECK(!applied(spheres.Renderer, nullptr));
  CHECK(!applied(nullptr, "ink"));
  double rgb[3];
  CHECK(!vtkLimnStyle::GetBackground("baroque", rgb));
}

/// Each style differs from all others, and plain is as if there had been none.
void checkPictures()
{
  Spheres spheres;
  const Picture first = render(spheres.Window);
  std::set<std::vector<unsigned char>> seen;
  for (int i = 0; i < vtkLimnStyle::GetNumberOfStyles(); ++i)
  {
    CHECK(applied(spheres.Renderer, vtkLimnStyle::GetStyleName(i)));
    const Picture pixels = render(spheres.Window);
    CHECK(seen.insert(pixels.Bytes).second);
    CHECK((pixels.Bytes == first.Bytes) == (i == 0));
  }
  CHECK(applied(spheres.Renderer, "plain"));
  CHECK(render(spheres.Window).Bytes == first.Bytes);
}

/// A square that faces the eye lies halfway between the ends of a scale from the upper right.
void checkColors()
{
  Stage stage;
  stage.LookFlat();
  vtkNew<vtkPolyData> data;
  data->SetPoints(flatPoints({ { 20, 20 }, { 80, 20 }, { 80, 60 }, { 20, 60 } }));
  vtkNew<vtkCellArray> polys;
  addCell(polys, { 0, 1, 2, 3 });
  data->SetPolys(polys);
  stage.Mapper->SetInputData(data);
  vtkNew<vtkLimnProperty> property;
  property->SetColor(1, 1, 1);
  stage.Actor->SetProperty(property);
  const auto middle = [&stage](const char* name)
  {
    CHECK(applied(stage.Renderer, name));
    return render(stage.Window).At(50, 40);
  };
  const auto isNear = [](const Pixel& rgb, double r, double g, double b)
  {
    return std::abs(rgb[0] - 255 * r) <= 1 && std::abs(rgb[1] - 255 * g) <= 1 &&
           std::abs(rgb[2] - 255 * b) <= 1;
  };
  // (k_cool + k_warm) / 2 = ((0, 0, 0.4) + 0.2 + (0.4, 0.4, 0) + 0.6) / 2
  CHECK(isNear(middle("technical"), 0.6, 0.6, 0.6));
  CHECK(isNear(middle("blueprint"), 0.08, 0.22, 0.46));
  CHECK(isNear(middle("ink"), 1, 1, 1));
  CHECK(isNear(middle("toon"), (0.35 + 1) / 2, (0.35 + 1) / 2, (0.35 + 1) / 2));
  double paper[3];
  CHECK(vtkLimnStyle::GetBackground("blueprint", paper));
  CHECK(applied(stage.Renderer, "blueprint"));
  CHECK(isNear(render(stage.Window).At(5, 5), paper[0], paper[1], paper[2]));
  CHECK(!vtkLimnStyle::GetBackground("technical", paper));
}

void checkProperties()
{
  Spheres spheres;
  vtkNew<vtkProperty> shared;
  shared->SetColor(0.1, 0.2, 0.3);
  vtkNew<vtkLimnActor> part;
  part->SetMapper(spheres.Mapper);
  part->SetProperty(shared);
  spheres.Other->SetProperty(shared);
  vtkNew<vtkAssembly> assembly;
  assembly->AddPart(part);
  spheres.Renderer->AddActor(assembly);
  vtkProperty* const own = spheres.Actor->GetProperty();

  CHECK(applied(spheres.Renderer, "xray"));
  // A vtkLimnProperty keeps its place, others are replaced, for all who shared them.
  CHECK(!vtkLimnProperty::SafeDownCast(own) == (spheres.Actor->GetProperty() != own));
  auto* const limn = vtkLimnProperty::SafeDownCast(part->GetProperty());
  CHECK(limn != nullptr && part->GetProperty() == spheres.Other->GetProperty());
  CHECK(limn->GetDiffuseColor()[2] == 0.3);
  CHECK(limn->GetOpacity() < 1 && limn->GetMatCap() != nullptr);

  // Settings that no style has a say in stay; those of the style before do not.
  limn->SetProceduralTextureToWood();
  limn->SetStrokeWidth(7);
  vtkNew<vtkTexture> texture;
  limn->SetTexture("paper", texture);
  CHECK(applied(spheres.Renderer, "ink"));
  CHECK(limn->GetOpacity() == 1 && limn->GetMatCap() == nullptr);
  CHECK(limn->GetContourLines() && limn->GetStrokeWidth() != 7);
  CHECK(limn->GetProceduralTexture() == vtkLimnProperty::PROCEDURAL_WOOD);
  CHECK(limn->GetTexture("paper") == texture);
  CHECK(applied(spheres.Renderer, "plain"));
  CHECK(!limn->GetContourLines() && limn->GetTone() == vtkLimnProperty::TONE_NONE);
  CHECK(spheres.Renderer->GetBackground()[0] == 0.5);

  // Plain ends what is remembered of the time before the first style.
  spheres.Renderer->SetBackground(0.25, 0.25, 0.25);
  limn->SetOpacity(0.6);
  CHECK(applied(spheres.Renderer, "xray"));
  CHECK(limn->GetOpacity() != 0.6 && spheres.Renderer->GetBackground()[0] == 0);
  CHECK(applied(spheres.Renderer, "technical"));
  CHECK(limn->GetOpacity() == 0.6 && spheres.Renderer->GetBackground()[0] == 0.25);
}

/// A copy of a styled property knows what the style replaced, and one of a plain property forgets
/// what it knew.
void checkCopies()
{
  vtkNew<vtkLimnProperty> property;
  property->SetOpacity(0.6);
  CHECK(vtkLimnStyle::Apply(property, "xray"));
  vtkNew<vtkLimnProperty> copy;
  copy->DeepCopy(property);
  CHECK(copy->GetOpacity() == property->GetOpacity() && copy->GetOpacity() != 0.6);
  CHECK(vtkLimnStyle::Apply(copy, "ink"));
  CHECK_EQUAL(copy->GetOpacity(), 0.6);
  CHECK(vtkLimnStyle::Apply(copy, "xray"));
  CHECK(vtkLimnStyle::Apply(copy, "plain"));
  CHECK_EQUAL(copy->GetOpacity(), 0.6);

  vtkNew<vtkLimnProperty> plain;
  plain->SetOpacity(0.3);
  property->DeepCopy(plain);
  CHECK(vtkLimnStyle::Apply(property, "plain"));
  CHECK_EQUAL(property->GetOpacity(), 0.3);
}
}

int TestLimnStyle(int, char*[])
{
  checkNames();
  checkUnknown();
  checkPictures();
  checkColors();
  checkProperties();
  checkCopies();
  return result();
}
