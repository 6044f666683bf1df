// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef limn_viewer_ViewCommand_h
#define limn_viewer_ViewCommand_h

#include "RenderSettings.h" // for SceneSettings
#include "UserError.h"      // for ExitStatus

namespace limn::viewer
{

/// Shows the scene in an OpenGL window until the user closes it. The window's title tells the
/// state; pressing h prints the keys. Throws UserError.
ExitStatus view(const SceneSettings& settings);

} // namespace limn::viewer

#endif
