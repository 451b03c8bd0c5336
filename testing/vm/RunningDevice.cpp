// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/vm/RunningDevice.h"

namespace palpate::test
{
namespace
{

constexpr auto millisecond = std::chrono::milliseconds(1);
constexpr auto mostBehind = std::chrono::milliseconds(20);

} // namespace

void RunningDevice::plug()
{
  this->still([this] { this->powerOn(); });
  this->stalls = false;
  this->attach();
  this->stop_ = false;
  this->thread_ = std::thread([this] { this->run(); });
}

void RunningDevice::unplug()
{
  if (!this->thread_.joinable())
  {
    return;
  }
  this->stop_ = true;
  this->thread_.join();
  this->detach();
}

void RunningDevice::run()
{
  Instant next = std::chrono::steady_clock::now() + millisecond;
  while (!this->stop_)
  {
    this->serve(next);
    const Instant now = std::chrono::steady_clock::now();
    if (now < next)
    {
      continue;
    }
    this->passMillisecond();
    ++this->time_ms_;
    next = now - next > mostBehind ? now : next + millisecond;
  }
}

} // namespace palpate::test
