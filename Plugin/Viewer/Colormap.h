// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef limn_viewer_Colormap_h
#define limn_viewer_Colormap_h

#include <vtkLookupTable.h>  // for the result
#include <vtkSmartPointer.h> // for the result

#include <array>  // for the range
#include <string> // for the name

namespace limn::viewer
{

/// A table of 256 colours over `range`. `name`: viridis, cool-warm, rainbow, grayscale or
/// black-body. Values that are NaN are grey.
vtkSmartPointer<vtkLookupTable> makeColormap(
  const std::string& name, const std::array<double, 2>& range);

} // namespace limn::viewer

#endif
