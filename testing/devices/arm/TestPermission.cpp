// SPDX-License-Identifier: GPL-3.0-or-later
// Arms whose files a person may not use, as `palpate devices` lists them: the system's answers are the test's.
#include <cerrno>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "devices/hid/HidapiBus.h"
#include "testing/devices/arm/TwoPlugs.h"
#include "testing/devices/arm/WoodenHapticsRig.h"

namespace palpate
{
namespace
{

std::vector<std::pair<std::string, int>> asked; ///< files, and for which uses

template<int Reason>
int answering(const char* path, int mode)
{
  asked.emplace_back(path, mode);
  errno = Reason;
  return Reason == 0 ? 0 : -1;
}

std::string refusalOf(const std::string& file)
{
  return "no permission to use " + file +
         ": copy devices/udev/70-palpate.rules to /etc/udev/rules.d/, see that it has a line for this device, and plug "
         "the device in again";
}

TEST(Permission, ThatIsMissingIsSaidWithTheFileAndTheRemedy)
{
  const test::TwoPlugs plugs;
  for (const FileAccess access : { answering<EACCES>, answering<EPERM> })
  {
    asked.clear();
    const std::vector<KnownDevice> known = plugs.listed(access);
    EXPECT_EQ(known[0].name, "falcon-0403-cb48");
    EXPECT_EQ(known[0].problem, refusalOf("/dev/bus/usb/001/007"));
    EXPECT_EQ(known[1].name, "2diy-2341-003e");
    EXPECT_EQ(known[1].problem, refusalOf("/dev/ttyACM3"));
    const std::vector<std::pair<std::string, int>> uses{ { "/dev/bus/usb/001/007", R_OK | W_OK },
      { "/dev/ttyACM3", R_OK | W_OK } };
    EXPECT_EQ(asked, uses);
  }
}

TEST(Permission, ThatIsThereLeavesNothingToSayAndAnotherReasonIsAnother)
{
  const test::TwoPlugs plugs;
  for (const KnownDevice& known : plugs.listed(answering<0>))
  {
    EXPECT_EQ(known.problem, "") << known.name;
  }
  for (const KnownDevice& known : plugs.listed(answering<ENOENT>))
  {
    EXPECT_THAT(known.problem, testing::HasSubstr("is gone: plug the device in again")) << known.name;
  }
}

TEST(Permission, ThatIsMissingForAWoodenHapticsIsSaidWhereItIsListedAndWhenItIsOpened)
{
  const test::WoodenHapticsRig rig;
  rig.port.openProblem = openProblem("/dev/hidraw4", EACCES);
  DeviceOptions options;
  options.hid = rig.bus;
  options.arms = std::make_shared<const std::vector<ArmKit>>(std::vector<ArmKit>{ rig.kit });
  const KnownDevice listed = knownDevices(options).back();
  EXPECT_EQ(listed.problem, refusalOf("/dev/hidraw4"));
  const MadeDevice made = makeDevice(listed.name, options);
  ASSERT_NE(made.device, nullptr) << made.problem;
  EXPECT_THAT(made.device->open(), testing::EndsWith(refusalOf("/dev/hidraw4")));
}

} // namespace
} // namespace palpate
