// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/io/DeviceThreads.h"

#include <chrono>
#include <utility>

#include "haptics/realtime/RealtimeThread.h"

namespace palpate
{
namespace
{

constexpr auto look = std::chrono::milliseconds(1);
constexpr auto patience = std::chrono::milliseconds(500);

} // namespace

void DeviceThreads::run(Work work)
{
  const auto running = std::make_shared<Running>();
  running->work = std::move(work);
  running->stop = this->stop_;
  const auto body = [running]
  {
    const Work& work = running->work;
    if (work.priority > 0)
    {
      // The user's own limits have to do. A broker's grant limits the time of the whole process and is kept
      // for the servo: a writer that is late delays a report, never a tick.
      static_cast<void>(acquireScheduling(work.priority));
    }
    while (!*running->stop)
    {
      if (!work.pass())
      {
        std::this_thread::sleep_for(std::chrono::milliseconds(work.idle_ms));
      }
    }
    if (work.leave)
    {
      work.leave();
    }
    running->done = true;
  };
  this->threads_.push_back({ running, std::thread(body) });
}

bool DeviceThreads::end() noexcept
{
  *this->stop_ = true;
  bool all = true;
  for (Started& started : this->threads_)
  {
    const auto until = std::chrono::steady_clock::now() + patience;
    while (!started.running->done && std::chrono::steady_clock::now() < until)
    {
      std::this_thread::sleep_for(look);
    }
    all = all && started.running->done;
    started.running->done ? started.thread.join() : started.thread.detach();
  }
  this->threads_.clear();
  return all;
}

} // namespace palpate
