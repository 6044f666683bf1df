// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Testing/Unit/TestScene.h"

#include <algorithm>
#include <cmath>

namespace limn::testing {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kGrazing = 0.3;

double tangentOf(const Viewpoint& view)
{
  return std::tan(view.fovyDegrees * kPi / 360);
}

}  // namespace

Viewpoint perspectiveView(Vec3d eye, Vec3d target, double fovyDegrees, ClipRange range)
{
  Viewpoint view;
  view.eye = eye;
  view.target = target;
  view.fovyDegrees = fovyDegrees;
  view.near = range.near;
  view.far = range.far;
  return view;
}

Viewpoint parallelView(Vec3d eye, Vec3d target, double halfHeight, ClipRange range)
{
  Viewpoint view = perspectiveView(eye, target, 0, range);
  view.parallel = true;
  view.halfHeight = halfHeight;
  return view;
}

Axes axesOf(const Viewpoint& view)
{
  const Vec3d back = normalized(view.eye - view.target);
  const Vec3d right = normalized(cross(Vec3d{0, 1, 0}, back));
  return {right, cross(back, right), back};
}

Camera Stage::camera() const
{
  const auto [right, up, back] = axesOf(view);
  const double aspect = static_cast<double>(width) / height, n = view.near, f = view.far;
  Camera camera;
  camera.worldToView = {{{right.x, right.y, right.z, -dot(right, view.eye)},
                         {up.x, up.y, up.z, -dot(up, view.eye)},
                         {back.x, back.y, back.z, -dot(back, view.eye)},
                         {0, 0, 0, 1}}};
  camera.parallel = view.parallel;
  const double size = view.parallel ? view.halfHeight : tangentOf(view);
  if (view.parallel)
    camera.viewToClip = {{{1 / (size * aspect), 0, 0, 0},
                          {0, 1 / size, 0, 0},
                          {0, 0, -2 / (f - n), -(f + n) / (f - n)},
                          {0, 0, 0, 1}}};
  else
    camera.viewToClip = {{{1 / (size * aspect), 0, 0, 0},
                          {0, 1 / size, 0, 0},
                          {0, 0, -(f + n) / (f - n), -2 * f * n / (f - n)},
                          {0, 0, -1, 0}}};
  return camera;
}

Scene Stage::scene() const
{
  return {camera(), ambientLight, lights, instances, samples, resolve};
}

Picture Stage::draw(Backend backend) const
{
  Picture picture(width, height);
  drawOver(picture, backend);
  return picture;
}

RenderStats Stage::drawOver(Picture& picture, Backend backend, Background background) const
{
  if (samples > 8) picture.coverage.clear();
  RenderStats stats;
  const Status status = render(scene(), picture.frame(background), {backend, 2}, &stats);
  EXPECT_TRUE(status.ok()) << status.message;
  return stats;
}

Ray Stage::ray(double x, double y) const
{
  const auto [right, up, back] = axesOf(view);
  const double size = view.parallel ? view.halfHeight : tangentOf(view);
  const double sideways = (2 * x / width - 1) * size * width / height;
  const double upward = (2 * y / height - 1) * size;
  const Vec3d aside = right * sideways + up * upward;
  if (view.parallel) return {view.eye + aside, -back};
  return {view.eye, normalized(aside - back)};
}

Vec3d Stage::project(Vec3d world) const
{
  const auto [right, up, back] = axesOf(view);
  const Vec3d way = world - view.eye;
  const double distance = -dot(back, way), n = view.near, f = view.far;
  const double size = view.parallel ? view.halfHeight : tangentOf(view) * distance;
  const double depth =
      view.parallel ? (distance - n) / (f - n) : 0.5 + ((f + n) / 2 - f * n / distance) / (f - n);
  return {width / 2.0 + dot(right, way) / size * height / 2.0,
          height / 2.0 + dot(up, way) / size * height / 2.0, depth};
}

Stage pixelStage(int side, int samples)
{
  const double centre = side / 2.0;
  Stage stage;
  stage.width = stage.height = side;
  stage.view = parallelView({centre, centre, 1}, {centre, centre, 0}, centre);
  stage.samples = samples;
  return stage;
}

std::optional<Hit> hitSphere(const Ray& ray)
{
  const double half = dot(ray.origin, ray.direction);
  const double discriminant = half * half - dot(ray.origin, ray.origin) + 1;
  if (discriminant < 0) return std::nullopt;
  const Vec3d p = ray.origin + ray.direction * (-half - std::sqrt(discriminant));
  return Hit{p, p, -ray.direction};
}

std::optional<Hit> hitPlane(const Ray& ray)
{
  if (!(ray.origin.z * ray.direction.z < 0)) return std::nullopt;
  return Hit{
      ray.origin - ray.direction * (ray.origin.z / ray.direction.z), {0, 0, 1}, -ray.direction};
}

double steepness(double power)
{
  // At the angle where the second derivative is zero: tan(x)^2 = 1/p, slope about sqrt(p/e).
  return std::max(1.0, std::sqrt(power));
}

void expectPicture(const Stage& stage, const Picture& picture, const Surface& surface,
                   const Equation& equation, double tolerance)
{
  int compared = 0;
  for (int y = 0; y < stage.height; ++y)
    for (int x = 0; x < stage.width; ++x) {
      const auto hit = surface(stage.ray(x + 0.5, y + 0.5));
      if (!hit || dot(hit->normal, hit->towardEye) < kGrazing) continue;
      const auto expected = equation(*hit);
      if (!expected) continue;
      const auto byte = [](double value) { return std::clamp(value, 0.0, 1.0) * 255; };
      const Rgba8 actual = at(picture, x, y);
      ASSERT_NEAR(actual.r, byte(expected->x), tolerance) << "red of pixel " << x << ", " << y;
      ASSERT_NEAR(actual.g, byte(expected->y), tolerance) << "green of pixel " << x << ", " << y;
      ASSERT_NEAR(actual.b, byte(expected->z), tolerance) << "blue of pixel " << x << ", " << y;
      ++compared;
    }
  EXPECT_GT(compared, stage.width * stage.height / 10);
}

void finish(OwnedMesh& mesh)
{
  if (mesh.cellCount == 0) mesh.cellCount = mesh.triangles.size();
  mesh.faces = faceGeometry(mesh.view(), mesh.cells, mesh.cellCount);
  const Status status = buildClusters(mesh.view(), 0, mesh.clusters);
  ASSERT_TRUE(status.ok()) << status.message;
}

OwnedMesh sphere(std::uint32_t rings, std::uint32_t sectors)
{
  OwnedMesh mesh;
  const auto addPoint = [&](double polar, double azimuth) {
    const Vec3d p = {std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth),
                     std::cos(polar)};
    mesh.positions.push_back(vec3Cast<float>(p));
    mesh.vertexNormals.push_back(vec3Cast<float>(p));
  };
  addPoint(0, 0);
  for (std::uint32_t ring = 1; ring < rings; ++ring)
    for (std::uint32_t sector = 0; sector < sectors; ++sector)
      addPoint(kPi * ring / rings, 2 * kPi * sector / sectors);
  addPoint(kPi, 0);

  const auto vertex = [&](std::uint32_t ring, std::uint32_t sector) {
    if (ring == 0) return 0u;
    if (ring == rings) return 1 + (rings - 1) * sectors;
    return 1 + (ring - 1) * sectors + sector % sectors;
  };
  for (std::uint32_t ring = 0; ring < rings; ++ring)
    for (std::uint32_t sector = 0; sector < sectors; ++sector) {
      const std::uint32_t a = vertex(ring, sector), b = vertex(ring + 1, sector),
                          c = vertex(ring + 1, sector + 1), d = vertex(ring, sector + 1);
      const auto cell = static_cast<std::uint32_t>(mesh.cellCount++);
      // At the poles one of a quad's two triangles has no area.
      if (ring + 1 < rings) {
        mesh.triangles.push_back({{a, b, c}});
        mesh.cells.push_back(cell);
      }
      if (ring > 0) {
        mesh.triangles.push_back({{a, c, d}});
        mesh.cells.push_back(cell);
      }
    }
  finish(mesh);
  return mesh;
}

const OwnedMesh& fineSphere()
{
  static const OwnedMesh mesh = sphere(128, 256);
  return mesh;
}

OwnedMesh sheet(Vec3d corner, Vec3d u, Vec3d v, std::uint32_t cells)
{
  OwnedMesh mesh;
  const Vec3f normal = vec3Cast<float>(normalized(cross(u, v)));
  for (std::uint32_t j = 0; j <= cells; ++j)
    for (std::uint32_t i = 0; i <= cells; ++i) {
      const double s = static_cast<double>(i) / cells, t = static_cast<double>(j) / cells;
      mesh.positions.push_back(vec3Cast<float>(corner + u * s + v * t));
      mesh.vertexNormals.push_back(normal);
    }
  for (std::uint32_t j = 0; j < cells; ++j)
    for (std::uint32_t i = 0; i < cells; ++i) {
      const std::uint32_t p = j * (cells + 1) + i;
      mesh.triangles.push_back({{p, p + 1, p + cells + 2}});
      mesh.triangles.push_back({{p, p + cells + 2, p + cells + 1}});
      mesh.cells.insert(mesh.cells.end(), 2, static_cast<std::uint32_t>(mesh.cellCount++));
    }
  finish(mesh);
  return mesh;
}

OwnedMesh soup(const std::vector<Vec3d>& points)
{
  OwnedMesh mesh;
  for (const Vec3d& p : points) {
    mesh.positions.push_back(vec3Cast<float>(p));
    mesh.vertexNormals.push_back({0, 0, 1});
  }
  for (std::uint32_t first = 0; first + 2 < points.size(); first += 3)
    mesh.triangles.push_back({{first, first + 1, first + 2}});
  finish(mesh);
  return mesh;
}

Instance instanceOf(const OwnedMesh& mesh)
{
  Instance instance;
  instance.clusters = &mesh.clusters;
  instance.mesh = mesh.view();
  instance.attributes = {mesh.vertexNormals,  mesh.cellNormals,  mesh.vertexColors, mesh.cellColors,
                         mesh.faces.centroid, mesh.faces.normal, mesh.cells,        mesh.cellCount};
  instance.style.reflection = Reflection::kLambert;
  return instance;
}

Instance painted(const OwnedMesh& mesh, Vec3f color, std::uint32_t id)
{
  Instance instance = instanceOf(mesh);
  instance.style.reflection = Reflection::kNone;
  instance.style.normals = NormalSource::kTriangle;
  instance.material.diffuseColor = color;
  instance.id = id;
  return instance;
}

Rgba8 at(const Picture& picture, int x, int y)
{
  return picture.color[static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                       static_cast<std::size_t>(x)];
}

bool covered(const Picture& picture, int x, int y)
{
  return picture.coverage[static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                          static_cast<std::size_t>(x)] != 0;
}

int bitCount(std::uint8_t bits)
{
  int count = 0;
  for (; bits != 0; bits = static_cast<std::uint8_t>(bits >> 1))
    count += bits & 1;
  return count;
}

}  // namespace limn::testing
