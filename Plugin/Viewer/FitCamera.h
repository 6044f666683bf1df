// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef limn_viewer_FitCamera_h
#define limn_viewer_FitCamera_h

#include "RenderSettings.h" // for CameraSettings

#include <vtkBoundingBox.h> // for Subject

#include <vector> // for Subject

class vtkCamera;
class vtkPoints;

namespace limn::viewer
{

/// What the picture must show.
struct Subject
{
  vtkBoundingBox box;
  std::vector<vtkPoints*> points; ///< those outside of `box` belong to no face and do not count
};

/// Points the camera as the settings say. What they leave open is chosen so that all points of the
/// subject are seen, from the front, a little from above and from the right. `aspect` is the
/// picture's width over its height. The clipping range is left to the renderer.
void fitCamera(
  const CameraSettings& settings, const Subject& subject, double aspect, vtkCamera& camera);

} // namespace limn::viewer

#endif
