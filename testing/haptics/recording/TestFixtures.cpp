// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdlib>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "haptics/recording/Recording.h"
#include "testing/haptics/recording/FixtureSessions.h"
#include "testing/support/TemporaryFolder.h"

namespace palpate
{
namespace
{

/// The recording in fixtures/ of that session.
Recording fixtureOf(const std::string& session)
{
  auto read = readRecording(std::string(PALPATE_FIXTURES) + "/format-8-" + session + ".palpate");
  EXPECT_TRUE(std::holds_alternative<Recording>(read)) << std::get<std::string>(read);
  return std::get<Recording>(std::move(read));
}

/// The events of a session, in words.
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

/// Replays a recording and returns its events.
std::set<std::string> replayed(const Recording& recording)
{
  std::set<std::string> lived;
  const ReplayResult result =
    replay(recording, {}, 1, [&lived](const TickOutput& output) { lived.merge(livedThrough(output.state)); });
  EXPECT_EQ(result.problem, "");
  EXPECT_EQ(result.difference, "");
  return lived;
}

void expectAll(const std::set<std::string>& lived, const std::set<std::string>& wanted)
{
  for (const std::string& what : wanted)
  {
    EXPECT_TRUE(lived.contains(what)) << "never came to: " << what;
  }
}

std::string faulted(Fault fault)
{
  return std::string("fault: ") + describe(fault);
}

TEST(Fixtures, OfAHandOnSurfacesReplayBitForBit)
{
  expectAll(replayed(fixtureOf("solid")),
    { "force", "sticks", "slips", "stabiliser", "moving surfaces", "stiffness limited", "late", "held", "limited",
      "safe", "armed", "engaged", "fault", faulted(Fault::NonFiniteSample), faulted(Fault::LateServo),
      faulted(Fault::DeviceLost), faulted(Fault::NoHand) });
}

TEST(Fixtures, OfAHandOnLinesReplayBitForBit)
{
  expectAll(replayed(fixtureOf("plane")), { "force", "guided", "held walls", "let go", "game waits", "game leads",
                                            "game lets go", "game explores", "game arrived", "game rests" });
}

} // namespace
} // namespace palpate
