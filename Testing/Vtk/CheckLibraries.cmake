# SPDX-FileCopyrightText: Copyright (c) the Limn authors
# SPDX-License-Identifier: BSD-3-Clause
#
# cmake -DLIBRARY=FILE -P CheckLibraries.cmake: fails if the library needs OpenGL or X.
execute_process(COMMAND ldd ${LIBRARY} OUTPUT_VARIABLE needed RESULT_VARIABLE failed)
if(failed OR NOT needed MATCHES "libvtkRenderingCore")
  message(FATAL_ERROR "ldd did not list the libraries of ${LIBRARY}:\n${needed}")
endif()
string(REGEX MATCHALL "lib(GL|OpenGL|GLX|EGL|GLEW|X11|Xt|vtkRenderingOpenGL2|vtkRenderingUI)[-.0-9a-z]*so[.0-9]*"
  graphics "${needed}")
if(graphics)
  message(FATAL_ERROR "${LIBRARY} needs ${graphics}")
endif()
