// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLimnRenderWindow
 * @brief   a render window in memory, drawn on the CPU
 *
 * Needs neither OpenGL nor a display, and shows nothing on a screen: pictures are taken with
 * vtkWindowToImageFilter or GetPixelData(). The picture depends on the scene alone, not on the
 * machine, its number of cores or the frame before.
 *
 * Its renderers have to be vtkLimnRenderers, its interactor a vtkLimnRenderWindowInteractor; with
 * LIMN_WINDOW=cpu in the environment VTK's own names make these. Surfaces are drawn; props that are
 * not (text, volumes, images, ...) are named once in a warning.
 *
 * MultiSamples is 4 unless VTK_TESTING is set in the environment, then 0; values are used as 1, 2,
 * 4, 8 or 16 samples per pixel. Of these one colour, their mean, and one depth, the nearest, are
 * kept: what is not erased before the next frame is drawn over as if each sample had them.
 *
 * @sa
 * vtkLimnRenderer vtkLimnRenderWindowInteractor
 */

#ifndef vtkLimnRenderWindow_h
#define vtkLimnRenderWindow_h

#include "vtkLimnModule.h" // for export macro
#include "vtkRenderWindow.h"

#include <memory> // for std::unique_ptr

class vtkActor;
class vtkIdTypeArray;

class VTKLIMN_EXPORT vtkLimnRenderWindow : public vtkRenderWindow
{
public:
  static vtkLimnRenderWindow* New();
  vtkTypeMacro(vtkLimnRenderWindow, vtkRenderWindow);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  const char* GetRenderingBackend() override { return "Limn"; }
  const char* ReportCapabilities() override;
  int SupportsOpenGL() override { return 0; }
  vtkTypeBool IsDirect() override { return 0; }

  /**
   * Only a vtkLimnRenderer; any other is an error and not added.
   */
  void AddRenderer(vtkRenderer* renderer) override;

  ///@{
  /**
   * Not one that waits for the events of a window on a screen: that is an error, and the interactor
   * is left without a window.
   */
  void SetInteractor(vtkRenderWindowInteractor* interactor) override;
  vtkRenderWindowInteractor* MakeRenderWindowInteractor() override;
  ///@}

  ///@{
  /**
   * Makes the frame as large as the window. An error, and an empty picture, if a side is zero or
   * larger than 16384 pixels.
   */
  void Start() override;
  void Finalize() override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  ///@}

  ///@{
  /**
   * There is no context that could be another's.
   */
  bool IsCurrent() override { return true; }
  void MakeCurrent() override {}
  void WaitForCompletion() override {}
  vtkTypeBool GetEventPending() override { return 0; }
  int* GetScreenSize() VTK_SIZEHINT(2) override;
  void SetFullScreen(vtkTypeBool fullScreen) override;
  ///@}

  ///@{
  /**
   * 32 bits, 8 bits. Renderers place the near plane by the depth buffer's size.
   */
  int GetDepthBufferSize() override { return 32; }
  int GetColorBufferSizes(int* rgba) override;
  ///@}

  /**
   * Samples per pixel in use: 1, 2, 4, 8 or 16, from MultiSamples.
   */
  int GetSamplesPerPixel();

  ///@{
  /**
   * Pixels from corner to corner, both included, in any order; row 0 is the lowest. Pixels outside
   * of the window read as zero (depth as 1) and are not written. Front and back buffer are the
   * same. Returned arrays belong to the caller (delete[]); ReleaseRGBAPixelData() does the same.
   */
  unsigned char* GetPixelData(int x, int y, int x2, int y2, int front, int right = 0) override;
  int GetPixelData(
    int x, int y, int x2, int y2, int front, vtkUnsignedCharArray* data, int right = 0) override;
  int SetPixelData(
    int x, int y, int x2, int y2, unsigned char* data, int front, int right = 0) override;
  int SetPixelData(
    int x, int y, int x2, int y2, vtkUnsignedCharArray* data, int front, int right = 0) override;

  float* GetRGBAPixelData(int x, int y, int x2, int y2, int front, int right = 0) override;
  int GetRGBAPixelData(
    int x, int y, int x2, int y2, int front, vtkFloatArray* data, int right = 0) override;
  int SetRGBAPixelData(
    int x, int y, int x2, int y2, float* data, int front, int blend = 0, int right = 0) override;
  int SetRGBAPixelData(int x, int y, int x2, int y2, vtkFloatArray* data, int front, int blend = 0,
    int right = 0) override;
  void ReleaseRGBAPixelData(float* data) override;

  unsigned char* GetRGBACharPixelData(
    int x, int y, int x2, int y2, int front, int right = 0) override;
  int GetRGBACharPixelData(
    int x, int y, int x2, int y2, int front, vtkUnsignedCharArray* data, int right = 0) override;
  int SetRGBACharPixelData(int x, int y, int x2, int y2, unsigned char* data, int front,
    int blend = 0, int right = 0) override;
  int SetRGBACharPixelData(int x, int y, int x2, int y2, vtkUnsignedCharArray* data, int front,
    int blend = 0, int right = 0) override;

  float* GetZbufferData(int x, int y, int x2, int y2) override;
  int GetZbufferData(int x, int y, int x2, int y2, float* z) override;
  int GetZbufferData(int x, int y, int x2, int y2, vtkFloatArray* z) override;
  int SetZbufferData(int x, int y, int x2, int y2, float* z) override;
  int SetZbufferData(int x, int y, int x2, int y2, vtkFloatArray* z) override;
  ///@}

  ///@{
  /**
   * Whether the next frames keep, besides colour and depth, what GetNormalData() and GetIdData()
   * read. Default: off.
   */
  void SetMaps(bool maps);
  bool GetMaps();
  vtkBooleanMacro(Maps, bool);
  ///@}

  ///@{
  /**
   * Of the surfaces seen in these pixels, as GetZbufferData() takes them, three components a pixel:
   * the unit normal that is lit, without bumps, in view coordinates (right, up, towards the eye),
   * facing the eye as the surface's side does; (0, 0, 0) where there is none. Translucent surfaces
   * leave what lies behind them. VTK_ERROR without Maps.
   */
  int GetNormalData(int x, int y, int x2, int y2, vtkFloatArray* data);
  ///@}

  ///@{
  /**
   * Likewise two components a pixel: the number of the actor, which GetMappedActor() takes, and the
   * cell of its mapper's input; -1 where there is none. Actors are numbered from 0 in the order in
   * which they were drawn since the window was cleared.
   */
  int GetIdData(int x, int y, int x2, int y2, vtkIdTypeArray* data);
  vtkActor* GetMappedActor(vtkIdType number);
  ///@}

  /**
   * The pixels themselves. For Limn's own use.
   */
  class vtkFrame;
  VTK_WRAPEXCLUDE vtkFrame& GetFrame() { return *this->Pixels; }

protected:
  vtkLimnRenderWindow();
  ~vtkLimnRenderWindow() override;

private:
  vtkLimnRenderWindow(const vtkLimnRenderWindow&) = delete;
  void operator=(const vtkLimnRenderWindow&) = delete;

  std::unique_ptr<vtkFrame> Pixels;
};

#endif
