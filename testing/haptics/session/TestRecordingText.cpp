// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "haptics/session/RecordingText.h"

namespace palpate
{
namespace
{

TEST(RecordingText, SaysNothingBeforeAnythingIsRecorded)
{
  EXPECT_EQ(recordingText({}), "");
}

TEST(RecordingText, SaysHowItIsAndWhatCanBeDoneNext)
{
  EXPECT_EQ(recordingText({ true, false, 0.0, "", false }), "Recording begins with Touch.");
  EXPECT_EQ(recordingText({ true, true, 12.34, "old.palpate", true }), "Recording: 12.3 s so far.");
  EXPECT_EQ(
    recordingText({ false, false, 2.0, "a.palpate", false }), "2.0 s recorded in a.palpate: save it, or replay it.");
  EXPECT_EQ(recordingText({ false, false, 2.0, "b.palpate", true }), "2.0 s recorded in b.palpate.");
}

TEST(RecordingText, OneThatIsWantedNextStandsBeforeOneThatIsThere)
{
  EXPECT_EQ(recordingText({ true, false, 2.0, "a.palpate", false }), "Recording begins with Touch.");
}

} // namespace
} // namespace palpate
