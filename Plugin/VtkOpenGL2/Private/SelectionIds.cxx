// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SelectionIds.h"

#include "vtkActor.h"
#include "vtkHardwareSelector.h"
#include "vtkOpenGLPolyDataMapper.h"

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

std::vector<unsigned int> PixelsOf(int code, vtkHardwareSelector* selector)
{
  const unsigned int* area = selector->GetArea();
  const unsigned int pixels = (area[2] - area[0] + 1) * (area[3] - area[1] + 1);
  const unsigned char* codes = selector->GetRawPixelBuffer(vtkHardwareSelector::ACTOR_PASS);
  std::vector<unsigned int> offsets;
  for (unsigned int offset = 0; codes && offset < 3 * pixels; offset += 3)
  {
    if (CodeOf(codes + offset) == code)
    {
      offsets.push_back(offset);
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
  for (const Draw& draw : this->Drawn)
  {
    if (draw.Actor && selector->GetCurrentPass() > vtkHardwareSelector::ACTOR_PASS)
    {
      std::vector<unsigned int> offsets = PixelsOf(this->ActorCode[draw.Twin], selector);
      draw.Twin->ProcessSelectorPixelBuffers(selector, offsets, draw.Actor);
    }
  }
  this->Drawn.clear();
}
