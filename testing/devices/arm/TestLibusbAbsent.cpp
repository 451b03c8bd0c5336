// SPDX-License-Identifier: GPL-3.0-or-later
// A build that found no libusb: this program has devices/arm/link/LibusbAbsent.cpp, and the kit that asks it, before
// those of libpalpate.
#include <algorithm>
#include <cerrno>

#include <gtest/gtest.h>

#include "devices/arm/ArmDevice.h"
#include "devices/arm/link/FtdiPort.h"
#include "testing/devices/arm/TwoPlugs.h"

namespace palpate
{
namespace
{

constexpr const char* sentence = "this build of the program has no libusb: install libusb-1.0-0-dev and build it again";

int allowed(const char* /*path*/, int /*mode*/)
{
  return 0;
}

int forbidden(const char* /*path*/, int /*mode*/)
{
  errno = EACCES;
  return -1;
}

TEST(LibusbAbsent, IsSaidOfAFalconWhereItIsListedAndWhenItIsOpenedWhateverItsPermission)
{
  const test::TwoPlugs plugs;
  for (const FileAccess access : { allowed, forbidden })
  {
    const KnownDevice falcon = plugs.listed(access)[0];
    EXPECT_EQ(falcon.name, "falcon-0403-cb48");
    EXPECT_EQ(falcon.problem, sentence);
    const MadeDevice made = makeDevice(falcon.name, plugs.options(access));
    ASSERT_NE(made.device, nullptr) << made.problem;
    EXPECT_EQ(made.device->open(), "\"falcon-0403-cb48\": " + std::string(sentence));
  }
  EXPECT_EQ(openFtdi("/dev/bus/usb/001/007").problem, sentence);
}

// The numbers of a Falcon, and all of the other arm, are those of every build.
TEST(LibusbAbsent, ChangesNothingElse)
{
  const test::TwoPlugs plugs;
  const std::vector<KnownDevice> known = plugs.listed(allowed);
  const DeviceInfo expected = armInfo("falcon-0403-cb48", {}, falconSetup());
  EXPECT_EQ(known[0].info.maxForce_N.value, std::min(1.0, expected.maxForce_N.value));
  EXPECT_EQ(known[0].info.workspaceRadius_m.value, expected.workspaceRadius_m.value);
  EXPECT_EQ(known[0].what, falconSetup().what);
  EXPECT_EQ(known[1].name, "2diy-2341-003e");
  EXPECT_EQ(known[1].problem, "");
  EXPECT_EQ(known[1].what, setupOf(twoDiyArm()).what);
  const MadeDevice board = makeDevice(known[1].name, plugs.options(allowed));
  ASSERT_NE(board.device, nullptr);
  EXPECT_EQ(board.device->open().find("libusb"), std::string::npos) << "it fails for want of its file alone";
}

} // namespace
} // namespace palpate
