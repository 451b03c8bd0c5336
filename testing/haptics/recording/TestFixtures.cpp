// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdlib>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "haptics/recording/Recording.h"
#include "testing/haptics/recording/FixtureSessions.h"
#include "testing/support/TemporaryFolder.h"

namespace palpate
{
namespace
{

std::filesystem::path fixtures()
{
  return std::filesystem::path(PALPATE_FIXTURES);
}

/// The recordings in fixtures/ of that session, one a format.
std::vector<std::string> fixturesOf(const std::string& session)
{
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(fixtures()))
  {
    if (entry.path().string().ends_with("-" + session + ".palpate"))
    {
      files.push_back(entry.path().string());
    }
  }
  return files;
}

Recording readGood(const std::string& path)
{
  auto read = readRecording(path);
  EXPECT_TRUE(std::holds_alternative<Recording>(read)) << std::get<std::string>(read);
  return std::get<Recording>(std::move(read));
}

/// What a session lived through, in words.
std::set<std::string> livedThrough(const HapticState& s)
{
  const std::pair<bool, std::string> seen[] = {
    { s.contacts > 0 && s.force_D.norm() > 0.1, "force" },
    { s.friction == FrictionState::Sticks, "sticks" },
    { s.friction == FrictionState::Slips, "slips" },
    { s.stabiliser_D.norm() > 0.0, "stabiliser" },
    { s.motionLag_s > 0.0, "moving surfaces" },
    { s.stiffnessLimited, "stiffness limited" },
    { s.stiffnessFactor < 1.0, "late" },
    { s.held, "held" },
    { s.clamped || s.riseLimited, "limited" },
    { s.letGo, "let go" },
    { s.guideShare == 1.0, "guided" },
    { s.deviceHolds && s.walls >= 2, "held walls" },
    { s.fault != Fault::None, std::string("fault: ") + describe(s.fault) },
    { true, std::string("game ") + name(s.game) },
    { true, name(s.engage) },
  };
  std::set<std::string> words;
  for (const auto& [happened, what] : seen)
  {
    if (happened)
    {
      words.insert(what);
    }
  }
  return words;
}

/// Replays a recording and says what was lived through.
std::set<std::string> replayed(const Recording& recording)
{
  std::set<std::string> lived;
  const ReplayResult result =
    replay(recording, {}, 1, [&lived](const TickOutput& output) { lived.merge(livedThrough(output.state)); });
  EXPECT_EQ(result.problem, "");
  EXPECT_EQ(result.difference, "");
  return lived;
}

void expectAll(const std::set<std::string>& lived, const std::set<std::string>& wanted, const std::string& file)
{
  for (const std::string& what : wanted)
  {
    EXPECT_TRUE(lived.contains(what)) << file << " never came to: " << what;
  }
}

std::string faulted(Fault fault)
{
  return std::string("fault: ") + describe(fault);
}

TEST(Fixtures, OfAHandOnSurfacesReplayBitForBitInEveryFormatThereWas)
{
  const std::vector<std::string> files = fixturesOf("solid");
  ASSERT_FALSE(files.empty());
  for (const std::string& file : files)
  {
    expectAll(replayed(readGood(file)),
      { "force", "sticks", "slips", "stabiliser", "moving surfaces", "stiffness limited", "late", "held", "limited",
        "safe", "armed", "engaged", "fault", faulted(Fault::NonFiniteSample), faulted(Fault::LateServo),
        faulted(Fault::DeviceLost), faulted(Fault::NoHand) },
      file);
  }
}

TEST(Fixtures, OfAHandOnLinesReplayBitForBitInEveryFormatThereWas)
{
  const std::vector<std::string> files = fixturesOf("plane");
  ASSERT_FALSE(files.empty());
  for (const std::string& file : files)
  {
    expectAll(replayed(readGood(file)),
      { "force", "guided", "held walls", "let go", "game waits", "game leads", "game lets go", "game explores",
        "game arrived", "game rests" },
      file);
  }
}

} // namespace
} // namespace palpate
