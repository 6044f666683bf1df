// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef limn_viewer_CheckIllustration_h
#define limn_viewer_CheckIllustration_h

namespace limn::viewer
{

struct MaterialSettings;
struct SceneSettings;

/// Makes a ramp or a matcap the tone. Throws UserError where options exclude each other.
void takePictures(MaterialSettings& material);

/// Throws UserError where a style and what it decides on are both asked for.
void checkStyle(const SceneSettings& scene);

/// Throws UserError for an option that the style does not show. For a picture alone: in a window a
/// key chooses the style.
void checkShownByStyle(const SceneSettings& scene);

/// Throws UserError for an option that the picture would not show. For a picture alone: in a window
/// keys choose tone and outline.
void checkIllustration(const SceneSettings& scene);

} // namespace limn::viewer

#endif
