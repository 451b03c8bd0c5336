// SPDX-License-Identifier: GPL-3.0-or-later
// The list of devices of the panel, without a window.
#include <memory>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pqHapticDeviceChoice.h"
#include "testing/devices/hid/FakeHidBus.h"
#include "vtkHapticKnownDevices.h"
#include "vtkHapticSession.h"
#include "vtkNew.h"

#include <QAbstractItemView>
#include <QApplication>

using namespace palpate;

namespace
{
constexpr const char* pluggedName = "pid-1209-ffb0-7";

class HapticDeviceChoice : public ::testing::Test
{
protected:
  void SetUp() override
  {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    this->application_ = std::make_unique<QApplication>(this->count_, this->arguments_);
    this->choice_ = std::make_unique<pqHapticDeviceChoice>();
    this->session_->GetDevices()->SetHidBus(this->bus_);
    this->choice_->setSession(this->session_);
  }

  void open()
  {
    this->choice_->showPopup();
    this->choice_->hidePopup();
  }

  QString tip(const char* device) const
  {
    return this->choice_->itemData(this->choice_->findText(device), Qt::ToolTipRole).toString();
  }

  int count_ = 1;
  char name_[5] = "test";
  char* arguments_[2] = { this->name_, nullptr };
  std::unique_ptr<QApplication> application_;
  std::unique_ptr<pqHapticDeviceChoice> choice_;
  std::shared_ptr<test::FakeHidBus> bus_ = std::make_shared<test::FakeHidBus>();
  vtkNew<vtkHapticSession> session_;
};

TEST_F(HapticDeviceChoice, ADeviceThatIsPluggedInLaterIsThereWhenTheListIsOpenedAndItsTipSaysWhatIsWrong)
{
  EXPECT_GE(this->choice_->findText("mouse"), 0);
  test::FakePort& port = this->bus_->plug(test::plainLayout(), "7");
  port.openProblem = "no permission";
  EXPECT_EQ(this->choice_->findText(pluggedName), -1);
  this->open();
  EXPECT_GE(this->choice_->findText(pluggedName), 0);
  EXPECT_EQ(this->tip(pluggedName), "no permission");
  port.openProblem.clear();
  this->open();
  EXPECT_EQ(this->tip(pluggedName), "");
}

// A person alone can lead neither; a program that chose one sees it.
TEST_F(HapticDeviceChoice, WhatOnlyAProgramCanLeadIsListedOnceAProgramHasChosenIt)
{
  for (const char* name : { "fed", "simulated-ideal", "simulated-joystick", "simulated-6d" })
  {
    this->session_->SetSetting("DeviceName", "mouse");
    this->open();
    EXPECT_EQ(this->choice_->findText(name), -1) << name;
    this->session_->SetSetting("DeviceName", name);
    this->open();
    EXPECT_EQ(this->choice_->currentText(), name);
  }
  this->session_->SetSetting("DeviceName", "mouse");
  this->open();
  EXPECT_GE(this->choice_->findText("replay"), 0);
}

TEST_F(HapticDeviceChoice, ASimulatedHandOnEachKindOfSoldDeviceIsListedAndItsTipSaysWhichDevice)
{
  for (const char* name : { "simulated-touch", "simulated-premium", "simulated-falcon", "simulated-omega" })
  {
    EXPECT_GE(this->choice_->findText(name), 0) << name;
  }
  EXPECT_THAT(this->tip("simulated-touch").toStdString(), ::testing::HasSubstr("a desktop stylus arm"));
}

TEST_F(HapticDeviceChoice, WhatAProgramChoosesIsShownWithoutTheListBeingOpened)
{
  int heard = 0;
  QObject::connect(this->choice_.get(), &QComboBox::currentTextChanged, [&] { ++heard; });
  for (const char* name : { "fed", "simulated-generic", "mouse" })
  {
    this->session_->SetSetting("DeviceName", name);
    this->choice_->follow();
    EXPECT_EQ(this->choice_->currentText(), name);
  }
  EXPECT_EQ(heard, 0);
}

TEST_F(HapticDeviceChoice, WhatIsPluggedInAndPushesIsMeantElseTheMouse)
{
  EXPECT_STREQ(this->session_->GetDevices()->GetPreferred(), "mouse");
  test::FakePort& port = this->bus_->plug(test::plainLayout(), "7");
  this->open();
  EXPECT_STREQ(this->session_->GetDevices()->GetPreferred(), pluggedName);
  port.openProblem = "no permission";
  this->open();
  EXPECT_STREQ(this->session_->GetDevices()->GetPreferred(), "mouse");
}

TEST_F(HapticDeviceChoice, AChosenDeviceStaysChosenWhenItIsUnpluggedAndNobodyHearsOfTheList)
{
  test::FakePort& port = this->bus_->plug(test::plainLayout(), "7");
  this->open();
  this->session_->SetSetting("DeviceName", pluggedName);
  this->choice_->setSession(this->session_);
  int heard = 0;
  QObject::connect(this->choice_.get(), &QComboBox::currentTextChanged, [&] { ++heard; });
  for (const bool present : { false, true })
  {
    port.present = present;
    this->open();
    EXPECT_EQ(this->choice_->currentText(), pluggedName);
    EXPECT_EQ(this->tip(pluggedName), present ? "" : "the device is not attached");
  }
  EXPECT_EQ(heard, 0);
}

} // namespace
