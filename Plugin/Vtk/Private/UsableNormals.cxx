// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "UsableNormals.h"

#include "Rendering/Base/ParallelStretches.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace limn::bridge
{
namespace
{

/// Shading divides by the length, which is infinite of large floats, too.
bool isUsable(Vec3f normal)
{
  return std::isfinite(dot(normal, normal));
}

std::size_t unusableOf(Span<const Vec3f> normals, int threads)
{
  constexpr std::size_t kPerTask = 65536;
  std::vector<std::size_t> counts(stretchCount(normals.size(), kPerTask));
  parallelForStretches(threads, normals.size(), kPerTask,
    [&](std::size_t stretch, std::size_t first, std::size_t end)
    {
      std::size_t count = 0;
      for (std::size_t i = first; i < end; ++i)
      {
        count += isUsable(normals[i]) ? 0 : 1;
      }
      counts[stretch] = count;
    });
  return std::accumulate(counts.begin(), counts.end(), std::size_t{ 0 });
}

} // namespace

void UsableNormals::look(Span<const Vec3f> given, vtkMTimeType version, int threads)
{
  if (given.data() == given_.data() && given.size() == given_.size() && version == version_)
  {
    return;
  }
  *this = UsableNormals();
  given_ = given;
  version_ = version;
  unusable_ = unusableOf(given, threads);
  if (this->areNone())
  {
    replaced_ = static_cast<vtkIdType>(unusable_);
  }
}

bool UsableNormals::lacksOwn(vtkIdType geometry) const
{
  return unusable_ > 0 && !this->areNone() && geometry_ != geometry;
}

void UsableNormals::replace(std::vector<Vec3f> own, vtkIdType geometry)
{
  mended_ = std::move(own);
  geometry_ = geometry;
  replaced_ = 0;
  for (std::size_t i = 0; i < mended_.size(); ++i)
  {
    if (isUsable(given_[i]))
    {
      mended_[i] = given_[i];
    }
    else if (!(mended_[i] == Vec3f{ 0, 0, 0 }))
    {
      ++replaced_;
    }
  }
}

Span<const Vec3f> UsableNormals::span() const
{
  if (unusable_ == 0)
  {
    return given_;
  }
  return this->areNone() ? Span<const Vec3f>() : Span<const Vec3f>(mended_);
}

} // namespace limn::bridge
