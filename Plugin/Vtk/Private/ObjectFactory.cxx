// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ObjectFactory.h"

#include "BackendMapper.h"

#include "vtkLimnActor.h"
#include "vtkLimnCamera.h"
#include "vtkLimnCompositor.h"
#include "vtkLimnHardwareSelector.h"
#include "vtkLimnPolyDataMapper.h"
#include "vtkLimnProperty.h"
#include "vtkLimnRenderWindow.h"
#include "vtkLimnRenderWindowInteractor.h"
#include "vtkLimnRenderer.h"
#include "vtkLimnShaderProperty.h"
#include "vtkLimnUniforms.h"

#include "vtkObjectFactoryCollection.h"
#include "vtkVersion.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <string>

namespace
{
VTK_CREATE_CREATE_FUNCTION(vtkLimnActor)
VTK_CREATE_CREATE_FUNCTION(vtkLimnCamera)
VTK_CREATE_CREATE_FUNCTION(vtkLimnHardwareSelector)
VTK_CREATE_CREATE_FUNCTION(vtkLimnPolyDataMapper)
VTK_CREATE_CREATE_FUNCTION(vtkLimnProperty)
VTK_CREATE_CREATE_FUNCTION(vtkLimnRenderWindow)
VTK_CREATE_CREATE_FUNCTION(vtkLimnRenderWindowInteractor)
VTK_CREATE_CREATE_FUNCTION(vtkLimnRenderer)
VTK_CREATE_CREATE_FUNCTION(vtkLimnShaderProperty)
VTK_CREATE_CREATE_FUNCTION(vtkLimnUniforms)

struct Override
{
  const char* Base;
  const char* Ours;
  vtkObjectFactory::CreateFunction Create;
  bool InOpenGLWindows; ///< ours works there too
};

const Override Overrides[] = {
  { "vtkActor", "vtkLimnActor", vtkObjectFactoryCreatevtkLimnActor, true },
  { "vtkPolyDataMapper", "vtkLimnPolyDataMapper", vtkObjectFactoryCreatevtkLimnPolyDataMapper,
    true },
  { "vtkProperty", "vtkLimnProperty", vtkObjectFactoryCreatevtkLimnProperty, true },
  { "vtkCamera", "vtkLimnCamera", vtkObjectFactoryCreatevtkLimnCamera, false },
  { "vtkHardwareSelector", "vtkLimnHardwareSelector", vtkObjectFactoryCreatevtkLimnHardwareSelector,
    false },
  { "vtkRenderWindow", "vtkLimnRenderWindow", vtkObjectFactoryCreatevtkLimnRenderWindow, false },
  { "vtkRenderWindowInteractor", "vtkLimnRenderWindowInteractor",
    vtkObjectFactoryCreatevtkLimnRenderWindowInteractor, false },
  { "vtkRenderer", "vtkLimnRenderer", vtkObjectFactoryCreatevtkLimnRenderer, false },
  { "vtkShaderProperty", "vtkLimnShaderProperty", vtkObjectFactoryCreatevtkLimnShaderProperty,
    false },
  { "vtkUniforms", "vtkLimnUniforms", vtkObjectFactoryCreatevtkLimnUniforms, false },
};

enum class Window
{
  Unset,
  OpenGL,
  Cpu,
};

Window ReadWindow()
{
  const char* value = std::getenv("LIMN_WINDOW");
  const std::string name = value ? value : "";
  if (!name.empty() && name != "gl" && name != "cpu")
  {
    vtkGenericWarningMacro(
      "LIMN_WINDOW is "
      << name
      << "; it has to be gl (Limn draws into OpenGL windows) or cpu (into windows of its own). "
      << "It is taken as not set.");
  }
  return name == "gl" ? Window::OpenGL : name == "cpu" ? Window::Cpu : Window::Unset;
}

// Not a static object's initialiser: a message makes objects, and comes back to this factory.
Window WindowFromEnvironment()
{
  static bool isRead = false;
  static Window window = Window::Unset;
  if (!isRead)
  {
    isRead = true;
    window = ReadWindow();
  }
  return window;
}

bool IsDisabled()
{
  const char* value = std::getenv("LIMN_DISABLE");
  return value && std::strcmp(value, "") != 0 && std::strcmp(value, "0") != 0;
}

template <class Visit>
void ForEachOtherFactory(vtkObjectFactory* self, Visit visit)
{
  vtkObjectFactoryCollection* factories = vtkObjectFactory::GetRegisteredFactories();
  vtkCollectionSimpleIterator iterator;
  factories->InitTraversal(iterator);
  while (vtkObjectFactory* factory = factories->GetNextObjectFactory(iterator))
  {
    if (!factory->IsA(self->GetClassName()))
    {
      visit(factory);
    }
  }
}

bool AnotherMakesWindows(vtkObjectFactory* self)
{
  bool makes = false;
  ForEachOtherFactory(self, [&makes](vtkObjectFactory* factory)
    { makes = makes || factory->HasOverride("vtkRenderWindow") != 0; });
  return makes;
}

// Factories of the modules that draw with OpenGL or open windows on a screen. Not the one of
// volumes: their mappers cannot be made without it, and our window leaves volumes out before any is
// drawn.
bool NeedsDisplay(vtkObjectFactory* factory)
{
  const std::string name = factory->GetClassName();
  if (name.find("Volume") != std::string::npos)
  {
    return false;
  }
  return name == "vtkRenderingUIObjectFactory" ||
         (name.find("OpenGL2") != std::string::npos && name.rfind("vtkLimn", 0) != 0);
}

// They draw nothing. Volume mappers cannot be made without the list of GPUs, and the exporter of
// vector graphics, which then holds our picture, not without its helper.
bool NeedsNoContext(const char* className)
{
  return std::strcmp(className, "vtkGPUInfoList") == 0 ||
         std::strcmp(className, "vtkOpenGLGL2PSHelper") == 0;
}

// One window of ours with one prop of OpenGL's would end the program.
void SwitchOff(vtkObjectFactory* factory, const char* className)
{
  if (factory->HasOverride(className) && !NeedsNoContext(className))
  {
    factory->Disable(className);
  }
}
}

vtkStandardNewMacro(vtkLimnObjectFactory);

//------------------------------------------------------------------------------
vtkLimnObjectFactory::vtkLimnObjectFactory()
{
  for (const Override& override : Overrides)
  {
    this->RegisterOverride(override.Base, override.Ours, "Limn", 1, override.Create);
  }
}

//------------------------------------------------------------------------------
const char* vtkLimnObjectFactory::GetVTKSourceVersion()
{
  return VTK_SOURCE_VERSION;
}

//------------------------------------------------------------------------------
const char* vtkLimnObjectFactory::GetDescription()
{
  return "Limn, rendering on the CPU";
}

//------------------------------------------------------------------------------
vtkObject* vtkLimnObjectFactory::CreateObject(const char* className)
{
  static const bool isDisabled = IsDisabled();
  if (isDisabled)
  {
    return nullptr;
  }
  const Window asked = WindowFromEnvironment();
  const bool isCpu = asked == Window::Cpu || (asked == Window::Unset && !AnotherMakesWindows(this));
  if (isCpu)
  {
    ForEachOtherFactory(this,
      [className](vtkObjectFactory* factory)
      {
        if (NeedsDisplay(factory))
        {
          SwitchOff(factory, className);
        }
      });
  }
  const auto found = std::find_if(std::begin(Overrides), std::end(Overrides),
    [className](const Override& one) { return std::strcmp(one.Base, className) == 0; });
  const bool isOurs = found != std::end(Overrides) && (isCpu || found->InOpenGLWindows);
  if (isOurs && !isCpu && std::strcmp(className, "vtkActor") == 0 && limn::bridge::compositor())
  {
    return limn::bridge::compositor()->NewActor();
  }
  return isOurs ? this->Superclass::CreateObject(className) : nullptr;
}

//------------------------------------------------------------------------------
void vtkLimnObjectFactory::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

namespace
{
// Factories are asked in the order of their list, to which each new one is appended. OpenGL's may
// be in it already, so ours goes to the front.
void RegisterFirst()
{
  vtkObjectFactoryCollection* factories = vtkObjectFactory::GetRegisteredFactories();
  vtkCollectionSimpleIterator iterator;
  factories->InitTraversal(iterator);
  while (vtkObjectFactory* factory = factories->GetNextObjectFactory(iterator))
  {
    if (vtkLimnObjectFactory::SafeDownCast(factory))
    {
      return;
    }
  }
  vtkLimnObjectFactory* factory = vtkLimnObjectFactory::New();
  if (factories->GetNumberOfItems() == 0)
  {
    vtkObjectFactory::RegisterFactory(factory);
  }
  else
  {
    factories->vtkCollection::InsertItem(-1, factory);
  }
  factory->Delete();
}

// When the library is loaded, by whatever way.
const bool isRegistered = (RegisterFirst(), true);
}

// VTK's autoinit calls it in programs that name this module in vtk_module_autoinit().
VTKLIMN_EXPORT void vtkLimn_AutoInit_Construct();
void vtkLimn_AutoInit_Construct()
{
  if (isRegistered)
  {
    RegisterFirst();
  }
}
