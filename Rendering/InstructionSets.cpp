// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The part of Renderer.h that chooses among the compiled kernels.
#include "Rendering/Renderer.h"

#include <hwy/highway.h>

namespace limn {

std::vector<std::string> availableTargets()
{
  const std::string current = currentTarget();
  hwy::SetSupportedTargetsForTest(0);
  std::vector<std::string> names;
  // Highway numbers better targets with lower bits.
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets())
    names.emplace_back(hwy::TargetName(target));
  useTarget(current);
  return names;
}

bool useTarget(const std::string& name)
{
  std::int64_t chosen = 0;
  hwy::SetSupportedTargetsForTest(0);
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets())
    if (name == hwy::TargetName(target)) chosen = target;
  hwy::SetSupportedTargetsForTest(chosen);
  hwy::GetChosenTarget().DeInit();
  return chosen != 0 || name.empty();
}

std::string currentTarget()
{
  return hwy::TargetName(hwy::SupportedAndGeneratedTargets().front());
}

}  // namespace limn
