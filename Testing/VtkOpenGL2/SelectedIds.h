// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "GLScene.h"

#include "vtkHardwareSelector.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"

#include <map>
#include <set>

/// By prop, the ids of its selected cells or points.
using SelectedIds = std::map<vtkProp*, std::set<vtkIdType>>;

/// Selects in the whole of a window of 200 x 160 pixels.
inline SelectedIds Select(GLScene& scene, int association)
{
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(scene.Renderer);
  selector->SetArea(0, 0, 199, 159);
  selector->SetFieldAssociation(association);
  auto selection = vtkSmartPointer<vtkSelection>::Take(selector->Select());
  SelectedIds selected;
  for (unsigned int i = 0; i < selection->GetNumberOfNodes(); ++i)
  {
    vtkSelectionNode* node = selection->GetNode(i);
    auto* prop = vtkProp::SafeDownCast(node->GetProperties()->Get(vtkSelectionNode::PROP()));
    auto* ids = vtkIdTypeArray::SafeDownCast(node->GetSelectionList());
    for (vtkIdType j = 0; j < ids->GetNumberOfValues(); ++j)
    {
      selected[prop].insert(ids->GetValue(j));
    }
  }
  return selected;
}
