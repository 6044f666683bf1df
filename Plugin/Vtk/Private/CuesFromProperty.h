// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef CuesFromProperty_h
#define CuesFromProperty_h

#include "Rendering/Base/Status.h"
#include "Rendering/DepthCues.h"

class vtkProperty;

namespace limn::bridge
{

/// The depth cues that the property asks for, in a window of so many pixels an inch. Errors: a halo
/// is too wide; it is left out.
Status cuesOf(vtkProperty* property, double pixelsPerInch, DepthCues& cues);

} // namespace limn::bridge

#endif
