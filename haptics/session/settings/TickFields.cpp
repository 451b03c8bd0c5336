// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/settings/TickFields.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <type_traits>

#include "haptics/session/settings/SessionSettings.h"
#include "haptics/tick/StageFields.h"

namespace palpate
{
namespace
{

template<class T>
void put(std::span<const double> values, T& member)
{
  member = static_cast<T>(values.front());
}

void put(std::span<const double> values, bool& member)
{
  member = values.front() != 0.0;
}

void put(std::span<const double> values, Vec3& member)
{
  member = Vec3(values[0], values[1], values[2]);
}

void put(std::span<const double> values, Quat& member)
{
  member = Quat(values[0], values[1], values[2], values[3]).normalized();
}

template<std::size_t n>
void put(std::span<const double> values, std::array<double, n>& member)
{
  std::ranges::copy(values.first(std::min(n, values.size())), member.begin());
}

template<std::size_t n>
std::vector<double> numbersOf(const std::array<double, n>& member)
{
  return { member.begin(), member.end() };
}

template<class T>
std::vector<double> numbersOf(const T& member)
{
  return { static_cast<double>(member) };
}

std::vector<double> numbersOf(const Vec3& member)
{
  return { member.begin(), member.end() };
}

std::vector<double> numbersOf(const Quat& member)
{
  return { member.w(), member.x(), member.y(), member.z() };
}

/// Calls function(member) with the member of these parameters that the setting names as "stage.field".
template<class Parameters, class Function>
void withField(Parameters& parameters, const Setting& setting, const Function& function)
{
  bool found = false;
  forEachPlan(
    [&](std::string_view stage, const auto& fields)
    {
      fields(
        [&](std::string_view field, auto& member)
        {
          if (setting.at.field == std::string(stage) + "." + std::string(field))
          {
            found = true;
            function(member);
          }
        },
        parameters);
    });
  if (!found)
  {
    throw std::logic_error(
      std::string(setting.name) + ": no stage has the field '" + std::string(setting.at.field) + "'");
  }
}

} // namespace

void setField(HapticParameters& parameters, const Setting& setting, std::span<const double> values)
{
  withField(parameters, setting, [values](auto& member) { put(values, member); });
}

std::vector<double> fieldOf(const HapticParameters& parameters, const Setting& setting)
{
  std::vector<double> numbers;
  withField(parameters, setting, [&numbers](const auto& member) { numbers = numbersOf(member); });
  return numbers;
}

HapticParameters sessionDefaults()
{
  HapticParameters parameters;
  for (const Setting& setting : sessionSettings())
  {
    if (!setting.at.field.empty())
    {
      setField(parameters, setting, setting.defaults);
    }
  }
  return parameters;
}

} // namespace palpate
