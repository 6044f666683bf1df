// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef limn_viewer_ApplyCues_h
#define limn_viewer_ApplyCues_h

#include "RenderSettings.h"

class vtkLimnProperty;

namespace limn::viewer
{

/// Gives the property the depth cues that are named; the others stay.
void applyCues(const CueSettings& cues, const Color& background, vtkLimnProperty& property);

} // namespace limn::viewer

#endif
