// SPDX-FileCopyrightText: Copyright (c) the Limn authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ParseValue.h"

#include "UserError.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>
#include <locale>
#include <sstream>

namespace limn::viewer
{
namespace
{

constexpr int kLargestSide = 16384;

/// Of a number's size. Far beyond any use, and small enough for the renderer, which squares lengths
/// and keeps colours in single precision.
constexpr double kLargestNumber = 1e30;
/// Likewise of numbers that must not be 0.
constexpr double kSmallestNumber = 1e-30;

std::vector<std::string> split(const std::string& text, const std::string& separators)
{
  std::vector<std::string> parts(1);
  for (const char letter : text)
  {
    if (separators.find(letter) != std::string::npos)
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

/// Of any size. What is larger or nearer to 0 than a double becomes the last one that is not.
std::optional<double> numberOfAnySize(const std::string& text)
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
  if (end != last || error == std::errc::invalid_argument)
  {
    return std::nullopt;
  }
  if (error == std::errc::result_out_of_range)
  {
    // Too large or too near to 0? from_chars does not say.
    std::istringstream stream(text);
    stream.imbue(std::locale::classic());
    stream >> number;
    const bool isTiny = std::abs(number) < 1;
    number =
      isTiny ? std::numeric_limits<double>::denorm_min() : std::numeric_limits<double>::max();
    return *first == '-' ? -number : number;
  }
  return std::isfinite(number) ? std::optional<double>(number) : std::nullopt;
}

std::optional<double> finiteNumber(const std::string& text)
{
  const std::optional<double> number = numberOfAnySize(text);
  return number && std::abs(*number) <= kLargestNumber ? number : std::nullopt;
}

/// Throws if a number, a part of the text, is too large.
void refuseHuge(
  const std::string& option, const std::string& text, const std::string& part, double number)
{
  if (std::abs(number) > kLargestNumber)
  {
    throw UserError(
      option + "=" + text + ": " + part + " is not from -1e30 to 1e30, as all numbers have to be");
  }
}

/// "30" of "30deg"; empty unless a number is followed by letters, of any alphabet.
std::string withoutUnit(const std::string& text)
{
  const std::size_t end = text.find_last_of("0123456789.");
  const std::string number = end == std::string::npos ? "" : text.substr(0, end + 1);
  const auto isOfUnit = [](unsigned char letter) { return std::isalpha(letter) || letter > 0x7F; };
  const bool hasUnit =
    number.size() < text.size() &&
    std::all_of(text.begin() + static_cast<std::ptrdiff_t>(number.size()), text.end(), isOfUnit);
  return hasUnit && finiteNumber(number) ? number : "";
}

/// What may be wrong with a text that is not what an option expects, if it is easily mended.
std::string hintOf(const std::string& text)
{
  for (const std::string& part : split(text, ",:="))
  {
    if (const std::string number = withoutUnit(part); !number.empty())
    {
      return "; write " + number + ", without a unit";
    }
  }
  return "";
}

/// Says so if a number in the text is too large, which nobody would guess from what is expected.
[[noreturn]] void refuse(
  const std::string& option, const std::string& text, const std::string& expected)
{
  for (const std::string& part : split(text, ",:="))
  {
    refuseHuge(option, text, part, numberOfAnySize(part).value_or(0));
  }
  throw UserError(option + "=" + text + " is not " + expected + hintOf(text));
}

/// Of StrokeUnits, in their order.
const char* const kUnits[] = { "px", "pt", "mm" };

/// Of a number whose unit is none of a length's, as in 30deg.
std::string unitHintOf(const std::string& text)
{
  return withoutUnit(text).empty() ? "" : "; the units of lengths are px, pt and mm";
}

/// In pixels, if no unit follows the number.
std::optional<Length> lengthOfAnySize(const std::string& text)
{
  std::string digits = text;
  Length length = { 0, 0 };
  for (int unit = 0; unit < 3; ++unit)
  {
    if (text.size() > 2 && text.compare(text.size() - 2, 2, kUnits[unit]) == 0)
    {
      digits.resize(text.size() - 2);
      length.unit = unit;
      break;
    }
  }
  const std::optional<double> number = numberOfAnySize(digits);
  length.value = number.value_or(0);
  return number ? std::optional<Length>(length) : std::nullopt;
}

/// However it is written: 1e3 is one.
std::optional<int> wholeNumber(const std::string& text, int smallest, int largest)
{
  const std::optional<double> number = numberOfAnySize(text);
  if (!number || *number < smallest || *number > largest || std::floor(*number) != *number)
  {
    return std::nullopt;
  }
  return static_cast<int>(*number);
}

std::optional<Vector3> finiteVector(const std::string& text)
{
  const std::vector<std::string> parts = split(text, ",");
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

/// A light of `kind` at a position, with its colour or power.
std::optional<LightSettings> lightAt(
  LightKind kind, const std::string& position, const std::string& color)
{
  static const std::string power = "power=";
  const bool isPower = color.rfind(power, 0) == 0;
  const auto at = finiteVector(position);
  const auto amount = intensityFrom(isPower ? color.substr(power.size()) : color);
  if (!at || !amount)
  {
    return std::nullopt;
  }
  LightSettings light;
  light.kind = kind;
  light.position = *at;
  light.color = *amount;
  light.isPower = isPower;
  return light;
}

std::optional<LightSettings> pointFrom(const std::vector<std::string>& parts)
{
  if (parts.size() != 3 && parts.size() != 4)
  {
    return std::nullopt;
  }
  auto light = lightAt(LightKind::Point, parts[1], parts[2]);
  if (!light || parts.size() == 3)
  {
    return light;
  }
  const auto attenuation = intensityFrom(parts[3]);
  if (!attenuation || *attenuation == Vector3{ 0, 0, 0 } || light->isPower)
  {
    return std::nullopt;
  }
  light->attenuation = *attenuation;
  return light;
}

std::optional<LightSettings> spotFrom(const std::vector<std::string>& parts)
{
  if (parts.size() != 6 && parts.size() != 7)
  {
    return std::nullopt;
  }
  auto light = lightAt(LightKind::Spot, parts[1], parts[5]);
  const auto direction = directionFrom(parts[2]);
  const auto cone = finiteNumber(parts[3]);
  const auto exponent = finiteNumber(parts[4]);
  const auto soft = parts.size() == 7 ? finiteNumber(parts[6]) : 0;
  const bool complete = light && direction && cone && exponent && soft;
  if (!complete || *cone <= 0 || *cone >= 90 || *exponent < 0 || *exponent > 128 || *soft < 0 ||
      *soft > *cone)
  {
    return std::nullopt;
  }
  light->direction = *direction;
  light->coneDegrees = *cone;
  light->exponent = *exponent;
  light->softDegrees = *soft;
  return light;
}

constexpr int kMostSamples = 65536;

/// The last of `count` parts is the number of samples, which may be left out.
bool setSamples(const std::vector<std::string>& parts, std::size_t count, LightSettings& light)
{
  if (parts.size() == count)
  {
    const auto samples = wholeNumber(parts.back(), 1, kMostSamples);
    light.samples = samples.value_or(0);
  }
  return light.samples > 0;
}

/// Neither is zero, too.
bool isRightAngle(const Vector3& a, const Vector3& b)
{
  constexpr double kSine = 1e-6;
  const double ab = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const double lengths = std::hypot(a[0], a[1], a[2]) * std::hypot(b[0], b[1], b[2]);
  return lengths > 0 && std::fabs(ab) <= kSine * lengths;
}

std::optional<LightSettings> rectangleFrom(const std::vector<std::string>& parts)
{
  if (parts.size() != 5 && parts.size() != 6)
  {
    return std::nullopt;
  }
  auto light = lightAt(LightKind::Rectangle, parts[1], parts[4]);
  const auto a = finiteVector(parts[2]);
  const auto b = finiteVector(parts[3]);
  if (!light || !a || !b || !isRightAngle(*a, *b) || !setSamples(parts, 6, *light))
  {
    return std::nullopt;
  }
  light->sides = { *a, *b };
  return light;
}

std::optional<LightSettings> sphereFrom(const std::vector<std::string>& parts)
{
  if (parts.size() != 4 && parts.size() != 5)
  {
    return std::nullopt;
  }
  auto light = lightAt(LightKind::Sphere, parts[1], parts[3]);
  const auto radius = finiteNumber(parts[2]);
  if (!light || !radius || *radius <= 0 || !setSamples(parts, 5, *light))
  {
    return std::nullopt;
  }
  light->radius = *radius;
  return light;
}

struct LightForm
{
  const char* kind;
  std::optional<LightSettings> (*from)(const std::vector<std::string>& parts);
  const char* form;
};

const LightForm kLightForms[] = {
  { "directional", directionalFrom,
    "directional:dx,dy,dz:r,g,b (a direction that is not zero; colours of at least 0)" },
  { "point", pointFrom,
    "point:x,y,z:r,g,b (colours of at least 0; power=r,g,b for the power) or "
    "point:x,y,z:r,g,b:a,b,c (for r,g,b / (a + b d + c d^2) at the distance d, not all 0)" },
  { "spot", spotFrom,
    "spot:x,y,z:dx,dy,dz:cone:exponent:r,g,b (cone: half angle between 0 and 90 degrees; exponent: "
    "0 to 128; power=r,g,b for the power), which :soft may follow (degrees of the cone over which "
    "it fades, 0 to cone)" },
  { "rectangle", rectangleFrom,
    "rectangle:x,y,z:ax,ay,az:bx,by,bz:r,g,b (its middle and two sides at a right angle; it shines "
    "to the side of a x b; power=r,g,b for the power), which :samples may follow (1 to "
    "65536)" },
  { "sphere", sphereFrom,
    "sphere:x,y,z:radius:r,g,b (a radius above 0; power=r,g,b for the power), which :samples may "
    "follow (1 to 65536)" },
};

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
  const std::vector<std::string> parts = split(text, ",");
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
  const std::vector<std::string> parts = split(text, ",");
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
  const std::vector<std::string> parts = split(text, ",");
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
  const std::vector<std::string> parts = split(text, ":");
  if (text == "headlight")
  {
    return {};
  }
  for (const LightForm& form : kLightForms)
  {
    if (inSmallLetters(parts[0]) != form.kind)
    {
      continue;
    }
    if (parts[0] != form.kind)
    {
      refuse(option, text, std::string("a light; write its kind in small letters: ") + form.kind);
    }
    if (const auto light = form.from(parts))
    {
      return *light;
    }
    refuse(option, text, std::string("of the form ") + form.form);
  }
  if (inSmallLetters(text) == "headlight")
  {
    refuse(option, text, "a light; write it in small letters: headlight");
  }
  refuse(option, text,
    "a light; choose one of: headlight, directional:..., point:..., spot:..., rectangle:..., "
    "sphere:... (see limn render --help)");
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

std::string inSmallLetters(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return text;
}

double parseNumberOfAnySize(
  const std::string& option, const std::string& text, const std::string& range)
{
  const std::optional<double> number = numberOfAnySize(text);
  if (!number)
  {
    throw UserError(option + "=" + text + " is not a number " + range + hintOf(text));
  }
  return *number;
}

void refuseTiny(const std::string& option, const std::string& text, double number)
{
  if (number != 0 && std::abs(number) < kSmallestNumber)
  {
    throw UserError(option + "=" + text + " is nearer to 0 than 1e-30, the smallest number here");
  }
}

double requirePositive(const std::string& option, const std::string& text, double number)
{
  if (number <= 0)
  {
    throw UserError(option + "=" + text + " is not greater than 0");
  }
  refuseTiny(option, text, number);
  return number;
}

double parsePositive(const std::string& option, const std::string& text)
{
  return requirePositive(option, text, parseNumber(option, text));
}

Length parseLength(const std::string& option, const std::string& text, const std::string& range)
{
  const std::optional<Length> length = lengthOfAnySize(text);
  if (!length)
  {
    const std::string mended = inSmallLetters(text);
    throw UserError(
      option + "=" + text + " is not a length" + (range.empty() ? "" : " " + range) +
      ", as in 2, 1.5px, 3pt or 0.5mm" +
      (mended != text && lengthOfAnySize(mended) ? "; write " + mended : unitHintOf(text)));
  }
  if (length->unit != 0)
  {
    refuseHuge(option, text, text, length->value);
  }
  return *length;
}

Length parseWidth(const std::string& option, const std::string& text, double mostPixels)
{
  std::ostringstream most;
  most << mostPixels << " pixels";
  const Length width = parseLength(option, text, "above 0 and up to " + most.str());
  requirePositive(option, text, width.value);
  if (width.unit == 0 && width.value > mostPixels)
  {
    throw UserError(option + "=" + text + " is greater than " + most.str());
  }
  return width;
}

std::array<Length, 2> parseDash(const std::string& option, const std::string& text)
{
  const std::vector<std::string> parts = split(text, ",");
  std::array<Length, 2> lengths = {};
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    const std::optional<Length> length = lengthOfAnySize(parts[i]);
    if (!length || parts.size() != lengths.size())
    {
      throw UserError(option + "=" + text +
                      " is not two lengths with a comma between them, as in " + option +
                      "=6,3 or " + option + "=2mm,1mm" + (length ? "" : unitHintOf(parts[i])));
    }
    refuseHuge(option, text, parts[i], length->value);
    lengths[i] = *length;
  }
  for (const Length& length : lengths)
  {
    if (length.value <= 0)
    {
      throw UserError(option + "=" + text + ": dash and gap have to be above 0");
    }
    refuseTiny(option, text, length.value);
  }
  if (lengths[0].unit == 0 && lengths[1].unit == 0 && lengths[0].value + lengths[1].value < 0.5)
  {
    throw UserError(option + "=" + text + ": dash and gap have to be half a pixel together");
  }
  return lengths;
}

} // namespace limn::viewer
