// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SelectionIds_h
#define SelectionIds_h

#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <map>
#include <vector>

class vtkActor;
class vtkHardwareSelector;
class vtkOpenGLPolyDataMapper;

/// Turns the primitive numbers that a selection pass drew into cell numbers.
///
/// vtkHardwareSelector asks the selected actor's own mapper to do so; here another one drew, and
/// only that one knows how it cut the cells into primitives.
class SelectionIds
{
public:
  /// Call after `twin` drew `actor` in a pass of `selector`.
  void Note(vtkHardwareSelector* selector, vtkActor* actor, vtkOpenGLPolyDataMapper* twin);
  bool IsEmpty() const { return this->Drawn.empty(); }
  /// Call when all of the pass is drawn. Forgets what was noted.
  void Translate(vtkHardwareSelector* selector);

private:
  struct Draw
  {
    vtkWeakPointer<vtkActor> Actor;
    vtkSmartPointer<vtkOpenGLPolyDataMapper> Twin;
  };
  std::vector<Draw> Drawn;
  std::map<vtkOpenGLPolyDataMapper*, int> ActorCode; ///< as the actor pass has it in its pixels
};

#endif
