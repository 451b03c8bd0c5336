// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/vm/PluggedDevice.h"

#include <utility>

namespace palpate::test
{
namespace
{

constexpr auto millisecond = std::chrono::milliseconds(1);
constexpr auto mostBehind = std::chrono::milliseconds(20);

} // namespace

PluggedDevice::PluggedDevice(VirtualHid& firmware, PlugIdentity identity)
  : firmware_(firmware), identity_(std::move(identity))
{
}

void PluggedDevice::plug()
{
  this->still([this] { this->powerOn(); });
  this->stalls = false;
  this->attach();
  this->stop_ = false;
  this->thread_ = std::thread([this] { this->run(); });
}

void PluggedDevice::unplug()
{
  if (!this->thread_.joinable())
  {
    return;
  }
  this->stop_ = true;
  this->thread_.join();
  this->detach();
}

void PluggedDevice::run()
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
    next = now - next > mostBehind ? now : next + millisecond;
  }
}

void PluggedDevice::passMillisecond()
{
  std::vector<std::vector<std::uint8_t>> inputs;
  {
    const std::lock_guard lock(this->mutex_);
    this->firmware_.advance(1);
    for (auto input = this->firmware_.nextInput(); !input.empty(); input = this->firmware_.nextInput())
    {
      inputs.push_back(std::move(input));
    }
  }
  ++this->time_ms_;
  for (const std::vector<std::uint8_t>& input : inputs)
  {
    this->send(input);
  }
  this->frame();
}

bool PluggedDevice::take(HidReportKind kind, std::span<const std::uint8_t> report)
{
  const std::lock_guard lock(this->mutex_);
  return this->firmware_.take(kind, report);
}

std::vector<std::uint8_t> PluggedDevice::feature(std::uint8_t id)
{
  const std::lock_guard lock(this->mutex_);
  return this->firmware_.feature(id);
}

} // namespace palpate::test
