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

std::string reason(int error)
{
  return std::strerror(error);
}

/// Runs in whichever thread exceeded RLIMIT_RTTIME: it goes on with ordinary scheduling.
extern "C" void demoteCaller(int)
{
  const sched_param none{};
  sched_setscheduler(0, SCHED_OTHER, &none);
}

void installDemotion()
{
  struct sigaction current{};
  if (sigaction(SIGXCPU, nullptr, &current) == 0 && current.sa_handler == SIG_DFL)
  {
    struct sigaction demote{};
    demote.sa_handler = demoteCaller;
    sigemptyset(&demote.sa_mask);
    sigaction(SIGXCPU, &demote, nullptr);
  }
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
  installDemotion();
  return { true, "SCHED_FIFO priority " + std::to_string(priority) };
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
  if (syscall(SYS_sched_setattr, 0, &attributes, 0U) != 0)
  {
    return { false, "a slice of 0.1 ms was refused: " + reason(errno) };
  }
  return { true, "slice 0.1 ms" };
}

SchedulingReport acquireScheduling(int wantedPriority)
{
  touchStack();
  const Granted fifo = requestFifo(wantedPriority);
  if (fifo.ok)
  {
    sched_param parameters{};
    int policy = 0;
    pthread_getschedparam(pthread_self(), &policy, &parameters);
    return { true, parameters.sched_priority, "servo thread: " + fifo.message };
  }
  SchedulingReport report{ false, 0, "servo thread: ordinary scheduling" };
  for (const Granted& step : { requestTimerSlack(), requestShortSlice() })
  {
    report.message += ", " + step.message;
  }
  report.message += "; " + fifo.message;
  return report;
}

RealtimeThread::RealtimeThread(
  std::function<void(const SchedulingReport&)> onScheduled, std::function<void(std::stop_token)> body)
  : thread_(
      [onScheduled = std::move(onScheduled), body = std::move(body)](std::stop_token stop)
      {
        onScheduled(acquireScheduling());
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
