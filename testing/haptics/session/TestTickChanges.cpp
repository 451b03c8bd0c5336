// SPDX-License-Identifier: GPL-3.0-or-later
// Changes around the tick while the hand presses.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "haptics/tick/ForceRenderer.h"
#include "testing/support/Meshes.h"

namespace palpate
{
namespace
{

/// Ticks one after the other, without limits.
class Hand
{
public:
  Hand() { this->parameters.safety = SafetyLimits::none(); }

  TickOutput at(const Vec3& p_D, const Scene* scene, const Scene* previous = nullptr)
  {
    TickInput input;
    input.tick = ++this->tick_;
    input.scene = scene;
    input.previousScene = previous;
    input.sample.pose_D.p = p_D;
    input.sample.time_s = 1e-3 * static_cast<double>(this->tick_);
    return renderTick(input, this->parameters, this->state);
  }

  HapticParameters parameters;
  RendererState state;

private:
  std::uint64_t tick_ = 0;
};

std::shared_ptr<const Scene> cube()
{
  return test::sceneOf(test::makeBox({ -1, -1, -2 }, { 1, 1, 0 }));
}

TEST(TickChanges, ABallThatIsResizedWhilePressedStaysOnItsSide)
{
  const auto scene = cube();
  Hand hand;
  static_cast<void>(hand.at({ 0.1, 0.2, 0.5 }, scene.get()));
  static_cast<void>(hand.at({ 0.1, 0.2, -0.05 }, scene.get()));
  for (const double radius : { 0.0, 0.2, 0.01, 0.5, 0.0, 0.1 })
  {
    hand.parameters.contact.radius_u = radius;
    const TickOutput out = hand.at({ 0.1, 0.2, -0.05 }, scene.get());
    EXPECT_LE((out.state.proxy_W.p - Vec3(0.1, 0.2, radius)).norm(), 1e-12) << "radius " << radius;
    EXPECT_EQ(out.state.contacts, 1);
  }
}

TEST(TickChanges, AnotherMapPlacesTheProxyAtTheHandWithoutAForceFromWhatLiesBetween)
{
  const auto scene = cube();
  Hand hand;
  static_cast<void>(hand.at({ 0, 0, 0.5 }, scene.get()));
  hand.parameters.map.offset_W = { 0, 0, -3 }; // the hand is now under the cube
  const TickOutput moved = hand.at({ 0, 0, 0.5 }, scene.get());
  EXPECT_EQ(moved.state.proxy_W.p, Vec3(0, 0, -2.5));
  EXPECT_EQ(moved.command.wrench_D.force, Vec3::Zero());
  hand.parameters.map.q_WD = Quat(0, 1, 0, 0); // half a turn about x: z = -3 - 0.5
  EXPECT_EQ(hand.at({ 0, 0, 0.5 }, scene.get()).state.proxy_W.p, Vec3(0, 0, -3.5));
}

TEST(TickChanges, ScenesOfTheSameRevisionBlendTooWhenOneReplacesTheOther)
{
  test::Random random(test::testSeed(71));
  const auto high = test::sceneOf(test::makeSheet({ 2, 2, 4, 4, 0.2 }, random));
  const auto low = test::sceneOf(test::shifted(test::makeSheet({ 2, 2, 4, 4, 0.2 }, random), { 0, 0, -0.001 }));
  ASSERT_EQ(high->revision(), low->revision());
  Hand hand;
  static_cast<void>(hand.at({ 0, 0, 0.1 }, high.get()));
  const double before = hand.at({ 0, 0, -0.002 }, high.get()).command.wrench_D.force.z();
  EXPECT_NEAR(before, 1000.0 * 0.002, 1e-11);
  EXPECT_NEAR(hand.at({ 0, 0, -0.002 }, low.get(), high.get()).command.wrench_D.force.z(), before, 1e-11);
  // F_new + (F_old - F_new) tau / (tau + T) one tick later.
  const double share = hand.parameters.sceneBlend_s / (hand.parameters.sceneBlend_s + 1e-3);
  EXPECT_NEAR(hand.at({ 0, 0, -0.002 }, low.get()).command.wrench_D.force.z(), 1.0 + share * (before - 1.0), 1e-11);
}

/// Whether bad samples in these ticks of 1 ms latch.
bool latches(std::initializer_list<int> badTicks)
{
  const auto scene = cube();
  Hand hand;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (int tick = 0; tick <= *(badTicks.end() - 1); ++tick)
  {
    const bool bad = std::find(badTicks.begin(), badTicks.end(), tick) != badTicks.end();
    static_cast<void>(hand.at({ 0, 0, bad ? nan : 0.5 }, scene.get()));
  }
  return hand.state.fault == Fault::NonFiniteSample;
}

TEST(TickChanges, AnyThreeBadSamplesWithinASecondLatchAndThreeInMoreDoNot)
{
  EXPECT_TRUE(latches({ 5, 6, 7 }));
  EXPECT_TRUE(latches({ 5, 500, 1004 }));
  EXPECT_FALSE(latches({ 5, 500, 1006 }));
  EXPECT_TRUE(latches({ 5, 900, 1010, 1020 })) << "the window slides: 900, 1010, 1020";
  EXPECT_FALSE(latches({ 5, 6 }));
}

TEST(TickChanges, AHandThatTheMapSendsToInfinityGivesNoForce)
{
  const auto scene = cube();
  Hand hand;
  static_cast<void>(hand.at({ 0, 0, 0.5 }, scene.get()));
  hand.parameters.map.scale_u_per_m = 1e308;
  const TickOutput out = hand.at({ 0, 0, -100.0 }, scene.get());
  EXPECT_TRUE(out.state.held);
  EXPECT_EQ(out.command.wrench_D.force, Vec3::Zero());
}

} // namespace
} // namespace palpate
