// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/settings/SettingStore.h"

#include "haptics/session/settings/SessionSettings.h"

namespace palpate
{
namespace
{

std::size_t placeOf(std::string_view name)
{
  return static_cast<std::size_t>(&sessionSetting(name) - sessionSettings().data());
}

/// "a text", "a number", "3 numbers".
std::string shapeOf(const Setting& setting)
{
  const std::size_t count = setting.defaults.size();
  return setting.kind == SettingKind::Text ? "a text" : count == 1 ? "a number" : std::to_string(count) + " numbers";
}

} // namespace

std::string refuse(const Setting& setting, const SettingValue& value)
{
  const bool isText = setting.kind == SettingKind::Text;
  if (setting.kind == SettingKind::Points)
  {
    return std::string(setting.name) + ": its points are added one by one";
  }
  if (value.numbers.size() != setting.defaults.size() || (!isText && !value.text.empty()))
  {
    return std::string(setting.name) + ": must be " + shapeOf(setting);
  }
  return refuse(setting, value.numbers, spoken(setting));
}

SettingStore::SettingStore()
{
  for (const Setting& setting : sessionSettings())
  {
    this->values_.push_back({ setting.defaults, std::string(setting.defaultText) });
  }
}

const SettingValue& SettingStore::of(std::string_view name) const
{
  return this->values_[placeOf(name)];
}

SettingValue& SettingStore::of(std::string_view name)
{
  return this->values_[placeOf(name)];
}

void SettingStore::put(std::string_view name, const SettingValue& value)
{
  SettingValue& held = this->of(name);
  held.numbers.assign(value.numbers.begin(), value.numbers.end());
  held.text = value.text;
}

} // namespace palpate
