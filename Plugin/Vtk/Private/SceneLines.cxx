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

void SceneLines::keep(std::size_t body, ContourLines lines)
{
  if (!lines.chains.empty())
  {
    lines_[body].push_back(std::make_shared<const ContourLines>(std::move(lines)));
  }
}

void SceneLines::castShadows(const WorldMesh& world, const TriangleTree& tree, int threads)
{
  std::vector<double> creaseDegrees;
  for (const Body& body : bodies_)
  {
    creaseDegrees.push_back(body.creaseDegrees);
  }
  for (std::size_t light = 0; light < lights_.size(); ++light)
  {
    const auto pieces = shadowPieces(world, tree, lights_[light], creaseDegrees, threads);
    for (std::size_t i = 0; i < bodies_.size(); ++i)
    {
      Mat4d toModel;
      if (bodies_[i].castsShadow && (light == 0 || bodies_[i].hasAllLights) &&
          invert(bodies_[i].place, toModel))
      {
        this->keep(i, shadowBorder(world, pieces, i, toModel));
      }
    }
  }
}

void SceneLines::cut(const WorldMesh& world, const TriangleTree& tree, int threads)
{
  std::vector<std::uint8_t> isCut;
  for (const Body& body : bodies_)
  {
    isCut.push_back(body.isCut ? 1 : 0);
  }
  const auto pieces = intersections(world, tree, isCut, threads);
  for (std::size_t i = 0; i < bodies_.size(); ++i)
  {
    if (Mat4d toModel; bodies_[i].isCut && invert(bodies_[i].place, toModel))
    {
      this->keep(i, intersectionLines(world, pieces, isCut, i, toModel));
    }
  }
}

Status SceneLines::build(const std::vector<Instance>& instances, int threads)
{
  lines_.assign(bodies_.size(), {});
  std::vector<PlacedMesh> meshes;
  std::vector<std::uint8_t> castsShadow;
  for (std::size_t i = 0; i < bodies_.size(); ++i)
  {
    meshes.push_back({ instances[i].mesh, instances[i].modelToWorld });
    castsShadow.push_back(bodies_[i].castsShadow && !lights_.empty() ? 1 : 0);
  }
  WorldMesh world;
  if (Status status = buildWorldMesh(meshes, castsShadow, threads, world); !status.ok())
  {
    bodies_.clear();
    return status;
  }
  const TriangleTree tree(world);
  if (!world.edges.empty())
  {
    this->castShadows(world, tree, threads);
  }
  if (std::any_of(bodies_.begin(), bodies_.end(), [](const Body& body) { return body.isCut; }))
  {
    this->cut(world, tree, threads);
  }
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
  if (!(bodies == bodies_ && lights == lights_))
  {
    bodies_ = std::move(bodies);
    lights_ = std::move(lights);
    if (Status status = this->build(instances, view.threads); !status.ok())
    {
      return status;
    }
  }
  for (std::size_t i = 0; i < surfaces.size(); ++i)
  {
    if (lines_[i].empty())
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
    for (const Lines& lines : lines_[i])
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
