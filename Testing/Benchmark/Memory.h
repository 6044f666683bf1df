// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Memory_h
#define Memory_h

#include "Candidate.h"
#include "Scenes.h"

/// Bytes in use beyond the scene's own arrays and the libraries with their start-up. Pictures
/// count: the window's own and the copy that is read from it.
struct MemoryUse
{
  double Peak; ///< most of them at any time until some frames are drawn
  double Kept; ///< after that
};

/// In a process of its own. Requires: as InChild().
MemoryUse MeasureMemory(const Way& way, const SceneMaker& maker);

#endif
