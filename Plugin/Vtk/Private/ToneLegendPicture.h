// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ToneLegendPicture_h
#define ToneLegendPicture_h

#include "Rendering/Base/Span.h"
#include "Rendering/Base/Status.h"
#include "Rendering/Scene.h"

#include <vector>

class vtkProperty;

namespace limn::bridge
{

/// How a surface of each of `colors` looks under a headlight: a column each, l.n from -1 in the
/// lowest of `rows` to 1 in the highest, in the middle of a row what it is there.
struct ToneLegendRequest
{
  Span<const Rgba8> colors;
  int rows;
  vtkProperty* property;  ///< as it is, but for outlines, highlights, shaders and opacity
  double legendSafeRange; ///< in place of the property's
};

/// Draws it, colors.size() x rows pixels with row 0 at the bottom, by the renderer itself.
Status drawToneLegend(const ToneLegendRequest& request, std::vector<Rgba8>& pixels);

} // namespace limn::bridge

#endif
