// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "haptics/session/settings/Setting.h"

namespace palpate
{

/// The value of one setting.
struct SettingValue
{
  std::vector<double> numbers{}; ///< as many as the table has defaults; none for a text
  std::string text{};
  friend bool operator==(const SettingValue&, const SettingValue&) = default;
};

/// Empty, or one line that says why the setting cannot have this value: its kind, its number of elements, its range.
[[nodiscard]] std::string refuse(const Setting& setting, const SettingValue& value);

/// The value of every setting of a session; the defaults of the table at first. A name that the table does not have
/// throws std::logic_error.
class SettingStore
{
public:
  SettingStore();

  [[nodiscard]] const SettingValue& of(std::string_view name) const;
  [[nodiscard]] SettingValue& of(std::string_view name);
  [[nodiscard]] double number(std::string_view name) const { return this->of(name).numbers.at(0); }
  [[nodiscard]] int whole(std::string_view name) const { return static_cast<int>(this->number(name)); }
  [[nodiscard]] bool isOn(std::string_view name) const { return this->number(name) != 0.0; }
  [[nodiscard]] const std::string& text(std::string_view name) const { return this->of(name).text; }

  /// Numbers are put where those before are: their address stays.
  void put(std::string_view name, const SettingValue& value);
  void put(std::string_view name, double number) { this->put(name, SettingValue{ { number }, {} }); }
  void put(std::string_view name, const std::string& text) { this->put(name, SettingValue{ {}, text }); }

private:
  std::vector<SettingValue> values_; ///< in the order of the table
};

} // namespace palpate
