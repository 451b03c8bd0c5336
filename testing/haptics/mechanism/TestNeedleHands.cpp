// SPDX-License-Identifier: GPL-3.0-or-later
// Simulated hands push a needle through an abdominal wall into a liver and pull it out again, 100 strokes each, at 1
// kHz.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "devices/simulated/SimulatedDevice.h"
#include "haptics/force/PassivityController.h"
#include "haptics/force/VelocityEstimator.h"
#include "haptics/force/VirtualCoupling.h"
#include "testing/support/MechanismRig.h"

namespace palpate::test
{
namespace
{

constexpr double stiffness = 500.0, rodLength = 0.1, wallAt = 0.1, liverAt = 0.115, inside_m = 0.03, outside_m = -0.005;

/// What a hand did, tick by tick.
struct Strokes
{
  std::vector<double> force_N; ///< along the shaft
  double largestStep_N = 0.0;  ///< of the laws' force, beyond what the hand moved times the stiffness
  double given_J = 0.0;        ///< by the hand so far
  double leastGiven_J = 0.0;   ///< where it touched nothing
  int punctured = 0;
  int withdrawn = 0;
  bool finite = true;
  double last_m = 0.0;
  double speed_m_per_s = 0.0;
};

class NeedleHands : public testing::TestWithParam<HandModel>
{
protected:
  [[nodiscard]] static bool held() { return GetParam().stiffness_N_per_m > 0.0; }

  /// Back and forth so many times; whom nobody holds lies on the wall by its weight.
  static Strokes play(int strokes)
  {
    MechanismRig rig(rodLength);
    rig.grip = { stiffness, 0.0 };
    rig.addSoft("wall", springWall("wall", Vec3(0.0, 0.0, wallAt), -Vec3::UnitZ(), 0.05, 1.0 / 800.0));
    rig.addSoft("liver", springWall("liver", Vec3(0.0, 0.0, liverAt), -Vec3::UnitZ(), 0.05, 1.0 / 300.0));
    for (const auto& [name, strength, rubs] : { std::tuple("wall", 1.5, 0.4), std::tuple("liver", 0.7, 0.2) })
    {
      MechanismLaw& law = rig.join(LawKind::Puncture, name, Vec3::Zero(), Vec3::Zero());
      law.strength_N = strength;
      law.dryFriction_N = rubs;
      law.friction = 1.0; // the device leaves the turn free: on a tip that slides the rod would fall over
    }
    SimulationOptions options;
    options.push_D = held() ? Vec3(Vec3::Zero()) : Vec3(0.0, 0.0, 0.5);
    HandPath path{ { Vec3(0.0, 0.0, held() ? outside_m : -2e-4), Vec3(1e-3, 2e-3, inside_m) }, 0.15 };
    SimulatedDevice device(*deviceModel("simulated-generic"), GetParam(), path, options);
    EXPECT_EQ(device.open(), "");
    const double way = 2.0 * (path.points_D[1] - path.points_D[0]).norm() / path.speed_m_per_s;
    return loop(rig, device, static_cast<int>(1000.0 * way * strokes));
  }

  static Strokes loop(MechanismRig& rig, SimulatedDevice& device, int ticks)
  {
    Strokes s;
    EnergyMeter energy;
    VelocityHistory history;
    PassivityPlan passivity;
    passivity.enabled = true;
    Vec3 before_D = Vec3::Zero(), lastForce = Vec3::Zero(), lastWrench = Vec3::Zero();
    for (int tick = 0; tick < ticks; ++tick)
    {
      DeviceSample sample;
      EXPECT_EQ(device.read(1e-3 * tick, sample), DeviceStatus::Ok);
      const Vec3 p_D = sample.pose_D.p;
      const Vec3 way_D = tick > 0 ? Vec3(p_D - before_D) : Vec3(Vec3::Zero());
      const MechanismResult& r = rig.step(p_D);
      const Vec3 pull_m = r.wrench_W.force / stiffness;
      const Vec3 velocity = estimateVelocity(VelocityFilter{}, p_D, 1e-3, history);
      SpringTick spring;
      spring.stretch_m = std::sqrt(2.0 * r.stored_Nu / stiffness);
      spring.stiffness_N_per_m = stiffness;
      spring.inward_m_per_s = pull_m.norm() > 0.0 ? -pull_m.dot(velocity) / pull_m.norm() : 0.0;
      spring.work_J = lastForce.dot(way_D);
      measureEnergy(spring, energy);
      const Vec3 force = coupleDevice(pull_m, velocity, stiffness, stabilisingDamping(passivity, spring, energy));
      DeviceCommand command;
      command.wrench_D.force = force;
      device.write(command);

      s.given_J -= lastForce.dot(way_D);
      s.leastGiven_J = r.rows == 0 ? std::min(s.leastGiven_J, s.given_J) : s.leastGiven_J;
      s.largestStep_N = std::max(s.largestStep_N, (r.wrench_W.force - lastWrench).norm() - stiffness * way_D.norm());
      s.finite = s.finite && force.allFinite() && !r.capped && r.residual_u <= 1e-12;
      for (int e = 0; e < r.eventCount; ++e)
      {
        s.punctured += r.events[e].change == LawChange::Punctured;
        s.withdrawn += r.events[e].change == LawChange::Withdrawn;
      }
      s.force_N.push_back(force.z());
      s.speed_m_per_s = device.speed_D().norm();
      s.last_m = p_D.z();
      before_D = p_D;
      lastForce = force;
      lastWrench = r.wrench_W.force;
    }
    return s;
  }
};

TEST_P(NeedleHands, StayStableAndGetNoEnergyAndNoStepAboveTheLimit)
{
  const int strokes = 100;
  const Strokes s = play(strokes);
  EXPECT_TRUE(s.finite);
  // A law's change is felt by so much at once; what was spread of it fades by a thirtieth a tick.
  EXPECT_LE(s.largestStep_N, ToolBlend::largestStep_N + 1.5 / 30.0);
  EXPECT_GE(s.leastGiven_J, -1e-5);
  if (!held())
  {
    EXPECT_EQ(s.punctured, 0);
    EXPECT_LE(s.speed_m_per_s, 1e-3);
    return;
  }
  // Both tissues in every stroke, but for the last one, which may end on its way.
  EXPECT_GE(s.punctured, 2 * (strokes - 1));
  EXPECT_GE(s.withdrawn, 2 * (strokes - 1));
  EXPECT_GT(s.given_J, strokes * 0.2e-3); // what friction and punctures take
}

TEST_P(NeedleHands, TheSameStrokesHaveTheSameBits)
{
  EXPECT_EQ(play(3).force_N, play(3).force_N);
}

INSTANTIATE_TEST_SUITE_P(All, NeedleHands, testing::ValuesIn(handModels()),
  [](const testing::TestParamInfo<HandModel>& info) { return info.param.name; });

/// A rod that a hand leads in and sideways.
Pose wayOf(int tick)
{
  return { Vec3(1e-3 * std::sin(0.01 * tick), 0.0, outside_m + 4e-5 * tick), Quat::Identity() };
}

TEST(NeedleRecording, GoesOnBitForBitFromTheStateOfAnyTick)
{
  MechanismRig whole(rodLength);
  MechanismRig part(rodLength);
  for (MechanismRig* rig : { &whole, &part })
  {
    rig->addSoft("wall", springWall("wall", Vec3(0.0, 0.0, wallAt), -Vec3::UnitZ(), 0.05, 1.0 / 800.0));
    MechanismLaw& law = rig->join(LawKind::Puncture, "wall", Vec3::Zero(), Vec3::Zero());
    law.strength_N = 1.5;
    law.dryFriction_N = 0.4;
    rig->plan();
  }
  constexpr int from = 260, ticks = 600;
  for (int tick = 0; tick < ticks; ++tick)
  {
    if (tick == from)
    {
      part.tick.restore(whole.tick.state());
    }
    const Vec3 all = whole.step(wayOf(tick)).wrench_W.force;
    if (tick >= from)
    {
      EXPECT_EQ(part.step(wayOf(tick)).wrench_W.force, all) << tick;
    }
  }
}

} // namespace
} // namespace palpate::test
