// SPDX-License-Identifier: GPL-3.0-or-later
// Arms of known wires that a text file alone describes, against models of boards and mechanics with other numbers than
// those of the arms that are built in; and which file has which device.
#include <array>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "devices/DeviceFactory.h"
#include "devices/arm/kit/WireFile.h"
#include "haptics/arm/file/ArmFile.h"
#include "testing/devices/arm/OwnArms.h"
#include "testing/devices/arm/TwoDiyRig.h"
#include "testing/devices/arm/WoodenHapticsRig.h"
#include "testing/support/Random.h"

namespace palpate
{
namespace
{

using test::OwnArms;
using test::with;
using testing::ElementsAre;

TEST(OwnPantograph, IsFoundByItsFileAndIsAnArmLikeTheOthers)
{
  const OwnArms own;
  own.write("my arm.json", test::ownPantograph());
  own.sys.plugSerial("ttyACM0", "16d0", "1234", "7");
  const std::vector<ArmKit> kits = own.kits();
  const std::vector<FoundArm> found = findArms(kits);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].name, "my-arm-16d0-1234-7");
  EXPECT_EQ(found[0].problem, "");
  EXPECT_EQ(found[0].entry.path, "/dev/ttyACM0");
  EXPECT_EQ(found[0].setup.what, "My pantograph");
  EXPECT_EQ(found[0].setup.pose, "Hold both arms against their pegs.");
  const ArmDevice device("arm", found[0].kit->bus, found[0].entry, found[0].setup);
  EXPECT_EQ(device.info().deviceClass, DeviceClass::Joystick2D);
  EXPECT_EQ(device.info().workspaceRadius_m.value, 0.025);
  EXPECT_LE(device.info().maxForce_N.value, 1.0) << "nothing has proven it";
}

/// Step of an encoder [rad].
double step_rad(double gear)
{
  return 2.0 * std::numbers::pi / (4000.0 * gear);
}

TEST(OwnPantograph, AppliesTheForceThatIsAskedWithItsLengthsGearsAndWiring)
{
  const Outcome<WiredArm> arm = parseWiredArm(test::ownPantograph());
  ASSERT_EQ(arm.problem, "");
  test::TwoDiyRig own(arm.value, test::ownPantographBody());
  ASSERT_EQ(own.rig.device.open(), "");
  ask(own.rig, { 0.5, 0.0, 0.0 });
  EXPECT_EQ(own.rig.status, DeviceStatus::Waiting);
  EXPECT_EQ(own.model->force_N().norm(), 0.0);
  own.setInPose();
  ask(own.rig, Vec3::Zero());
  test::Random random(12);
  for (int i = 0; i < 300; ++i)
  {
    Vec3 from_m = 0.024 * random.direction();
    from_m.z() = 0.0;
    ASSERT_TRUE(own.model->lead(from_m + Vec3(0.02, 0.11, 0.0)));
    Vec3 force_N = random.direction();
    force_N.z() = 0.0;
    own.rig.command.wrench_D.force = force_N;
    own.rig.run(4);
    ASSERT_EQ(own.rig.status, DeviceStatus::Ok);
    // A count of each encoder, and a part of one by which its offset is rounded.
    const Mat3 ways = own.model->ways();
    const double count_m = 2.0 * (ways.col(0).norm() * step_rad(2.0) + ways.col(1).norm() * step_rad(4.0));
    EXPECT_LT((own.rig.sample.pose_D.p - from_m).norm(), count_m) << from_m.transpose();
    EXPECT_LT((own.model->force_N() - force_N).norm(), own.model->step_N() + 1e-2) << from_m.transpose();
  }
}

TEST(OwnPantograph, IsAskedForNoMoreThanTheFirmwareGives)
{
  const std::string strong = with(test::ownPantograph(), "\"gear\": -2, \"max_torque_Nm\": 0.1", "\"gear\": -2");
  const Outcome<WiredArm> arm = parseWiredArm(with(strong, "\"max_torque_Nm\": 0.1", "\"max_torque_Nm\": 5"));
  ASSERT_EQ(arm.problem, "");
  EXPECT_EQ(arm.value.plan.joints[0].maxTorque_Nm, 0.123);
  EXPECT_EQ(arm.value.plan.joints[1].maxTorque_Nm, 0.123);
}

/// The count that an arm has in its pose and the angle at count 0 describe the same.
TEST(OwnPantograph, MayHaveItsPoseByCountsInsteadOfAngles)
{
  // Turned by 45 degrees, 1000 counts of 8000 a turn, against the encoder.
  const std::string counted =
    with(test::ownPantograph(), "\"zero_deg\": 135", "\"zero_deg\": 180, \"calibrated\": 1000");
  const Outcome<WiredArm> arm = parseWiredArm(counted);
  ASSERT_EQ(arm.problem, "");
  EXPECT_NEAR(boardOf(arm.value).offset_deg[0], 135.0, 1e-9);
  EXPECT_EQ(setupOf(arm.value).counters[0], 135);
}

ArmKit ownWoodenKit(const std::shared_ptr<test::FakeHidBus>& bus, const test::TemporaryFolder& folder)
{
  std::ofstream(folder.file("wooden.json")) << test::ownWoodenHaptics();
  return ownArmKits(folder.path(), { bus }).at(0);
}

TEST(OwnWoodenHaptics, AppliesTheForceThatIsAskedWithItsTorqueConstants)
{
  test::WoodenHapticsRig rig(true, { "", 0x16d0, 0x0f4c, "7", "arm" }, ownWoodenKit);
  rig.model->constants_Nm_per_A = { 0.02, 0.03, 0.05 };
  const std::vector<ArmKit> kits{ rig.kit };
  const std::vector<FoundArm> found = findArms(kits);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].name, "wooden-16d0-0f4c-7");
  ASSERT_EQ(rig.open(), "");
  rig.command = {};
  rig.run(5);
  test::Random random(6);
  for (int i = 0; i < 100; ++i)
  {
    ASSERT_TRUE(rig.model->lead(0.05 * random.direction() + Vec3(0.0, 0.0, 0.02)));
    rig.command.wrench_D.force = random.direction();
    rig.run(4);
    ASSERT_EQ(rig.status, DeviceStatus::Ok);
    // The Jacobian is that of the counted place: a count turns a force by less than 1 in 100.
    EXPECT_LE((rig.model->force_N() - rig.command.wrench_D.force).norm(), rig.model->halfStep_N() + 1e-2);
  }
}

TEST(OwnWoodenHaptics, HasReportsAsLongAsItsFileSaysElseAsUsualForItsBoard)
{
  const std::string text = with(test::ownWoodenHaptics(), "\"serial\": \"7\", ", "");
  const auto answers = [](const std::string& file, std::uint16_t vendor, std::uint16_t product, std::size_t bytes)
  {
    const OwnArms own;
    own.write("wooden.json", file);
    const auto model = std::make_shared<test::WoodenHapticsModel>();
    model->reportBytes = bytes;
    own.hid->plug(model, { "", vendor, product, "", "arm" });
    const std::vector<ArmKit> kits = own.kits();
    const std::vector<FoundArm> found = findArms(kits);
    const ArmBus::Opened opened = kits.back().bus->open(found.at(0).entry);
    return opened.value != nullptr && opened.value->exchange({}, 5).said == ArmLine::Said::Reading;
  };
  EXPECT_TRUE(answers(text, 0x16d0, 0x0f4c, 14));
  EXPECT_FALSE(answers(text, 0x16d0, 0x0f4c, 32));
  EXPECT_TRUE(answers(with(text, "\"pose\"", "\"report_bytes\": 32, \"pose\""), 0x16d0, 0x0f4c, 32));
  EXPECT_TRUE(answers(with(text, "16d0:0f4c", "16c0:0486"), 0x16c0, 0x0486, 64));
}

TEST(OwnWoodenHaptics, ReadsAFourthCounterAsAGripOnlyWhereItsFileSaysSo)
{
  for (const bool grips : { false, true })
  {
    const OwnArms own;
    const std::string key = grips ? "\"grip\": true, \"pose\"" : "\"pose\"";
    own.write("wooden.json", with(test::ownWoodenHaptics(), "\"pose\"", key));
    const auto model = std::make_shared<test::WoodenHapticsModel>();
    model->fourth = 10123;
    own.hid->plug(model, { "", 0x16d0, 0x0f4c, "7", "arm" });
    const std::vector<ArmKit> kits = own.kits();
    const std::vector<FoundArm> found = findArms(kits);
    const ArmBus::Opened opened = kits.back().bus->open(found.at(0).entry);
    ASSERT_NE(opened.value, nullptr) << opened.problem;
    const WireReading reading = opened.value->exchange({}, 5).reading;
    EXPECT_EQ(reading.encoder[3], grips ? 123.0 : 10123.0);
    EXPECT_EQ(reading.grip, grips);
  }
}

TEST(OwnWoodenHaptics, IsTheDeviceOfItsSerialNumberAlone)
{
  const OwnArms own;
  own.write("wooden.json", test::ownWoodenHaptics());
  const auto plug = [&own](std::uint16_t product, const std::string& serial, HidUsage usage) {
    own.hid->plug(std::make_shared<test::WoodenHapticsModel>(), { "", 0x16d0, product, serial, "arm", usage });
  };
  plug(0x0f4c, "7", 0);
  plug(0x0f4c, "8", 0);
  plug(0x0f4d, "7", 0);
  plug(0x0f4c, "7", 0xFFC90004); // the part for text of a Teensy
  EXPECT_THAT(own.found(), ElementsAre("wooden-16d0-0f4c-7"));
}

TEST(WireFile, SaysWhatIsWrongWithThePlaceAndTheReason)
{
  const std::string usb = "wire.usb: each text must have the numbers of a device as lsusb shows them, such as "
                          "\"2341:003e\"";
  const std::vector<std::array<std::string, 3>> bad{
    { "\"protocol\": \"2diy\", ", "", "wire.protocol: this key is missing" },
    { "\"2diy\"", "\"smoke\"", "wire.protocol: unknown protocol \"smoke\"; valid protocols: 2diy, woodenhaptics" },
    { "\"usb\": [\"16d0:1234\"], ", "", "wire.usb: must be a list of texts in quotes" },
    { "[\"16d0:1234\"]", "[5840]", "wire.usb: must be a list of texts in quotes" },
    { "[\"16d0:1234\"]", "[]", "wire.usb: must name a device" },
    { "16d0:1234", "16d0", usb },
    { "16d0:1234", "16d0:12g4", usb },
    { "16d0:1234", "16d0-1234", usb },
    { "16d0:1234", "16d0:0000", usb },
    { "16d0:1234", "0000:1234", usb },
    { "16d0:1234", "0x16:1234", usb },
    { "\"pose\": \"Hold both arms against their pegs.\", ", "", "wire.pose: this key is missing" },
    { "\"device\": 7", "\"device\": 0", "wire.device: must be a whole number from 1 to 255" },
    { "\"device\": 7", "\"device\": 256", "wire.device: must be a whole number from 1 to 255" },
    { "\"device\": 7", "\"serial\": 7", "wire.serial: must be a text in quotes" },
    { "\"device\": 7", "\"pose_tolerance_deg\": 0", "wire.pose_tolerance_deg: must be from 1 to 30" },
    { "\"device\": 7", "\"pose_tolerance_deg\": 31", "wire.pose_tolerance_deg: must be from 1 to 30" },
    { "\"device\": 7", "\"guard\": false",
      "wire.guard: unknown key; valid keys: protocol, usb, serial, pose, pose_tolerance_deg, device, motors_turned, "
      "encoders_turned" },
    { "[true, false]", "[true]", "wire.motors_turned: must be a list of 2 times true or false" },
    { "[false, true]", "[0, 1]", "wire.encoders_turned: must be a list of 2 times true or false" },
    { "\"counts_per_turn\": 4000, \"gear\": -2", "\"gear\": -2", "joint 1: its counts a turn must be above 0" },
    { "\"gear\": 4", "\"gear\": 1e7", "joint 2: its counts a turn, times its gear, must be from 1 to 1e9" },
    { "\"gear\": 4", "\"gear\": 1e-4", "joint 2: its counts a turn, times its gear, must be from 1 to 1e9" },
    { "\"gear\": 4", "\"gear\": 4, \"follows\": 1, \"share\": 1",
      "joint 2: it follows another one, which the protocol 2diy does not have" },
    { "\"zero_deg\": 45", "\"zero_deg\": 400",
      "joint 2: its angle in the pose in which the counters are set is beyond 360 degrees" },
    { ", \"radius_m\": 0.025", "", "a device needs a work space with a radius above 0" },
    { "[0.02, 0.11, 0]", "[0.02, 0.2, 0]", "the arm does not reach the centre of its work space" },
    { "\"arm_m\": 0.06", "\"arm_m\": -1", "the length \"arm\" must be above 0 and finite" },
    { "\"wire\": {", "\"wire\": 7, \"rest\": {",
      "rest: unknown key; valid keys: format, version, name, source, kind, at_m, turn, joints, masses, "
      "gravity_m_per_s2, work_space, max_force_N, max_stiffness_N_per_m, max_damping_Ns_per_m, max_condition, wire, "
      "base_m, arm_m, forearm_m" },
  };
  ASSERT_EQ(parseWiredArm(test::ownPantograph()).problem, "");
  for (const auto& [old, fresh, sentence] : bad)
  {
    EXPECT_EQ(parseWiredArm(with(test::ownPantograph(), old, fresh)).problem, sentence) << old;
  }
}

TEST(WireFile, SaysLikewiseWhatIsWrongWithTheWireOfAWoodenHaptics)
{
  const std::vector<std::array<std::string, 3>> bad{
    { "\"pose\"", "\"report_bytes\": 13, \"pose\"", "wire.report_bytes: must be a whole number from 14 to 64" },
    { "\"pose\"", "\"report_bytes\": 65, \"pose\"", "wire.report_bytes: must be a whole number from 14 to 64" },
    { "\"pose\"", "\"device\": 5, \"pose\"",
      "wire.device: unknown key; valid keys: protocol, usb, serial, pose, pose_tolerance_counts, report_bytes, grip" },
    { "\"pose\"", "\"pose_tolerance_counts\": 3001, \"pose\"", "wire.pose_tolerance_counts: must be from 1 to 3000" },
    { "\"torque_constant_Nm_per_A\": 0.03, ", "", "joint 2: its torque constant must be above 0" },
    { "\"calibrated\": 6000", "\"calibrated\": 32768", "joint 3: its calibrated count must be from -32768 to 32767" },
    { "\"woodenhaptics\", \"usb\"", "\"2diy\", \"usb\"", "the protocol carries at most 2 joints, and this arm has 3" },
  };
  ASSERT_EQ(parseWiredArm(test::ownWoodenHaptics()).problem, "");
  for (const auto& [old, fresh, sentence] : bad)
  {
    EXPECT_EQ(parseWiredArm(with(test::ownWoodenHaptics(), old, fresh)).problem, sentence) << old;
  }
}

/// A chain of three joints in space whose last joints have no motor, or four motors.
TEST(WireFile, RefusesAnArmWhoseMotorsDoNotSuitTheWire)
{
  const auto chain = [](int motors, int joints)
  {
    std::string text = R"({ "format": "palpate arm", "version": 1, "name": "chain", "kind": "serial", "joints": [)";
    for (int i = 0; i < joints; ++i)
    {
      text += std::string(i > 0 ? ", " : "") + R"({ "axis": [)" + (i == 0 ? "0, 0, 1" : "0, 1, 0") +
              R"(], "at_m": [0.1, 0, 0], "counts_per_turn": 1000, "torque_constant_Nm_per_A": 0.1, "motor": )" +
              (i < motors ? "true }" : "false }");
    }
    return text + R"(], "tip_m": [0.1, 0, 0.02], "work_space": { "centre_m": [0.25, 0, 0.05], "radius_m": 0.02 },
      "wire": { "protocol": "woodenhaptics", "usb": ["16d0:0f4c"], "pose": "Fold it." } })";
  };
  EXPECT_EQ(parseWiredArm(chain(3, 3)).problem, "");
  EXPECT_EQ(parseWiredArm(chain(4, 4)).problem, "the protocol carries at most 3 motors, and this arm has 4");
  EXPECT_EQ(parseWiredArm(chain(2, 3)).problem,
    "a device needs 3 motors to push in every direction of its hand, and this arm has 2");
}

TEST(WireFile, RefusesAPlanarArmWhosePlaneIsAnother)
{
  const std::string sentence =
    "the joints of an arm with two of them must turn about z, so that the hand moves in the plane z = 0";
  const std::string upright = with(test::ownPantograph(), "\"at_m\"", "\"turn\": [0.8, 0.6, 0, 0], \"at_m\"");
  EXPECT_EQ(parseWiredArm(upright).problem, sentence);
  const auto links = [](const std::string& axis, const std::string& turn)
  {
    return R"({ "format": "palpate arm", "version": 1, "name": "links", "kind": "serial", "joints": [
      { "counts_per_turn": 4000 }, { "at_m": [0.1, 0, 0], "counts_per_turn": 4000, "axis": )" +
           axis + R"(, "turn": )" + turn + R"( } ], "tip_m": [0.1, 0, 0],
      "work_space": { "centre_m": [0.12, 0.04, 0], "radius_m": 0.02 },
      "wire": { "protocol": "2diy", "usb": ["16d0:1234"], "pose": "Stretch it." } })";
  };
  EXPECT_EQ(parseWiredArm(links("[0, 0, 1]", "[1, 0, 0, 0]")).problem, "");
  EXPECT_EQ(parseWiredArm(links("[0, 0, -1]", "[1, 0, 0, 0]")).problem, "");
  EXPECT_EQ(parseWiredArm(links("[0, 1, 0]", "[1, 0, 0, 0]")).problem, sentence);
  EXPECT_EQ(parseWiredArm(links("[0, 0, 1]", "[0.8, 0.6, 0, 0]")).problem, sentence);
}

TEST(WireFile, OfTheBuiltInPantographIsThatOfTheBoardsOfArduino)
{
  const WiredArm arm = twoDiyArm();
  ASSERT_TRUE(arm.wire);
  EXPECT_STREQ(protocolOf(*arm.wire), "2diy");
  EXPECT_THAT(numbersOf(arm.wire->devices), ElementsAre("2341:003e", "2341:804d", "2a03:003e", "2a03:804d"));
}

TEST(OwnArmsFolder, HasTheFilesOfArmsAndNothingElse)
{
  const OwnArms own;
  EXPECT_TRUE(ownArmKits("", {}).empty());
  EXPECT_TRUE(ownArmKits(own.folder.file("none"), {}).empty());
  own.write("arm.json~", "backup");
  own.write("notes.txt", "notes");
  std::filesystem::create_directory(own.folder.file("folder.json"));
  EXPECT_TRUE(own.found().empty());
  std::filesystem::create_symlink(own.folder.file("nowhere"), own.folder.file("link.json"));
  EXPECT_THAT(
    own.found(), ElementsAre("link: " + own.folder.file("link.json") + ": it cannot be read, or it is empty"));
}

TEST(OwnArmsFolder, TellsEachWrongFileByItsNameAlsoWhereNoSuchDeviceIsPlugged)
{
  const OwnArms own;
  own.write("a.json", "{");
  own.write("b.json", armText("falcon").value);
  own.write("c.json", with(test::ownPantograph(), "\"gear\": 4", "\"gear\": 0"));
  EXPECT_THAT(own.found(),
    ElementsAre("a: " + own.folder.file("a.json") + ": not JSON: byte 2 is unexpected",
      "b: " + own.folder.file("b.json") + ": wire: this key is missing, which says how the arm is plugged in",
      "c: " + own.folder.file("c.json") + ": joint 2: its gear must be a finite number other than 0"));
  DeviceOptions options;
  options.hid = own.hid;
  options.arms = std::make_shared<const std::vector<ArmKit>>(own.kits());
  EXPECT_EQ(knownDevices(options).back().name, "c");
  const MadeDevice made = makeDevice("c", options);
  ASSERT_NE(made.device, nullptr);
  EXPECT_THAT(made.device->open(), testing::HasSubstr("its gear must be"));
}

/// Numbers that are built in for the 2DIY, too.
std::string claiming(const std::string& more = "")
{
  return with(test::ownPantograph(), "\"16d0:1234\"]", "\"2341:003e\"]" + more);
}

TEST(OwnArmsFolder, HasADeviceThatAFileNamesAndNotTheBuiltInKitToo)
{
  const OwnArms own;
  own.sys.plugSerial("ttyACM0", "2341", "003e", "7");
  own.sys.plugSerial("ttyACM1", "2341", "003e", "8");
  EXPECT_THAT(own.found(), ElementsAre("2diy-2341-003e-7", "2diy-2341-003e-8"));
  own.write("mine.json", claiming(", \"serial\": \"8\""));
  EXPECT_THAT(own.found(), ElementsAre("2diy-2341-003e-7", "mine-2341-003e-8"));
  own.write("mine.json", claiming());
  EXPECT_THAT(own.found(), ElementsAre("mine-2341-003e-7", "mine-2341-003e-8"));
}

/// With the lengths of another arm it could push the wrong way.
TEST(OwnArmsFolder, LeavesADeviceOfAWrongFileToNobody)
{
  const OwnArms own;
  own.sys.plugSerial("ttyACM0", "2341", "003e", "7");
  own.write("mine.json", with(claiming(), "\"arm_m\": 0.06", "\"arm_m\": 0"));
  EXPECT_THAT(own.found(), ElementsAre("mine-2341-003e-7: " + own.folder.file("mine.json") +
                                       ": the length \"arm\" must be above 0 and finite"));
  own.write("mine.json", with(claiming(), "\"device\": 7", "\"device\": 0"));
  EXPECT_THAT(own.found(), ElementsAre("mine-2341-003e-7: " + own.folder.file("mine.json") +
                                       ": wire.device: must be a whole number from 1 to 255"));
}

TEST(OwnArmsFolder, GivesADeviceOfTwoFilesToTheFirstByNameAndTellsItToTheOther)
{
  const OwnArms own;
  own.sys.plugSerial("ttyACM0", "2341", "003e", "7");
  own.write("b.json", claiming());
  own.write("a.json", claiming());
  EXPECT_THAT(own.found(),
    ElementsAre("a-2341-003e-7", "b-2341-003e-7: " + own.folder.file("b.json") + ": " + own.folder.file("a.json") +
                                   " names this device, too: remove one of the two, or give each the serial number of "
                                   "its device"));
  own.write("b.json", claiming(", \"serial\": \"7\""));
  EXPECT_THAT(own.found(), ElementsAre("b-2341-003e-7")) << "a serial number says more";
}

TEST(OwnArmsFolder, TellsTwoFilesWhoseDevicesWouldHaveTheSameNames)
{
  const OwnArms own;
  own.write("my arm.json", test::ownPantograph());
  own.write("my-arm.json", test::ownWoodenHaptics());
  EXPECT_THAT(own.found(),
    ElementsAre("my-arm: " + own.folder.file("my-arm.json") + ": its devices would have the same names as those of " +
                own.folder.file("my arm.json") + ": rename one"));
}

TEST(OwnArmsFolder, TellsADeviceThatIsNotWhereTheProtocolLooksForIt)
{
  const OwnArms own;
  own.sys.plugSerial("ttyACM0", "2341", "003e", "7");
  own.write("mine.json", with(with(test::ownWoodenHaptics(), "16d0:0f4c", "2341:003e"), "\"serial\": \"7\", ", ""));
  EXPECT_THAT(
    own.found(), ElementsAre("mine-2341-003e-7: " + own.folder.file("mine.json") +
                             ": this device is attached, but not where the protocol of the file looks for it"));
}

TEST(OwnArmsFolder, ListsAJoystickThatAFileNamesAsThatArmAlone)
{
  const OwnArms own;
  constexpr HidUsage joystick = 0x010004;
  own.hid->plug(std::make_shared<test::WoodenHapticsModel>(), { "", 0x16d0, 0x0f4c, "7", "arm", joystick });
  const auto names = [&own]
  {
    DeviceOptions options;
    options.hid = own.hid;
    options.arms = std::make_shared<const std::vector<ArmKit>>(own.kits());
    std::vector<std::string> all;
    for (const KnownDevice& known : knownDevices(options))
    {
      if (known.name.find("16d0-0f4c") != std::string::npos)
      {
        all.push_back(known.name);
      }
    }
    return all;
  };
  EXPECT_THAT(names(), ElementsAre("hid-16d0-0f4c-7"));
  own.write("wooden.json", test::ownWoodenHaptics());
  EXPECT_THAT(names(), ElementsAre("wooden-16d0-0f4c-7"));
}

} // namespace
} // namespace palpate
