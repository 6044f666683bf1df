// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Testing/Agreement/RandomScene.h"

#include "Rendering/Mesh/MoveVertices.h"
#include "Testing/Agreement/RandomShaders.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace limn::testing {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Mat4d lookAt(Vec3d eye, Vec3d target)
{
  const Vec3d back = normalized(eye - target);
  const Vec3d up = std::fabs(back.y) < 0.9 ? Vec3d{0, 1, 0} : Vec3d{1, 0, 0};
  const Vec3d right = normalized(cross(up, back));
  const Vec3d above = cross(back, right);
  return {{{right.x, right.y, right.z, -dot(right, eye)},
           {above.x, above.y, above.z, -dot(above, eye)},
           {back.x, back.y, back.z, -dot(back, eye)},
           {0, 0, 0, 1}}};
}

Mat4d perspective(double tangent, double aspect, double near, double far)
{
  return {{{1 / (tangent * aspect), 0, 0, 0},
           {0, 1 / tangent, 0, 0},
           {0, 0, -(far + near) / (far - near), -2 * far * near / (far - near)},
           {0, 0, -1, 0}}};
}

Mat4d parallel(double halfHeight, double aspect, double near, double far)
{
  return {{{1 / (halfHeight * aspect), 0, 0, 0},
           {0, 1 / halfHeight, 0, 0},
           {0, 0, -2 / (far - near), -(far + near) / (far - near)},
           {0, 0, 0, 1}}};
}

bool isExaggeration(RandomScene::Detail detail)
{
  return detail == RandomScene::Detail::kExaggerated ||
         detail == RandomScene::Detail::kCreasedExaggeration;
}

enum class Shape { kSoup, kSlivers, kGrid, kCoincident, kHuge, kTiny, kShapes };

void addTriangle(OwnedMesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c)
{
  mesh.triangles.push_back({{a, b, c}});
}

std::vector<Vec3d> makeShape(Random& random, Shape shape, OwnedMesh& mesh)
{
  std::vector<Vec3d> points;
  if (shape == Shape::kGrid) {
    const std::uint32_t side = 3 + random.below(14);
    for (std::uint32_t j = 0; j < side; ++j)
      for (std::uint32_t i = 0; i < side; ++i)
        points.push_back(
            {2.0 * i / (side - 1) - 1, 2.0 * j / (side - 1) - 1, random.between(-0.2, 0.2)});
    for (std::uint32_t j = 0; j + 1 < side; ++j)
      for (std::uint32_t i = 0; i + 1 < side; ++i) {
        const std::uint32_t p = j * side + i;
        addTriangle(mesh, p, p + 1, p + side + 1);
        addTriangle(mesh, p, p + side + 1, p + side);
      }
    return points;
  }
  const double size = shape == Shape::kHuge ? 60 : shape == Shape::kTiny ? 0.02 : 0.8;
  const std::uint32_t count = 20 + random.below(200);
  for (std::uint32_t t = 0; t < count; ++t) {
    const auto first = static_cast<std::uint32_t>(points.size());
    const Vec3d centre = random.inBox(1);
    const Vec3d a = centre + random.inBox(size), b = centre + random.inBox(size);
    const Vec3d aside = random.inBox(1e-3);
    const Vec3d c = shape == Shape::kSlivers ? a + (b - a) * random.between(0, 1) + aside
                                             : centre + random.inBox(size);
    points.insert(points.end(), {a, b, c});
    addTriangle(mesh, first, first + 1, first + 2);
    // The same face again, as it is, turned, or over other corners.
    if (shape == Shape::kCoincident) {
      addTriangle(mesh, first + random.below(3), first + 1, first + 2);
      addTriangle(mesh, first + 2, first + 1, first);
    }
  }
  return points;
}

/// Rings of quads about the y axis, each cut in two.
std::vector<Vec3d> makeBumpySphere(Random& random, OwnedMesh& mesh)
{
  const std::uint32_t side = 40 + random.below(90);
  const double bumps = random.between(0, 0.2), waves = random.between(1, 12);
  const Vec3d centre = random.inBox(0.7);
  std::vector<Vec3d> points;
  for (std::uint32_t j = 0; j <= side; ++j)
    for (std::uint32_t i = 0; i < side; ++i) {
      const double u = 2 * kPi * i / side, v = kPi * j / side;
      const double r = 0.6 + bumps * std::sin(waves * u) * std::sin(waves * v);
      points.push_back(centre + Vec3d{r * std::sin(v) * std::cos(u), r * std::cos(v),
                                      r * std::sin(v) * std::sin(u)});
    }
  for (std::uint32_t j = 0; j < side; ++j)
    for (std::uint32_t i = 0; i < side; ++i) {
      const std::uint32_t a = j * side + i, b = j * side + (i + 1) % side;
      addTriangle(mesh, a, b, b + side);
      addTriangle(mesh, a, b + side, a + side);
    }
  return points;
}

/// Tetrahedra and boxes, flat ones and needles among them, each triangle with its own points or
/// not, some open, some inside out.
std::vector<Vec3d> makeSolids(Random& random, OwnedMesh& mesh)
{
  constexpr std::uint32_t kFaces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                          {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  std::vector<Vec3d> corners, points;
  const bool isSoup = random.chance(2), isInsideOut = random.chance(6);
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (isInsideOut) std::swap(b, c);
    if (!isSoup) return addTriangle(mesh, a, b, c);
    const auto first = static_cast<std::uint32_t>(points.size());
    points.insert(points.end(), {corners[a], corners[b], corners[c]});
    addTriangle(mesh, first, first + 1, first + 2);
  };
  for (std::uint32_t solids = 1 + random.below(6); solids > 0; --solids) {
    const auto first = static_cast<std::uint32_t>(corners.size());
    const double size = random.chance(5) ? 8 : 0.7;
    const Vec3d centre = random.inBox(1), u = random.inBox(size), v = random.inBox(size),
                w = random.chance(5) ? cross(u, v) * 1e-7 : random.inBox(size);
    for (std::uint32_t i = 0; i < 8; ++i)
      corners.push_back(centre + (u * ((i & 1u) - 0.5) + v * (((i >> 1) & 1u) - 0.5)) +
                        w * ((i >> 2) - 0.5));
    const bool turned = dot(cross(u, v), w) < 0;
    for (const auto& face : kFaces) {
      if (random.chance(20)) continue;
      const std::uint32_t a = first + face[0], b = first + face[turned ? 3 : 1],
                          c = first + face[2], d = first + face[turned ? 1 : 3];
      add(a, b, c);
      add(a, c, d);
    }
  }
  if (mesh.triangles.empty()) add(0, 1, 2);
  return isSoup ? points : corners;
}

/// An uneven sheet across the picture.
std::vector<Vec3d> makeSheet(Random& random, OwnedMesh& mesh)
{
  const std::uint32_t side = 2 + random.below(5);
  const double depth = random.between(-1, 1);
  std::vector<Vec3d> points;
  for (std::uint32_t j = 0; j < side; ++j)
    for (std::uint32_t i = 0; i < side; ++i)
      points.push_back({5.0 * i / (side - 1) - 2.5, 5.0 * j / (side - 1) - 2.5,
                        depth + random.between(-0.4, 0.4)});
  for (std::uint32_t j = 0; j + 1 < side; ++j)
    for (std::uint32_t i = 0; i + 1 < side; ++i) {
      const std::uint32_t p = j * side + i;
      addTriangle(mesh, p, p + 1, p + side + 1);
      addTriangle(mesh, p, p + side + 1, p + side);
    }
  return points;
}

}  // namespace

Picture::Picture(int w, int h) : width(w), height(h)
{
  const auto pixels = static_cast<std::size_t>(w) * static_cast<std::size_t>(h);
  color.resize(pixels);
  depth.resize(pixels, 1.0f);
  coverage.resize(pixels, 0);
  instance.resize(pixels, kNobody);
  cell.resize(pixels, kNobody);
}

FrameView Picture::frame(Background background)
{
  FrameView view;
  view.width = width;
  view.height = height;
  view.rowStride = width;
  view.color = color.data();
  view.depth = depth.data();
  view.coverage = coverage.empty() ? nullptr : coverage.data();
  view.instance = instance.data();
  view.cell = cell.data();
  view.background = background;
  if (!radiance[0].empty())
    view.radiance = {radiance[0].data(), radiance[1].data(), radiance[2].data()};
  if (!normal[0].empty()) view.normal = {normal[0].data(), normal[1].data(), normal[2].data()};
  return view;
}

void Picture::addRadiance()
{
  for (std::vector<float>& plane : radiance)
    plane.resize(color.size());
  for (std::size_t i = 0; i < color.size(); ++i) {
    radiance[0][i] = static_cast<float>(color[i].r) / 255.0f;
    radiance[1][i] = static_cast<float>(color[i].g) / 255.0f;
    radiance[2][i] = static_cast<float>(color[i].b) / 255.0f;
  }
}

void Picture::addNormals()
{
  for (std::vector<float>& plane : normal)
    plane.resize(color.size());
}

void Picture::sortLinePixels()
{
  std::sort(linePixels.begin(), linePixels.end(), [](const LinePixel& a, const LinePixel& b) {
    return a.y != b.y ? a.y < b.y : a.x < b.x;
  });
}

std::size_t Picture::differingPixels(const Picture& other) const
{
  const auto floatsDiffer = [&](std::size_t i) {
    for (std::size_t c = 0; c < 3; ++c)
      if ((!radiance[c].empty() &&
           std::memcmp(&radiance[c][i], &other.radiance[c][i], sizeof(float)) != 0) ||
          (!normal[c].empty() &&
           std::memcmp(&normal[c][i], &other.normal[c][i], sizeof(float)) != 0))
        return true;
    return false;
  };
  std::size_t count = 0;
  for (std::size_t i = 0; i < color.size(); ++i)
    if (floatsDiffer(i) || std::memcmp(&color[i], &other.color[i], sizeof color[i]) != 0 ||
        std::memcmp(&depth[i], &other.depth[i], sizeof depth[i]) != 0 ||
        (!coverage.empty() && coverage[i] != other.coverage[i]) ||
        instance[i] != other.instance[i] || cell[i] != other.cell[i])
      ++count;
  return count;
}

namespace {

bool hasImageLines(RandomScene::Detail detail)
{
  return detail == RandomScene::Detail::kImageLines || detail == RandomScene::Detail::kCreases ||
         detail == RandomScene::Detail::kIdBorders;
}

}  // namespace

RandomScene::RandomScene(std::uint32_t seed, Detail detail) : seed_(seed)
{
  Random random(seed);
  width_ = 1 + static_cast<int>(random.below(150));
  height_ = 1 + static_cast<int>(random.below(150));
  centre_ = random.chance(4) ? random.inBox(1e7) : Vec3d{0, 0, 0};
  const std::uint32_t meshes = 1 + random.below(3);
  for (std::uint32_t i = 0; i < meshes; ++i)
    addMesh(random, detail);
  for (std::uint32_t i = 0; i < meshes; ++i)
    instances_.push_back(instanceOf(random, *meshes_[i], 7 + i, detail));
  if (random.chance(3)) instances_.push_back(instanceOf(random, *meshes_[0], 42, detail));
  const std::uint32_t lights = random.below(4);
  for (std::uint32_t i = 0; i < lights; ++i)
    lights_.push_back(randomLight(random));
  // VTK's default, which has a path of its own.
  if (random.chance(4)) lights_ = {Light{}};
  placeCamera(random);
  if (detail == Detail::kLights) addLights();
  if (detail == Detail::kLines || detail == Detail::kLineShares ||
      (detail == Detail::kCues && seed % 4 == 1))
    addLines(Random(seed ^ 0x11E5u));
  if (detail == Detail::kLineShares) addShares();
  if (detail == Detail::kVeils && seed % 4 != 0) addLines(Random(seed ^ 0x7E1Bu));
  const bool isShaded = detail == Detail::kShaders;
  const bool isHatched = detail == Detail::kHatching;
  const bool isExaggerated = isExaggeration(detail);
  const bool isToned = detail == Detail::kTones || isHatched || isExaggerated;
  const bool isVeiled = detail == Detail::kVeils;
  const bool isTranslucent = detail == Detail::kTranslucent || detail == Detail::kFineTranslucent ||
                             isVeiled || (isToned && seed % 5 == 2);
  if (detail == Detail::kReflections || isShaded || isToned) addReflections();
  if (detail == Detail::kTextures || isShaded || (isTranslucent && seed % 5 == 0) ||
      (isToned && seed % 3 == 0))
    addTextures();
  if (isTranslucent) addTranslucency();
  if (isHatched)
    addHatching();
  else if (isExaggerated)
    addExaggeration(detail);
  else if (isToned)
    addTones();
  if (detail == Detail::kDataTones) addDataTones();
  if (detail == Detail::kHulls) addHulls();
  if (hasImageLines(detail) || (isVeiled && seed % 3 == 1)) addImageLines();
  if (detail == Detail::kCreases) addCreaseDetectors();
  if (detail == Detail::kIdBorders) addIds();
  if (detail == Detail::kCues || (isVeiled && seed % 3 == 0)) addCues();
  scene_.ambientLight = random.color();
  scene_.lights = lights_;
  scene_.instances = instances_;
  scene_.samples = 1 << random.below(4);
  if (isTranslucent) scene_.samples = 1 << Random(seed ^ 0x5EEDu).below(5);
  scene_.resolve = random.chance(4) ? Resolve::kLinear : Resolve::kGamma22;
  background_ = random.chance(2) ? Background::kBlend : Background::kKeepApart;
  if (isVeiled && seed % 6 != 0) background_ = Background::kBlend;
  if (detail == Detail::kPost) addEffects(Random(seed ^ 0xB100Du));
  if (isShaded || ((isTranslucent || isToned) && seed % 7 == 0))
    addShaders(Random(seed ^ 0x54ADEu));
}

Picture RandomScene::canvas() const
{
  Picture picture(width_, height_);
  if (scene_.samples > 8) picture.coverage.clear();
  Random random(seed_ ^ 0xC0FFEEu);
  const bool oldDepths = random.chance(3);
  for (std::size_t i = 0; i < picture.color.size(); ++i) {
    picture.color[i] = {static_cast<std::uint8_t>(i * 7), static_cast<std::uint8_t>(i / 3), 40, 0};
    if (oldDepths && i % 5 == 0) picture.depth[i] = static_cast<float>(random.between(0, 1));
  }
  return picture;
}

void RandomScene::addMesh(Random& random, Detail detail)
{
  auto mesh = std::make_unique<OwnedMesh>();
  const auto shape = static_cast<Shape>(random.below(static_cast<std::uint32_t>(Shape::kShapes)));
  std::vector<Vec3d> points =
      detail == Detail::kFine || detail == Detail::kFineTranslucent ||
              (detail == Detail::kHulls && seed_ % 8 == 0) ||
              ((detail == Detail::kLines || detail == Detail::kLineShares) && seed_ % 5 == 0) ||
              ((hasImageLines(detail) || detail == Detail::kCues) && seed_ % 3 == 1) ||
              (isExaggeration(detail) && seed_ % 3 == 1)
          ? makeBumpySphere(random, *mesh)
      : detail == Detail::kHulls ? makeSolids(random, *mesh)
      : detail == Detail::kCoarse ||
              ((detail == Detail::kTextures || detail == Detail::kShaders ||
                detail == Detail::kTranslucent || detail == Detail::kTones ||
                detail == Detail::kDataTones || detail == Detail::kLines ||
                detail == Detail::kLineShares || detail == Detail::kHatching ||
                isExaggeration(detail) || hasImageLines(detail) || detail == Detail::kCues ||
                detail == Detail::kVeils) &&
               seed_ % 2 == 0)
          ? makeSheet(random, *mesh)
          : makeShape(random, shape, *mesh);
  if (random.chance(6)) {
    points[random.below(static_cast<std::uint32_t>(points.size()))].y = kInfinity;
    points[random.below(static_cast<std::uint32_t>(points.size()))].z = std::nan("");
    mesh->triangles[0].vertex[1] = static_cast<std::uint32_t>(points.size()) + 5;
  }
  for (Vec3d& p : points)
    p = p + centre_;
  // Floats at 1e7 are whole numbers: such scenes come in double.
  if (centre_ == Vec3d{0, 0, 0} && !random.chance(4)) {
    for (const Vec3d& p : points)
      mesh->positions.push_back(vec3Cast<float>(p));
  } else {
    mesh->precise = points;
  }
  addAttributes(random, *mesh);
  const Status status = buildClusters(mesh->view(), 0, mesh->clusters);
  if (!status.ok()) std::abort();
  meshes_.push_back(std::move(mesh));
}

void RandomScene::addAttributes(Random& random, OwnedMesh& mesh)
{
  const std::size_t vertices = mesh.view().vertexCount();
  const auto byte = [&] { return static_cast<std::uint8_t>(random.below(256)); };
  for (std::size_t v = 0; v < vertices; ++v)
    mesh.vertexNormals.push_back(vec3Cast<float>(random.inBox(1)));
  mesh.cellCount = mesh.triangles.size();
  if (random.chance(3)) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      mesh.cells.push_back(static_cast<std::uint32_t>(t / 2));
    mesh.cellCount = mesh.triangles.size() / 2 + 1;
  }
  for (std::size_t c = 0; c < mesh.cellCount; ++c)
    mesh.cellNormals.push_back(vec3Cast<float>(random.inBox(1)));
  if (random.chance(3))
    for (std::size_t v = 0; v < vertices; ++v)
      mesh.vertexColors.push_back({byte(), byte(), byte(), 255});
  if (random.chance(3))
    for (std::size_t c = 0; c < mesh.cellCount; ++c)
      mesh.cellColors.push_back({byte(), byte(), byte(), 255});
  mesh.faces = faceGeometry(mesh.view(), mesh.cells, mesh.cellCount);
}

Instance RandomScene::instanceOf(Random& random, const OwnedMesh& mesh, std::uint32_t id,
                                 Detail detail)
{
  Instance instance;
  instance.clusters = &mesh.clusters;
  instance.mesh = mesh.view();
  instance.attributes = {mesh.vertexNormals,  mesh.cellNormals,  mesh.vertexColors, mesh.cellColors,
                         mesh.faces.centroid, mesh.faces.normal, mesh.cells,        mesh.cellCount};
  if (centre_ == Vec3d{0, 0, 0} && random.chance(2)) {
    const Vec3d move = random.inBox(0.5);
    instance.modelToWorld = {{{random.between(-1.5, 1.5), 0.2, 0, move.x},
                              {-0.3, random.between(0.5, 1.5), 0.1, move.y},
                              {0, 0.4, random.between(0.5, 1.5), move.z},
                              {0, 0, 0, 1}}};
  }
  instance.material = {random.color(),
                       random.color(),
                       random.color(),
                       static_cast<float>(random.between(0, 0.5)),
                       static_cast<float>(random.between(0, 1)),
                       static_cast<float>(random.between(0, 1)),
                       static_cast<float>(random.chance(5) ? 0 : random.between(0, 120))};
  instance.style = randomStyle(random, mesh);
  if (detail == Detail::kCoarse && random.chance(2)) instance.material.specular = 0;
  if (detail == Detail::kCoarse && random.chance(2))
    instance.style.outlineThreshold = static_cast<float>(random.between(0, 1));
  instance.cullBackFaces = random.chance(5);
  instance.cullFrontFaces = random.chance(8);
  instance.id = id;
  return instance;
}

Style RandomScene::randomStyle(Random& random, const OwnedMesh&)
{
  Style style;
  style.frequency = static_cast<ShadingFrequency>(random.below(3));
  style.normals = static_cast<NormalSource>(random.below(3));
  style.reflection = static_cast<Reflection>(random.below(5));
  if (random.chance(3)) style.tone = static_cast<Tone>(1 + random.below(2));
  style.toneCool = random.color();
  style.toneWarm = random.color();
  if (random.chance(4)) style.outlineThreshold = static_cast<float>(random.between(0, 0.4));
  style.outlineColor = random.color();
  return style;
}

void RandomScene::addImages(Random& random)
{
  constexpr int kImages = 4;
  for (int n = 0; n < kImages; ++n) {
    const int width = 1 + static_cast<int>(random.below(40));
    const int height = 1 + static_cast<int>(random.below(40));
    const int components = 1 + static_cast<int>(random.below(4));
    const auto format = static_cast<TexelFormat>(random.below(3));
    const auto count = static_cast<std::size_t>(width * height * components);
    std::vector<std::uint8_t> bytes(count);
    std::vector<std::uint16_t> words(count);
    std::vector<float> floats(count);
    for (std::size_t i = 0; i < count; ++i) {
      bytes[i] = static_cast<std::uint8_t>(random.below(256));
      words[i] = static_cast<std::uint16_t>(random.below(65536));
      floats[i] = static_cast<float>(random.between(-0.2, 1.5));
    }
    TextureView view = {width, height, components, format, bytes.data(), count};
    if (format == TexelFormat::kUnorm16) view.texels = words.data();
    if (format == TexelFormat::kFloat32) view.texels = floats.data();
    view.byteCount = count * (format == TexelFormat::kUnorm8    ? 1
                              : format == TexelFormat::kUnorm16 ? 2
                                                                : 4);
    images_.push_back(std::make_unique<TextureImage>());
    if (!images_.back()->build(view, MipChain::kFull).ok()) std::abort();
  }
  for (std::uint32_t n = 0; n < 6; ++n) {
    ProceduralTexture procedural;
    procedural.kind = static_cast<ProceduralKind>(n % 3);
    procedural.space = n < 3 ? ProceduralSpace::kUv : ProceduralSpace::kObject;
    procedural.scale = static_cast<float>(random.between(0.5, 9));
    procedural.turbulence = static_cast<float>(random.chance(2) ? 0 : random.between(0, 2));
    procedurals_.push_back(procedural);
  }
}

TextureLayer RandomScene::randomLayer(Random& random) const
{
  TextureLayer layer;
  layer.role = static_cast<TextureRole>(random.below(5));
  if (layer.bendsNormals() || !random.chance(4))
    layer.image = images_[random.below(static_cast<std::uint32_t>(images_.size()))].get();
  else
    layer.procedural = &procedurals_[random.below(static_cast<std::uint32_t>(procedurals_.size()))];
  layer.sampler.wrapU = static_cast<TextureWrap>(random.below(4));
  layer.sampler.wrapV = static_cast<TextureWrap>(random.below(4));
  layer.sampler.filter = static_cast<TextureFilter>(random.below(3));
  layer.sampler.maxAnisotropy = random.chance(2) ? 1 : 1 + static_cast<int>(random.below(16));
  const Vec3f border = random.color();
  layer.sampler.borderColor = {border.x, border.y, border.z, 0.5f};
  layer.uvSet = static_cast<int>(random.below(2));
  if (random.chance(2))
    for (float& value : layer.uvTransform)
      value = static_cast<float>(random.between(-2, 2));
  layer.mode = static_cast<TextureMode>(random.below(4));
  layer.amount = static_cast<float>(random.between(-1, 2));
  layer.onBackFaces = !random.chance(3);
  return layer;
}

/// Some with the one before them.
void RandomScene::joinTextures()
{
  Random random(seed_ ^ 0x1B56C4E9u);
  for (std::vector<TextureLayer>& layers : layers_)
    for (std::size_t i = 1; i < layers.size(); ++i) {
      if (layers[i].bendsNormals() || layers[i - 1].bendsNormals() || random.chance(2)) continue;
      layers[i].role = layers[i - 1].role;
      layers[i].join = static_cast<TextureJoin>(1 + random.below(5));
    }
}

void RandomScene::addTextures()
{
  Random random(seed_ ^ 0x68E31DA4u);
  addImages(random);
  for (const auto& mesh : meshes_) {
    const std::size_t vertices = mesh->view().vertexCount();
    const double spread = random.chance(4) ? 1e5 : random.between(0.5, 8);
    for (std::vector<Vec2f>* uv : {&mesh->uv, &mesh->uv2})
      for (std::size_t v = 0; v < vertices; ++v)
        uv->push_back({static_cast<float>(random.between(-spread, spread)),
                       static_cast<float>(random.between(-spread, spread))});
    if (random.chance(5)) mesh->uv[0] = {std::nanf(""), static_cast<float>(kInfinity)};
  }
  for (Instance& instance : instances_) {
    for (const auto& mesh : meshes_) {
      if (instance.clusters != &mesh->clusters) continue;
      instance.attributes.uv = mesh->uv;
      instance.attributes.uv2 = mesh->uv2;
    }
    layers_.emplace_back();
    const std::uint32_t count = 1 + random.below(3);
    for (std::uint32_t i = 0; i < count; ++i)
      layers_.back().push_back(randomLayer(random));
    instance.layers = layers_.back();
  }
  joinTextures();
}

void RandomScene::addTranslucency()
{
  Random random(seed_ ^ 0x3C6EF372u);
  const auto alpha = [&] { return static_cast<std::uint8_t>(random.below(256)); };
  for (const auto& mesh : meshes_)
    for (std::vector<Rgba8>* colors : {&mesh->vertexColors, &mesh->cellColors})
      for (Rgba8& color : *colors)
        color.a = alpha();
  // Some once more, where they are or elsewhere.
  const std::size_t count = instances_.size();
  for (std::size_t i = 0; i < count; ++i)
    for (std::uint32_t copies = random.below(3); copies > 0; --copies) {
      Instance copy = instances_[i];
      if (centre_ == Vec3d{0, 0, 0} && !random.chance(3))
        for (auto& row : copy.modelToWorld.m)
          row[3] += random.between(-0.3, 0.3);
      instances_.push_back(copy);
    }
  for (Instance& instance : instances_) {
    if (random.chance(4)) continue;
    instance.material.opacity =
        static_cast<float>(random.chance(5) ? random.below(2) : random.between(0, 1));
    instance.style.readsAlpha = random.chance(2);
    if (random.chance(2)) instance.material.diffuse *= 5;
  }
}

void RandomScene::addTones()
{
  Random random(seed_ ^ 0x70E5u);
  if (images_.empty()) addImages(random);
  const auto number = [&](double low, double high) {
    return static_cast<float>(random.between(low, high));
  };
  for (Instance& instance : instances_) {
    Style& style = instance.style;
    if (random.chance(2)) style.frequency = ShadingFrequency::kPhong;
    style.tone = static_cast<Tone>(random.below(6));
    style.toneLight = static_cast<ToneLight>(random.below(2));
    style.toneHighlight = static_cast<ToneHighlight>(random.below(4));
    style.toonBands = static_cast<int>(random.chance(3) ? random.below(2) : random.below(12));
    if (random.chance(9)) style.toonBands = kMaxToonBands;
    style.ramp.image = images_[random.below(static_cast<std::uint32_t>(images_.size()))].get();
    style.ramp.detail = static_cast<RampDetail>(random.below(3));
    style.ramp.exponent = number(0, 20);
    if (random.chance(2)) {
      style.ramp.nearest = number(0.01, 2);
      style.ramp.farthest = style.ramp.nearest * number(1.01, 9);
    }
    style.outlineThreshold = random.chance(3) ? number(0, 0.6) : 0.0f;
    style.evenOutline = random.chance(3);
    style.outlineWidth = number(0, 9);
    style.outlineOpacity = random.chance(3) ? 1.0f : number(0, 1);
    // Normals that look to the eye's side now and then, as real ones do.
    if (random.chance(2)) instance.material.specularPower = number(1, 40);
  }
}

void RandomScene::addHatching()
{
  Random random(seed_ ^ 0x4A7C4u);
  const auto number = [&](double low, double high) {
    return static_cast<float>(random.between(low, high));
  };
  for (Instance& instance : instances_) {
    Style& style = instance.style;
    if (random.chance(2)) style.frequency = ShadingFrequency::kPhong;
    style.tone = Tone::kHatching;
    style.toonBands = random.chance(5) ? 4 : 0;
    style.evenOutline = random.chance(4);
    style.toneLight = random.chance(4) ? ToneLight::kUpperRight : ToneLight::kFirst;
    style.hatching.paper = random.color();
    style.hatching.ink = random.color();
    style.hatching.spacing = random.chance(6) ? number(1, 256) : number(1, 20);
    style.hatching.darkest = random.chance(3) ? 1.0f : number(0, 1);
    if (!instance.attributes.uv.empty() && random.chance(2))
      style.hatching.place = HatchPlace::kTexture;
  }
}

void RandomScene::addExaggeration(Detail detail)
{
  const bool isCreased = detail == Detail::kCreasedExaggeration;
  Random random(seed_ ^ (isCreased ? 0xC4EA5Eu : 0xE4A66E8u));
  const auto number = [&](double low, double high) {
    return static_cast<float>(random.between(low, high));
  };
  if (random.chance(2)) addDataTones();
  for (const auto& mesh : meshes_) {
    SmoothScales scales = {1 + static_cast<int>(random.below(kMaxSmoothLevels)),
                           random.chance(12) ? number(0.1, 3) : number(0.001, 0.1)};
    if (isCreased) scales.creaseDegrees = random.between(0, 90);
    const Span<const Vec3f> normals =
        random.chance(2) ? Span<const Vec3f>(mesh->vertexNormals) : Span<const Vec3f>();
    if (!limn::smoothNormals({mesh->view(), normals, mesh->cells}, scales, 2, mesh->smoothNormals)
             .ok())
      std::abort();
  }
  if (random.chance(4)) addNormals(random);
  for (Instance& instance : instances_) {
    for (const auto& mesh : meshes_) {
      if (instance.clusters != &mesh->clusters) continue;
      instance.attributes.smoothNormals = mesh->smoothNormals.packed;
      instance.attributes.smoothOfCorner = mesh->smoothNormals.ofCorner;
      instance.attributes.smoothCount = mesh->smoothNormals.count();
      instance.attributes.smoothLevels = mesh->smoothNormals.levels;
      instance.attributes.smoothRatio = mesh->smoothNormals.ratio;
    }
    Style& style = instance.style;
    if (random.chance(2)) style.frequency = ShadingFrequency::kPhong;
    if (!random.chance(9)) style.tone = Tone::kExaggerated;
    style.toonBands = random.chance(3) ? 2 + static_cast<int>(random.below(6)) : 0;
    style.evenOutline = random.chance(6);
    style.toneLight = random.chance(2) ? ToneLight::kUpperRight : ToneLight::kFirst;
    Exaggeration& exaggeration = style.exaggeration;
    exaggeration.contrast = random.chance(8) ? number(0, 1000) : number(0, 20);
    exaggeration.exponent =
        random.chance(2) ? number(-4, 4) : 1 - static_cast<float>(random.below(4));
    exaggeration.base = random.chance(4) ? static_cast<float>(random.below(2)) : number(0, 1);
  }
}

void RandomScene::addDataTones()
{
  Random random(seed_ ^ 0x7A3D11C5u);
  // Colours at the edge of the gamut as often as any.
  const bool isPure = random.chance(3);
  const auto byte = [&] {
    return static_cast<std::uint8_t>(isPure ? 255 * random.below(2) : random.below(256));
  };
  for (const auto& mesh : meshes_) {
    if (!mesh->vertexColors.empty() || !mesh->cellColors.empty()) continue;
    for (std::size_t v = 0; v < mesh->view().vertexCount(); ++v)
      mesh->vertexColors.push_back({byte(), byte(), byte(), 255});
  }
  for (Instance& instance : instances_) {
    for (const auto& mesh : meshes_) {
      if (instance.clusters != &mesh->clusters) continue;
      instance.attributes.vertexColors = mesh->vertexColors;
      instance.attributes.cellColors = mesh->cellColors;
    }
    Style& style = instance.style;
    if (!random.chance(6)) style.tone = static_cast<Tone>(1 + random.below(2));
    style.toneOverData = static_cast<ToneOverData>(random.chance(8) ? 0 : 1 + random.below(2));
    style.undertone = static_cast<float>(random.chance(5) ? random.below(2) : random.between(0, 1));
    style.legendSafeRange =
        static_cast<float>(random.chance(5) ? 100 * random.below(2) : random.between(0, 50));
    if (random.chance(2)) instance.material.diffuse = 1;
    if (random.chance(8)) instance.material.diffuse = 3;
    if (random.chance(4)) style.toonBands = static_cast<int>(2 + random.below(6));
  }
}

void RandomScene::addHulls()
{
  Random random(seed_ ^ 0x8A5CD789u);
  for (const auto& mesh : meshes_)
    if (!buildHullEdges(mesh->view(), 2, mesh->hull).ok()) std::abort();
  std::vector<Instance> solids;
  solids.swap(instances_);
  for (Instance& solid : solids) {
    if (random.chance(4))
      for (auto& row : solid.modelToWorld.m)
        row[0] = centre_ == Vec3d{0, 0, 0} ? -row[0] : row[0];
    if (random.chance(6)) solid.material.opacity = 0.5f;
    instances_.push_back(solid);
    if (random.chance(5)) continue;
    Instance hull = solid;
    for (const auto& mesh : meshes_)
      if (&mesh->clusters == solid.clusters) hull.hull = &mesh->hull;
    hull.clusters = nullptr;
    hull.style.outlineColor = random.color();
    hull.style.outlineWidth =
        static_cast<float>(random.chance(6) ? 40 * random.below(2) : random.between(0.2, 6));
    if (random.chance(4)) hull.style.outlineOpacity = static_cast<float>(random.between(0, 1));
    instances_.insert(random.chance(2) ? instances_.end() : instances_.begin(), hull);
  }
}

void RandomScene::addImageLines()
{
  Random random(seed_ ^ 0x11A6E0u);
  const auto number = [&](double low, double high) {
    return static_cast<float>(random.between(low, high));
  };
  if (random.chance(4)) instances_[0].material.opacity = 0.5f;
  for (Instance& instance : instances_) {
    if (random.chance(5)) continue;
    Style& style = instance.style;
    // Mostly the one that is not for comparison alone.
    style.imageOutline.detector =
        random.chance(4) ? static_cast<OutlineDetector>(random.below(4)) : OutlineDetector::kPlane;
    style.imageOutline.depthTolerance = random.chance(4) ? number(0, 0.5) : number(0.5, 6);
    style.imageOutline.creaseDegrees = random.chance(5) ? 180 : number(0, 120);
    style.outlineWidth = random.chance(6) ? number(4, 8) : number(0, 4);
    style.outlineColor = random.color();
    style.outlineOpacity = random.chance(2) ? 1 : number(0, 1);
    // Facets would be nothing but creases.
    if (!random.chance(4)) style.normals = NormalSource::kVertex;
  }
}

void RandomScene::addCreaseDetectors()
{
  Random random(seed_ ^ 0xC4EA5Eu);
  for (Instance& instance : instances_) {
    ImageOutline& outline = instance.style.imageOutline;
    outline.creases = static_cast<CreaseDetector>(random.below(3));
    if (random.chance(2)) outline.creaseDegrees = static_cast<float>(random.between(0, 60));
  }
}

void RandomScene::addIds()
{
  Random random(seed_ ^ 0x1D5u);
  for (const auto& mesh : meshes_) {
    // Patches of cells, and now and then each its own.
    const std::uint32_t parts = 2 + random.below(6), patch = 1 + random.below(40);
    mesh->cellIds.resize(mesh->cells.empty() ? mesh->triangles.size() : mesh->cellCount);
    for (std::size_t cell = 0; cell < mesh->cellIds.size(); ++cell)
      mesh->cellIds[cell] = patch == 1
                                ? random.below(parts)
                                : static_cast<std::uint32_t>(cell / patch) * 2654435761u % parts;
  }
  for (std::size_t i = 0; i < instances_.size(); ++i) {
    Instance& instance = instances_[i];
    if (!random.chance(6)) instance.attributes.cellIds = meshes_[i % meshes_.size()]->cellIds;
    instance.style.imageOutline.ids = !random.chance(5);
    if (random.chance(3)) instance.style.imageOutline.creaseDegrees = 180;
    // Large enough for borders to be no steps.
    if (random.chance(2)) instance.style.imageOutline.depthTolerance *= 4;
  }
}

void RandomScene::addCues()
{
  Random random(seed_ ^ 0xC0E5D1u);
  const auto number = [&](double low, double high) {
    return static_cast<float>(random.between(low, high));
  };
  if (random.chance(2)) addImageLines();
  // Often one radius for all, as in programs.
  const float eyeDomeRadius = number(0.001, 0.02), unsharpRadius = number(0.001, 0.1);
  for (Instance& instance : instances_) {
    DepthCues& cues = instance.style.cues;
    if (random.chance(6)) continue;
    if (random.chance(2)) cues.eyeDome.strength = random.chance(4) ? number(2, 30) : number(0, 2);
    cues.eyeDome.radius = random.chance(2) ? eyeDomeRadius : number(0.001, 0.02);
    if (random.chance(2)) cues.unsharp.strength = random.chance(4) ? 1 : number(0, 1);
    cues.unsharp.radius = random.chance(2) ? unsharpRadius : number(0.001, 0.1);
    cues.unsharp.lightens = random.chance(2);
    if (random.chance(2)) cues.halo.width = random.chance(6) ? number(5, 12) : number(0, 5);
    cues.halo.depth = random.chance(4) ? number(0.05, 1) : number(1, 6);
    cues.halo.color = random.color() * 1.2f;
  }
}

void RandomScene::addReflections()
{
  Random random(seed_ ^ 0xB5297A4Du);
  for (Instance& instance : instances_) {
    Style& style = instance.style;
    Material& material = instance.material;
    if (!random.chance(6)) style.tone = Tone::kNone;
    style.reflection = static_cast<Reflection>(
        random.below(static_cast<std::uint32_t>(Reflection::kMetallicRoughnessAsVtk) + 1));
    style.fresnel = random.chance(3);
    style.fallOff = !random.chance(4);
    if (random.chance(3)) material.specularPower = static_cast<float>(1 << random.below(12));
    const auto share = [&] {
      return static_cast<float>(random.chance(5) ? random.below(2) : random.between(0, 1));
    };
    material.roughness = share();
    material.metallic = share();
    material.refractiveIndex = random.color() * 2.0f + Vec3f{1, 1, 1};
    material.edgeTint = random.color();
    if (random.chance(3)) material.rim = random.color();
    material.rimPower = static_cast<float>(random.between(0, 6));
  }
}

void RandomScene::addNormals(Random& random)
{
  for (auto& mesh : meshes_) {
    const double angle = random.chance(5) ? 180 : random.between(0, 120);
    const auto weight = static_cast<NormalWeight>(random.below(3));
    const Status status =
        splitVertexNormals(mesh->view(), mesh->cells, weight, angle, 2, mesh->splitNormals);
    if (!status.ok()) std::abort();
    mesh->firstCorners = limn::firstCorners(mesh->view(), mesh->cells, mesh->cellCount);
  }
  for (Instance& instance : instances_) {
    const auto mesh = std::find_if(meshes_.begin(), meshes_.end(), [&](const auto& one) {
      return &one->clusters == instance.clusters;
    });
    if (random.chance(2)) instance.attributes.facePoints = (*mesh)->firstCorners;
    if (random.chance(3)) continue;
    instance.attributes.vertexNormals = (*mesh)->splitNormals.normals;
    instance.attributes.normalOfCorner = (*mesh)->splitNormals.ofCorner;
  }
}

void RandomScene::addLights()
{
  Random random(seed_ ^ 0x11647u);
  addNormals(random);
  const std::uint32_t more = 1 + random.below(3);
  for (std::uint32_t i = 0; i < more; ++i) {
    Light light = randomLight(random);
    light.kind = static_cast<LightKind>(2 + random.below(4));
    if (light.kind == LightKind::kSpot)
      light.softDegrees =
          random.chance(4) ? 0.0f : light.coneDegrees * static_cast<float>(random.between(0, 1));
    light.halfSide[0] = random.inBox(1);
    light.halfSide[1] = random.inBox(1);
    light.radius = random.between(0.01, 2);
    light.samples = 1 + static_cast<int>(random.below(20));
    if (random.chance(3)) {
      light.unit = LightUnit::kPower;
      light.color = light.color * 20.0f;
    }
    lights_.push_back(light);
  }
}

Light RandomScene::randomLight(Random& random)
{
  Light light;
  light.kind = static_cast<LightKind>(random.below(4));
  light.position = centre_ + random.inBox(4);
  light.direction = random.inBox(1);
  light.color = random.color() * 2.0f;
  if (random.chance(2)) light.attenuation = random.color() + Vec3f{0.1f, 0, 0};
  light.coneDegrees = static_cast<float>(random.between(0, 90));
  light.exponent = static_cast<float>(random.between(0, 8));
  return light;
}

void RandomScene::placeCamera(Random& random)
{
  // Near and inside the meshes as often as well before them.
  const double distance = random.chance(2) ? random.between(0.05, 1) : random.between(2, 6);
  const Vec3d eye = centre_ + normalized(random.inBox(1) + Vec3d{0.01, 0, 0}) * distance;
  const double aspect = static_cast<double>(width_) / height_;
  const double near = random.chance(3) ? 1e-3 : 0.1, far = random.between(2, 12);
  scene_.camera.worldToView = lookAt(eye, centre_ + random.inBox(0.3));
  scene_.camera.parallel = random.chance(3);
  scene_.camera.viewToClip = scene_.camera.parallel
                                 ? parallel(random.between(0.01, 2), aspect, near, far)
                                 : perspective(random.between(0.1, 1.2), aspect, near, far);
}

void RandomScene::addEffects(Random random)
{
  const auto number = [&](double low, double high) {
    return static_cast<float>(random.between(low, high));
  };
  for (Light& light : lights_)
    light.color = light.color * number(1, 9);
  scene_.lights = lights_;
  if (!random.chance(3)) effects_.exposure = number(0, 3);
  if (!random.chance(3)) {
    effects_.bloom = {number(0, 2), number(0, 2), 1 + static_cast<int>(random.below(8))};
  }
  if (!scene_.camera.parallel && !random.chance(3)) {
    const std::uint32_t largest = random.chance(10) ? 40 : 6;
    effects_.depthOfField = {number(0, 0.4), number(0.1, 6),
                             1 + static_cast<int>(random.below(largest))};
  }
  effects_.toneMapping = static_cast<ToneMapping>(random.below(4));
  effects_.whitePoint = number(0.1, 8);
  if (random.chance(2)) return;
  Fxaa& fxaa = effects_.fxaa;
  fxaa.enabled = true;
  fxaa.highQualityEndpoints = !random.chance(3);
  if (random.chance(2)) return;
  fxaa.relativeContrastThreshold = number(0, 1);
  fxaa.hardContrastThreshold = random.chance(4) ? 0.0f : number(0, 0.5);
  fxaa.subpixelBlendLimit = number(0, 1);
  fxaa.subpixelContrastThreshold = random.chance(8) ? 1.0f : number(0, 1);
  fxaa.endpointSearchIterations = static_cast<int>(random.below(30));
}

LineStyle randomLineStyle(Random& random)
{
  const auto number = [&](double low, double high) {
    return static_cast<float>(random.between(low, high));
  };
  LineStyle style;
  style.color = random.color() * 1.2f;
  style.opacity = random.chance(2) ? 1.0f : number(0, 1);
  style.width = random.chance(3) ? number(0.05, 1) : number(0.5, random.chance(6) ? 40 : 6);
  if (random.chance(2)) style.outerFactor = number(0, 3);
  if (random.chance(2)) style.taper = number(0, random.chance(3) ? 300 : 30);
  if (random.chance(3)) {
    style.dash = number(0.3, 20);
    style.gap = number(0.3, 20);
  }
  style.hidden = static_cast<HiddenLines>(random.below(3));
  style.cap = static_cast<LineCap>(random.below(2));
  return style;
}

void RandomScene::addLines(Random random)
{
  for (Instance& instance : instances_) {
    const MeshView& mesh = instance.mesh;
    EdgeTable table;
    if (!buildEdgeTable(mesh, random.chance(5) ? 0.05 : 0, 2, table).ok()) std::abort();
    FeatureArrays arrays;
    if (!random.chance(3)) arrays.cells = instance.attributes.cells;
    const auto kinds = edgeKinds(mesh, table, arrays, random.between(0, 120), 2);
    lines_.emplace_back();
    const std::uint32_t sets = 1 + random.below(3);
    for (std::uint32_t i = 0; i < sets; ++i) {
      chains_.push_back(std::make_unique<OwnedLines>());
      OwnedLines& own = *chains_.back();
      const unsigned chosen = 1 + random.below(31);
      EdgeChains edges = chainEdges(table, kinds, chosen);
      markOuterEdges(mesh, table, scene_.camera, instance.modelToWorld, edges);
      own.chains = std::move(edges.chains);
      for (std::uint8_t& flags : own.chains.flags)
        if (random.chance(10)) flags = static_cast<std::uint8_t>(random.below(4));
      if (random.chance(3)) own.chains.flags.clear();
      LineSet set = own.chains.lines(mesh, randomLineStyle(random));
      // Equal styles are one drawing.
      if (i > 0 && random.chance(3)) set.style = lines_.back().back().style;
      if (random.chance(3)) {
        for (std::size_t v = 0; v < mesh.vertexCount(); ++v)
          own.slack.push_back(static_cast<float>(random.between(0, 0.5)));
        set.slack = own.slack;
      }
      lines_.back().push_back(set);
    }
    instance.lines = lines_.back();
  }
}

void RandomScene::addShares()
{
  Random random(seed_ ^ 0x54A4E5u);
  std::size_t number = 0;
  for (std::size_t i = 0; i < instances_.size(); ++i) {
    for (LineSet& set : lines_[i]) {
      OwnedLines& own = *chains_[number++];
      if (random.chance(5)) continue;
      for (std::size_t v = 0; v < set.points.vertexCount(); ++v)
        own.share.push_back(random.chance(4) ? static_cast<float>(random.below(2))
                                             : static_cast<float>(random.between(0, 1)));
      set.share = own.share;
    }
    instances_[i].lines = lines_[i];
  }
}

void RandomScene::addShaders(Random random)
{
  for (const auto& mesh : meshes_) {
    if (random.chance(3)) continue;
    const RandomVertexShader shader(random, centre_);
    MovedVertices moved;
    moveVertices(shader, mesh->view(), mesh->vertexNormals, 2, moved);
    mesh->positions = moved.positions;
    mesh->precise = moved.precisePositions;
    // In place: instances borrow them.
    if (shader.movesNormals())
      std::copy(moved.normals.begin(), moved.normals.end(), mesh->vertexNormals.begin());
    if (!refitClusters(mesh->view(), 2, mesh->clusters) &&
        !buildClusters(mesh->view(), 2, mesh->clusters).ok())
      std::abort();
    const FaceGeometry faces = faceGeometry(mesh->view(), mesh->cells, mesh->cellCount);
    std::copy(faces.centroid.begin(), faces.centroid.end(), mesh->faces.centroid.begin());
    std::copy(faces.normal.begin(), faces.normal.end(), mesh->faces.normal.begin());
  }
  for (Instance& instance : instances_) {
    for (const auto& mesh : meshes_)
      if (instance.clusters == &mesh->clusters) instance.mesh = mesh->view();
    if (random.chance(5)) continue;
    shaders_.push_back(std::make_unique<RandomSurfaceShader>(random));
    instance.style.surfaceShader = shaders_.back().get();
  }
}

Picture drawn(const RandomScene& random, const RenderOptions& options)
{
  Picture picture = random.canvas();
  const Status status = render(random.scene(), picture.frame(random.background()), options);
  EXPECT_TRUE(status.ok()) << status.message;
  return picture;
}

}  // namespace limn::testing
