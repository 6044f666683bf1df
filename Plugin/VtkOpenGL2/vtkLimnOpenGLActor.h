// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLimnOpenGLActor
 * @brief   the actor that vtkActor::New() makes beside OpenGL windows
 *
 * VTK's OpenGL classes take it for granted that every actor is a vtkOpenGLActor; some make actors
 * of their own by vtkActor::New() (images, text in space). So the object factory makes this one
 * where the program's windows are OpenGL's. It draws as vtkLimnActor does.
 *
 * @sa
 * vtkLimnActor vtkLimnOpenGLCompositor
 */

#ifndef vtkLimnOpenGLActor_h
#define vtkLimnOpenGLActor_h

#include "vtkLimnOpenGL2Module.h" // for export macro
#include "vtkOpenGLActor.h"

class vtkLimnCompositor;

class VTKLIMNOPENGL2_EXPORT vtkLimnOpenGLActor : public vtkOpenGLActor
{
public:
  static vtkLimnOpenGLActor* New();
  vtkTypeMacro(vtkLimnOpenGLActor, vtkOpenGLActor);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Who draws mappers that are not Limn's; not kept alive. Without one they draw themselves.
   */
  void SetCompositor(vtkLimnCompositor* compositor) { this->Compositor = compositor; }

  void Render(vtkRenderer* renderer, vtkMapper* mapper) override;

  ///@{
  /**
   * As vtkOpenGLActor's, after Limn's lines that wait for all opaque actors.
   */
  int RenderTranslucentPolygonalGeometry(vtkViewport* viewport) override;
  int RenderVolumetricGeometry(vtkViewport* viewport) override;
  ///@}

protected:
  vtkLimnOpenGLActor() = default;
  ~vtkLimnOpenGLActor() override = default;

private:
  vtkLimnOpenGLActor(const vtkLimnOpenGLActor&) = delete;
  void operator=(const vtkLimnOpenGLActor&) = delete;

  vtkLimnCompositor* Compositor = nullptr;
};

#endif
