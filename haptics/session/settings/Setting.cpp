// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/settings/Setting.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>

namespace palpate
{
namespace
{

/// Rounding of a quaternion typed by a person or read from a text file.
constexpr double unitTolerance = 1e-6;

std::string small(std::string_view text)
{
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(), [](unsigned char c) { return std::tolower(c); });
  return result;
}

std::string choicesOf(const Setting& setting)
{
  std::string text;
  for (std::size_t i = 0; i < setting.choices.size(); ++i)
  {
    const bool last = i + 1 == setting.choices.size();
    text += i == 0 ? "" : last ? " or " : ", ";
    text += setting.kind == SettingKind::Choice ? std::to_string(i) + " (" + small(setting.choices[i]) + ")"
                                                : std::string(setting.choices[i]);
  }
  return text;
}

std::string rangeOf(const Setting& setting)
{
  const std::string low = quantity(setting.low, "");
  if (std::isfinite(setting.low) && std::isfinite(setting.high))
  {
    return low + " to " + quantity(setting.high, "");
  }
  return !std::isfinite(setting.low) ? "" : setting.above ? "more than " + low : low + " or more";
}

/// "a finite number of N/m, 0 or more", where the range alone does not say that it is a number.
std::string allowedWithKind(const Setting& setting)
{
  const std::string range = allowed(setting);
  if (setting.kind != SettingKind::Number && setting.kind != SettingKind::Count)
  {
    return range;
  }
  const bool counts = setting.unit.empty() || setting.unit == "1";
  return std::string(setting.kind == SettingKind::Count ? "a whole number" : "a finite number") +
         (counts ? "" : " of " + std::string(setting.unit)) + (range.empty() ? "" : ", ") + range;
}

bool isUnit(std::span<const double> values)
{
  double square = 0.0;
  std::for_each(values.begin(), values.end(), [&square](double value) { square += value * value; });
  return std::abs(std::sqrt(square) - 1.0) <= unitTolerance;
}

bool isUsable(const Setting& setting, double value)
{
  const bool within = value >= setting.low && value <= setting.high && !(setting.above && value == setting.low);
  switch (setting.kind)
  {
    case SettingKind::Flag:
      return value == 0.0 || value == 1.0;
    case SettingKind::Choice:
      return value >= 0.0 && value < static_cast<double>(setting.choices.size()) && value == std::floor(value);
    case SettingKind::Count:
      return std::isfinite(value) && within && value == std::floor(value);
    default:
      return std::isfinite(value) && within;
  }
}

std::string listed(std::span<const double> values)
{
  std::string text;
  for (const double value : values)
  {
    text += (text.empty() ? "" : ", ") + quantity(value, "");
  }
  return text;
}

} // namespace

std::string_view words(TakesEffect effect) noexcept
{
  switch (effect)
  {
    case TakesEffect::NextTick:
      return "next tick";
    case TakesEffect::NextFrame:
      return "next frame";
    case TakesEffect::NextScene:
      return "next scene";
    case TakesEffect::NextTouch:
      return "next touch";
    default:
      return "at once";
  }
}

std::string quantity(double value, std::string_view unit)
{
  std::ostringstream text;
  text << value << (unit.empty() || unit == "1" ? "" : " ") << (unit == "1" ? "" : unit);
  return text.str();
}

std::string allowed(const Setting& setting)
{
  switch (setting.kind)
  {
    case SettingKind::Flag:
      return "on or off";
    case SettingKind::Rotation:
      return "a unit quaternion (w, x, y, z)";
    case SettingKind::Choice:
    case SettingKind::Text:
      return choicesOf(setting);
    default:
      return rangeOf(setting);
  }
}

std::string defaultWords(const Setting& setting)
{
  switch (setting.kind)
  {
    case SettingKind::Flag:
      return setting.defaults.at(0) != 0.0 ? "on" : "off";
    case SettingKind::Text:
      return setting.defaultText.empty() ? "none" : std::string(setting.defaultText);
    case SettingKind::Choice:
      return small(setting.choices.at(static_cast<std::size_t>(setting.defaults.at(0))));
    default:
      break;
  }
  const bool single = setting.defaults.size() == 1;
  return setting.defaults.empty() ? "none"
         : single                 ? quantity(setting.defaults.front(), setting.unit)
                  : listed(setting.defaults) + (setting.unit.empty() || setting.unit == "1" ? "" : " ") +
                      (setting.unit == "1" ? "" : std::string(setting.unit));
}

Setting ofPath(Setting setting)
{
  if (setting.alongPath)
  {
    setting.defaults = { *setting.alongPath };
  }
  if (setting.anyAlongPath)
  {
    setting.low = 0.0;
    setting.high = Setting::infinity;
  }
  return setting;
}

std::string spoken(const Setting& setting)
{
  std::string title(setting.title);
  if (const std::size_t extra = title.find(" (&"); extra != std::string::npos)
  {
    title.erase(extra);
  }
  std::erase(title, '&');
  return title.empty() ? std::string(setting.name) : small(title);
}

std::string refuse(const Setting& setting, std::span<const double> values, std::string_view said)
{
  const bool each = std::all_of(values.begin(), values.end(), [&](double value) { return isUsable(setting, value); });
  if (each && (setting.kind != SettingKind::Rotation || isUnit(values)))
  {
    return {};
  }
  std::string sentence(setting.sentence);
  sentence.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(sentence.front())));
  return std::string(said) + ": must be " + allowedWithKind(setting) + ", not " + listed(values) + "; " + sentence;
}

} // namespace palpate
