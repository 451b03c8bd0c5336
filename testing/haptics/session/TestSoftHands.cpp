// SPDX-License-Identifier: GPL-3.0-or-later
// Simulated hands press, slide over and let go of a soft block, and at last rest on it. 3 s each; a minute with
// PALPATE_TEST_FULL.
#include <cmath>

#include <gtest/gtest.h>

#include "SoftBlock.h"
#include "devices/simulated/SimulatedDevice.h"
#include "haptics/recording/Recording.h"
#include "haptics/session/HapticSession.h"
#include "haptics/session/SessionWorkers.h"
#include "haptics/session/soft/SoftChoice.h"
#include "testing/support/LongForm.h"
#include "testing/support/TemporaryFolder.h"

namespace palpate::test
{
namespace
{

constexpr double pressed_m = 0.006;

/// Where a hand is led at last [m].
Vec3 lastTarget()
{
  return topOfBlock() - Vec3(0.0, 0.0, pressed_m);
}

/// The block under a force on the vertex in the middle of its top, solved with all of it until nothing is open.
class WholeBlock
{
public:
  WholeBlock() : made_(makeSoftBody(softBlock(ElasticModel::NeoHookean)))
  {
    this->surface_ = makeSoftSurface(*this->made_.body, this->made_.checked.mesh);
    const std::vector<Vec3>& places_W = this->surface_.rest_W;
    for (std::size_t v = 0; v < places_W.size(); ++v)
    {
      this->top_ = (places_W[v] - topOfBlock()).norm() < (places_W[this->top_] - topOfBlock()).norm() ? v : this->top_;
    }
  }

  struct Rest
  {
    double energy_J = 0.0;
    double yield_m = 0.0;
  };
  [[nodiscard]] Rest under(double force_N)
  {
    SoftBody& body = *this->made_.body;
    Eigen::VectorXd load = Eigen::VectorXd::Zero(body.displacement().size());
    this->surface_.map.addForce(this->top_, Vec3(0.0, 0.0, -force_N), load);
    EXPECT_TRUE(body.settle(load, 50));
    const SoftBodyState state = body.stateUnder(load);
    EXPECT_LE(state.residual_N, 1e-9 * force_N);
    return { state.energy_Nu, -this->surface_.map.displacementOf(this->top_, body.displacement()).z() };
  }

private:
  SoftBodyResult made_;
  SoftSurface surface_;
  std::size_t top_ = 0;
};

/// The outcome of a hand in front of a soft block.
struct Played
{
  double given_J = 0.0; ///< by the hand since contact began
  double least_J = 0.0; ///< of any contact that has ended
  double most_J = 0.0;  ///< stored at once
  int presses = 0;      ///< times that contact began
  double restless_m = 0.0;
  HapticState last;
};

class SoftHands : public testing::TestWithParam<HandModel>
{
protected:
  void begin(const std::string& file)
  {
    HapticParameters parameters;
    parameters.stiffness_N_per_m = 500.0;
    parameters.safety = SafetyLimits::none();
    ASSERT_EQ(this->session.setParameters(parameters), "");
    this->session.choose<SoftTask>(
      { std::make_shared<const SoftBodyInput>(softBlock(ElasticModel::NeoHookean)), "block", 25.0 });
    const Vec3 aside(0.012, 0.008, 0.0), up(0.0, 0.0, this->held() ? 0.02 : 0.002); // 1 N on .1 kg makes .2 m/s of 2 mm
    HandPath path{
      { topOfBlock() + up, lastTarget(), lastTarget() + aside, lastTarget() - aside, topOfBlock() - aside + up }, 0.15
    };
    SimulationOptions simulated;
    simulated.push_D = Vec3(0.0, 0.0, this->push_N());
    SessionOptions options;
    options.virtualTime = true;
    options.recordFile = file;
    ASSERT_EQ(
      this->session.start(
        std::make_unique<SimulatedDevice>(*deviceModel("simulated-generic"), GetParam(), path, simulated), options),
      "");
  }

  /// Whom nobody holds presses by its weight.
  [[nodiscard]] double push_N() const { return this->held() ? 0.0 : -1.0; }
  [[nodiscard]] bool held() const { return GetParam().stiffness_N_per_m > 0.0; }

  SimulatedDevice& device() { return static_cast<SimulatedDevice&>(*this->session.device()); }

  void step(Played& played)
  {
    const HapticState before = played.last;
    ASSERT_EQ(this->session.step(1), 1);
    played.last = this->session.state();
    played.given_J -= before.force_W.dot(played.last.device_W.p - before.device_W.p);
    played.most_J = std::max(played.most_J, played.last.soft.stored_J);
    if (before.soft.pressed && !played.last.soft.pressed)
    {
      played.least_J = std::min(played.least_J, played.given_J);
    }
    if (!before.soft.pressed)
    {
      played.given_J = 0.0;
      played.presses += played.last.soft.pressed;
    }
  }

  /// Along its path, then to rest on the block.
  Played play(double seconds)
  {
    Played played;
    for (int tick = 0; tick < static_cast<int>(1000.0 * seconds); ++tick)
    {
      this->step(played);
    }
    constexpr int way = 300, still = 1500, watched = 200;
    const Vec3 from = this->device().position_D();
    Vec3 rest = Vec3::Zero();
    for (int tick = 1; tick <= way + still; ++tick)
    {
      this->device().lead(from + std::min(1.0, static_cast<double>(tick) / way) * (lastTarget() - from));
      this->step(played);
      rest = tick == way + still - watched ? this->device().position_D() : rest;
      played.restless_m =
        tick > way + still - watched ? std::max(played.restless_m, (this->device().position_D() - rest).norm()) : 0.0;
    }
    return played;
  }

  /// Of block, coupling and hand, with the contact under that force and all else at rest.
  [[nodiscard]] double energyOf(WholeBlock& block, double force_N, double coupling_N_per_m) const
  {
    const WholeBlock::Rest rest = block.under(force_N);
    const double device_m = topOfBlock().z() - rest.yield_m - force_N / coupling_N_per_m;
    const double off_m = device_m - lastTarget().z();
    return rest.energy_J + 0.5 * force_N * force_N / coupling_N_per_m +
           0.5 * GetParam().stiffness_N_per_m * off_m * off_m - this->push_N() * device_m;
  }

  HapticSession session;
};

TEST_P(SoftHands, PressSlideAndLetGoAreStableComeToRestWhereEnergyIsLeastAndReplayBitForBit)
{
  const TemporaryFolder folder;
  this->begin(folder.file("hand"));
  const double seconds = isLongForm() ? 60.0 : 3.0;
  const Played played = this->play(seconds);
  EXPECT_GE(played.least_J, -0.02 * played.most_J) << "a hand gets back no more than it gave";
  EXPECT_GE(played.presses, this->held() ? static_cast<int>(seconds) : 1);
  EXPECT_LE(played.restless_m, 1e-6);

  const double force_N = played.last.force_W.norm();
  ASSERT_GT(force_N, 0.5);
  const double coupling_N_per_m = force_N / (played.last.proxy_W.p - played.last.device_W.p).norm();
  WholeBlock block;
  const auto at = [&](double share) { return this->energyOf(block, share * force_N, coupling_N_per_m); };
  constexpr double apart = 0.1;
  const double less = at(1.0 - apart), here = at(1.0), more = at(1.0 + apart);
  EXPECT_LT(here, std::min(less, more));
  const double off = 0.5 * apart * (less - more) / (less - 2.0 * here + more); // of the parabola's lowest place
  EXPECT_NEAR(off, 0.0, 1e-3);
  std::cout << GetParam().name << ": rests under " << force_N << " N, " << 100.0 * off
            << " % from least energy, and moves by " << 1e9 * played.restless_m << " nm; a contact gave it at most "
            << -100.0 * played.least_J / played.most_J << " % of what was stored\n";

  EXPECT_EQ(this->session.stop(), "");
  const auto read = readRecording(folder.file("hand"));
  ASSERT_TRUE(std::holds_alternative<Recording>(read)) << std::get<std::string>(read);
  const ReplayResult result = replay(std::get<Recording>(read));
  EXPECT_EQ(result.problem + result.difference, "");
  EXPECT_EQ(result.ticks, static_cast<std::uint64_t>(1000.0 * seconds) + 1800u);
}

INSTANTIATE_TEST_SUITE_P(EveryHand, SoftHands, testing::ValuesIn(handModels()),
  [](const testing::TestParamInfo<HandModel>& info) { return info.param.name; });

} // namespace
} // namespace palpate::test
