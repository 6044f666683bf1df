// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ParseValue.h"

#include "UserError.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

namespace limn::viewer
{
namespace
{

constexpr int kLargestSide = 16384;

/// Of a number's size. Far beyond any use, and small enough for the renderer, which squares lengths
/// and keeps colours in single precision.
constexpr double kLargestNumber = 1e30;

[[noreturn]] void refuse(
  const std::string& option, const std::string& text, const std::string& expected)
{
  throw UserError(option + "=" + text + " is not " + expected);
}

std::vector<std::string> split(const std::string& text, char separator)
{
  std::vector<std::string> parts(1);
  for (const char letter : text)
  {
    if (letter == separator)
    {
      parts.emplace_back();
    }
    else
    {
      parts.back() += letter;
    }
  }
  return parts;
}

std::optional<double> finiteNumber(const std::string& text)
{
  const char* first = text.data();
  const char* const last = first + text.size();
  // from_chars, unlike strtod, does not depend on the locale; but it knows no plus sign.
  if (first != last && *first == '+' && last - first > 1 && first[1] != '-')
  {
    ++first;
  }
  double number = 0;
  const auto [end, error] = std::from_chars(first, last, number);
  if (error != std::errc() || end != last || !(std::abs(number) <= kLargestNumber))
  {
    return std::nullopt;
  }
  return number;
}

std::optional<int> wholeNumber(const std::string& text, int smallest, int largest)
{
  int number = 0;
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, number);
  if (error != std::errc() || end != last || number < smallest || number > largest)
  {
    return std::nullopt;
  }
  return number;
}

std::optional<Vector3> finiteVector(const std::string& text)
{
  const std::vector<std::string> parts = split(text, ',');
  if (parts.size() != 3)
  {
    return std::nullopt;
  }
  Vector3 vector;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const std::optional<double> number = finiteNumber(parts[i]);
    if (!number)
    {
      return std::nullopt;
    }
    vector[i] = *number;
  }
  return vector;
}

bool isAllIn(const Vector3& vector, double smallest, double largest)
{
  return std::all_of(vector.begin(), vector.end(),
    [&](double number) { return number >= smallest && number <= largest; });
}

bool isIntensity(const Vector3& vector)
{
  return isAllIn(vector, 0, kLargestNumber);
}

std::optional<Vector3> directionFrom(const std::string& text)
{
  const std::optional<Vector3> vector = finiteVector(text);
  return vector == Vector3{ 0, 0, 0 } ? std::nullopt : vector;
}

std::optional<Color> intensityFrom(const std::string& text)
{
  const std::optional<Color> color = finiteVector(text);
  return color && isIntensity(*color) ? color : std::nullopt;
}

std::optional<LightSettings> directionalFrom(const std::vector<std::string>& parts)
{
  if (parts.size() != 3)
  {
    return std::nullopt;
  }
  const auto direction = directionFrom(parts[1]);
  const auto color = intensityFrom(parts[2]);
  if (!direction || !color)
  {
    return std::nullopt;
  }
  LightSettings light;
  light.kind = LightKind::Directional;
  light.direction = *direction;
  light.color = *color;
  return light;
}

std::optional<LightSettings> pointFrom(const std::vector<std::string>& parts)
{
  if (parts.size() != 3)
  {
    return std::nullopt;
  }
  const auto position = finiteVector(parts[1]);
  const auto color = intensityFrom(parts[2]);
  if (!position || !color)
  {
    return std::nullopt;
  }
  LightSettings light;
  light.kind = LightKind::Point;
  light.position = *position;
  light.color = *color;
  return light;
}

std::optional<LightSettings> spotFrom(const std::vector<std::string>& parts)
{
  if (parts.size() != 6)
  {
    return std::nullopt;
  }
  const auto position = finiteVector(parts[1]);
  const auto direction = directionFrom(parts[2]);
  const auto cone = finiteNumber(parts[3]);
  const auto exponent = finiteNumber(parts[4]);
  const auto color = intensityFrom(parts[5]);
  const bool complete = position && direction && cone && exponent && color;
  if (!complete || *cone <= 0 || *cone >= 90 || *exponent < 0 || *exponent > 128)
  {
    return std::nullopt;
  }
  return LightSettings{ LightKind::Spot, *position, *direction, *cone, *exponent, *color };
}

} // namespace

double parseNumber(const std::string& option, const std::string& text)
{
  const std::optional<double> number = finiteNumber(text);
  if (!number)
  {
    refuse(option, text, "a finite number, as in " + option + "=1.5");
  }
  return *number;
}

std::vector<double> parseNumbers(
  const std::string& option, const std::string& text, std::size_t fewest, std::size_t most)
{
  const std::vector<std::string> parts = split(text, ',');
  std::vector<double> numbers;
  for (const std::string& part : parts)
  {
    const std::optional<double> number = finiteNumber(part);
    if (!number || parts.size() < fewest || parts.size() > most)
    {
      const std::string count = fewest == most
                                  ? std::to_string(most)
                                  : std::to_string(fewest) + " to " + std::to_string(most);
      refuse(option, text, count + " finite numbers with commas between them");
    }
    numbers.push_back(*number);
  }
  return numbers;
}

int parseInteger(const std::string& option, const std::string& text, int smallest, int largest)
{
  const std::optional<int> number = wholeNumber(text, smallest, largest);
  if (!number)
  {
    refuse(option, text,
      "a whole number from " + std::to_string(smallest) + " to " + std::to_string(largest));
  }
  return *number;
}

Vector3 parseVector(const std::string& option, const std::string& text)
{
  const std::optional<Vector3> vector = finiteVector(text);
  if (!vector)
  {
    refuse(option, text, "three finite numbers, as in " + option + "=1,0,-2.5");
  }
  return *vector;
}

Vector3 parseDirection(const std::string& option, const std::string& text)
{
  const Vector3 vector = parseVector(option, text);
  if (vector == Vector3{ 0, 0, 0 })
  {
    refuse(option, text, "a direction, as in " + option + "=0,1,0");
  }
  return vector;
}

Color parseColor(const std::string& option, const std::string& text)
{
  const std::optional<Color> color = finiteVector(text);
  if (!color || !isAllIn(*color, 0, 1))
  {
    refuse(option, text, "a colour of three numbers from 0 to 1, as in " + option + "=0.9,0.5,0");
  }
  return *color;
}

Color parseIntensity(const std::string& option, const std::string& text)
{
  const std::optional<Color> color = intensityFrom(text);
  if (!color)
  {
    refuse(option, text, "a colour of three numbers of at least 0, as in " + option + "=1,0.5,0");
  }
  return *color;
}

std::array<double, 2> parseRange(const std::string& option, const std::string& text)
{
  const std::vector<std::string> parts = split(text, ',');
  if (parts.size() == 2)
  {
    const auto low = finiteNumber(parts[0]);
    const auto high = finiteNumber(parts[1]);
    if (low && high && *low < *high)
    {
      return { *low, *high };
    }
  }
  refuse(option, text, "two numbers, the smaller first, as in " + option + "=0,1");
}

std::array<int, 2> parseResolution(const std::string& option, const std::string& text)
{
  const std::vector<std::string> parts = split(text, ',');
  if (parts.size() == 2)
  {
    const auto width = wholeNumber(parts[0], 1, kLargestSide);
    const auto height = wholeNumber(parts[1], 1, kLargestSide);
    if (width && height)
    {
      return { *width, *height };
    }
  }
  refuse(option, text,
    "a width and a height from 1 to " + std::to_string(kLargestSide) + " pixels, as in " + option +
      "=1000,600");
}

Vector3 parseAxis(const std::string& option, const std::string& text)
{
  if (text.size() == 2 && (text[0] == '+' || text[0] == '-'))
  {
    const int axis = std::toupper(static_cast<unsigned char>(text[1])) - 'X';
    if (axis >= 0 && axis < 3)
    {
      Vector3 direction = { 0, 0, 0 };
      direction[static_cast<std::size_t>(axis)] = text[0] == '+' ? 1 : -1;
      return direction;
    }
  }
  refuse(option, text, "an axis; choose one of: +X, -X, +Y, -Y, +Z, -Z");
}

LightSettings parseLight(const std::string& option, const std::string& text)
{
  const std::vector<std::string> parts = split(text, ':');
  const std::string& kind = parts[0];
  if (kind == "headlight" && parts.size() == 1)
  {
    return {};
  }
  if (kind == "directional")
  {
    if (const auto light = directionalFrom(parts))
    {
      return *light;
    }
    refuse(option, text,
      "of the form directional:dx,dy,dz:r,g,b (a direction that is not zero; colours of at least "
      "0)");
  }
  if (kind == "point")
  {
    if (const auto light = pointFrom(parts))
    {
      return *light;
    }
    refuse(option, text, "of the form point:x,y,z:r,g,b (colours of at least 0)");
  }
  if (kind == "spot")
  {
    if (const auto light = spotFrom(parts))
    {
      return *light;
    }
    refuse(option, text,
      "of the form spot:x,y,z:dx,dy,dz:cone:exponent:r,g,b (cone: half angle between 0 and 90 "
      "degrees; exponent: 0 to 128)");
  }
  refuse(option, text,
    "a light; choose one of: directional:dx,dy,dz:r,g,b, point:x,y,z:r,g,b, "
    "spot:x,y,z:dx,dy,dz:cone:exponent:r,g,b, headlight");
}

std::string joinWords(const std::vector<std::string>& words)
{
  std::string joined;
  for (const std::string& word : words)
  {
    joined += (joined.empty() ? "" : ", ") + word;
  }
  return joined;
}

} // namespace limn::viewer
