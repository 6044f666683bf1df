// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLimnHardwareSelector
 * @brief   tells which actors and cells are seen in a vtkLimnRenderWindow
 *
 * Draws who and which cell is nearest at each pixel, once and into memory of its own: the window's
 * picture stays as it is. Its depth becomes that of what can be picked, as in VTK's windows, until
 * it is rendered again: vtkPropPicker reads there where the prop was hit. Cells are those of
 * surfaces. Points cannot be selected yet; asking for them is an error, and nothing is selected.
 *
 * @sa
 * vtkLimnRenderWindow
 */

#ifndef vtkLimnHardwareSelector_h
#define vtkLimnHardwareSelector_h

#include "vtkHardwareSelector.h"
#include "vtkLimnModule.h" // for export macro

#include <memory> // for std::unique_ptr
#include <vector> // for std::vector

class vtkActor;
class vtkLimnPolyDataMapper;

class VTKLIMN_EXPORT vtkLimnHardwareSelector : public vtkHardwareSelector
{
public:
  static vtkLimnHardwareSelector* New();
  vtkTypeMacro(vtkLimnHardwareSelector, vtkHardwareSelector);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  bool CaptureBuffers() override;
  void SavePixelBuffer(int pass) override;

  /**
   * Called by Limn's mapper while a selection is made: a surface of the prop that is at hand.
   */
  VTK_WRAPEXCLUDE void AddSurface(vtkActor* actor, vtkLimnPolyDataMapper* mapper);

protected:
  vtkLimnHardwareSelector();
  ~vtkLimnHardwareSelector() override;

  void BeginRenderProp(vtkRenderWindow*) override {}
  void EndRenderProp(vtkRenderWindow*) override {}

private:
  vtkLimnHardwareSelector(const vtkLimnHardwareSelector&) = delete;
  void operator=(const vtkLimnHardwareSelector&) = delete;

  int RenderPickableProps();
  void DrawIds();
  void LeaveDepth();
  void SaveIds(int pass, const std::vector<vtkIdType>& ids);

  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
