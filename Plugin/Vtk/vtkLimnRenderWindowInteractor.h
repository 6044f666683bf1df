// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLimnRenderWindowInteractor
 * @brief   an interactor without a display
 *
 * Lets programs that were written for a window on a screen run without one. Events may be sent to
 * it (InvokeEvent() and the recorder of events work); none come by themselves. Start() therefore
 * renders, unless the program has, and returns.
 *
 * @sa
 * vtkLimnRenderWindow
 */

#ifndef vtkLimnRenderWindowInteractor_h
#define vtkLimnRenderWindowInteractor_h

#include "vtkLimnModule.h" // for export macro
#include "vtkRenderWindowInteractor.h"

class VTKLIMN_EXPORT vtkLimnRenderWindowInteractor : public vtkRenderWindowInteractor
{
public:
  static vtkLimnRenderWindowInteractor* New();
  vtkTypeMacro(vtkLimnRenderWindowInteractor, vtkRenderWindowInteractor);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Renders nothing, as VTK's interactors on a screen: the first camera is the program's to set.
   */
  void Initialize() override;
  void TerminateApp() override { this->Done = true; }

protected:
  vtkLimnRenderWindowInteractor() = default;
  ~vtkLimnRenderWindowInteractor() override = default;

  /**
   * Returns at once: there is nothing to wait for.
   */
  void StartEventLoop() override;

private:
  vtkLimnRenderWindowInteractor(const vtkLimnRenderWindowInteractor&) = delete;
  void operator=(const vtkLimnRenderWindowInteractor&) = delete;
};

#endif
