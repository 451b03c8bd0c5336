// SPDX-License-Identifier: GPL-3.0-or-later
// The guard of a device that keeps its torque when its host dies: a process of its own, on a real serial line.
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stop_token>
#include <string>
#include <sys/wait.h>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "devices/arm/WireLine.h"
#include "devices/arm/kit/Kits.h"
#include "devices/arm/link/Guard.h"
#include "devices/arm/link/SerialPort.h"
#include "devices/arm/protocol/FalconWire.h"
#include "haptics/arm/file/ArmFile.h"
#include "testing/devices/arm/FalconModel.h"
#include "testing/devices/arm/PtyBoard.h"
#include "testing/devices/arm/TwoDiyModel.h"
#include "testing/support/Eventually.h"
#include "testing/support/Random.h"
#include "testing/support/TemporaryFolder.h"

namespace palpate
{
namespace
{

constexpr double pushed_Nm = 0.05;
constexpr int generous_ms = 20000; ///< for an answer on a machine that is busy

/// The two that keep their torque, on a serial line. A Falcon's guard writes to a USB endpoint in its stead, which a
/// guest alone has (testing/vm/arm).
struct KilledTwoDiy
{
  using Model = test::TwoDiyModel;
  static ArmBus::Opened open(const std::string& path) { return twoDiyKit().bus->open({ path, 0, 0, {}, {} }); }
  static double torque(const Model& model) { return std::hypot(model.torque_Nm[0], model.torque_Nm[1]); }
};

/// The arm of an owner's file on such a board.
struct KilledOwnArm
{
  using Model = test::TwoDiyModel;
  static ArmBus::Opened open(const std::string& path)
  {
    const test::TemporaryFolder folder;
    std::ofstream(folder.file("own.json")) << armText("pantograph").value;
    return ownArmKits(folder.path(), {}).at(0).bus->open({ path, 0, 0, {}, {} });
  }
  static double torque(const Model& model) { return KilledTwoDiy::torque(model); }
};

struct KilledFalcon
{
  using Model = test::FalconModel;
  static ArmBus::Opened open(const std::string& path)
  {
    Outcome<std::unique_ptr<SerialPort>> port = SerialPort::open(path);
    const auto wire = std::make_shared<FalconWire>();
    Outcome<Guard> guard = Guard::start(port.ok() ? port.value->handle() : -1, 0, wire->farewell());
    return { guard.ok() ? std::make_unique<WireLine>(std::move(port.value), wire, std::move(guard.value)) : nullptr,
      guard.problem };
  }
  static double torque(const Model& model)
  {
    return std::hypot(model.motor[0], model.motor[1], model.motor[2]) / std::abs(FalconWire::number_per_Nm);
  }
};

/// Pushes until it is killed. With a child that holds a copy of everything that it has.
[[noreturn]] void pushForEver(const ArmBus::Opened& opened, bool withChild)
{
  if (opened.value == nullptr)
  {
    _exit(3);
  }
  if (withChild && fork() == 0)
  {
    pause();
    _exit(0);
  }
  WireOrder order;
  order.joint_Nm = { pushed_Nm, -pushed_Nm, 0.0 };
  for (;;)
  {
    static_cast<void>(opened.value->exchange(order, 5));
  }
}

/// A program that pushes a board, and is killed after it got that many answers. The time until then is printed alone:
/// guard and board are processes on a machine that may be busy, and the board has no clock of its own here. Tests in a
/// guest judge the time (testing/vm/arm).
template<class Kit>
void expectNoTorqueAfterDeath(bool withChild, int answers)
{
  typename Kit::Model model;
  test::PtyBoard board(model);
  const pid_t program = fork();
  if (program == 0)
  {
    setsid();
    close(board.file());
    pushForEver(Kit::open(board.path()), withChild);
  }
  const auto serveUntil = [&](auto over)
  {
    const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (!over() && std::chrono::steady_clock::now() < until)
    {
      board.serve(1);
    }
    return over();
  };
  ASSERT_TRUE(serveUntil([&] { return Kit::torque(model) > 0.9 * pushed_Nm && model.answers >= answers; }));
  const auto killed = std::chrono::steady_clock::now();
  kill(program, SIGKILL);
  EXPECT_TRUE(serveUntil([&] { return Kit::torque(model) == 0.0; }));
  const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - killed;
  std::printf("no torque %.1f ms after the death of the program\n", took.count());
  kill(-program, SIGKILL);
  EXPECT_EQ(waitpid(program, nullptr, 0), program);
  for (int i = 0; i < 50; ++i)
  {
    board.serve(1);
    ASSERT_EQ(Kit::torque(model), 0.0) << "and it stays so";
  }
}

template<class Kit>
class GuardOfAKilledProgram : public testing::Test
{
};
using KilledArms = testing::Types<KilledTwoDiy, KilledOwnArm, KilledFalcon>;
TYPED_TEST_SUITE(GuardOfAKilledProgram, KilledArms);

TYPED_TEST(GuardOfAKilledProgram, EndsTheTorque)
{
  expectNoTorqueAfterDeath<TypeParam>(false, 50);
}

TYPED_TEST(GuardOfAKilledProgram, EndsItAlsoWhereAChildOfTheProgramHoldsItsPipe)
{
  expectNoTorqueAfterDeath<TypeParam>(true, 50);
}

TYPED_TEST(GuardOfAKilledProgram, EndsItAlsoWhereTheProgramIsKilledAtItsFirstPush)
{
  const std::size_t times = test::testCount(20);
  for (std::size_t i = 0; i < times && !testing::Test::HasFailure(); ++i)
  {
    expectNoTorqueAfterDeath<TypeParam>(true, 1);
  }
}

TEST(Guard, ThatIsEndedItselfEndsTheForce)
{
  test::TwoDiyModel model;
  test::PtyBoard board(model);
  Outcome<std::unique_ptr<SerialPort>> port = SerialPort::open(board.path());
  ASSERT_TRUE(port.ok()) << port.problem;
  const WireBytes noTorque{ 2, 5, 0, 0, 0, 0, 0, 0, 0, 0 };
  Outcome<Guard> guard = Guard::start(port.value->handle(), 0, noTorque);
  ASSERT_TRUE(guard.ok()) << guard.problem;
  EXPECT_TRUE(guard.value.watches());
  kill(guard.value.process(), SIGTERM);
  kill(guard.value.process(), SIGINT);
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_TRUE(guard.value.watches()) << "what ends programs politely does not end it";
  kill(guard.value.process(), SIGKILL);
  EXPECT_TRUE(test::eventually([&] { return !guard.value.watches(); }));
}

/// The guard that this process has started; -1: none, or more than one.
pid_t guardOfThisProcess()
{
  pid_t found = -1;
  int guards = 0;
  for (const auto& folder : std::filesystem::directory_iterator("/proc"))
  {
    // "12 (palpate-guard) S 7 ...": its number, name, state and parent.
    std::string number, name, state;
    pid_t parent = -1;
    if (std::ifstream(folder.path() / "stat") >> number >> name >> state >> parent && name == "(palpate-guard)" &&
        parent == getpid())
    {
      found = static_cast<pid_t>(std::stoi(number));
      ++guards;
    }
  }
  return guards == 1 ? found : -1;
}

TEST(Guard, ThatIsKilledEndsTheForceOfItsLine)
{
  test::TwoDiyModel model;
  test::PtyBoard board(model);
  const ArmBus::Opened opened = KilledTwoDiy::open(board.path());
  ASSERT_NE(opened.value, nullptr) << opened.problem;
  WireOrder order;
  order.joint_Nm = { pushed_Nm, -pushed_Nm, 0.0 };
  {
    const std::jthread firmware(
      [&board](const std::stop_token& over)
      {
        while (!over.stop_requested())
        {
          board.serve(1);
        }
      });
    ASSERT_EQ(opened.value->exchange(order, generous_ms).said, ArmLine::Said::Reading) << opened.value->error();
  }
  ASSERT_GT(model.torque_Nm[0], 0.9 * pushed_Nm);
  const pid_t guard = guardOfThisProcess();
  ASSERT_GT(guard, 0);
  ASSERT_EQ(kill(guard, SIGKILL), 0);
  siginfo_t ended{};
  ASSERT_EQ(waitid(P_PID, static_cast<id_t>(guard), &ended, WEXITED | WNOWAIT), 0);

  const int orders = model.answers;
  EXPECT_EQ(opened.value->exchange(order, 0).said, ArmLine::Said::Gone);
  EXPECT_EQ(opened.value->error(), "the guard, which ends the force when this program dies, has ended");
  board.serve(50);
  EXPECT_EQ(model.answers, orders) << "nothing was ordered without a guard";
  opened.value->letGo(); // as the link does with a line that is gone
  EXPECT_TRUE(test::eventually(
    [&]
    {
      board.serve(1);
      return model.torque_Nm == std::array<double, 2>{};
    }));
  EXPECT_EQ(opened.value->exchange(order, 0).said, ArmLine::Said::Gone) << "and it stays so";
  board.serve(50);
  EXPECT_EQ(model.torque_Nm, (std::array<double, 2>{}));
}

TEST(Guard, WritesWhenItsProgramLetsGoOfItAndThenIsGone)
{
  test::TwoDiyModel model;
  test::PtyBoard board(model);
  Outcome<std::unique_ptr<SerialPort>> port = SerialPort::open(board.path());
  ASSERT_TRUE(port.ok()) << port.problem;
  pid_t process = -1;
  {
    Outcome<Guard> guard = Guard::start(port.value->handle(), 0, WireBytes{ 0xAB, 0xCD });
    ASSERT_TRUE(guard.ok()) << guard.problem;
    process = guard.value.process();
  }
  EXPECT_EQ(kill(process, 0), -1) << "it has ended and was waited for";
  std::array<std::uint8_t, 8> bytes{};
  EXPECT_EQ(read(board.file(), bytes.data(), bytes.size()), 2);
  EXPECT_EQ(bytes[0], 0xAB);
  EXPECT_EQ(bytes[1], 0xCD);
}

TEST(Guard, ThatCannotHoldTheLinkIsSaid)
{
  const Outcome<Guard> guard = Guard::start(-1, 0, WireBytes{ 1 });
  EXPECT_THAT(guard.problem, testing::HasSubstr("without it this device gives no force"));
}

TEST(Guard, IsFoundBesideLibrariesOneFolderDeepAndTwo)
{
  const test::TemporaryFolder prefix;
  const std::filesystem::path guard = prefix.path() / "libexec" / "palpate" / "palpate-guard";
  std::filesystem::create_directories(guard.parent_path());
  std::ofstream(guard) << "a program";
  for (const char* folder : { "lib", "lib/x86_64-linux-gnu" })
  {
    EXPECT_EQ(guardProgramOf(prefix.path() / folder / "libpalpate.so"), guard.string()) << folder;
  }
}

TEST(SerialPort, IsOneProgramsAlone)
{
  test::TwoDiyModel model;
  test::PtyBoard board(model);
  const Outcome<std::unique_ptr<SerialPort>> first = SerialPort::open(board.path());
  ASSERT_TRUE(first.ok()) << first.problem;
  EXPECT_THAT(SerialPort::open(board.path()).problem, testing::HasSubstr("is busy: close the other program"));
  EXPECT_THAT(SerialPort::open("/dev/none").problem, testing::HasSubstr("is gone"));
}

TEST(SerialPort, IsGoneWhenTheOtherEndIs)
{
  test::TwoDiyModel model;
  Outcome<std::unique_ptr<SerialPort>> port;
  {
    test::PtyBoard board(model);
    port = SerialPort::open(board.path());
    ASSERT_TRUE(port.ok()) << port.problem;
  }
  std::array<std::uint8_t, 8> bytes{};
  EXPECT_LT(port.value->receive(bytes, 5), 0);
  EXPECT_FALSE(port.value->send(bytes));
  EXPECT_EQ(port.value->error(), "No such device") << "which is said as an unplugged cable";
}

} // namespace
} // namespace palpate
