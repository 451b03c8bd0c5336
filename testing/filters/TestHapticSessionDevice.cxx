// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "vtkHapticSession.h"
#include "vtkNew.h"

using ::testing::HasSubstr;
using ::testing::StrEq;

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
