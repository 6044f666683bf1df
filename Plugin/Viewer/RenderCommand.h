// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef limn_viewer_RenderCommand_h
#define limn_viewer_RenderCommand_h

#include "RenderSettings.h" // for RenderSettings
#include "UserError.h"      // for ExitStatus

namespace limn::viewer
{

/// Draws the scene and writes the picture. Throws UserError; then no file was written.
ExitStatus render(const RenderSettings& settings);

} // namespace limn::viewer

#endif
