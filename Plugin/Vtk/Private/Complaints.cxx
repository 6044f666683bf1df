// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Complaints.h"

#include "vtkObject.h"

#include <algorithm>

namespace limn::bridge
{

Complaints::~Complaints()
{
  for (const Complaint& one : all_)
  {
    const std::string text = one.cause + one.details;
    if (one.others > 0)
    {
      vtkWarningWithObjectMacro(
        one.object, << text << " So it is with " << one.others << " more in this scene.");
    }
    else
    {
      vtkWarningWithObjectMacro(one.object, << text);
    }
  }
}

void Complaints::add(vtkObject* object, const std::string& cause, const std::string& details)
{
  const auto known = std::find_if(
    all_.begin(), all_.end(), [&](const Complaint& one) { return one.cause == cause; });
  if (known != all_.end())
  {
    ++known->others;
    return;
  }
  all_.push_back({ object, cause, details, 0 });
}

} // namespace limn::bridge
