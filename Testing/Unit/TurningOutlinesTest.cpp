// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Lines from the picture of solids that turn: outer outlines never break, and nothing is peppered.
#include "Data/Generator/GeneratedMeshes.h"
#include "Testing/Unit/TestScene.h"

#include <algorithm>
#include <cmath>

namespace limn::testing {
namespace {

constexpr double kPi = 3.14159265358979323846;
/// Pixels that are lighter, less than a fifth dark, are not a line's.
constexpr int kLight = 205;
constexpr int kSamples = 4;

class TurningOutlines : public BothBackends {};
LIMN_ON_BOTH_BACKENDS(TurningOutlines);

struct Place {
  int x, y;
};

/// Pixels of a picture, and which of them have been visited.
class Flood {
 public:
  explicit Flood(const Picture& picture) : picture_(picture), isSeen_(picture.color.size(), false)
  {
  }

  /// Visits what can be reached from a place over pixels for which mayEnter(x, y), and returns it.
  template <class MayEnter>
  std::vector<Place> from(Place start, bool overCorners, MayEnter mayEnter)
  {
    std::vector<Place> found;
    enter(start, found, mayEnter);
    for (std::size_t i = 0; i < found.size(); ++i)
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx)
          if (overCorners || dx == 0 || dy == 0)
            enter({found[i].x + dx, found[i].y + dy}, found, mayEnter);
    return found;
  }

 private:
  template <class MayEnter>
  void enter(Place p, std::vector<Place>& found, MayEnter mayEnter)
  {
    if (p.x < 0 || p.y < 0 || p.x >= picture_.width || p.y >= picture_.height) return;
    const auto i = static_cast<std::size_t>(p.y * picture_.width + p.x);
    if (isSeen_[i] || !mayEnter(p.x, p.y)) return;
    isSeen_[i] = true;
    found.push_back(p);
  }

  const Picture& picture_;
  std::vector<bool> isSeen_;
};

/// Whether the background runs through a gap in the line: to a pixel that lies inside of the
/// surface by more than another.
bool isBroken(const Picture& picture)
{
  const std::vector<Place> outside = Flood(picture).from(
      {0, 0}, false, [&](int x, int y) { return at(picture, x, y).g > kLight; });
  const auto isInside = [&](Place p) {
    for (int y = p.y - 1; y <= p.y + 1; ++y)
      for (int x = p.x - 1; x <= p.x + 1; ++x) {
        if (x < 0 || y < 0 || x >= picture.width || y >= picture.height) return false;
        const auto i = static_cast<std::size_t>(y * picture.width + x);
        if (bitCount(picture.coverage[i]) < kSamples) return false;
      }
    return true;
  };
  return std::any_of(outside.begin(), outside.end(), isInside);
}

/// Lines of few pixels that touch no other.
std::size_t specks(const Picture& picture)
{
  constexpr std::size_t kFew = 5;
  Flood flood(picture);
  std::size_t count = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const std::size_t size =
          flood
              .from({x, y}, true,
                    [&](int column, int row) { return at(picture, column, row).g <= kLight; })
              .size();
      count += size > 0 && size < kFew ? 1 : 0;
    }
  return count;
}

OwnedMesh owned(const GeneratedMesh& mesh)
{
  OwnedMesh result;
  result.positions = mesh.positions;
  result.triangles = mesh.triangles();
  result.vertexNormals = mesh.normals;
  finish(result);
  return result;
}

/// Draws the solid, white with a black line over white, in the frames of a turn, and calls
/// check(picture, number of the frame).
template <class Check>
void turn(const OwnedMesh& mesh, double radius, int height, Backend backend, Check check)
{
  Stage stage;
  stage.width = height * 4 / 3;
  stage.height = height;
  stage.samples = kSamples;
  stage.resolve = Resolve::kLinear;
  stage.instances = {painted(mesh, {1, 1, 1})};
  Style& style = stage.instances[0].style;
  style.imageOutline.detector = OutlineDetector::kPlane;
  style.imageOutline.creaseDegrees = 180;
  style.outlineWidth = 2;
  const int step = backend == Backend::kReference ? 40 : 1;  // which takes its time
  for (int frame = 0; frame < 360; frame += step) {
    const double angle = frame * kPi / 180, far = 4 * radius;
    stage.view = perspectiveView({far * std::cos(angle), 0.4 * far, far * std::sin(angle)},
                                 {0, 0, 0}, 32, {2 * radius, 8 * radius});
    Picture picture(stage.width, stage.height);
    std::fill(picture.color.begin(), picture.color.end(), Rgba8{255, 255, 255, 255});
    stage.drawOver(picture, backend);
    check(picture, frame);
  }
}

/// About the origin.
OwnedMesh pot()
{
  GeneratedMesh mesh = teapot(6);
  for (Vec3f& p : mesh.positions)
    p = p - Vec3f{0, 1.5f, 0};
  return owned(mesh);
}

TEST_P(TurningOutlines, NeverBreak)
{
  const OwnedMesh solids[] = {pot(), sphere(9, 12)};
  const double radius[] = {3.4, 1.1};
  for (int i = 0; i < 2; ++i)
    turn(solids[i], radius[i], 192, GetParam(), [&](const Picture& picture, int frame) {
      EXPECT_FALSE(isBroken(picture)) << "solid " << i << ", frame " << frame;
    });
}

TEST_P(TurningOutlines, AreNotPeppered)
{
  std::size_t count = 0;
  turn(pot(), 3.4, 96, GetParam(), [&](const Picture& picture, int) { count += specks(picture); });
  EXPECT_EQ(count, 0u);
}

/// A sheet, and before it a small square of the same mesh.
OwnedMesh squareBeforeSheet(double side)
{
  const auto quadrangle = [](double low, double size, double z) {
    const Vec3d a = {low, low, z}, u = {size, 0, 0}, v = {0, size, 0};
    return std::vector<Vec3d>{a, a + u, a + u + v, a, a + u + v, a + v};
  };
  std::vector<Vec3d> points = quadrangle(-10, 60, -8);
  const std::vector<Vec3d> square = quadrangle(12, side, 0);
  points.insert(points.end(), square.begin(), square.end());
  return soup(points);
}

TEST_P(TurningOutlines, StepsOfLessThanEightPixelsAreNone)
{
  // A square of n x n pixels is bordered by 4 (n - 1) of them.
  for (const int side : {1, 2, 3, 6}) {
    const OwnedMesh mesh = squareBeforeSheet(side);
    Stage stage = pixelStage(32, 4);
    stage.resolve = Resolve::kLinear;
    stage.instances = {painted(mesh, {1, 1, 1})};
    stage.instances[0].style.imageOutline.detector = OutlineDetector::kPlane;
    stage.instances[0].style.outlineWidth = 1;
    const Picture picture = draw(stage);
    int lined = 0;
    for (int y = 0; y < 32; ++y)
      for (int x = 0; x < 32; ++x)
        lined += at(picture, x, y).g < 128 ? 1 : 0;
    EXPECT_EQ(lined, side < 3 ? 0 : 4 * (side - 1)) << side;
  }
}

}  // namespace
}  // namespace limn::testing
