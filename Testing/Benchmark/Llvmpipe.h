// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Llvmpipe_h
#define Llvmpipe_h

#include <string>

/// Makes Mesa's llvmpipe draw for OpenGL, with the number of threads and the width of vectors that
/// are the fastest here; those that LP_NUM_THREADS and LP_NATIVE_VECTOR_WIDTH give are kept.
/// Requires: as InChild().
void ChooseFastestLlvmpipe();

/// Who draws for OpenGL, as it calls itself. Throws unless it is llvmpipe with the chosen vectors.
std::string OpenGLRenderer();

#endif
