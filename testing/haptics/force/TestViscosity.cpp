// SPDX-License-Identifier: GPL-3.0-or-later
// Row 47: a handle thrown to and fro in a narrow corridor.
#include <cmath>

#include <gtest/gtest.h>

#include "devices/simulated/SimulatedDevice.h"
#include "haptics/force/Viscosity.h"

namespace palpate
{
namespace
{

/// 4 mm wide, walls of 2000 N/m closed once a millisecond by motors of 5 N.
Corridor narrow()
{
  return { 2e-3, 2000.0, 5.0, 0.05, 0.05, 1e-3, 0.1 };
}

TEST(Viscosity, WithoutItAThrowGrowsUntilTheMotorsLimitAndWithALittleItEnds)
{
  const Throw without = throwIn(narrow(), 0.0, 5.0), with = throwIn(narrow(), 0.5, 5.0);
  EXPECT_GT(without.speed_m_per_s, 10 * 0.1);
  EXPECT_GT(without.reach_m, 10 * 2e-3); // deep in walls that give no more than 5 N
  EXPECT_LT(with.speed_m_per_s, 1e-3 * 0.1);
  EXPECT_LE(with.reach_m, 2e-3);
  Corridor damped = narrow();
  damped.damping_Ns_per_m = 0.2;
  EXPECT_EQ(smallestViscosity(damped), 0.0); // its own damping is enough
}

TEST(Viscosity, TheSmallestIsEnoughAndATenthLessIsNot)
{
  const std::optional<double> found = smallestViscosity(narrow());
  ASSERT_TRUE(found.has_value());
  EXPECT_TRUE(decays(narrow(), *found));
  EXPECT_FALSE(decays(narrow(), 0.9 * *found));
}

TEST(Viscosity, ACorridorThatNoneHelpsIsSaid)
{
  Corridor corridor = narrow();
  corridor.period_s = 0.05; // 20 Hz: walls of 2000 N/m throw the handle whatever damps it
  EXPECT_FALSE(smallestViscosity(corridor).has_value());
}

// In free air v' = -(b + B) v / m: held for a period, each one multiplies the speed by (1 + B / b) exp(-b T / m) - B /
// b.
TEST(Viscosity, AJoystickRendersItInItsOwnLoop)
{
  DeviceModel model = *deviceModel("simulated-joystick");
  model.friction_N = 0.0;
  SimulationOptions options;
  options.period_s = 0.05;
  options.velocity_D = { 0.1, 0, 0 };
  SimulatedDevice joystick(model, *handModel("none"), { { Vec3(-0.04, 0, 0) } }, options);
  ASSERT_EQ(joystick.open(), "");
  DeviceCommand command;
  command.viscosity_Ns_per_m = 2.0;
  joystick.write(command);
  DeviceSample sample;
  ASSERT_EQ(joystick.read(0.1, sample), DeviceStatus::Ok);
  const double b = model.damping_Ns_per_m, ratio = command.viscosity_Ns_per_m / b;
  const double once = (1 + ratio) * std::exp(-b * 1e-3 / model.mass_kg) - ratio;
  EXPECT_NEAR(joystick.speed_D().x(), 0.1 * std::pow(once, 100), 1e-12);
}

} // namespace
} // namespace palpate
