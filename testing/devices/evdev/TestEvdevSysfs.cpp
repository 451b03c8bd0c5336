// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <fstream>

#include <gtest/gtest.h>

#include "devices/evdev/EvdevSysfs.h"
#include "testing/support/Random.h"
#include "testing/support/TemporaryFolder.h"

namespace palpate
{
namespace
{

namespace fs = std::filesystem;

void write(const fs::path& file, const std::string& content)
{
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << content;
}

// The kernel writes words of its unsigned long, the highest first, without leading zeros and without the words that
// are 0 before the first one that is not (drivers/input/input.c, input_bits_to_string).
TEST(EvdevSysfs, BitsAreReadAsTheKernelWritesThem)
{
  test::Random random(test::testSeed(20261122));
  for (std::size_t i = 0; i < test::testCount(200); ++i)
  {
    std::vector<std::uint64_t> words(1 + random.below(12));
    for (std::uint64_t& word : words)
    {
      word = random.below(3) == 0 ? 0 : random.next() >> random.below(64);
    }
    std::string line;
    std::vector<std::size_t> expected;
    for (std::size_t w = words.size(); w-- > 0;)
    {
      char text[20];
      std::snprintf(text, sizeof text, "%llx", static_cast<unsigned long long>(words[w]));
      line += !line.empty() ? " " + std::string(text) : words[w] != 0 || w == 0 ? std::string(text) : "";
    }
    for (std::size_t bit = 0; bit < 64 * words.size(); ++bit)
    {
      if ((words[bit / 64] >> (bit % 64) & 1U) != 0)
      {
        expected.push_back(bit);
      }
    }
    EXPECT_EQ(bitsOf(line), expected) << line;
  }
}

TEST(EvdevSysfs, WhatIsNoLineOfBitsHasNone)
{
  EXPECT_TRUE(bitsOf("").empty());
  EXPECT_TRUE(bitsOf("no bits").empty());
  EXPECT_TRUE(bitsOf("1 0x3").empty());
  EXPECT_TRUE(bitsOf("12345678901234567").empty()); // more than a word holds
  test::Random random(test::testSeed(7));
  const std::string letters = "0123456789abcdef x\t-\xff";
  for (std::size_t i = 0; i < test::testCount(2000); ++i)
  {
    std::string line(random.below(40), ' ');
    for (char& c : line)
    {
      c = letters[random.below(static_cast<std::uint32_t>(letters.size()))];
    }
    const std::vector<std::size_t> bits = bitsOf(line);
    EXPECT_TRUE(bits.empty() || line.find_first_not_of("0123456789abcdef ") == std::string::npos) << line;
  }
}

class EvdevFolders : public testing::Test
{
protected:
  /// A USB device with two HID interfaces, of which the first has the event device.
  void SetUp() override
  {
    const fs::path usb = this->root / "usb1" / "1-1";
    this->hid = usb / "1-1:1.0" / "0003:046D:C24F.0001";
    this->other = usb / "1-1:1.1" / "0003:046D:C24F.0002";
    for (const fs::path& folder : { this->hid, this->other })
    {
      write(folder.parent_path() / "bInterfaceNumber", "00\n");
      write(folder / "report_descriptor", "x");
    }
    const fs::path input = this->hid / "input" / "input5";
    write(input / "capabilities" / "ff", "300040000 0\n");
    write(input / "capabilities" / "abs", "3\n");
    write(input / "capabilities" / "key", "1 0 0 0 0\n");
    write(input / "id" / "vendor", "046d\n");
    write(input / "id" / "product", "c24f\n");
    write(input / "uniq", "\n");
    write(input / "name", "Logitech G29\n");
    fs::create_directory_symlink(this->hid, input / "device");
    this->event = input / "event3";
    fs::create_directories(this->event);
    fs::create_directory_symlink(input, this->event / "device");
  }

  test::TemporaryFolder temporary;
  fs::path root = fs::canonical(temporary.path());
  fs::path hid, other, event;
};

TEST_F(EvdevFolders, SayWhatADeviceIs)
{
  const HidEntry entry = entryOf(this->event);
  EXPECT_EQ(entry.path, "/dev/input/event3");
  EXPECT_EQ(entry.vendor, 0x046D);
  EXPECT_EQ(entry.product, 0xC24F);
  EXPECT_EQ(entry.serial, "");
  EXPECT_EQ(entry.name, "Logitech G29");
  const EvdevTraits traits = traitsOf(this->event);
  // 0x300040000 above a word of 64 bits: bits 64 + 18, 64 + 32 and 64 + 33.
  EvdevTraits expected;
  expected.forces.set(FF_CONSTANT).set(FF_GAIN).set(FF_AUTOCENTER);
  static_assert(FF_CONSTANT == 64 + 18 && FF_GAIN == 64 + 32 && FF_AUTOCENTER == 64 + 33);
  EXPECT_EQ(traits.forces, expected.forces);
  EXPECT_EQ(traits.axes, decltype(traits.axes)(3));
  EXPECT_TRUE(traits.keys[256]);
  EXPECT_EQ(traits.keys.count(), 1u);
}

TEST_F(EvdevFolders, AllInterfacesOfOneUsbDeviceAreBehindItsPlugAndNoOthers)
{
  write(this->root / "usb1" / "1-2" / "1-2:1.0" / "bInterfaceNumber", "00\n");
  write(this->root / "usb1" / "1-2" / "1-2:1.0" / "0003:1209:0001.0003" / "report_descriptor", "x");
  EXPECT_EQ(hidFolders(this->event), (std::vector{ this->hid, this->other }));
  fs::remove(this->hid.parent_path() / "bInterfaceNumber"); // a device that a program made up is behind no plug
  EXPECT_EQ(hidFolders(this->event), std::vector{ this->hid });
  fs::remove(this->hid / "report_descriptor");
  EXPECT_TRUE(hidFolders(this->event).empty());
}

TEST_F(EvdevFolders, AProgramThatHasAnInterfaceOpenPastTheDriverIsNamed)
{
  const fs::path processes = this->root / "proc";
  fs::create_directories(this->other / "hidraw" / "hidraw4");
  write(processes / "17" / "comm", "bystander\n");
  fs::create_directories(processes / "17" / "fd");
  fs::create_symlink("/dev/hidraw40", processes / "17" / "fd" / "3");
  const std::vector<fs::path> both = hidFolders(this->event);
  EXPECT_EQ(hidrawHolder(both, processes), "");
  write(processes / "18" / "comm", "wine\n");
  fs::create_directories(processes / "18" / "fd");
  fs::create_symlink("/dev/hidraw4", processes / "18" / "fd" / "9");
  EXPECT_EQ(hidrawHolder(both, processes), "wine (process 18)");
  EXPECT_EQ(hidrawHolder({ this->hid }, processes), "");
}

} // namespace
} // namespace palpate
