// SPDX-License-Identifier: GPL-3.0-or-later
#include <cerrno>
#include <cstring>

#include <gtest/gtest.h>

#include "devices/common/LinkNotes.h"
#include "haptics/core/Fault.h"
#include "testing/support/Says.h"

namespace palpate
{
namespace
{

TEST(LinkNotes, OfALossSayWhyWhetherItIsBackAndWhatToDo)
{
  LinkReport link;
  const auto describeLoss = [](const LinkReport& report) { return describeFault(Fault::DeviceLost, report); };
  EXPECT_EQ(describeLoss(link), describe(Fault::DeviceLost)) << "nobody knows why";
  link.message = "unplugged";
  EXPECT_TRUE(test::says(describeLoss(link), { "is lost: unplugged", "then engage again" }));
  link.attached = true;
  link.lostFor = link.message;
  EXPECT_TRUE(test::says(describeLoss(link), { "was lost: unplugged", "attached again: engage again" }));
  link.message = "no position yet: move it";
  EXPECT_TRUE(test::says(
    describeLoss(link), { "was lost: unplugged", "attached again, but no position yet: move it, then engage again" }));
  link.message = "Hold it in its pose.";
  EXPECT_TRUE(test::says(describeLoss(link), { "attached again: Hold it in its pose, then engage again" }));
}

TEST(LinkNotes, OfAnArmThatStaysAttachedSayWhyItsForceHasEndedAndTheStepThatItNeeds)
{
  LinkReport link;
  link.attached = true;
  link.lostFor = "unplugged"; // before
  link.endedFor = link.message = "no power: plug it in";
  const auto described = [&link] { return describeFault(Fault::DeviceLost, link); };
  EXPECT_EQ(described(), "the force has ended: no power: plug it in; then engage again");
  link.endedFor = "the zero is lost";
  link.message = "Pull the knob out.";
  EXPECT_EQ(described(), "the force has ended: the zero is lost: Pull the knob out; then engage again");
}

TEST(LinkNotes, BeforeTheFirstPositionSayTheStepThatTheDeviceWaitsFor)
{
  LinkReport link;
  link.attached = true;
  EXPECT_EQ(describeFault(Fault::NoHand, link), describe(Fault::NoHand)) << "it waits for nothing";
  link.message = "Hold it in its pose.";
  EXPECT_EQ(describeFault(Fault::NoHand, link), "Hold it in its pose");
  EXPECT_EQ(describeFault(Fault::LateServo, link), describe(Fault::LateServo)) << "the step has nothing to do with it";
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
  const std::string counts =
    "1000 reports per second, 1 effects renewed, 2 stalls, 3 losses, 4 strange, 5 out of range";
  EXPECT_EQ(describeLink(link), counts);
  link.attached = false;
  link.message = "unplugged";
  EXPECT_EQ(describeLink(link), counts + "; not attached: unplugged");
}

TEST(LinkNotes, AWriteThatFailsBecauseTheDeviceIsGoneIsSaidAsBeingUnplugged)
{
  EXPECT_TRUE(test::says(
    describeFailedWrite(std::strerror(ENODEV)), { "unplugged" })); // as the kernel's driver and hidapi say it
  EXPECT_TRUE(test::says(describeFailedWrite(std::strerror(EPIPE)), { "rejects", std::strerror(EPIPE) }));
}

} // namespace
} // namespace palpate
