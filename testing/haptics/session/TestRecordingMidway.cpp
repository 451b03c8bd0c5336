// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings that begin and end while a hand touches, and disks that are full.
#include <cmath>
#include <csignal>
#include <filesystem>
#include <functional>

#include <gtest/gtest.h>
#include <sys/resource.h>

#include "devices/FedDevice.h"
#include "haptics/recording/RecordingChunks.h"
#include "haptics/recording/writing/EndedRecording.h"
#include "haptics/session/HapticSession.h"
#include "testing/support/Eventually.h"
#include "testing/support/Meshes.h"
#include "testing/support/TemporaryFolder.h"

namespace palpate
{
namespace
{

constexpr double radius_m = 0.05; // of the sphere

/// A session in virtual time or not, and a hand that strokes a sphere 1 to 3 mm deep, with friction, as a ball.
class Stroke
{
public:
  explicit Stroke(bool virtualTime = true)
  {
    HapticParameters parameters;
    parameters.contact.radius_u = 0.001;
    parameters.contact.friction = { 0.4, 0.3 };
    parameters.safety.engageRamp_s = 0.01;
    EXPECT_EQ(this->session.setParameters(parameters), "");
    this->session.setScene(test::sceneOf(test::makeIcosphere(3, radius_m)));
    SessionOptions options;
    options.virtualTime = virtualTime;
    EXPECT_EQ(this->session.start(std::make_unique<FedDevice>(), options), "");
    this->feed(Vec3(0.0, 0.0, radius_m + 0.002));
  }

  void feed(const Vec3& p_D)
  {
    DeviceSample sample;
    sample.pose_D.p = p_D;
    static_cast<FedDevice*>(this->session.device())->feed(sample);
  }

  void run(int ticks)
  {
    for (int i = 0; i < ticks; ++i)
    {
      const double s = 1e-3 * this->tick++;
      const double angle = 0.6 * std::sin(1.3 * s);
      this->feed((radius_m - 0.001 - 0.001 * std::sin(7.0 * s)) * Vec3(std::sin(angle), 0.0, std::cos(angle)));
      ASSERT_EQ(this->session.step(1), 1);
    }
  }

  HapticSession session;
  int tick = 0;
};

Recording readWhole(const std::string& path)
{
  auto read = readRecording(path);
  EXPECT_TRUE(std::holds_alternative<Recording>(read)) << std::get<std::string>(read);
  return std::get<Recording>(std::move(read));
}

void expectBitForBit(const Recording& recording, std::uint64_t ticks)
{
  const ReplayResult result = replay(recording);
  EXPECT_EQ(result.problem + result.difference, "");
  EXPECT_EQ(result.ticks, ticks);
}

/// No file of this process grows beyond so many bytes, and nobody is killed for trying.
class SmallDisk
{
public:
  explicit SmallDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN))
  {
    getrlimit(RLIMIT_FSIZE, &this->before_);
    const rlimit small{ bytes, this->before_.rlim_max };
    setrlimit(RLIMIT_FSIZE, &small);
  }
  ~SmallDisk()
  {
    setrlimit(RLIMIT_FSIZE, &this->before_);
    std::signal(SIGXFSZ, this->handler_);
  }

private:
  rlimit before_{};
  void (*handler_)(int);
};

TEST(RecordingMidway, BegunWhileAHandPressesReplaysBitForBitAndHoldsWhatWasTouchedMeanwhile)
{
  const test::TemporaryFolder folder;
  Stroke stroke;
  stroke.run(700);
  ASSERT_GT(stroke.session.state().force_D.norm(), 0.3) << "it presses";
  ASSERT_EQ(stroke.session.record(folder.file("a")), "");
  EXPECT_TRUE(stroke.session.recording());
  stroke.run(400);
  stroke.session.setScene(test::sceneOf(test::makeIcosphere(4, radius_m)));
  stroke.run(300);
  stroke.session.endRecording();
  EXPECT_FALSE(stroke.session.recording());
  const std::optional<EndedRecording> ended = stroke.session.takeRecorded();
  ASSERT_TRUE(ended) << "at once, for nobody else writes in virtual time";
  EXPECT_EQ(ended->file, folder.file("a"));
  EXPECT_EQ(ended->problem, "");
  EXPECT_FALSE(stroke.session.takeRecorded()) << "only once";
  stroke.run(100);
  const Recording recording = readWhole(folder.file("a"));
  EXPECT_EQ(recording.scenes.size(), 2U);
  EXPECT_EQ(recording.initialState.engage, EngageState::Engaged);
  expectBitForBit(recording, 700);
}

TEST(RecordingMidway, OneAfterTheOtherAreTwoWholeRecordings)
{
  const test::TemporaryFolder folder;
  Stroke stroke;
  stroke.run(100);
  ASSERT_EQ(stroke.session.record(folder.file("a")), "");
  stroke.run(50);
  ASSERT_EQ(stroke.session.record(folder.file("b")), "");
  stroke.run(70);
  EXPECT_EQ(stroke.session.stop(), "");
  expectBitForBit(readWhole(folder.file("a")), 50);
  expectBitForBit(readWhole(folder.file("b")), 70);
}

TEST(RecordingMidway, AFileThatCannotBeWrittenLeavesTheOneBeforeGoingOn)
{
  const test::TemporaryFolder folder;
  Stroke stroke;
  ASSERT_EQ(stroke.session.record(folder.file("a")), "");
  stroke.run(50);
  EXPECT_NE(stroke.session.record("/nonexistent-folder/b").find("/nonexistent-folder/b"), std::string::npos);
  EXPECT_TRUE(stroke.session.recording());
  stroke.run(50);
  EXPECT_EQ(stroke.session.stop(), "");
  expectBitForBit(readWhole(folder.file("a")), 100);
}

TEST(RecordingMidway, TheHandFeelsNothingOfABeginningOrAnEnd)
{
  const test::TemporaryFolder folder;
  Stroke recorded, other;
  for (int tick = 0; tick < 2000; ++tick)
  {
    if (tick % 200 == 100)
    {
      ASSERT_EQ(recorded.session.record(folder.file(std::to_string(tick))), "");
    }
    if (tick % 200 == 150)
    {
      recorded.session.endRecording();
    }
    recorded.run(1);
    other.run(1);
    // The ball is sought anew from the place where it was, under the same hand: the same to rounding of metres and
    // newtons, thousands of times below the resolution of an encoder or a hand.
    ASSERT_LT((recorded.session.state().force_D - other.session.state().force_D).norm(), 1e-6) << tick;
  }
}

TEST(RecordingMidway, OfAServoThreadIsWholeOnceItsLastTickIsWritten)
{
  const test::TemporaryFolder folder;
  Stroke stroke(false);
  ASSERT_TRUE(test::eventually([&] { return stroke.session.state().tick > 20; }));
  ASSERT_EQ(stroke.session.record(folder.file("a")), "");
  const std::uint64_t begun = stroke.session.state().tick;
  ASSERT_TRUE(test::eventually([&] { return stroke.session.state().tick > begun + 50; }));
  stroke.session.endRecording();
  std::optional<EndedRecording> ended;
  ASSERT_TRUE(test::eventually([&] { return (ended = stroke.session.takeRecorded()).has_value(); }));
  EXPECT_EQ(ended->problem, "");
  const Recording recording = readWhole(folder.file("a"));
  const ReplayResult result = replay(recording);
  EXPECT_EQ(result.problem + result.difference, "");
  EXPECT_GE(result.ticks, 40U);
  EXPECT_EQ(stroke.session.stop(), "");
}

/// The most ticks that fit: the bytes before the first of them, then whole ticks, then the closing mark.
TEST(RecordingMidway, ADiskThatIsFullEndsItAndEveryTickThatFitsIsKept)
{
  constexpr rlim_t room = 300000;
  const test::TemporaryFolder folder;
  std::optional<EndedRecording> ended;
  {
    const SmallDisk disk(room);
    Stroke stroke;
    ASSERT_EQ(stroke.session.record(folder.file("a")), "");
    int ticks = 0;
    while (!(ended = stroke.session.takeRecorded()) && ++ticks < 10000)
    {
      stroke.run(1);
    }
    EXPECT_FALSE(stroke.session.recording());
    EXPECT_GT(stroke.session.state().force_D.norm(), 0.3) << "touching goes on";
    EXPECT_EQ(stroke.session.stop(), "");
  }
  ASSERT_TRUE(ended);
  EXPECT_EQ(ended->file, folder.file("a"));
  for (const std::string& part : { folder.file("a"), std::string("full"), std::string("kept") })
  {
    EXPECT_NE(ended->problem.find(part), std::string::npos) << ended->problem;
  }
  const Recording recording = readWhole(folder.file("a"));
  const ReplayResult result = replay(recording);
  EXPECT_EQ(result.problem + result.difference, "");
  const std::uintmax_t size = std::filesystem::file_size(folder.file("a"));
  EXPECT_LE(size, room);
  EXPECT_GT(size + recordedChunk(tickChunk(TickRecord{}), 1).size(), room) << "one more did not fit";
  EXPECT_GT(result.ticks, 100U);
}

TEST(RecordingMidway, ADiskWithoutRoomForItsBeginningIsSaidAndLeavesNoFileOfItsName)
{
  const test::TemporaryFolder folder;
  std::optional<EndedRecording> ended;
  {
    const SmallDisk disk(100);
    Stroke stroke;
    ASSERT_EQ(stroke.session.record(folder.file("a")), "");
    int ticks = 0;
    while (!(ended = stroke.session.takeRecorded()) && ++ticks < 10)
    {
      stroke.run(1);
    }
    EXPECT_EQ(stroke.session.stop(), "");
  }
  ASSERT_TRUE(ended);
  EXPECT_EQ(ended->file, "");
  EXPECT_NE(ended->problem.find("full"), std::string::npos) << ended->problem;
  EXPECT_FALSE(std::filesystem::exists(folder.file("a")));
}

} // namespace
} // namespace palpate
