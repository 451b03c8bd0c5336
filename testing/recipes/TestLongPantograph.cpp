// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "devices/arm/kit/WireFile.h"
#include "testing/devices/arm/TwoDiyRig.h"

namespace palpate
{
namespace
{

TEST(RecipeOfAnArmOfAKnownWire, PushesAsItIsAsked)
{
  const Outcome<WiredArm> arm = wiredArmNamed(PALPATE_LONG_ARM);
  ASSERT_EQ(arm.problem, "");
  test::TwoDiyRig board(
    arm.value, { 0.1, 0.14, 0.04, { 180.0, 0.0 }, { 4.0, -4.0 }, 4096.0, { false, true }, { false, false } });
  ASSERT_EQ(board.rig.device.open(), "");
  board.setInPose();
  ASSERT_TRUE(board.model->lead({ 0.02, 0.17, 0.0 }));
  const Vec3 force_N(0.25, -0.5, 0.0);
  ask(board.rig, force_N);
  EXPECT_EQ(board.rig.status, DeviceStatus::Ok);
  EXPECT_LT(board.rig.sample.pose_D.p.norm(), 2e-4);
  EXPECT_LT((board.model->force_N() - force_N).norm(), board.model->step_N() + 5e-3);
}

} // namespace
} // namespace palpate
