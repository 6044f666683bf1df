// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef limn_viewer_CueOptions_h
#define limn_viewer_CueOptions_h

#include "OptionList.h"
#include "RenderSettings.h"

namespace limn::viewer
{

/// Adds the options of depth cues.
void addCueOptions(OptionList& options, CueSettings& cues);

/// Throws a UserError for options that say how a cue is drawn that is not. A style may have it.
void checkCues(const SceneSettings& scene);

} // namespace limn::viewer

#endif
