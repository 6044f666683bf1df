// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLimnRenderer
 * @brief   a renderer for Limn's own window
 *
 * Draws the background and the surfaces of its actors into its viewport of a vtkLimnRenderWindow.
 * FXAA works as in VTK, with vtkFXAAOptions; a vtkLimnPostEffects adds other post effects.
 * Props of kinds that are not drawn (text, images, volumes, ...) are named once in a warning.
 *
 * @sa
 * vtkLimnRenderWindow vtkLimnActor
 */

#ifndef vtkLimnRenderer_h
#define vtkLimnRenderer_h

#include "vtkLimnModule.h" // for export macro
#include "vtkRenderer.h"
#include "vtkSmartPointer.h" // for the post effects

#include <set>    // for std::set
#include <string> // for std::string

class vtkLimnPostEffects;
class vtkLimnRenderWindow;

class VTKLIMN_EXPORT vtkLimnRenderer : public vtkRenderer
{
public:
  static vtkLimnRenderer* New();
  vtkTypeMacro(vtkLimnRenderer, vtkRenderer);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void DeviceRender() override;
  void Clear() override;
  vtkCamera* MakeCamera() override;

  ///@{
  /**
   * What is done to the viewport when its surfaces are drawn. Default: nullptr, nothing.
   */
  void SetPostEffects(vtkLimnPostEffects* effects);
  vtkLimnPostEffects* GetPostEffects();
  ///@}

  /**
   * That of the post effects and the options of FXAA, too.
   */
  vtkMTimeType GetMTime() override;

  /**
   * The props given to PickPropFrom() while that runs, else all.
   */
  vtkPropCollection* GetPropsToPickFrom();

  /**
   * A warning that this renderer says only the first time.
   */
  void WarnOnce(const std::string& what);

protected:
  vtkLimnRenderer();
  ~vtkLimnRenderer() override;

  int UpdateCamera() override;
  int UpdateLights() override;
  int UpdateGeometry(vtkFrameBufferObjectBase* frameBuffer = nullptr) override;

private:
  vtkLimnRenderer(const vtkLimnRenderer&) = delete;
  void operator=(const vtkLimnRenderer&) = delete;

  void DropPropsThatAreNotDrawn();
  void WarnOfUnusedSettings();

  std::set<std::string> Warnings;
  vtkSmartPointer<vtkLimnPostEffects> PostEffects;
};

#endif
