// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>

#include "devices/evdev/EvdevEngine.h"
#include "devices/hid/pid/PidEngine.h"
#include "testing/devices/evdev/FakeEvdevBus.h"
#include "testing/support/Random.h"

namespace palpate
{
namespace
{

using test::VirtualDriver;

struct Engine
{
  explicit Engine(const EvdevTraits& traits = test::stickTraits())
    : port(bus.plug(traits)), connection(bus.open(port.entry).value), engine(*connection, traits)
  {
  }
  VirtualDriver& driver() { return this->port.driver; }
  /// An effect of that type that plays. From the left it pushes to the right.
  int playing(HidUsage type, double comesFrom_deg = 270.0)
  {
    const int block = this->engine.create(type).value;
    EffectSettings settings;
    settings.type = type;
    settings.comesFrom_deg = comesFrom_deg;
    EXPECT_TRUE(this->engine.setEffect(block, settings));
    EXPECT_TRUE(this->engine.start(block));
    return block;
  }

  test::FakeEvdevBus bus;
  test::FakeEvdevPort& port;
  std::unique_ptr<EvdevConnection> connection;
  EvdevEngine engine;
};

TEST(EvdevEngine, OpeningGivesFullGainAndEndsTheDevicesOwnSpring)
{
  Engine rig;
  EXPECT_EQ(rig.engine.open(), "");
  EXPECT_EQ(rig.driver().gain, 0xFFFF);
  EXPECT_EQ(rig.driver().autocentre, 0);
}

// Clockwise from the far side; the axis y points towards the person.
TEST(EvdevEngine, AForcePushesAwayFromWhereItComesFrom)
{
  test::Random random(test::testSeed(5));
  for (std::size_t i = 0; i < test::testCount(200); ++i)
  {
    Engine rig;
    ASSERT_EQ(rig.engine.open(), "");
    const double share = random.uniform(-1.0, 1.0),
                 angle_deg = i < 4 ? 90.0 * static_cast<double>(i) : random.uniform(0.0, 360.0);
    ASSERT_TRUE(rig.engine.setConstantForce(rig.playing(pid::constantForce, angle_deg), share));
    const double angle = angle_deg * M_PI / 180.0;
    EXPECT_NEAR(rig.driver().force()[0], -share * std::sin(angle), VirtualDriver::rounding) << angle_deg;
    EXPECT_NEAR(rig.driver().force()[1], share * std::cos(angle), VirtualDriver::rounding) << angle_deg;
  }
}

TEST(EvdevEngine, ALevelIsSaidAsExactlyAsTheKernelTakesItAndNeverStronger)
{
  Engine rig;
  ASSERT_EQ(rig.engine.open(), "");
  const int block = rig.playing(pid::constantForce);
  for (const double share : { 0.0, 1.0, -1.0, 0.3, -0.7, 1e-6, 2.0, -3.0 })
  {
    ASSERT_TRUE(rig.engine.setConstantForce(block, share));
    const double level = rig.driver().of(FF_CONSTANT)->u.constant.level;
    EXPECT_LE(std::fabs(level - 32767.0 * std::clamp(share, -1.0, 1.0)), 0.5) << share;
    EXPECT_EQ(rig.engine.constantForceSteps(share), static_cast<std::int64_t>(level));
  }
}

// Two walls, unlike each other, through the driver's reading of a condition.
TEST(EvdevEngine, AConditionPushesAsOurFormulaSays)
{
  test::Random random(test::testSeed(9));
  Engine rig;
  ASSERT_EQ(rig.engine.open(), "");
  const int block = rig.playing(pid::spring);
  for (std::size_t i = 0; i < test::testCount(300); ++i)
  {
    const double low = random.uniform(-0.9, 0.2), high = random.uniform(low, 0.9);
    Condition walls = corridor(low, high, random.uniform(), random.uniform());
    walls.negativeSaturation = random.uniform();
    walls.positiveSaturation = random.uniform();
    const std::size_t axis = random.below(2);
    ASSERT_TRUE(rig.engine.setCondition(block, static_cast<int>(axis), walls));
    rig.driver().position[axis] = random.uniform(-1.0, 1.0);
    Condition felt = walls;
    felt.positiveCoefficient *= VirtualDriver::springGain;
    felt.negativeCoefficient *= VirtualDriver::springGain;
    const double rounding = VirtualDriver::springGain * 3.0 / 32767.0 + 1.0 / 65535.0;
    EXPECT_NEAR(rig.driver().force()[axis], conditionForce(felt, rig.driver().position[axis]), rounding);
    rig.driver().position[axis] = 0.0;
    ASSERT_TRUE(rig.engine.setCondition(block, static_cast<int>(axis), {}));
  }
}

TEST(EvdevEngine, ASineSwingsBetweenItsMagnitudesOverItsPeriod)
{
  Engine rig;
  ASSERT_EQ(rig.engine.open(), "");
  const int block = rig.playing(pid::sine);
  ASSERT_TRUE(rig.engine.setPeriodic(block, 0.3, 20.0));
  ASSERT_TRUE(rig.engine.start(block));
  for (int ms = 0; ms < 40; ++ms)
  {
    EXPECT_NEAR(rig.driver().force()[0], 0.3 * std::sin(2.0 * M_PI * ms / 20.0), 1e-4) << ms;
    rig.driver().advance(1);
  }
}

TEST(EvdevEngine, AnEffectEndsByItselfUnlessItIsStartedAgain)
{
  Engine rig;
  ASSERT_EQ(rig.engine.open(), "");
  const int block = rig.playing(pid::constantForce);
  ASSERT_TRUE(rig.engine.setConstantForce(block, 0.5));
  rig.driver().advance(EffectSettings{}.duration_ms - 1);
  EXPECT_GT(rig.driver().force()[0], 0.0);
  ASSERT_TRUE(rig.engine.start(block));
  rig.driver().advance(EffectSettings{}.duration_ms - 1);
  EXPECT_GT(rig.driver().force()[0], 0.0);
  rig.driver().advance(1);
  EXPECT_EQ(rig.driver().force()[0], 0.0);
}

// I-Force sticks: EAGAIN until the stick has said that it took the last change.
TEST(EvdevEngine, WhatABusyDriverDidNotTakeIsGivenAgain)
{
  Engine rig;
  ASSERT_EQ(rig.engine.open(), "");
  const int block = rig.playing(pid::constantForce);
  EXPECT_EQ(rig.engine.catchUp(), PidStep::Idle);
  rig.port.busyFor = 2;
  EXPECT_TRUE(rig.engine.setConstantForce(block, 0.5));
  EXPECT_EQ(rig.driver().force()[0], 0.0);
  EXPECT_EQ(rig.engine.catchUp(), PidStep::Idle);
  EXPECT_EQ(rig.engine.catchUp(), PidStep::Sent);
  EXPECT_NEAR(rig.driver().force()[0], 0.5, VirtualDriver::rounding);
  EXPECT_EQ(rig.engine.catchUp(), PidStep::Idle);
  rig.port.busyFor = 1;
  EXPECT_TRUE(rig.engine.setConstantForce(block, 0.2));
  rig.port.uploadsThatFail = 1;
  EXPECT_EQ(rig.engine.catchUp(), PidStep::Failed);
}

TEST(EvdevEngine, TellsWhenTheMemoryForEffectsIsFull)
{
  Engine rig;
  ASSERT_EQ(rig.engine.open(), "");
  for (std::size_t i = 0; i < VirtualDriver::memory; ++i)
  {
    EXPECT_EQ(rig.engine.create(pid::constantForce).problem, "");
  }
  const EffectEngine::Created refused = rig.engine.create(pid::constantForce);
  EXPECT_EQ(refused.value, 0);
  EXPECT_NE(refused.problem.find("No space left"), std::string::npos) << refused.problem;
}

TEST(EvdevEngine, ClosingLeavesNoEffectAndTheDevicesOwnSpringAsItsDriverSaidItWas)
{
  Engine rig;
  rig.port.settings["autocenter"] = 0x1234;
  ASSERT_EQ(rig.engine.open(), "");
  EXPECT_EQ(rig.driver().autocentre, 0);
  ASSERT_TRUE(rig.engine.setConstantForce(rig.playing(pid::constantForce), 0.5));
  static_cast<void>(rig.playing(pid::spring));
  rig.engine.close();
  EXPECT_EQ(rig.driver().held(), 0);
  EXPECT_EQ(rig.driver().autocentre, 0x1234);
  Engine silent; // its driver does not say: it stays as drivers leave it when a device is plugged in
  ASSERT_EQ(silent.engine.open(), "");
  silent.engine.close();
  EXPECT_EQ(silent.driver().autocentre, 0);
}

} // namespace
} // namespace palpate
