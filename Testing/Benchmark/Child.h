// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Child_h
#define Child_h

#include <functional>
#include <vector>

/// What `work` returns in a process of its own: for peaks of memory, which a process has one of,
/// and for settings that the graphics library reads once. Throws if the process fails.
/// Requires: no threads and no OpenGL in this process yet, as the child is a copy of it.
std::vector<double> InChild(const std::function<std::vector<double>()>& work);

#endif
