// SPDX-License-Identifier: GPL-3.0-or-later
// Simulated hands push a wire round a bend and pull it back. 4 s each; a minute with PALPATE_TEST_FULL.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "devices/simulated/SimulatedDevice.h"
#include "haptics/session/HapticSession.h"
#include "haptics/session/mechanism/MechanismChoice.h"
#include "haptics/session/mechanism/MechanismTouch.h"
#include "testing/support/LongForm.h"
#include "testing/support/WireTube.h"

namespace palpate::test
{
namespace
{

constexpr double mm_per_m = 1000.0;

struct WireHand
{
  HandModel hand;
  double friction = 0.0;
};

std::vector<WireHand> wireHands()
{
  std::vector<WireHand> all;
  for (const HandModel& hand : handModels())
  {
    all.push_back({ hand, 0.0 });
    all.push_back({ hand, 0.1 });
  }
  return all;
}

class WireHands : public testing::TestWithParam<WireHand>
{
protected:
  [[nodiscard]] static MechanismInputs inputs()
  {
    const Tube tube{ .first_mm = 10.0, .angle_rad = 0.5 * std::numbers::pi, .last_mm = 40.0, .ring_mm = 0.5 };
    MechanismBody body;
    body.name = "wire";
    body.kind = MechanismBodyKind::Wire;
    body.wire =
      std::make_shared<const PlannedWire>(planWire(nitinolWire(100.0, 24, GetParam().friction), tube.mesh(), 1));
    MechanismInputs inputs;
    inputs.mechanism.bodies = { body };
    inputs.unit_m = 1.0 / mm_per_m;
    return inputs;
  }

  void begin()
  {
    HapticParameters p;
    p.stiffness_N_per_m = 1000.0;
    p.map.scale_u_per_m = mm_per_m;
    p.safety = SafetyLimits::none();
    ASSERT_EQ(this->session.setParameters(p), "");
    this->session.choose<MechanismTask>({ std::make_shared<const MechanismInputs>(inputs()), "wire", 30.0 });
    SimulationOptions simulated;
    simulated.push_D = Vec3(this->held() ? 0.0 : 0.05, 0.0, 0.0); // a device that nobody holds is pushed
    SessionOptions options;
    options.virtualTime = true;
    options.engage = true;
    const HandPath path{ { Vec3::Zero(), Vec3(0.055, 0.0, 0.0) }, 0.1 };
    ASSERT_EQ(this->session.start(
                std::make_unique<SimulatedDevice>(*deviceModel("simulated-generic"), GetParam().hand, path, simulated),
                options),
      "");
  }

  [[nodiscard]] bool held() const { return GetParam().hand.stiffness_N_per_m > 0.0; }

  HapticSession session;
};

/// A wire before the bend stores no energy: whatever the hand gets beyond its own work since then was made.
TEST_P(WireHands, GetNoEnergyFromAWireThatTheyPushAndPull)
{
  this->begin();
  const int ticks = (isLongForm() ? 60 : 4) * 1000;
  double given_J = 0.0, home_J = 0.0, least_J = 0.0, most_N = 0.0, furthest_mm = 0.0;
  HapticState before = this->session.state();
  for (int i = 0; i < ticks; ++i)
  {
    ASSERT_EQ(this->session.step(1), 1);
    const HapticState& now = this->session.state();
    given_J -= before.force_W.dot(now.device_W.p - before.device_W.p) / mm_per_m;
    constexpr double straight_mm = 8.0; // the wire ends before the bend, and stores nothing
    home_J = now.device_W.p.x() < straight_mm ? std::max(home_J, given_J) : home_J;
    least_J = std::min(least_J, given_J - home_J);
    most_N = std::max(most_N, now.force_W.norm());
    furthest_mm = std::max(furthest_mm, now.device_W.p.x());
    before = now;
  }
  RecordProperty("least_mJ", std::to_string(1e3 * least_J));
  RecordProperty("most_N", std::to_string(most_N));
  EXPECT_GE(least_J, -5e-3);
  EXPECT_GT(most_N, this->held() ? 0.1 : 0.05);
  EXPECT_LE(most_N, 1.0) << "stable";
  EXPECT_GT(furthest_mm, 20.0) << "it went round the bend";
}

INSTANTIATE_TEST_SUITE_P(EveryHand, WireHands, testing::ValuesIn(wireHands()),
  [](const testing::TestParamInfo<WireHand>& info)
  { return info.param.hand.name + (info.param.friction > 0.0 ? "Rubbing" : "Smooth"); });

} // namespace
} // namespace palpate::test
