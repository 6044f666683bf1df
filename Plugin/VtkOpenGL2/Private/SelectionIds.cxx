// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SelectionIds.h"

#include "vtkActor.h"
#include "vtkHardwareSelector.h"
#include "vtkOpenGLPolyDataMapper.h"

#include <unordered_map>

namespace
{
int CodeOf(const unsigned char* rgb)
{
  return rgb[0] | rgb[1] << 8 | rgb[2] << 16;
}

int CodeOf(const float* color)
{
  unsigned char rgb[3];
  for (int i = 0; i < 3; ++i)
  {
    rgb[i] = static_cast<unsigned char>(color[i] * 255.0f + 0.5f);
  }
  return CodeOf(rgb);
}

using PixelsByCode = std::unordered_map<int, std::vector<unsigned int>>;

/// Offsets into the selector's buffers, by what the actor pass drew there.
PixelsByCode AllPixels(vtkHardwareSelector* selector)
{
  constexpr int Nobody = 0;
  const unsigned int* area = selector->GetArea();
  const unsigned int pixels = (area[2] - area[0] + 1) * (area[3] - area[1] + 1);
  const unsigned char* codes = selector->GetRawPixelBuffer(vtkHardwareSelector::ACTOR_PASS);
  PixelsByCode offsets;
  for (unsigned int offset = 0; codes && offset < 3 * pixels; offset += 3)
  {
    const int code = CodeOf(codes + offset);
    if (code != Nobody)
    {
      offsets[code].push_back(offset);
    }
  }
  return offsets;
}
}

void SelectionIds::Note(
  vtkHardwareSelector* selector, vtkActor* actor, vtkOpenGLPolyDataMapper* twin)
{
  if (selector->GetCurrentPass() == vtkHardwareSelector::ACTOR_PASS)
  {
    this->ActorCode[twin] = CodeOf(selector->GetPropColorValue());
  }
  this->Drawn.push_back({ actor, twin });
}

void SelectionIds::Translate(vtkHardwareSelector* selector)
{
  if (selector->GetCurrentPass() > vtkHardwareSelector::ACTOR_PASS)
  {
    PixelsByCode pixels = AllPixels(selector);
    for (const Draw& draw : this->Drawn)
    {
      if (draw.Actor)
      {
        draw.Twin->ProcessSelectorPixelBuffers(
          selector, pixels[this->ActorCode[draw.Twin]], draw.Actor);
      }
    }
  }
  this->Drawn.clear();
}
