// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef UnusableValues_h
#define UnusableValues_h

#include <string>

class vtkProperty;

namespace limn::bridge
{

/// The first of a property's values that no surface can be drawn with, with its name and what it
/// has to be, in words; empty if there is none. What is not asked for, as a tone's picture or a
/// depth cue's radius, may have any value.
std::string unusableValueOf(vtkProperty* property);

} // namespace limn::bridge

#endif
