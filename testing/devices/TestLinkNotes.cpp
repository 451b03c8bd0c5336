// SPDX-License-Identifier: GPL-3.0-or-later
#include <cerrno>
#include <cstring>

#include <gtest/gtest.h>

#include "devices/common/LinkNotes.h"
#include "haptics/core/Fault.h"

namespace palpate
{
namespace
{

TEST(LinkNotes, OfALossSayWhyWhetherItIsBackAndWhatToDo)
{
  LinkReport link;
  EXPECT_EQ(describeLoss(link), describe(Fault::DeviceLost)) << "nobody knows why";
  link.message = "it was unplugged";
  EXPECT_EQ(describeLoss(link), "the device is lost: it was unplugged; then engage again");
  link.attached = true;
  link.lostFor = link.message;
  EXPECT_EQ(describeLoss(link), "the device was lost: it was unplugged; it is there again: engage again");
  link.message = "it has not said yet where the hand is: move it";
  EXPECT_EQ(describeLoss(link), "the device was lost: it was unplugged; it is there again, but it has not said yet "
                                "where the hand is: move it, then engage again");
}

TEST(LinkNotes, OfALinkCountWhatWentWrong)
{
  LinkReport link;
  link.inputRate_Hz = 999.6;
  link.restarts = 1;
  link.stalls = 2;
  link.losses = 3;
  link.strange = 4;
  link.outOfRange = 5;
  link.attached = true;
  const std::string counts = "1000 reports a second, 1 effects renewed, 2 stalls, 3 losses, 4 strange, 5 out of range";
  EXPECT_EQ(describeLink(link), counts);
  link.attached = false;
  link.message = "it was unplugged";
  EXPECT_EQ(describeLink(link), counts + "; not there: it was unplugged");
}

TEST(LinkNotes, AWriteThatFailsBecauseTheDeviceIsGoneIsSaidAsBeingUnplugged)
{
  EXPECT_EQ(describeFailedWrite(std::strerror(ENODEV)), "it was unplugged"); // as the kernel's driver and hidapi say it
  EXPECT_EQ(describeFailedWrite(std::strerror(EPIPE)), std::string("it does not take forces: ") + std::strerror(EPIPE));
}

} // namespace
} // namespace palpate
