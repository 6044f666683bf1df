// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef limn_viewer_CheckLines_h
#define limn_viewer_CheckLines_h

namespace limn::viewer
{

struct SceneSettings;

/// Throws UserError for an option of lines that the picture would not show, and for lines that are
/// too wide.
void checkLines(const SceneSettings& scene);

/// Whether surfaces are drawn with strokes along their curvature.
bool hasHatchLines(const SceneSettings& scene);

} // namespace limn::viewer

#endif
