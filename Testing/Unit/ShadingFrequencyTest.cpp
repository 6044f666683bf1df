// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How often a light equation is evaluated: once a face, once a vertex, once a pixel.
#include "Testing/Unit/TestScene.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace limn::testing {
namespace {

class Frequencies : public BothBackends {};
LIMN_ON_BOTH_BACKENDS(Frequencies);

constexpr Vec3d kLightAt = {1.5, 1.2, 2};

/// 0.7 of matt and 0.5 of glossy (p = 6) reflection of a point light without fall-off.
double brightness(Vec3d p, Vec3d n, Vec3d eye)
{
  const Vec3d l = normalized(kLightAt - p), v = normalized(eye - p);
  const double nl = dot(n, l);
  if (nl <= 0) return 0;
  return 0.7 * nl + 0.5 * std::pow(std::max(0.0, dot(n, normalized(l + v))), 6);
}
void giveGlossAndLight(Stage& stage)
{
  Light light;
  light.kind = LightKind::kPoint;
  light.position = kLightAt;
  light.attenuation = {1, 0, 0};
  stage.lights = {light};
  for (Instance& instance : stage.instances) {
    instance.material.diffuse = 0.7f;
    instance.material.specular = 0.5f;
    instance.material.specularPower = 6;
    instance.style.reflection = Reflection::kBlinnPhong;
  }
}

Stage coarseSphere(const OwnedMesh& mesh)
{
  Stage stage;
  stage.view.eye = {1.1, 0.9, 2.6};
  stage.instances = {instanceOf(mesh)};
  giveGlossAndLight(stage);
  stage.instances[0].style.frequency = ShadingFrequency::kFlat;
  return stage;
}

struct Face {
  Vec3d areaTimesCentroid = {0, 0, 0}, areaTimesNormal = {0, 0, 0};
  double area = 0;
};
std::map<std::uint32_t, Face> facesOf(const OwnedMesh& mesh)
{
  std::map<std::uint32_t, Face> faces;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const MeshView view = mesh.view();
    const auto& v = mesh.triangles[t].vertex;
    const Vec3d a = view.position(v[0]), b = view.position(v[1]), c = view.position(v[2]);
    const Vec3d normal = cross(b - a, c - a);
    const double area = std::sqrt(dot(normal, normal));
    Face& face = faces[mesh.cells.empty() ? static_cast<std::uint32_t>(t) : mesh.cells[t]];
    face.areaTimesCentroid = face.areaTimesCentroid + (a + b + c) * (area / 3);
    face.areaTimesNormal = face.areaTimesNormal + normal;
    face.area += area;
  }
  return faces;
}

/// Each pixel of a flat picture, by its cell, against the equation at that face's centroid.
void expectFlat(const Stage& stage, const OwnedMesh& mesh, const Picture& picture)
{
  auto faces = facesOf(mesh);
  std::map<std::uint32_t, Rgba8> seen;
  for (std::size_t i = 0; i < picture.color.size(); ++i) {
    if (picture.coverage[i] == 0) continue;
    const Rgba8 color = picture.color[i];
    const Rgba8 first = seen.emplace(picture.cell[i], color).first->second;
    ASSERT_EQ(color.r, first.r) << "face " << picture.cell[i] << " has two colours";
    const Face& face = faces.at(picture.cell[i]);
    const double expected = brightness(face.areaTimesCentroid * (1 / face.area),
                                       normalized(face.areaTimesNormal), stage.view.eye);
    ASSERT_NEAR(color.r, 255 * std::min(1.0, expected), kRounding + 0.01);
  }
  EXPECT_GT(seen.size(), 20u);
}

TEST_P(Frequencies, FlatIsTheEquationAtTheCentroidOfEachTriangle)
{
  OwnedMesh mesh = sphere(6, 9);
  mesh.cells.clear();
  mesh.cellCount = 0;
  finish(mesh);
  const Stage stage = coarseSphere(mesh);
  expectFlat(stage, mesh, draw(stage));
}

TEST_P(Frequencies, FlatLightsAQuadOnceThoughItIsTwoTriangles)
{
  const OwnedMesh mesh = sphere(8, 12);
  const Stage stage = coarseSphere(mesh);
  expectFlat(stage, mesh, draw(stage));
}

TEST_P(Frequencies, FlatByTheFirstVertexIsTheEquationThere)
{
  const OwnedMesh mesh = sphere(8, 12);
  Stage stage = coarseSphere(mesh);
  const std::vector<Vec3d> first = firstCorners(mesh.view(), mesh.cells, mesh.cellCount);
  stage.instances[0].attributes.facePoints = first;
  std::map<std::uint32_t, Vec3d> corners;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    corners.emplace(mesh.cells[t], mesh.view().position(mesh.triangles[t].vertex[0]));
  auto faces = facesOf(mesh);
  const Picture picture = draw(stage);
  std::size_t seen = 0;
  for (std::size_t i = 0; i < picture.color.size(); ++i) {
    if (picture.coverage[i] == 0) continue;
    const std::uint32_t cell = picture.cell[i];
    const double expected =
        brightness(corners.at(cell), normalized(faces.at(cell).areaTimesNormal), stage.view.eye);
    ASSERT_NEAR(picture.color[i].r, 255 * std::min(1.0, expected), kRounding + 0.01);
    ++seen;
  }
  EXPECT_GT(seen, 1000u);
}

TEST_P(Frequencies, CornersMayHaveNormalsOfTheirOwn)
{
  OwnedMesh mesh = sheet({-1, -1, 0}, {2, 0, 0}, {0, 2, 0});
  Stage stage;
  stage.view = parallelView({0, 0, 4}, {0, 0, 0}, 1);
  Light light;
  stage.lights = {light};
  stage.instances = {instanceOf(mesh)};
  const std::vector<Vec3f> normals = {{0, 0, 1}, {0.6f, 0, 0.8f}};
  const std::vector<std::uint32_t> ofCorner = {1, 1, 1, 0, 0, 0};
  stage.instances[0].attributes.vertexNormals = normals;
  stage.instances[0].attributes.normalOfCorner = ofCorner;
  const Picture picture = draw(stage);
  std::size_t bright = 0, dark = 0;
  for (const Rgba8& color : picture.color) {
    ASSERT_TRUE(color.r == 255 || color.r == 204) << int{color.r};
    ++(color.r == 255 ? bright : dark);
  }
  EXPECT_NEAR(static_cast<double>(bright), static_cast<double>(dark), 100);
}

/// A sheet of 4 x 4 cells, 16 pixels each, whose vertices lie on pixel centres; normals swing.
struct Wavy {
  OwnedMesh mesh;
  Stage stage;

  explicit Wavy(ShadingFrequency frequency)
      : mesh(sheet({-31.5 / 32, -31.5 / 32, 0}, {2, 0, 0}, {0, 2, 0}, 4))
  {
    for (std::size_t v = 0; v < mesh.vertexNormals.size(); ++v) {
      const double angle = 0.8 * static_cast<double>(v);
      mesh.vertexNormals[v] = vec3Cast<float>(
          normalized(Vec3d{0.6 * std::cos(angle), 0.6 * std::sin(angle), 0.8}) * 2.0);
    }
    stage.width = stage.height = 64;
    stage.view = parallelView({0, 0, 3}, {0, 0, 0}, 1);
    stage.instances = {instanceOf(mesh)};
    giveGlossAndLight(stage);
    stage.instances[0].style.frequency = frequency;
  }
  Vec3d position(std::size_t v) const { return vec3Cast<double>(mesh.positions[v]); }
  double brightnessAt(std::size_t v) const
  {
    const Vec3d p = position(v), n = normalized(vec3Cast<double>(mesh.vertexNormals[v]));
    // Under parallel projection the eye is straight above.
    return brightness(p, n, p + Vec3d{0, 0, 1});
  }
};

TEST_P(Frequencies, GouraudHasTheEquationsColorAtEachVertex)
{
  const Wavy wavy(ShadingFrequency::kGouraud);
  const Picture picture = draw(wavy.stage);
  for (std::size_t v = 0; v < wavy.mesh.positions.size(); ++v) {
    const Vec3d p = wavy.position(v);
    // Right and lower border belong to the neighbours that are not there.
    if (p.x > 1 || p.y < -0.97 || p.y > 1) continue;
    const int x = static_cast<int>(32 + 32 * p.x), y = static_cast<int>(32 + 32 * p.y);
    EXPECT_NEAR(at(picture, x, y).r, 255 * std::min(1.0, wavy.brightnessAt(v)), kRounding + 0.01)
        << "vertex " << v;
  }
}

TEST_P(Frequencies, GouraudIsLinearAlongAnEdge)
{
  const Wavy wavy(ShadingFrequency::kGouraud);
  const Picture picture = draw(wavy.stage);
  // Vertices 6 and 7, on pixels (16, 16) and (32, 16).
  const double first = wavy.brightnessAt(6), second = wavy.brightnessAt(7);
  for (int i = 0; i <= 16; ++i)
    EXPECT_NEAR(at(picture, 16 + i, 16).r, 255 * (first + (second - first) * i / 16),
                kRounding + 0.01);
}

TEST_P(Frequencies, PhongIsTheEquationWithTheInterpolatedNormalAlongAnEdge)
{
  const Wavy wavy(ShadingFrequency::kPhong);
  const Picture picture = draw(wavy.stage);
  const Vec3d p = wavy.position(6), q = wavy.position(7);
  const Vec3d m = vec3Cast<double>(wavy.mesh.vertexNormals[6]),
              n = vec3Cast<double>(wavy.mesh.vertexNormals[7]);
  for (int i = 0; i <= 16; ++i) {
    const double t = i / 16.0;
    const Vec3d here = p * (1 - t) + q * t;
    const double expected =
        brightness(here, normalized(m * (1 - t) + n * t), here + Vec3d{0, 0, 1});
    EXPECT_NEAR(at(picture, 16 + i, 16).r, 255 * std::min(1.0, expected), kRounding + 0.01);
  }
}

TEST_P(Frequencies, AHighlightInsideAFaceIsSeenByPhongAndMissedByGouraud)
{
  const OwnedMesh mesh = sheet({-1, -1, 0}, {2, 0, 0}, {0, 2, 0});
  Stage stage;
  stage.width = stage.height = 95;
  stage.view = parallelView({0, 0, 3}, {0, 0, 0}, 1);
  stage.instances = {instanceOf(mesh)};
  Light light;
  light.kind = LightKind::kPoint;
  light.position = {0, 0, 0.5};
  light.attenuation = {1, 0, 0};
  stage.lights = {light};
  stage.instances[0].material.diffuse = 0;
  stage.instances[0].material.specular = 1;
  stage.instances[0].material.specularPower = 60;
  stage.instances[0].style.reflection = Reflection::kBlinnPhong;
  const auto centre = [&](ShadingFrequency frequency) {
    stage.instances[0].style.frequency = frequency;
    return static_cast<int>(at(draw(stage), 47, 47).g);
  };
  EXPECT_EQ(centre(ShadingFrequency::kPhong), 255);
  // At the corners l leans by 70.5 degrees, h by half of that: cos^60 is 5e-6.
  EXPECT_EQ(centre(ShadingFrequency::kGouraud), 0);
}

}  // namespace
}  // namespace limn::testing
