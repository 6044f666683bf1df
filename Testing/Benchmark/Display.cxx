// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Display.h"

#include <X11/Xlib.h>

bool IsDisplayOpen()
{
  Display* const display = XOpenDisplay(nullptr);
  if (!display)
  {
    return false;
  }
  XCloseDisplay(display);
  return true;
}
