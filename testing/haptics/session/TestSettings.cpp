// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "haptics/session/settings/SessionSettings.h"
#include "haptics/session/settings/SettingStore.h"
#include "haptics/session/settings/TickFields.h"
#include "haptics/tick/HapticParameters.h"

namespace palpate
{
namespace
{

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

std::string said(const char* name, std::vector<double> values)
{
  return refuse(sessionSetting(name), values, spoken(sessionSetting(name)));
}

TEST(Settings, EveryDefaultIsAllowedAndNoNameComesTwice)
{
  std::set<std::string_view> names;
  for (const Setting& setting : sessionSettings())
  {
    EXPECT_TRUE(names.insert(setting.name).second) << setting.name;
    EXPECT_THAT(refuse(setting, setting.defaults, setting.name), IsEmpty());
    EXPECT_THAT(std::string(setting.sentence), Not(IsEmpty())) << setting.name;
    EXPECT_NE(setting.sentence.back(), '.') << setting.name;
  }
  for (const Readout& readout : sessionReadouts())
  {
    EXPECT_TRUE(names.insert(readout.name).second) << readout.name;
    EXPECT_NE(readout.sentence.back(), '.') << readout.name;
  }
  EXPECT_THROW(static_cast<void>(sessionSetting("Stifness")), std::logic_error);
}

TEST(Settings, TheEndsOfARangeAreAllowedAndWhatIsBeyondThemIsNot)
{
  const auto next = [](double value, double towards) { return std::nextafter(value, towards); };
  for (const Setting& setting : sessionSettings())
  {
    const auto refused = [&](double value)
    {
      std::vector<double> values = setting.defaults;
      values.back() = value;
      return !refuse(setting, values, setting.name).empty();
    };
    if (setting.kind != SettingKind::Number)
    {
      continue;
    }
    for (const double bad : { std::nan(""), Setting::infinity, -Setting::infinity })
    {
      EXPECT_EQ(setting.defaults.empty(), false) << setting.name;
      EXPECT_TRUE(refused(bad)) << setting.name << ' ' << bad;
    }
    if (std::isfinite(setting.low))
    {
      EXPECT_EQ(refused(setting.low), setting.above) << setting.name;
      EXPECT_FALSE(refused(next(setting.low, Setting::infinity))) << setting.name;
      EXPECT_TRUE(refused(next(setting.low, -Setting::infinity))) << setting.name;
    }
    if (std::isfinite(setting.high))
    {
      EXPECT_FALSE(refused(setting.high)) << setting.name;
      EXPECT_TRUE(refused(next(setting.high, Setting::infinity))) << setting.name;
    }
  }
}

TEST(Settings, WholeNumbersChoicesAndRotationsAreTakenAsWhatTheyAre)
{
  EXPECT_THAT(said("Delay", { 16 }), IsEmpty());
  EXPECT_THAT(said("Delay", { 17 }), HasSubstr("a whole number of ticks, 0 to 16, not 17"));
  EXPECT_THAT(said("Delay", { 0.5 }), Not(IsEmpty()));
  EXPECT_THAT(said("Simplify", { 2 }), IsEmpty());
  for (const double bad : { -1.0, 0.5, 3.0, std::nan("") })
  {
    EXPECT_THAT(said("Simplify", { bad }), HasSubstr("must be 0 (auto), 1 (off) or 2 (on), not"));
  }
  EXPECT_THAT(said("Passivity", { 2 }), HasSubstr("on or off"));
  EXPECT_THAT(said("Rotation", { std::sqrt(0.5), 0.0, std::sqrt(0.5), 0.0 }), IsEmpty());
  EXPECT_THAT(said("Rotation", { 1.0, 1.0, 0.0, 0.0 }), HasSubstr("a unit quaternion (w, x, y, z), not 1, 1, 0, 0"));
}

TEST(Settings, ARefusalNamesTheSettingItsRangeWithTheUnitAndWhatItIs)
{
  EXPECT_EQ(said("Stiffness", { -1 }),
    "stiffness: must be a finite number of N/m, 0 or more, not -1; stiffness of the spring between hand and proxy");
  EXPECT_THAT(said("Scale", { 0 }), HasSubstr("scale: must be a finite number of u/m, more than 0, not 0"));
  EXPECT_THAT(said("WallRate", { 5 }), HasSubstr("WallRate: must be a finite number of Hz, 20 to 1000, not 5"));
  EXPECT_THAT(said("FrictionStatic", { -0.5 }), HasSubstr("a finite number, 0 to 10, not -0.5"));
  EXPECT_THAT(said("LineRadius", { std::nan("") }),
    HasSubstr("radius of lines: must be a finite number of u, 0 or more, not nan"));
  EXPECT_THAT(said("LinesAsWalls", { 7 }), HasSubstr("lines as walls: "));
  EXPECT_THAT(said("Offset", { 0, 0, std::nan("") }), HasSubstr("must be a finite number of u, not 0, 0, nan"));
}

/// The tick takes the numbers that the table allows, and the other way round, where both limit a number.
TEST(Settings, TheTickTakesWhatTheTableAllows)
{
  const auto taken = [](auto put)
  {
    HapticParameters parameters;
    parameters.map.scale_u_per_m = 1.0;
    put(parameters);
    return parameters.validate().empty();
  };
  for (const double value : { -1.0, 0.0, 1.0, 10.0, 11.0, 16.0, 17.0, 1e6, std::nan(""), Setting::infinity })
  {
    const auto allows = [value](const char* name) { return said(name, { value }).empty(); };
    EXPECT_EQ(taken([=](auto& p) { p.stiffness_N_per_m = value; }), allows("Stiffness")) << value;
    EXPECT_EQ(taken([=](auto& p) { p.damping_Ns_per_m = value; }), allows("Damping")) << value;
    EXPECT_EQ(taken([=](auto& p) { p.contact.radius_u = value; }), allows("Radius")) << value;
    EXPECT_EQ(taken([=](auto& p) { p.map.scale_u_per_m = value; }), allows("Scale")) << value;
    EXPECT_EQ(taken([=](auto& p) { p.passivity.delay_ticks = value; }), allows("Delay")) << value;
    EXPECT_EQ(taken([=](auto& p) { p.contact.friction = { value, value }; }), allows("FrictionStatic")) << value;
    EXPECT_EQ(allows("FrictionKinetic"), allows("FrictionStatic")) << value;
  }
}

/// Another value than the default that the setting allows.
std::vector<double> other(const Setting& setting)
{
  switch (setting.kind)
  {
    case SettingKind::Rotation:
      return { 0.5, 0.5, -0.5, 0.5 };
    case SettingKind::Flag:
    case SettingKind::Choice:
      return { setting.defaults.front() == 0.0 ? 1.0 : 0.0 };
    default:
      break;
  }
  std::vector<double> values = setting.defaults;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] += std::min(1.0 + static_cast<double>(i), 0.5 * (setting.high - values[i]));
  }
  return values;
}

TEST(Settings, ThatIsAFieldOfTheTickIsThatFieldAndNoOther)
{
  int fields = 0;
  const HapticParameters before = sessionDefaults();
  for (const Setting& setting : sessionSettings())
  {
    if (setting.at.field.empty())
    {
      continue;
    }
    ++fields;
    EXPECT_EQ(fieldOf(before, setting), setting.defaults) << setting.name;
    const std::vector<double> values = other(setting);
    ASSERT_THAT(refuse(setting, values, setting.name), IsEmpty());
    HapticParameters changed = before;
    setField(changed, setting, values);
    EXPECT_THAT(changed.validate(), IsEmpty()) << setting.name;
    for (const Setting& one : sessionSettings())
    {
      if (!one.at.field.empty())
      {
        EXPECT_EQ(fieldOf(changed, one), one.name == setting.name ? values : one.defaults) << one.name;
      }
    }
  }
  EXPECT_GE(fields, 14);
}

TEST(Settings, AFieldThatNoStageHasIsSaidByName)
{
  Setting setting = sessionSetting("Stiffness");
  setting.at.field = "stiffness.stifness_N_per_m";
  EXPECT_THROW(static_cast<void>(fieldOf({}, setting)), std::logic_error);
}

TEST(Settings, WhoFeelsAlongAPathBeginsWithTheTicksOwnParameters)
{
  for (const Setting& setting : sessionSettings())
  {
    if (!setting.at.field.empty() && !setting.at.option.empty())
    {
      EXPECT_EQ(fieldOf(HapticParameters(), setting), ofPath(setting).defaults) << setting.name;
    }
  }
}

TEST(Settings, TheTableAsTextHasEverySettingAndEveryReadout)
{
  const std::string text = describedAsJson();
  for (const Setting& setting : sessionSettings())
  {
    EXPECT_THAT(text, HasSubstr("{\"name\": \"" + std::string(setting.name) + "\""));
  }
  for (const Readout& readout : sessionReadouts())
  {
    EXPECT_THAT(text, HasSubstr("{\"name\": \"" + std::string(readout.name) + "\""));
  }
  EXPECT_THAT(text, HasSubstr("\"high\": null")); // JSON has no infinity
}

TEST(SettingStore, HoldsTheDefaultsOfTheTableAtFirst)
{
  const SettingStore store;
  for (const Setting& setting : sessionSettings())
  {
    EXPECT_EQ(store.of(setting.name).numbers, setting.defaults) << setting.name;
    EXPECT_EQ(store.text(setting.name), setting.defaultText) << setting.name;
  }
  EXPECT_THROW(static_cast<void>(store.of("Stifness")), std::logic_error);
}

TEST(SettingStore, NumbersStayWhereTheyAreWhenTheyAreSet)
{
  SettingStore store;
  const double* const before = store.of("Offset").numbers.data();
  store.put("Offset", SettingValue{ { 1.0, 2.0, 3.0 }, {} });
  EXPECT_EQ(store.of("Offset").numbers.data(), before);
  EXPECT_EQ(before[2], 3.0);
}

TEST(SettingStore, AValueOfAnotherShapeIsRefused)
{
  const auto refused = [](const char* name, const SettingValue& value) { return refuse(sessionSetting(name), value); };
  EXPECT_EQ(refused("Offset", { { 1.0, 2.0 }, {} }), "Offset: must be 3 numbers");
  EXPECT_EQ(refused("Radius", { {}, "a" }), "Radius: must be a number");
  EXPECT_EQ(refused("DeviceName", { { 1.0 }, {} }), "DeviceName: must be a text");
  EXPECT_THAT(refused("StrokePoints", { { 1.0 }, {} }), HasSubstr("one by one"));
  EXPECT_THAT(refused("Radius", { { -1.0 }, {} }), HasSubstr("0 or more"));
  EXPECT_EQ(refused("DeviceName", { {}, "mouse" }), "");
}

} // namespace
} // namespace palpate
