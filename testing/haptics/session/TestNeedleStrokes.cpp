// SPDX-License-Identifier: GPL-3.0-or-later
// A session whose simulated hand pushes a needle through an abdominal wall into a liver, both of tetrahedra, and pulls
// it out again, 30 strokes in every hand, 100 in the long form, then holds still in them. PALPATE_TEST_COUNT: of
// strokes.
#include <cmath>

#include <gtest/gtest.h>

#include "WallAndLiver.h"
#include "devices/simulated/SimulatedDevice.h"
#include "haptics/recording/Recording.h"
#include "haptics/session/HapticSession.h"
#include "haptics/session/SessionWorkers.h"
#include "haptics/session/mechanism/MechanismChoice.h"
#include "testing/support/LongForm.h"
#include "testing/support/Random.h"
#include "testing/support/TemporaryFolder.h"

namespace palpate::test
{
namespace
{

constexpr double spring = 500.0, beyond_m = 0.04, before_m = -0.006, speed_m_per_s = 0.25;

/// A needle that nobody holds would fall over like a strut that stands on its tip: a guide leads it.
MechanismInputs guided(MechanismInputs inputs)
{
  inputs.mechanism.bodies.push_back(bodyCalled("world", MechanismBodyKind::World));
  MechanismConstraint& guide = inputs.mechanism.laws.emplace_back();
  guide.name = "guide";
  guide.kind = ConstraintKind::Slider;
  guide.a = "needle";
  guide.b = "world";
  return inputs;
}

/// The work of a hand by the record of its ticks alone, and how the force steps in them.
class Judge
{
public:
  explicit Judge(const SafetyLimits& limits) : limits_(limits) {}

  void look(const TickRecord& tick)
  {
    if (this->ticks_++ > 0)
    {
      const Vec3 way_m = tick.sample.pose_D.p - this->last_.sample.pose_D.p;
      this->given_J -= this->last_.wrench_D.force.dot(way_m);
      this->offMeter_J = std::max(this->offMeter_J, std::abs(this->given_J + tick.delivered_J));
      this->lookAtContact(tick);
      this->lookAtStep(tick, way_m);
    }
    this->last_ = tick;
  }

  double given_J = 0.0;
  double offMeter_J = 0.0; ///< from the session's own meter
  double leastInContact_J =
    0.0; ///< given since a contact began, at any time in it, against the most that it had stored
  double leastExcess_J = 0.0;
  double mostStored_J = 0.0;
  double mostExcess_J = 0.0; ///< by the session's own meter
  double mostRise_N = 0.0;   ///< beyond the limit of the session
  double mostFall_N = 0.0;   ///< beyond the fall that a change of a constraint and the hand's motion may make at once

private:
  void lookAtContact(const TickRecord& tick)
  {
    const bool touches = tick.contacts > 0;
    if (!touches)
    {
      this->contactFrom_J = this->given_J;
    }
    this->leastInContact_J = std::min(this->leastInContact_J, this->given_J - this->contactFrom_J);
    this->mostStored_J = std::max(this->mostStored_J, tick.wrench_D.force.squaredNorm() / (2.0 * spring));
    this->mostExcess_J = std::max(this->mostExcess_J, tick.excess_J);
  }

  void lookAtStep(const TickRecord& tick, const Vec3& way_m)
  {
    const double step_N = tick.wrench_D.force.norm() - this->last_.wrench_D.force.norm();
    this->mostRise_N = std::max(this->mostRise_N, step_N - this->limits_.maxRise_N_per_s * tick.dt_s);
    this->mostFall_N = std::max(this->mostFall_N, -step_N - 2.0 * spring * way_m.norm());
  }

  SafetyLimits limits_;
  TickRecord last_;
  double contactFrom_J = 0.0;
  int ticks_ = 0;
};

class NeedleStrokes : public testing::TestWithParam<HandModel>
{
protected:
  [[nodiscard]] static bool held() { return GetParam().stiffness_N_per_m > 0.0; }
  [[nodiscard]] static int strokes() { return held() ? static_cast<int>(testCount(isLongForm() ? 100 : 30)) : 3; }

  void begin(const std::string& file)
  {
    HapticParameters parameters;
    parameters.stiffness_N_per_m = spring;
    parameters.passivity.enabled = true;
    parameters.safety.needsEngage = false;
    parameters.safety.engageRamp_s = 0.0;
    parameters.safety.hand = handLimits(0.1, parameters.safety.maxForce_N);
    this->limits = parameters.safety;
    ASSERT_EQ(this->session.setParameters(parameters), "");
    const MechanismInputs inputs = held() ? wallAndLiver(1) : guided(wallAndLiver(1));
    this->session.choose<MechanismTask>({ std::make_shared<const MechanismInputs>(inputs), "needle", 25.0 });
    SimulationOptions simulated;
    simulated.push_D = Vec3(0.0, 0.0, held() ? 0.0 : 0.5); // whom nobody holds lies on the wall by its weight
    const Vec3 from(0.0, 0.0, (held() ? before_m : -2e-4) - needle_m), to(1e-3, 2e-3, beyond_m - needle_m);
    this->stroke_ticks = static_cast<int>(std::ceil(2e3 * (to - from).norm() / speed_m_per_s));
    SessionOptions options;
    options.virtualTime = true;
    options.recordFile = file;
    ASSERT_EQ(this->session.start(std::make_unique<SimulatedDevice>(*deviceModel("simulated-generic"), GetParam(),
                                    HandPath{ { from, to }, speed_m_per_s }, simulated),
                options),
      "");
  }

  SimulatedDevice& device() { return static_cast<SimulatedDevice&>(*this->session.device()); }

  void step()
  {
    const Vec3 before_W = this->session.state().device_W.p;
    ASSERT_EQ(this->session.step(1), 1);
    this->way_m = (this->session.state().device_W.p - before_W).norm();
    const MechanismNow& now = this->session.state().mechanism;
    this->isMet = this->isMet && !now.capped && now.residual_u <= 1e-12;
    for (std::uint64_t i = this->changes; i < now.changes.count; ++i)
    {
      this->look(now.changes.at(i));
    }
    this->changes = now.changes.count;
  }

  void look(const MechanismEvent& event)
  {
    const double asked_N = event.law == 0 ? skin_N : capsule_N;
    if (event.change == ConstraintChange::Punctured)
    {
      ++this->punctured[event.law];
      this->leastPuncture = std::min(this->leastPuncture, event.force_N / asked_N);
      this->mostBeyond_N = std::max(this->mostBeyond_N, event.force_N - asked_N - spring * this->way_m);
    }
    this->withdrawn += event.change == ConstraintChange::Withdrawn;
  }

  /// Into wall and liver, on the spring of both, until nothing moves there.
  void restInBoth()
  {
    const Vec3 inBoth(0.5e-3, 1e-3, 0.03 - needle_m);
    const Vec3 from = this->device().position_D();
    for (int tick = 1; tick <= way + settles; ++tick)
    {
      const double share = std::min(static_cast<double>(tick) / way, 1.0);
      this->device().lead(held() ? Vec3(from + share * (inBoth - from)) : from);
      this->step();
    }
  }

  /// How far the hand moves about where it is, in so many ticks.
  double restless_m(int ticks)
  {
    const Vec3 at = this->device().position_D();
    double most_m = 0.0;
    for (int i = 0; i < ticks; ++i)
    {
      this->step();
      most_m = std::max(most_m, (this->device().position_D() - at).norm());
    }
    return most_m;
  }

  static constexpr int way = 300, settles = 1200; // ticks
  HapticSession session;
  SafetyLimits limits;
  int stroke_ticks = 0;
  std::uint64_t changes = 0;
  std::array<int, 2> punctured{};
  int withdrawn = 0;
  double leastPuncture = 10.0; ///< of the strength that was set
  double mostBeyond_N = -1.0;  ///< of that strength and the rise by the hand's motion in that tick
  double way_m = 0.0;
  bool isMet = true;
};

TEST_P(NeedleStrokes, ThroughWallAndLiverAreStableTakeEnergyNeverStepAboveTheLimitAndReplayBitForBit)
{
  const TemporaryFolder folder;
  const std::string file = folder.file("strokes");
  this->begin(file);
  const int moving = strokes() * this->stroke_ticks;
  for (int tick = 0; tick < moving; ++tick)
  {
    this->step();
  }
  this->restInBoth();
  constexpr int watched = 200;
  const double before_m = this->restless_m(watched), last_m = this->restless_m(watched);
  EXPECT_GT(this->session.state().force_D.norm(), 0.1);
  EXPECT_LE(before_m, 1e-6);
  EXPECT_LE(last_m, std::max(before_m, 1e-9)) << "nothing grows while the hand is still";
  EXPECT_TRUE(this->isMet);
  EXPECT_EQ(this->session.state().fault, Fault::None);

  for (const int times : this->punctured)
  {
    EXPECT_GE(times, held() ? strokes() : 0);
    EXPECT_LE(times, held() ? strokes() + 1 : 0);
  }
  if (held())
  {
    EXPECT_GE(this->withdrawn, 2 * strokes() - 2);
    EXPECT_GE(this->leastPuncture, 1.0);
    EXPECT_LE(this->mostBeyond_N, 0.0);
  }
  EXPECT_EQ(this->session.stop(), "");

  const auto read = readRecording(file);
  ASSERT_TRUE(std::holds_alternative<Recording>(read)) << std::get<std::string>(read);
  const auto& recording = std::get<Recording>(read);
  const ReplayResult result = replay(recording);
  EXPECT_EQ(result.problem + result.difference, "");
  EXPECT_EQ(result.ticks, static_cast<std::uint64_t>(moving + way + settles + 2 * watched));
  Judge judge(this->limits);
  for (const RecordedEntry& entry : recording.entries)
  {
    if (const auto* const tick = std::get_if<TickRecord>(&entry))
    {
      judge.look(*tick);
    }
  }
  EXPECT_LE(judge.offMeter_J, 1e-12 + 1e-9 * std::abs(judge.given_J)) << "the session's meter";
  EXPECT_GE(judge.leastInContact_J, -0.02 * judge.mostStored_J) << "a hand gets back no more than it gave";
  EXPECT_LE(judge.mostExcess_J, this->limits.hand.excess_J / 5.0) << "a fifth of what ends the force";
  EXPECT_LE(judge.mostRise_N, 1e-12);
  EXPECT_LE(judge.mostFall_N, ToolBlend::largestStep_N + skin_N * 1e-3 / ToolBlend::fade_s);
  if (held())
  {
    EXPECT_GT(judge.given_J, strokes() * 2.0 * beyond_m * inSkin_N * 0.5) << "what the shaft rubs off";
  }
  std::cout << GetParam().name << ": " << moving << " ticks, gave " << 1e3 * judge.given_J << " mJ, got back at most "
            << -1e3 * judge.leastInContact_J << " mJ of " << 1e3 * judge.mostStored_J << " stored, meter's excess "
            << 1e3 * judge.mostExcess_J << ", rise beyond limit " << judge.mostRise_N << " N, fall " << judge.mostFall_N
            << " N, pierced " << this->punctured[0] << " + " << this->punctured[1] << ", beyond " << this->mostBeyond_N
            << " N, moves by " << 1e9 * last_m << " nm\n";
}

INSTANTIATE_TEST_SUITE_P(EveryHand, NeedleStrokes, testing::ValuesIn(handModels()),
  [](const testing::TestParamInfo<HandModel>& info) { return info.param.name; });

} // namespace
} // namespace palpate::test
