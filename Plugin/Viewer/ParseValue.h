// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef limn_viewer_ParseValue_h
#define limn_viewer_ParseValue_h

#include "RenderSettings.h" // for Vector3, Color, LightSettings

#include <array>   // for Range
#include <string>  // for the texts
#include <utility> // for std::pair
#include <vector>  // for choices

/// One value of one option from its text. `option` is named in the errors ("--color"). All throw
/// UserError, which says what was expected and shows an example.
namespace limn::viewer
{

/// A finite number, written as in "12", "-0.5" or "1e-3", with nothing after it. All numbers here
/// are at most 1e30 in size.
double parseNumber(const std::string& option, const std::string& text);

/// Likewise of any size, for options that have a range of their own to name: "from 0 to 1".
double parseNumberOfAnySize(
  const std::string& option, const std::string& text, const std::string& range);

/// Throws if a number, which may be 0, is so near to it that the renderer would take it for that.
void refuseTiny(const std::string& option, const std::string& text, double number);

/// `number`; throws if it is not from 1e-30 on.
double requirePositive(const std::string& option, const std::string& text, double number);

/// A number above 0, from 1e-30 on.
double parsePositive(const std::string& option, const std::string& text);

/// Finite numbers with commas between them, as many as allowed.
std::vector<double> parseNumbers(
  const std::string& option, const std::string& text, std::size_t fewest, std::size_t most);

/// A whole number from `smallest` to `largest`.
int parseInteger(const std::string& option, const std::string& text, int smallest, int largest);

/// x,y,z
Vector3 parseVector(const std::string& option, const std::string& text);

/// x,y,z that is not 0,0,0.
Vector3 parseDirection(const std::string& option, const std::string& text);

/// r,g,b that stands in the picture as it is, as a background's: each from 0 to 1.
Color parseColor(const std::string& option, const std::string& text);

/// r,g,b of a light, a surface or a tone, from which the picture is computed: each at least 0.
Color parseIntensity(const std::string& option, const std::string& text);

/// A number in pixels, or in what follows it: px, pt, mm. Pixels may be of any size, for options
/// that have a range of their own to name: "from 0 to 64 pixels".
Length parseLength(const std::string& option, const std::string& text, const std::string& range);

/// A length above 0, pixels up to `mostPixels`.
Length parseWidth(const std::string& option, const std::string& text, double mostPixels);

/// Two lengths above 0 with a comma between them.
std::array<Length, 2> parseDash(const std::string& option, const std::string& text);

/// a,b with a < b.
std::array<double, 2> parseRange(const std::string& option, const std::string& text);

/// width,height: each from 1 to 16384.
std::array<int, 2> parseResolution(const std::string& option, const std::string& text);

/// One of +X -X +Y -Y +Z -Z, in either case.
Vector3 parseAxis(const std::string& option, const std::string& text);

/// headlight | directional:dx,dy,dz:r,g,b | point:x,y,z:r,g,b[:a,b,c] |
/// spot:x,y,z:dx,dy,dz:cone:exponent:r,g,b[:soft] |
/// rectangle:x,y,z:ax,ay,az:bx,by,bz:r,g,b[:samples] | sphere:x,y,z:radius:r,g,b[:samples], with
/// power=r,g,b for r,g,b of those with a position.
LightSettings parseLight(const std::string& option, const std::string& text);

/// As names are written here.
std::string inSmallLetters(std::string text);

/// "flat, gouraud, phong"
std::string joinWords(const std::vector<std::string>& words);

template <typename Value>
using Choices = std::vector<std::pair<std::string, Value>>;

/// The value whose name is `text`. A name in `later` is one that a later version will serve.
template <typename Value>
Value parseChoice(const std::string& option, const std::string& text, const Choices<Value>& choices,
  const std::vector<std::string>& later = {});

} // namespace limn::viewer

#include "ParseValue.txx" // for parseChoice

#endif
