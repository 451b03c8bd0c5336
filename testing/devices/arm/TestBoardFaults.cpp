// SPDX-License-Identifier: GPL-3.0-or-later
// Faults of a link of bytes to an arm: no force within 20 ms, and one sentence.
#include <algorithm>
#include <functional>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/devices/arm/FalconRig.h"
#include "testing/devices/arm/TwoDiyRig.h"
#include "testing/support/Random.h"

namespace palpate
{
namespace
{

/// An arm that pushes with 1 N.
class Pushing
{
public:
  virtual ~Pushing() = default;
  virtual test::BoardRig& rig() = 0;
  /// The largest force along y that it may give here [N].
  virtual double largest_N() = 0;
};

class PushingFalcon final : public Pushing
{
public:
  PushingFalcon()
  {
    EXPECT_EQ(this->falcon_.rig.device.open(), "");
    this->falcon_.home();
    ask(this->falcon_.rig, { 0.0, 1.0, 0.0 });
    EXPECT_GT(this->falcon_.model->force_N().norm(), 0.9);
  }
  test::BoardRig& rig() override { return this->falcon_.rig; }
  /// Until a motor's number is 4096, but no more than CHAI3D lists.
  double largest_N() override
  {
    constexpr double largest_Nm = 4096.0 / 10000.0, listed_N = 8.0;
    const Vec3 torqueOfOneNewton = this->falcon_.model->ways().transpose() * Vec3::UnitY();
    return std::min(listed_N, largest_Nm / torqueOfOneNewton.cwiseAbs().maxCoeff());
  }

private:
  test::FalconRig falcon_;
};

class PushingTwoDiy final : public Pushing
{
public:
  PushingTwoDiy()
  {
    EXPECT_EQ(this->diy_.rig.device.open(), "");
    this->diy_.setInPose();
    EXPECT_TRUE(this->diy_.model->lead({ 0.01, 0.085, 0.0 }));
    ask(this->diy_.rig, { 0.0, 1.0, 0.0 });
    EXPECT_GT(this->diy_.model->force_N().norm(), 0.9);
  }
  test::BoardRig& rig() override { return this->diy_.rig; }
  /// Every direction gets the force of the motors in their worst one: along the way of a joint.
  double largest_N() override
  {
    constexpr double largest_Nm = 0.123;
    const Mat3 ways = this->diy_.model->ways();
    return largest_Nm / std::max(ways.col(0).norm(), ways.col(1).norm());
  }

private:
  test::TwoDiyRig diy_;
};

struct BoardFault
{
  const char* name;
  void (*happen)(test::BoardModel& board);
  const char* sentence;
  bool hears; ///< the board still hears
};

constexpr const char* nonsense = "the device answers with something else than its protocol has";
constexpr std::array<BoardFault, 5> faults{ {
  { "Unplugged", [](test::BoardModel& board) { board.present = false; }, "unplugged", false },
  { "Frozen", [](test::BoardModel& board) { board.frozen = true; }, "the device does not answer", false },
  { "Silent", [](test::BoardModel& board) { board.silentFor = 1000; }, "the device does not answer", true },
  { "HalfMessages", [](test::BoardModel& board) { board.cutAnswers = 1000; }, nonsense, true },
  { "WrongAnswers", [](test::BoardModel& board) { board.wrongAnswers = 1000; }, nonsense, true },
} };

template<class Arm>
class BoardFaults : public testing::Test
{
};
using Arms = testing::Types<PushingFalcon, PushingTwoDiy>;
TYPED_TEST_SUITE(BoardFaults, Arms);

TYPED_TEST(BoardFaults, EndTheForceWithinTwentyMillisecondsAndAreSaid)
{
  for (const BoardFault& fault : faults)
  {
    TypeParam arm;
    fault.happen(*arm.rig().board);
    arm.rig().run(20);
    EXPECT_TRUE(!fault.hears || arm.rig().board->force_N().norm() == 0.0) << fault.name;
    EXPECT_GE(arm.rig().lostTicks, 1) << fault.name;
    EXPECT_NE(arm.rig().status, DeviceStatus::Ok) << fault.name;
    EXPECT_THAT(arm.rig().device.linkReport().lostFor, testing::HasSubstr(fault.sentence)) << fault.name;
  }
}

TYPED_TEST(BoardFaults, ArmsThatAreUnpluggedAtAnyStepOfAnExchangeAreLost)
{
  for (int calls = 0; calls < 8; ++calls)
  {
    TypeParam arm;
    arm.rig().board->callsUntilUnplugged = calls;
    arm.rig().run(20);
    EXPECT_GE(arm.rig().lostTicks, 1) << calls;
    EXPECT_NE(arm.rig().device.linkReport().lostFor, "") << calls;
  }
}

TYPED_TEST(BoardFaults, OneWrongAnswerIsFollowedByNoForceAndThenByForceAgain)
{
  TypeParam arm;
  arm.rig().board->wrongAnswers = 1;
  arm.rig().tick();
  arm.rig().pass();
  arm.rig().tick();
  arm.rig().pass();
  EXPECT_EQ(arm.rig().board->force_N().norm(), 0.0);
  arm.rig().run(5);
  EXPECT_EQ(arm.rig().status, DeviceStatus::Ok);
  EXPECT_GT(arm.rig().board->force_N().norm(), 0.9);
}

TYPED_TEST(BoardFaults, AClockThatJumpsGivesNoForceThatNobodyAskedForAndLosesNothing)
{
  for (const std::int64_t jump_ns : { 3600 * 1000 * perMs_ns, -3600 * 1000 * perMs_ns })
  {
    TypeParam arm;
    arm.rig().time.pass(jump_ns);
    arm.rig().tick();
    arm.rig().pass();
    EXPECT_LT(arm.rig().board->force_N().norm(), 1.1);
    arm.rig().run(5);
    EXPECT_EQ(arm.rig().status, DeviceStatus::Ok) << jump_ns;
    EXPECT_NEAR(arm.rig().board->force_N().norm(), 1.0, 0.05) << jump_ns;
  }
}

TYPED_TEST(BoardFaults, GivesNoForceForCommandsThatAreNoNumbersAndNeverMoreThanItsMotorsCan)
{
  TypeParam arm;
  test::BoardRig& rig = arm.rig();
  for (const double wrong : { std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity() })
  {
    rig.command.wrench_D.force = { 0.0, wrong, 0.0 };
    rig.run(5);
    EXPECT_EQ(rig.board->force_N().norm(), 0.0);
  }
  rig.command.wrench_D.force = { 0.0, 1e9, 0.0 };
  rig.run(5);
  const Vec3 most_N = rig.board->force_N();
  // The Jacobian is that of the counted place: a count turns a force by less than 1 in 100.
  EXPECT_NEAR(most_N.y(), arm.largest_N(), rig.board->step_N() + 0.01 * arm.largest_N());
  EXPECT_LT(std::abs(most_N.x()), 0.02 * most_N.y()) << "what is too much is made smaller, not turned";
}

} // namespace
} // namespace palpate
