// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Data/Generator/GeneratedMeshes.h"

#include "Rendering/Lines/Contours.h"
#include "Rendering/Mesh/WeldVertices.h"
#include "Testing/Unit/EdgedMesh.h"
#include "Testing/Unit/Polyhedra.h"
#include "Testing/Unit/TestScene.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace limn {
namespace {

using testing::OwnedMesh;
using testing::Polyhedron;
using testing::Stage;

constexpr double kPi = 3.14159265358979323846;

struct Model : testing::EdgedMesh {
  using EdgedMesh::EdgedMesh;

  ContourLines smooth(const Stage& stage, const Mat4d& place = Mat4d::identity()) const
  {
    return smoothContours(mesh, table, arrays, {}, stage.camera(), place, 2);
  }
  EdgeChains edges(const Stage& stage) const
  {
    return silhouetteEdges(mesh, table, {}, stage.camera(), Mat4d::identity(), 2);
  }
};

/// Points at which not exactly an even number of links meet.
std::size_t oddPoints(const LineChains& chains)
{
  std::map<std::uint32_t, int> degree;
  for (std::size_t c = 0; c + 1 < chains.first.size(); ++c)
    for (std::uint32_t i = chains.first[c]; i + 1 < chains.first[c + 1]; ++i) {
      ++degree[chains.vertex[i]];
      ++degree[chains.vertex[i + 1]];
    }
  return static_cast<std::size_t>(std::count_if(
      degree.begin(), degree.end(), [](const auto& point) { return point.second % 2 != 0; }));
}

std::size_t closedChains(const LineChains& chains)
{
  std::size_t count = 0;
  for (std::size_t c = 0; c + 1 < chains.first.size(); ++c)
    count += chains.vertex[chains.first[c]] == chains.vertex[chains.first[c + 1] - 1] ? 1 : 0;
  return count;
}

Stage stageOf(const testing::Viewpoint& view)
{
  Stage stage;
  stage.width = stage.height = 1000;
  stage.view = view;
  return stage;
}

// 448 triangles: the interpolated contour of linear triangles is up to 10 pixels off here.
TEST(Contours, OfASphereInPerspectiveIsACircleOfTheKnownRadius)
{
  const OwnedMesh sphere = testing::sphere(15, 16);
  ASSERT_EQ(sphere.triangles.size(), 448u);
  const Model model(sphere.view(), sphere.vertexNormals);
  double worst = 0, worstOnAxis = 0, sum = 0;
  int count = 0;
  for (int turn = 0; turn < 40; ++turn) {
    // The first along the axis of the mesh, as VTK's camera looks at its sphere.
    const double angle = 0.157 * turn + 0.05, height = std::sin(0.9 * turn) * 0.9;
    const double flat = std::sqrt(1 - height * height);
    const Vec3d eye = turn == 0
                          ? Vec3d{0, 0, 3}
                          : Vec3d{flat * std::cos(angle), height, flat * std::sin(angle)} * 3.0;
    const Stage stage = stageOf(testing::perspectiveView(eye, {0, 0, 0}, 50));
    const ContourLines contours = model.smooth(stage);
    EXPECT_EQ(closedChains(contours.chains), 1u);
    EXPECT_EQ(contours.chains.first.size(), 2u);
    for (const Vec3d& p : contours.points) {
      const Vec3d at = stage.project(p);
      const double error = std::fabs(std::hypot(at.x - 500, at.y - 500) - 379.099);
      worst = std::max(worst, error);
      if (turn == 0) worstOnAxis = std::max(worstOnAxis, error);
      sum += error;
      ++count;
    }
  }
  EXPECT_LT(worstOnAxis, 0.36);
  // Diagonals of the quads at the equator are longer.
  EXPECT_LT(worst, 0.39);
  EXPECT_LT(sum / count, 0.1);
}

// VTK's default direction gives a mean z of R^2/d here.
TEST(Contours, OfASphereInParallelProjectionIsItsEquator)
{
  const OwnedMesh sphere = testing::sphere(32, 48);
  const Model model(sphere.view(), sphere.vertexNormals);
  const Stage stage = stageOf(testing::parallelView({0, 0, 3}, {0, 0, 0}, 1.2));
  const ContourLines contours = model.smooth(stage);
  ASSERT_FALSE(contours.chains.empty());
  for (const Vec3d& p : contours.points) {
    EXPECT_NEAR(p.z, 0, 1e-6);
    EXPECT_NEAR(std::hypot(p.x, p.y), 1, 1e-4);
  }
  const EdgeChains edges = model.edges(stage);
  double meanZ = 0;
  for (const std::uint32_t v : edges.chains.vertex)
    meanZ += sphere.view().position(v).z / static_cast<double>(edges.chains.vertex.size());
  EXPECT_NEAR(meanZ, 0, 0.05);
}

TEST(Contours, OfATorusAreTwoLoopsAtTheKnownAngles)
{
  const double R = 1, r = 0.35;
  const Polyhedron torus = testing::torus(R, r, 60, 32);
  std::vector<Vec3f> normals;
  for (const Vec3f& p : torus.positions) {
    const double far = std::hypot(static_cast<double>(p.x), static_cast<double>(p.y));
    const Vec3d ring = {static_cast<double>(p.x) / far * R, static_cast<double>(p.y) / far * R, 0};
    normals.push_back(vec3Cast<float>(normalized(vec3Cast<double>(p) - ring)));
  }
  const Model model(torus.view(), normals);
  for (const double theta : {0.1, 0.5, 0.9, 1.3}) {
    // The axis is z; the gaze leans by theta towards x.
    const Vec3d toward = {std::sin(theta), 0.0, std::cos(theta)};
    const Stage stage = stageOf(testing::parallelView(toward * 5.0, {0, 0, 0}, 1.6));
    const ContourLines contours = model.smooth(stage);
    EXPECT_EQ(contours.chains.first.size(), 3u) << theta;
    EXPECT_EQ(closedChains(contours.chains), 2u) << theta;
    double worst = 0;
    for (const Vec3d& p : contours.points) {
      const double u = std::atan2(p.y, p.x), phi = std::atan2(p.z, std::hypot(p.x, p.y) - R);
      // n.v = cos(phi) cos(u) sin(theta) + sin(phi) cos(theta) = 0
      worst = std::max(worst, std::fabs(std::cos(phi) * std::cos(u) * std::sin(theta) +
                                        std::sin(phi) * std::cos(theta)));
    }
    EXPECT_LT(worst, 5e-3) << theta;
  }
}

// The hole's contour is, on the screen, inside of the axis' ellipse by r all along: it turns back
// where that bends more, with a radius below r, as its least one is R cos^2(theta). The torus
// itself lies before what goes on from there.
TEST(Contours, ThatTurnBackAreConcealedBehindTheSurface)
{
  const double R = 1, r = 0.35;
  const Polyhedron torus = testing::torus(R, r, 60, 32);
  const std::vector<Vec3f> normals = vertexNormals(torus.view(), NormalWeight::kAngle);
  const Model model(torus.view(), normals);
  // Below 0 inside.
  const auto depthUnder = [&](Vec3d p) {
    const double out = std::hypot(p.x, p.y) - R;
    return std::sqrt(out * out + p.z * p.z) - r;
  };
  for (const double theta : {0.2, 0.9, 1.0, 1.1, 1.2}) {
    const Vec3d toward = {std::sin(theta), 0.0, std::cos(theta)};
    const Stage stage = stageOf(testing::parallelView(toward * 5.0, {0, 0, 0}, 1.6));
    const ContourLines contours = model.smooth(stage);
    std::size_t runs = 0;
    for (std::size_t i = 0; i < contours.chains.flags.size(); ++i) {
      if ((contours.chains.flags[i] & kConcealedLine) == 0) continue;
      runs += i == 0 || (contours.chains.flags[i - 1] & kConcealedLine) == 0 ? 1 : 0;
      EXPECT_FALSE(contours.facets[i].bulges);
      const Vec3d place = (contours.points[contours.chains.vertex[i]] +
                           contours.points[contours.chains.vertex[i + 1]]) *
                          0.5;
      double least = 1;
      for (double way = 0.01; way < 1; way += 0.01)
        least = std::min(least, depthUnder(place + toward * way));
      EXPECT_LT(least, 0) << theta;
    }
    const bool turnsBack = R * std::cos(theta) * std::cos(theta) < r;
    EXPECT_EQ(runs > 1, turnsBack) << theta;
    EXPECT_EQ(runs > 0, turnsBack) << theta;
  }
}

TEST(Contours, OfClosedMeshesAreClosedInEveryFrameOfATurn)
{
  const OwnedMesh sphere = testing::sphere(9, 10);
  const Polyhedron torus = testing::torus(1, 0.4, 14, 9);
  std::vector<Vec3f> normals = vertexNormals(torus.view(), NormalWeight::kArea);
  const Model models[] = {Model(sphere.view(), sphere.vertexNormals), Model(torus.view(), normals)};
  for (const Model& model : models)
    for (int frame = 0; frame < 360; ++frame) {
      const double angle = frame * kPi / 180;
      const Stage stage = stageOf(
          testing::perspectiveView({4 * std::cos(angle), 1.3, 4 * std::sin(angle)}, {0, 0, 0}, 40));
      const ContourLines contours = model.smooth(stage);
      ASSERT_FALSE(contours.chains.empty());
      ASSERT_EQ(closedChains(contours.chains) + 1, contours.chains.first.size()) << frame;
      ASSERT_EQ(oddPoints(contours.chains), 0u) << frame;
      ASSERT_EQ(oddPoints(model.edges(stage).chains), 0u) << frame;
    }
}

// Where its patches end the teapot is open; there alone a contour may end.
TEST(Contours, OfTheTeapotEndAtItsBordersOnlyInEveryFrameOfATurn)
{
  const GeneratedMesh generated = teapot(5);
  Polyhedron mesh;
  mesh.positions = generated.positions;
  mesh.triangles = generated.triangles();
  const std::vector<std::uint32_t> place = weldVertices(mesh.view(), 0, 2);
  for (Triangle& triangle : mesh.triangles)
    for (std::uint32_t& v : triangle.vertex)
      v = place[v];
  const std::vector<Vec3f> normals = vertexNormals(mesh.view(), NormalWeight::kAngle);
  const Model model(mesh.view(), normals);
  std::size_t ends = 0;
  for (int frame = 0; frame < 360; ++frame) {
    const double angle = frame * kPi / 180;
    const Vec3d eye = {9 * std::cos(angle), 4.3, 9 * std::sin(angle)};
    const Stage stage = stageOf(testing::perspectiveView(eye, {0, 0, 0}, 40, {1, 30}));
    const auto isFront = [&](std::uint32_t v) {
      return dot(vec3Cast<double>(normals[v]), eye - mesh.view().position(v)) >= 0;
    };
    std::size_t crossedBorders = 0;
    for (const MeshEdge& edge : model.table.edges)
      crossedBorders +=
          edge.faceCount % 2 != 0 && isFront(edge.vertex[0]) != isFront(edge.vertex[1]) ? 1 : 0;
    ASSERT_EQ(oddPoints(model.smooth(stage).chains), crossedBorders) << frame;
    ends += crossedBorders;
    ASSERT_GT(model.smooth(stage).chains.vertex.size(), 100u);
  }
  RecordProperty("ends", std::to_string(ends));
}

TEST(Contours, FollowHardEdgesWhereOneSideIsSeen)
{
  const Polyhedron cube = testing::cube();
  SplitNormals split;
  ASSERT_TRUE(splitVertexNormals(cube.view(), cube.cells, NormalWeight::kArea, 30, 2, split).ok());
  Model model(cube.view(), split.normals);
  model.arrays.normalOfCorner = split.ofCorner;
  const Stage stage = stageOf(testing::perspectiveView({3, 2, 4}, {0, 0, 0}, 40));
  const ContourLines contours = model.smooth(stage);
  ASSERT_EQ(contours.chains.first.size(), 2u);
  EXPECT_EQ(contours.chains.vertex.size(), 7u) << "the hexagon";
  EXPECT_EQ(closedChains(contours.chains), 1u);
  EXPECT_EQ(model.edges(stage).chains.vertex.size(), 7u);
}

TEST(Contours, AreTheSameWhereNormalsAreToldByVertex)
{
  OwnedMesh sphere = testing::sphere(15, 16);
  for (Vec3f& position : sphere.positions)
    if (position.z > 0.5f) position.z = 0.5f;
  SplitNormals split;
  Array<std::uint32_t> only;
  ASSERT_TRUE(
      splitVertexNormals(sphere.view(), {}, NormalWeight::kAngle, 30, 2, split, &only).ok());
  const auto severals = std::count(only.begin(), only.end(), kNoOnlyNormal);
  ASSERT_GT(severals, 10) << "around the cut";
  ASSERT_LT(severals, 100);
  Model model(sphere.view(), split.normals);
  model.arrays.normalOfCorner = split.ofCorner;
  Model told = model;
  told.arrays.normalOfVertex = only;
  for (int i = 0; i < 12; ++i) {
    const double angle = i * kPi / 6;
    const Vec3d eye = {4 * std::cos(angle), 4 * std::sin(angle), 1.0 + 0.3 * i};
    const Stage stage = stageOf(testing::perspectiveView(eye, {0, 0, 0}, 50));
    const ContourLines expected = model.smooth(stage), actual = told.smooth(stage);
    ASSERT_FALSE(expected.points.empty());
    ASSERT_EQ(actual.points.size(), expected.points.size());
    for (std::size_t p = 0; p < expected.points.size(); ++p)
      EXPECT_TRUE(actual.points[p] == expected.points[p]);
    EXPECT_EQ(actual.chains.vertex, expected.chains.vertex);
    EXPECT_EQ(actual.chains.first, expected.chains.first);
  }
}

TEST(Contours, OfAPlaneAreNone)
{
  const Polyhedron plane = testing::plane(4);
  const std::vector<Vec3f> normals(plane.positions.size(), {0, 0, 1});
  const Model model(plane.view(), normals);
  const Stage stage = stageOf(testing::perspectiveView({1, 0.4, 3}, {0, 0, 0}, 50));
  EXPECT_TRUE(model.smooth(stage).chains.empty());
  EXPECT_TRUE(model.edges(stage).chains.empty());
}

TEST(Contours, WindingAndMirrorsChangeNothing)
{
  OwnedMesh sphere = testing::sphere(15, 16);
  const Stage stage = stageOf(testing::perspectiveView({2, 1, 3}, {0, 0, 0}, 50));
  const std::size_t edges = Model(sphere.view(), sphere.vertexNormals).edges(stage).edge.size();
  const std::size_t links = Model(sphere.view(), sphere.vertexNormals).smooth(stage).points.size();
  const Mat4d mirrored = {{{-1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
  const Stage turned = stageOf(testing::perspectiveView({-2, 1, 3}, {0, 0, 0}, 50));
  EXPECT_EQ(Model(sphere.view(), sphere.vertexNormals).smooth(turned, mirrored).points.size(),
            links);
  for (std::size_t t = 0; t < sphere.triangles.size(); t += 3)
    std::swap(sphere.triangles[t].vertex[1], sphere.triangles[t].vertex[2]);
  EXPECT_EQ(Model(sphere.view(), sphere.vertexNormals).edges(stage).edge.size(), edges);
  EXPECT_EQ(Model(sphere.view(), sphere.vertexNormals).smooth(stage).points.size(), links);
}

/// Breaks of a closed outline: angles about the centre of the picture at which it is not there.
int missingAngles(const testing::Picture& picture, double low, double high)
{
  int missing = 0;
  const double middle = picture.width / 2.0;
  for (int i = 0; i < 720; ++i) {
    const double angle = i * kPi / 360;
    bool isThere = false;
    for (double radius = low; radius < high && !isThere; radius += 0.5) {
      const int x = static_cast<int>(middle + radius * std::cos(angle));
      const int y = static_cast<int>(middle + radius * std::sin(angle));
      isThere = testing::at(picture, x, y).r > 90;
    }
    missing += isThere ? 0 : 1;
  }
  return missing;
}

class ContourPictures : public testing::BothBackends {};

TEST_P(ContourPictures, AnOutlineNeverBreaksWhileACoarseSphereTurns)
{
  const OwnedMesh sphere = testing::sphere(9, 12);
  const Model model(sphere.view(), sphere.vertexNormals);
  LineStyle style;
  style.color = {1, 0, 0};
  for (int frame = 0; frame < 360; ++frame) {
    const double angle = frame * kPi / 180;
    Stage stage;
    stage.view =
        testing::perspectiveView({3 * std::cos(angle), 0.9, 3 * std::sin(angle)}, {0, 0, 0}, 50);
    stage.width = stage.height = 96;
    const double radius = 48 / std::tan(25 * kPi / 180) / std::sqrt(9 + 0.81 - 1);
    const ContourLines contours = model.smooth(stage);
    const EdgeChains edges = model.edges(stage);
    const LineSet sets[] = {contours.lines(style), edges.chains.lines(sphere.view(), style)};
    stage.instances = {testing::painted(sphere, {0, 0, 1})};
    for (int kind = 0; kind < 2; ++kind) {
      stage.instances[0].lines = {sets + kind, 1};
      const testing::Picture picture = draw(stage);
      ASSERT_EQ(missingAngles(picture, kind == 0 ? radius - 2 : radius * 0.9, radius + 2), 0)
          << "frame " << frame << (kind == 0 ? ", smooth" : ", edges");
    }
  }
}

TEST_P(ContourPictures, AnOutlineHasNoGapsWhereLargeFacetsHideIt)
{
  const OwnedMesh sphere = testing::sphere(8, 12);
  const Model model(sphere.view(), sphere.vertexNormals);
  LineStyle style;
  style.color = {1, 0, 0};
  const int end = GetParam() == Backend::kReference ? 160 : 180;
  for (int frame = 156; frame < end; ++frame) {
    const double angle = frame * kPi / 90;
    const double distance = 6.7, height = -1.6 - 0.01 * frame;
    const double level = std::sqrt(distance * distance - height * height);
    Stage stage;
    stage.view = testing::perspectiveView(
        {level * std::cos(angle), height, level * std::sin(angle)}, {0, 0, 0}, 27);
    stage.width = stage.height = 480;
    const double radius = 240 / std::tan(13.5 * kPi / 180) / std::sqrt(distance * distance - 1);
    const ContourLines contours = model.smooth(stage);
    const LineSet set = contours.lines(style);
    stage.instances = {testing::painted(sphere, {0, 0, 1})};
    stage.instances[0].lines = {&set, 1};
    EXPECT_EQ(missingAngles(draw(stage), radius * 0.9, radius + 2), 0) << "frame " << frame;
  }
}
LIMN_ON_BOTH_BACKENDS(ContourPictures);

}  // namespace
}  // namespace limn
