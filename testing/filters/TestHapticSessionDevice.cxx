// SPDX-License-Identifier: GPL-3.0-or-later
// Devices that are chosen, unplugged, plugged in, and chosen while another one runs. Virtual time.
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "VirtualSession.h"
#include "VtkScenes.h"
#include "testing/devices/hid/FakeHidBus.h"
#include "testing/support/Eventually.h"
#include "testing/support/Says.h"
#include "vtkHapticDeviceCheck.h"
#include "vtkHapticKnownDevices.h"
#include "vtkHapticLabyrinthGame.h"
#include "vtkPolyData.h"

using namespace palpate;
using namespace palpate::testing;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StrEq;

namespace
{
constexpr const char* pluggedName = "pid-1209-ffb0-7";

int indexOf(vtkHapticSession* session, const std::string& name)
{
  for (int i = 0; i < session->GetDevices()->GetNumberOfDevices(); ++i)
  {
    if (session->GetDevices()->GetName(i) == name)
    {
      return i;
    }
  }
  return -1;
}

/// A joystick that holds the wall y = 0, its hand led 3 mm below it.
void feelWall(vtkHapticSession* session)
{
  session->SetSetting("VirtualTime", true);
  session->SetSetting("Stiffness", 200.0);
  session->SetSetting("DeviceName", "simulated-joystick");
  session->SetSetting("Hand", "firm");
  session->AddStrokePoint(0, 5, 0);
  session->AddStrokePoint(10, -3, 0);
  ASSERT_TRUE(session->AddSurface("line", makePath({ { -40, 0, 0 }, { 40, 0, 0 } }), nullptr));
  session->CommitScene();
  ASSERT_TRUE(session->FinishScene());
  session->TouchingOn();
  ASSERT_TRUE(session->GetTouching()) << session->GetProblem();
  session->Step(ticksToEngage);
}
} // namespace

TEST(HapticSessionDevice, WhatTheChosenDeviceIsAndCannotDoIsSaidBeforeItIsTouched)
{
  vtkNew<vtkHapticSession> session;
  EXPECT_THAT(session->GetDeviceKind(), StrEq("motion, no force"));
  EXPECT_THAT(session->GetDeviceNotes(), HasSubstr("renders no force"));
  session->SetSetting("DeviceName", "simulated-joystick");
  EXPECT_THAT(session->GetDeviceKind(), StrEq("2 axes of force"));
  EXPECT_THAT(session->GetDeviceNotes(), HasSubstr("force along z is not felt"));
  session->SetSetting("DeviceName", "simulated-ideal");
  EXPECT_THAT(session->GetDeviceNotes(), StrEq(""));
}

TEST(HapticSessionDevice, ADeviceWithoutALinkHasNothingToSayAboutOne)
{
  vtkNew<vtkHapticSession> session;
  session->SetSetting("VirtualTime", true);
  session->TouchingOn();
  session->Step(100);
  EXPECT_THAT(session->GetLinkText(), StrEq(""));
  EXPECT_EQ(session->GetDevices()->GetLinkRate(), 0.0);
  EXPECT_EQ(session->GetDevices()->GetLinkStalls() + session->GetDevices()->GetLinkLosses() +
              session->GetDevices()->GetLinkStrange(),
    0);
  EXPECT_EQ(session->GetDevices()->GetLinkRestarts(), 0);
}

// Device and surfaces are chosen by the person who touches: another choice waits until touching starts again.
TEST(HapticSessionDevice, ADeviceThatIsChosenMeanwhileChangesNothingOfTheOneThatRuns)
{
  vtkNew<vtkHapticSession> asBefore, chosenAnew;
  feelWall(asBefore);
  feelWall(chosenAnew);
  chosenAnew->SetSetting("DeviceName", "simulated-premium");
  EXPECT_TRUE(chosenAnew->GetRaisesLines());
  chosenAnew->SetSetting("DeviceName", "mouse");
  EXPECT_TRUE(chosenAnew->GetDeviceGivesForce());
  chosenAnew->SetSetting("DeviceName", "simulated-premium");
  EXPECT_THAT(chosenAnew->GetPlanText(), StrEq(asBefore->GetPlanText()));
  chosenAnew->FitWorkspace();
  asBefore->FitWorkspace();
  EXPECT_EQ(chosenAnew->GetSetting("Scale"), asBefore->GetSetting("Scale"));
  int mostHeld = 0;
  for (int i = 0; i < 100; ++i)
  {
    asBefore->Step(10);
    chosenAnew->Step(10);
    mostHeld = std::max(mostHeld, asBefore->GetWallsHeld());
    ASSERT_EQ(chosenAnew->GetWallsHeld(), asBefore->GetWallsHeld());
    for (int axis = 0; axis < 3; ++axis)
    {
      ASSERT_EQ(chosenAnew->GetForce()[axis], asBefore->GetForce()[axis]);
      ASSERT_EQ(chosenAnew->GetHandPosition()[axis], asBefore->GetHandPosition()[axis]);
    }
  }
  EXPECT_GE(mostHeld, 1);
  chosenAnew->TouchingOff();
  EXPECT_FALSE(chosenAnew->GetRaisesLines());
  EXPECT_TRUE(test::says(chosenAnew->GetPlanText(), { "device holds none", "guided" }));
}

TEST(HapticSessionDevice, AMouseThatIsChosenMeanwhileLeadsNoOtherHand)
{
  vtkNew<vtkHapticSession> session;
  session->SetSetting("VirtualTime", true);
  session->TouchingOn();
  session->SetSetting("DeviceName", "mouse");
  EXPECT_FALSE(session->GetFollowsMouse());
  EXPECT_THAT(session->GetSettingText("DeviceName"), StrEq("mouse"));
  session->TouchingOff();
  EXPECT_TRUE(session->GetFollowsMouse());
  session->TouchingOn();
  session->SetSetting("DeviceName", "fed");
  EXPECT_TRUE(session->GetFollowsMouse());
}

TEST(HapticSessionDevice, OneThatIsPluggedInLaterIsFoundWhenDevicesAreLookedForAndItsProblemIsSaid)
{
  const auto bus = std::make_shared<test::FakeHidBus>();
  vtkNew<vtkHapticSession> session;
  session->GetDevices()->SetHidBus(bus);
  EXPECT_EQ(indexOf(session, pluggedName), -1);
  test::FakePort& port = bus->plug(test::plainLayout(), "7");
  port.openProblem = "no permission";
  session->GetDevices()->Look();
  const int index = indexOf(session, pluggedName);
  ASSERT_GE(index, 0);
  EXPECT_THAT(session->GetDevices()->GetProblem(index), StrEq("no permission"));
  session->SetSetting("DeviceName", pluggedName);
  EXPECT_THAT(session->GetDeviceNotes(), HasSubstr("Cannot be used now: no permission"));
  port.openProblem.clear();
  session->GetDevices()->Look();
  EXPECT_THAT(session->GetDeviceNotes(), Not(HasSubstr("Cannot be used now")));
}

TEST(HapticSessionDevice, AChosenOneThatIsUnpluggedIsStillKnownForWhatItWas)
{
  const auto bus = std::make_shared<test::FakeHidBus>();
  test::FakePort& port = bus->plug(test::plainLayout(), "7");
  vtkNew<vtkHapticSession> session;
  session->GetDevices()->SetHidBus(bus);
  session->SetSetting("DeviceName", pluggedName);
  const std::string kind = session->GetDeviceKind();
  EXPECT_THAT(kind, StrEq("2 axes of force"));
  port.present = false;
  for (const char* folder : { "one", "another", "" }) // whatever is known is looked up anew
  {
    session->GetDeviceCheck()->SetCalibrationFolder(folder);
    EXPECT_THAT(session->GetSettingText("DeviceName"), StrEq(pluggedName));
    EXPECT_THAT(session->GetDeviceKind(), StrEq(kind));
    EXPECT_TRUE(session->GetDeviceGivesForce());
  }
  EXPECT_TRUE(test::says(session->GetDeviceNotes(), { "Cannot be used now", "not attached" }));
  EXPECT_THAT(errorsOf(session, [&] { session->TouchingOn(); }), ::testing::SizeIs(1));
}

TEST(HapticSessionDevice, WhyADeviceIsLostIsSaid)
{
  const auto bus = std::make_shared<test::FakeHidBus>(false);
  test::FakePort& port = bus->plug(test::plainLayout(), "7");
  vtkNew<vtkHapticSession> session;
  session->GetDevices()->SetHidBus(bus);
  session->SetSetting("VirtualTime", true);
  session->SetSetting("DeviceName", pluggedName);
  session->TouchingOn();
  ASSERT_TRUE(session->GetTouching()) << session->GetProblem();
  EXPECT_THAT(session->GetLinkText(), HasSubstr(" 0 out of range"));
  const auto says = [&](const char* text)
  {
    return test::eventually(
      [&]
      {
        bus->advance(1);
        session->Step(1);
        session->Update();
        return std::string(session->GetFaultText()).find(text) != std::string::npos;
      });
  };
  bus->alone([&] { return port.present = false; });
  EXPECT_TRUE(says("\"plain stick\" 7 is not attached: plug the device in; then engage again"))
    << session->GetFaultText();
  bus->alone([&] { return port.device->silent = port.present = true; });
  EXPECT_TRUE(says("attached again, but the device has not reported a position yet")) << session->GetFaultText();
  bus->alone([&] { return port.device->silent = false; });
  EXPECT_TRUE(says("attached again: engage again")) << session->GetFaultText();
}

TEST(HapticSessionDevice, AMaskOfButtonsThatIsNoneIsRefusedAndSaid)
{
  vtkNew<vtkHapticSession> session;
  session->SetSetting("DeadManButtons", 1 << 3);
  EXPECT_THAT(errorsOf(session, [&] { session->SetSetting("DeadManButtons", -1); }), ::testing::SizeIs(1));
  EXPECT_THAT(session->GetProblem(), HasSubstr("Bit i stands for button i + 1"));
  EXPECT_EQ(session->GetSetting("DeadManButtons"), 1 << 3);
}

TEST(HapticSessionDevice, AGripThatADeviceDoesNotHaveIsSaidWhereItIsAskedFor)
{
  const auto bus = std::make_shared<test::FakeHidBus>();
  bus->plug(test::plainLayout(), "7");
  test::PidLayout gripless = test::plainLayout();
  gripless.stateId = 0;
  bus->plug(gripless, "8");
  vtkNew<vtkHapticSession> session;
  session->GetDevices()->SetHidBus(bus);
  session->SetSetting("DeviceName", "pid-1209-ffb0-8");
  EXPECT_THAT(session->GetDeviceNotes(), Not(HasSubstr("grip")));
  session->SetSetting("DeadManGrip", true);
  EXPECT_THAT(session->GetDeviceNotes(), HasSubstr("no grip sensor"));
  session->SetSetting("DeviceName", pluggedName);
  EXPECT_THAT(session->GetDeviceNotes(), Not(HasSubstr("grip")));
}

TEST(HapticSessionDevice, WhoDoesNotHoldTheDeadManIsToldWhileTouching)
{
  vtkNew<vtkHapticSession> session;
  session->SetSetting("VirtualTime", true);
  session->SetSetting("DeadManButtons", 1);
  session->TouchingOn();
  session->Step(10);
  session->Update();
  EXPECT_THAT(session->GetWarning(), HasSubstr("dead-man switch is released"));
  session->TouchingOff();
  EXPECT_THAT(session->GetWarning(), StrEq(""));
}

// Both buttons at once: the first one chooses, unless it holds the hand engaged.
TEST(HapticSessionDevice, ItsButtonsChooseALabyrinthOnceUnlessTheyHoldTheHandEngaged)
{
  const auto wishes = [](int deadMan, std::vector<std::uint32_t> pressed)
  {
    const auto bus = std::make_shared<test::FakeHidBus>();
    test::FakePort& port = bus->plug(test::plainLayout(), "7");
    vtkNew<vtkHapticSession> session;
    session->GetDevices()->SetHidBus(bus);
    session->SetSetting("VirtualTime", true);
    session->SetSetting("DeviceName", pluggedName);
    session->SetSetting("DeadManButtons", deadMan);
    session->TouchingOn();
    EXPECT_TRUE(session->GetTouching()) << session->GetProblem();
    session->Step(10);
    EXPECT_EQ(session->GetLabyrinth()->TakeWish(), 0);
    std::vector<int> seen;
    for (const std::uint32_t buttons : pressed)
    {
      bus->alone([&] { port.device->buttons = buttons; });
      int wish = 0;
      EXPECT_TRUE(test::eventually(
        [&]
        {
          session->Step(1);
          wish = session->GetLabyrinth()->TakeWish();
          return wish != 0;
        }));
      seen.push_back(wish);
      session->Step(10);
      EXPECT_EQ(session->GetLabyrinth()->TakeWish(), 0) << "held down, it asks once";
    }
    return seen;
  };
  EXPECT_THAT(wishes(0, { 1, 2, 1 }), ElementsAre(1, 2, 1)); // button n, labyrinth n
  EXPECT_THAT(wishes(0, { 3 }), ElementsAre(1));
  EXPECT_THAT(wishes(1, { 3 }), ElementsAre(2));
}
