// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Colours that come with the data, per vertex and per face.
#include "Testing/Unit/TestScene.h"

namespace limn::testing {
namespace {

class DataColors : public BothBackends {};
LIMN_ON_BOTH_BACKENDS(DataColors);

/// Seen at a slant in perspective, so that affine interpolation would show.
Stage slanted(const OwnedMesh& mesh)
{
  Stage stage;
  stage.view = perspectiveView({0.5, -1.6, 0.9}, {0, 0, 0}, 50, {0.1, 10});
  stage.instances = {painted(mesh, {0.9f, 0.1f, 0.4f})};
  return stage;
}
OwnedMesh square(std::uint32_t cells)
{
  return sheet({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, cells);
}
std::optional<Hit> hitSquare(const Ray& ray)
{
  const auto hit = hitPlane(ray);
  const bool inside = hit && hit->position.x > -0.97 && hit->position.x < 0.97 &&
                      hit->position.y > -0.97 && hit->position.y < 0.97;
  return inside ? hit : std::nullopt;
}

TEST_P(DataColors, VertexColorsRunEvenlyOverTheSurface)
{
  OwnedMesh mesh = square(1);
  mesh.vertexColors = {{0, 0, 51, 0}, {255, 0, 51, 9}, {0, 255, 51, 255}, {255, 255, 51, 1}};
  // Corners in the sheet's order: (-1, -1), (1, -1), (-1, 1), (1, 1).
  const Stage stage = slanted(mesh);
  const auto color = [](const Hit& hit) {
    return Vec3d{(hit.position.x + 1) / 2, (hit.position.y + 1) / 2, 0.2};
  };
  expectPicture(stage, draw(stage), hitSquare, color, kRounding + 0.05);
}

TEST_P(DataColors, AlphaOfTheDataIsNotRead)
{
  OwnedMesh mesh = square(1);
  mesh.vertexColors.assign(4, {10, 20, 30, 0});
  const Rgba8 color = at(draw(slanted(mesh)), 48, 48);
  EXPECT_EQ(color.a, 255);
  EXPECT_EQ(color.b, 30);
}

TEST_P(DataColors, CellColorsAreConstantOverACell)
{
  OwnedMesh mesh = square(4);
  for (std::uint32_t cell = 0; cell < 16; ++cell)
    mesh.cellColors.push_back(
        {static_cast<std::uint8_t>(cell * 17), 0, static_cast<std::uint8_t>(255 - cell), 255});
  const Picture picture = draw(slanted(mesh));
  int compared = 0;
  for (std::size_t i = 0; i < picture.color.size(); ++i) {
    if (picture.coverage[i] == 0) continue;
    ASSERT_EQ(picture.color[i].r, picture.cell[i] * 17);
    ASSERT_EQ(picture.color[i].b, 255 - picture.cell[i]);
    ++compared;
  }
  EXPECT_GT(compared, 1000);
}

TEST_P(DataColors, VertexColorsWinOverCellColors)
{
  OwnedMesh mesh = square(1);
  mesh.cellColors = {{255, 255, 255, 255}};
  mesh.vertexColors.assign(4, {10, 20, 30, 255});
  EXPECT_EQ(at(draw(slanted(mesh)), 48, 48).g, 20);
}

TEST_P(DataColors, ReplaceTheDiffuseAndAmbientColorButNotTheCoefficients)
{
  OwnedMesh mesh = square(1);
  mesh.cellColors = {{200, 100, 0, 255}};
  Stage stage = slanted(mesh);
  Material& material = stage.instances[0].material;
  material.diffuse = 0.25f;
  material.ambient = 0.5f;
  const Rgba8 color = at(draw(stage), 48, 48);
  EXPECT_EQ(color.r, 150);
  EXPECT_EQ(color.g, 75);
  EXPECT_EQ(color.b, 0);
}

TEST_P(DataColors, TheHighlightKeepsItsOwnColor)
{
  OwnedMesh mesh = square(1);
  mesh.cellColors = {{255, 0, 0, 255}};
  Stage stage = slanted(mesh);
  stage.instances[0].style.reflection = Reflection::kAsVtk;
  stage.instances[0].style.normals = NormalSource::kVertex;
  stage.instances[0].material.diffuse = 0;
  stage.instances[0].material.specular = 1;
  stage.instances[0].material.specularPower = 0;
  stage.instances[0].material.specularColor = {0, 0.4f, 0.8f};
  stage.lights = {Light{}};
  const Rgba8 color = at(draw(stage), 48, 48);
  EXPECT_EQ(color.r, 0);
  EXPECT_EQ(color.g, 102);
  EXPECT_EQ(color.b, 204);
}

TEST_P(DataColors, APixelIsShadedAtItsCentreOrIfPartlyCoveredAtItsFirstCoveredSample)
{
  // Red grows by 16 a pixel from x = 0.5 to 15.5. Of eight samples, the pixels under both ends show
  // half: the first with x >= 1/2 is sample 0, at 9/16; the first with x < 1/2 sample 1, at 7/16.
  OwnedMesh mesh = sheet({0.5, 0, 0}, {15, 0, 0}, {0, 16, 0});
  mesh.vertexColors = {{0, 0, 0, 255}, {240, 0, 0, 255}, {0, 0, 0, 255}, {240, 0, 0, 255}};
  Stage stage = pixelStage(16, 8);
  stage.instances = {painted(mesh, {1, 1, 1})};
  Picture picture(16, 16);
  stage.drawOver(picture, GetParam(), Background::kKeepApart);
  for (int x = 1; x < 15; ++x)
    ASSERT_EQ(at(picture, x, 8).r, 16 * x);
  ASSERT_EQ(at(picture, 0, 8).r, 1);
  ASSERT_EQ(at(picture, 15, 8).r, 239);
}

TEST_P(DataColors, GouraudLightsColoredVerticesAndFlatColorsEachPixel)
{
  OwnedMesh mesh = square(1);
  mesh.vertexColors = {{0, 0, 51, 255}, {255, 0, 51, 255}, {0, 255, 51, 255}, {255, 255, 51, 255}};
  Stage stage = slanted(mesh);
  const auto color = [](const Hit& hit) {
    return Vec3d{(hit.position.x + 1) / 2, (hit.position.y + 1) / 2, 0.2};
  };
  for (const ShadingFrequency frequency : {ShadingFrequency::kGouraud, ShadingFrequency::kFlat}) {
    stage.instances[0].style.frequency = frequency;
    expectPicture(stage, draw(stage), hitSquare, color, kRounding + 0.05);
  }
}

}  // namespace
}  // namespace limn::testing
