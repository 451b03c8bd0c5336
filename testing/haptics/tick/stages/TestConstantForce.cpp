// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "haptics/core/PoseMath.h"
#include "haptics/recording/RecordedStages.h"
#include "haptics/session/settings/SessionSettings.h"
#include "haptics/session/settings/TickFields.h"
#include "haptics/tick/ForceRenderer.h"
#include "testing/haptics/tick/stages/Tick.h"
#include "testing/support/Meshes.h"
#include "testing/support/Random.h"

namespace palpate
{
namespace
{

using test::dt_s;

constexpr double wall_N_per_m = 1000.0;
const Vec3 force_W(0.3, -0.6, 0.6); // 0.9 N

void setConstantForce(HapticParameters& parameters, const Vec3& to_W)
{
  const std::vector<double> numbers(to_W.begin(), to_W.end());
  setField(parameters, sessionSetting("ConstantForce"), numbers);
}

/// A hand above the plane z = 0, or in it, in a device that is turned against the scene.
class ConstantForce : public testing::Test
{
protected:
  ConstantForce()
  {
    test::Random random(test::testSeed(1401));
    this->scene_ = test::sceneOf(test::makeSheet({ 2.0, 2.0, 8, 8, 0.2 }, random));
    this->parameters_.stiffness_N_per_m = wall_N_per_m;
    this->parameters_.map.q_WD = shortestTurn(Vec3::UnitZ(), random.direction());
    setConstantForce(this->parameters_, force_W);
  }

  TickOutput tick(const Vec3& p_W, EventKind event = EventKind::Mark)
  {
    const HapticEvent told{ 0, event, 0 };
    TickInput input;
    input.tick = ++this->tick_;
    input.scene = this->scene_.get();
    input.dt_s = dt_s;
    input.sample.time_s = dt_s * static_cast<double>(this->tick_);
    input.sample.pose_D.p = this->parameters_.map.toDevice(p_W);
    input.events = { &told, 1 };
    return renderTick(input, this->parameters_, this->state_);
  }

  TickOutput engaged(const Vec3& p_W)
  {
    TickOutput out = this->tick(p_W, EventKind::Engage);
    for (int i = 0; i < static_cast<int>(this->parameters_.safety.engageRamp_s / dt_s) + 1; ++i)
    {
      out = this->tick(p_W);
    }
    return out;
  }

  std::shared_ptr<const Scene> scene_;
  HapticParameters parameters_;
  RendererState state_;
  std::uint64_t tick_ = 0;
};

TEST_F(ConstantForce, IsNoneBeforeForceIsEngagedAndThenGrowsToWhatWasSet)
{
  for (int i = 0; i < 20; ++i)
  {
    EXPECT_EQ(this->tick({ 0, 0, 0.5 }).state.force_W, Vec3(Vec3::Zero()));
  }
  double before_N = 0.0;
  TickOutput out = this->tick({ 0, 0, 0.5 }, EventKind::Engage);
  while (out.state.gain < 1.0)
  {
    out = this->tick({ 0, 0, 0.5 });
    EXPECT_GE(out.state.force_D.norm(), before_N);
    before_N = out.state.force_D.norm();
  }
  EXPECT_LT((out.state.force_W - force_W).norm(), 1e-12);
  EXPECT_LT((out.command.wrench_D.force - this->parameters_.map.q_WD.conjugate() * force_W).norm(), 1e-12);
}

TEST_F(ConstantForce, EndsThroughTheRampOfARelease)
{
  this->engaged({ 0, 0, 0.5 });
  const int ramp = static_cast<int>(this->parameters_.safety.releaseRamp_s / dt_s + 0.5);
  double before_N = this->tick({ 0, 0, 0.5 }, EventKind::Release).state.force_D.norm();
  EXPECT_GT(before_N, 0.9 * force_W.norm()) << "a release is no jump";
  for (int i = 1; i < ramp; ++i)
  {
    const double now_N = this->tick({ 0, 0, 0.5 }).state.force_D.norm();
    EXPECT_LT(now_N, before_N);
    before_N = now_N;
  }
  EXPECT_NEAR(before_N, 0.0, 1e-12);
}

TEST_F(ConstantForce, IsNoLargerThanTheLimitOfTheSession)
{
  setConstantForce(this->parameters_, 100.0 * force_W);
  const Vec3 limited_W = this->parameters_.safety.maxForce_N * force_W.normalized();
  EXPECT_LT((this->engaged({ 0, 0, 0.5 }).state.force_W - limited_W).norm(), 1e-12);
}

TEST_F(ConstantForce, RisesNoFasterThanAForceMay)
{
  setConstantForce(this->parameters_, Vec3::Zero());
  this->engaged({ 0, 0, 0.5 });
  setConstantForce(this->parameters_, force_W);
  const double rise_N = this->parameters_.safety.maxRise_N_per_s * dt_s;
  const int ticks = static_cast<int>(std::ceil(force_W.norm() / rise_N - 1e-9));
  for (int i = 1; i <= ticks; ++i)
  {
    EXPECT_NEAR(this->tick({ 0, 0, 0.5 }).state.force_W.norm(), std::min(i * rise_N, force_W.norm()), 1e-12);
  }
}

TEST_F(ConstantForce, AddsToTheSpringOfTheContactAndIsNoWorkOfIt)
{
  const auto press = [this](const Vec3& constant_W)
  {
    this->state_ = {};
    this->tick_ = 0;
    setConstantForce(this->parameters_, constant_W);
    TickOutput out = this->engaged({ 0, 0, 1e-3 });
    for (int i = 0; i <= 40; ++i)
    {
      out = this->tick({ 0, 0, 1e-3 - 5e-5 * i });
    }
    return out.state;
  };
  const HapticState plain = press(Vec3::Zero()), pulled = press(force_W);
  EXPECT_NEAR(plain.force_W.z(), wall_N_per_m * 1e-3, 1e-9);
  EXPECT_LT((pulled.force_W - plain.force_W - force_W).norm(), 1e-9);
  EXPECT_LT((pulled.besideContact_D - this->parameters_.map.toDevice(force_W)).norm(), 1e-12);
  EXPECT_NEAR(pulled.energy.delivered_J, plain.energy.delivered_J, 1e-12);
  EXPECT_NEAR(pulled.energy.excess_J, plain.energy.excess_J, 1e-12);
}

TEST_F(ConstantForce, TakesNoWorkOverAClosedWay)
{
  this->engaged({ 0.1, 0, 0.5 });
  constexpr int steps = 1000;
  const auto at_W = [](int i)
  {
    const double turn = 2.0 * std::numbers::pi * i / steps;
    return Vec3(0.1 * std::cos(turn), 0.1 * std::sin(turn), 0.5 + 0.05 * std::sin(2.0 * turn));
  };
  double work_J = 0.0;
  for (int i = 1; i <= steps; ++i)
  {
    work_J += this->tick(at_W(i)).state.force_W.dot(at_W(i) - at_W(i - 1)); // the scale is 1
  }
  EXPECT_NEAR(work_J, 0.0, 1e-12);
}

TEST_F(ConstantForce, IsRecordedAndOneThatIsNoNumberIsRefused)
{
  ByteWriter bytes;
  putParameters(bytes, this->parameters_);
  ByteReader in(bytes.bytes().data(), bytes.bytes().size());
  HapticParameters read;
  getParameters(in, read);
  EXPECT_EQ(read.constantForce_W, force_W);
  setConstantForce(this->parameters_, Vec3(0, 0, std::nan("")));
  EXPECT_NE(this->parameters_.validate(), "");
}

} // namespace
} // namespace palpate
