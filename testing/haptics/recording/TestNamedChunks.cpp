// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdint>
#include <set>
#include <string>
#include <type_traits>
#include <vector>

#include <gtest/gtest.h>

#include "haptics/recording/RecordedStages.h"
#include "haptics/recording/Recording.h"
#include "haptics/recording/bytes/RecordingLayout.h"
#include "haptics/tick/StageFields.h"
#include "testing/haptics/recording/FixtureSessions.h"
#include "testing/haptics/recording/RecordingBytes.h"
#include "testing/support/TemporaryFolder.h"

namespace palpate
{
namespace
{

using test::RawChunk;
using test::RawRecording;

/// A session in today's format, taken apart.
RawRecording recorded()
{
  const test::TemporaryFolder folder;
  const std::string file = folder.file("plane");
  EXPECT_EQ(test::recordPlane(file), "");
  return test::takeApart(file);
}

Recording readGood(const RawRecording& raw)
{
  auto read = parseRecording(test::putTogether(raw), "it");
  EXPECT_TRUE(std::holds_alternative<Recording>(read)) << std::get<std::string>(read);
  return std::holds_alternative<Recording>(read) ? std::get<Recording>(std::move(read)) : Recording{};
}

std::string problemOf(const RawRecording& raw)
{
  const auto read = parseRecording(test::putTogether(raw), "it");
  const auto* const problem = std::get_if<std::string>(&read);
  return problem != nullptr ? *problem : "";
}

std::uint64_t countOf(const RawRecording& raw, const std::string& name)
{
  return static_cast<std::uint64_t>(
    std::count_if(raw.chunks.begin(), raw.chunks.end(), [&name](const RawChunk& c) { return c.name == name; }));
}

void expectReplays(const Recording& recording, std::uint64_t ticks)
{
  const ReplayResult result = replay(recording);
  EXPECT_EQ(result.problem + result.difference, "");
  EXPECT_EQ(result.ticks, ticks);
}

TEST(NamedChunks, ThatAreUnknownAreRefusedByTheirName)
{
  RawRecording raw = recorded();
  raw.chunks.insert(raw.chunks.end() - 1, { "glove", 7, "any bytes" });
  EXPECT_NE(problemOf(raw).find("a part of kind glove, which this program does not know"), std::string::npos);
}

TEST(NamedChunks, OfAnotherVersionAreRefusedByIt)
{
  for (const std::uint32_t version : { chunks::tick.version - 1, chunks::tick.version + 1 })
  {
    RawRecording raw = recorded();
    for (RawChunk& chunk : raw.chunks)
    {
      chunk.version = chunk.name == "tick" ? version : chunk.version;
    }
    EXPECT_NE(problemOf(raw).find("tick in version " + std::to_string(version)), std::string::npos);
  }
}

TEST(NamedChunks, OfTicksHoldTheirPoseTargetToTheBit)
{
  constexpr std::size_t targetBytes = (7 + 1) * sizeof(double); // pose, stiffness
  RawRecording raw = recorded();
  expectReplays(readGood(raw), countOf(raw, "tick"));
  for (RawChunk& chunk : raw.chunks)
  {
    if (chunk.name == "tick")
    {
      chunk.payload[chunk.payload.size() - targetBytes] ^= 1; // the last bit of where the target is
      break;
    }
  }
  EXPECT_NE(replay(readGood(raw)).difference.find("target differs"), std::string::npos);
}

TEST(NamedChunks, OfTodaysVersionWithMoreThanTheyHoldAreDamaged)
{
  for (const std::size_t at : { std::size_t{ 2 }, std::size_t{ 10 } })
  {
    RawRecording raw = recorded();
    raw.chunks[at].payload += "more";
    EXPECT_NE(problemOf(raw).find("is damaged: a part of kind " + raw.chunks[at].name), std::string::npos) << at;
  }
}

TEST(NamedChunks, OfABrickWithoutItsBytesAreDamaged)
{
  RawRecording raw = recorded();
  raw.chunks.insert(raw.chunks.begin() + 1, { "brick", input::FieldBlocks::chunk.version, "" });
  EXPECT_NE(problemOf(raw), "");
}

TEST(NamedChunks, BeginWithTheirFirstParameters)
{
  RawRecording raw = recorded();
  raw.chunks.erase(raw.chunks.begin());
  EXPECT_EQ(problemOf(raw), "it is damaged: it does not begin with its first parameters");
}

TEST(NamedChunks, WithANameThatCannotBeShownAreDamaged)
{
  RawRecording raw = recorded();
  raw.chunks[4].name = "\x1b[2J";
  EXPECT_EQ(problemOf(raw), "it is damaged: it has a part of unknown kind");
}

/// The start chunk's text with these parameters.
std::string startWith(const std::string& parameters)
{
  return test::rawPart("parameters", parameters);
}

TEST(RecordedParameters, ThatALackingFieldAndALackingStageKeepTheirDefaults)
{
  const double stiffness_N_per_m = 123.0;
  RawRecording raw = recorded();
  raw.chunks.front().payload =
    startWith(test::rawPart("guide", test::rawPart("stiffness_N_per_m", test::raw(stiffness_N_per_m))));
  const Recording recording = readGood(raw);
  EXPECT_EQ(recording.parameters.guide.stiffness_N_per_m, stiffness_N_per_m);
  EXPECT_EQ(recording.parameters.guide.largest_N, GuidePlan{}.largest_N);
  EXPECT_EQ(recording.parameters.safety.maxForce_N, SafetyLimits{}.maxForce_N);
}

TEST(RecordedParameters, ThatCannotBeAreRefused)
{
  const std::string impossible[] = {
    test::rawPart("guide", test::rawPart("stiffness_N_per_m", test::raw(-1.0))),
    test::rawPart("guide", test::rawPart("stiffness_N_per_m", test::raw(1.0F))),
    test::rawPart("guide", test::rawPart("on", test::raw(std::uint8_t{ 2 }))),
    test::rawPart("guide", "cut"),
    test::rawPart("guide", test::rawPart("colour", test::raw(1.0))),
    test::rawPart("magnet", test::rawPart("pull_N", test::raw(1.0))),
    "cut",
  };
  for (const std::string& parameters : impossible)
  {
    RawRecording raw = recorded();
    raw.chunks.front().payload = startWith(parameters);
    EXPECT_EQ(problemOf(raw).rfind("it is damaged: ", 0), 0U) << parameters;
  }
}

/// Gives each field it is shown another value than any before it had.
struct Scramble
{
  int& next;

  template<class T>
  void operator()(const char* /*name*/, T& value) const
  {
    ++this->next;
    if constexpr (std::is_same_v<T, bool>)
    {
      value = !value;
    }
    else if constexpr (std::is_same_v<T, Vec3>)
    {
      value = Vec3(this->next, this->next + 0.25, this->next + 0.5);
    }
    else if constexpr (std::is_same_v<T, Pose>)
    {
      value.p = Vec3(this->next, this->next + 0.25, this->next + 0.5);
    }
    else if constexpr (std::is_same_v<T, Quat>)
    {
      value.coeffs() << this->next, this->next + 0.25, this->next + 0.5, this->next + 0.75;
    }
    else if constexpr (HasMembers<T>)
    {
      int each = this->next;
      membersOf([&each](auto& one) { Scramble{ each }("", one); }, value);
    }
    else if constexpr (requires { value.begin(); })
    {
      int each = this->next; // a field, however many numbers it has
      std::for_each(value.begin(), value.end(), [&each](auto& one) { Scramble{ each }("", one); });
    }
    else
    {
      value = static_cast<T>(this->next);
    }
  }
};

/// Counts the fields of two objects that are the same to the bit, and those that differ.
struct Compare
{
  int& same;
  int& different;

  template<class T>
  void operator()(const char* /*name*/, const T& a, const T& b) const
  {
    ByteWriter first, second;
    first.put(a);
    second.put(b);
    ++(first.bytes() == second.bytes() ? this->same : this->different);
  }
};

TEST(RecordedParameters, EveryFieldOfEveryPlanComesBackBitForBit)
{
  int fields = 0, same = 0, different = 0;
  HapticParameters written, read;
  forEachPlan([&](std::string_view, const auto& visit) { visit(Scramble{ fields }, written); });
  forEachPlan([&](std::string_view, const auto& visit) { visit(Compare{ same, different }, written, read); });
  EXPECT_EQ(different, fields) << "each has another value than its default";
  ByteWriter bytes;
  putParameters(bytes, written);
  ByteReader in(bytes.bytes().data(), bytes.bytes().size());
  getParameters(in, read);
  EXPECT_TRUE(in.ok());
  same = different = 0;
  forEachPlan([&](std::string_view, const auto& visit) { visit(Compare{ same, different }, written, read); });
  EXPECT_EQ(different, 0);
  EXPECT_EQ(same, fields);
}

TEST(RecordedParameters, EveryRecordedFieldOfEveryStateComesBackBitForBit)
{
  int fields = 0, same = 0, different = 0;
  RendererState written, read;
  forEachState([&](std::string_view, const auto& visit) { visit(Scramble{ fields }, written); });
  ByteWriter bytes;
  putState(bytes, written);
  ByteReader in(bytes.bytes().data(), bytes.bytes().size());
  getState(in, read);
  EXPECT_TRUE(in.ok());
  forEachState([&](std::string_view, const auto& visit) { visit(Compare{ same, different }, written, read); });
  EXPECT_EQ(different, 0);
  EXPECT_EQ(same, fields);
  EXPECT_GT(fields, 30);
}

TEST(RecordedParameters, NoTwoFieldsOfAStageAndNoTwoStagesHaveOneName)
{
  std::set<std::string> stages;
  forEachPlan(
    [&stages](std::string_view stage, const auto& visit)
    {
      EXPECT_TRUE(stages.insert(std::string(stage)).second) << stage;
      std::set<std::string> names;
      HapticParameters parameters;
      visit([&names, stage](const char* name, const auto&) { EXPECT_TRUE(names.insert(name).second) << stage << name; },
        parameters);
    });
}

/// Where in memory a member lies.
struct Extent
{
  std::uintptr_t begin = 0, end = 0;
  std::size_t alignment = 1;
};

struct Locate
{
  std::vector<Extent>& extents;

  template<class T>
  void operator()(const char* /*name*/, const T& member) const
  {
    const auto begin = reinterpret_cast<std::uintptr_t>(&member);
    this->extents.push_back({ begin, begin + sizeof(T), alignof(T) });
  }
};

/// Between the members that are named there is never space for another one.
template<class Plan>
void expectNoHoles(std::vector<Extent> members, const Plan& plan, std::string_view stage)
{
  std::sort(members.begin(), members.end(), [](const Extent& a, const Extent& b) { return a.begin < b.begin; });
  auto at = reinterpret_cast<std::uintptr_t>(&plan);
  members.push_back({ at + sizeof(Plan), at + sizeof(Plan), alignof(Plan) });
  for (const Extent& member : members)
  {
    EXPECT_LT(member.begin - at, member.alignment) << stage;
    at = member.end;
  }
}

TEST(RecordedParameters, LeaveNoMemberOfAPlanOutButWhatEachTickSets)
{
  TickStages::forEach(
    []<class S>(std::type_identity<S>)
    {
      if constexpr (HasPlan<S>)
      {
        const typename S::Plan plan{};
        std::vector<Extent> members;
        S::planFields(Locate{ members }, plan);
        if constexpr (std::is_same_v<S, stage::Contact>)
        {
          Locate{ members }("coupling_N_per_m", plan.contact.coupling_N_per_m);
        }
        if constexpr (std::is_same_v<S, stage::Field>)
        {
          Locate{ members }("friction", plan.field.friction); // the contact's
        }
        expectNoHoles(members, plan, S::name);
      }
    });
}

} // namespace
} // namespace palpate
