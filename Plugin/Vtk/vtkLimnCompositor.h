// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLimnCompositor
 * @brief   what Limn needs from a window that it does not own
 *
 * Limn's mapper draws into its own memory. In a window made by another backend (OpenGL) the result
 * has to be carried over, and what Limn cannot draw has to be drawn by that backend's own classes.
 * This interface is all that Limn knows of such a backend. The module Limn::VtkOpenGL2 provides the
 * implementation for OpenGL windows; New() makes it through the object factory, loading the module
 * if the program has not, and returns nullptr if it cannot be had.
 *
 * @sa
 * vtkLimnPolyDataMapper vtkLimnRenderWindow
 */

#ifndef vtkLimnCompositor_h
#define vtkLimnCompositor_h

#include "vtkLimnModule.h" // for export macro
#include "vtkObject.h"

#include <cstddef> // for size_t

class vtkActor;
class vtkMapper;
class vtkPolyDataMapper;
class vtkRenderer;
class vtkWindow;

class VTKLIMN_EXPORT vtkLimnCompositor : public vtkObject
{
public:
  static vtkLimnCompositor* New();
  vtkTypeMacro(vtkLimnCompositor, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * A picture of one viewport. Rows run from the bottom; Width x Height is the viewport's size in
   * pixels. Only pixels [Touched[0], Touched[2]) x [Touched[1], Touched[3]) can hold something.
   */
  struct Layer
  {
    int Width;
    int Height;
    int Touched[4];
    int Samples;
    const unsigned char* Color;    ///< RGBA; the mean of the covered samples, opaque, or all zero
    const float* Depth;            ///< window depth in [0, 1] of the nearest covered sample
    const unsigned char* Coverage; ///< bit s set: sample s is covered; 0: nothing here
  };

  /**
   * The number of samples per pixel with which a layer blends best with the renderer's window: what
   * its framebuffer has in truth (1 if it is not multisampled).
   */
  virtual int GetSamples(vtkRenderer* renderer) = 0;

  /**
   * Draws a layer into the renderer's viewport of the current framebuffer, with a depth test of
   * "less or equal", writing colour and depth of the covered samples. False on an error (reported).
   */
  virtual bool Composite(vtkRenderer* renderer, const Layer& layer) = 0;

  /**
   * Likewise for Blend(), which draws into the window's own framebuffer.
   */
  virtual int GetSamplesForBlend(vtkRenderer* renderer) = 0;

  /**
   * Gives the window depths, Width x Height floats, of what is in the renderer's viewport so far,
   * whatever framebuffer is bound; of several samples a pixel one. False on an error (reported).
   */
  virtual bool ReadDepth(vtkRenderer* renderer, int width, int height, float* depth) = 0;

  /**
   * Blends a layer over the renderer's viewport of the window's own framebuffer, whatever
   * framebuffer is bound, without a depth test and without writing depth. Its colours are
   * multiplied by alpha: a pixel's covered samples get their mean. False on an error (reported).
   */
  virtual bool Blend(vtkRenderer* renderer, const Layer& layer) = 0;

  /**
   * What lines lay over those samples of a pixel that show nothing of their layer.
   */
  struct LinePixel
  {
    unsigned short X;
    unsigned short Y;
    unsigned char Color[4]; ///< RGBA, multiplied by alpha
    float Depth;            ///< window depth in [0, 1] of the nearest of the lines
    unsigned char Samples;  ///< bit s set: of sample s
  };
  struct LineLayer
  {
    int Width;
    int Height;
    int Samples;
    const LinePixel* Pixels;
    size_t Count;
    bool WritesDepth; ///< that of pixels of whose named samples lines cover half or more
  };

  /**
   * Blends lines over what is not nearer than they are, in the renderer's viewport of the window's
   * own framebuffer, whatever framebuffer is bound; in their order where a pixel comes several
   * times, as those of several layers may. Call it after Composite() or Blend() of the layers, and
   * when all is drawn that may lie behind them. False on an error (reported).
   */
  virtual bool BlendLines(vtkRenderer* renderer, const LineLayer& lines) = 0;

  /**
   * For actors in windows of other backends, when their renderer goes on from the opaque actors to
   * others: blends the lines of Limn's actors that have waited for these, if there are any.
   */
  static void BlendWaitingLines(vtkRenderer* renderer);

  /**
   * Draws an actor with the backend's own mapper, as if Limn were not there: same input, lookup
   * table, property, texture and matrix. For wireframe, point and line actors, for hardware
   * selection, and for all actors of a renderer with render passes.
   */
  virtual void RenderWithBackend(
    vtkRenderer* renderer, vtkActor* actor, vtkPolyDataMapper* mapper) = 0;

  /**
   * Draws an actor whose mapper is not Limn's (a backend's own, as the composite or the glyph
   * mapper), with what the backend's actor and property would set up around it: culling, depth
   * mask, textures of the property. This base calls the mapper and sets up nothing.
   */
  virtual void RenderMapperWithBackend(vtkRenderer* renderer, vtkActor* actor, vtkMapper* mapper);

  /**
   * A new actor of the backend's own kind that draws as vtkLimnActor does; the caller owns it.
   */
  virtual vtkActor* NewActor() = 0;

  /**
   * Frees what belongs to a window's graphics context.
   */
  virtual void ReleaseGraphicsResources(vtkWindow* window) = 0;

protected:
  vtkLimnCompositor();
  ~vtkLimnCompositor() override;

private:
  vtkLimnCompositor(const vtkLimnCompositor&) = delete;
  void operator=(const vtkLimnCompositor&) = delete;
};

#endif
