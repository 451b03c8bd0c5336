// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>

#include "devices/common/BareSprings.h"
#include "devices/simulated/SimulatedDevice.h"
#include "haptics/force/DeviceWalls.h"
#include "testing/support/PlainJoystick.h"
#include "testing/support/Random.h"

namespace palpate
{
namespace
{

constexpr double K = 200.0;

DeviceCommand wallAt(double offset_m, double largest_N)
{
  AxisWalls walls;
  walls.offset_m[0] = offset_m;
  DeviceCommand held;
  command(walls, K, held, largest_N);
  return held;
}

TEST(BareSprings, PullAsTheyPush)
{
  for (const double m : { -0.01, -0.001, 0.002, 0.03 })
  {
    EXPECT_DOUBLE_EQ(conditionForce(bareSpring(0.005, K), m), -K * (m - 0.005));
  }
}

TEST(BareSprings, GiveTheForceOfTheWallsWhereTheHandleIsAndNoneBeforeThem)
{
  test::Random random(test::testSeed(2));
  for (std::size_t i = 0; i < test::testCount(1000); ++i)
  {
    AxisWalls walls;
    for (auto& offset_m : walls.offset_m)
    {
      offset_m = random.uniform(-0.02, 0.0);
    }
    const Vec3 p_D(random.uniform(-0.03, 0.03), random.uniform(-0.03, 0.03), 0.0);
    DeviceCommand held;
    command(walls, K, held, 1.0);
    const Vec3 expected_N = forceOfWalls(held, p_D);
    switchSprings(p_D, held);
    Vec3 force_N = Vec3::Zero();
    for (std::size_t k = 0; k < held.wallCount; ++k)
    {
      const DeviceWall& wall = held.walls[k];
      force_N +=
        conditionForce(bareSpring(wall.offset_m, wall.stiffness_N_per_m), wall.normal_D.dot(p_D)) * wall.normal_D;
    }
    EXPECT_NEAR((force_N - expected_N).norm(), 0.0, 1e-12) << p_D.transpose();
  }
}

TEST(BareSprings, OfADeviceAreOffUntilTheHostSeesTheHandleBehindAndOnUntilItSeesItBefore)
{
  constexpr double host_s = 0.008, speed_m_per_s = 0.1, heavy_kg = 1e4;
  DeviceModel model = test::plainJoystick(0.0);
  model.bareSprings = true;
  model.mass_kg = heavy_kg;
  model.loop_s = 1e-5;
  for (const double way : { -1.0, 1.0 }) // into the wall x >= 0, and out of it
  {
    SimulationOptions options;
    options.period_s = host_s;
    options.velocity_D = { way * speed_m_per_s, 0, 0 };
    const double from_m = -way * 0.25 * speed_m_per_s * host_s;
    SimulatedDevice device(model, *handModel("none"), { { Vec3(from_m, 0, 0) } }, options);
    ASSERT_EQ(device.open(), "");
    device.write(wallAt(0.0, 10.0));
    DeviceSample sample;
    static_cast<void>(device.read(host_s, sample)); // crosses a quarter of the path, and nothing is updated
    const double gained_N_s = heavy_kg * (device.speed_D().x() - way * speed_m_per_s);
    const double mean_m = from_m + way * 0.5 * speed_m_per_s * host_s;
    const double expected_N_s = way < 0.0 ? 0.0 : -K * mean_m * host_s;
    EXPECT_NEAR(gained_N_s, expected_N_s, 1e-2 * K * std::fabs(mean_m) * host_s) << way;
  }
}

} // namespace
} // namespace palpate
