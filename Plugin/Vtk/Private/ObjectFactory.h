// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ObjectFactory_h
#define ObjectFactory_h

#include "vtkLimnModule.h"
#include "vtkObjectFactory.h"

/// Makes Limn's classes where a program asks for VTK's, as the environment wants it:
///   LIMN_DISABLE=1     none
///   LIMN_WINDOW=gl     vtkActor, vtkPolyDataMapper, vtkProperty: Limn draws into OpenGL windows
///   LIMN_WINDOW=cpu    windows and renderers too, and no class of OpenGL's modules any more
/// Without LIMN_WINDOW it is gl if another factory makes windows, else cpu.
class vtkLimnObjectFactory : public vtkObjectFactory
{
public:
  static vtkLimnObjectFactory* New();
  vtkTypeMacro(vtkLimnObjectFactory, vtkObjectFactory);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  const char* GetVTKSourceVersion() override;
  const char* GetDescription() override;

  vtkLimnObjectFactory(const vtkLimnObjectFactory&) = delete;
  void operator=(const vtkLimnObjectFactory&) = delete;

protected:
  vtkLimnObjectFactory();
  ~vtkLimnObjectFactory() override = default;

  vtkObject* CreateObject(const char* className) override;
};

#endif
