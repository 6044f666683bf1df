// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef limn_viewer_SceneOptions_h
#define limn_viewer_SceneOptions_h

#include "OptionList.h"     // for where they are added
#include "RenderSettings.h" // for what they set

namespace limn::viewer
{

/// Adds the options that describe a scene, shared by `render` and `view`. `scene` must outlive
/// `options`. They do not touch SceneSettings::background, which the verbs treat differently.
void addSceneOptions(OptionList& options, SceneSettings& scene);

} // namespace limn::viewer

#endif
