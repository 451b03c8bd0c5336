// SPDX-License-Identifier: GPL-3.0-or-later
// A hand that turns holds a tool by a simulated device with six axes: pressed flat, tipped, in a slot, on a screw.
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "devices/simulated/SimulatedDevice.h"
#include "haptics/force/StabilityLimits.h"
#include "haptics/safety/HandLimits.h"
#include "haptics/session/HapticSession.h"
#include "haptics/session/SessionWorkers.h"
#include "haptics/session/tool/ToolChoice.h"
#include "haptics/tool/motion/Turn.h"
#include "testing/haptics/session/WatchedHand.h"
#include "testing/support/Meshes.h"
#include "testing/support/Thread.h"

namespace palpate::test
{
namespace
{

constexpr double tick_s = 1e-3;

/// A hand's task with a tool. In m; it begins at the pose of the time 0 and holds still from restFrom_s on.
struct Deed
{
  std::string name;
  TriangleMesh tool, scene;
  std::function<Pose(double time_s)> hand_W;
  double restFrom_s = 2.0;
};

/// Rises from 0 to 1 within two times and stays.
double ramp(double time_s, double from_s, double to_s)
{
  return std::clamp((time_s - from_s) / (to_s - from_s), 0.0, 1.0);
}

double swing(double time_s, double rate_Hz, double until_s)
{
  return time_s < until_s ? std::sin(2.0 * std::numbers::pi * rate_Hz * time_s) : 0.0;
}

Deed pressedFlat()
{
  constexpr double half = 0.02;
  Random random(testSeed(1821));
  return { "pressed flat", makeBox(Vec3::Constant(-half), Vec3::Constant(half)),
    makeSheet({ 0.4, 0.4, 8, 8, 0.3 }, random), [](double s) {
      return Pose{ Vec3(0.005 * swing(s, 2.0, 2.0), 0, half + 0.002 - 0.006 * ramp(s, 0.2, 0.4)), Quat::Identity() };
    } };
}

Deed tipped()
{
  Deed deed = pressedFlat();
  deed.name = "tipped";
  deed.hand_W = [flat = deed.hand_W](double s)
  {
    Pose hand = flat(s);
    hand.q = turnBy(ramp(s, 0.5, 0.6) * Vec3(0.1 + 0.2 * swing(s, 3.0, 2.0), 0.3 * swing(s, 1.5, 2.0), 0.0));
    return hand;
  };
  return deed;
}

Deed inSlot()
{
  constexpr double half = 0.01, room = 1e-4;
  TriangleMesh slot = makeBox(Vec3(-0.04, -0.03, -0.04), Vec3(-half - room, 0.03, 0.0));
  append(slot, makeBox(Vec3(half + room, -0.03, -0.04), Vec3(0.04, 0.03, 0.0)));
  return { "in the slot", makeBox(Vec3(-half, -0.01, -0.02), Vec3(half, 0.01, 0.02)), slot,
    [](double s)
    {
      const double pushed = ramp(s, 1.0, 1.1);
      return Pose{ Vec3(0.004 * pushed * swing(s, 2.0, 2.0), 0, 0.021 - 0.015 * ramp(s, 0.2, 0.8)),
        turnBy(pushed * Vec3(0, 0.2 * swing(s, 3.0, 2.0), 0.0)) };
    } };
}

Deed onScrew()
{
  constexpr double pitch = 0.004, room = 2e-4, lead = pitch / (2.0 * std::numbers::pi);
  const ThreadSize screw{ 0.01, pitch, 0.04 }, bore{ 0.01 + room, pitch, 0.012 };
  return { "on the screw", threadMesh(bore, 32), threadMesh(screw, 32),
    [](double s)
    {
      const double turn = 1.5 * ramp(s, 0.2, 1.0);
      return Pose{ Vec3(0.001 * swing(s, 2.0, 2.0), 0, lead * turn + 0.002 * ramp(s, 1.2, 1.4)),
        turnBy(Vec3(0, 0.05 * swing(s, 1.5, 2.0), turn)) };
    } };
}

WatchedHand play(const Deed& deed, const HandModel& hand)
{
  HapticParameters parameters;
  parameters.stiffness_N_per_m = 1000.0;
  parameters.safety = SafetyLimits::none();
  HapticSession session;
  EXPECT_EQ(session.setParameters(parameters), "");
  session.setScene(sceneOf(deed.scene));
  session.choose<ToolTask>({ std::make_shared<const ToolMesh>(makeTool(deed.tool, Vec3(Vec3::Zero())).value), 0.0 });
  SessionOptions options;
  options.virtualTime = true;
  auto made = std::make_unique<SimulatedDevice>(*deviceModel("simulated-6d"), hand, HandPath{ { deed.hand_W(0.0).p } });
  SimulatedDevice& device = *made;
  EXPECT_EQ(session.start(std::move(made), options), "");
  const int ticks = static_cast<int>((deed.restFrom_s + 0.4) / tick_s);
  return watchHand(session, device, deed.hand_W, ticks, 200);
}

} // namespace

TEST(TurningHand, ComesToRestWithEveryDeedIsGivenNoEnergyAndFeelsNoStep)
{
  const DeviceModel& device = *deviceModel("simulated-6d");
  const double allowance_J = handLimits(0.1, 3.0).excess_J / 5.0; // a fifth of the excess that ends the force of a
                                                                  // device of 3 N
  for (const Deed& deed : { pressedFlat(), tipped(), inSlot(), onScrew() })
  {
    for (const HandModel& hand : handModels())
    {
      if (hand.stiffness_N_per_m == 0.0)
      {
        continue; // nobody holds it
      }
      const WatchedHand seen = play(deed, hand);
      SCOPED_TRACE(deed.name + ", " + hand.name);
      EXPECT_EQ(seen.fault, Fault::None);
      EXPECT_GT(seen.pressed_N, 0.2) << "what is not felt shows nothing";
      EXPECT_LE(seen.trembles_m, device.encoderStep_m);
      EXPECT_LE(seen.trembles_rad, device.turning.step_rad);
      EXPECT_LE(seen.excess_J, allowance_J);
      EXPECT_LE(seen.step_N, 0.2);
    }
  }
}

TEST(TurningHand, WithALongLeverIsGivenTheStiffnessThatItsTurnsHold)
{
  HapticSession session;
  HapticParameters parameters;
  parameters.stiffness_N_per_m = 1e5;
  ASSERT_EQ(session.setParameters(parameters), "");
  SessionOptions options;
  options.virtualTime = true;
  ASSERT_EQ(session.start(std::make_unique<SimulatedDevice>(
                            *deviceModel("simulated-6d"), *handModel("light"), HandPath{ { Vec3::Zero() } }),
              options),
    "");
  session.step(2);
  const double ofWays_N_per_m = session.state().stiffness_N_per_m;
  const auto tool =
    std::make_shared<const ToolMesh>(makeTool(makeBox(Vec3::Constant(-0.1), Vec3::Constant(0.1))).value);
  session.choose<ToolTask>({ tool, 3.0 });
  session.step(2);
  EXPECT_LT(session.state().stiffness_N_per_m, 0.5 * ofWays_N_per_m);
  EXPECT_DOUBLE_EQ(session.state().stiffness_N_per_m, 0.8 * session.limits().turning_N_per_m);
  EXPECT_EQ(session.limits().decides, StiffnessLimit::Turning);
  session.choose<ToolTask>({});
  session.step(2);
  EXPECT_EQ(session.state().stiffness_N_per_m, ofWays_N_per_m);
}

} // namespace palpate::test
