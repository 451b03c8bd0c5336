// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "haptics/tick/ForceRenderer.h"
#include "testing/support/AllocationGuard.h"
#include "testing/support/Meshes.h"

namespace palpate
{
namespace
{

/// A square of 2 m in the plane z = 0, felt from above.
std::shared_ptr<const Scene> floorScene()
{
  test::Random random(1);
  return test::sceneOf(test::makeSheet({ 2.0, 2.0, 8, 8, 0.2 }, random));
}

TickInput inputAt(const Vec3& p_D, const Scene* scene, std::uint64_t tick = 1)
{
  TickInput input;
  input.tick = tick;
  input.scene = scene;
  input.sample.time_s = 1e-3 * static_cast<double>(tick);
  input.sample.pose_D.p = p_D;
  return input;
}

HapticParameters headless()
{
  HapticParameters parameters;
  parameters.safety = SafetyLimits::none();
  return parameters;
}

TEST(Tick, ForceIsStiffnessTimesDepthOverScaleAlongTheNormal)
{
  const auto scene = floorScene();
  HapticParameters parameters = headless();
  parameters.stiffness_N_per_m = 800.0;
  parameters.map.scale_u_per_m = 4.0;
  RendererState state;
  static_cast<void>(renderTick(inputAt({ 0.01, 0.02, 0.1 }, scene.get()), parameters, state));
  // The device 2 mm under its plane is 8 mm under the floor in the scene: F = 800 N/m * 2 mm.
  const TickOutput out = renderTick(inputAt({ 0.01, 0.02, -0.002 }, scene.get(), 2), parameters, state);
  EXPECT_NEAR(out.command.wrench_D.force.z(), 800.0 * 0.002, 1e-11);
  EXPECT_NEAR(out.command.wrench_D.force.head<2>().norm(), 0.0, 1e-11);
  EXPECT_NEAR(out.state.device_W.p.z(), -0.008, 1e-15);
  EXPECT_EQ(out.state.contacts, 1);
}

TEST(Tick, DampingActsAlongTheSpringWithTheEstimatedVelocityAndNeverPulls)
{
  const auto scene = floorScene();
  HapticParameters parameters = headless();
  parameters.damping_Ns_per_m = 5.0;
  for (const double velocity : { -0.1, 0.1, 0.5 })
  {
    RendererState state;
    static_cast<void>(renderTick(inputAt({ 0, 0, 0.1 }, scene.get()), parameters, state));
    const double before_m = -0.001 - 1e-3 * velocity; // one period of 1 ms earlier
    static_cast<void>(renderTick(inputAt({ 0, 0, before_m }, scene.get(), 2), parameters, state));
    const TickOutput out = renderTick(inputAt({ 0, 0, -0.001 }, scene.get(), 3), parameters, state);
    EXPECT_NEAR(out.state.velocity_D.z(), velocity, 1e-12);
    const double expected = std::max(0.0, 1000.0 * 0.001 - 5.0 * velocity);
    EXPECT_NEAR(out.command.wrench_D.force.z(), expected, 1e-11);
  }
}

TEST(Tick, GivesNoForceBeforeItIsEngagedAndEngagesOnlyFromASmallForce)
{
  const auto scene = floorScene();
  HapticParameters parameters;
  RendererState state;
  const HapticEvent engage{ 0, EventKind::Engage, 0 };
  static_cast<void>(renderTick(inputAt({ 0, 0, 0.1 }, scene.get()), parameters, state));
  TickInput deep = inputAt({ 0, 0, -0.002 }, scene.get(), 2); // 2 N, above the 0.3 N allowed at engaging
  EXPECT_EQ(renderTick(deep, parameters, state).command.wrench_D.force.norm(), 0.0);
  deep.events = { &engage, 1 };
  TickOutput out = renderTick(deep, parameters, state);
  EXPECT_EQ(out.state.engage, EngageState::Armed);
  EXPECT_EQ(out.command.wrench_D.force.norm(), 0.0);
  out = renderTick(inputAt({ 0, 0, -0.0002 }, scene.get(), 3), parameters, state);
  EXPECT_EQ(out.state.engage, EngageState::Engaged);
}

TEST(Tick, TheEngageRampReachesFullForceAfterItsTimeAndRisesMonotonically)
{
  const auto scene = floorScene();
  HapticParameters parameters;
  RendererState state;
  const HapticEvent engage{ 0, EventKind::Engage, 0 };
  double before = 0.0;
  for (std::uint64_t tick = 1; tick <= 1200; ++tick)
  {
    TickInput input = inputAt({ 0, 0, tick == 1 ? 0.001 : -0.0002 }, scene.get(), tick);
    if (tick == 1)
    {
      input.events = { &engage, 1 };
    }
    const double force = renderTick(input, parameters, state).command.wrench_D.force.norm();
    EXPECT_GE(force, before);
    before = force;
    if (tick == 500) // half of the 1 s ramp: smoothstep(0.5) = 0.5, within a tick's worth
    {
      EXPECT_NEAR(force, 0.5 * 0.2, 0.2 * 2e-3);
    }
  }
  EXPECT_NEAR(before, 0.2, 1e-11);
}

TEST(Tick, OneBadSampleHoldsNoForceForItsTickAndTheThirdInASecondLatches)
{
  const auto scene = floorScene();
  const HapticParameters parameters = headless();
  RendererState state;
  static_cast<void>(renderTick(inputAt({ 0, 0, 0.1 }, scene.get()), parameters, state));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (int bad = 1; bad <= 3; ++bad)
  {
    const TickOutput held = renderTick(inputAt({ 0, nan, 0 }, scene.get()), parameters, state);
    EXPECT_EQ(held.command.wrench_D.force.norm(), 0.0);
    EXPECT_TRUE(held.state.held);
    EXPECT_EQ(held.state.engage, bad < 3 ? EngageState::Engaged : EngageState::Fault) << bad;
    const TickOutput good = renderTick(inputAt({ 0, 0, -0.001 }, scene.get()), parameters, state);
    EXPECT_TRUE(good.command.wrench_D.force.allFinite());
    EXPECT_EQ(good.command.wrench_D.force.norm() > 0.5, bad < 3) << bad;
  }
  EXPECT_EQ(state.fault, Fault::NonFiniteSample);
}

TEST(Tick, ALostDeviceLatchesUntilThePersonEngagesAgain)
{
  const auto scene = floorScene();
  HapticParameters parameters;
  RendererState state;
  TickInput lost = inputAt({ 0, 0, 0.1 }, scene.get());
  lost.status = DeviceStatus::Lost;
  EXPECT_EQ(renderTick(lost, parameters, state).state.fault, Fault::DeviceLost);
  EXPECT_EQ(renderTick(inputAt({ 0, 0, 0.1 }, scene.get(), 2), parameters, state).state.engage, EngageState::Fault);
  const HapticEvent engage{ 0, EventKind::Engage, 0 };
  TickInput again = inputAt({ 0, 0, 0.1 }, scene.get(), 3);
  again.events = { &engage, 1 };
  EXPECT_EQ(renderTick(again, parameters, state).state.engage, EngageState::Engaged);
}

// Where a sample says the hand is before anybody knows is nowhere: one that appears above is not stopped below.
TEST(Tick, BeforeAnybodySaidWhereTheHandIsThereIsNoForceAndNoProxy)
{
  const auto scene = floorScene();
  HapticParameters parameters;
  RendererState state;
  for (std::uint64_t tick = 1; tick <= 4; ++tick)
  {
    TickInput waiting = inputAt({ 0, 0, -0.01 }, scene.get(), tick);
    waiting.status = DeviceStatus::Waiting;
    const TickOutput out = renderTick(waiting, parameters, state);
    EXPECT_EQ(out.state.fault, Fault::NoHand);
    EXPECT_EQ(out.command.wrench_D.force, Vec3(0, 0, 0));
    EXPECT_FALSE(state.contact.placed);
  }
  const Vec3 hand(0, 0, 0.03);
  const TickOutput out = renderTick(inputAt(hand, scene.get(), 5), parameters, state);
  EXPECT_EQ(out.state.fault, Fault::None);
  EXPECT_EQ(out.state.proxy_W.p, hand);
  EXPECT_EQ(out.command.wrench_D.force, Vec3(0, 0, 0));
}

TEST(Tick, WithoutASceneTheForceRampsOutIn50Milliseconds)
{
  const auto scene = floorScene();
  HapticParameters parameters;
  parameters.sceneBlend_s = 0.0;
  RendererState state;
  const HapticEvent engage{ 0, EventKind::Engage, 0 };
  for (std::uint64_t tick = 1; tick <= 1100; ++tick)
  {
    TickInput input = inputAt({ 0, 0, tick == 1 ? 0.001 : -0.0002 }, scene.get(), tick);
    input.events = { &engage, tick == 1 ? 1U : 0U };
    static_cast<void>(renderTick(input, parameters, state));
  }
  for (std::uint64_t tick = 1101; tick <= 1150; ++tick)
  {
    const TickOutput out = renderTick(inputAt({ 0, 0, -0.0002 }, nullptr, tick), parameters, state);
    EXPECT_EQ(out.state.fault, Fault::SceneRefused);
  }
  EXPECT_NEAR(state.gain, 0.0, 1e-12);
}

TEST(Tick, AReplacedSceneNeverStepsTheForce)
{
  const auto scene = floorScene();
  test::Random random(1);
  const auto higher = std::make_shared<const Scene>(
    7, test::sceneOf(test::shifted(test::makeSheet({ 2.0, 2.0, 8, 8, 0.2 }, random), { 0, 0, -0.001 }))->surfaces());
  const HapticParameters parameters = headless();
  RendererState state;
  static_cast<void>(renderTick(inputAt({ 0, 0, 0.1 }, scene.get()), parameters, state));
  double before =
    renderTick(inputAt({ 0, 0, -0.002 }, scene.get(), 2), parameters, state).command.wrench_D.force.norm();
  EXPECT_NEAR(before, 2.0, 1e-11);
  for (std::uint64_t tick = 3; tick < 600; ++tick)
  {
    TickInput input = inputAt({ 0, 0, -0.002 }, higher.get(), tick);
    input.previousScene = tick == 3 ? scene.get() : nullptr;
    const double force = renderTick(input, parameters, state).command.wrench_D.force.norm();
    EXPECT_LE(std::fabs(force - before), 0.1) << tick;
    before = force;
  }
  EXPECT_NEAR(before, 1.0, 1e-3); // 1 mm less deep in the lower floor
}

TEST(Tick, ABallThatDoesNotFitGivesNoForceAndSaysSo)
{
  TriangleMesh slot = test::makeBox({ -1, -1, -1.01 }, { 1, 1, -0.01 });
  append(slot, test::makeBox({ -1, -1, 0.01 }, { 1, 1, 1.01 }));
  const auto scene = test::sceneOf(slot);
  HapticParameters parameters = headless();
  parameters.contact.radius_u = 0.1;
  RendererState state;
  const TickOutput out = renderTick(inputAt({ 0, 0, 0 }, scene.get()), parameters, state);
  EXPECT_EQ(out.state.fault, Fault::PlacementFailed);
  EXPECT_EQ(out.command.wrench_D.force.norm(), 0.0);
}

TEST(Tick, NeitherAllocatesNorFreesNorLocksOverASlideWithSceneSwaps)
{
  const auto one = test::sceneOf(test::makeIcosphere(4, 0.05));
  const auto two = std::make_shared<const Scene>(9, test::sceneOf(test::makeIcosphere(3, 0.05))->surfaces());
  for (const double radius : { 0.0, 0.002 })
  {
    HapticParameters parameters = headless();
    parameters.contact.radius_u = radius;
    RendererState state;
    const Scene* last = nullptr;
    const test::AllocationGuard guard;
    for (std::uint64_t tick = 0; tick < 5000; ++tick)
    {
      const double angle = 1e-3 * static_cast<double>(tick);
      const double reach = tick == 0 ? 0.06 : 0.048;
      TickInput input =
        inputAt({ reach * std::cos(angle), reach * std::sin(angle), 0.01 * std::sin(3 * angle) }, one.get(), tick);
      input.scene = (tick / 500) % 2 == 0 ? one.get() : two.get();
      input.previousScene = input.scene != last ? last : nullptr;
      last = input.scene;
      static_cast<void>(renderTick(input, parameters, state));
    }
    EXPECT_EQ(guard.allocations(), 0U);
    EXPECT_EQ(guard.frees(), 0U);
    EXPECT_EQ(guard.locks(), 0U);
  }
}

} // namespace
} // namespace palpate
