// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rendering/Lines/HatchStrokes.h"

namespace limn {
namespace {

template <class T>
void appendAll(const std::vector<T>& more, std::vector<T>& all)
{
  all.insert(all.end(), more.begin(), more.end());
}

}  // namespace

void HatchStrokes::append(const HatchStrokes& more)
{
  const auto pointCount = static_cast<std::uint32_t>(points.size());
  const auto vertexCount = static_cast<std::uint32_t>(vertex.size());
  appendAll(more.points, points);
  appendAll(more.triangle, triangle);
  appendAll(more.normals, normals);
  appendAll(more.across, across);
  appendAll(more.rank, rank);
  appendAll(more.isCross, isCross);
  appendAll(more.face, face);
  for (const std::uint32_t v : more.vertex)
    vertex.push_back(pointCount + v);
  for (std::size_t i = first.empty() ? 0 : 1; i < more.first.size(); ++i)
    first.push_back(vertexCount + more.first[i]);
}

}  // namespace limn
