// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Textures on surfaces: where they are read, what they change, and in which order.
#include "Testing/Unit/TestScene.h"

#include <cmath>

namespace limn::testing {
namespace {

class TexturedSurfaces : public BothBackends {};
LIMN_ON_BOTH_BACKENDS(TexturedSurfaces);

constexpr int kSide = 64;

/// A sheet of kSide x kSide units that fills a picture of as many pixels; u and v from 0 to 1.
struct Board {
  OwnedMesh mesh = sheet({0, 0, 0}, {kSide, 0, 0}, {0, kSide, 0});
  TextureImage image;
  std::vector<TextureLayer> layers;
  Stage stage = pixelStage(kSide, 1);

  Board()
  {
    for (const Vec3f p : mesh.positions)
      mesh.uv.push_back({p.x / kSide, p.y / kSide});
    Instance instance = painted(mesh, {1, 1, 1});
    instance.attributes.uv = mesh.uv;
    instance.attributes.uv2 = mesh.uv;
    stage.instances = {instance};
  }
  void load(int width, int height, int components, const std::vector<std::uint8_t>& bytes)
  {
    const TextureView view = {width,        height,      components, TexelFormat::kUnorm8,
                              bytes.data(), bytes.size()};
    ASSERT_TRUE(image.build(view, MipChain::kFull).ok());
  }
  TextureLayer& add(TextureRole role, TextureMode mode = TextureMode::kModulate)
  {
    TextureLayer layer;
    layer.image = &image;
    layer.role = role;
    layer.mode = mode;
    layer.sampler.filter = TextureFilter::kNearest;
    layers.push_back(layer);
    return layers.back();
  }
  Picture draw(Backend backend)
  {
    stage.instances[0].layers = layers;
    return stage.draw(backend);
  }
  Instance& instance() { return stage.instances[0]; }
};

void expectColor(const Picture& picture, int x, int y, Vec3d color, double tolerance = 0.5)
{
  const Rgba8 c = at(picture, x, y);
  EXPECT_NEAR(c.r, 255 * color.x, tolerance) << x << ' ' << y;
  EXPECT_NEAR(c.g, 255 * color.y, tolerance) << x << ' ' << y;
  EXPECT_NEAR(c.b, 255 * color.z, tolerance) << x << ' ' << y;
}

std::vector<std::uint8_t> ramp(int side)
{
  std::vector<std::uint8_t> bytes;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      for (const int value : {x * 4, y * 4, (x * y) % 256})
        bytes.push_back(static_cast<std::uint8_t>(value));
  return bytes;
}

TEST_P(TexturedSurfaces, ShowEachTexelInItsPixel)
{
  Board board;
  board.load(kSide, kSide, 3, ramp(kSide));
  board.add(TextureRole::kShaded);
  const Picture picture = board.draw(GetParam());
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const Rgba8 c = at(picture, x, y);
      ASSERT_EQ(c.r, x * 4);
      ASSERT_EQ(c.g, y * 4);
      ASSERT_EQ(c.b, (x * y) % 256);
    }
}

TEST_P(TexturedSurfaces, MoveWithTheTransformOfTheirCoordinates)
{
  Board board;
  board.load(2, 1, 1, {0, 255});
  TextureLayer& layer = board.add(TextureRole::kShaded);
  // Four stripes along y.
  const float turned[6] = {0, 2, 0, 1, 0, 0};
  std::copy(turned, turned + 6, layer.uvTransform);
  const Picture picture = board.draw(GetParam());
  for (int y = 0; y < kSide; ++y)
    EXPECT_EQ(at(picture, 5, y).r, y / 16 % 2 == 0 ? 0 : 255) << y;
}

TEST_P(TexturedSurfaces, AreCombinedByTheirModes)
{
  const Vec3d c = {0.8, 0.4, 0.2}, t = {0.2, 1, 0.6};
  const double a = 102 / 255.0;
  const struct {
    TextureMode mode;
    Vec3d expected;
  } cases[] = {{TextureMode::kModulate, c * t},
               {TextureMode::kReplace, t},
               {TextureMode::kDecal, c * (1 - a) + t * a},
               {TextureMode::kAdd, {1, 1, 0.8}}};
  for (const TextureRole role : {TextureRole::kShaded, TextureRole::kSurface})
    for (const auto& one : cases) {
      Board board;
      board.instance().material.diffuseColor = vec3Cast<float>(c);
      board.load(1, 1, 4, {51, 255, 153, 102});
      board.add(role, one.mode);
      expectColor(board.draw(GetParam()), 9, 7, one.expected, 0.51);
    }
}

TEST_P(TexturedSurfaces, AreJoinedBeforeTheyArePutOver)
{
  const Vec3d surface = {0.55, 1, 0.7};
  const Vec3d c = {0.8, 0.4, 0.2}, t = {0.2, 1, 0.6};
  const double b = 204 / 255.0, a = 102 / 255.0;
  const Vec3d half = {0.5, 0.5, 0.5};
  // As a decal they show their common alpha, too.
  const struct {
    TextureJoin join;
    Vec3d color;
    double alpha;
  } cases[] = {{TextureJoin::kReplace, t * a + c * (1 - a), a + b * (1 - a)},
               {TextureJoin::kModulate, c * t, b * a},
               {TextureJoin::kAdd, t * a + c * b, b + a},
               {TextureJoin::kAddSigned, t * a + c * b - half, b + a - 0.5},
               {TextureJoin::kSubtract, c - t * a, b}};
  for (const auto& one : cases)
    for (const bool showsAlpha : {false, true}) {
      Board board;
      board.instance().material.diffuseColor = vec3Cast<float>(surface);
      board.load(1, 1, 4, {204, 102, 51, 204});
      TextureImage next;
      const std::uint8_t bytes[] = {51, 255, 153, 102};
      ASSERT_TRUE(
          next.build({1, 1, 4, TexelFormat::kUnorm8, bytes, sizeof bytes}, MipChain::kNone).ok());
      board.add(TextureRole::kShaded, showsAlpha ? TextureMode::kDecal : TextureMode::kModulate);
      TextureLayer& second = board.add(TextureRole::kShaded);
      second.image = &next;
      second.join = one.join;
      const Vec3d decal = surface + (one.color - surface) * one.alpha;
      const Vec3d shown = showsAlpha ? decal : surface * one.color;
      const auto bounded = [](double v) { return v < 0 ? 0 : v > 1 ? 1 : v; };
      expectColor(board.draw(GetParam()), 9, 9,
                  {bounded(shown.x), bounded(shown.y), bounded(shown.z)});
    }
}

TEST_P(TexturedSurfaces, AreJoinedWithOneOfTheirRoleOnly)
{
  const auto complaint = [&](TextureRole first, TextureRole second) {
    Board board;
    board.load(1, 1, 1, {0});
    board.add(first).join = first == second ? TextureJoin::kAdd : TextureJoin::kNone;
    board.add(second).join = TextureJoin::kAdd;
    board.instance().layers = board.layers;
    Picture picture(kSide, kSide);
    RenderOptions options;
    options.backend = GetParam();
    return render(board.stage.scene(), picture.frame(Background::kBlend), options).message;
  };
  EXPECT_EQ(complaint(TextureRole::kShaded, TextureRole::kShaded),
            "Instance 0: texture 0 is joined with the texture before it; there is none.");
  EXPECT_EQ(complaint(TextureRole::kShaded, TextureRole::kSurface),
            "Instance 0: texture 1 is joined with one of another role, or bends normals; only "
            "colours of the same role can be joined.");
}

TEST_P(TexturedSurfaces, DressTheSurfaceBeforeItIsLit)
{
  // The highlight is not textured, unless the texture comes last.
  for (const TextureRole role : {TextureRole::kSurface, TextureRole::kShaded}) {
    Board board;
    Instance& instance = board.instance();
    instance.style.reflection = Reflection::kBlinnPhong;
    instance.style.normals = NormalSource::kTriangle;
    instance.material.diffuse = 0.5f;
    instance.material.ambient = 0;
    instance.material.specular = 0.25f;
    Light light;
    light.kind = LightKind::kDirectional;
    board.stage.lights = {light};
    board.load(1, 1, 3, {51, 102, 255});
    board.add(role);
    const Vec3d t = {0.2, 0.4, 1}, glossy = {0.25, 0.25, 0.25};
    const Vec3d expected = role == TextureRole::kSurface ? t * 0.5 + glossy : t * 0.75;
    expectColor(board.draw(GetParam()), 20, 30, expected, 0.51);
  }
}

TEST_P(TexturedSurfaces, LightmapsAddWhatTheyHoldOfLight)
{
  Board board;
  Instance& instance = board.instance();
  instance.style.reflection = Reflection::kLambert;
  instance.material.diffuseColor = {0.5f, 1, 0.25f};
  instance.material.diffuse = 1;
  instance.material.ambient = 0;
  board.load(2, 1, 1, {0, 204});
  TextureLayer& layer = board.add(TextureRole::kLight);
  layer.uvSet = 1;
  layer.amount = 0.5f;
  const Picture dark = board.draw(GetParam());
  expectColor(dark, 10, 10, {0, 0, 0});
  expectColor(dark, 50, 10, {0.2, 0.4, 0.1});
}

TEST_P(TexturedSurfaces, NormalMapsTiltThePlane)
{
  Board board;
  Instance& instance = board.instance();
  instance.style.reflection = Reflection::kLambert;
  instance.style.normals = NormalSource::kTriangle;
  instance.material.ambient = 0;
  Light light;
  light.kind = LightKind::kDirectional;
  light.direction = {-0.6, 0, -0.8};
  board.stage.lights = {light};
  // n = (0.6, 0, 0.8): towards the light, from where u grows.
  board.load(1, 1, 3, {204, 128, 230});
  board.add(TextureRole::kNormal);
  const Vec3d n = normalized(Vec3d{2 * 204 / 255.0 - 1, 2 * 128 / 255.0 - 1, 2 * 230 / 255.0 - 1});
  const double lit = dot(n, Vec3d{0.6, 0, 0.8});
  EXPECT_GT(lit, 0.999);
  expectColor(board.draw(GetParam()), 12, 40, {lit, lit, lit}, 0.6);
}

TEST_P(TexturedSurfaces, BumpsFollowTheDerivativeOfTheirHeights)
{
  // Heights of 4 i in column i: a slope of 64 * 4 / 255 over the image.
  Board board;
  Instance& instance = board.instance();
  instance.style.reflection = Reflection::kLambert;
  instance.style.normals = NormalSource::kTriangle;
  instance.material.ambient = 0;
  Light light;
  light.kind = LightKind::kDirectional;
  light.direction = {0.6, 0, -0.8};
  board.stage.lights = {light};
  board.load(kSide, kSide, 3, ramp(kSide));
  board.add(TextureRole::kBump).amount = 0.5f;
  const double slope = 0.5 * kSide * 4 / 255.0;
  const Vec3d n = normalized(Vec3d{-slope, 0, 1});
  const double lit = dot(n, Vec3d{-0.6, 0, 0.8});
  expectColor(board.draw(GetParam()), 30, 40, {lit, lit, lit}, 0.6);
}

TEST_P(TexturedSurfaces, AreCorrectInPerspective)
{
  // A checker on the floor: the ray through each pixel says which field it shows.
  const OwnedMesh floor = sheet({-8, -8, 0}, {16, 0, 0}, {0, 16, 0});
  ProceduralTexture checker;
  checker.colorA = {1, 1, 1, 1};
  checker.colorB = {0, 0, 0, 1};
  TextureLayer layer;
  layer.procedural = &checker;
  Stage stage;
  stage.view = perspectiveView({0.3, -4, 1.5}, {0, 0, 0}, 50);
  Instance instance = painted(floor, {1, 1, 1});
  instance.layers = {&layer, 1};
  stage.instances = {instance};
  const auto field = [](const Hit& hit) -> std::optional<Vec3d> {
    const double x = hit.position.x, y = hit.position.y;
    if (std::fabs(x) > 7.9 || std::fabs(y) > 7.9) return std::nullopt;
    if (std::fabs(x - std::round(x)) < 0.01 || std::fabs(y - std::round(y)) < 0.01)
      return std::nullopt;
    const bool isWhite = (static_cast<int>(std::floor(x) + std::floor(y)) & 1) == 0;
    return isWhite ? Vec3d{1, 1, 1} : Vec3d{0, 0, 0};
  };
  stage.view.eye = {0.3, -1.5, 2.5};
  expectPicture(stage, draw(stage), hitPlane, field, kRounding);
}

TEST_P(TexturedSurfaces, AreLeftOutFromInside)
{
  Board board;
  board.load(1, 1, 1, {0});
  board.add(TextureRole::kShaded).onBackFaces = false;
  board.draw(GetParam());
  EXPECT_EQ(at(board.draw(GetParam()), 3, 3).r, 0);
  for (Triangle& triangle : board.mesh.triangles)
    std::swap(triangle.vertex[1], triangle.vertex[2]);
  finish(board.mesh);
  EXPECT_EQ(at(board.draw(GetParam()), 3, 3).r, 255);
}

TEST_P(TexturedSurfaces, WithoutCoordinatesAreAnError)
{
  Board board;
  board.load(1, 1, 1, {0});
  board.add(TextureRole::kShaded);
  board.instance().attributes.uv = {};
  board.instance().layers = board.layers;
  Picture picture(kSide, kSide);
  RenderOptions options;
  options.backend = GetParam();
  const Status status = render(board.stage.scene(), picture.frame(Background::kBlend), options);
  EXPECT_EQ(status.error, Error::kMissingData);
  EXPECT_EQ(status.message,
            "Instance 0: texture 0 needs texture coordinates, and the mesh has none.");
}

}  // namespace
}  // namespace limn::testing
