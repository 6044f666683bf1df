// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef BackendActor_h
#define BackendActor_h

#include "vtkNew.h"

class vtkActor;
class vtkInformation;
class vtkMapper;
class vtkMatrix4x4;
class vtkOpenGLActor;
class vtkOpenGLPolyDataMapper;
class vtkPolyDataMapper;
class vtkRenderer;

/// The OpenGL twin of an actor with a mapper: shares their input, property, texture, lookup table
/// and matrix, and keeps its own buffers between frames. OpenGL's mappers take it for granted that
/// an actor is OpenGL's own.
class BackendActor
{
public:
  BackendActor();
  ~BackendActor();
  BackendActor(const BackendActor&) = delete;
  BackendActor& operator=(const BackendActor&) = delete;

  /// Draws as vtkOpenGLActor with a vtkOpenGLProperty would, in the pass that `actor` is in.
  /// Requires: called while vtkActor renders `actor`, which readies its texture.
  void Render(vtkRenderer* renderer, vtkActor* actor, vtkPolyDataMapper* mapper);

  /// The same, for a mapper that is OpenGL's already.
  void RenderOpenGLMapper(vtkRenderer* renderer, vtkActor* actor, vtkMapper* mapper);

  /// The twin that drew; it knows which primitive stands for which cell.
  vtkOpenGLPolyDataMapper* GetMapper() { return this->Mapper; }

private:
  void Follow(vtkActor* actor);
  void Follow(vtkPolyDataMapper* mapper);
  void Draw(vtkRenderer* renderer, vtkActor* actor, vtkMapper* mapper);

  vtkNew<vtkOpenGLActor> Actor;
  vtkNew<vtkOpenGLPolyDataMapper> Mapper;
  vtkNew<vtkMatrix4x4> Matrix;
  vtkNew<vtkInformation> Keys;
};

#endif
