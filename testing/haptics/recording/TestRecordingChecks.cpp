// SPDX-License-Identifier: GPL-3.0-or-later
// A recording whose bytes are not those that were written says so.
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "haptics/core/Checksum.h"
#include "haptics/recording/Recording.h"
#include "testing/haptics/recording/CutRecording.h"
#include "testing/haptics/recording/FixtureSessions.h"
#include "testing/haptics/recording/FlippedBits.h"
#include "testing/haptics/recording/RecordingBytes.h"
#include "testing/support/Random.h"
#include "testing/support/TemporaryFolder.h"

namespace palpate
{
namespace
{

std::uint32_t checksumOf(const std::string& bytes)
{
  return crc32c(bytes.data(), bytes.size());
}

/// RFC 3720, appendix B.4, and the check value of the catalogue of parametrised CRC algorithms.
TEST(Checksum, IsThatOfThePublishedVectors)
{
  std::string up, down;
  for (int i = 0; i < 32; ++i)
  {
    up += static_cast<char>(i);
    down += static_cast<char>(31 - i);
  }
  EXPECT_EQ(checksumOf(std::string(32, '\0')), 0x8a9136aau);
  EXPECT_EQ(checksumOf(std::string(32, '\xff')), 0x62a8ab43u);
  EXPECT_EQ(checksumOf(up), 0x46dd794eu);
  EXPECT_EQ(checksumOf(down), 0x113fdb5cu);
  EXPECT_EQ(checksumOf("123456789"), 0xe3069283u);
  EXPECT_EQ(checksumOf(""), 0u);
}

TEST(Checksum, IsTheRemainderOfTheDivisionWhereverBytesLieAndHoweverManyThereAre)
{
  test::Random random(11);
  std::vector<char> bytes(300);
  for (char& byte : bytes)
  {
    byte = static_cast<char>(random.below(256));
  }
  for (std::size_t size = 0; size < 70; ++size)
  {
    const std::size_t begin = random.below(static_cast<std::uint32_t>(bytes.size() - size));
    EXPECT_EQ(crc32c(bytes.data() + begin, size), test::plainCrc32c(bytes.data() + begin, size)) << size;
  }
}

TEST(RecordingChecks, AreWrittenAsTheFormatSays)
{
  const test::TemporaryFolder folder;
  ASSERT_EQ(test::recordPlane(folder.file("a")), "");
  const std::vector<char> written = test::bytesOf(folder.file("a"));
  std::vector<char> repaired = written;
  test::repairChecks(repaired, test::plainCrc32c);
  EXPECT_EQ(written, repaired);
  EXPECT_EQ(written, test::putTogether(test::takeApart(folder.file("a")))) << "chunks are numbered from 1 on";
  ASSERT_NE(test::checkedChunksBegin(written), 0u);
}

TEST(RecordingChecks, NameTheChunkOfEveryBitThatFlipsInARecordingOfSurfacesThatMove)
{
  const test::TemporaryFolder folder;
  ASSERT_EQ(test::recordSolid(folder.file("a")), "");
  test::FlippedBits(folder.file("a")).expectEachIsNamed(21, "motion");
}

/// A hand that touches nothing has the same tick again and again: but for their numbers most chunks could be exchanged.
TEST(RecordingChecks, NameThePlaceWhereAChunkIsMissingDoubledOrExchanged)
{
  const test::TemporaryFolder folder;
  ASSERT_EQ(test::recordPlane(folder.file("a")), "");
  const test::CutRecording cut(folder.file("a"));
  const std::size_t last = cut.chunks() - 1;
  const std::size_t stride = 1 + last / 200;
  for (std::size_t i = 0; i < last; i += stride)
  {
    const auto stands = [i](std::size_t place, std::size_t number)
    {
      return "it is damaged: in the place of its chunk " + std::to_string(i + place) + " stands its chunk " +
             std::to_string(i + number) + ",";
    };
    EXPECT_TRUE(cut.problemOf(i, i + 1, {}).starts_with(stands(1, 2))) << "missing: " << i;
    EXPECT_TRUE(cut.problemOf(i, i + 1, { i, i }).starts_with(stands(2, 1))) << "doubled: " << i;
    EXPECT_TRUE(cut.problemOf(i, i + 2, { i + 1, i }).starts_with(stands(1, 2))) << "exchanged: " << i;
  }
  EXPECT_EQ(cut.problemOf(last, last + 1, {}), "it is cut short: it ends without its closing mark");
  EXPECT_EQ(cut.problemOf(last, last + 1, { last, last }), "it is damaged: something follows its closing mark");
}

TEST(RecordingChecks, NameTheChunkOfEveryBitThatFlipsInAFixture)
{
  int fixtures = 0;
  for (const auto& file : std::filesystem::directory_iterator(PALPATE_FIXTURES))
  {
    if (file.path().extension() == ".palpate")
    {
      test::FlippedBits(file.path().string()).expectEachIsNamed(22, "scene");
      ++fixtures;
    }
  }
  EXPECT_EQ(fixtures, 2);
}

/// A disk or a transfer loses the end, not a bit: that is another sentence.
TEST(RecordingChecks, OfARecordingThatEndsTooEarlyAreNotCalledWrong)
{
  const test::TemporaryFolder folder;
  ASSERT_EQ(test::recordPlane(folder.file("a")), "");
  const std::vector<char> whole = test::putTogether(test::takeApart(folder.file("a")));
  const std::size_t begin = test::checkedChunksBegin(whole);
  for (std::size_t length = begin; length < whole.size(); length += 1 + whole.size() / 997)
  {
    const auto read = parseRecording({ whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length) }, "it");
    ASSERT_TRUE(std::holds_alternative<std::string>(read)) << length;
    EXPECT_EQ(std::get<std::string>(read), "it is cut short: it ends without its closing mark") << length;
  }
}

} // namespace
} // namespace palpate
