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

int indexOf(const vtkHapticSession* session, const std::string& name)
{
  for (int i = 0; i < session->GetNumberOfKnownDevices(); ++i)
  {
    if (session->GetKnownDeviceName(i) == name)
    {
      return i;
    }
  }
  return -1;
}

/// A joystick that holds the wall y = 0, its hand led 3 mm below it.
void feelWall(vtkHapticSession* session)
{
  session->VirtualTimeOn();
  session->SetStiffness(200.0);
  session->SetDeviceName("simulated-joystick");
  session->SetHand("firm");
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
  EXPECT_THAT(session->GetDeviceNotes(), HasSubstr("gives no force"));
  session->SetDeviceName("simulated-joystick");
  EXPECT_THAT(session->GetDeviceKind(), StrEq("2 axes of force"));
  EXPECT_THAT(session->GetDeviceNotes(), HasSubstr("what pushes along z is not felt"));
  session->SetDeviceName("simulated-ideal");
  EXPECT_THAT(session->GetDeviceNotes(), StrEq(""));
}

TEST(HapticSessionDevice, ADeviceWithoutALinkHasNothingToSayAboutOne)
{
  vtkNew<vtkHapticSession> session;
  session->VirtualTimeOn();
  session->TouchingOn();
  session->Step(100);
  EXPECT_THAT(session->GetLinkText(), StrEq(""));
  EXPECT_EQ(session->GetLinkRate(), 0.0);
  EXPECT_EQ(session->GetLinkStalls() + session->GetLinkLosses() + session->GetLinkStrange(), 0);
  EXPECT_EQ(session->GetLinkRestarts(), 0);
}

// What is touched and how depends on who touches it: another choice waits until touching starts again.
TEST(HapticSessionDevice, ADeviceThatIsChosenMeanwhileChangesNothingOfTheOneThatRuns)
{
  vtkNew<vtkHapticSession> asBefore, chosenAnew;
  feelWall(asBefore);
  feelWall(chosenAnew);
  chosenAnew->SetDeviceName("simulated-premium");
  EXPECT_TRUE(chosenAnew->GetRaisesLines());
  chosenAnew->SetDeviceName("mouse");
  EXPECT_TRUE(chosenAnew->GetDeviceGivesForce());
  chosenAnew->SetDeviceName("simulated-premium");
  EXPECT_THAT(chosenAnew->GetPlanSentence(), StrEq(asBefore->GetPlanSentence()));
  chosenAnew->FitWorkspace();
  asBefore->FitWorkspace();
  EXPECT_EQ(chosenAnew->GetScale(), asBefore->GetScale());
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
  EXPECT_THAT(chosenAnew->GetPlanSentence(), HasSubstr("the device holds none; the hand is led to the plane"));
}

TEST(HapticSessionDevice, AMouseThatIsChosenMeanwhileLeadsNoOtherHand)
{
  vtkNew<vtkHapticSession> session;
  session->VirtualTimeOn();
  session->TouchingOn();
  session->SetDeviceName("mouse");
  EXPECT_FALSE(session->GetFollowsMouse());
  EXPECT_THAT(session->GetDeviceName(), StrEq("mouse"));
  session->TouchingOff();
  EXPECT_TRUE(session->GetFollowsMouse());
  session->TouchingOn();
  session->SetDeviceName("fed");
  EXPECT_TRUE(session->GetFollowsMouse());
}

TEST(HapticSessionDevice, OneThatIsPluggedInLaterIsFoundWhenDevicesAreLookedForAndItsProblemIsSaid)
{
  const auto bus = std::make_shared<test::FakeHidBus>();
  vtkNew<vtkHapticSession> session;
  session->SetHidBus(bus);
  EXPECT_EQ(indexOf(session, pluggedName), -1);
  test::FakePort& port = bus->plug(test::plainLayout(), "7");
  port.openProblem = "no permission";
  session->LookForDevices();
  const int index = indexOf(session, pluggedName);
  ASSERT_GE(index, 0);
  EXPECT_THAT(session->GetKnownDeviceProblem(index), StrEq("no permission"));
  session->SetDeviceName(pluggedName);
  EXPECT_THAT(session->GetDeviceNotes(), HasSubstr("Cannot be used now: no permission"));
  port.openProblem.clear();
  session->LookForDevices();
  EXPECT_THAT(session->GetDeviceNotes(), Not(HasSubstr("Cannot be used now")));
}

TEST(HapticSessionDevice, AChosenOneThatIsUnpluggedIsStillKnownForWhatItWas)
{
  const auto bus = std::make_shared<test::FakeHidBus>();
  test::FakePort& port = bus->plug(test::plainLayout(), "7");
  vtkNew<vtkHapticSession> session;
  session->SetHidBus(bus);
  session->SetDeviceName(pluggedName);
  const std::string kind = session->GetDeviceKind();
  EXPECT_THAT(kind, StrEq("2 axes of force"));
  port.present = false;
  for (const char* folder : { "one", "another", "" }) // whatever is known is looked up anew
  {
    session->SetCalibrationFolder(folder);
    EXPECT_THAT(session->GetDeviceName(), StrEq(pluggedName));
    EXPECT_THAT(session->GetDeviceKind(), StrEq(kind));
    EXPECT_TRUE(session->GetDeviceGivesForce());
  }
  EXPECT_THAT(session->GetDeviceNotes(), HasSubstr("Cannot be used now: it is not plugged in"));
  EXPECT_THAT(errorsOf(session, [&] { session->TouchingOn(); }), ::testing::SizeIs(1));
}

TEST(HapticSessionDevice, WhyADeviceIsLostIsSaid)
{
  const auto bus = std::make_shared<test::FakeHidBus>(false);
  test::FakePort& port = bus->plug(test::plainLayout(), "7");
  vtkNew<vtkHapticSession> session;
  session->SetHidBus(bus);
  session->VirtualTimeOn();
  session->SetDeviceName(pluggedName);
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
  EXPECT_TRUE(says("\"plain stick\" 7 is not there: plug it in; then engage again")) << session->GetFaultText();
  bus->alone([&] { return port.device->silent = port.present = true; });
  EXPECT_TRUE(
    says("the device was lost: it was unplugged; it is there again, but it has not said yet where the hand is: "
         "move it, then engage again"))
    << session->GetFaultText();
  bus->alone([&] { return port.device->silent = false; });
  EXPECT_TRUE(says("the device was lost: it was unplugged; it is there again: engage again"))
    << session->GetFaultText();
}

TEST(HapticSessionDevice, AMaskOfButtonsThatIsNoneIsRefusedAndSaid)
{
  vtkNew<vtkHapticSession> session;
  session->SetDeadManButtons(1 << 3);
  EXPECT_THAT(errorsOf(session, [&] { session->SetDeadManButtons(-1); }), ::testing::SizeIs(1));
  EXPECT_THAT(session->GetProblem(), HasSubstr("bit i stands for button i + 1"));
  EXPECT_EQ(session->GetDeadManButtons(), 1 << 3);
}

TEST(HapticSessionDevice, AGripThatADeviceDoesNotHaveIsSaidWhereItIsAskedFor)
{
  const auto bus = std::make_shared<test::FakeHidBus>();
  bus->plug(test::plainLayout(), "7");
  test::PidLayout gripless = test::plainLayout();
  gripless.stateId = 0;
  bus->plug(gripless, "8");
  vtkNew<vtkHapticSession> session;
  session->SetHidBus(bus);
  session->SetDeviceName("pid-1209-ffb0-8");
  EXPECT_THAT(session->GetDeviceNotes(), Not(HasSubstr("grip")));
  session->DeadManGripOn();
  EXPECT_THAT(session->GetDeviceNotes(), HasSubstr("no grip sensor"));
  session->SetDeviceName(pluggedName);
  EXPECT_THAT(session->GetDeviceNotes(), Not(HasSubstr("grip")));
}

TEST(HapticSessionDevice, WhoDoesNotHoldTheDeadManIsToldWhileTouching)
{
  vtkNew<vtkHapticSession> session;
  session->VirtualTimeOn();
  session->SetDeadManButtons(1);
  session->TouchingOn();
  session->Step(10);
  session->Update();
  EXPECT_THAT(session->GetWarning(), HasSubstr("dead-man is not held"));
  session->TouchingOff();
  EXPECT_THAT(session->GetWarning(), StrEq(""));
}

// Both buttons at once: the first one chooses, unless it is what holds the hand engaged.
TEST(HapticSessionDevice, ItsButtonsChooseALabyrinthOnceUnlessTheyHoldTheHandEngaged)
{
  const auto wishes = [](int deadMan, std::vector<std::uint32_t> pressed)
  {
    const auto bus = std::make_shared<test::FakeHidBus>();
    test::FakePort& port = bus->plug(test::plainLayout(), "7");
    vtkNew<vtkHapticSession> session;
    session->SetHidBus(bus);
    session->VirtualTimeOn();
    session->SetDeviceName(pluggedName);
    session->SetDeadManButtons(deadMan);
    session->TouchingOn();
    EXPECT_TRUE(session->GetTouching()) << session->GetProblem();
    session->Step(10);
    EXPECT_EQ(session->TakeLabyrinthWish(), 0);
    std::vector<int> seen;
    for (const std::uint32_t buttons : pressed)
    {
      bus->alone([&] { port.device->buttons = buttons; });
      int wish = 0;
      EXPECT_TRUE(test::eventually(
        [&]
        {
          session->Step(1);
          wish = session->TakeLabyrinthWish();
          return wish != 0;
        }));
      seen.push_back(wish);
      session->Step(10);
      EXPECT_EQ(session->TakeLabyrinthWish(), 0) << "held down, it asks once";
    }
    return seen;
  };
  EXPECT_THAT(wishes(0, { 1, 2, 1 }), ElementsAre(1, 2, 1)); // button n, labyrinth n
  EXPECT_THAT(wishes(0, { 3 }), ElementsAre(1));
  EXPECT_THAT(wishes(1, { 3 }), ElementsAre(2));
}
