// SPDX-License-Identifier: GPL-3.0-or-later
// Two tools in two hands, against each other.
#include <gtest/gtest.h>

#include <cmath>

#include "Tools.h"
#include "haptics/tool/move/ToolPair.h"
#include "haptics/tool/worker/ToolFollower.h"
#include "testing/support/NoisySphere.h"

namespace palpate::test
{
namespace
{

constexpr double halfOfPaired_mm = 10.0;

ToolMesh cubeOf(double half)
{
  return makeTool(makeBox(Vec3::Constant(-half), Vec3::Constant(half))).value;
}

ToolPair::Poses along(double first_mm, double second_mm)
{
  return { Pose{ Vec3(first_mm, 0, 0), Quat::Identity() }, Pose{ Vec3(second_mm, 0, 0), Quat::Identity() } };
}

bool rests(ToolPair& pair, const ToolPair::Poses& hands_W)
{
  bool still = false;
  for (int i = 0; i < 40 && !still; ++i)
  {
    still = pair.update(hands_W, plenty);
  }
  return still;
}

} // namespace

TEST(ToolPair, PressedFaceToFaceEachGivesWayByTheOthersShareOfBothStiffnesses)
{
  const ToolMesh cube = cubeOf(halfOfPaired_mm);
  for (const double second_N_per_mm : { 0.01, 0.5, 1.0, 3.0, 100.0 })
  {
    constexpr double first_N_per_mm = 1.0, pressed_mm = 2.0;
    ToolPair pair(cube, cube,
      { ToolPair::Hold{ cube.gyration_u, first_N_per_mm }, ToolPair::Hold{ cube.gyration_u, second_N_per_mm } });
    ASSERT_EQ(pair.place(along(-halfOfPaired_mm - 1.0, halfOfPaired_mm + 1.0)), "");
    const ToolPair::Poses hands_W = along(-halfOfPaired_mm + 0.5 * pressed_mm, halfOfPaired_mm - 0.5 * pressed_mm);
    ASSERT_TRUE(rests(pair, hands_W)) << second_N_per_mm;
    // Two springs in a row: their compressions add up to the hands' overlap and the rest gap.
    const double between_mm = pressed_mm + cube.restGap_u();
    const double both_N_per_mm = first_N_per_mm * second_N_per_mm / (first_N_per_mm + second_N_per_mm);
    const double push_N = both_N_per_mm * between_mm;
    EXPECT_NEAR(pair.poses_W()[0].p.x(), hands_W[0].p.x() - push_N / first_N_per_mm, 1e-5);
    EXPECT_NEAR(pair.poses_W()[1].p.x(), hands_W[1].p.x() + push_N / second_N_per_mm, 1e-5);
    const ToolPair::Pushes pushes = pair.pushes(hands_W);
    EXPECT_LE((pushes[0].force - Vec3(-push_N, 0, 0)).norm(), 1e-5 * push_N);
    EXPECT_LE((pushes[0].force + pushes[1].force).norm(), 1e-12 * push_N) << "what one feels the other feels";
    EXPECT_LE(pushes[0].torque.norm() + pushes[1].torque.norm(), 1e-6 * push_N * halfOfPaired_mm);
  }
}

TEST(ToolPair, AskewTheTorquesAndForcesOfBothAreInBalance)
{
  const ToolMesh small = cubeOf(6.0), large = cubeOf(halfOfPaired_mm);
  ToolPair pair(small, large, { ToolPair::Hold{ small.gyration_u, 1.0 }, ToolPair::Hold{ large.gyration_u, 2.0 } });
  const ToolPair::Poses start_W{ Pose{ Vec3(-20, 3, 1), turnBy(Vec3(0.1, 0.2, 0.3)) }, Pose{ Vec3::Zero() } };
  ASSERT_EQ(pair.place(start_W), "");
  ToolPair::Poses hands_W = start_W;
  hands_W[0].p.x() = -12.0;
  ASSERT_TRUE(rests(pair, hands_W));
  const ToolPair::Pushes pushes = pair.pushes(hands_W);
  EXPECT_GT(pushes[0].force.norm(), 0.1);
  EXPECT_LE((pushes[0].force + pushes[1].force).norm(), 1e-12 * pushes[0].force.norm());
  const Vec3 about_W = pushes[0].torque + pushes[1].torque + pair.poses_W()[0].p.cross(pushes[0].force) +
                       pair.poses_W()[1].p.cross(pushes[1].force);
  EXPECT_LE(about_W.norm(), 1e-9 * halfOfPaired_mm);
  // At rest each push is the spring from its tool to its hand.
  for (std::size_t i = 0; i < 2; ++i)
  {
    const double stiffness = i == 0 ? 1.0 : 2.0;
    EXPECT_LE((pushes[i].force - stiffness * (pair.poses_W()[i].p - hands_W[i].p)).norm(), 1e-4);
  }
}

TEST(ToolPair, ThrownAtEachOtherWhileBothTurnNeitherPassesTheOther)
{
  Random random(testSeed(2401));
  const ToolMesh one = makeTool(scaled(NoisySphere(200, 1.0).mesh(), 0.2)).value;
  const ToolMesh other = makeTool(scaled(NoisySphere(300, 1.0).mesh(), 0.3)).value;
  ToolPair pair(one, other, { ToolPair::Hold{ one.gyration_u, 1.0 }, ToolPair::Hold{ other.gyration_u, 2.0 } });
  CrossingJudge ofOne(*one.shape_B, *other.shape_B, 2), ofOther(*other.shape_B, *one.shape_B, 2);
  pair.watch(0, &ofOne);
  pair.watch(1, &ofOther);
  const std::size_t throws = testCount(4);
  std::size_t pushed = 0;
  for (std::size_t i = 0; i < throws; ++i)
  {
    const Vec3 way = random.direction();
    ASSERT_EQ(pair.place({ Pose{ -30.0 * way, Quat::Identity() }, Pose{ 30.0 * way, Quat::Identity() } }), "");
    const Vec3 aside = 5.0 * random.direction();
    for (int k = 1; k <= 8; ++k)
    {
      const double s = k / 8.0;
      const ToolPair::Poses hands_W{ Pose{ (60.0 * s - 30.0) * way + s * aside, turnBy(s * 1.4 * random.direction()) },
        Pose{ (30.0 - 60.0 * s) * way, turnBy(s * 1.4 * random.direction()) } };
      pair.update(hands_W, ToolFollower::usualWork);
      pushed += pair.pushes(hands_W)[0].force.norm() > 0.0 ? 1 : 0;
    }
  }
  EXPECT_EQ(ofOne.found() + ofOther.found(), 0u) << "of " << ofOne.judged() + ofOther.judged();
  EXPECT_GT(pushed, throws);
}

} // namespace palpate::test
