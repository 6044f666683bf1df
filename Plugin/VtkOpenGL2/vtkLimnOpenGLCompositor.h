// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLimnOpenGLCompositor
 * @brief   brings Limn's pictures into OpenGL windows
 *
 * Uploads the touched rectangle of a layer and draws it with colour and depth. In a multisampled
 * framebuffer each pixel writes just the samples that Limn covered, so that VTK's own resolve
 * blends its edges with whatever else is drawn there, before or after. Lines that cover a part of
 * such a sample are blended when all opaque actors are drawn. What Limn does not draw is
 * drawn by vtkOpenGLPolyDataMapper.
 *
 * One object serves any number of windows; what it keeps for a window goes with the window.
 *
 * @sa
 * vtkLimnCompositor vtkOpenGLPolyDataMapper
 */

#ifndef vtkLimnOpenGLCompositor_h
#define vtkLimnOpenGLCompositor_h

#include "vtkLimnCompositor.h"
#include "vtkLimnOpenGL2Module.h" // for export macro

#include <memory> // for std::unique_ptr

class vtkOpenGLPolyDataMapper;
class vtkOpenGLRenderWindow;

class VTKLIMNOPENGL2_EXPORT vtkLimnOpenGLCompositor : public vtkLimnCompositor
{
public:
  static vtkLimnOpenGLCompositor* New();
  vtkTypeMacro(vtkLimnOpenGLCompositor, vtkLimnCompositor);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The samples of the bound framebuffer, or the next smaller of 8, 4, 2 and 1. Call it while the
   * renderer draws: outside of a frame the window's own buffers are bound, not those it draws to.
   */
  int GetSamples(vtkRenderer* renderer) override;

  /**
   * Errors: the window is not an OpenGL window, the layer is not as large as the viewport, a plane
   * is missing, the number of samples is none of 1, 2, 4 and 8, a texture cannot be made.
   */
  bool Composite(vtkRenderer* renderer, const Layer& layer) override;

  int GetSamplesForBlend(vtkRenderer* renderer) override;

  bool ReadDepth(vtkRenderer* renderer, int width, int height, float* depth) override;

  /**
   * Errors: as Composite().
   */
  bool Blend(vtkRenderer* renderer, const Layer& layer) override;

  /**
   * Errors: as Composite().
   */
  bool BlendLines(vtkRenderer* renderer, const LineLayer& lines) override;

  void RenderWithBackend(
    vtkRenderer* renderer, vtkActor* actor, vtkPolyDataMapper* mapper) override;

  void RenderMapperWithBackend(vtkRenderer* renderer, vtkActor* actor, vtkMapper* mapper) override;

  vtkActor* NewActor() override;

  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkLimnOpenGLCompositor();
  ~vtkLimnOpenGLCompositor() override;

private:
  vtkLimnOpenGLCompositor(const vtkLimnOpenGLCompositor&) = delete;
  void operator=(const vtkLimnOpenGLCompositor&) = delete;

  vtkOpenGLRenderWindow* GetWindow(vtkRenderer* renderer);
  bool IsValid(const Layer& layer);
  bool IsSampled(int samples);
  bool IsAccepted(const Layer& layer, bool isPainted);
  template <class Paint>
  bool PaintInOwnFramebuffer(vtkRenderer* renderer, int width, int height, const Paint& paint);
  void NoteSelection(vtkRenderer* renderer, vtkActor* actor, vtkOpenGLPolyDataMapper* twin);

  void ForgetWindow(vtkObject* window, unsigned long event, void* data);
  void ForgetActor(vtkObject* actor, unsigned long event, void* data);
  void ForgetMapper(vtkObject* mapper, unsigned long event, void* data);
  void TranslateSelection(vtkObject* renderer, unsigned long event, void* data);

  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
