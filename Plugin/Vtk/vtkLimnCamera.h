// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLimnCamera
 * @brief   a camera for vtkLimnRenderer
 *
 * A vtkCamera that follows the window's stereo setting.
 *
 * @sa
 * vtkLimnRenderer
 */

#ifndef vtkLimnCamera_h
#define vtkLimnCamera_h

#include "vtkCamera.h"
#include "vtkLimnModule.h" // for export macro

class VTKLIMN_EXPORT vtkLimnCamera : public vtkCamera
{
public:
  static vtkLimnCamera* New();
  vtkTypeMacro(vtkLimnCamera, vtkCamera);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void Render(vtkRenderer* renderer) override;

protected:
  vtkLimnCamera() = default;
  ~vtkLimnCamera() override = default;

private:
  vtkLimnCamera(const vtkLimnCamera&) = delete;
  void operator=(const vtkLimnCamera&) = delete;
};

#endif
