// SPDX-License-Identifier: GPL-3.0-or-later
#include <atomic>
#include <cstdint>
#include <memory>
#include <thread>

#include <gtest/gtest.h>

#include "haptics/realtime/SnapshotMailbox.h"
#include "testing/support/AllocationGuard.h"

namespace palpate
{
namespace
{

/// Counts the living, and is marked when it dies so that a reader would see a dead one.
struct Snapshot
{
  explicit Snapshot(std::uint64_t n) : number(n) { ++alive; }
  ~Snapshot()
  {
    this->number = ~std::uint64_t{ 0 };
    --alive;
  }
  std::uint64_t number;
  inline static std::atomic<int> alive = 0;
};

TEST(SnapshotMailbox, HandsOverTheNewestAndKeepsTheReplacedOneForOneTick)
{
  SnapshotMailbox<Snapshot> mailbox;
  EXPECT_EQ(mailbox.acquire(), nullptr);
  mailbox.publish(std::make_shared<const Snapshot>(1));
  ASSERT_NE(mailbox.acquire(), nullptr);
  EXPECT_EQ(mailbox.replaced(), nullptr);
  mailbox.publish(std::make_shared<const Snapshot>(2));
  EXPECT_EQ(mailbox.acquire()->number, 2U);
  ASSERT_NE(mailbox.replaced(), nullptr);
  EXPECT_EQ(mailbox.replaced()->number, 1U);
  mailbox.collect();
  EXPECT_EQ(mailbox.replaced()->number, 1U) << "freed while the reader could see it";
  EXPECT_EQ(mailbox.acquire()->number, 2U);
  EXPECT_EQ(mailbox.replaced(), nullptr);
}

TEST(SnapshotMailbox, FreesWhatTheReaderPutDownAndEverythingAtItsEnd)
{
  {
    SnapshotMailbox<Snapshot> mailbox;
    for (std::uint64_t n = 0; n < 100; ++n)
    {
      mailbox.publish(std::make_shared<const Snapshot>(n));
      EXPECT_EQ(mailbox.acquire()->number, n);
      EXPECT_LE(Snapshot::alive.load(), 4);
    }
  }
  EXPECT_EQ(Snapshot::alive.load(), 0);
}

TEST(SnapshotMailbox, AcquiringNeitherAllocatesNorFreesNorLocks)
{
  SnapshotMailbox<Snapshot> mailbox;
  for (std::uint64_t n = 0; n < 10; ++n)
  {
    mailbox.publish(std::make_shared<const Snapshot>(n));
    const test::AllocationGuard guard;
    static_cast<void>(mailbox.acquire());
    static_cast<void>(mailbox.acquire());
    EXPECT_EQ(guard.allocations() + guard.frees() + guard.locks(), 0U);
  }
}

TEST(SnapshotMailbox, AReaderNeverSeesADeadOrAnOlderSnapshotIn300000Publishes)
{
  constexpr std::uint64_t publishes = 300'000;
  SnapshotMailbox<Snapshot> mailbox;
  std::atomic<bool> done = false;
  std::uint64_t backward = 0, dead = 0;
  std::jthread reader(
    [&]
    {
      std::uint64_t last = 0;
      while (!done.load(std::memory_order_relaxed))
      {
        if (const Snapshot* const now = mailbox.acquire())
        {
          dead += now->number > publishes;
          backward += now->number < last;
          last = now->number;
          if (const Snapshot* const before = mailbox.replaced())
          {
            dead += before->number > publishes;
          }
        }
      }
    });
  for (std::uint64_t n = 1; n <= publishes; ++n)
  {
    mailbox.publish(std::make_shared<const Snapshot>(n));
  }
  done = true;
  reader.join();
  EXPECT_EQ(dead, 0U);
  EXPECT_EQ(backward, 0U);
}

// A reader that pauses at odd moments lets replaced snapshots pile up between two emptyings.
TEST(SnapshotMailbox, NothingIsLostHoweverTheReaderPauses)
{
  constexpr std::uint64_t publishes = 300'000;
  {
    SnapshotMailbox<Snapshot> mailbox;
    std::atomic<bool> done = false;
    std::jthread reader(
      [&]
      {
        for (std::uint32_t step = 1; !done.load(std::memory_order_relaxed); step = step * 1664525U + 1013904223U)
        {
          static_cast<void>(mailbox.acquire());
          for (std::uint32_t pause = step >> 24; pause > 0 && !done.load(std::memory_order_relaxed); --pause)
          {
          }
        }
      });
    for (std::uint64_t n = 1; n <= publishes; ++n)
    {
      mailbox.publish(std::make_shared<const Snapshot>(n));
    }
    done = true;
  }
  EXPECT_EQ(Snapshot::alive.load(), 0);
}

} // namespace
} // namespace palpate
