// SPDX-License-Identifier: GPL-3.0-or-later
// Loose bodies in the session's tick: before the first answer, and as bytes of a recording.
#include <vector>

#include <gtest/gtest.h>

#include "LooseScenes.h"
#include "MechanismTicks.h"
#include "haptics/recording/RecordedStages.h"

namespace palpate::test
{
namespace
{

constexpr int answerTicks = 33, stone = LooseRig::first;

/// A hand that comes from the side and pushes.
Pose handAt(int tick)
{
  return { Vec3(-0.06 + 5e-5 * tick, 0.002, stoneHalf_m.z()), Quat::Identity() };
}

/// A worker's mechanism, an answer after each so many ticks.
class Worker
{
public:
  explicit Worker(const LooseRig& rig)
  {
    std::string refusal;
    this->bodies_ = MechanismBodies::make({}, refusal);
    this->plan_ = planMechanism(rig.inputs.mechanism, {}, 1);
    this->bodies_->hold(rig.inputs.mechanism, this->plan_);
    this->bodies_->pace(1e-3 * answerTicks);
  }

  const FeltMechanism& at(int tick, const MechanismHand& hand)
  {
    if (tick % answerTicks == 0)
    {
      this->bodies_->tell(hand);
      EXPECT_TRUE(this->bodies_->press(1e-3 * answerTicks));
      EXPECT_TRUE(this->bodies_->changed()) << "each answer is told";
      this->felt.push_back(std::make_shared<const FeltMechanism>(
        this->felt.size() + 1, this->plan_, this->bodies_->newest(), this->bodies_->found()));
    }
    return *this->felt.back();
  }

  std::vector<std::shared_ptr<const FeltMechanism>> felt;

private:
  std::unique_ptr<MechanismBodies> bodies_;
  MechanismPlan plan_;
};

FeltMechanism feltAgain(const FeltMechanism& felt)
{
  const RecordedMechanism read = writtenAndRead(felt);
  return { read.revision, read.plan, {}, read.found };
}

TEST(LooseInTick, StandsOnItsTableBeforeTheHandHasToldAnything)
{
  LooseRig rig(0.3);
  rig.add(stoneHalf_m, Vec3(0, 0, stoneHalf_m.z()));
  Worker worker(rig);
  MechanismTicks ticks;
  for (int i = 0; i < 2 * answerTicks; ++i)
  {
    (void)ticks.next(i, handAt(i), worker.at(i, ticks.state().mechanismHand));
    EXPECT_NEAR(ticks.state().mechanism.pose_W[stone].p.z(), stoneHalf_m.z(), 1e-7) << i;
  }
}

TEST(LooseInTick, IsComputedAnewToTheLastBitFromARecordingAndFromHalfway)
{
  LooseRig rig(0.3);
  rig.add(stoneHalf_m, Vec3(0, 0, stoneHalf_m.z()));
  rig.add(Vec3(0.01, 0.01, 0.02), Vec3(0.045, 0.004, 0.02), Quat(Eigen::AngleAxisd(0.3, Vec3::UnitZ())));
  Worker worker(rig);
  constexpr int most = 1000, halfway = 15 * answerTicks;
  MechanismTicks ticks;
  ByteWriter half;
  std::vector<TickOutput> first;
  std::vector<Pose> stone_W;
  for (int i = 0; i < most; ++i)
  {
    const FeltMechanism& felt = worker.at(i, ticks.state().mechanismHand);
    if (i == halfway)
    {
      putState(half, ticks.state());
    }
    first.push_back(ticks.next(i, handAt(i), felt));
    stone_W.push_back(ticks.state().mechanism.pose_W[stone + 1]);
  }
  EXPECT_GT(stone_W.back().p.x(), 0.05) << "the stone has pushed the other one";
  auto middle = std::make_unique<RendererState>();
  ByteReader in(half.bytes().data(), half.bytes().size());
  getState(in, *middle);
  ASSERT_TRUE(in.ok());
  MechanismTicks again, fromHalfway(std::move(middle));
  for (int i = 0; i < most; ++i)
  {
    const auto place = static_cast<std::size_t>(i);
    const FeltMechanism read = feltAgain(*worker.felt[place / answerTicks]);
    const Wrench& expected = first[place].command.wrench_D;
    ASSERT_EQ(again.next(i, handAt(i), read).command.wrench_D.force, expected.force) << i;
    ASSERT_EQ(again.state().mechanism.pose_W[stone + 1].p, stone_W[place].p) << i;
    if (i >= halfway)
    {
      ASSERT_EQ(fromHalfway.next(i, handAt(i), read).command.wrench_D.force, expected.force) << i;
      ASSERT_EQ(fromHalfway.state().mechanism.pose_W[stone + 1].p, stone_W[place].p) << i;
    }
  }
}

TEST(LooseInTick, AMassThatNoForceMovesIsRefusedInARecording)
{
  LooseRig rig(0.3);
  rig.add(stoneHalf_m, Vec3(0, 0, stoneHalf_m.z()));
  const MechanismPlan plan = planMechanism(rig.inputs.mechanism, {}, 1);
  const auto reads = [](const MechanismPlan& written)
  {
    ByteWriter out;
    putMechanism(out, FeltMechanism(1, written, {}));
    ByteReader in(out.bytes().data(), out.bytes().size());
    (void)readMechanism(in);
    return in.ok();
  };
  EXPECT_TRUE(reads(plan));
  const auto refuses = [&](const auto& change)
  {
    MechanismPlan other = plan;
    change(other.bodies[stone]);
    EXPECT_FALSE(reads(other));
  };
  refuses([](PlannedBody& body) { body.mass.mass_Ns2_per_u = -1.0; });
  refuses([](PlannedBody& body) { body.mass.mass_Ns2_per_u = std::numeric_limits<double>::infinity(); });
  refuses([](PlannedBody& body) { body.mass.inertia_N_s2_u.setZero(); });
  refuses([](PlannedBody& body) { body.mass.inertia_N_s2_u(0, 1) = 1.0; });
}

} // namespace
} // namespace palpate::test
