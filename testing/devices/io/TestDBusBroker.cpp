// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include <sched.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include "devices/io/broker/DBusBroker.h"
#include "testing/devices/io/FakeRealtimeService.h"

namespace palpate
{
namespace
{

using test::FakeRealtimeService;
using test::Manner;

struct Answer
{
  Granted granted;
  std::uint64_t thread = 0;
  int policy = 0; ///< of the thread that asked, afterwards
};

/// Asks from a thread of its own, which may become a real-time one.
Answer ask(const DBusService& service, int priority)
{
  Answer answer;
  std::jthread(
    [&]
    {
      DBusBroker broker(service);
      answer.granted = broker.request(priority);
      answer.thread = static_cast<std::uint64_t>(syscall(SYS_gettid));
      answer.policy = sched_getscheduler(0) & ~SCHED_RESET_ON_FORK;
    })
    .join();
  return answer;
}

std::uint64_t hardLimit_us()
{
  rlimit limit{};
  getrlimit(RLIMIT_RTTIME, &limit);
  return limit.rlim_max;
}

class DBusBrokers : public testing::Test
{
protected:
  void SetUp() override { ASSERT_NE(this->bus.address(), ""); }

  test::PrivateBus bus;
};

TEST_F(DBusBrokers, RealtimeKitIsAskedForThisThreadWithinItsOwnLimits)
{
  const DBusService kit = realtimeKit(this->bus.address());
  const FakeRealtimeService service(kit, Manner::Grants);
  const Answer answer = ask(kit, 99);
  EXPECT_TRUE(answer.granted.ok) << answer.granted.message;
  EXPECT_EQ(service.asked().thread, answer.thread);
  EXPECT_EQ(service.asked().process, 0U);
  EXPECT_EQ(service.asked().priority, static_cast<std::uint32_t>(FakeRealtimeService::mostPriority));
  EXPECT_LE(service.asked().hardLimit_us, static_cast<std::uint64_t>(FakeRealtimeService::longestRun_us));
  EXPECT_EQ(answer.policy == SCHED_RR, service.asked().granted);
}

TEST_F(DBusBrokers, AnAllowedPriorityIsNotRaised)
{
  const DBusService kit = realtimeKit(this->bus.address());
  const FakeRealtimeService service(kit, Manner::Lies);
  EXPECT_TRUE(ask(kit, 7).granted.ok);
  EXPECT_EQ(service.asked().priority, 7U);
}

TEST_F(DBusBrokers, ThePortalIsToldTheProcessToo)
{
  const DBusService portal = realtimePortal(this->bus.address());
  const FakeRealtimeService service(portal, Manner::Grants);
  const Answer answer = ask(portal, 10);
  EXPECT_TRUE(answer.granted.ok) << answer.granted.message;
  EXPECT_EQ(service.asked().process, static_cast<std::uint64_t>(getpid()));
  EXPECT_EQ(service.asked().thread, answer.thread);
}

TEST_F(DBusBrokers, ARunawayIsDemotedBeforeTheProgramWouldBeEnded)
{
  const DBusService kit = realtimeKit(this->bus.address());
  const FakeRealtimeService service(kit, Manner::Lies);
  EXPECT_TRUE(ask(kit, 10).granted.ok);
  rlimit limit{};
  ASSERT_EQ(getrlimit(RLIMIT_RTTIME, &limit), 0);
  EXPECT_LE(limit.rlim_max, static_cast<rlim_t>(FakeRealtimeService::longestRun_us));
  EXPECT_LE(limit.rlim_cur, limit.rlim_max / 2);
}

struct Failure
{
  std::string name;
  std::optional<Manner> manner; ///< none: there is no service
  int patience_ms = 1000;
  bool lowersLimit = false; ///< it came so far that the service was asked for the thread
  std::string message;
};

void PrintTo(const Failure& failure, std::ostream* os)
{
  *os << failure.name;
}

class FailingDBusBrokers
  : public DBusBrokers
  , public testing::WithParamInterface<Failure>
{
};

TEST_P(FailingDBusBrokers, SayWhyInOneLineAndLowerNoLimitForNothing)
{
  const Failure& failure = this->GetParam();
  DBusService kit = realtimeKit(this->bus.address());
  kit.patience_ms = failure.patience_ms;
  const auto service = failure.manner ? std::make_unique<FakeRealtimeService>(kit, *failure.manner)
                                      : std::unique_ptr<FakeRealtimeService>();
  const std::uint64_t before_us = hardLimit_us();
  const Granted granted = ask(kit, 10).granted;
  EXPECT_FALSE(granted.ok);
  EXPECT_EQ(granted.message, failure.message);
  EXPECT_TRUE(failure.lowersLimit || hardLimit_us() == before_us);
}

INSTANTIATE_TEST_SUITE_P(Reasons, FailingDBusBrokers,
  testing::Values(Failure{ "Refusal", Manner::Refuses, 1000, true, "it refused: nobody is sitting at this computer" },
    Failure{ "NotThere", std::nullopt, 1000, false, "it is not there" },
    Failure{ "Silent", Manner::IsSilent, 50, false, "it did not answer within 50 ms" },
    Failure{ "TextsForNumbers", Manner::Babbles, 1000, false, "it gave no number as MaxRealtimePriority" }),
  [](const testing::TestParamInfo<Failure>& info) { return info.param.name; });

TEST(DBusBroker, WithoutABusThereIsOneLineThatSaysSo)
{
  EXPECT_EQ(ask(realtimePortal(""), 10).granted.message, "there is no bus to ask it on");
  const Granted nowhere = ask(realtimeKit("unix:path=/nowhere/at/all"), 10).granted;
  EXPECT_FALSE(nowhere.ok);
  EXPECT_NE(nowhere.message.find("cannot be reached"), std::string::npos) << nowhere.message;
  EXPECT_EQ(nowhere.message.find('\n'), std::string::npos);
}

TEST_F(DBusBrokers, TheThreadsReportNamesWhoGrantedItOrEveryReason)
{
  const DBusService kit = realtimeKit(this->bus.address()), portal = realtimePortal(this->bus.address());
  const FakeRealtimeService refusing(kit, Manner::Refuses), lying(portal, Manner::Lies);
  const RealtimeBrokers brokers{ std::make_shared<DBusBroker>(kit), std::make_shared<DBusBroker>(portal) };
  SchedulingReport report;
  // The limits grant a priority of 0 to no user, so the brokers are always asked.
  std::jthread([&] { report = acquireScheduling(0, brokers); }).join();
  EXPECT_FALSE(report.realtime);
  EXPECT_NE(report.message.find("RTKit: it refused: nobody is sitting at this computer"), std::string::npos)
    << report.message;
  EXPECT_NE(report.message.find("desktop portal: it agreed, but nothing changed"), std::string::npos) << report.message;
  EXPECT_EQ(report.message.find('\n'), std::string::npos);
}

} // namespace
} // namespace palpate
