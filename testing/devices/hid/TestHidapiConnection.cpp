// SPDX-License-Identifier: GPL-3.0-or-later
// Our side of hidapi, against functions of the same names over virtual devices.
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "devices/hid/HidapiBus.h"
#include "devices/io/HidDiscovery.h"
#include "devices/io/PidDevice.h"
#include "testing/devices/hid/FakeHidapi.h"
#include "testing/support/TemporaryFolder.h"

namespace palpate
{
namespace
{

namespace fs = std::filesystem;

/// A computer with virtual devices: hidapi's functions and the folder that tells their descriptors.
class HidapiConnection : public testing::Test
{
protected:
  HidapiConnection() : fake(*plugged), bus(systemHidBus(this->sysfs.path().string())) {}

  test::FakePort& plug(const test::PidLayout& layout, const std::string& serial)
  {
    test::FakePort& port = this->plugged->plug(layout, serial);
    const fs::path folder = this->sysfs.path() / port.entry.path / "device";
    fs::create_directories(folder);
    std::ofstream file(folder / "report_descriptor", std::ios::binary);
    file.write(
      reinterpret_cast<const char*>(port.descriptor.data()), static_cast<std::streamsize>(port.descriptor.size()));
    return port;
  }

  std::shared_ptr<test::FakeHidBus> plugged = std::make_shared<test::FakeHidBus>();
  test::FakeHidapi fake;
  const test::TemporaryFolder sysfs;
  std::shared_ptr<HidBus> bus;
};

TEST_F(HidapiConnection, ADeviceListedOnceForEachCollectionIsOneDevice)
{
  const test::FakePort& port = this->plug(test::plainLayout(), "A");
  this->plug(test::hobbyLayout(), "B");
  const std::vector<HidEntry> found = this->bus->devices();
  ASSERT_EQ(found.size(), 2u);
  const HidEntry& first = found[0].serial == "A" ? found[0] : found[1];
  EXPECT_EQ(first.path, port.entry.path);
  EXPECT_EQ(first.vendor, port.entry.vendor);
  EXPECT_EQ(first.product, port.entry.product);
  EXPECT_EQ(first.name, port.entry.name);
}

TEST_F(HidapiConnection, DrivesADeviceFromFindingItToForceAndClosesIt)
{
  test::FakePort& port = this->plug(test::plainLayout(), "A");
  const std::vector<FoundHid> found = findHidDevices(*this->bus);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].problem, "");
  PidDeviceOptions options;
  options.threads = false;
  options.clock = &this->plugged->time();
  PidDevice device(found[0].name, this->bus, found[0].entry, options);
  ASSERT_EQ(device.open(), "");
  DeviceCommand command;
  command.wrench_D.force.x() = 1.0;
  DeviceSample sample;
  for (int pass = 0; pass < 30; ++pass)
  {
    device.write(command);
    static_cast<void>(device.link().writePass());
    // hidapi's own waiting takes real time; the device's is virtual
    this->plugged->advance(1);
    EXPECT_TRUE(device.link().readPass(0));
    EXPECT_EQ(device.read(0.0, sample), DeviceStatus::Ok);
  }
  EXPECT_NEAR(port.device->force()[0], 0.2, 1e-3);
  EXPECT_EQ(port.device->badReports, 0);
  device.close();
  EXPECT_EQ(port.device->effectsUsed(), 0);
  EXPECT_EQ(port.opened, port.closed);
}

TEST_F(HidapiConnection, WhatTheSystemSaysOfAFailureIsPassedOn)
{
  test::FakePort& port = this->plug(test::plainLayout(), "A");
  const HidBus::Opened opened = this->bus->open(port.entry);
  ASSERT_NE(opened.value, nullptr);
  port.present = false;
  EXPECT_FALSE(opened.value->write(std::vector<std::uint8_t>{ 0x1C, 3 }));
  EXPECT_EQ(opened.value->error(), "No such device");
  std::vector<std::uint8_t> report(64);
  while (opened.value->read(report, 0) > 0)
  {
  }
  EXPECT_EQ(opened.value->read(report, 0), -1);
  EXPECT_EQ(opened.value->getFeature(report), -1);
  EXPECT_FALSE(opened.value->setFeature(report));
}

TEST_F(HidapiConnection, ADeviceWithoutDescriptorIsPassedOver)
{
  this->plugged->plug(test::plainLayout(), "A"); // nothing in the folder of descriptors
  EXPECT_TRUE(findHidDevices(*this->bus).empty());
  EXPECT_NE(this->bus->descriptor(this->bus->devices().at(0)).problem, "");
}

} // namespace
} // namespace palpate
