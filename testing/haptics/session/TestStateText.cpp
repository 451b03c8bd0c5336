// SPDX-License-Identifier: GPL-3.0-or-later
// One line with status, reason and remedy.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "haptics/core/Fault.h"
#include "haptics/session/StateText.h"
#include "haptics/session/Warning.h"

namespace palpate
{
namespace
{

TEST(StateText, WhatNothingCanBeFeltWithoutComesFirst)
{
  SessionGlance glance;
  EXPECT_EQ(stateText(glance), "Press Touch to touch the visible data.");
  glance.problem = "the file is gone: choose another";
  EXPECT_EQ(stateText(glance), "The file is gone: choose another.");
  glance.touching = true;
  glance.engage = EngageState::Armed;
  glance.warning = "the dead-man switch is released: hold its button";
  EXPECT_EQ(stateText(glance), "No force: The dead-man switch is released: hold its button.");
  glance.engage = EngageState::Engaged;
  EXPECT_EQ(stateText(glance), "Touching. The dead-man switch is released: hold its button.");
  glance.fault = "the device is lost";
  EXPECT_EQ(stateText(glance), "No force: The device is lost.");
  glance.refusal = "No data are visible: open a file.";
  EXPECT_EQ(stateText(glance), "No force: No data are visible: open a file.");
}

TEST(StateText, WithoutATroubleItSaysWhatToDoNext)
{
  SessionGlance glance;
  glance.touching = true;
  glance.engage = EngageState::Armed;
  EXPECT_EQ(stateText(glance), "Waiting: move the hand out of the data it overlaps, then the force starts.");
  glance.engage = EngageState::Engaged;
  EXPECT_EQ(stateText(glance), "Touching.");
}

TEST(StateText, DataThatAreBeingPreparedAreNotSaidToBeMissingAndADeviceThatIsLostIsSaid)
{
  SessionGlance glance;
  glance.touching = glance.preparing = true;
  glance.fault = describe(Fault::SceneRefused);
  EXPECT_EQ(stateText(glance), "Preparing the visible data: the force starts when they are ready.");
  glance.refusal = "No data are visible: open a file.";
  EXPECT_EQ(stateText(glance), "Preparing the visible data: the force starts when they are ready.");
  glance.fault = describe(Fault::DeviceLost);
  glance.refusal = "";
  EXPECT_EQ(stateText(glance), "No force: The device stopped answering: plug the device in again, then engage again.");
}

TEST(StateText, ASurfaceThatWasRefusedIsNamedWhereNothingElseIsLeftAndADamagedOneWhereThereIsNoOtherTrouble)
{
  SessionGlance glance;
  glance.refused = "bad.stl: none of its 3 triangles can be touched";
  EXPECT_EQ(stateText(glance), "Press Touch to touch the visible data.") << "the session found no fault yet";
  glance.fault = describe(Fault::SceneRefused);
  EXPECT_EQ(stateText(glance), "No force: bad.stl: none of its 3 triangles can be touched.");
  glance.fault = describe(Fault::DeviceLost);
  EXPECT_THAT(stateText(glance), ::testing::HasSubstr("The device stopped answering"));
  glance = {};
  glance.damaged = "skull.stl: 42 of 3040 triangles are left out";
  EXPECT_EQ(stateText(glance), "skull.stl: 42 of 3040 triangles are left out.");
  glance.touching = true;
  glance.engage = EngageState::Engaged;
  EXPECT_EQ(stateText(glance), "Touching. skull.stl: 42 of 3040 triangles are left out.");
  glance.problem = "the file is gone: choose another";
  EXPECT_EQ(stateText(glance), "Touching. The file is gone: choose another.");
}

TEST(StateText, AForceThatIsCutIsSaidWithItsSizeBeforeWhatElseThereIs)
{
  SessionGlance glance;
  glance.touching = true;
  glance.engage = EngageState::Engaged;
  glance.limitedTo_N = 3.0;
  EXPECT_EQ(stateText(glance), "Touching, force limited to 3 N.");
  glance.preparing = true;
  EXPECT_EQ(stateText(glance), "Touching, force limited to 3 N.") << "other data are prepared while these are felt";
  glance.preparing = false;
  glance.problem = "the file is gone: choose another";
  EXPECT_EQ(stateText(glance), "Touching, force limited to 3 N. The file is gone: choose another.");
}

TEST(StateText, ADepthThatAsksForMoreThanTheLargestForceIsSaidBeforeTheTouch)
{
  SessionGlance glance;
  glance.limitedFrom_m = 3.0 / 2000.0; // N by N/m
  EXPECT_EQ(
    stateText(glance), "Press Touch to touch the visible data. The force grows no more from a depth of 1.5 mm on.");
  glance.problem = "the file is gone: choose another";
  EXPECT_EQ(stateText(glance), "The file is gone: choose another.");
}

TEST(StateText, AnotherDeviceThanTheOneThatRunsIsSaid)
{
  EXPECT_EQ(otherDeviceText("mouse", "mouse"), "");
  EXPECT_EQ(otherDeviceText("mouse", "replay"), "mouse still moves the hand: release and touch again to use replay");
}

} // namespace
} // namespace palpate
