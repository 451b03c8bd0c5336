// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "devices/simulated/DeviceModels.h"
#include "devices/simulated/SerialLink.h"
#include "haptics/force/DeviceWalls.h"
#include "haptics/force/StabilityLimits.h"
#include "testing/support/Random.h"

namespace palpate
{
namespace
{

constexpr double bytes_per_s = 3125.0;

DeviceCommand forceOf(double force_N)
{
  DeviceCommand command;
  command.wrench_D.force.x() = force_N;
  return command;
}

DeviceCommand wallsAt(double right_m, double left_m, double stiffness_N_per_m)
{
  AxisWalls walls;
  walls.offset_m[0] = right_m;
  walls.offset_m[2] = left_m;
  DeviceCommand held;
  command(walls, stiffness_N_per_m, held);
  return held;
}

TEST(SerialLink, CountsSixBytesForEachParameterThatHasChanged)
{
  const DeviceCommand two = wallsAt(-0.01, -0.02, 200.0);
  EXPECT_EQ(SerialLink::bytesBetween(two, two), 0.0);
  EXPECT_EQ(SerialLink::bytesBetween(two, wallsAt(-0.01, -0.03, 200.0)), 6.0);
  EXPECT_EQ(SerialLink::bytesBetween(two, wallsAt(-0.02, -0.03, 100.0)), 24.0);
  EXPECT_EQ(SerialLink::bytesBetween(two, {}), 12.0); // both lose their stiffness
  EXPECT_EQ(SerialLink::bytesBetween(forceOf(1.0), forceOf(2.0)), 12.0);
  DeviceCommand viscous = two;
  viscous.viscosity_Ns_per_m = 1.0;
  EXPECT_EQ(SerialLink::bytesBetween(two, viscous), 6.0);
}

TEST(SerialLink, AForceActsWhenItsLastByteHasArrivedAndTheNewestIsSentNext)
{
  SerialLink link(bytes_per_s);
  constexpr double message_s = 12.0 / bytes_per_s; // 3.84 ms
  EXPECT_EQ(link.carry(forceOf(1.0), 0.0).wrench_D.force.x(), 0.0);
  EXPECT_EQ(link.carry(forceOf(2.0), 0.001).wrench_D.force.x(), 0.0);
  EXPECT_EQ(link.carry(forceOf(3.0), 0.99 * message_s).wrench_D.force.x(), 0.0);
  EXPECT_EQ(link.carry(forceOf(4.0), message_s).wrench_D.force.x(), 1.0);
  EXPECT_EQ(link.carry(forceOf(4.0), 1.99 * message_s).wrench_D.force.x(), 1.0);
  EXPECT_EQ(link.carry(forceOf(4.0), 2.0 * message_s).wrench_D.force.x(), 3.0); // the newest when the link was free
  EXPECT_EQ(link.carry(forceOf(4.0), 3.0 * message_s).wrench_D.force.x(), 4.0);
}

TEST(SerialLink, WithoutALimitEachCommandIsThereAtOnce)
{
  test::Random random(test::testSeed(3));
  SerialLink link(DeviceModel::unlimited);
  for (std::size_t i = 0; i < test::testCount(1000); ++i)
  {
    const double force_N = random.uniform(-1.0, 1.0);
    EXPECT_EQ(link.carry(forceOf(force_N), 1e-3 * static_cast<double>(i)).wrench_D.force.x(), force_N);
  }
}

TEST(SerialLink, ThatIsSlowerThanTheHostIsTheLoopThatStiffnessIsLimitedFor)
{
  DeviceInfo slow = infoOf(*deviceModel("simulated-generic"));
  const LoopSettings host{ .period_s = 1e-3, .passivity = { .enabled = false } };
  const double direct_N_per_m = stabilityLimits(slow, host).stable_N_per_m;
  slow.forceUpdate_s.value = 12.0 / bytes_per_s;
  const LoopSettings link{ .period_s = 12.0 / bytes_per_s, .passivity = { .enabled = false, .delay_ticks = 1.0 } };
  const DeviceInfo fast = infoOf(*deviceModel("simulated-generic"));
  EXPECT_DOUBLE_EQ(stabilityLimits(slow, host).stable_N_per_m, stabilityLimits(fast, link).stable_N_per_m);
  EXPECT_LT(stabilityLimits(slow, host).stable_N_per_m, 0.5 * direct_N_per_m);
  slow.forceUpdate_s.value = 0.5e-3; // carries two in a tick
  EXPECT_EQ(stabilityLimits(slow, host).stable_N_per_m, direct_N_per_m);
}

} // namespace
} // namespace palpate
