// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/path/PathSettings.h"

#include <algorithm>
#include <array>
#include <vector>

#include "haptics/field/laws/Detent.h"
#include "haptics/session/settings/AutoChoice.h"
#include "haptics/session/settings/SessionSettings.h"
#include "haptics/session/settings/TickFields.h"

namespace palpate
{
namespace
{

/// Beside those that have an option of the program.
constexpr std::array<std::string_view, 2> choicesOfPath = { "ToolCoupling", "LinesAsWalls" };

std::string inBraces(const Setting& setting)
{
  return "{" + std::string(setting.name) + "}";
}

/// "", or the first setting of a path that is asked about and is not as by default.
template<class Asked>
std::string firstSet(const SettingStore& settings, const Asked& asked)
{
  for (const Setting& each : sessionSettings())
  {
    const Setting setting = ofPath(each);
    const SettingValue& value = settings.of(setting.name);
    const bool isDefault = value.numbers == setting.defaults && value.text == setting.defaultText;
    if (!isDefault && isOfPath(setting) && asked(setting.name))
    {
      return inBraces(setting);
    }
  }
  return {};
}

/// "", or why settings cannot be together.
std::string refuseTogether(const SettingStore& settings)
{
  const HapticParameters parameters = pathParameters(settings);
  const bool named = !setAmong(settings, { "FieldArray", "FieldVectors", "FieldResistance" }).empty();
  if (named && !isOn(parameters.field))
  {
    return "{FieldArray}: a field array is set, but no force: set {FieldIsosurface}, {FieldFollow} or another force";
  }
  if (!named && isOn(parameters.field))
  {
    return "{FieldArray}: a field force is set, but no array: set {FieldArray}, {FieldVectors} or {FieldResistance}";
  }
  const std::string problem = parameters.validate();
  return problem.starts_with("friction") ? "{FrictionStatic}, {FrictionKinetic}: " + problem : problem;
}

} // namespace

bool isOfPath(const Setting& setting)
{
  return !setting.at.option.empty() || setting.name.starts_with("Field") ||
         std::ranges::find(choicesOfPath, setting.name) != choicesOfPath.end();
}

std::string withNames(std::string sentence, const std::function<std::string(std::string_view)>& known)
{
  for (const Setting& setting : sessionSettings())
  {
    const std::string name = inBraces(setting);
    for (std::size_t at = sentence.find(name); at != std::string::npos; at = sentence.find(name, at))
    {
      const std::string put = known(setting.name);
      sentence.replace(at, name.size(), put);
      at += put.size();
    }
  }
  return sentence;
}

bool areWalls(const SettingStore& settings)
{
  return settings.whole("LinesAsWalls") == static_cast<int>(AutoChoice::On);
}

SettingStore pathSettings()
{
  SettingStore store;
  for (const Setting& setting : sessionSettings())
  {
    store.put(setting.name, SettingValue{ ofPath(setting).defaults, std::string(setting.defaultText) });
  }
  return store;
}

std::string refusePathSettings(const SettingStore& settings)
{
  for (const Setting& each : sessionSettings())
  {
    const Setting setting = ofPath(each);
    const bool numbers = isOfPath(setting) && setting.kind != SettingKind::Text;
    const std::string problem = numbers ? refuse(setting, settings.of(setting.name).numbers, inBraces(setting)) : "";
    if (!problem.empty())
    {
      return problem;
    }
  }
  DetentPlan detent;
  constexpr std::string_view itsName = "levels"; // with which its sentences begin
  const std::string problem = setLevels(detent, settings.text("FieldDetentLevels"));
  return problem.empty() ? refuseTogether(settings) : "{FieldDetentLevels}" + problem.substr(itsName.size());
}

std::string setBeside(const SettingStore& settings, std::initializer_list<std::string_view> felt)
{
  return firstSet(settings, [felt](std::string_view name) { return std::ranges::find(felt, name) == felt.end(); });
}

std::string setAmong(const SettingStore& settings, std::initializer_list<std::string_view> unfelt)
{
  return firstSet(
    settings, [unfelt](std::string_view name) { return std::ranges::find(unfelt, name) != unfelt.end(); });
}

HapticParameters pathParameters(const SettingStore& settings)
{
  HapticParameters parameters;
  for (const Setting& setting : sessionSettings())
  {
    if (isOfPath(setting) && !setting.at.field.empty())
    {
      setField(parameters, setting, settings.of(setting.name).numbers);
    }
  }
  parameters.contact.friction = { settings.number("FrictionStatic"), settings.number("FrictionKinetic") };
  static_cast<void>(setLevels(parameters.field.detent, settings.text("FieldDetentLevels")));
  parameters.stiffness_N_per_m /= parameters.map.scale_u_per_m;
  parameters.map = {};
  return parameters;
}

} // namespace palpate
