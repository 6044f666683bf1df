// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLimnRenderWindowInteractor
 * @brief   an interactor without a display
 *
 * Lets programs that were written for a window on a screen run without one. Events may be sent to
 * it (InvokeEvent() and the recorder of events work); of themselves only those of timers come.
 * Start() renders, unless the program has, and serves timers until TerminateApp() is called or none
 * is left; without timers it returns at once.
 *
 * @sa
 * vtkLimnRenderWindow
 */

#ifndef vtkLimnRenderWindowInteractor_h
#define vtkLimnRenderWindowInteractor_h

#include "vtkLimnModule.h" // for export macro
#include "vtkRenderWindowInteractor.h"

#include <memory> // for std::unique_ptr

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
  vtkLimnRenderWindowInteractor();
  ~vtkLimnRenderWindowInteractor() override;

  void StartEventLoop() override;

  ///@{
  /**
   * `duration` is in milliseconds.
   */
  int InternalCreateTimer(int timerId, int timerType, unsigned long duration) override;
  int InternalDestroyTimer(int platformTimerId) override;
  ///@}

private:
  vtkLimnRenderWindowInteractor(const vtkLimnRenderWindowInteractor&) = delete;
  void operator=(const vtkLimnRenderWindowInteractor&) = delete;

  class vtkTimers;
  std::unique_ptr<vtkTimers> Timers;
};

#endif
