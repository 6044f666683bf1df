// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef limn_viewer_CompareCommand_h
#define limn_viewer_CompareCommand_h

#include "RenderSettings.h" // for CompareSettings
#include "UserError.h"      // for ExitStatus

namespace limn::viewer
{

/// Prints how many pixels differ, and by how much. ExitPicturesDiffer if any channel of any pixel
/// differs by more than the tolerance. A picture without colour or alpha channels counts as grey,
/// and as opaque. Throws UserError for pictures that cannot be read or have different sizes.
ExitStatus compare(const CompareSettings& settings);

} // namespace limn::viewer

#endif
