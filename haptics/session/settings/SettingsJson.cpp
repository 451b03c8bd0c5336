// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <sstream>

#include "haptics/session/settings/SessionSettings.h"

namespace palpate
{
namespace
{

const char* name(SettingKind kind)
{
  const char* const names[] = { "flag", "count", "choice", "number", "rotation", "points", "text" };
  return names[static_cast<int>(kind)];
}

const char* name(Readout::Kind kind)
{
  const char* const names[] = { "text", "flag", "count", "long count", "number" };
  return names[static_cast<int>(kind)];
}

/// The tables hold no control characters.
std::string quoted(std::string_view text)
{
  std::string result = "\"";
  for (const char c : text)
  {
    result += c == '"' || c == '\\' ? "\\" : "";
    result += c;
  }
  return result + '"';
}

/// A number that is not finite is null.
std::string number(double value)
{
  std::ostringstream text;
  text.precision(std::numeric_limits<double>::max_digits10);
  text << value;
  return std::isfinite(value) ? text.str() : "null";
}

template<typename T, typename Write>
std::string array(const T& values, Write write)
{
  std::string text = "[";
  for (const auto& value : values)
  {
    text += (text.size() > 1 ? ", " : "") + write(value);
  }
  return text + "]";
}

std::string field(std::string_view key, const std::string& value, bool first = false)
{
  return (first ? "" : ", ") + quoted(key) + ": " + value;
}

std::string object(const Setting& setting)
{
  return "{" + field("name", quoted(setting.name), true) + field("kind", quoted(name(setting.kind))) +
         field("unit", quoted(setting.unit)) + field("title", quoted(setting.title)) +
         field("sentence", quoted(setting.sentence)) + field("effect", quoted(words(setting.effect))) +
         field("defaults", array(setting.defaults, number)) + field("default_text", quoted(setting.defaultText)) +
         field("default_words", quoted(defaultWords(setting))) + field("low", number(setting.low)) +
         field("high", number(setting.high)) + field("above", setting.above ? "true" : "false") +
         field("allowed", quoted(allowed(setting))) + field("choices", array(setting.choices, quoted)) +
         field("saved", setting.saved ? "true" : "false") + field("field", quoted(setting.at.field)) +
         field("option", quoted(setting.at.option)) +
         field("path_default_words", quoted(defaultWords(ofPath(setting)))) +
         field("path_allowed", quoted(allowed(ofPath(setting)))) + "}";
}

std::string object(const Readout& readout)
{
  return "{" + field("name", quoted(readout.name), true) + field("kind", quoted(name(readout.kind))) +
         field("unit", quoted(readout.unit)) + field("title", quoted(readout.title)) +
         field("sentence", quoted(readout.sentence)) + field("elements", std::to_string(readout.elements)) + "}";
}

} // namespace

std::string describedAsJson()
{
  const auto write = [](const auto& described) { return object(described); };
  return "{" + field("settings", array(sessionSettings(), write), true) +
         field("readouts", array(sessionReadouts(), write)) + "}";
}

} // namespace palpate
