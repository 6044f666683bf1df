// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLimnOpenGL2ObjectFactory.h"
#include "vtkNew.h"
#include "vtkObjectFactoryCollection.h"

// Whoever loads the library gets the compositor, also where nobody called VTK's autoinit macros:
// a program that was built before Limn, or vtkLimnCompositor::New() loading it on demand.
static const bool Registered = []
{
  vtkNew<vtkLimnOpenGL2ObjectFactory> factory;
  vtkObjectFactory::RegisterFactory(factory);
  return true;
}();
