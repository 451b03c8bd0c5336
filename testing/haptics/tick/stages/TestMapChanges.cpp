// SPDX-License-Identifier: GPL-3.0-or-later
// Another map between hand and scene: the force goes on without a step, and no surface swallows a hand.
#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "haptics/session/plan/HandMap.h"
#include "haptics/tick/ForceRenderer.h"
#include "testing/haptics/tick/stages/Tick.h"
#include "testing/support/Meshes.h"
#include "testing/support/Random.h"

namespace palpate
{
namespace
{

using test::dt_s;

constexpr double radius_m = 0.05, sphere_N_per_m = 500.0;

/// A device that a test leads, and a sphere whose middle is the origin.
struct Hand
{
  std::shared_ptr<const Scene> scene = test::sceneOf(test::makeIcosphere(4, radius_m));
  HapticParameters parameters;
  RendererState state;
  std::uint64_t tick = 0;

  Hand()
  {
    this->parameters.stiffness_N_per_m = sphere_N_per_m;
    this->parameters.safety = SafetyLimits::none();
    this->parameters.passivity.enabled = false;
    this->parameters.keepsHand = true;
  }

  TickOutput at(const Vec3& p_D)
  {
    TickInput input;
    input.tick = ++this->tick;
    input.dt_s = dt_s;
    input.scene = this->scene.get();
    input.sample.time_s = dt_s * static_cast<double>(this->tick);
    input.sample.pose_D.p = p_D;
    return renderTick(input, this->parameters, this->state);
  }

  /// From outside to that place.
  TickOutput press(const Vec3& p_D)
  {
    static_cast<void>(this->at(1.2 * radius_m * p_D.normalized()));
    return this->at(p_D);
  }
};

Quat smallTurn(test::Random& random)
{
  return Quat(Eigen::AngleAxisd(random.uniform(-0.1, 0.1), random.direction()));
}

// F of the tick that takes the map is F of the tick before, and goes to the force of the new map like exp(-t / tau).
TEST(MapChanges, ATurnAboutAPressingHandStepsNoForceAndTheForceTurnsInTheBlendTime)
{
  test::Random random(test::testSeed(161));
  for (std::size_t i = 0; i < test::testCount(200); ++i)
  {
    Hand hand;
    const Vec3 p_D = (radius_m - random.uniform(0.0005, 0.003)) * random.direction();
    const TickOutput before = hand.press(p_D);
    ASSERT_GT(before.command.wrench_D.force.norm(), 0.2);
    WorkspaceMap turned = hand.parameters.map;
    turned.q_WD = smallTurn(random) * turned.q_WD;
    hand.parameters.map = keepingHand(turned, { p_D, before.state.device_W.p });
    const TickOutput after = hand.at(p_D);
    EXPECT_LT((after.command.wrench_D.force - before.command.wrench_D.force).norm(), 1e-9) << i;
    EXPECT_LT((after.state.proxy_W.p - before.state.proxy_W.p).norm(), 1e-9) << "and the proxy stays";
    const double share = hand.parameters.sceneBlend_s / (hand.parameters.sceneBlend_s + dt_s);
    const Vec3 new_D = hand.parameters.map.directionToDevice(before.state.force_W);
    const Vec3 next_D = new_D + share * (before.command.wrench_D.force - new_D);
    EXPECT_LT((hand.at(p_D).command.wrench_D.force - next_D).norm(), 1e-9);
  }
}

// The nearest that a program knows of a hand is a tick or a frame old: so far the hand moves in the scene.
TEST(MapChanges, ThatMoveAHandALittleIntoASurfaceAreHeldBackByItAndStepNoForce)
{
  test::Random random(test::testSeed(162));
  for (std::size_t i = 0; i < test::testCount(200); ++i)
  {
    Hand hand;
    const Vec3 outward = random.direction();
    const Vec3 p_D = (radius_m + 0.0005) * outward;
    static_cast<void>(hand.at(p_D));
    hand.parameters.map.offset_W = -random.uniform(0.001, 0.0045) * outward;
    const TickOutput after = hand.at(p_D);
    EXPECT_LT(after.command.wrench_D.force.norm(), 1e-12) << "as before";
    EXPECT_GT(after.state.contacts, 0);
    for (int more = 0; more < 600; ++more) // twenty blend times
    {
      static_cast<void>(hand.at(p_D));
    }
    const TickOutput rest = hand.at(p_D);
    const Vec3 pushed_D = sphere_N_per_m * (rest.state.proxy_W.p - rest.state.device_W.p);
    EXPECT_GT(pushed_D.dot(outward), 0.0) << "out, not through";
    EXPECT_LT((rest.command.wrench_D.force - pushed_D).norm(), 1e-6);
  }
}

TEST(MapChanges, ThatPutAHandElsewhereHaveItBeginThereAndItsOldForceFade)
{
  Hand hand;
  const TickOutput before = hand.press({ 0, 0, radius_m - 0.002 });
  hand.parameters.map.offset_W = { 0, 0, 0.04 };
  double last_N = before.command.wrench_D.force.norm();
  for (int tick = 0; tick < 300; ++tick)
  {
    const TickOutput now = hand.at({ 0, 0, radius_m - 0.002 });
    EXPECT_EQ(now.state.contacts, 0);
    EXPECT_LE(
      std::fabs(last_N - now.command.wrench_D.force.norm()), 1.01 * last_N * dt_s / hand.parameters.sceneBlend_s);
    last_N = now.command.wrench_D.force.norm();
  }
  EXPECT_LT(last_N, 1e-3);
}

TEST(MapChanges, ThatPutAHandIntoASurfaceWithAPlaceToComeFromLeaveTheBallOutside)
{
  Hand hand;
  static_cast<void>(hand.at({ 0, 0, 0.2 }));
  hand.parameters.map.offset_W = { 0, 0, -0.16 };
  hand.parameters.ballLead = { 1, hand.scene->geometryHash(), { 0, 0, 0.2 } };
  const TickOutput after = hand.at({ 0, 0, 0.2 });
  EXPECT_NEAR(after.state.device_W.p.z(), 0.04, 1e-12) << "10 mm deep";
  EXPECT_NEAR(after.state.proxy_W.p.z(), radius_m, 0.002) << "on the facets of the sphere";
  EXPECT_LT(after.command.wrench_D.force.norm(), 1e-12) << "no step";
}

TEST(MapChanges, WhileTheClutchIsHeldNothingMovesTheHandAndNothingPushesIt)
{
  Hand hand;
  hand.parameters.safety.releaseRamp_s = 0.05;
  hand.parameters.safety.engageRamp_s = 0.2;
  const Vec3 p_D(0, 0, radius_m - 0.002);
  const TickOutput before = hand.press(p_D);
  hand.parameters.clutch = true;
  test::Random random(test::testSeed(163));
  double last_N = before.command.wrench_D.force.norm();
  Vec3 handle_D = p_D;
  for (int tick = 0; tick < 200; ++tick)
  {
    handle_D += 0.0005 * random.direction();
    const TickOutput now = hand.at(handle_D);
    ASSERT_EQ(now.state.device_W.p, before.state.device_W.p);
    ASSERT_EQ(now.state.handle_D, handle_D);
    ASSERT_LT((now.state.proxy_W.p - before.state.proxy_W.p).norm(), 1e-12);
    ASSERT_LE(now.command.wrench_D.force.norm(), last_N + 1e-12) << "it only goes down";
    last_N = now.command.wrench_D.force.norm();
    EXPECT_TRUE(tick < 52 || last_N == 0.0) << "within the ramp of a release";
  }
  hand.parameters.clutch = false;
  hand.parameters.map = keepingHand(hand.parameters.map, { handle_D, before.state.device_W.p });
  for (int tick = 0; tick < 250; ++tick)
  {
    const TickOutput now = hand.at(handle_D);
    ASSERT_LT((now.state.device_W.p - before.state.device_W.p).norm(), 1e-12) << "it goes on from where it is";
    const double force_N = now.command.wrench_D.force.norm();
    ASSERT_LT(force_N - last_N, 2.0 * before.command.wrench_D.force.norm() * dt_s / 0.2) << "over the engage ramp";
    last_N = force_N;
  }
  EXPECT_NEAR(last_N, before.command.wrench_D.force.norm(), 1e-9);
}

} // namespace
} // namespace palpate
