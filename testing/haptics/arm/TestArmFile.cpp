// SPDX-License-Identifier: GPL-3.0-or-later
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "haptics/arm/file/ArmFile.h"
#include "haptics/arm/shown/ArmWorkSpaceMap.h"
#include "testing/support/TemporaryFolder.h"

namespace palpate
{
namespace
{

using testing::HasSubstr;

const std::string twoLinks = R"({ "format": "palpate arm", "version": 1, "name": "two links", "kind": "serial",
  "joints": [ { "low_deg": -90, "high_deg": 90 }, { "at_m": [0.15, 0, 0], "low_deg": 0, "high_deg": 170 } ],
  "tip_m": [0.15, 0, 0], "masses": [ { "kg": 0.1, "link": 1, "at_m": [0.15, 0, 0] } ],
  "work_space": { "centre_m": [0.2, 0, 0], "radius_m": 0.08 } })";

const std::string delta = R"({ "format": "palpate arm", "version": 1, "name": "delta", "kind": "delta",
  "base_m": 0.1, "platform_m": 0.04, "arm_m": 0.15, "forearm_m": 0.25, "joints": [ {}, {}, {} ] })";

/// That delta with two hinges, of which the second one is 10 mm above the first.
const std::string hybrid = R"({ "format": "palpate arm", "version": 1, "name": "hybrid", "kind": "delta",
  "base_m": 0.1, "platform_m": 0.04, "arm_m": 0.15, "forearm_m": 0.25, "joints": [ {}, {}, {} ],
  "wrist": [ {}, { "at_m": [0, 0, 0.01], "axis": [0, 2, 0], "high_deg": 45 } ], "tip_m": [0.05, 0, 0],
  "masses": [ { "kg": 0.1, "link": 9, "at_m": [0.02, 0, 0] } ] })";

std::string with(std::string text, const std::string& old, const std::string& fresh)
{
  const std::size_t at = text.find(old);
  EXPECT_NE(at, std::string::npos) << old;
  return text.replace(at, old.size(), fresh);
}

TEST(ArmFile, BecomesThePlanItDescribes)
{
  const Outcome<ArmPlan> read = parseArm(twoLinks);
  ASSERT_EQ(read.problem, "");
  EXPECT_EQ(read.value.name, "two links");
  EXPECT_NEAR(read.value.joints[0].high_rad, M_PI / 2, 1e-15);
  ASSERT_EQ(read.value.masses.size(), 1u);
  EXPECT_EQ(read.value.masses[0].to, Vec3(0.15, 0, 0));
  const Arm arm(read.value);
  JointVector q(2);
  q << 0.0, M_PI / 2;
  EXPECT_LE((arm.forward(q)->p - Vec3(0.15, 0.15, 0)).norm(), 1e-15);
}

TEST(ArmFile, OfAWristHasItsJointsLastAndWithoutMotors)
{
  const Outcome<ArmPlan> read = parseArm(hybrid), without = parseArm(delta);
  ASSERT_EQ(read.problem + without.problem, "");
  const Arm arm(read.value), base(without.value);
  EXPECT_EQ(arm.joints(), 5);
  EXPECT_EQ(arm.motors(), 3);
  EXPECT_NEAR(read.value.joints[4].high_rad, M_PI / 4, 1e-15);
  EXPECT_EQ(read.value.masses[0].from, Vec3(0.02, 0, 0));
  // A quarter turn about z brings the tip from x to y; the axis of the second hinge is level then.
  JointVector q(5);
  q << 0.3, 0.4, 0.5, M_PI / 2, 0.0;
  const Vec3 platform = base.forward(q.head<3>())->p;
  EXPECT_LE((arm.forward(q)->p - platform - Vec3(0, 0.05, 0.01)).norm(), 1e-15);
  q[4] = M_PI / 2;
  EXPECT_LE((arm.forward(q)->p - platform - Vec3(0, 0, 0.01 - 0.05)).norm(), 1e-15);
  EXPECT_LE((arm.linkPoint(q, 9, read.value.masses[0].from).p - platform - Vec3(0, 0, 0.01 - 0.02)).norm(), 1e-15);
}

TEST(ArmFile, HasTheClassOfItsLinks)
{
  EXPECT_STREQ(classOf(parseArm(twoLinks).value), "serial");
  EXPECT_STREQ(classOf(parseArm(delta).value), "parallel");
  EXPECT_STREQ(classOf(parseArm(hybrid).value), "hybrid");
  EXPECT_STREQ(classOf(knownArm("pantograph").value), "parallel");
  EXPECT_STREQ(classOf(knownArm("woodenhaptics-2015").value), "serial");
  ArmPlan wooden = knownArm("woodenhaptics-2015").value;
  wooden.wrist.count = 1;
  EXPECT_STREQ(classOf(wooden), "serial") << "a chain goes on";
}

TEST(ArmFile, IsRefusedWithThePlaceAndTheReason)
{
  const std::vector<std::pair<std::string, std::string>> bad = {
    { with(twoLinks, "palpate arm", "palpate leg"), "format: must be \"palpate arm\"" },
    { with(twoLinks, "\"version\": 1", "\"version\": 2"), "later version: update Palpate" },
    { with(twoLinks, "serial", "octopus"), "unknown kind \"octopus\"; valid kinds: serial" },
    { with(twoLinks, "tip_m", "tipp_m"), "tipp_m: unknown key" },
    { with(twoLinks, "\"low_deg\": -90, \"high_deg\": 90", "\"low_deg\": 90, \"high_deg\": -90"),
      "joint 1: its limits exclude each other" },
    { with(twoLinks, "\"link\": 1", "\"link\": 3"), "a mass is on link 3" },
    { with(twoLinks, "\"kg\": 0.1", "\"kg\": -0.1"), "masses[0].kg: must not be below 0" },
    { with(twoLinks, "\"radius_m\": 0.08", "\"radius_m\": -1"), "work_space.radius_m: must not be below 0" },
    { with(twoLinks, "[0.15, 0, 0], \"low", "[0.15, 0], \"low"), "must be a list of 3 numbers" },
    { with(twoLinks, "\"low_deg\": 0", "\"axis\": [0, 0, 0], \"low_deg\": 0"),
      "joints[1].axis: must have a direction" },
    { with(twoLinks, "\"low_deg\": 0", "\"gear\": 0, \"low_deg\": 0"), "joint 2: its gear" },
    { with(twoLinks, "{ \"low_deg\": -90", "{ \"motor\": false, \"low_deg\": -90"), "joints with motors come before" },
    { with(twoLinks, "\"tip_m\"", "\"max_condition\": 0.5, \"tip_m\""), "largest condition must be above 1" },
    { with(delta, "\"arm_m\": 0.15", "\"arm_m\": -0.15"), "the length \"arm\" must be above 0" },
    { with(delta, "\"arm_m\": 0.15, ", ""), "arm_m: this key is missing" },
    { with(delta, "{}, {}, {}", "{}, {}"), "this kind of arm has 3 joints" },
    { with(delta, "\"base_m\"", "\"legs_deg\": [0, 120, 360], \"base_m\""), "two legs have the same azimuth" },
    { with(delta, "\"base_m\"", "\"side\": 2, \"base_m\""), "side: must be 1 or -1" },
    { with(twoLinks, "\"tip_m\"", "\"wire\": 7, \"tip_m\""), "wire: must be an object, { ... }" },
    { with(delta, "\"base_m\"", "\"tip_m\": [0, 0, 0], \"base_m\""), "tip_m: unknown key" },
    { with(delta, "{}, {}, {}", "{}, {}, { \"motor\": false }"), "every joint of this kind needs a motor" },
    { with(hybrid, "[ {}, { \"at_m\"", "[ {}, {}, {}, { \"at_m\""), "wrist: a chain has 3 joints at most" },
    { with(hybrid, "[ {}, { \"at_m\": [0, 0, 0.01], \"axis\": [0, 2, 0], \"high_deg\": 45 } ]", "[]"),
      "wrist: has no hinge" },
    { with(hybrid, "[0, 2, 0]", "[0, 0, 0]"), "wrist[1].axis: must have a direction" },
    { with(hybrid, "{}, { \"at_m\"", "{}, { \"motor\": true, \"at_m\""), "joint 5: joints with motors come before" },
    { with(hybrid, "\"link\": 9", "\"link\": 10"), "a mass is on link 10, and this arm has links 1 to 9" },
    { with(hybrid, "[0.02, 0, 0] } ]", "0.02 } ]"), "must be a list of 3 numbers" },
    { with(twoLinks, "\"tip_m\"", "\"wrist\": [ {} ], \"tip_m\""), "wrist: a chain has its hinges as joints" },
    { "[]", "must be an object" },
    { "", "not JSON" },
  };
  for (const auto& [text, says] : bad)
  {
    const std::string problem = parseArm(text).problem;
    EXPECT_THAT(problem, HasSubstr(says));
    EXPECT_EQ(problem.find('\n'), std::string::npos);
  }
}

TEST(ArmFile, LeavesItsWireToWhoeverDrivesTheArm)
{
  const std::string wired = with(twoLinks, "\"tip_m\"", "\"wire\": { \"protocol\": \"smoke\" }, \"tip_m\"");
  EXPECT_EQ(parseArm(wired).problem, "");
}

TEST(ArmFile, CutShortAnywhereIsNotJson)
{
  for (std::size_t length = 0; length < twoLinks.size(); ++length)
  {
    EXPECT_THAT(parseArm(twoLinks.substr(0, length)).problem, HasSubstr("not JSON")) << length;
  }
}

TEST(ArmFile, OfAFileIsNamedInItsFault)
{
  const test::TemporaryFolder folder;
  const std::string file = (folder.path() / "leg.json").string();
  EXPECT_THAT(readArmFile(file).problem, HasSubstr(file + ": it cannot be read"));
  std::ofstream(file) << with(twoLinks, "palpate arm", "palpate leg");
  EXPECT_THAT(readArmFile(file).problem, HasSubstr(file + ": format: must be"));
  std::ofstream(file) << twoLinks;
  EXPECT_EQ(readArmFile(file).problem, "");
}

TEST(ArmFile, TellsAWorkSpaceThatHoldsASingularity)
{
  const Arm within(parseArm(twoLinks).value);
  EXPECT_EQ(noteOn(within, rangeOf(within, mapWorkSpace(within, 12))), "");
  // The links stretched and folded: at 0.3 m, and at the shoulder.
  const Arm stretched(parseArm(with(twoLinks, "\"radius_m\": 0.08", "\"radius_m\": 0.0999")).value);
  EXPECT_THAT(noteOn(stretched, rangeOf(stretched, mapWorkSpace(stretched, 12))), HasSubstr("singularity"));
  const Arm beyond(parseArm(with(twoLinks, "\"radius_m\": 0.08", "\"radius_m\": 0.15")).value);
  EXPECT_THAT(noteOn(beyond, rangeOf(beyond, mapWorkSpace(beyond, 12))), HasSubstr("does not reach"));
  const Arm nowhere(parseArm(delta).value);
  EXPECT_THAT(noteOn(nowhere, rangeOf(nowhere, mapWorkSpace(nowhere, 12))), HasSubstr("no work space"));
}

TEST(ArmFile, OfEveryArmThatIsBuiltInIsReadAndReachesItsWorkSpace)
{
  EXPECT_GE(knownArms().size(), 6u);
  for (const std::string& name : knownArms())
  {
    const Outcome<ArmPlan> plan = knownArm(name);
    ASSERT_EQ(plan.problem, "") << name;
    const Arm arm(plan.value);
    const ArmRange range = rangeOf(arm, mapWorkSpace(arm, 10));
    EXPECT_EQ(noteOn(arm, range), "") << name;
  }
  EXPECT_THAT(knownArm("leg").problem, HasSubstr("known arms: falcon"));
}

} // namespace
} // namespace palpate
