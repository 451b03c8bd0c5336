// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/io/PidDevice.h"

#include <chrono>
#include <thread>
#include <utility>

#include "haptics/realtime/RealtimeThread.h"

namespace palpate
{
namespace
{

constexpr int readTimeout_ms = 100;
constexpr int writerPriority = 19; // just below the servo
constexpr auto idle = std::chrono::milliseconds(1);
constexpr auto noDevice = std::chrono::milliseconds(20);
constexpr auto patience = std::chrono::milliseconds(500);

/// What a detached thread still needs when the device object is gone.
std::shared_ptr<const Clock> clockOf(const PidDeviceOptions& options)
{
  if (options.clock != nullptr)
  {
    return { options.clock, [](const Clock*) {} };
  }
  return std::make_shared<MonotonicClock>();
}

} // namespace

/// The reader and the writer. Each owns what it works on, so that one that hangs in the system can be left behind.
struct PidDevice::Threads
{
  std::shared_ptr<PidLink> link;
  std::shared_ptr<const Clock> clock;
  std::atomic<bool> stop = false;
  std::atomic<bool> readerDone = false, writerDone = false;
  std::thread reader, writer;

  void read()
  {
    while (!this->stop)
    {
      if (!this->link->readPass(readTimeout_ms))
      {
        std::this_thread::sleep_for(noDevice);
      }
    }
    this->readerDone = true;
  }

  void write()
  {
    static_cast<void>(acquireScheduling(writerPriority));
    while (!this->stop)
    {
      if (!this->link->writePass())
      {
        std::this_thread::sleep_for(idle);
      }
    }
    this->link->detach();
    this->writerDone = true;
  }

  /// Waits a while; a thread that hangs in a call to the device is left to itself. True: it has ended.
  static bool leave(std::thread& thread, const std::atomic<bool>& done)
  {
    const auto until = std::chrono::steady_clock::now() + patience;
    while (!done && std::chrono::steady_clock::now() < until)
    {
      std::this_thread::sleep_for(idle);
    }
    if (!done)
    {
      thread.detach();
      return false;
    }
    thread.join();
    return true;
  }
};

DeviceInfo pidInfo(
  const std::string& name, const HidEntry& entry, const ReportDescriptor& descriptor, const PidScale& scale)
{
  const PidInput input(descriptor);
  DeviceInfo info;
  info.name = name;
  info.serial = entry.serial;
  info.deviceClass = input.hasTwoAxes() ? DeviceClass::Joystick2D : DeviceClass::Wheel1D;
  info.workspaceRadius_m = { scale.halfTravel_m, false };
  info.resolution_m = { input.usable() ? input.step() * scale.halfTravel_m : 0.0, false };
  info.maxForce_N = { scale.maxForce_N, false };
  return info;
}

PidDevice::PidDevice(
  const std::string& name, std::shared_ptr<HidBus> bus, HidEntry entry, const PidDeviceOptions& options)
  : bus_(std::move(bus)), entry_(std::move(entry)), options_(options), clock_(clockOf(options)), link_(this->newLink())
{
  const ReportDescriptor descriptor = parseReportDescriptor(this->bus_->descriptor(this->entry_).bytes);
  this->info_ = pidInfo(name, this->entry_, descriptor, options.output.scale);
}

std::shared_ptr<PidLink> PidDevice::newLink() const
{
  return std::make_shared<PidLink>(this->bus_, this->entry_, this->options_.output, *this->clock_);
}

PidDevice::~PidDevice()
{
  this->close();
}

std::string PidDevice::open()
{
  if (this->threads_ != nullptr)
  {
    return {};
  }
  std::string problem = this->link_->attach();
  if (!problem.empty() || !this->options_.threads)
  {
    return problem;
  }
  auto threads = std::make_shared<Threads>();
  threads->link = this->link_;
  threads->clock = this->clock_;
  this->threads_ = threads;
  threads->reader = std::thread([threads] { threads->read(); });
  threads->writer = std::thread([threads] { threads->write(); });
  return {};
}

void PidDevice::close() noexcept
{
  if (this->threads_ == nullptr)
  {
    this->link_->detach();
    return;
  }
  const std::shared_ptr<Threads> threads = std::exchange(this->threads_, nullptr);
  threads->stop = true;
  const bool writerEnded = Threads::leave(threads->writer, threads->writerDone);
  const bool readerEnded = Threads::leave(threads->reader, threads->readerDone);
  if (!writerEnded || !readerEnded)
  {
    this->link_ = this->newLink(); // the old one is theirs, whenever they come back
  }
}

DeviceStatus PidDevice::read(double tickTime_s, DeviceSample& sample) noexcept
{
  const std::optional<PidLink::Hand> hand = this->link_->hand();
  if (!hand)
  {
    return DeviceStatus::Lost;
  }
  sample = {};
  sample.time_s = tickTime_s;
  sample.pose_D.p = hand->p_D;
  sample.buttons = hand->buttons;
  return DeviceStatus::Ok;
}

} // namespace palpate
