// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/devices/hid/FakeHidBus.h"

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

namespace palpate::test
{
namespace
{

constexpr int stall_ms = 5000;

} // namespace

/// One open handle of a port. Locks the bus for each call, but not while it waits.
class FakeConnection final : public HidConnection
{
public:
  FakeConnection(FakeHidBus& bus, FakePort& port) : bus_(bus), port_(port) {}

  ~FakeConnection() override
  {
    this->bus_.alone([this] { return ++this->port_.closed; });
  }

  int read(std::span<std::uint8_t> report, int timeout_ms) noexcept override
  {
    if (const auto meanwhile = this->bus_.alone([&] { return this->begin(timeout_ms); }))
    {
      meanwhile();
      return -1;
    }
    for (int waited_ms = 0;; ++waited_ms)
    {
      const int length = this->bus_.alone([&] { return this->take(report); });
      if (length != 0 || waited_ms >= timeout_ms)
      {
        return length;
      }
      this->wait(1);
    }
  }

  bool write(std::span<const std::uint8_t> report) noexcept override
  {
    std::unique_lock lock(this->bus_.mutex_);
    if (!this->bus_.answers(this->port_))
    {
      return this->fail("No such device");
    }
    if (this->port_.writesThatFail > 0)
    {
      --this->port_.writesThatFail;
      return this->fail("Input/output error");
    }
    if (this->port_.stalls && !this->waitForRelease(lock))
    {
      return this->fail("Connection timed out");
    }
    this->bus_.pass(1);
    this->port_.firmware().take(HidReportKind::Output, report);
    return true;
  }

  bool setFeature(std::span<const std::uint8_t> report) noexcept override
  {
    const std::lock_guard lock(this->bus_.mutex_);
    if (!this->bus_.answers(this->port_))
    {
      return this->fail("No such device");
    }
    return this->port_.firmware().take(HidReportKind::Feature, report) || this->fail("Broken pipe");
  }

  int getFeature(std::span<std::uint8_t> report) noexcept override
  {
    const std::lock_guard lock(this->bus_.mutex_);
    if (!this->bus_.answers(this->port_) || this->port_.featureTimesOut)
    {
      static_cast<void>(this->fail(this->port_.present ? "Connection timed out" : "No such device"));
      return -1;
    }
    std::vector<std::uint8_t> feature = this->port_.firmware().feature(report[0]);
    if (this->port_.shortFeature >= 0)
    {
      feature.resize(static_cast<std::size_t>(this->port_.shortFeature));
    }
    std::copy_n(feature.begin(), std::min(feature.size(), report.size()), report.begin());
    return static_cast<int>(feature.size());
  }

  std::string error() const override
  {
    const std::lock_guard lock(this->bus_.mutex_);
    return this->error_;
  }

  void wait(int duration_ms) noexcept override
  {
    if (this->bus_.virtualTime_)
    {
      this->bus_.advance(duration_ms);
      return;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(duration_ms));
  }

private:
  bool fail(const char* why)
  {
    this->error_ = why;
    return false;
  }

  std::function<void()> begin(int timeout_ms)
  {
    this->port_.longestRead_ms = std::max(this->port_.longestRead_ms, timeout_ms);
    return std::exchange(this->port_.whileReading, nullptr);
  }

  int take(std::span<std::uint8_t> report)
  {
    if (this->port_.readFails)
    {
      return -1;
    }
    const std::vector<std::uint8_t> input = this->port_.firmware().nextInput();
    if (input.empty() && !this->port_.present)
    {
      return -1; // reports that were queued before still come
    }
    std::copy_n(input.begin(), std::min(input.size(), report.size()), report.begin());
    return static_cast<int>(std::min(input.size(), report.size()));
  }

  bool waitForRelease(std::unique_lock<std::mutex>& lock)
  {
    if (this->bus_.virtualTime_)
    {
      this->bus_.pass(stall_ms);
      return false;
    }
    ++this->port_.hanging;
    const bool released = this->bus_.released_.wait_for(
      lock, std::chrono::milliseconds(stall_ms), [this] { return !this->port_.stalls || !this->port_.present; });
    --this->port_.hanging;
    return released && this->port_.present;
  }

  FakeHidBus& bus_;
  FakePort& port_;
  std::string error_;
};

std::int64_t FakeHidBus::Time::now_ns() const noexcept
{
  const std::lock_guard lock(this->bus_.mutex_);
  return this->bus_.now_ms_ * 1000000;
}

FakePort& FakeHidBus::place(HidEntry entry)
{
  entry.path = "fake" + std::to_string(this->ports_.size());
  this->ports_.push_back(std::make_unique<FakePort>());
  this->ports_.back()->entry = std::move(entry);
  return *this->ports_.back();
}

FakePort& FakeHidBus::plug(const PidLayout& layout, const std::string& serial)
{
  const std::lock_guard lock(this->mutex_);
  FakePort& port = this->place({ "", 0x1209, 0xFFB0, serial, layout.name + " stick" });
  port.device = std::make_shared<VirtualPidDevice>(layout);
  port.descriptor = descriptorOf(layout);
  return port;
}

FakePort& FakeHidBus::plug(const CapLayout& layout, const std::string& serial)
{
  const std::lock_guard lock(this->mutex_);
  FakePort& port = this->place({ "", 0x256F, 0xC62E, serial, layout.name });
  port.spaceMouse = std::make_shared<VirtualSpaceMouse>(layout);
  port.descriptor = descriptorOf(layout);
  return port;
}

FakePort& FakeHidBus::plug(std::shared_ptr<FirmwareModel> model, std::vector<std::uint8_t> descriptor)
{
  const std::lock_guard lock(this->mutex_);
  FakePort& port = this->place({ "", 0x1209, 0xFFB0, "0001", "model" });
  port.model = std::move(model);
  port.descriptor = std::move(descriptor);
  return port;
}

FakePort& FakeHidBus::plug(std::shared_ptr<VirtualHid> other, HidEntry entry)
{
  const std::lock_guard lock(this->mutex_);
  FakePort& port = this->place(std::move(entry));
  port.other = std::move(other);
  return port;
}

std::vector<HidEntry> FakeHidBus::devices()
{
  const std::lock_guard lock(this->mutex_);
  std::vector<HidEntry> there;
  for (const auto& port : this->ports_)
  {
    if (port->present)
    {
      there.push_back(port->entry);
    }
  }
  return there;
}

HidBus::Descriptor FakeHidBus::descriptor(const HidEntry& entry)
{
  const std::lock_guard lock(this->mutex_);
  for (const auto& port : this->ports_)
  {
    if (port->entry.path == entry.path && this->answers(*port))
    {
      return { port->descriptorProblem.empty() ? port->descriptor : std::vector<std::uint8_t>(),
        port->descriptorProblem };
    }
  }
  return { {}, "No such device" };
}

HidBus::Opened FakeHidBus::open(const HidEntry& entry)
{
  const std::lock_guard lock(this->mutex_);
  for (const auto& port : this->ports_)
  {
    if (port->entry.path != entry.path || !this->answers(*port))
    {
      continue;
    }
    if (!port->openProblem.empty())
    {
      return { nullptr, port->openProblem };
    }
    ++port->opened;
    return { std::make_unique<FakeConnection>(*this, *port), {} };
  }
  return { nullptr, "No such device" };
}

void FakeHidBus::advance(int duration_ms)
{
  const std::lock_guard lock(this->mutex_);
  this->now_ms_ += duration_ms;
  for (const auto& port : this->ports_)
  {
    port->firmware().advance(duration_ms);
  }
}

void FakeHidBus::release(FakePort& port)
{
  const std::lock_guard lock(this->mutex_);
  port.stalls = false;
  this->released_.notify_all();
}

bool FakeHidBus::answers(FakePort& port)
{
  if (port.callsUntilUnplugged == 0)
  {
    port.present = false;
  }
  if (port.callsUntilUnplugged > 0)
  {
    --port.callsUntilUnplugged;
  }
  return port.present;
}

void FakeHidBus::pass(int duration_ms)
{
  if (this->virtualTime_)
  {
    this->now_ms_ += duration_ms;
    for (const auto& port : this->ports_)
    {
      port->firmware().advance(duration_ms);
    }
  }
}

} // namespace palpate::test
