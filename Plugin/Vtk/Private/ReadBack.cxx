// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ReadBack.h"

#include "ToneLegendPicture.h"

#include "Rendering/Reference/ReferenceDataTone.h"

#include "vtkLimnProperty.h"

#include "vtkLookupTable.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <deque>
#include <mutex>
#include <utility>

namespace limn::bridge
{
namespace
{

Rgba8 colorOf(vtkScalarsToColors* table, int number, int count)
{
  vtkLookupTable* const entries = vtkLookupTable::SafeDownCast(table);
  const unsigned char* color = nullptr;
  if (entries && entries->GetNumberOfTableValues() > 0)
  {
    const vtkIdType last = entries->GetNumberOfTableValues() - 1;
    color = entries->GetPointer(count > 1 ? (number * last + (count - 1) / 2) / (count - 1) : 0);
  }
  else
  {
    const double* const range = table->GetRange();
    const double share = count > 1 ? static_cast<double>(number) / (count - 1) : 0.0;
    color = table->MapValue(range[0] + share * (range[1] - range[0]));
  }
  return { color[0], color[1], color[2], 255 };
}

/// Our own, as what is found with it decides how surfaces look, which is the same on each machine.
Vec3d labOf(Rgba8 color)
{
  return vec3Cast<double>(
    reference::labOf({ color.r / 255.0f, color.g / 255.0f, color.b / 255.0f }));
}

/// Of the nearest, from 0 to 1.
double valueOf(const std::vector<Vec3d>& legend, const Vec3d& color)
{
  std::size_t nearest = 0;
  double least = HUGE_VAL;
  for (std::size_t i = 0; i < legend.size(); ++i)
  {
    const Vec3d apart = legend[i] - color;
    const double distance = dot(apart, apart);
    if (distance < least)
    {
      least = distance;
      nearest = i;
    }
  }
  return static_cast<double>(nearest) / static_cast<double>(legend.size() - 1);
}

bool areEqual(const std::vector<Rgba8>& a, const std::vector<Rgba8>& b)
{
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Rgba8)) == 0;
}

/// Infinite if it cannot be found.
double errorOfRange(Span<const Rgba8> legend, vtkLimnProperty* property, double range)
{
  double error = 0;
  return readBackError(legend, property, range, error).ok() ? error : HUGE_VAL;
}

double boundOf(Span<const Rgba8> legend, double asked)
{
  constexpr double kMostAdded = 0.038;
  constexpr int kHalvings = 6;
  vtkNew<vtkLimnProperty> property;
  property->SetToneToGooch();
  property->SetToneOverDataToLegendSafe();
  // Colours that a table has twice are misread without a tone, too.
  const double most = errorOfRange(legend, property, 0) + kMostAdded;
  if (errorOfRange(legend, property, asked) <= most)
  {
    return asked;
  }
  double bound = 0;
  double step = asked;
  for (int i = 0; i < kHalvings; ++i)
  {
    step /= 2;
    bound += errorOfRange(legend, property, bound + step) <= most ? step : 0;
  }
  return bound;
}

} // namespace

std::vector<Rgba8> colorsOf(vtkScalarsToColors* table, int count)
{
  table->Build();
  std::vector<Rgba8> colors;
  for (int i = 0; i < count; ++i)
  {
    colors.push_back(colorOf(table, i, count));
  }
  return colors;
}

Status readBackError(
  Span<const Rgba8> legend, vtkProperty* property, double legendSafeRange, double& error)
{
  constexpr int kTones = 64;
  std::vector<Rgba8> pixels;
  const Status status = drawToneLegend({ legend, kTones, property, legendSafeRange }, pixels);
  if (!status.ok())
  {
    return status;
  }
  std::vector<Vec3d> labs;
  for (const Rgba8& color : legend)
  {
    labs.push_back(labOf(color));
  }
  // Of a sphere that is lit from the eye, l.n of 0 ... c fills a share of c^2 of the picture.
  double sum = 0;
  double weights = 0;
  for (int row = kTones / 2; row < kTones; ++row)
  {
    const double cosine = (2.0 * row + 1) / kTones - 1;
    for (std::size_t column = 0; column < legend.size(); ++column)
    {
      const Rgba8& drawn = pixels[static_cast<std::size_t>(row) * legend.size() + column];
      const double value = static_cast<double>(column) / static_cast<double>(legend.size() - 1);
      sum += cosine * std::fabs(valueOf(labs, labOf(drawn)) - value);
      weights += cosine;
    }
  }
  error = sum / weights;
  return {};
}

double legendSafeBound(vtkScalarsToColors* table, double asked)
{
  struct Answer
  {
    std::vector<Rgba8> legend;
    double asked;
    double bound;
  };
  // A thousand actors may share a table, or have copies of one.
  constexpr std::size_t kMostAnswers = 16;
  static std::mutex mutex;
  static std::deque<Answer> answers;
  std::vector<Rgba8> legend = colorsOf(table, kLegendColors);
  const std::lock_guard<std::mutex> lock(mutex);
  for (const Answer& answer : answers)
  {
    if (asked == answer.asked && areEqual(legend, answer.legend))
    {
      return answer.bound;
    }
  }
  const double bound = boundOf(legend, asked);
  answers.push_front({ std::move(legend), asked, bound });
  answers.resize(std::min(answers.size(), kMostAnswers));
  return bound;
}

double LegendSafeBound::operator()(vtkScalarsToColors* table, double asked)
{
  const vtkMTimeType time = table->GetMTime();
  if (table != this->table_ || time != this->time_ || asked != this->asked_)
  {
    this->bound_ = legendSafeBound(table, asked);
    this->table_ = table;
    this->time_ = time;
    this->asked_ = asked;
  }
  return this->bound_;
}

} // namespace limn::bridge
