// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "devices/hid/pid/PidWalls.h"
#include "testing/devices/hid/FakeHidBus.h"
#include "testing/support/Random.h"

namespace palpate
{
namespace
{

using test::PidLayout;
using test::VirtualPidDevice;

constexpr double largestShare = 0.6;

/// Scale of the virtual device: its spring gives full force at a tenth of half its travel.
PidScale virtualScale()
{
  PidScale scale;
  scale.springStiffness_N_per_m = VirtualPidDevice::springGain * scale.maxForce_N / scale.halfTravel_m;
  scale.damperViscosity_Ns_per_m = VirtualPidDevice::damperMetric * scale.springStiffness_N_per_m;
  return scale;
}

struct Corridors
{
  std::array<double, 2> low_m, high_m;
  double stiffness_N_per_m;
};

/// All four walls round a rectangle, in an order of their own.
DeviceCommand fourWalls(const Corridors& c)
{
  DeviceCommand command;
  command.wallCount = 4;
  command.walls = { { { -Vec3::UnitX(), -c.high_m[0], c.stiffness_N_per_m },
    { Vec3::UnitY(), c.low_m[1], c.stiffness_N_per_m }, { Vec3::UnitX(), c.low_m[0], c.stiffness_N_per_m },
    { -Vec3::UnitY(), -c.high_m[1], c.stiffness_N_per_m } } };
  return command;
}

Corridors randomCorridors(test::Random& random, const PidScale& scale)
{
  Corridors c{};
  for (const std::size_t axis : { 0U, 1U })
  {
    c.low_m[axis] = random.uniform(-0.9, 0.4) * scale.halfTravel_m;
    c.high_m[axis] = c.low_m[axis] + random.uniform(0.02, 0.5) * scale.halfTravel_m;
  }
  c.stiffness_N_per_m = random.uniform(0.1, 1.0) * scale.springStiffness_N_per_m;
  return c;
}

/// A virtual device that holds the walls of a command.
struct Held
{
  Held(const PidLayout& layout, const DeviceCommand& command, const PidScale& scale)
    : port(bus.plug(layout)), descriptor(parseReportDescriptor(port.descriptor)),
      connection(bus.open(port.entry).value), engine(*connection, descriptor)
  {
    EXPECT_EQ(this->engine.open(), "");
    this->plan = planWalls(command, scale, conditionAbilities(this->descriptor), largestShare);
    this->spring = this->hold(pid::spring, this->plan.springs);
    const Condition braking = planDamper(command, scale, largestShare);
    static_cast<void>(this->hold(pid::damper, { braking, braking }));
  }

  int hold(HidUsage type, const std::array<Condition, 2>& conditions)
  {
    const int block = this->engine.create(type).value;
    EffectSettings settings;
    settings.type = type;
    settings.duration_ms = 30000;
    EXPECT_TRUE(this->engine.setEffect(block, settings));
    EXPECT_TRUE(this->engine.setCondition(block, 0, conditions[0]));
    EXPECT_TRUE(this->engine.setCondition(block, 1, conditions[1]));
    EXPECT_TRUE(this->engine.setEffect(block, settings));
    EXPECT_TRUE(this->engine.start(block));
    return block;
  }

  VirtualPidDevice& device() { return *this->port.device; }

  test::FakeHidBus bus;
  test::FakePort& port;
  ReportDescriptor descriptor;
  std::unique_ptr<HidConnection> connection;
  PidEngine engine;
  WallPlan plan;
  int spring = 0;
};

bool holdsFour(const PidLayout& layout)
{
  return layout.conditionNumber(0x65) != nullptr && layout.conditionNumber(0x63) != nullptr;
}

/// Of a number of the condition report, one step as a share.
double stepOf(const PidLayout& layout, std::uint8_t usage)
{
  return 1.0 / static_cast<double>(layout.conditionNumber(usage)->max);
}

// Row 48.
TEST(PidWalls, FourWallsAreHeldWhereTheyAreToOneStepOnEveryLayoutWithADeadBand)
{
  test::Random random(test::testSeed(5301));
  const PidScale scale = virtualScale();
  const std::size_t cases = test::testCount(50);
  for (const PidLayout& layout : test::allLayouts())
  {
    for (std::size_t i = 0; holdsFour(layout) && i < cases; ++i)
    {
      const Corridors c = randomCorridors(random, scale);
      Held held(layout, fourWalls(c), scale);
      EXPECT_EQ(held.plan.held, (std::array<bool, 4>{ true, true, true, true }));
      for (const int axis : { 0, 1 })
      {
        const auto a = static_cast<std::size_t>(axis);
        // HID's y points towards the person: the far wall is the lower one there.
        const double low = (axis == 0 ? c.low_m[a] : -c.high_m[a]) / scale.halfTravel_m;
        const double high = (axis == 0 ? c.high_m[a] : -c.low_m[a]) / scale.halfTravel_m;
        const Condition& kept = held.device().condition(held.spring, axis);
        const double step = std::max(stepOf(layout, 0x60), stepOf(layout, 0x65)) * (1.0 + 1e-9);
        EXPECT_NEAR(kept.centre, 0.5 * (low + high), 0.5 * step) << layout.name;
        EXPECT_NEAR(kept.deadBand, 0.5 * (high - low), 0.5 * step) << layout.name;
        EXPECT_NEAR(kept.centre - kept.deadBand, low, step) << layout.name;
        EXPECT_NEAR(kept.centre + kept.deadBand, high, step) << layout.name;
        const double coefficient = c.stiffness_N_per_m / scale.springStiffness_N_per_m;
        EXPECT_NEAR(kept.positiveCoefficient, coefficient, 0.5000001 * stepOf(layout, 0x61)) << layout.name;
        EXPECT_NEAR(kept.negativeCoefficient, coefficient, 0.5000001 * stepOf(layout, 0x62)) << layout.name;
        EXPECT_NEAR(kept.positiveSaturation, largestShare, 0.5000001 * stepOf(layout, 0x63)) << layout.name;
        EXPECT_NEAR(kept.negativeSaturation, largestShare, 0.5000001 * stepOf(layout, 0x64)) << layout.name;
      }
      EXPECT_EQ(held.device().badReports, 0) << layout.name;
    }
  }
}

TEST(PidWalls, TheForceOfTheDeviceAlongAWholeSweepIsThatOfTheFourWallsAskedFor)
{
  test::Random random(test::testSeed(5302));
  const PidScale scale = virtualScale();
  for (const PidLayout& layout : test::allLayouts())
  {
    if (!holdsFour(layout))
    {
      continue;
    }
    const Corridors c = randomCorridors(random, scale);
    Held held(layout, fourWalls(c), scale);
    const double K = c.stiffness_N_per_m, most_N = largestShare * scale.maxForce_N;
    for (int i = -200; i <= 200; ++i)
    {
      // Not along a diagonal of the rectangle: one axis must not make up for the other.
      const std::array<double, 2> at_m{ 0.005 * i * scale.halfTravel_m, 0.004 * (100 - i) * scale.halfTravel_m };
      held.device().position = { at_m[0] / scale.halfTravel_m, -at_m[1] / scale.halfTravel_m };
      for (const std::size_t a : { 0U, 1U })
      {
        // Springs from the low wall downwards and from the high wall upwards, each cut to 60 % of the largest force.
        const double below_m = std::max(0.0, c.low_m[a] - at_m[a]), above_m = std::max(0.0, at_m[a] - c.high_m[a]);
        const double wanted_N = std::min(K * below_m, most_N) - std::min(K * above_m, most_N);
        const double edge_N = K * scale.halfTravel_m * std::max(stepOf(layout, 0x60), stepOf(layout, 0x65));
        const double slope_N = scale.springStiffness_N_per_m * std::max(below_m, above_m) * stepOf(layout, 0x61);
        const double top_N = scale.maxForce_N * stepOf(layout, 0x63);
        const double given_N =
          (a == 0 ? 1.0 : -1.0) * held.device().force()[a] * scale.maxForce_N; // HID's y is ours reversed
        EXPECT_NEAR(given_N, wanted_N, edge_N + slope_N + top_N) << layout.name << ", axis " << a;
      }
    }
  }
}

TEST(PidWalls, AHandThatPushesRestsBehindEachWallByPushOverStiffness)
{
  const PidScale scale = virtualScale();
  const Corridors c{ { -0.3 * scale.halfTravel_m, -0.2 * scale.halfTravel_m },
    { 0.5 * scale.halfTravel_m, 0.2 * scale.halfTravel_m }, scale.springStiffness_N_per_m };
  Held held(test::plainLayout(), fourWalls(c), scale);
  const double push = 0.5, behind = push / VirtualPidDevice::springGain;
  const auto rest = [&](double x, double y)
  {
    held.device().push = { x, y };
    held.bus.advance(2000);
    return held.device().position;
  };
  EXPECT_NEAR(rest(push, 0)[0], 0.5 + behind, 2e-4);
  EXPECT_NEAR(rest(-push, 0)[0], -0.3 - behind, 2e-4);
  EXPECT_NEAR(rest(0, push)[1], 0.2 + behind, 2e-4);
  EXPECT_NEAR(rest(0, -push)[1], -0.2 - behind, 2e-4);
}

TEST(PidWalls, AHarderPushThanTheLimitGoesThrough)
{
  const PidScale scale = virtualScale();
  DeviceCommand command;
  command.wallCount = 1;
  command.walls[0] = { -Vec3::UnitX(), 0.0, scale.springStiffness_N_per_m };
  Held held(test::plainLayout(), command, scale);
  held.device().push = { largestShare + 0.05, 0.0 };
  held.bus.advance(15000); // the excess of 0.05 against its friction of 0.6 moves it by a twelfth a second
  EXPECT_EQ(held.device().position[0], 1.0); // the limit on the hand holds on the device, too
}

TEST(PidWalls, EachWallPushesNoHarderThanItsOwnLimitOnTheDeviceAndOnTheHost)
{
  const PidScale scale = virtualScale();
  const double K = scale.springStiffness_N_per_m;
  DeviceCommand command = fourWalls({ { -0.01, -0.01 }, { 0.01, 0.01 }, K });
  command.walls[0].largest_N = 2.0; // x <= 0.01
  command.walls[2].largest_N = 1.0; // x >= -0.01
  command.walls[3].largest_N = 0.5; // y <= 0.01, in HID's direction the lower one
  const Held held(test::plainLayout(), command, scale);
  EXPECT_EQ(held.plan.springs[0].positiveSaturation, 2.0 / scale.maxForce_N);
  EXPECT_EQ(held.plan.springs[0].negativeSaturation, 1.0 / scale.maxForce_N);
  EXPECT_EQ(held.plan.springs[1].negativeSaturation, 0.5 / scale.maxForce_N);
  EXPECT_EQ(held.plan.springs[1].positiveSaturation, largestShare); // less than a wall without limit asks for
  // Full force of the springs comes at a tenth of half the travel behind a wall.
  const Vec3 deep_D(0.01 + 0.1 * scale.halfTravel_m, 0.0, 0.0);
  EXPECT_NEAR(hostWallForce(command, {}, deep_D).x(), -2.0, 1e-12);
  EXPECT_NEAR(hostWallForce(command, {}, -deep_D).x(), 1.0, 1e-12);
}

TEST(PidWalls, OneCoefficientForBothSidesGoesWithOneLimit)
{
  const PidScale scale = virtualScale();
  DeviceCommand command;
  command.wallCount = 1;
  command.walls[0] = { Vec3::UnitX(), 0.0, scale.springStiffness_N_per_m, 1.0 };
  const WallPlan plan = planWalls(command, scale, { false, true, true }, largestShare);
  EXPECT_EQ(plan.springs[0].negativeSaturation, 1.0 / scale.maxForce_N);
  EXPECT_EQ(plan.springs[0].positiveSaturation, 1.0 / scale.maxForce_N);
}

TEST(PidWalls, OneWallLeavesTheOtherSideFreeOnEveryLayoutThatHoldsOne)
{
  const PidScale scale = virtualScale();
  for (const PidLayout& layout : test::allLayouts())
  {
    for (const Vec3& normal_D : { Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0) })
    {
      DeviceCommand command;
      command.wallCount = 1;
      command.walls[0] = { normal_D, 0.2 * scale.halfTravel_m, scale.springStiffness_N_per_m };
      Held held(layout, command, scale);
      EXPECT_EQ(held.plan.held[0], layout.conditionNumber(0x63) != nullptr) << layout.name;
      const std::size_t axis = normal_D.x() != 0.0 ? 0 : 1;
      const double sign = axis == 0 ? normal_D.x() : -normal_D.y();
      for (const double along : { -0.5, 0.5, 0.9 })
      {
        held.device().position = {};
        held.device().position[axis] = sign * along;
        const bool pushes = held.plan.held[0] && along < 0.2;
        EXPECT_NEAR(sign * held.device().force()[axis], pushes ? largestShare : 0.0, 0.01) << layout.name << along;
      }
    }
  }
}

TEST(PidWalls, WithoutADeadBandOneOfTwoWallsIsHeldAndTheHostHasTheOther)
{
  const PidScale scale = virtualScale();
  const Corridors c{ { -0.01, -0.01 }, { 0.01, 0.01 }, 100.0 };
  const DeviceCommand command = fourWalls(c);
  const WallPlan plan = planWalls(command, scale, { true, false, true }, largestShare);
  EXPECT_EQ(plan.held, (std::array<bool, 4>{ false, false, true, true })); // x >= and, HID's y being turned, y <=
  const Vec3 force = hostWallForce(command, plan, Vec3(0.015, -0.015, 0.0));
  EXPECT_NEAR(force.x(), -100.0 * 0.005, 1e-12);
  EXPECT_NEAR(force.y(), 100.0 * 0.005, 1e-12);
}

TEST(PidWalls, ADeviceThatCannotHoldOrLimitLeavesAllWallsToTheHost)
{
  const PidScale scale = virtualScale();
  const DeviceCommand command = fourWalls({ { -0.01, -0.01 }, { 0.01, 0.01 }, 100.0 });
  for (const ConditionAbilities abilities : { ConditionAbilities{ false, false, false },
         ConditionAbilities{ false, false, true }, ConditionAbilities{ true, true, false } })
  {
    const WallPlan plan = planWalls(command, scale, abilities, largestShare);
    EXPECT_EQ(plan.held, (std::array<bool, 4>{}));
    EXPECT_NEAR(hostWallForce(command, plan, Vec3(0.02, 0.02, 0.0)).norm(), std::sqrt(2.0), 1e-12);
  }
}

TEST(PidWalls, SlantedCrossedAndDoubledWallsStayWithTheHost)
{
  const PidScale scale = virtualScale();
  const ConditionAbilities all{ true, true, true };
  DeviceCommand command;
  command.wallCount = 2;
  command.walls[0] = { Vec3(0.6, 0.8, 0.0), 0.0, 100.0 };
  command.walls[1] = { Vec3::UnitX(), 0.0, 100.0 };
  EXPECT_EQ(planWalls(command, scale, all, largestShare).held, (std::array<bool, 4>{ false, true }));
  command.walls[0] = { Vec3::UnitX(), 0.01, 100.0 }; // tighter than the other
  EXPECT_EQ(planWalls(command, scale, all, largestShare).held, (std::array<bool, 4>{ true, false }));
  command.walls[0] = { -Vec3::UnitX(), 0.01, 100.0 }; // x <= -0.01 and x >= 0
  EXPECT_EQ(planWalls(command, scale, all, largestShare).held, (std::array<bool, 4>{ false, false }));
  command.walls[0] = { Vec3::UnitX(), std::nan(""), 100.0 };
  EXPECT_EQ(planWalls(command, scale, all, largestShare).held, (std::array<bool, 4>{ false, true }));
}

TEST(PidWalls, TheViscosityOfACommandBrakesLikeIt)
{
  const PidScale scale = virtualScale();
  DeviceCommand command;
  command.viscosity_Ns_per_m = 0.5 * scale.damperViscosity_Ns_per_m;
  Held held(test::plainLayout(), command, scale);
  const double v_m_per_s = 0.01;
  held.device().velocity = { v_m_per_s / scale.halfTravel_m, 0.0 };
  EXPECT_NEAR(held.device().force()[0] * scale.maxForce_N, -command.viscosity_Ns_per_m * v_m_per_s, 1e-6);
}

} // namespace
} // namespace palpate
