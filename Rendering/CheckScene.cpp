// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/CheckScene.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>

namespace limn {
namespace {

bool isFinite(const Mat4d& matrix)
{
  const double* first = &matrix.m[0][0];
  return std::all_of(first, first + 16, [](double v) { return std::isfinite(v); });
}

bool areNotNegative(std::initializer_list<float> values)
{
  return std::all_of(values.begin(), values.end(),
                     [](float v) { return std::isfinite(v) && v >= 0; });
}

bool isNotNegative(Vec3f v)
{
  return areNotNegative({v.x, v.y, v.z});
}

Status checkFrame(const Scene& scene, const FrameView& frame)
{
  if (frame.width < 1 || frame.height < 1 || frame.width > kMaxImageSide ||
      frame.height > kMaxImageSide)
    return {Error::kInvalidImageSize, "Image size " + std::to_string(frame.width) + " x " +
                                          std::to_string(frame.height) + " is not between 1 and " +
                                          std::to_string(kMaxImageSide) +
                                          " pixels a side; choose another resolution."};
  if (frame.rowStride < frame.width)
    return {Error::kInvalidImageSize, "The image's row stride is smaller than its width."};
  if (frame.color == nullptr || frame.depth == nullptr)
    return {Error::kMissingData, "The image has no colour or no depth plane."};
  const RadianceView& radiance = frame.radiance;
  if ((radiance.r == nullptr) != (radiance.g == nullptr) ||
      (radiance.r == nullptr) != (radiance.b == nullptr))
    return {Error::kMissingData,
            "The image has one or two planes of radiance; give three or none."};
  const NormalView& normal = frame.normal;
  if ((normal.x == nullptr) != (normal.y == nullptr) ||
      (normal.x == nullptr) != (normal.z == nullptr))
    return {Error::kMissingData, "The image has one or two planes of normals; give three or none."};
  if (scene.samples != 1 && scene.samples != 2 && scene.samples != 4 && scene.samples != 8 &&
      scene.samples != 16)
    return {Error::kInvalidSampleCount, "Samples per pixel: " + std::to_string(scene.samples) +
                                            " is not one of 1, 2, 4, 8, 16."};
  if (scene.samples > 8 && frame.coverage != nullptr)
    return {Error::kInvalidSampleCount,
            "A plane of coverage has room for 8 samples per pixel; draw 16 without one."};
  return {};
}

bool isPositional(LightKind kind)
{
  return kind != LightKind::kHeadlight && kind != LightKind::kDirectional;
}

bool isArea(LightKind kind)
{
  return kind == LightKind::kRectangle || kind == LightKind::kSphere;
}

Status checkShape(const Light& light, const std::string& name)
{
  if (light.samples < 1)
    return {Error::kInvalidLight,
            name + " has " + std::to_string(light.samples) + " samples; give it at least one."};
  if (light.kind == LightKind::kSphere && !(std::isfinite(light.radius) && light.radius > 0))
    return {Error::kInvalidLight, name + " is a sphere whose radius is not above 0."};
  const Vec3d facing = cross(light.halfSide[0], light.halfSide[1]);
  if (light.kind == LightKind::kRectangle && (!isFinite(facing) || facing == Vec3d{0, 0, 0}))
    return {Error::kInvalidLight, name + " is a rectangle without an area."};
  return {};
}

Status checkLight(const Light& light, std::size_t number)
{
  const std::string name = "Light " + std::to_string(number);
  if (!isFinite(light.position) || !isFinite(light.direction) || !isFinite(light.color) ||
      !isFinite(light.attenuation) || !std::isfinite(light.coneDegrees) ||
      !std::isfinite(light.exponent))
    return {Error::kNotFinite, name + " has a value that is not a finite number."};
  if (!isNotNegative(light.color) || !isNotNegative(light.attenuation) || light.exponent < 0)
    return {Error::kNotFinite, name + " has a negative colour, attenuation or exponent."};
  const bool isPower = light.unit == LightUnit::kPower;
  if (isPower && !isPositional(light.kind))
    return {Error::kInvalidLight,
            name + " is directional and has no power; give it an intensity or a position."};
  if (isPositional(light.kind) && !isPower && light.attenuation == Vec3f{0, 0, 0})
    return {Error::kNotFinite, name +
                                   " has attenuation (0, 0, 0), a division by zero; the inverse "
                                   "square law is (0, 0, 1)."};
  if ((light.kind == LightKind::kDirectional || light.kind == LightKind::kSpot) &&
      light.direction == Vec3d{0, 0, 0})
    return {Error::kNotFinite, name + " has the direction (0, 0, 0)."};
  if (light.kind == LightKind::kSpot && !(light.coneDegrees >= 0 && light.coneDegrees <= 90))
    return {Error::kNotFinite, name + " has a cone angle outside 0 to 90 degrees."};
  if (light.kind == LightKind::kSpot &&
      !(light.softDegrees >= 0 && light.softDegrees <= light.coneDegrees))
    return {Error::kInvalidLight, name + " has a soft edge that is not 0 to its cone angle wide."};
  return isArea(light.kind) ? checkShape(light, name) : Status{};
}

Status checkLights(Span<const Light> lights)
{
  std::size_t count = 0;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    if (Status status = checkLight(lights[i], i); !status.ok()) return status;
    count += isArea(lights[i].kind) ? static_cast<std::size_t>(lights[i].samples) : 1;
  }
  if (count > kMaxLights)
    return {Error::kInvalidLight, std::to_string(count) + " lights, each sample of an area light " +
                                      "counted, are more than " + std::to_string(kMaxLights) +
                                      "; take fewer lights or samples."};
  return {};
}

/// Becomes words only where there is something to say: a frame may have thousands of instances.
struct InstanceName {
  std::size_t number;
};

std::string operator+(InstanceName name, const char* rest)
{
  return "Instance " + std::to_string(name.number) + rest;
}

Status checkMaterial(const Instance& instance, InstanceName name)
{
  const Material& m = instance.material;
  const Style& s = instance.style;
  if (!areNotNegative({m.ambient, m.diffuse, m.specular, m.specularPower}) ||
      !isNotNegative(m.ambientColor) || !isNotNegative(m.diffuseColor) ||
      !isNotNegative(m.specularColor))
    return {Error::kNotFinite, name + ": a material value is negative or not finite."};
  if (!areNotNegative({m.roughness, m.metallic, m.rimPower}) || !isNotNegative(m.rim) ||
      !isNotNegative(m.edgeTint))
    return {Error::kNotFinite, name + ": a material value is negative or not finite."};
  if (m.roughness > 1 || m.metallic > 1)
    return {Error::kNotFinite, name + ": roughness and metallic have to be 0 to 1."};
  if (!isFinite(m.refractiveIndex) ||
      std::min({m.refractiveIndex.x, m.refractiveIndex.y, m.refractiveIndex.z}) < 1)
    return {Error::kNotFinite, name + ": the refractive index has to be at least 1."};
  if (!(m.opacity >= 0 && m.opacity <= 1))
    return {Error::kNotFinite, name + ": the opacity has to be 0 to 1."};
  if (!isFinite(s.toneCool) || !isFinite(s.toneWarm) || !isFinite(s.outlineColor) ||
      !std::isfinite(s.coolSurface) || !std::isfinite(s.warmSurface) ||
      !std::isfinite(s.outlineThreshold))
    return {Error::kNotFinite, name + ": a style value is not finite."};
  if (s.toonBands < 0 || s.toonBands > kMaxToonBands)
    return {Error::kNotFinite, name + ": its toon bands are not 0 to 64."};
  if (!areNotNegative({s.outlineWidth, s.outlineOpacity}) || s.outlineOpacity > 1)
    return {Error::kNotFinite,
            name + ": the outline's width has to be at least 0, its opacity 0 to 1."};
  if (!(s.undertone >= 0 && s.undertone <= 1))
    return {Error::kNotFinite, name + ": the share of the undertone has to be 0 to 1."};
  if (!(s.legendSafeRange >= 0 && s.legendSafeRange <= 100))
    return {Error::kNotFinite, name + ": the legend-safe range has to be 0 to 100."};
  if (!areNotNegative({s.imageOutline.depthTolerance, s.imageOutline.creaseDegrees}) ||
      s.imageOutline.creaseDegrees > 180)
    return {Error::kNotFinite,
            name +
                ": the tolerance of an image outline has to be at least 0, its crease angle 0 "
                "to 180 degrees."};
  if (s.imageOutline.detector != OutlineDetector::kNone && s.outlineWidth > kMaxImageOutlineWidth)
    return {Error::kNotFinite, name + ": an image outline has to be at most 64 pixels wide."};
  return {};
}

Status checkCues(const DepthCues& cues, InstanceName name)
{
  const auto isShare = [](float radius, float most) { return radius > 0 && radius <= most; };
  if (!areNotNegative({cues.eyeDome.strength}) || cues.eyeDome.strength > kMaxCueStrength ||
      !isShare(cues.eyeDome.radius, kMaxEyeDomeRadius))
    return {
        Error::kNotFinite,
        name + ": eye-dome lighting needs a strength of 0 to 100 and a radius above 0 to 0.02."};
  if (!areNotNegative({cues.unsharp.strength}) || cues.unsharp.strength > 1 ||
      !isShare(cues.unsharp.radius, kMaxUnsharpRadius))
    return {
        Error::kNotFinite,
        name + ": a depth unsharp mask needs a strength of 0 to 1 and a radius above 0 to 0.1."};
  if (!areNotNegative({cues.halo.width, cues.halo.depth}) || cues.halo.width > kMaxHaloWidth ||
      cues.halo.depth <= 0 || !isNotNegative(cues.halo.color))
    return {Error::kNotFinite, name +
                                   ": a halo has to be 0 to 64 pixels wide, its depth above 0 "
                                   "and its colour not negative."};
  return {};
}

Status checkRamp(const Style& style, InstanceName name)
{
  if (style.tone != Tone::kRamp && style.tone != Tone::kMatCap) return {};
  const ToneRamp& ramp = style.ramp;
  if (ramp.image == nullptr || ramp.image->empty())
    return {Error::kMissingData, name + ": its tone needs a picture; give it a ToneRamp::image."};
  const bool isRange = ramp.nearest > 0 && ramp.farthest > ramp.nearest;
  if (!areNotNegative({ramp.exponent, ramp.nearest, ramp.farthest}) ||
      !(isRange || (ramp.nearest == 0 && ramp.farthest == 0)))
    return {Error::kNotFinite,
            name + ": its ramp has a negative exponent or a range that is not 0 < a < b."};
  return {};
}

Status checkHatching(const Instance& instance, InstanceName name)
{
  if (instance.style.tone != Tone::kHatching) return {};
  const Hatching& hatching = instance.style.hatching;
  if (!isNotNegative(hatching.paper) || !isNotNegative(hatching.ink) ||
      !(hatching.darkest >= 0 && hatching.darkest <= 1))
    return {Error::kNotFinite,
            name +
                ": a colour of its hatching is negative or not finite, or its darkest tone not "
                "0 to 1."};
  if (!(hatching.spacing >= 1 && hatching.spacing <= kMaxHatchSpacing))
    return {Error::kNotFinite, name +
                                   ": the strokes of its hatching have to be 1 to 256 pixels "
                                   "apart."};
  if (hatching.place == HatchPlace::kTexture && instance.attributes.uv.empty() &&
      !instance.mesh.triangles.empty())
    return {Error::kMissingData,
            name + ": its hatching lies on texture coordinates, and there are none."};
  return {};
}

Status checkExaggeration(const Instance& instance, InstanceName name)
{
  if (instance.style.tone != Tone::kExaggerated) return {};
  const Exaggeration& e = instance.style.exaggeration;
  if (!(e.contrast >= 0 && e.contrast <= kMaxExaggeration) || !(e.base >= 0 && e.base <= 1) ||
      !(e.exponent >= -kMaxExaggerationExponent && e.exponent <= kMaxExaggerationExponent))
    return {Error::kNotFinite,
            name +
                ": its exaggeration needs a contrast of 0 to 1000, an exponent of -4 to 4 and a "
                "base of 0 to 1."};
  return {};
}

struct MeshSizes {
  std::size_t vertices, triangles;
};

Status checkSize(std::size_t size, std::size_t needed, InstanceName name, const char* what)
{
  if (size == 0 || size >= needed) return {};
  return {Error::kSizeMismatch, name + what + ": " + std::to_string(size) + " values for " +
                                    std::to_string(needed) + "; give one each or none."};
}

/// Of an instance that draws a hull.
Status checkHull(const Instance& instance, InstanceName name)
{
  const HullEdges& hull = *instance.hull;
  const MeshView& mesh = instance.mesh;
  if (hull.weld.size() != mesh.vertexCount() || hull.normal.size() != mesh.triangles.size())
    return {Error::kSizeMismatch,
            name + ": its hull is of another mesh; call buildHullEdges() for this one."};
  if (!isNotNegative(instance.style.outlineColor))
    return {Error::kNotFinite, name + ": the colour of its hull is negative or not finite."};
  const Attributes& a = instance.attributes;
  return a.cells.empty()
             ? Status{}
             : checkSize(a.cells.size(), mesh.triangles.size(), name, ": cells of triangles");
}

Status checkSmoothNormals(const Instance& instance, MeshSizes sizes, InstanceName name)
{
  const Attributes& a = instance.attributes;
  if (a.smoothNormals.empty()) {
    if (!instance.style.isExaggerated() || sizes.triangles == 0) return {};
    return {Error::kMissingData,
            name + ": its exaggeration needs normals of several scales; call smoothNormals()."};
  }
  if (a.smoothLevels < 1 || a.smoothLevels > kMaxSmoothLevels ||
      !(a.smoothRatio >= 1 && a.smoothRatio <= kMaxSmoothRatio))
    return {Error::kNotFinite,
            name + ": its smooth normals have to be of 1 to 8 levels, their ratio 1 to 16."};
  if (a.smoothNormals.size() > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max()))
    return {Error::kTooManyPrimitives,
            name + ": it has more than 2147483647 smooth normals; ask for fewer levels."};
  const auto levels = static_cast<std::size_t>(a.smoothLevels);
  if (a.smoothOfCorner.empty())
    return checkSize(a.smoothNormals.size(), sizes.vertices * levels, name, ": smooth normals");
  // As for cells, how many there are is told: to look at each corner would take as long as drawing.
  if (a.smoothCount == 0 || a.smoothCount > a.smoothNormals.size() / levels)
    return {Error::kSizeMismatch, name + ": its corners have " + std::to_string(a.smoothCount) +
                                      " smooth normals of " + std::to_string(levels) +
                                      " levels, and there are " +
                                      std::to_string(a.smoothNormals.size()) +
                                      " values; set smoothCount to how many there are."};
  return checkSize(a.smoothOfCorner.size(), 3 * sizes.triangles, name,
                   ": smooth normals of corners");
}

Status checkAttributes(const Instance& instance, MeshSizes sizes, InstanceName name)
{
  if (Status status = checkSmoothNormals(instance, sizes, name); !status.ok()) return status;
  const Attributes& a = instance.attributes;
  const Style& style = instance.style;
  if (!a.cells.empty() && a.cells.size() < sizes.triangles)
    return checkSize(a.cells.size(), sizes.triangles, name, ": cells of triangles");
  const std::size_t cells = a.cells.empty() ? sizes.triangles : a.cellCount;
  const bool flat = style.frequency == ShadingFrequency::kFlat;
  if (flat && (a.facePoints.empty() || a.faceNormals.empty()) && sizes.triangles > 0)
    return {Error::kMissingData, name + ": flat shading needs points and normals of faces."};
  if (!flat && style.normals == NormalSource::kVertex && a.vertexNormals.empty() &&
      sizes.triangles > 0)
    return {Error::kMissingData, name + ": the style asks for vertex normals that are not there."};
  if (!flat && style.normals == NormalSource::kCell && a.cellNormals.empty() && sizes.triangles > 0)
    return {Error::kMissingData, name + ": the style asks for cell normals that are not there."};
  const struct {
    std::size_t size, needed;
    const char* what;
  } checks[] = {
      {a.normalOfCorner.empty() ? a.vertexNormals.size() : 0, sizes.vertices, ": vertex normals"},
      {a.normalOfCorner.size(), 3 * sizes.triangles, ": normals of corners"},
      {a.cellNormals.size(), cells, ": cell normals"},
      {a.vertexColors.size(), sizes.vertices, ": vertex colours"},
      {a.cellColors.size(), cells, ": cell colours"},
      {a.cellIds.size(), cells, ": ids of cells"},
      {a.facePoints.size(), cells, ": points of faces"},
      {a.faceNormals.size(), cells, ": face normals"},
      {a.uv.size(), sizes.vertices, ": texture coordinates"},
      {a.uv2.size(), sizes.vertices, ": second texture coordinates"}};
  for (const auto& check : checks)
    if (Status status = checkSize(check.size, check.needed, name, check.what); !status.ok())
      return status;
  return {};
}

Status checkLayer(const TextureLayer& layer, const Attributes& attributes, const std::string& name)
{
  if ((layer.image == nullptr) == (layer.procedural == nullptr))
    return {Error::kMissingData, name + " needs an image or a procedural texture, and not both."};
  if (layer.image != nullptr && layer.image->empty())
    return {Error::kMissingData, name + " has an empty image; call TextureImage::build()."};
  if (layer.bendsNormals() && layer.image == nullptr)
    return {Error::kMissingData, name + " bends normals and needs an image."};
  if (layer.uvSet != 0 && layer.uvSet != 1)
    return {Error::kMissingData, name + " reads the texture coordinates " +
                                     std::to_string(layer.uvSet) + "; there are 0 and 1."};
  if (!std::isfinite(layer.amount) || !std::all_of(layer.uvTransform, layer.uvTransform + 6,
                                                   [](float v) { return std::isfinite(v); }))
    return {Error::kNotFinite, name + " has a value that is not a finite number."};
  if (layer.procedural != nullptr)
    if (Status status = checkProcedural(*layer.procedural, name); !status.ok()) return status;
  if (Status status = checkSampler(layer.sampler, name); !status.ok()) return status;
  const bool hasUv = !(layer.uvSet == 0 ? attributes.uv : attributes.uv2).empty();
  if ((layer.readsUv() || layer.bendsNormals()) && !hasUv)
    return {Error::kMissingData, name + " needs texture coordinates, and the mesh has none."};
  return {};
}

/// Of texture i.
Status checkJoin(Span<const TextureLayer> layers, std::size_t i, const std::string& name)
{
  if (layers[i].join == TextureJoin::kNone) return {};
  if (i == 0)
    return {Error::kMissingData, name + " is joined with the texture before it; there is none."};
  if (layers[i].bendsNormals() || layers[i - 1].role != layers[i].role)
    return {Error::kMissingData,
            name +
                " is joined with one of another role, or bends normals; only colours of the "
                "same role can be joined."};
  return {};
}

Status checkLayers(const Instance& instance, InstanceName name)
{
  for (std::size_t i = 0; i < instance.layers.size(); ++i) {
    const std::string text = ": texture " + std::to_string(i);
    if (Status status = checkLayer(instance.layers[i], instance.attributes, name + text.c_str());
        !status.ok())
      return status;
    if (Status status = checkJoin(instance.layers, i, name + text.c_str()); !status.ok())
      return status;
  }
  return {};
}

Status checkLineStyle(const LineStyle& style, const std::string& name)
{
  if (!areNotNegative(
          {style.opacity, style.width, style.outerFactor, style.taper, style.dash, style.gap}) ||
      !isNotNegative(style.color))
    return {Error::kNotFinite, name + " have a style value that is negative or not finite."};
  if (style.opacity > 1) return {Error::kNotFinite, name + ": the opacity has to be 0 to 1."};
  if (style.width <= 0 || style.width > kMaxLineWidth || style.outerFactor > kMaxLineWidth)
    return {Error::kNotFinite, name + ": the width has to be above 0 and at most 256 pixels."};
  // Dashes that no pixel tells apart would be without number.
  if (style.dash > 0 && (style.gap <= 0 || style.dash + style.gap < 0.5f))
    return {Error::kNotFinite,
            name + ": dashes need gaps, and both together at least half a pixel."};
  return {};
}

Status checkLines(const LineSet& set, const std::string& name)
{
  if (Status status = checkLineStyle(set.style, name); !status.ok()) return status;
  const std::size_t points = set.points.vertexCount();
  for (const std::uint32_t vertex : set.vertex)
    if (vertex >= points)
      return {Error::kIndexOutOfRange, name + " name a point that is not there."};
  for (std::size_t i = 0; i < set.first.size(); ++i)
    if (set.first[i] > set.vertex.size() || (i > 0 && set.first[i] < set.first[i - 1]))
      return {Error::kIndexOutOfRange, name + " have a chain that is out of order."};
  if (!set.flags.empty() && set.flags.size() < set.vertex.size())
    return {Error::kSizeMismatch, name + " have flags for some segments only; give all or none."};
  if (!set.slack.empty() && set.slack.size() < points)
    return {Error::kSizeMismatch, name + " have slack for some points only; give all or none."};
  if (!std::all_of(set.slack.begin(), set.slack.end(),
                   [](float slack) { return areNotNegative({slack}); }))
    return {Error::kNotFinite, name + " have a slack that is negative or not finite."};
  if (!set.share.empty() && set.share.size() < points)
    return {Error::kSizeMismatch, name + " have shares for some points only; give all or none."};
  if (!std::all_of(set.share.begin(), set.share.end(),
                   [](float share) { return share >= 0 && share <= 1; }))
    return {Error::kNotFinite, name + " have a share of their width that is not from 0 to 1."};
  return {};
}

Status checkInstance(const Instance& instance, std::size_t number, Backend backend)
{
  const InstanceName name = {number};
  if (!isFinite(instance.modelToWorld))
    return {Error::kNotFinite, name + ": its matrix has a value that is not a finite number."};
  if (Status status = checkMaterial(instance, name); !status.ok()) return status;
  if (Status status = checkCues(instance.style.cues, name); !status.ok()) return status;
  if (instance.hull != nullptr) return checkHull(instance, name);
  if (Status status = checkRamp(instance.style, name); !status.ok()) return status;
  if (Status status = checkHatching(instance, name); !status.ok()) return status;
  if (Status status = checkExaggeration(instance, name); !status.ok()) return status;
  if (Status status = checkLayers(instance, name); !status.ok()) return status;
  for (std::size_t i = 0; i < instance.lines.size(); ++i)
    if (Status status =
            checkLines(instance.lines[i], name + (": lines " + std::to_string(i)).c_str());
        !status.ok())
      return status;
  if (backend == Backend::kPipeline) {
    if (instance.clusters == nullptr)
      return {Error::kMissingData, name + " has no clusters; call buildClusters()."};
    const ClusteredMesh& mesh = *instance.clusters;
    return checkAttributes(instance, {mesh.meshVertexCount, mesh.meshTriangleCount}, name);
  }
  if (instance.mesh.triangles.empty() && instance.clusters != nullptr &&
      instance.clusters->triangleCount > 0)
    return {Error::kMissingData, name + ": the reference renderer needs the mesh's triangles."};
  return checkAttributes(instance, {instance.mesh.vertexCount(), instance.mesh.triangles.size()},
                         name);
}

}  // namespace

Status checkScene(const Scene& scene, const FrameView& frame, Backend backend)
{
  if (Status status = checkFrame(scene, frame); !status.ok()) return status;
  if (!isFinite(scene.camera.worldToView) || !isFinite(scene.camera.viewToClip))
    return {Error::kNotFinite, "A camera matrix has a value that is not a finite number."};
  if (!isNotNegative(scene.ambientLight))
    return {Error::kNotFinite, "The ambient light is negative or not finite."};
  if (Status status = checkLights(scene.lights); !status.ok()) return status;
  std::size_t clusters = 0;
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    if (Status status = checkInstance(scene.instances[i], i, backend); !status.ok()) return status;
    if (backend == Backend::kPipeline && scene.instances[i].hull == nullptr)
      clusters += scene.instances[i].clusters->clusters.size();
  }
  if (clusters >= kNobody)
    return {Error::kTooManyPrimitives,
            "The frame has more than 4294967294 clusters; draw fewer "
            "meshes at once."};
  return {};
}

}  // namespace limn
