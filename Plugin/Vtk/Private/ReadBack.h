// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReadBack_h
#define ReadBack_h

#include "Rendering/Base/Span.h"
#include "Rendering/Base/Status.h"
#include "Rendering/Scene.h"

#include "vtkType.h"

#include <vector>

class vtkProperty;
class vtkScalarsToColors;

/// How well values can be read off toned surfaces by the colours of their legend.
namespace limn::bridge
{

/// The entries of a vtkLookupTable in their order, of other tables the colours of values evenly
/// over the range.
std::vector<Rgba8> colorsOf(vtkScalarsToColors* table, int count);

constexpr int kLegendColors = 128; ///< from which values are read

/// The error of vtkLimnToneLegend::GetReadBackError(), of a surface with the property's look but
/// the range given, where colours come from a legend of kLegendColors.
Status readBackError(
  Span<const Rgba8> legend, vtkProperty* property, double legendSafeRange, double& error);

/// What vtkLimnProperty's LegendSafeRange is bounded to with the table: the most, up to `asked`, to
/// which the tone adds 3.8 % to the error of reading values back. Keeps the last answers.
double legendSafeBound(vtkScalarsToColors* table, double asked);

/// The same for the table of one mapper, without a look at its colours while it stays as it is.
class LegendSafeBound
{
public:
  double operator()(vtkScalarsToColors* table, double asked);

private:
  const vtkScalarsToColors* table_ = nullptr;
  vtkMTimeType time_ = 0;
  double asked_ = 0;
  double bound_ = 0;
};

} // namespace limn::bridge

#endif
