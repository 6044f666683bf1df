// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef limn_viewer_EffectOptions_h
#define limn_viewer_EffectOptions_h

#include "OptionList.h"     // for where they are added
#include "RenderSettings.h" // for what they set

namespace limn::viewer
{

/// Adds the options of what is done to the finished picture. `effects` must outlive `options`.
void addEffectOptions(OptionList& options, EffectSettings& effects);

/// Throws UserError for effects that the window or the camera of the settings do not have, and for
/// those that need another one.
void checkEffects(const RenderSettings& settings);

} // namespace limn::viewer

#endif
