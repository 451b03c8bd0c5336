// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>

#include <gtest/gtest.h>

#include "haptics/recording/bytes/RecordingLayout.h"
#include "haptics/recording/inputs/Tools.h"

namespace palpate
{
namespace
{

ToolContacts someContacts()
{
  ToolContacts set;
  set.held = set.placed = true;
  set.revision = 7;
  set.pose_W = { Vec3(1, 2, 3), Quat(0.6, 0.0, 0.8, 0.0) };
  set.characteristic_u = 0.5;
  set.restGap_u = 1e-7;
  set.ball_u = 0.25;
  set.reach_u = 0.75;
  set.count = 2;
  set.contacts[0] = { Vec3(0, 0, 1), Vec3(0.1, 0.2, 0.3), 1e-7 };
  set.contacts[1] = { Vec3(0, 1, 0), Vec3(-0.1, 0.2, 0.3), 2e-7 };
  return set;
}

/// Whether a written set is read back.
bool isRead(const ToolContacts& set)
{
  ByteWriter out;
  putTool(out, set);
  ByteReader in(out.bytes().data(), out.bytes().size());
  static_cast<void>(readTool(in));
  return in.ok() && in.left() == 0;
}

TEST(RecordedTools, ContactsComeBackToTheLastBit)
{
  ByteWriter out, again;
  putTool(out, someContacts());
  ByteReader in(out.bytes().data(), out.bytes().size());
  const ToolContacts read = readTool(in);
  ASSERT_TRUE(in.ok());
  putTool(again, read);
  EXPECT_EQ(again.bytes(), out.bytes());
  EXPECT_EQ(read.count, 2u);
  EXPECT_EQ(read.contacts[1].arm_W, Vec3(-0.1, 0.2, 0.3));
  EXPECT_EQ(read.ball_u, 0.25);
  EXPECT_EQ(read.reach_u, 0.75);
}

TEST(RecordedTools, ContactsThatCannotBeAreRefused)
{
  const auto isReadWith = [](const auto& change)
  {
    ToolContacts set = someContacts();
    change(set);
    return isRead(set);
  };
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(isReadWith([](ToolContacts&) {}));
  EXPECT_TRUE(isReadWith([](ToolContacts& set) { set.count = ToolContacts::capacity; }));
  EXPECT_FALSE(isReadWith([](ToolContacts& set) { set.contacts[1].n_W.x() = none; }));
  EXPECT_FALSE(isReadWith([](ToolContacts& set) { set.pose_W.q.w() = none; }));
  EXPECT_FALSE(isReadWith([](ToolContacts& set) { set.characteristic_u = 0.0; }));
  EXPECT_FALSE(isReadWith([](ToolContacts& set) { set.ball_u = none; }));
  EXPECT_FALSE(isReadWith([](ToolContacts& set) { set.ball_u = -1.0; }));
  EXPECT_FALSE(isReadWith([](ToolContacts& set) { set.reach_u = none; }));
  EXPECT_FALSE(isReadWith([](ToolContacts& set) { set.reach_u = -1.0; }));
}

TEST(RecordedTools, MoreContactsThanThereIsRoomForAreRefusedBeforeAnyIsRead)
{
  ToolContacts set = someContacts();
  set.count = 0;
  ByteWriter out;
  putTool(out, set);
  std::vector<char> bytes = out.bytes();
  const std::size_t atCount = bytes.size() - sizeof(std::uint64_t) - 2 * sizeof(double); // ball and reach
  bytes.resize(atCount + sizeof(std::uint64_t) + 56 * (ToolContacts::capacity + 1));
  bytes[atCount] = static_cast<char>(ToolContacts::capacity + 1);
  ByteReader in(bytes.data(), bytes.size());
  static_cast<void>(readTool(in));
  EXPECT_FALSE(in.ok());
}

} // namespace
} // namespace palpate
