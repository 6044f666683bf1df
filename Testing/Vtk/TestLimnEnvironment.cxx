// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What LIMN_WINDOW and LIMN_DISABLE do, in a program without OpenGL. The first argument names what
// the environment was set to.
#include "Check.h"
#include "Messages.h"

#include "vtkLimnRenderWindow.h"

#include "vtkActor.h"
#include "vtkNew.h"

#include <string>

int TestLimnEnvironment(int argc, char* argv[])
{
  const std::string setting = argc > 1 ? argv[1] : "";
  Messages messages;
  vtkNew<vtkRenderWindow> window;
  vtkNew<vtkActor> actor;
  vtkNew<vtkLimnRenderWindow> named;
  CHECK(named);
  const std::string windowClass = window->GetClassName();
  const std::string actorClass = actor->GetClassName();
  if (setting == "unset")
  {
    CHECK_EQUAL(windowClass, "vtkLimnRenderWindow");
    CHECK_EQUAL(messages.GetText(), "");
  }
  else if (setting == "gl")
  {
    CHECK_EQUAL(windowClass, "vtkRenderWindow");
    CHECK_EQUAL(actorClass, "vtkLimnOpenGLActor");
  }
  else if (setting == "disabled")
  {
    CHECK_EQUAL(windowClass, "vtkRenderWindow");
    CHECK_EQUAL(actorClass, "vtkActor");
  }
  else if (setting == "wrong")
  {
    // The message came with the first object, before this test could listen.
    CHECK_EQUAL(windowClass, "vtkLimnRenderWindow");
    CHECK_EQUAL(messages.GetText(), "");
  }
  else
  {
    CHECK(!"a known setting as argument");
  }
  return result();
}
