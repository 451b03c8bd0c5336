// SPDX-License-Identifier: GPL-3.0-or-later
// Arms behind the kernel's own HID layer, its USB and its serial lines, hidapi and libusb, with their guards: only the
// firmwares and the mechanics are models. Runs in a virtual machine of its own (../README.md). Durations are those of
// the firmwares' clocks.
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <numbers>
#include <numeric>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/vm/OtherProgram.h"
#include "testing/vm/arm/ArmServo.h"
#include "testing/vm/arm/UhidWoodenHaptics.h"
#include "testing/vm/arm/UsbBoard.h"

namespace palpate
{
namespace
{

using test::ArmServo;
using test::OtherProgram;
using test::waitUntil;

constexpr int guarded_ms = 250; ///< by when a guard has ended the torque of a program that was killed

/// The names of the three, and how their models are asked.
struct WoodenHaptics
{
  using Plug = test::UhidWoodenHaptics;
  using Model = test::WoodenHapticsModel;
  static constexpr const char* road = "woodenhaptics";
  static constexpr double count_m = 3e-4;
  static constexpr int dead_ms = Model::watchdog_ms + Model::period_ms, onTheWay_ms = ArmLink::answer_ms;
  /// The firmware counts from the last order that reached it: some were on their way when the program died.
  static std::int64_t withoutOrders_ms(Plug& plug, std::int64_t /*sinceDeath_ms*/)
  {
    return plug.alone([](const Model& model) { return model.wentOffAfter_ms; });
  }
  static void makeReady(Plug&) {}
  static double torque(const Model& model)
  {
    return std::hypot(model.current_mA[0], model.current_mA[1], model.current_mA[2]);
  }
  static double step_N(const Model& model) { return 2.0 * model.halfStep_N(); }
  static Vec3 middle_m() { return Vec3::Zero(); }
};

struct Falcon
{
  using Plug = test::UsbFalcon;
  using Model = test::FalconModel;
  static constexpr const char* road = "falcon";
  static constexpr double count_m = 2e-4;
  static constexpr int dead_ms = guarded_ms, onTheWay_ms = 0;
  static std::int64_t withoutOrders_ms(Plug& /*plug*/, std::int64_t sinceDeath_ms) { return sinceDeath_ms; }
  static void makeReady(Plug& plug)
  {
    plug.alone([](Model& model) { model.homed = { true, true, true }; });
  }
  static double torque(const Model& model)
  {
    return std::hypot<double>(model.motor[0], model.motor[1], model.motor[2]);
  }
  static double step_N(const Model& model) { return model.step_N(); }
  static Vec3 middle_m() { return { 0.0, 0.0, 0.125 }; }
};

struct TwoDiy
{
  using Plug = test::UsbTwoDiy;
  using Model = test::TwoDiyModel;
  static constexpr const char* road = "2diy";
  static constexpr double count_m = 1e-4;
  static constexpr int dead_ms = guarded_ms, onTheWay_ms = 0;
  static std::int64_t withoutOrders_ms(Plug& /*plug*/, std::int64_t sinceDeath_ms) { return sinceDeath_ms; }
  static void makeReady(Plug& plug)
  {
    plug.alone([](Model& model) { model.place({ std::numbers::pi, 0.0, 0.0 }); });
  }
  static double torque(const Model& model) { return std::hypot(model.torque_Nm[0], model.torque_Nm[1]); }
  static double step_N(const Model& model) { return model.step_N(); }
  static Vec3 middle_m() { return { 0.01, 0.085, 0.0 }; }
};

/// An arm that is plugged in, and this program's device and servo for it.
template<class Kit>
struct Arm
{
  explicit Arm(const std::string& serial) : plug(serial), clock(plug), servo(Kit::road, plugged().serial(), &clock) {}

  [[nodiscard]] double torque() { return this->plug.alone(Kit::torque); }
  /// Opens it and brings it as far as to a hand in the middle of its work space. False: it does not come so far.
  [[nodiscard]] bool begin()
  {
    EXPECT_EQ(this->servo.device.open(), "");
    return this->comesBack();
  }
  [[nodiscard]] bool comesBack()
  {
    Kit::makeReady(this->plug);
    return this->servo.prepare() && this->lead(Vec3::Zero());
  }
  /// To a place from the middle. False: the hand is not read there.
  [[nodiscard]] bool lead(const Vec3& from_m)
  {
    const bool led = this->plug.alone([&](auto& model) { return model.lead(Kit::middle_m() + from_m); });
    const auto there = [&] { return (this->servo.sample.pose_D.p - from_m).norm() < Kit::count_m; };
    return led && this->servo.runUntil(there);
  }
  /// Within a step of its numbers and the turn of the force by a count.
  [[nodiscard]] bool feels(const Vec3& force_N)
  {
    const auto off_N = [&](auto& model) { return (model.force_N() - force_N).norm() - Kit::step_N(model); };
    return this->plug.alone(off_N) < 0.01 * force_N.norm();
  }
  [[nodiscard]] bool push(const Vec3& force_N)
  {
    this->servo.ask(force_N);
    return this->servo.runUntil([&] { return this->feels(force_N); });
  }
  [[nodiscard]] bool isLost()
  {
    return this->servo.runUntil([this] { return this->servo.status == DeviceStatus::Lost; });
  }

  typename Kit::Plug plug;
  test::FirmwareClock clock;
  ArmServo servo;

private:
  typename Kit::Plug& plugged()
  {
    this->plug.plug();
    return this->plug;
  }
};

template<class Kit>
class ArmOnAKernel : public testing::Test
{
};

using Kits = testing::Types<WoodenHaptics, Falcon, TwoDiy>;
struct KitNames
{
  template<class Kit>
  static std::string GetName(int)
  {
    return Kit::road;
  }
};
TYPED_TEST_SUITE(ArmOnAKernel, Kits, KitNames);

constexpr double push_N = 0.8;

TYPED_TEST(ArmOnAKernel, IsReadAndPushedAsItsModelIs)
{
  Arm<TypeParam> arm("push");
  ASSERT_TRUE(arm.begin());
  for (int i = 0; i < 8; ++i)
  {
    const double turn = i * std::numbers::pi / 4;
    const Vec3 across(std::cos(turn), std::sin(turn), 0.0);
    ASSERT_TRUE(arm.lead(0.02 * across)) << i;
    EXPECT_TRUE(arm.push(push_N * Vec3(across.y(), -across.x(), 0.0))) << i;
  }
  const LinkReport before = arm.servo.device.linkReport();
  const std::int64_t from_ms = arm.plug.time_ms();
  arm.servo.run(1000);
  const double exchanges = static_cast<double>(arm.servo.device.linkReport().inputs - before.inputs);
  std::cout << TypeParam::road << ": " << 1e3 * exchanges / static_cast<double>(arm.plug.time_ms() - from_ms)
            << " exchanges a second\n";
  const std::int64_t closed_ms = arm.plug.time_ms();
  arm.servo.device.close();
  EXPECT_TRUE(waitUntil([&] { return arm.torque() == 0.0; }));
  EXPECT_LE(arm.plug.time_ms() - closed_ms, 20) << "the last order was on its way";
}

// A wall at the middle: the hand feels K times its depth, as far as a count shows that.
TYPED_TEST(ArmOnAKernel, PushesAHandOutOfAWall)
{
  constexpr double K_N_per_m = 100.0;
  Arm<TypeParam> arm("wall");
  ASSERT_TRUE(arm.begin());
  arm.servo.ask(Vec3::Zero());
  for (const double deep_m : { -0.005, 0.004, 0.008 })
  {
    ASSERT_TRUE(arm.lead({ deep_m, 0.0, 0.0 }));
    const auto pressed = [&]
    {
      arm.servo.command.wrench_D.force.x() = -K_N_per_m * std::max(0.0, arm.servo.sample.pose_D.p.x());
      const double wanted_N = -K_N_per_m * std::max(0.0, deep_m);
      const auto off_N = [&](auto& model)
      { return (model.force_N() - Vec3(wanted_N, 0.0, 0.0)).norm() - TypeParam::step_N(model); };
      return arm.plug.alone(off_N) < K_N_per_m * TypeParam::count_m;
    };
    EXPECT_TRUE(arm.servo.runUntil(pressed)) << deep_m;
  }
}

TYPED_TEST(ArmOnAKernel, UnpluggedInContactIsLostWithOneSentenceAndBackWithoutForceUntilItIsAskedForAnew)
{
  Arm<TypeParam> arm("contact");
  ASSERT_TRUE(arm.begin());
  for (int i = 0; i < 3; ++i) // at three moments of an exchange
  {
    ASSERT_TRUE(arm.push({ push_N, 0.0, 0.0 })) << i;
    arm.plug.unplug();
    EXPECT_TRUE(arm.isLost());
    EXPECT_EQ(arm.servo.device.linkReport().lostFor, "the cable was unplugged");
    arm.plug.plug();
    EXPECT_TRUE(arm.servo.runUntil([&] { return arm.torque() == 0.0; })) << "told so by the first message";
    ASSERT_TRUE(arm.comesBack());
    arm.servo.run(100);
    EXPECT_EQ(arm.torque(), 0.0);
  }
  EXPECT_TRUE(arm.push({ push_N, 0.0, 0.0 }));
}

TYPED_TEST(ArmOnAKernel, UnpluggedBeforeItIsReadyIsLostWithTheSameSentence)
{
  Arm<TypeParam> arm("early");
  ASSERT_EQ(arm.servo.device.open(), "");
  arm.servo.command.wrench_D.force = { push_N, 0.0, 0.0 };
  EXPECT_TRUE(arm.servo.runUntil([&] { return arm.servo.status == DeviceStatus::Waiting; }));
  EXPECT_TRUE(arm.servo.device.step());
  EXPECT_EQ(arm.torque(), 0.0);
  arm.servo.device.stepDone(""); // to be set, or soon
  arm.plug.unplug();
  EXPECT_TRUE(arm.isLost());
  EXPECT_EQ(arm.servo.device.linkReport().lostFor, "the cable was unplugged");
  EXPECT_FALSE(arm.servo.device.step()) << "nothing can be done with what is not there";
  arm.plug.plug();
  EXPECT_TRUE(arm.comesBack());
  EXPECT_EQ(arm.torque(), 0.0);
}

TYPED_TEST(ArmOnAKernel, IsRefusedToASecondProgramUntilTheFirstHasEnded)
{
  Arm<TypeParam> arm("two");
  ASSERT_TRUE(arm.begin());
  {
    ArmServo second(TypeParam::road, arm.plug.serial());
    EXPECT_THAT(second.device.open(), testing::HasSubstr("is busy: close the other program"));
    EXPECT_TRUE(arm.push({ push_N, 0.0, 0.0 })) << "the first goes on";
  }
  arm.servo.device.close();
  ArmServo third(TypeParam::road, arm.plug.serial());
  EXPECT_EQ(third.device.open(), "") << "its guard has ended, too";
}

TYPED_TEST(ArmOnAKernel, OfAProgramThatIsKilledInContactHasNoTorqueSoonAfter)
{
  typename TypeParam::Plug plug("killed");
  plug.plug();
  TypeParam::makeReady(plug);
  OtherProgram program({ "--push-arm", TypeParam::road, plug.serial() });
  const auto pushes = [&]
  {
    plug.alone([](auto& model) { return model.lead(TypeParam::middle_m()); });
    return plug.alone(TypeParam::torque) > 0.0;
  };
  ASSERT_TRUE(waitUntil([&] { return plug.alone(TypeParam::torque) > 0.0 || pushes(); }, 20000));
  std::int64_t now_ms = plug.time_ms();
  ASSERT_TRUE(waitUntil([&] { return plug.time_ms() > now_ms + 100; }));
  ASSERT_GT(plug.alone(TypeParam::torque), 0.0);
  now_ms = plug.time_ms();
  program.kill();
  EXPECT_TRUE(waitUntil([&] { return plug.alone(TypeParam::torque) == 0.0; }));
  const std::int64_t took_ms = plug.time_ms() - now_ms;
  std::cout << TypeParam::road << ": no torque " << took_ms << " ms after the program's death\n";
  EXPECT_LE(TypeParam::withoutOrders_ms(plug, took_ms), TypeParam::dead_ms);
  EXPECT_LE(took_ms, TypeParam::dead_ms + TypeParam::onTheWay_ms);
  EXPECT_TRUE(waitUntil([&] { return plug.time_ms() > now_ms + 2 * TypeParam::dead_ms; }));
  EXPECT_EQ(plug.alone(TypeParam::torque), 0.0) << "and it stays so";
  ArmServo next(TypeParam::road, plug.serial());
  EXPECT_EQ(next.device.open(), "") << "nobody holds it any more";
}

TYPED_TEST(ArmOnAKernel, ThatTakesNothingAnyMoreIsLostAndToldNoTorqueAsSoonAsItTakesSomethingAgain)
{
  Arm<TypeParam> arm("stalled");
  ASSERT_TRUE(arm.begin());
  ASSERT_TRUE(arm.push({ push_N, 0.0, 0.0 }));
  arm.plug.stalls = true;
  EXPECT_TRUE(arm.isLost());
  EXPECT_FALSE(arm.servo.device.linkReport().lostFor.empty());
  std::cout << TypeParam::road << " that stalls: " << arm.servo.device.linkReport().lostFor << "\n";
  arm.plug.stalls = false;
  EXPECT_TRUE(arm.servo.runUntil([&] { return arm.torque() == 0.0; }, 10000));
  arm.servo.run(200);
  EXPECT_EQ(arm.torque(), 0.0);
}

TEST(ArmFalcon, GivesNoForceBeforeAllItsMotorsAreHomed)
{
  Arm<Falcon> arm("homing");
  ASSERT_EQ(arm.servo.device.open(), "");
  arm.servo.command.wrench_D.force = { 0.0, 0.0, push_N };
  for (std::size_t homed = 0; homed < 3; ++homed)
  {
    arm.servo.run(100);
    EXPECT_EQ(arm.servo.status, DeviceStatus::Waiting);
    EXPECT_EQ(arm.torque(), 0.0) << homed;
    arm.plug.alone([homed](test::FalconModel& model) { model.homed[homed] = true; });
  }
  EXPECT_TRUE(arm.servo.runUntil([&] { return arm.servo.status == DeviceStatus::Ok; }));
  EXPECT_TRUE(arm.plug.alone([](test::FalconModel& model) { return model.homing; }));
  EXPECT_TRUE(arm.push({ 0.0, 0.0, push_N }));
}

/// A Falcon without firmware, and a file for it.
struct BareFalcon
{
  using Loader = test::FalconChip::Loader;

  explicit BareFalcon(const std::string& serial) : plug(serial), clock(plug)
  {
    std::iota(this->bytes.begin(), this->bytes.end(), std::uint8_t{ 3 });
    std::ofstream(this->file, std::ios::binary)
      .write(reinterpret_cast<const char*>(this->bytes.data()), static_cast<std::streamsize>(this->bytes.size()));
    this->plug.aloneWithLoader([](Loader& loader) { loader.runs = false; });
    this->plug.plug();
  }

  [[nodiscard]] std::vector<std::uint8_t> loaded()
  {
    return this->plug.aloneWithLoader([](Loader& loader) { return loader.loaded; });
  }

  test::UsbFalcon plug;
  test::FirmwareClock clock;
  std::string file = (std::filesystem::temp_directory_path() / "firmware.bin").string();
  std::vector<std::uint8_t> bytes = std::vector<std::uint8_t>(20000);
};

TEST(ArmFalcon, IsLoadedFromTheFileThatAPersonChooses)
{
  BareFalcon bare("load");
  ArmServo servo("falcon", bare.plug.serial(), &bare.clock);
  ASSERT_EQ(servo.device.open(), "");
  servo.run(50);
  ASSERT_TRUE(servo.device.step());
  EXPECT_TRUE(servo.device.step()->wantsFile);
  servo.device.stepDone(bare.file);
  Falcon::makeReady(bare.plug);
  EXPECT_TRUE(servo.runUntil([&] { return servo.status == DeviceStatus::Ok; }, 30000))
    << servo.device.linkReport().message;
  EXPECT_EQ(bare.loaded(), bare.bytes);
}

TEST(ArmFalcon, UnpluggedBeforeItHasItsFirmwareAndWhileItIsLoadedIsLostWithOneSentence)
{
  for (const bool loads : { false, true })
  {
    BareFalcon bare(loads ? "cut" : "bare");
    ArmServo servo("falcon", bare.plug.serial(), &bare.clock);
    ASSERT_EQ(servo.device.open(), "");
    servo.run(50);
    ASSERT_TRUE(servo.device.step());
    if (loads)
    {
      servo.device.stepDone(bare.file);
      ASSERT_TRUE(servo.runUntil([&] { return bare.loaded().size() > bare.bytes.size() / 10; }));
    }
    bare.plug.unplug();
    EXPECT_LT(bare.loaded().size(), bare.bytes.size());
    EXPECT_TRUE(servo.runUntil([&] { return servo.status == DeviceStatus::Lost; })) << loads;
    EXPECT_EQ(servo.device.linkReport().lostFor, "the cable was unplugged");
    EXPECT_FALSE(servo.device.step());
  }
}

} // namespace
} // namespace palpate
