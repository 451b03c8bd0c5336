// SPDX-License-Identifier: GPL-3.0-or-later
#include <csignal>
#include <thread>

#include <gtest/gtest.h>
#include <sched.h>
#include <sys/resource.h>

#include "haptics/realtime/LoopStatistics.h"
#include "haptics/realtime/PeriodicTimer.h"
#include "haptics/realtime/RealtimeThread.h"

namespace palpate
{
namespace
{

constexpr std::int64_t timerPeriod_ns = 1'000'000;

TEST(VirtualTimer, WakesOncePerPeriodWithoutLateness)
{
  VirtualTimer timer(timerPeriod_ns);
  for (std::int64_t n = 1; n <= 10; ++n)
  {
    const Wakeup wakeup = timer.wait();
    EXPECT_EQ(wakeup.due_ns, n * timerPeriod_ns);
    EXPECT_EQ(wakeup.lateness_ns, 0);
    EXPECT_EQ(wakeup.missed, 0U);
  }
}

TEST(VirtualTimer, SkipsThePeriodsALateWakeUpMissedAndFindsThePhaseAgain)
{
  VirtualTimer timer(timerPeriod_ns);
  static_cast<void>(timer.wait());
  timer.delayNext(3 * timerPeriod_ns + 250'000); // due at 2 ms, runs at 5.25 ms
  const Wakeup late = timer.wait();
  EXPECT_EQ(late.missed, 3U);
  EXPECT_EQ(late.due_ns, 5 * timerPeriod_ns);
  EXPECT_EQ(late.lateness_ns, 250'000);
  const Wakeup next = timer.wait();
  EXPECT_EQ(next.due_ns, 6 * timerPeriod_ns);
  EXPECT_EQ(next.missed, 0U);
}

TEST(PeriodicTimer, WakeUpsPlusMissedPeriodsAreThePeriodsElapsed)
{
  PeriodicTimer timer(timerPeriod_ns);
  const Wakeup first = timer.wait();
  std::int64_t periods = 0, last = first.due_ns;
  for (int i = 0; i < 100; ++i)
  {
    if (i == 50)
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(7)); // at least six periods pass unseen
    }
    const Wakeup wakeup = timer.wait();
    periods += 1 + static_cast<std::int64_t>(wakeup.missed);
    EXPECT_GE(wakeup.lateness_ns, 0);
    EXPECT_LT(wakeup.lateness_ns, timerPeriod_ns);
    last = wakeup.due_ns;
  }
  EXPECT_EQ(last - first.due_ns, periods * timerPeriod_ns);
  EXPECT_GE(periods, 106);
}

TEST(RealtimeThread, ReportsWhatSchedulingItGotAndRunsItsBody)
{
  SchedulingReport report;
  bool ran = false;
  RealtimeThread thread(
    [&report](const SchedulingReport& r) { report = r; }, [&ran](const std::stop_token&) { ran = true; });
  thread.join();
  EXPECT_TRUE(ran);
  EXPECT_FALSE(report.message.empty());
  EXPECT_EQ(report.realtime, report.priority > 0);
}

TEST(RealtimeThread, ARefusedRequestSaysWhyInsteadOfFailing)
{
  std::jthread(
    []
    {
      const Granted granted = requestFifo(0); // no real-time priority is below 1
      EXPECT_FALSE(granted.ok);
      EXPECT_NE(granted.message.find("real-time priority"), std::string::npos);
    })
    .join();
}

TEST(RealtimeThread, ARunawayBecomesAnOrdinaryThreadInsteadOfEndingTheProgram)
{
  std::jthread(
    []
    {
      ASSERT_TRUE(demoteRunaways().ok);
      rlimit limit{};
      ASSERT_EQ(getrlimit(RLIMIT_RTTIME, &limit), 0);
      EXPECT_LE(limit.rlim_cur, 200'000U); // [us]
      static_cast<void>(requestFifo(10));  // granted or not: the signal must be survived
      ASSERT_EQ(raise(SIGXCPU), 0);
      EXPECT_EQ(sched_getscheduler(0) & ~SCHED_RESET_ON_FORK, SCHED_OTHER);
    })
    .join();
}

TEST(RealtimeThread, IsOrdinaryAndSaysWhyWhereTheProgramHandlesTheRunawaySignalItself)
{
  const auto before = std::signal(SIGXCPU, SIG_IGN);
  SchedulingReport report;
  RealtimeThread([&report](const SchedulingReport& r) { report = r; }, [](const std::stop_token&) {}).join();
  std::signal(SIGXCPU, before);
  EXPECT_FALSE(report.realtime);
  EXPECT_NE(report.message.find("SIGXCPU"), std::string::npos) << report.message;
}

TEST(RealtimeThread, NicenessIsRaisedWhereItIsAllowedAndTheAnswerSaysWhich)
{
  std::jthread(
    []
    {
      const Granted granted = requestNice();
      EXPECT_EQ(granted.ok, getpriority(PRIO_PROCESS, 0) == -11) << granted.message;
      EXPECT_NE(granted.message.find("nice -11"), std::string::npos);
    })
    .join();
}

TEST(RealtimeThread, BrokersAreAskedInTurnOnceTheLimitsRefuse)
{
  class Refusing final : public RealtimeBroker
  {
  public:
    explicit Refusing(std::vector<std::string>& asked, std::string name) : asked_(asked), name_(std::move(name)) {}
    [[nodiscard]] std::string name() const override { return this->name_; }
    [[nodiscard]] Granted request(int) override
    {
      this->asked_.push_back(this->name_);
      return { false, "not today" };
    }

  private:
    std::vector<std::string>& asked_;
    std::string name_;
  };
  std::vector<std::string> asked;
  const RealtimeBrokers brokers{ std::make_shared<Refusing>(asked, "A"), std::make_shared<Refusing>(asked, "B") };
  SchedulingReport report;
  std::jthread([&] { report = acquireScheduling(0, brokers); }).join(); // no limit allows a priority of 0
  EXPECT_EQ(asked, (std::vector<std::string>{ "A", "B" }));
  EXPECT_FALSE(report.realtime);
  EXPECT_NE(report.message.find("A: not today; B: not today"), std::string::npos) << report.message;
}

TEST(RealtimeThread, AShortSliceKeepsTheNicenessThatWasGiven)
{
  std::jthread(
    []
    {
      ASSERT_EQ(setpriority(PRIO_PROCESS, 0, 5), 0); // of this thread only
      static_cast<void>(requestShortSlice());
      EXPECT_EQ(getpriority(PRIO_PROCESS, 0), 5);
    })
    .join();
}

TEST(DurationHistogram, QuantilesAreTheUpperEndsOfTheirBins)
{
  DurationHistogram histogram;
  for (int i = 0; i < 1000; ++i)
  {
    histogram.add(i < 985 ? 3.5 : 250.5); // 98.5 % in bin [3, 4), 1.5 % in bin [250, 251)
  }
  const Quantiles q = histogram.quantiles();
  EXPECT_EQ(q.count, 1000U);
  EXPECT_EQ(q.p50_us, 4.0);
  EXPECT_EQ(q.p99_us, 250.5); // its bin ends at 251, the largest value was less
  EXPECT_EQ(q.max_us, 250.5);
}

// Two in a thousand take 700 us: one in a thousand takes at least that, one in a hundred does not.
TEST(DurationHistogram, OneInAThousandIsSeenBesideOneInAHundred)
{
  DurationHistogram histogram;
  for (int i = 0; i < 10'000; ++i)
  {
    histogram.add(i % 500 == 0 ? 700.5 : 3.5);
  }
  EXPECT_EQ(histogram.quantiles().p99_us, 4.0);
  EXPECT_EQ(histogram.quantiles().p999_us, 700.5);
}

TEST(DurationHistogram, TakesValuesOfAnySizeWithoutLosingTheLargest)
{
  DurationHistogram histogram;
  for (const double value : { -1.0, 0.0, 999.9, 1000.0, 99'999.0, 5e6 })
  {
    histogram.add(value);
  }
  EXPECT_EQ(histogram.quantiles().count, 6U);
  EXPECT_EQ(histogram.quantiles().max_us, 5e6);
}

// 2500 values in the first turn, 2 in the second: the one of 30 ms is 1 of 2502, far above the 99th percentile.
TEST(SlidingHistogram, OneLateValueAfterATurnDoesNotDecideTheP99)
{
  SlidingHistogram histogram;
  for (int i = 0; i < 2500; ++i)
  {
    histogram.add(0.001 * i, 10.5);
  }
  histogram.add(2.5, 30'000.0);
  histogram.add(2.501, 10.5);
  EXPECT_EQ(histogram.quantiles().count, 2502U);
  EXPECT_EQ(histogram.quantiles().p99_us, 11.0);
  EXPECT_EQ(histogram.quantiles().max_us, 30'000.0);
}

TEST(SlidingHistogram, ForgetsWhatIsOlderThanFiveSeconds)
{
  SlidingHistogram histogram;
  histogram.add(0.0, 800.0);
  for (double t = 0.001; t < 6.0; t += 0.001)
  {
    histogram.add(t, 10.5);
  }
  EXPECT_EQ(histogram.quantiles().max_us, 10.5);
}

} // namespace
} // namespace palpate
