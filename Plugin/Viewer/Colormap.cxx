// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Colormap.h"

#include <vtkColorTransferFunction.h>
#include <vtkNew.h>

#include <map>
#include <vector>

namespace limn::viewer
{
namespace
{

constexpr int kTableSize = 256;

enum class Space
{
  Rgb,
  Lab,
  Diverging
};

struct Stop
{
  double value, red, green, blue; ///< all from 0 to 1
};

struct Colormap
{
  Space space;
  std::vector<Stop> stops;
};

const Colormap& findColormap(const std::string& name)
{
  static const std::map<std::string, Colormap> colormaps = {
    { "grayscale", { Space::Rgb, { { 0, 0, 0, 0 }, { 1, 1, 1, 1 } } } },
    { "rainbow", { Space::Rgb, { { 0, 0, 0, 1 }, { 0.25, 0, 1, 1 }, { 0.5, 0, 1, 0 },
                                 { 0.75, 1, 1, 0 }, { 1, 1, 0, 0 } } } },
    { "black-body", { Space::Rgb, { { 0, 0, 0, 0 }, { 0.4, 0.9, 0, 0 }, { 0.8, 0.9, 0.9, 0 },
                                    { 1, 1, 1, 1 } } } },
    // Moreland's diverging map between these two colours (Diverging Color Maps for Scientific
    // Visualization, 2009).
    { "cool-warm",
      { Space::Diverging, { { 0, 0.230, 0.299, 0.754 }, { 1, 0.706, 0.016, 0.150 } } } },
    // Ten colours of the map of Smith and van der Walt (2015, CC0), joined in CIE Lab.
    { "viridis",
      { Space::Lab, { { 0. / 9, 0.267, 0.005, 0.329 }, { 1. / 9, 0.281, 0.156, 0.469 },
                      { 2. / 9, 0.244, 0.288, 0.537 }, { 3. / 9, 0.191, 0.407, 0.556 },
                      { 4. / 9, 0.148, 0.512, 0.557 }, { 5. / 9, 0.120, 0.621, 0.535 },
                      { 6. / 9, 0.208, 0.719, 0.473 }, { 7. / 9, 0.431, 0.808, 0.346 },
                      { 8. / 9, 0.710, 0.869, 0.169 }, { 9. / 9, 0.993, 0.906, 0.144 } } } },
  };
  return colormaps.at(name);
}

} // namespace

vtkSmartPointer<vtkLookupTable> makeColormap(
  const std::string& name, const std::array<double, 2>& range)
{
  const Colormap& colormap = findColormap(name);
  vtkNew<vtkColorTransferFunction> function;
  switch (colormap.space)
  {
    case Space::Rgb:
      function->SetColorSpaceToRGB();
      break;
    case Space::Lab:
      function->SetColorSpaceToLab();
      break;
    case Space::Diverging:
      function->SetColorSpaceToDiverging();
      break;
  }
  for (const Stop& stop : colormap.stops)
  {
    function->AddRGBPoint(stop.value, stop.red, stop.green, stop.blue);
  }
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(kTableSize);
  table->SetTableRange(range[0], range[1]);
  for (int i = 0; i < kTableSize; ++i)
  {
    double color[3];
    function->GetColor(static_cast<double>(i) / (kTableSize - 1), color);
    table->SetTableValue(i, color[0], color[1], color[2]);
  }
  constexpr double kGrey = 0.5;
  table->SetNanColor(kGrey, kGrey, kGrey, 1);
  return table;
}

} // namespace limn::viewer
