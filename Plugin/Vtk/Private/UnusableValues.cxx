// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "UnusableValues.h"

#include "Rendering/Scene.h"

#include "vtkLimnProperty.h"

#include <cmath>
#include <limits>
#include <sstream>

namespace limn::bridge
{
namespace
{

/// What the core has room for.
constexpr double kMost = std::numeric_limits<float>::max();

struct Range
{
  double least = 0;
  double most = kMost;
  bool isAboveLeast = false;

  bool holds(double value) const
  {
    if (!(value >= -kMost && value <= kMost))
    {
      return false;
    }
    // As the core compares them.
    const auto rounded = static_cast<float>(value);
    return (isAboveLeast ? rounded > static_cast<float>(least)
                         : rounded >= static_cast<float>(least)) &&
           rounded <= static_cast<float>(most);
  }
};

constexpr Range kNotNegative;
constexpr Range kFinite = { -kMost };
constexpr Range kAtLeastOne = { 1 };
constexpr Range kPositive = { 0, kMost, true };
constexpr Range kShare = { 0, 1 };
constexpr Range kAngle = { 0, 180 };

std::ostream& operator<<(std::ostream& os, const Range& range)
{
  if (range.most < kMost && range.isAboveLeast)
  {
    return os << "above " << range.least << ", at most " << range.most;
  }
  if (range.most < kMost)
  {
    return os << "from " << range.least << " to " << range.most;
  }
  os << "a finite number";
  if (range.least > 0)
  {
    return os << ", at least " << range.least;
  }
  return os << (range.isAboveLeast ? " above 0" : range.least == 0 ? ", not negative" : "");
}

/// Keeps the first fault that it meets.
class Checker
{
public:
  explicit Checker(vtkProperty* property) : property_(property) {}

  bool isGood() const { return fault_.empty(); }
  const std::string& fault() const { return fault_; }

  void check(const char* name, double value, const Range& range)
  {
    if (!isGood() || range.holds(value))
    {
      return;
    }
    std::ostringstream need;
    need << range;
    if (std::isfinite(value) && std::fabs(value) > kMost && range.most == kMost)
    {
      need << ", and no more than " << kMost << " in size";
    }
    constexpr double kLeastAboveZero = std::numeric_limits<float>::denorm_min();
    if (range.isAboveLeast && range.least == 0 && value > 0 && value < kLeastAboveZero)
    {
      need << ", and no less than " << kLeastAboveZero;
    }
    this->refuse(name, value, need.str());
  }
  /// Of three values, as colours have.
  void check(const char* name, const double* values, const Range& range)
  {
    for (int i = 0; i < 3; ++i)
    {
      this->check(name, values[i], range);
    }
  }
  void refuse(const char* name, double value, const std::string& need)
  {
    std::ostringstream why;
    why << " has the value " << value << "; it has to be " << need << ".";
    this->refuse(name, why.str());
  }
  void refuse(const char* name, const std::string& why)
  {
    if (isGood())
    {
      fault_ = std::string(name) + " of its " + property_->GetClassName() + why;
    }
  }

private:
  vtkProperty* property_;
  std::string fault_;
};

void checkMaterial(vtkProperty* property, Checker& checker)
{
  checker.check("AmbientColor", property->GetAmbientColor(), kNotNegative);
  checker.check("DiffuseColor", property->GetDiffuseColor(), kNotNegative);
  checker.check("SpecularColor", property->GetSpecularColor(), kNotNegative);
  checker.check("Ambient", property->GetAmbient(), kNotNegative);
  checker.check("Diffuse", property->GetDiffuse(), kNotNegative);
  checker.check("Specular", property->GetSpecular(), kNotNegative);
  checker.check("SpecularPower", property->GetSpecularPower(), kNotNegative);
  checker.check("Opacity", property->GetOpacity(), kShare);
  checker.check("Roughness", property->GetRoughness(), kShare);
  checker.check("Metallic", property->GetMetallic(), kShare);
  checker.check("EdgeTint", property->GetEdgeTint(), kNotNegative);
  checker.check("BaseIOR", property->GetBaseIOR(), kAtLeastOne);
  checker.check("NormalScale", property->GetNormalScale(), kFinite);
}

void checkReflection(vtkLimnProperty* property, Checker& checker)
{
  checker.check("RimColor", property->GetRimColor(), kNotNegative);
  checker.check("RimPower", property->GetRimPower(), kNotNegative);
  checker.check("RefractiveIndex", property->GetRefractiveIndex(), kAtLeastOne);
  checker.check("FeatureAngle", property->GetFeatureAngle(), kAngle);
}

void checkRamp(vtkLimnProperty* property, Checker& checker)
{
  const bool isRamp = property->GetTone() == vtkLimnProperty::TONE_RAMP;
  const bool isMatCap = property->GetTone() == vtkLimnProperty::TONE_MAT_CAP;
  if ((isRamp && !property->GetToonRamp()) || (isMatCap && !property->GetMatCap()))
  {
    checker.refuse(isRamp ? "ToonRamp" : "MatCap",
      std::string(" is not set, and the tone ") + property->GetToneAsString() + " needs it.");
  }
  if (!isRamp)
  {
    return;
  }
  checker.check("ToonRampExponent", property->GetToonRampExponent(), kNotNegative);
  const double* const range = property->GetToonRampRange();
  checker.check("ToonRampRange", range[0], kNotNegative);
  checker.check("ToonRampRange", range[1], kNotNegative);
  const auto nearest = static_cast<float>(checker.isGood() ? range[0] : 0);
  const auto farthest = static_cast<float>(checker.isGood() ? range[1] : 0);
  if (!(nearest > 0 && farthest > nearest) && !(nearest == 0 && farthest == 0))
  {
    checker.refuse("ToonRampRange", range[0], "above 0 and below the range's other end");
  }
}

void checkTone(vtkLimnProperty* property, Checker& checker)
{
  checker.check("CoolColor", property->GetCoolColor(), kFinite);
  checker.check("WarmColor", property->GetWarmColor(), kFinite);
  checker.check("CoolSurface", property->GetCoolSurface(), kFinite);
  checker.check("WarmSurface", property->GetWarmSurface(), kFinite);
  checker.check("Undertone", property->GetUndertone(), kShare);
  checker.check("LegendSafeRange", property->GetLegendSafeRange(), { 0, 100 });
  checkRamp(property, checker);
  checker.check("HatchSpacing", property->GetHatchSpacing(), kPositive);
  checker.check("HatchDarkest", property->GetHatchDarkest(), kShare);
  checker.check("HatchWidth", property->GetHatchWidth(), { 0, kMaxLineWidth, true });
  checker.check("HatchPaper", property->GetHatchPaper(), kNotNegative);
  checker.check("HatchInk", property->GetHatchInk(), kNotNegative);
  checker.check(
    "ExaggerationContrast", property->GetExaggerationContrast(), { 0, kMaxExaggeration });
  checker.check("ExaggerationExponent", property->GetExaggerationExponent(),
    { -kMaxExaggerationExponent, kMaxExaggerationExponent });
  checker.check("ExaggerationBase", property->GetExaggerationBase(), kShare);
  checker.check("ExaggerationScale", property->GetExaggerationScale(), { 0, 1, true });
}

void checkOutline(vtkLimnProperty* property, Checker& checker)
{
  checker.check("OutlineColor", property->GetOutlineColor(), kNotNegative);
  // How wide it may be tells checkOutlineWidth().
  checker.check("OutlineWidth", property->GetOutlineWidth(), kNotNegative);
  checker.check("OutlineOpacity", property->GetOutlineOpacity(), kShare);
  checker.check("OutlineThreshold", property->GetOutlineThreshold(), kShare);
  checker.check("OutlineCreaseAngle", property->GetOutlineCreaseAngle(), kAngle);
  if (property->GetOutline() == vtkLimnProperty::OUTLINE_IMAGE)
  {
    checker.check("OutlineDepthTolerance", property->GetOutlineDepthTolerance(), kNotNegative);
  }
}

/// Of lines, whether any are drawn or not. How wide they are in pixels tells checkStroke().
void checkLines(vtkLimnProperty* property, Checker& checker)
{
  checker.check("CreaseAngle", property->GetCreaseAngle(), kAngle);
  checker.check("RidgeThreshold", property->GetRidgeThreshold(), kNotNegative);
  checker.check("SuggestiveThreshold", property->GetSuggestiveThreshold(), kNotNegative);
  checker.check("StrokeColor", property->GetStrokeColor(), kNotNegative);
  checker.check("StrokeOpacity", property->GetStrokeOpacity(), kShare);
  checker.check("StrokeWidth", property->GetStrokeWidth(), kPositive);
  checker.check("OuterWidthFactor", property->GetOuterWidthFactor(), { 0, kMaxLineWidth });
  checker.check("StrokeTaper", property->GetStrokeTaper(), kNotNegative);
  checker.check("StrokeDash", property->GetStrokeDash(), kNotNegative);
  checker.check("StrokeGap", property->GetStrokeGap(), kNotNegative);
  const auto dash = static_cast<float>(checker.isGood() ? property->GetStrokeDash() : 0);
  const auto gap = static_cast<float>(checker.isGood() ? property->GetStrokeGap() : 0);
  if (dash > 0 && gap > 0 && dash + gap < 0.5f)
  {
    checker.refuse("StrokeGap", property->GetStrokeGap(),
      "with StrokeDash together at least half a pixel, or 0");
  }
}

void checkCues(vtkLimnProperty* property, Checker& checker)
{
  if (property->GetEyeDomeLighting())
  {
    checker.check("EyeDomeStrength", property->GetEyeDomeStrength(), { 0, kMaxCueStrength });
    checker.check("EyeDomeRadius", property->GetEyeDomeRadius(), { 0, kMaxEyeDomeRadius, true });
  }
  if (property->GetDepthUnsharp() != vtkLimnProperty::DEPTH_UNSHARP_OFF)
  {
    checker.check("DepthUnsharpStrength", property->GetDepthUnsharpStrength(), kShare);
    checker.check(
      "DepthUnsharpRadius", property->GetDepthUnsharpRadius(), { 0, kMaxUnsharpRadius, true });
  }
  // How wide it is in pixels tells haloOf().
  checker.check("HaloWidth", property->GetHaloWidth(), kNotNegative);
  if (property->GetHaloWidth() > 0)
  {
    checker.check("HaloDepth", property->GetHaloDepth(), kPositive);
    checker.check("HaloColor", property->GetHaloColor(), kNotNegative);
  }
}

void checkTextures(vtkLimnProperty* property, Checker& checker)
{
  checker.check("BumpScale", property->GetBumpScale(), kFinite);
  checker.check("LightmapIntensity", property->GetLightmapIntensity(), kFinite);
  if (property->GetProceduralTexture() == vtkLimnProperty::PROCEDURAL_NONE)
  {
    return;
  }
  constexpr Range color = { -kLargestTexel, kLargestTexel };
  checker.check("ProceduralColorA", property->GetProceduralColorA(), color);
  checker.check("ProceduralColorB", property->GetProceduralColorB(), color);
  checker.check("ProceduralScale", property->GetProceduralScale(), { 0, kMostProcedural, true });
  checker.check(
    "ProceduralTurbulence", property->GetProceduralTurbulence(), { 0, kMostProcedural });
}

} // namespace

std::string unusableValueOf(vtkProperty* property)
{
  Checker checker(property);
  checkMaterial(property, checker);
  if (vtkLimnProperty* const limn = vtkLimnProperty::SafeDownCast(property))
  {
    checkReflection(limn, checker);
    checkTone(limn, checker);
    checkOutline(limn, checker);
    checkLines(limn, checker);
    checkCues(limn, checker);
    checkTextures(limn, checker);
  }
  return checker.fault();
}

} // namespace limn::bridge
