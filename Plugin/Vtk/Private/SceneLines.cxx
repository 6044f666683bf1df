// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SceneLines.h"

#include "MapperInternals.h"

#include "vtkLimnProperty.h"

#include "vtkActor.h"

#include <algorithm>
#include <utility>

namespace limn::bridge
{

namespace
{

/// As they are, or with what a camera sees only the other side of.
std::shared_ptr<const ContourLines> seenLines(
  const std::shared_ptr<const ShadowLines>& shadow, const Camera& camera, const Mat4d& place)
{
  std::vector<std::uint8_t> flags;
  if (!concealBehindSheets(*shadow, camera, place, flags))
  {
    return { shadow, &shadow->lines };
  }
  auto lines = std::make_shared<ContourLines>(shadow->lines);
  lines->chains.flags = std::move(flags);
  return lines;
}

} // namespace

bool wantsSceneLines(vtkProperty* property)
{
  vtkLimnProperty* const limn = vtkLimnProperty::SafeDownCast(property);
  return limn && (limn->GetShadowLines() || limn->GetIntersectionLines());
}

bool SceneLines::Body::operator==(const Body& other) const
{
  return mapper == other.mapper && geometry == other.geometry && isSamePlace(place, other.place) &&
         castsShadow == other.castsShadow && isCut == other.isCut &&
         hasAllLights == other.hasAllLights && creaseDegrees == other.creaseDegrees;
}

SceneLines::Body SceneLines::bodyOf(const Surface& surface)
{
  vtkLimnProperty* const property = vtkLimnProperty::SafeDownCast(surface.actor->GetProperty());
  return { surface.mapper, surface.mapper->GetInternals().Mesh.geometryChanges(),
    surface.modelToWorld, property && property->GetShadowLines(),
    property && property->GetIntersectionLines(),
    property && property->GetLineLights() == vtkLimnProperty::LINE_LIGHTS_ALL,
    property ? property->GetCreaseAngle() : 0 };
}

void SceneLines::castShadows(int threads)
{
  shadows_.assign(bodies_.size(), {});
  if (!refinedTree_)
  {
    return;
  }
  std::vector<double> creaseDegrees;
  for (const Body& body : bodies_)
  {
    creaseDegrees.push_back(body.creaseDegrees);
  }
  for (std::size_t light = 0; light < lights_.size(); ++light)
  {
    const auto casters = shadowCasters(refined_.mesh, refined_.normals, lights_[light], threads);
    const auto pieces =
      shadowPieces(refined_.mesh, *refinedTree_, lights_[light], casters, creaseDegrees, threads);
    for (std::size_t i = 0; i < bodies_.size(); ++i)
    {
      Mat4d toModel;
      if (bodies_[i].castsShadow && (light == 0 || bodies_[i].hasAllLights) &&
          invert(bodies_[i].place, toModel))
      {
        ShadowLines shadow = shadowBorder(refined_, casters, pieces, lights_[light], i, toModel);
        if (!shadow.lines.chains.empty())
        {
          shadows_[i].push_back(std::make_shared<const ShadowLines>(std::move(shadow)));
        }
      }
    }
  }
}

void SceneLines::cut(const WorldMesh& world, int threads)
{
  cuts_.assign(bodies_.size(), {});
  std::vector<std::uint8_t> isCut;
  for (const Body& body : bodies_)
  {
    isCut.push_back(body.isCut ? 1 : 0);
  }
  if (std::count(isCut.begin(), isCut.end(), 1) == 0)
  {
    return;
  }
  const auto pieces = intersections(world, TriangleTree(world), isCut, threads);
  for (std::size_t i = 0; i < bodies_.size(); ++i)
  {
    if (Mat4d toModel; bodies_[i].isCut && invert(bodies_[i].place, toModel))
    {
      ContourLines lines = intersectionLines(world, pieces, isCut, i, toModel);
      if (!lines.chains.empty())
      {
        cuts_[i] = std::make_shared<const ContourLines>(std::move(lines));
      }
    }
  }
}

Status SceneLines::place(const std::vector<Instance>& instances, bool hasLights, int threads)
{
  std::vector<PlacedMesh> meshes;
  std::vector<std::uint8_t> castsShadow;
  std::vector<double> creaseDegrees;
  for (std::size_t i = 0; i < bodies_.size(); ++i)
  {
    meshes.push_back({ instances[i].mesh, instances[i].modelToWorld });
    castsShadow.push_back(bodies_[i].castsShadow && hasLights ? 1 : 0);
    creaseDegrees.push_back(bodies_[i].creaseDegrees);
  }
  WorldMesh world;
  if (Status status = buildWorldMesh(meshes, castsShadow, threads, world); !status.ok())
  {
    return status;
  }
  this->cut(world, threads);
  refined_ = {};
  refinedTree_.reset();
  if (world.edges.empty())
  {
    return {};
  }
  WorldNormals normals;
  if (Status status = worldNormals(world, creaseDegrees, threads, normals); !status.ok())
  {
    return status;
  }
  refined_ = refineWorld(std::move(world), std::move(normals));
  refinedTree_ = std::make_unique<const TriangleTree>(refined_.mesh);
  return {};
}

Status SceneLines::add(const std::vector<const Surface*>& surfaces,
  std::vector<Instance>& instances, const LineView& view, FrameLines& frame)
{
  std::vector<Body> bodies;
  bodies.reserve(surfaces.size());
  for (const Surface* const surface : surfaces)
  {
    bodies.push_back(bodyOf(*surface));
  }
  const auto any = [&](bool Body::*wish) {
    return std::any_of(bodies.begin(), bodies.end(), [&](const Body& body) { return body.*wish; });
  };
  std::vector<LightRays> lights = any(&Body::castsShadow) ? view.rays : std::vector<LightRays>();
  if (!lights.empty() && !any(&Body::hasAllLights))
  {
    lights.resize(1);
  }
  const bool isPlaced = bodies == bodies_ && lights.empty() == lights_.empty();
  if (!isPlaced)
  {
    bodies_ = std::move(bodies);
    if (Status status = this->place(instances, !lights.empty(), view.threads); !status.ok())
    {
      bodies_.clear();
      return status;
    }
  }
  if (!isPlaced || !(lights == lights_))
  {
    lights_ = std::move(lights);
    this->castShadows(view.threads);
  }
  for (std::size_t i = 0; i < surfaces.size(); ++i)
  {
    if (!cuts_[i] && shadows_[i].empty())
    {
      continue;
    }
    const LineStyle style = strokeStyleOf(
      vtkLimnProperty::SafeDownCast(surfaces[i]->actor->GetProperty()), view.pixelsPerInch);
    if (Status status = checkStroke(style); !status.ok())
    {
      return status;
    }
    const Span<const LineSet> before = instances[i].lines;
    auto sets = std::make_unique<std::vector<LineSet>>(before.begin(), before.end());
    std::vector<std::shared_ptr<const ContourLines>> all;
    for (const auto& shadow : shadows_[i])
    {
      all.push_back(seenLines(shadow, view.camera, instances[i].modelToWorld));
    }
    if (cuts_[i])
    {
      all.push_back(cuts_[i]);
    }
    for (const auto& lines : all)
    {
      frame.contours.push_back(lines);
      sets->push_back(lines->lines(style));
    }
    instances[i].lines = *sets;
    frame.sets.push_back(std::move(sets));
  }
  return {};
}

} // namespace limn::bridge
