// SPDX-License-Identifier: GPL-3.0-or-later
// A simulated device that feels torque holds the ball among loose sources: it comes to rest, and is given no energy.
#include <cmath>

#include <gtest/gtest.h>

#include "devices/simulated/SimulatedDevice.h"
#include "haptics/safety/HandLimits.h"
#include "haptics/session/HapticSession.h"
#include "haptics/tool/motion/Turn.h"
#include "testing/haptics/session/LooseStones.h"
#include "testing/haptics/session/WatchedHand.h"

namespace palpate::test
{
namespace
{

/// Presses the stone on the floor, goes to and fro and turns for a second, then holds still.
Pose swayingHand_W(double time_s)
{
  const double pressed_m = 1e-3 * std::min(time_s / 0.3, 1.0), sways = time_s < 1.0 ? std::sin(12.0 * time_s) : 0.0;
  return { Vec3(2e-3 * sways, 0.0, 2.0 * half_m.z() + fingertip_m + 5e-4 - 2.5 * pressed_m),
    turnBy(Vec3(0.2 * sways, 0.3 * sways, 0.1 * sways)) };
}

constexpr double friction = 0.5;

/// A ball in the hand, and the stone on the floor.
void beginAmongStones(HapticSession& session, HapticParameters parameters)
{
  parameters.contact.radius_u = fingertip_m;
  parameters.contact.friction = { friction, friction };
  parameters.safety = SafetyLimits::none();
  EXPECT_EQ(session.setParameters(parameters), "");
  session.setScene(sceneOfAll({ floorInput(), stoneInput() }));
  session.setLoose(stones());
}

SessionOptions virtualTime()
{
  SessionOptions options;
  options.virtualTime = true;
  return options;
}

WatchedHand rub(const HandModel& hand)
{
  HapticSession session;
  HapticParameters parameters;
  parameters.stiffness_N_per_m = 1000.0;
  beginAmongStones(session, parameters);
  auto made =
    std::make_unique<SimulatedDevice>(*deviceModel("simulated-6d"), hand, HandPath{ { swayingHand_W(0.0).p } });
  SimulatedDevice& device = *made;
  EXPECT_EQ(session.start(std::move(made), virtualTime()), "");
  return watchHand(session, device, swayingHand_W, 1600, 200);
}

TEST(BallAmongLoose, ComesToRestInAHandThatFeelsTorque)
{
  const DeviceModel& device = *deviceModel("simulated-6d");
  const double allowance_J = handLimits(0.1, 3.0).excess_J / 5.0; // as of a tool
  for (const HandModel& hand : handModels())
  {
    if (hand.stiffness_N_per_m == 0.0)
    {
      continue; // nobody holds it
    }
    const WatchedHand seen = rub(hand);
    SCOPED_TRACE(hand.name);
    EXPECT_EQ(seen.fault, Fault::None);
    EXPECT_GT(seen.pressed_N, 0.2);
    EXPECT_LE(seen.trembles_m, device.encoderStep_m);
    EXPECT_LE(seen.trembles_rad, device.turning.step_rad);
    EXPECT_LE(seen.excess_J, allowance_J);
  }
}

/// The stability of a hand's turn is judged for a spring K L^2 with L no longer than the ball's bounds reach, sqrt(3)
/// R: so much torque there is per turn of the ball against the hand, however stiff the spring is that keeps it upright.
TEST(BallAmongLoose, IsFeltToTurnByTheSpringOfTheLeverThatTheDampersAndLimitsAreOf)
{
  constexpr double deep_m = 5e-4;
  HapticSession session;
  HapticParameters parameters;
  parameters.stiffness_N_per_m = firm_N_per_m;
  parameters.limitStiffness = false;
  beginAmongStones(session, parameters);
  auto device = std::make_unique<FedDevice>();
  FedDevice& fed = *device;
  Pose hand{ Vec3(0.2, 0.2, fingertip_m + 1e-3), Quat::Identity() };
  fed.feed(sampleAt(hand));
  ASSERT_EQ(session.start(std::move(device), virtualTime()), "");
  session.step(200);
  for (; hand.p.z() > fingertip_m - deep_m; hand.p.z() -= 1e-5)
  {
    fed.feed(sampleAt(hand));
    session.step(1);
  }
  for (int i = 0; i < 500; ++i) // it slides
  {
    hand.p.y() += 2e-5;
    fed.feed(sampleAt(hand));
    session.step(1);
  }
  const HapticState& state = session.state();
  const double turn_rad = turnFromTo(state.mechanism.hand_W.q, state.proxy_W.q).norm();
  const double ofContact_Nm = friction * state.force_W.z() * fingertip_m;
  EXPECT_NEAR(firm_N_per_m * std::pow(50.0 * fingertip_m, 2) * turn_rad, ofContact_Nm, 0.02 * ofContact_Nm);
  const double felt_Nm = 3.0 * firm_N_per_m * fingertip_m * fingertip_m * turn_rad;
  EXPECT_NEAR(state.torque_D.norm(), felt_Nm, 0.01 * felt_Nm);
}

} // namespace
} // namespace palpate::test
