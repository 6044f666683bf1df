# SPDX-FileCopyrightText: Copyright (c) the Limn authors
# SPDX-License-Identifier: BSD-3-Clause
"""Limn, a rasterizer on the CPU, in place of VTK's OpenGL pipeline for surfaces.

After "import limn", before or after vtkmodules, vtkPolyDataMapper(), vtkActor() and vtkProperty()
make Limn's classes. With LIMN_WINDOW=cpu in the environment the render window is Limn's too, and
needs neither OpenGL nor a display.
"""

import os

from .vtkLimn import *

if os.environ.get("LIMN_WINDOW") != "cpu":
    try:
        from .vtkLimnOpenGL2 import *
    except ImportError:
        # Without OpenGL's libraries only windows of Limn's own can be had.
        pass
