// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "devices/simulated/SimulatedDevice.h"
#include "haptics/labyrinth/Labyrinth.h"
#include "haptics/recording/Recording.h"
#include "haptics/session/HapticSession.h"
#include "testing/support/TemporaryFolder.h"

namespace palpate
{
namespace
{

/// A corridor with the start within the reach of the exit, so that a game ends in its first tick of exploring.
Labyrinth shortCorridor()
{
  Labyrinth labyrinth;
  labyrinth.name = "short corridor";
  labyrinth.curves = { { { 0, 1 }, { 10, 1 }, { 10, 0 }, { 0, 0 } }, { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 } } };
  labyrinth.start_W = Eigen::Vector2d(4.5, 0.5);
  labyrinth.exit_W = Eigen::Vector2d(4.7, 0.5);
  return labyrinth;
}

constexpr int playedTicks = 8000;

/// Two games on a joystick that nobody holds, the second one asked for after 4 s; returns the phases at the ends of
/// ticks.
std::string play(const std::string& path, bool deviceHolds)
{
  const DeviceModel& model = *deviceModel("simulated-joystick");
  HapticSession session;
  HapticParameters parameters;
  parameters.contact.radius_u = shortCorridor().radius_u();
  parameters.map = fitted(shortCorridor(), model.workspaceRadius_m);
  parameters.game = gameOf(shortCorridor());
  parameters.walls.hold = deviceHolds;
  EXPECT_EQ(session.setParameters(parameters), "");
  session.setScene(SceneBuilder().build({ wallsOf(shortCorridor()) }).scene);
  SessionOptions options;
  options.virtualTime = true;
  options.recordFile = path;
  const HandPath from{ { Vec3(-0.02, 0, 0) } };
  EXPECT_EQ(session.start(std::make_unique<SimulatedDevice>(model, *handModel("none"), from), options), "");
  std::string phases;
  for (int tick = 0; tick < playedTicks; ++tick)
  {
    if (tick == playedTicks / 2)
    {
      session.play();
    }
    EXPECT_EQ(session.step(1), 1);
    const std::string phase = name(session.state().game);
    if (phases.size() < phase.size() + 1 || phases.compare(phases.size() - phase.size() - 1, phase.size(), phase) != 0)
    {
      phases += phase + ";";
    }
  }
  EXPECT_EQ(session.stop(), "");
  return phases;
}

/// The first tick in which the device is asked for a signal; null if there is none.
TickRecord* signalledTick(Recording& recording)
{
  for (RecordedEntry& entry : recording.entries)
  {
    if (auto* const tick = std::get_if<TickRecord>(&entry); tick != nullptr && tick->signal != Signal::None)
    {
      return tick;
    }
  }
  return nullptr;
}

TEST(LabyrinthGame, IsRecordedAndReplayedBitForBitWithASecondGameAskedForByAnEvent)
{
  for (const bool deviceHolds : { false, true })
  {
    const test::TemporaryFolder folder;
    const std::string path = folder.file("game");
    const std::string phases = play(path, deviceHolds);
    EXPECT_EQ(phases, "waits;leads;lets go;arrived;rests;lets go;arrived;rests;");
    auto read = readRecording(path);
    ASSERT_TRUE(std::holds_alternative<Recording>(read)) << std::get<std::string>(read);
    auto& recording = std::get<Recording>(read);
    const ReplayResult result = replay(recording);
    EXPECT_EQ(result.problem, "");
    EXPECT_EQ(result.difference, "");
    EXPECT_EQ(result.ticks, static_cast<std::uint64_t>(playedTicks));
    TickRecord* const shaken = signalledTick(recording);
    ASSERT_EQ(shaken != nullptr, deviceHolds) << "a device that holds the walls shakes by itself";
    if (shaken != nullptr)
    {
      shaken->signal = Signal::None;
      EXPECT_EQ(replay(recording).difference, "tick " + std::to_string(shaken->tick) + ": signal differs");
    }
  }
}

} // namespace
} // namespace palpate
