// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "devices/hid/pid/PidEngine.h"
#include "devices/hid/report/PidNumbers.h"
#include "testing/devices/hid/FakeHidBus.h"

namespace palpate
{
namespace
{

using test::FakeHidBus;
using test::FakePort;
using test::PidLayout;

/// An engine on a virtual device.
struct EngineRig
{
  explicit EngineRig(const PidLayout& layout)
    : port(bus.plug(layout)), descriptor(parseReportDescriptor(port.descriptor)),
      connection(bus.open(port.entry).value), engine(*connection, descriptor)
  {
  }

  test::VirtualPidDevice& device() { return *this->port.device; }

  /// A constant force of that share in that direction, playing.
  int play(double share, double comesFrom_deg, int duration_ms)
  {
    const PidEngine::Created made = this->engine.create(pid::constantForce);
    EXPECT_EQ(made.problem, "");
    EffectSettings settings;
    settings.duration_ms = duration_ms;
    settings.comesFrom_deg = comesFrom_deg;
    EXPECT_TRUE(this->engine.setEffect(made.value, settings));
    EXPECT_TRUE(this->engine.setConstantForce(made.value, share));
    EXPECT_TRUE(this->engine.start(made.value));
    return made.value;
  }

  FakeHidBus bus;
  FakePort& port;
  ReportDescriptor descriptor;
  std::unique_ptr<HidConnection> connection;
  PidEngine engine;
};

TEST(PidEngine, OpensEveryLayoutWithoutAReportTheDeviceDoesNotKnow)
{
  for (const PidLayout& layout : test::allLayouts())
  {
    EngineRig rig(layout);
    EXPECT_EQ(rig.engine.open(), "") << layout.name;
    EXPECT_TRUE(rig.device().actuators) << layout.name;
    EXPECT_EQ(rig.device().gain, 1.0) << layout.name;
    EXPECT_EQ(rig.device().resets, 1) << layout.name;
    EXPECT_EQ(rig.device().badReports, 0) << layout.name;
  }
}

TEST(PidEngine, AConstantForceComesFromItsDirectionOnEveryLayoutToOneStep)
{
  for (const PidLayout& layout : test::allLayouts())
  {
    for (const double comesFrom_deg : { 0.0, 90.0, 180.0, 270.0 })
    {
      EngineRig rig(layout);
      ASSERT_EQ(rig.engine.open(), "");
      static_cast<void>(rig.play(0.5, comesFrom_deg, 1000));
      // Where it comes from, clockwise from -y. Half a step of the angle turns the force by at most that; half a step
      // of the force itself.
      const double turn = comesFrom_deg * M_PI / 180.0;
      const double step =
        M_PI / static_cast<double>(layout.wholeTurn) + 0.5 / static_cast<double>(layout.magnitude.max);
      EXPECT_NEAR(rig.device().force()[0], -0.5 * std::sin(turn), step) << layout.name;
      EXPECT_NEAR(rig.device().force()[1], 0.5 * std::cos(turn), step) << layout.name;
      EXPECT_EQ(rig.device().badReports, 0) << layout.name;
    }
  }
}

TEST(PidEngine, ZeroForceIsExactlyZeroAndNotANumberIsZero)
{
  for (const PidLayout& layout : test::allLayouts())
  {
    EngineRig rig(layout);
    ASSERT_EQ(rig.engine.open(), "");
    const int block = rig.play(0.0, 270.0, 1000);
    EXPECT_EQ(rig.device().force()[0], 0.0) << layout.name;
    ASSERT_TRUE(rig.engine.setConstantForce(block, std::numeric_limits<double>::quiet_NaN()));
    EXPECT_EQ(rig.device().force()[0], 0.0) << layout.name;
  }
}

TEST(PidEngine, NotANumberIsTheMiddleOfAFieldWithoutNegativeNumbers)
{
  HidField field;
  field.logicalMax = 254;
  EXPECT_EQ(signedShareToField(field, std::numeric_limits<double>::quiet_NaN()), 127);
  EXPECT_EQ(signedShareToField(field, -1.0), 0);
  EXPECT_EQ(signedShareToField(field, 1.0), 254);
}

TEST(PidEngine, ForcesOutsideTheirRangeAreCutToIt)
{
  for (const PidLayout& layout : test::allLayouts())
  {
    EngineRig rig(layout);
    ASSERT_EQ(rig.engine.open(), "");
    const int block = rig.play(1e9, 0.0, 1000);
    EXPECT_EQ(rig.device().force()[1], 1.0) << layout.name;
    ASSERT_TRUE(rig.engine.setConstantForce(block, -1e9));
    EXPECT_EQ(rig.device().force()[1], -1.0) << layout.name;
  }
}

TEST(PidEngine, AForceIsChangedInPlaceWithoutAGap)
{
  EngineRig rig(test::plainLayout());
  ASSERT_EQ(rig.engine.open(), "");
  const int block = rig.play(0.2, 270.0, 1000);
  const int before = rig.device().outputs;
  ASSERT_TRUE(rig.engine.setConstantForce(block, 0.4));
  EXPECT_EQ(rig.device().outputs, before + 1);
  EXPECT_NEAR(rig.device().force()[0], 0.4, 1e-9);
}

TEST(PidEngine, AnEffectEndsByItselfUnlessItIsStartedAgain)
{
  for (const PidLayout& layout : test::allLayouts())
  {
    EngineRig rig(layout);
    ASSERT_EQ(rig.engine.open(), "");
    const int block = rig.play(0.5, 270.0, 200);
    for (int again = 0; again < 20; ++again)
    {
      rig.bus.advance(100);
      ASSERT_EQ(rig.device().effectsPlaying(), 1) << layout.name;
      ASSERT_TRUE(rig.engine.start(block));
    }
    rig.bus.advance(250);
    EXPECT_EQ(rig.device().force()[0], 0.0) << layout.name;
  }
}

TEST(PidEngine, ADurationLongerThanTheFieldIsItsLongestAndNeverForever)
{
  HidField field;
  field.bitCount = 16;
  field.logicalMax = 32767;
  EXPECT_EQ(timeToField(field, 65535.0), 32767);
  field.logicalMax = 65535;
  EXPECT_EQ(timeToField(field, 1e9), 65534);
  field.unit = 0x1003;
  field.exponent = -4;
  EXPECT_EQ(timeToField(field, 200.0), 2000); // tenths of a millisecond
}

TEST(PidEngine, SoloStopsTheOthersAndStopStopsOne)
{
  EngineRig rig(test::officeLayout()); // whose operations stand in another order
  ASSERT_EQ(rig.engine.open(), "");
  const int first = rig.play(0.1, 270.0, 1000), second = rig.play(0.2, 270.0, 1000);
  EXPECT_EQ(rig.device().effectsPlaying(), 2);
  ASSERT_TRUE(rig.engine.startSolo(first));
  EXPECT_EQ(rig.device().effectsPlaying(), 1);
  ASSERT_TRUE(rig.engine.start(second));
  ASSERT_TRUE(rig.engine.stop(first));
  EXPECT_NEAR(rig.device().force()[0], 0.2, 0.02);
  ASSERT_TRUE(rig.engine.free(first));
  EXPECT_EQ(rig.device().effectsUsed(), 1);
}

TEST(PidEngine, ClosingStopsFreesAndLeavesTheDeviceAsItWakes)
{
  for (const PidLayout& layout : test::allLayouts())
  {
    EngineRig rig(layout);
    ASSERT_EQ(rig.engine.open(), "");
    static_cast<void>(rig.play(0.5, 270.0, 1000));
    rig.engine.close();
    EXPECT_EQ(rig.device().stopAlls, 1 + 1) << layout.name;
    EXPECT_EQ(rig.device().effectsUsed(), 0) << layout.name;
    EXPECT_EQ(rig.device().resets, 1 + 1) << layout.name;
    EXPECT_EQ(rig.device().centring(), layout.habits.wakesCentred) << layout.name;
    EXPECT_TRUE(rig.device().centring() || rig.device().force()[0] == 0.0) << layout.name;
    EXPECT_EQ(rig.device().badReports, 0) << layout.name;
  }
}

TEST(PidEngine, ASineShakesWithItsPeriod)
{
  EngineRig rig(test::plainLayout());
  ASSERT_EQ(rig.engine.open(), "");
  const PidEngine::Created made = rig.engine.create(pid::sine);
  EffectSettings settings;
  settings.type = pid::sine;
  settings.duration_ms = 1000;
  settings.comesFrom_deg = 270.0;
  ASSERT_TRUE(rig.engine.setEffect(made.value, settings));
  ASSERT_TRUE(rig.engine.setPeriodic(made.value, 0.5, 40.0));
  ASSERT_TRUE(rig.engine.start(made.value));
  for (int ms = 0; ms < 80; ++ms)
  {
    EXPECT_NEAR(rig.device().force()[0], 0.5 * std::sin(2.0 * M_PI * ms / 40.0), 1e-4) << ms;
    rig.bus.advance(1);
  }
}

TEST(PidEngine, ADriverManagedPoolIsRefusedByName)
{
  EngineRig none(test::driverManagedLayout());
  EXPECT_NE(none.engine.open().find("driver-managed pool"), std::string::npos);
  PidLayout said = test::plainLayout();
  said.deviceManaged = false;
  EngineRig rig(said);
  EXPECT_NE(rig.engine.open().find("driver-managed pool"), std::string::npos);
  EXPECT_EQ(rig.device().outputs, 0);
}

TEST(PidEngine, AFullPoolIsSaidWithTheCure)
{
  PidLayout small = test::plainLayout();
  small.slots = 1;
  EngineRig rig(small);
  ASSERT_EQ(rig.engine.open(), "");
  EXPECT_EQ(rig.engine.create(pid::spring).problem, "");
  const PidEngine::Created second = rig.engine.create(pid::damper);
  EXPECT_EQ(second.value, 0);
  EXPECT_NE(second.problem.find("full"), std::string::npos);
  EXPECT_NE(second.problem.find("close other programs"), std::string::npos);
}

TEST(PidEngine, AnEffectTheDeviceDoesNotHaveIsNotAskedFor)
{
  PidLayout layout = test::plainLayout();
  layout.effects = { 0x26 };
  EngineRig rig(layout);
  ASSERT_EQ(rig.engine.open(), "");
  EXPECT_FALSE(rig.engine.supports(pid::spring));
  EXPECT_NE(rig.engine.create(pid::spring).problem, "");
  EXPECT_EQ(rig.device().badReports, 0);
}

TEST(PidEngine, ASlowBlockLoadIsAwaitedButNotForEver)
{
  EngineRig rig(test::plainLayout());
  ASSERT_EQ(rig.engine.open(), "");
  rig.device().slowLoads = 30;
  EXPECT_EQ(rig.engine.create(pid::spring).problem, "");
  rig.device().slowLoads = 1000;
  EXPECT_NE(rig.engine.create(pid::spring).problem.find("does not confirm"), std::string::npos);
}

TEST(PidEngine, FeatureRequestsThatTimeOutComeShortOrWithAnotherIdAreSaid)
{
  EngineRig late(test::plainLayout());
  late.port.featureTimesOut = true;
  EXPECT_NE(late.engine.open().find("timed out"), std::string::npos);
  EngineRig cut(test::plainLayout());
  cut.port.shortFeature = 2;
  EXPECT_NE(cut.engine.open().find("2 bytes instead of 5"), std::string::npos);
  EngineRig other(test::plainLayout());
  ASSERT_EQ(other.engine.open(), "");
  other.device().wrongLoad = std::vector<std::uint8_t>{ 0x77, 1, 1, 0, 0 };
  const PidEngine::Created made = other.engine.create(pid::spring);
  EXPECT_EQ(made.value, 0);
  EXPECT_NE(made.problem.find("report 34 came as 119"), std::string::npos) << made.problem;
}

TEST(PidEngine, ABlockOfZeroIsNotBelieved)
{
  EngineRig rig(test::plainLayout());
  ASSERT_EQ(rig.engine.open(), "");
  rig.device().wrongLoad = std::vector<std::uint8_t>{ 0x22, 0, 1, 0, 0 }; // success, in no block
  EXPECT_EQ(rig.engine.create(pid::spring).value, 0);
}

TEST(PidEngine, UnpluggingAtAnyStepOfOpeningIsSaidAndEndsSoon)
{
  int steps = 0;
  for (bool opened = false; !opened; ++steps)
  {
    EngineRig rig(test::plainLayout());
    rig.port.callsUntilUnplugged = steps;
    const std::string problem = rig.engine.open();
    const PidEngine::Created made = problem.empty() ? rig.engine.create(pid::spring) : PidEngine::Created{ 0, problem };
    opened = made.problem.empty();
    EXPECT_TRUE(opened || made.problem.find("No such device") != std::string::npos) << steps << ": " << made.problem;
    ASSERT_LT(steps, 100);
  }
  EXPECT_GT(steps, 5); // pool, reset, enable, gain, create, load
}

TEST(PidEngine, StateReportsAreReadAndOthersAreNotTakenForOne)
{
  EngineRig rig(test::plainLayout());
  const std::vector<std::uint8_t> off{ 0x02, 0x10, 0x00 }, playing{ 0x02, 0x12, 0x0F };
  ASSERT_TRUE(rig.engine.state(off));
  EXPECT_FALSE(rig.engine.state(off)->actuatorsEnabled);
  EXPECT_TRUE(rig.engine.state(playing)->actuatorsEnabled);
  EXPECT_TRUE(rig.engine.state(playing)->playing);
  EXPECT_EQ(rig.engine.state(playing)->block, 7);
  EXPECT_FALSE(rig.engine.state(std::vector<std::uint8_t>{ 0x01, 0x10, 0x00 }));
  EXPECT_FALSE(rig.engine.state(std::vector<std::uint8_t>{ 0x02, 0x10 }));
}

TEST(PidEngine, ADescriptorWithoutForceFeedbackIsRefused)
{
  const ReportDescriptor broken = parseReportDescriptor({});
  EXPECT_NE(PidEngine::refusal(broken).find("report descriptor"), std::string::npos);
  PidLayout layout = test::plainLayout();
  const std::vector<std::uint8_t> whole = descriptorOf(layout);
  const std::vector<std::uint8_t> joystick{ 0x05, 0x01, 0x09, 0x04, 0xA1, 0x01, 0x09, 0x30, 0x75, 0x08, 0x95, 0x01,
    0x81, 0x02, 0xC0 };
  EXPECT_NE(PidEngine::refusal(parseReportDescriptor(joystick)).find("no force"), std::string::npos);
  EXPECT_EQ(PidEngine::refusal(parseReportDescriptor(whole)), "");
}

} // namespace
} // namespace palpate
