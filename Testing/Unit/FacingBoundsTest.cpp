// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/Generator/GeneratedMeshes.h"

#include "Rendering/Lines/SurfaceCurves.h"
#include "Rendering/Mesh/VertexNormals.h"
#include "Testing/Unit/TestScene.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace limn {
namespace {

using testing::Stage;

/// A mesh with all that lines are found from.
struct Model {
  std::vector<Vec3d> positions;
  std::vector<Triangle> triangles;
  std::vector<Vec3f> normals;
  SplitNormals split;
  EdgeTable table;
  Array<VertexCurvature> curvature;
  FacingBounds faceBounds, normalBounds;
  CurveBounds curveBounds;

  explicit Model(const GeneratedMesh& mesh) : triangles(mesh.triangles())
  {
    for (const Vec3f& p : mesh.positions)
      positions.push_back(vec3Cast<double>(p));
  }
  MeshView view() const { return {{}, positions, triangles}; }
  CurvedSurface surface() const { return {view(), normals, curvature}; }
  FeatureArrays arrays() const
  {
    FeatureArrays result;
    result.vertexNormals = split.normals;
    result.normalOfCorner = split.ofCorner;
    return result;
  }
  void build()
  {
    ASSERT_TRUE(buildEdgeTable(view(), 0, 2, table).ok());
    normals = vertexNormals(view(), NormalWeight::kArea);
    ASSERT_TRUE(splitVertexNormals(view(), {}, NormalWeight::kAngle, 40, 2, split).ok());
    curvature = vertexCurvature(view(), normals, 2);
    faceBounds = boundFaces(view(), table, 2);
    normalBounds = boundNormals(view(), table, arrays(), 2);
    curveBounds = boundCurves(surface(), table, 2);
  }
};

/// Moves vertices, turns some triangles over, squeezes some to slivers or to nothing.
void disturb(Model& model, double share, std::mt19937& random)
{
  std::uniform_real_distribution<double> unit(-1, 1);
  for (Vec3d& p : model.positions)
    p = p + Vec3d{unit(random), unit(random), unit(random)} * share;
  for (Triangle& triangle : model.triangles) {
    if (unit(random) > 1 - 2 * share) std::swap(triangle.vertex[0], triangle.vertex[1]);
    if (unit(random) > 1 - share) {
      const Vec3d a = model.positions[triangle.vertex[0]], b = model.positions[triangle.vertex[1]];
      const double along = unit(random), off = unit(random) > 0 ? 1e-12 : 0;
      model.positions[triangle.vertex[2]] =
          a + (b - a) * along + Vec3d{unit(random), unit(random), unit(random)} * off;
    }
  }
}

std::vector<Model> models()
{
  std::mt19937 random(20261129);
  std::vector<Model> all;
  for (const double share : {0.0, 0.002, 0.05})
    for (const GeneratedMesh& mesh : {sphere(60, 40, 1), torus(90, 50, 1, 0.4), knot(200, 24, 0.4),
                                      gear(9, 0.4), extrudedSine(60, 20), teapot(6), cube()}) {
      all.emplace_back(mesh);
      disturb(all.back(), share, random);
    }
  // Far out, where coordinates are rough.
  all.emplace_back(torus(90, 50, 1, 0.4));
  for (Vec3d& p : all.back().positions)
    p = p + Vec3d{3e6, -2e6, 5e5};
  all.emplace_back(sphere(60, 40, 1e-6));
  all.emplace_back(sphere(60, 40, 1));
  all.back().positions[7].x = std::nan("");
  for (Model& model : all)
    model.build();
  return all;
}

struct View {
  Camera camera;
  Mat4d place;
};

std::vector<View> viewsOf(const Model& model, std::mt19937& random)
{
  const Box box = finiteBox(model.view());
  const Vec3d center = (box.low + box.high) * 0.5, half = box.high - center;
  const double radius = std::sqrt(dot(half, half));
  std::normal_distribution<double> normal;
  std::vector<View> views;
  for (const double distance : {0.3, 1.01, 1.5, 3.0, 40.0, 3000.0})
    for (int i = 0; i < 4; ++i) {
      const Vec3d way = normalized(Vec3d{normal(random), normal(random), normal(random)});
      Mat4d turn = Mat4d::identity();
      if (i == 1) turn.m[2][2] = -1;
      if (i == 2) turn = {{{20, 0.3, 0, 1}, {0, 0.5, 0, 0}, {0, 0, 1, -2}, {0, 0, 0, 1}}};
      const Vec3d target = transformPoint(turn, center);
      Stage stage;
      stage.view = i % 2 == 0
                       ? testing::perspectiveView(target + way * (radius * distance), target, 40)
                       : testing::parallelView(target + way * (radius * distance), target, radius);
      views.push_back({stage.camera(), turn});
    }
  return views;
}

void expectSame(const ContourLines& a, const ContourLines& b)
{
  EXPECT_EQ(a.points.size(), b.points.size());
  for (std::size_t i = 0; i < std::min(a.points.size(), b.points.size()); ++i)
    EXPECT_TRUE(a.points[i] == b.points[i]);
  EXPECT_EQ(a.slack, b.slack);
  EXPECT_EQ(a.chains.vertex, b.chains.vertex);
  EXPECT_EQ(a.chains.first, b.chains.first);
}

void expectNoLineChanges(const Model& model, const View& view)
{
  const auto silhouettes = [&](const FacingBounds& bounds) {
    return silhouetteEdges(model.view(), model.table, bounds, view.camera, view.place, 2);
  };
  EXPECT_EQ(silhouettes(model.faceBounds).edge, silhouettes({}).edge);
  const auto smooth = [&](const FacingBounds& bounds) {
    return smoothContours(model.view(), model.table, model.arrays(), bounds, view.camera,
                          view.place, 2);
  };
  expectSame(smooth(model.normalBounds), smooth({}));
  const auto suggestive = [&](const CurveBounds& bounds) {
    return suggestiveContours(model.surface(), model.table, bounds, view.camera, view.place, {}, 2);
  };
  expectSame(suggestive(model.curveBounds), suggestive({}));
}

TEST(FacingBounds, ChangeNoLine)
{
  std::mt19937 random(7);
  for (const Model& model : models())
    for (const View& view : viewsOf(model, random))
      expectNoLineChanges(model, view);
}

// A plate seen from its edge, far out or from far away: its facets turn this way and that by
// rounding.
TEST(FacingBounds, ChangeNoLineWhereRoundingDecides)
{
  const Vec3d across = normalized(Vec3d{0.3, 0.8, -0.5});
  const Vec3d along = normalized(cross(across, {1, 0, 0})), aside = cross(across, along);
  const std::pair<Vec3d, double> places[] = {{{3e8, -2e8, 1e8}, 5.0}, {{3, -2, 1}, 1e10}};
  for (const auto& [center, distance] : places) {
    Model model(sheet(60));
    for (Vec3d& p : model.positions)
      p = center + along * p.x + aside * p.z;
    model.build();
    for (int i = 0; i < 20; ++i) {
      const Vec3d toEye = along * std::cos(0.3 * i) + aside * std::sin(0.3 * i);
      Stage stage;
      stage.view = distance < 10 ? testing::parallelView(center + toEye * distance, center, 2)
                                 : testing::perspectiveView(center + toEye * distance, center, 1);
      expectNoLineChanges(model, {stage.camera(), Mat4d::identity()});
    }
  }
}

// Of two faces folded together and wound unlike, both are seen from their fronts.
TEST(FacingBounds, KnowOfFacesThatAreNotWoundAlike)
{
  Model model(GeneratedMesh{});
  model.positions = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, -0.1}};
  model.triangles = {{{0, 2, 1}}, {{0, 3, 1}}};
  model.build();
  Stage stage;
  stage.view = testing::perspectiveView({0.3, 0.4, 9}, {0.3, 0.4, 0}, 30);
  EXPECT_EQ(silhouetteEdges(model.view(), model.table, model.faceBounds, stage.camera(),
                            Mat4d::identity(), 1)
                .chains.vertex.size(),
            2u);
}

void expectSame(const FacingBounds& a, const FacingBounds& b)
{
  ASSERT_EQ(a.boxes.size(), b.boxes.size());
  for (std::size_t i = 0; i < a.boxes.size(); ++i) {
    EXPECT_TRUE(std::equal(a.boxes[i].middle, a.boxes[i].middle + 4, b.boxes[i].middle)) << i;
    EXPECT_TRUE(std::equal(a.boxes[i].half, a.boxes[i].half + 4, b.boxes[i].half)) << i;
  }
}

// A normal may be that of one corner, or of many at several vertices.
TEST(FacingBounds, DoNotDependOnHowNormalsAreNumbered)
{
  for (const GeneratedMesh& mesh : {cube(), gear(9, 0.4), torus(90, 50, 1, 0.4)}) {
    Model model(mesh);
    model.build();
    std::vector<Vec3f> ofCorners, once;
    std::vector<std::uint32_t> corners, numbers;
    for (const std::uint32_t number : model.split.ofCorner) {
      const Vec3f normal = model.split.normals[number];
      corners.push_back(static_cast<std::uint32_t>(ofCorners.size()));
      ofCorners.push_back(normal);
      const auto known = std::find(once.begin(), once.end(), normal);
      numbers.push_back(static_cast<std::uint32_t>(known - once.begin()));
      if (known == once.end()) once.push_back(normal);
    }
    const auto bounds = [&](Span<const Vec3f> normals, Span<const std::uint32_t> ofCorner) {
      FeatureArrays arrays;
      arrays.vertexNormals = normals;
      arrays.normalOfCorner = ofCorner;
      return boundNormals(model.view(), model.table, arrays, 2);
    };
    expectSame(bounds(ofCorners, corners), model.normalBounds);
    expectSame(bounds(once, numbers), model.normalBounds);
  }
}

TEST(FacingBounds, OfEndsAreThoseOfNormalsThatVerticesHave)
{
  Model model(torus(90, 50, 1, 0.4));
  model.build();
  for (Triangle& triangle : model.triangles)
    for (std::uint32_t& vertex : triangle.vertex)
      vertex = model.table.place[vertex];
  model.build();
  FeatureArrays arrays;
  arrays.vertexNormals = model.normals;
  expectSame(boundEnds(model.view(), finiteBox(model.view()), model.table, model.normals, 2),
             boundNormals(model.view(), model.table, arrays, 2));
}

// Or they would be of no use.
TEST(FacingBounds, LeaveOutMostOfASmoothMesh)
{
  Model model(torus(200, 120, 1, 0.4));
  model.build();
  for (const double distance : {2.5, 30.0}) {
    Stage stage;
    stage.view = testing::perspectiveView({0, distance * 0.8, distance * 0.6}, {0, 0, 0}, 40);
    const BoundedFacing ofFaces(model.faceBounds, stage.camera(), Mat4d::identity());
    const BoundedFacing ofNormals(model.normalBounds, stage.camera(), Mat4d::identity());
    const BoundedCurves ofCurves(model.curveBounds, stage.camera(), Mat4d::identity());
    std::size_t turning[3] = {0, 0, 0};
    for (std::size_t b = 0; b < model.faceBounds.boxes.size(); ++b) {
      turning[0] += ofFaces.side(b) == BoundedFacing::Side::kBoth ? 1 : 0;
      turning[1] += ofNormals.side(b) == BoundedFacing::Side::kBoth ? 1 : 0;
      turning[2] += ofCurves.hasNone(b) ? 0 : 1;
    }
    for (const std::size_t count : turning) {
      EXPECT_GT(count, 0u);
      EXPECT_LT(count, model.faceBounds.boxes.size() / 6);
    }
  }
}

}  // namespace
}  // namespace limn
