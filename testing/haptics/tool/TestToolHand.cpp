// SPDX-License-Identifier: GPL-3.0-or-later
// A hand that goes and turns holds a tool: device, hand, tick and the tool's own updates in one loop, in virtual time.
#include <gtest/gtest.h>

#include <cmath>

#include "Tools.h"
#include "haptics/safety/HandLimits.h"
#include "haptics/tick/ForceRenderer.h"
#include "haptics/tool/worker/ToolFollower.h"

namespace palpate::test
{
namespace
{

constexpr double period_s = 1e-3;
constexpr int subSteps = 20;

/// A handle with a mass for displacements and, times the lever's square, for turns; led by a hand that is a spring with
/// a damper. In units of the lever turns are like displacements, so that the limits of stiffness are those of a point.
class LedHandle
{
public:
  explicit LedHandle(double lever_m) : lever_m_(lever_m) {}

  void go(const Vec6& wanted, const Wrench& felt)
  {
    constexpr double mass_kg = 0.1, friction = 2.0, handStiffness = 200.0, handDamping = 4.0;
    Vec6 push;
    push << felt.force, felt.torque / this->lever_m_;
    constexpr double dt_s = period_s / subSteps;
    for (int i = 0; i < subSteps; ++i)
    {
      const Vec6 hand = handStiffness * (wanted - this->at_) - (handDamping + friction) * this->speed_;
      this->speed_ += dt_s / mass_kg * (hand + push);
      this->at_ += dt_s * this->speed_;
    }
  }

  [[nodiscard]] Pose pose() const { return { this->at_.head<3>(), turnBy(this->at_.tail<3>() / this->lever_m_) }; }
  [[nodiscard]] double speed() const { return this->speed_.norm(); }
  void put(const Vec6& at) { this->at_ = at; }

private:
  double lever_m_;
  Vec6 at_ = Vec6::Zero(), speed_ = Vec6::Zero();
};

struct LoopOfTool
{
  LoopOfTool(const TriangleMesh& toolMesh, const TriangleMesh& sceneMesh, double stiffness_N_per_m)
    : scene(sceneOf(sceneMesh)), tool(makeTool(toolMesh).value),
      follower(ToolMove(tool, makeToolScene(cleanMesh(sceneMesh).mesh, tool), tool.gyration_u), links),
      handle(tool.gyration_u)
  {
    parameters.stiffness_N_per_m = stiffness_N_per_m;
    parameters.passivity.enabled = true;
    parameters.safety = SafetyLimits::none();
    parameters.safety.hand = handLimits(0.1, 3.0); // the latch of a device of 3 N
  }

  HapticState tick(const Vec6& wanted, int ticksAnUpdate)
  {
    TickInput input;
    input.tick = ++this->ticks;
    input.dt_s = period_s;
    input.sample.pose_D = this->handle.pose();
    input.scene = this->scene.get();
    input.tool = &this->links.contacts.read();
    const TickOutput out = renderTick(input, this->parameters, this->state);
    this->links.hand.write({ out.state.tool.hand_W, true });
    if (this->ticks % static_cast<std::uint64_t>(ticksAnUpdate) == 0)
    {
      this->follower.step();
    }
    this->handle.go(wanted, out.command.wrench_D);
    return out.state;
  }

  std::shared_ptr<const Scene> scene;
  ToolMesh tool;
  ToolLinks links;
  ToolFollower follower;
  LedHandle handle;
  HapticParameters parameters;
  RendererState state;
  std::uint64_t ticks = 0;
};

} // namespace

TEST(ToolHand, ThatPressesACubeFlatAndTipsItComesToRestAndIsGivenNoEnergyThatTheSpringDoesNotHold)
{
  constexpr double half_m = 0.02, stiffness_N_per_m = 1000.0;
  Random random(testSeed(1804));
  for (const int ticksAnUpdate : { 1, 10 })
  {
    LoopOfTool loop(makeBox(Vec3::Constant(-half_m), Vec3::Constant(half_m)),
      makeSheet({ 0.4, 0.4, 8, 8, 0.3 }, random), stiffness_N_per_m);
    Vec6 wanted = Vec6::Zero();
    wanted.z() = half_m + 0.01;
    loop.handle.put(wanted);
    double pressed_N = 0.0, turned_Nm = 0.0;
    HapticState state;
    for (int i = 0; i < 6000; ++i)
    {
      const double s = period_s * i;
      const double swing = i < 4000 ? std::sin(2.0 * std::numbers::pi * 1.5 * s) : 0.0;
      wanted.x() = 0.01 * swing;
      wanted.z() = i < 500 ? half_m + 0.01 : half_m - 0.006;
      wanted.tail<3>() = loop.tool.gyration_u * Vec3(0.0, 0.5 * swing, 0.2 * swing);
      state = loop.tick(wanted, ticksAnUpdate);
      ASSERT_EQ(state.fault, i < ticksAnUpdate + 1 ? state.fault : Fault::None) << i; // placed by the first update
      pressed_N = std::max(pressed_N, state.force_D.norm());
      turned_Nm = std::max(turned_Nm, state.torque_D.norm());
    }
    EXPECT_GT(pressed_N, 0.5);
    EXPECT_GT(turned_Nm, 0.01);
    EXPECT_LE(loop.handle.speed(), 1e-6) << "at rest, " << ticksAnUpdate;
    EXPECT_LE(state.energy.delivered_J, 0.0) << "it takes, on the whole";
    EXPECT_LE(state.energy.peakExcess_J, loop.parameters.safety.hand.excess_J / 5.0) << "the allowance of a fifth";
  }
}

} // namespace palpate::test
