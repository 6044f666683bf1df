// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLimnActor
 * @brief   an actor for Limn's mapper
 *
 * Used as any vtkActor, in a vtkLimnRenderWindow or in an OpenGL window beside ordinary actors. A
 * property that it has to make itself is a vtkLimnProperty.
 *
 * @sa
 * vtkLimnPolyDataMapper vtkLimnProperty
 */

#ifndef vtkLimnActor_h
#define vtkLimnActor_h

#include "vtkActor.h"
#include "vtkLimnModule.h" // for export macro

class VTKLIMN_EXPORT vtkLimnActor : public vtkActor
{
public:
  static vtkLimnActor* New();
  vtkTypeMacro(vtkLimnActor, vtkActor);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * As vtkActor's; in a vtkLimnRenderWindow without the calls by which textures and properties
   * prepare a graphics library.
   */
  int RenderOpaqueGeometry(vtkViewport* viewport) override;
  int RenderTranslucentPolygonalGeometry(vtkViewport* viewport) override;
  int RenderVolumetricGeometry(vtkViewport* viewport) override;
  void Render(vtkRenderer* renderer, vtkMapper* mapper) override;
  ///@}

  ///@{
  /**
   * As vtkActor's, but the alpha of a texture that is a decal lets nothing through.
   */
  vtkTypeBool HasOpaqueGeometry() override;
  vtkTypeBool HasTranslucentPolygonalGeometry() override;
  ///@}

  /**
   * As vtkActor's. Warns of sizes that cannot be drawn as they should be: below 1e-20, nearer than
   * which no vtkCamera comes, and above 1e18, where squares of distances overflow.
   */
  using Superclass::GetBounds;
  double* GetBounds() VTK_SIZEHINT(6) override;

  vtkProperty* MakeProperty() override;

  /**
   * Made for the window's backend if there is one, else a vtkLimnShaderProperty.
   */
  vtkShaderProperty* GetShaderProperty() override;

protected:
  vtkLimnActor() = default;
  ~vtkLimnActor() override = default;

private:
  enum SizeFaults
  {
    NO_FAULT = 0,
    TOO_SMALL,
    TOO_LARGE
  };
  int SizeFault = NO_FAULT; // that was last warned of

  vtkLimnActor(const vtkLimnActor&) = delete;
  void operator=(const vtkLimnActor&) = delete;
};

#endif
