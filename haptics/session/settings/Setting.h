// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace palpate
{

/// Kind of the values of a setting.
enum class SettingKind
{
  Flag,     ///< 0 or 1
  Count,    ///< a whole number
  Choice,   ///< one of the choices, by its place from 0 on
  Number,   ///< one or more numbers, each within the range
  Rotation, ///< a unit quaternion (w, x, y, z)
  Points,   ///< any number of points
  Text      ///< one of the choices where there are any, else any text
};

enum class TakesEffect
{
  AtOnce,
  NextTick,
  NextFrame,
  NextScene,
  NextTouch
};

/// Where a setting stands besides the property that every one is.
struct SettingPlaces
{
  std::string_view field{};  ///< "stage.field" of the tick's parameters that it is; "": something follows from it
  std::string_view group{};  ///< group of the panel with a row for the setting; "": no row, or a control of its own
  std::string_view option{}; ///< of `palpate touch`, without dashes; "": none
};

/// A setting of a session, described for all interfaces.
struct Setting
{
  std::string_view name; ///< of its property
  SettingKind kind = SettingKind::Number;
  std::string_view unit;     ///< "" without a unit; u is a scene unit
  std::string_view title;    ///< of its row in the panel, & before its letter; "": it has none
  std::string_view sentence; ///< description
  TakesEffect effect = TakesEffect::NextTick;
  std::vector<double> defaults{}; ///< one a number
  std::string_view defaultText{}; ///< of a text
  double low = -infinity;         ///< least value
  double high = infinity;         ///< largest value
  bool above = false;             ///< more than the least value
  std::vector<std::string_view> choices{};
  bool saved = true; ///< in a state file
  SettingPlaces at{};
  std::optional<double> alongPath{}; ///< default of one who feels along a path in the scene, where it is another
  bool anyAlongPath = false;         ///< who feels along a path may have any value from 0 on

  static constexpr double infinity = std::numeric_limits<double>::infinity();
};

/// A read-out of a session.
struct Readout
{
  enum class Kind
  {
    Text,
    Flag,
    Count,
    LongCount,
    Number
  };
  std::string_view name; ///< of its property
  Kind kind = Kind::Number;
  std::string_view unit;     ///< "" without a unit
  std::string_view title;    ///< of its row in the panel; "": it has none of its own
  std::string_view sentence; ///< description
  int elements = 1;
};

/// When it takes effect, in words.
[[nodiscard]] std::string_view words(TakesEffect effect) noexcept;

/// A number with its unit, "500 N/m"; without one where that says nothing.
[[nodiscard]] std::string quantity(double value, std::string_view unit);

/// Which values a setting can have, in words without their unit: "0 or more"; "" where any will do.
[[nodiscard]] std::string allowed(const Setting& setting);

/// The default in words with its unit.
[[nodiscard]] std::string defaultWords(const Setting& setting);

/// The setting as one who feels along a path in the scene has it: with that default and range.
[[nodiscard]] Setting ofPath(Setting setting);

/// Its title as a sentence has it: in small letters, without the mark of a letter; its name where it has no title.
[[nodiscard]] std::string spoken(const Setting& setting);

/// Empty, or one line with the reason against `values` and the allowed values. `said`: the name of the setting for the
/// person.
[[nodiscard]] std::string refuse(const Setting& setting, std::span<const double> values, std::string_view said);

} // namespace palpate
