// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/realtime/RealtimeThread.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <utility>

#include <pthread.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace palpate
{
namespace
{

constexpr std::size_t stackTouched = 64 * 1024;
constexpr rlim_t longestRun_us = 200'000;
constexpr int wantedNice = -11;
constexpr int defaultPriority = 20;

std::string reason(int error)
{
  return std::strerror(error);
}

/// Runs in the thread that exceeded RLIMIT_RTTIME: it goes on with ordinary scheduling. SCHED_RESET_ON_FORK stays
/// set, since an ordinary user may not clear it.
extern "C" void demoteCaller(int)
{
  const int error = errno;
  const sched_param none{};
  sched_setscheduler(0, SCHED_OTHER | SCHED_RESET_ON_FORK, &none);
  errno = error;
}

bool installDemotion()
{
  struct sigaction current
  {
  };
  sigaction(SIGXCPU, nullptr, &current);
  if (current.sa_handler != SIG_DFL)
  {
    return current.sa_handler == demoteCaller;
  }
  struct sigaction demote
  {
  };
  demote.sa_handler = demoteCaller;
  demote.sa_flags = SA_RESTART;
  sigemptyset(&demote.sa_mask);
  return sigaction(SIGXCPU, &demote, nullptr) == 0;
}

void touchStack() noexcept
{
  [[maybe_unused]] volatile char stack[stackTouched];
  for (std::size_t i = 0; i < stackTouched; i += 1024)
  {
    stack[i] = 0;
  }
}

/// The kernel's struct sched_attr up to the fields used here; glibc of 2022 declares none.
struct SchedulingAttributes
{
  std::uint32_t size = sizeof(SchedulingAttributes);
  std::uint32_t policy = SCHED_OTHER;
  std::uint64_t flags = 0;
  std::int32_t nice = 0;
  std::uint32_t priority = 0;
  std::uint64_t runtime_ns = 0;
  std::uint64_t deadline_ns = 0;
  std::uint64_t period_ns = 0;
};

/// Real-time priority of the calling thread; 0: none.
int realtimePriority()
{
  sched_param parameters{};
  int policy = 0;
  pthread_getschedparam(pthread_self(), &policy, &parameters);
  policy &= ~SCHED_RESET_ON_FORK;
  return policy == SCHED_FIFO || policy == SCHED_RR ? parameters.sched_priority : 0;
}

/// One broker's answer; a grant is believed only if the thread has the priority.
Granted ask(RealtimeBroker& broker, int wantedPriority)
{
  const Granted answer = broker.request(wantedPriority);
  const int priority = realtimePriority();
  if (answer.ok && priority > 0)
  {
    return { true, "real-time priority " + std::to_string(priority) + " through " + broker.name() };
  }
  return { false, broker.name() + ": " + (answer.ok ? "it agreed, but nothing changed" : answer.message) };
}

/// The limits of the user first, then the brokers, until one grants it; else every reason.
Granted requestRealtime(int wantedPriority, std::span<const std::shared_ptr<RealtimeBroker>> brokers)
{
  Granted granted = demoteRunaways();
  if (!granted.ok)
  {
    return granted;
  }
  granted = requestFifo(wantedPriority);
  for (auto broker = brokers.begin(); broker != brokers.end() && !granted.ok; ++broker)
  {
    Granted answer = ask(**broker, wantedPriority);
    granted = { answer.ok, answer.ok ? answer.message : granted.message + "; " + answer.message };
  }
  return granted;
}

} // namespace

Granted requestFifo(int wantedPriority)
{
  rlimit limit{};
  getrlimit(RLIMIT_RTPRIO, &limit);
  const int allowed = geteuid() == 0 ? 99 : static_cast<int>(std::min<rlim_t>(limit.rlim_cur, 99));
  const int priority = std::min(wantedPriority, allowed);
  if (priority < 1)
  {
    return { false, "real-time priority is not allowed (RLIMIT_RTPRIO is 0): add \"@users - rtprio 20\" to "
                    "/etc/security/limits.conf and log in again" };
  }
  sched_param parameters{};
  parameters.sched_priority = priority;
  const int error = pthread_setschedparam(pthread_self(), SCHED_FIFO | SCHED_RESET_ON_FORK, &parameters);
  if (error != 0)
  {
    return { false, "real-time priority " + std::to_string(priority) + " was refused: " + reason(error) };
  }
  return { true, "SCHED_FIFO priority " + std::to_string(priority) };
}

Granted requestNice()
{
  if (setpriority(PRIO_PROCESS, 0, wantedNice) == 0) // 0: this thread
  {
    return { true, "nice " + std::to_string(wantedNice) };
  }
  return { false, "nice " + std::to_string(wantedNice) + " is not allowed" };
}

Granted requestTimerSlack()
{
  if (prctl(PR_SET_TIMERSLACK, 1UL, 0UL, 0UL, 0UL) != 0)
  {
    return { false, "timer slack of 1 ns was refused: " + reason(errno) };
  }
  return { true, "timer slack 1 ns" };
}

Granted requestShortSlice()
{
  SchedulingAttributes attributes;
  attributes.runtime_ns = 100'000;
  attributes.nice = getpriority(PRIO_PROCESS, 0); // an ordinary user may not lower it
  if (syscall(SYS_sched_setattr, 0, &attributes, 0U) != 0)
  {
    return { false, "a slice of 0.1 ms was refused: " + reason(errno) };
  }
  return { true, "slice 0.1 ms" };
}

Granted demoteRunaways()
{
  if (!installDemotion())
  {
    return { false,
      "real-time priority is not asked for: this program handles SIGXCPU itself, so a runaway servo could "
      "not be stopped" };
  }
  rlimit limit{};
  getrlimit(RLIMIT_RTTIME, &limit);
  // well below the hard limit, at which the kernel ends the whole program
  limit.rlim_cur = std::min({ limit.rlim_cur, longestRun_us, limit.rlim_max / 2 });
  if (setrlimit(RLIMIT_RTTIME, &limit) != 0)
  {
    return { false, "a limit of 0.2 s for real-time threads (RLIMIT_RTTIME) was refused: " + reason(errno) };
  }
  return { true, "ordinary after 0.2 s without sleep" };
}

Granted limitRealtimeRuns(std::int64_t longest_us)
{
  if (longest_us < 2)
  {
    return { false, "a limit of " + std::to_string(longest_us) + " us for real-time threads cannot be set" };
  }
  rlimit limit{};
  getrlimit(RLIMIT_RTTIME, &limit);
  limit.rlim_max = std::min(limit.rlim_max, static_cast<rlim_t>(longest_us));
  limit.rlim_cur = std::min(limit.rlim_cur, limit.rlim_max / 2);
  if (setrlimit(RLIMIT_RTTIME, &limit) != 0)
  {
    return { false,
      "a limit of " + std::to_string(longest_us) + " us for real-time threads was refused: " + reason(errno) };
  }
  return { true, "no real-time run above " + std::to_string(longest_us) + " us" };
}

SchedulingReport acquireScheduling(int wantedPriority, std::span<const std::shared_ptr<RealtimeBroker>> brokers)
{
  touchStack();
  const Granted realtime = requestRealtime(wantedPriority, brokers);
  if (realtime.ok)
  {
    return { true, realtimePriority(), "servo thread: " + realtime.message };
  }
  SchedulingReport report{ false, 0, "servo thread: ordinary scheduling" };
  for (const Granted& step : { requestNice(), requestTimerSlack(), requestShortSlice() })
  {
    report.message += ", " + step.message;
  }
  report.message += "; " + realtime.message;
  return report;
}

RealtimeThread::RealtimeThread(std::function<void(const SchedulingReport&)> onScheduled,
  std::function<void(std::stop_token)> body, RealtimeBrokers brokers)
  : thread_(
      [onScheduled = std::move(onScheduled), body = std::move(body), brokers = std::move(brokers)](std::stop_token stop)
      {
        onScheduled(acquireScheduling(defaultPriority, brokers));
        body(std::move(stop));
      })
{
}

void RealtimeThread::join()
{
  if (this->thread_.joinable())
  {
    this->thread_.request_stop();
    this->thread_.join();
  }
}

} // namespace palpate
