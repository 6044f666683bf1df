// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef limn_viewer_Lengths_h
#define limn_viewer_Lengths_h

#include <string> // for options

namespace limn::viewer
{

struct Length;
struct SceneSettings;

/// Of a length in the picture.
double pixelsOf(const Length& length, const SceneSettings& scene);

/// As on the command line, "2mm".
std::string textOf(const Length& length);
/// Throws UserError if the length is more than so many pixels.
void requireAtMost(
  const std::string& option, const Length& length, double mostPixels, const SceneSettings& scene);
/// Throws UserError if the length is neither 0 nor so many pixels at least.
void requireAtLeast(
  const std::string& option, const Length& length, double leastPixels, const SceneSettings& scene);

} // namespace limn::viewer

#endif
