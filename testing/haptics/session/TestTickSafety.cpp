// SPDX-License-Identifier: GPL-3.0-or-later
// Events that end the force in the tick: the dead-man, the speed cut, the energy latch; and those that are only
// reported.
#include <gtest/gtest.h>

#include "haptics/tick/ForceRenderer.h"
#include "testing/support/Meshes.h"

namespace palpate
{
namespace
{

constexpr double depth_m = 1e-3, dt_s = 1e-3; // into a wall of 1000 N/m, at 1 kHz
constexpr std::uint32_t button = 0b10;

/// A hand pressed 1 mm deep into the plane z = 0, fully engaged.
class PressedHand : public testing::Test
{
protected:
  PressedHand()
  {
    test::Random random(1);
    this->scene_ = test::sceneOf(test::makeSheet({ 2.0, 2.0, 8, 8, 0.2 }, random));
    this->parameters_.safety.deadMan.buttons = button;
    this->parameters_.safety.hand = { 2.0, 0.05 };
  }

  TickOutput tick(const Vec3& p_D, std::uint32_t buttons = button, bool engage = false)
  {
    const HapticEvent event{ 0, EventKind::Engage, 0 };
    TickInput input;
    input.tick = ++this->tick_;
    input.scene = this->scene_.get();
    input.dt_s = dt_s;
    input.sample.time_s = dt_s * static_cast<double>(this->tick_);
    input.sample.pose_D.p = p_D;
    input.sample.buttons = buttons;
    if (engage)
    {
      input.events = { &event, 1 };
    }
    return renderTick(input, this->parameters_, this->state_);
  }

  /// Engages in the air, waits for the ramp, presses slowly.
  void press()
  {
    this->tick({ 0, 0, 1e-3 }, button, true);
    this->engaged();
    for (int i = 0; i <= 20; ++i)
    {
      this->tick({ 0, 0, 1e-3 - 1e-4 * i });
    }
    ASSERT_NEAR(this->tick({ 0, 0, -depth_m }).state.force_D.z(), 1000.0 * depth_m, 1e-9);
  }

  void engaged()
  {
    for (int i = 0; i < 1100; ++i)
    {
      this->tick({ 0, 0, 1e-3 });
    }
  }

  std::shared_ptr<const Scene> scene_;
  HapticParameters parameters_;
  RendererState state_;
  std::uint64_t tick_ = 0;
};

TEST_F(PressedHand, LetGoIsFreeWithinTheReleaseRampAndStartsAgainFromASmallForce)
{
  this->press();
  const int ramp = static_cast<int>(this->parameters_.safety.releaseRamp_s / dt_s + 0.5);
  double before_N = 1000.0 * depth_m;
  for (int i = 0; i < ramp; ++i)
  {
    const TickOutput out = this->tick({ 0, 0, -depth_m }, 0);
    EXPECT_TRUE(out.state.letGo);
    EXPECT_LT(out.state.force_D.z(), before_N);
    before_N = out.state.force_D.z();
  }
  EXPECT_NEAR(before_N, 0.0, 1e-12);
  TickOutput out = this->tick({ 0, 0, -depth_m });
  EXPECT_EQ(out.state.engage, EngageState::Armed) << "1 N is not a small force";
  EXPECT_EQ(out.state.force_D.norm(), 0.0);
  out = this->tick({ 0, 0, 1e-3 });
  EXPECT_EQ(out.state.engage, EngageState::Engaged);
}

TEST_F(PressedHand, AnotherButtonDoesNotHold)
{
  this->press();
  EXPECT_TRUE(this->tick({ 0, 0, -depth_m }, ~button).state.letGo);
}

TEST_F(PressedHand, ThatIsTornAwayFasterThanAHandCanIsCutAndStaysSo)
{
  this->press();
  const double step_m = 1.01 * this->parameters_.safety.hand.speed_m_per_s * dt_s;
  double x_m = 0.0;
  TickOutput out;
  do
  {
    x_m += step_m;
    out = this->tick({ x_m, 0, -depth_m });
    ASSERT_LT(x_m, 0.5) << "within the window of the velocity";
  } while (out.state.fault == Fault::None);
  EXPECT_EQ(out.state.fault, Fault::VelocityCut);
  for (int i = 0; i < 20; ++i)
  {
    out = this->tick({ x_m, 0, -depth_m });
  }
  EXPECT_EQ(out.state.force_D.norm(), 0.0);
  EXPECT_EQ(out.state.engage, EngageState::Fault);
  out = this->tick({ x_m, 0, 1e-3 }, button, true);
  EXPECT_EQ(out.state.engage, EngageState::Engaged) << "the person may engage again";
}

TEST_F(PressedHand, InFreeAirMayBeAsFastAsItLikes)
{
  this->tick({ 0, 0, 1e-3 }, button, true);
  this->engaged();
  TickOutput out;
  for (int i = 1; i <= 30; ++i)
  {
    out = this->tick({ 0.01 * i, 0, 1e-3 }); // 10 m/s
  }
  EXPECT_EQ(out.state.engage, EngageState::Engaged);
}

TEST_F(PressedHand, LatchesWhenItIsGivenMoreEnergyThanAllowed)
{
  this->parameters_.safety.maxForce_N = this->parameters_.safety.maxRise_N_per_s = 1e9;
  this->press();
  // Up and down at 1 m/s: a held force lacks K s^2 / 2 of the spring's work in every step of s.
  constexpr double step_m = 1e-3, leak_J = 0.5 * 1000.0 * step_m * step_m;
  constexpr int latchesAt = 100;
  this->parameters_.safety.hand.excess_J = this->state_.energy.excess_J + (latchesAt - 0.5) * leak_J;
  for (int i = 1; i <= latchesAt; ++i)
  {
    const int down = i % 10 <= 5 ? i % 10 : 10 - i % 10;
    const Fault fault = this->tick({ 0, 0, -depth_m - step_m * down }).state.fault;
    ASSERT_EQ(fault, i < latchesAt ? Fault::None : Fault::EnergyLatch) << i;
  }
}

TEST_F(PressedHand, ThatStandsStillToTheBitUnderForceIsSaidNotCut)
{
  this->parameters_.safety.frozenAbove_N = 0.5;
  this->press();
  TickOutput out;
  for (int i = 0; i < 260; ++i)
  {
    out = this->tick({ 0, 0, -depth_m });
  }
  EXPECT_TRUE(out.state.frozen);
  EXPECT_EQ(out.state.engage, EngageState::Engaged);
  EXPECT_FALSE(this->tick({ 0, 0, -1.001 * depth_m }).state.frozen);
}

} // namespace
} // namespace palpate
