// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkObjectFactory.h"
#include "vtkVersion.h"

// What VTK wants to find in a library of VTK_AUTOLOAD_PATH. It overrides nothing: the factory that
// does so comes with the library this one is linked to, which puts it before all others.
class vtkLimnAutoloadFactory : public vtkObjectFactory
{
public:
  static vtkLimnAutoloadFactory* New();
  vtkTypeMacro(vtkLimnAutoloadFactory, vtkObjectFactory);
  const char* GetVTKSourceVersion() override { return VTK_SOURCE_VERSION; }
  const char* GetDescription() override { return "Loads Limn"; }

  vtkLimnAutoloadFactory(const vtkLimnAutoloadFactory&) = delete;
  void operator=(const vtkLimnAutoloadFactory&) = delete;

protected:
  vtkLimnAutoloadFactory() = default;
};
vtkStandardNewMacro(vtkLimnAutoloadFactory);

VTK_FACTORY_INTERFACE_IMPLEMENT(vtkLimnAutoloadFactory)
