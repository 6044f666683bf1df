// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Mesh/FaceGeometry.h"

#include "Rendering/Mesh/LocalPosition.h"

namespace limn {
namespace {

/// Sums over the triangles of one face.
struct FaceSums {
  Vec3d twiceArea = {0, 0, 0};  ///< vector area of all triangles
  Vec3d moment = {0, 0, 0};     ///< centroids times areas
  double area = 0;
  Vec3d corners = {0, 0, 0};
  double cornerCount = 0;
};

}  // namespace

FaceGeometry faceGeometry(const MeshView& mesh, Span<const std::uint32_t> cells,
                          std::size_t cellCount)
{
  const Vec3d origin = localOrigin(finiteBox(mesh));
  const std::size_t vertexCount = mesh.vertexCount();
  std::vector<FaceSums> sums(cellCount);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::size_t cell = cells.empty() ? t : cells[t];
    const auto [i, j, k] = mesh.triangles[t].vertex;
    if (i >= vertexCount || j >= vertexCount || k >= vertexCount || cell >= cellCount) continue;
    const Vec3d a = mesh.position(i) - origin, b = mesh.position(j) - origin,
                c = mesh.position(k) - origin;
    const Vec3d twiceArea = cross(b - a, c - a);
    if (!isFinite(twiceArea)) continue;
    FaceSums& face = sums[cell];
    const double area = std::sqrt(dot(twiceArea, twiceArea));
    const Vec3d corners = (a + b) + c;
    face.twiceArea = face.twiceArea + twiceArea;
    face.moment = face.moment + corners * (area / 3.0);
    face.area += area;
    face.corners = face.corners + corners;
    face.cornerCount += 3;
  }
  FaceGeometry faces;
  faces.centroid.reserve(cellCount);
  faces.normal.reserve(cellCount);
  for (const FaceSums& face : sums) {
    const Vec3d centroid = face.area > 0          ? face.moment * (1.0 / face.area)
                           : face.cornerCount > 0 ? face.corners * (1.0 / face.cornerCount)
                                                  : Vec3d{0, 0, 0};
    faces.centroid.push_back(origin + centroid);
    faces.normal.push_back(vec3Cast<float>(normalized(face.twiceArea)));
  }
  return faces;
}

std::vector<Vec3d> firstCorners(const MeshView& mesh, Span<const std::uint32_t> cells,
                                std::size_t cellCount)
{
  std::vector<Vec3d> corners(cellCount, Vec3d{0, 0, 0});
  // From the last to the first, which stays.
  for (std::size_t t = mesh.triangles.size(); t-- > 0;) {
    const std::size_t cell = cells.empty() ? t : cells[t];
    const std::uint32_t vertex = mesh.triangles[t].vertex[0];
    if (vertex >= mesh.vertexCount() || cell >= cellCount) continue;
    const Vec3d position = mesh.position(vertex);
    if (isFinite(position)) corners[cell] = position;
  }
  return corners;
}

}  // namespace limn
