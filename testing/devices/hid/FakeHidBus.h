// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "devices/hid/HidConnection.h"
#include "haptics/core/Clock.h"
#include "testing/devices/hid/FirmwareModel.h"
#include "testing/devices/hid/VirtualPidDevice.h"
#include "testing/devices/hid/VirtualSpaceMouse.h"

namespace palpate::test
{

/// A device plugged into the fake bus, and the faults of the link to it.
struct FakePort
{
  HidEntry entry;
  std::shared_ptr<VirtualPidDevice> device; ///< one of the four
  std::shared_ptr<FirmwareModel> model;
  std::shared_ptr<VirtualSpaceMouse> spaceMouse;
  std::shared_ptr<VirtualHid> other;
  std::vector<std::uint8_t> descriptor;
  bool present = true;
  std::string descriptorProblem; ///< why its descriptor cannot be had
  std::string openProblem;       ///< no permission, busy: the system's message
  bool featureTimesOut = false;
  bool stalls = false;                ///< a write waits until this ends, or 5 s, then fails
  int hanging = 0;                    ///< so many writes wait now
  int callsUntilUnplugged = -1;       ///< it goes after that many calls more, whatever they are
  int shortFeature = -1;              ///< features are cut to that many bytes
  int writesThatFail = 0;             ///< so many fail although it is there
  bool readFails = false;             ///< although it is there
  std::function<void()> whileReading; ///< happens once while a read waits, which fails then
  int longestRead_ms = 0;             ///< that a read was to wait
  int opened = 0, closed = 0;

  [[nodiscard]] VirtualHid& firmware()
  {
    return this->device != nullptr  ? static_cast<VirtualHid&>(*this->device)
           : this->model != nullptr ? static_cast<VirtualHid&>(*this->model)
           : this->other != nullptr ? *this->other
                                    : *this->spaceMouse;
  }
};

/// A bus without a system: connections to virtual devices. With virtual time a call takes the time it would take and
/// the devices go on meanwhile; without, calls really block and the test moves the devices.
class FakeHidBus final : public HidBus
{
public:
  /// Virtual time of the bus, for whoever needs a clock.
  class Time final : public Clock
  {
  public:
    explicit Time(const FakeHidBus& bus) noexcept : bus_(bus) {}
    [[nodiscard]] std::int64_t now_ns() const noexcept override;

  private:
    const FakeHidBus& bus_;
  };

  explicit FakeHidBus(bool virtualTime = true) noexcept : virtualTime_(virtualTime), time_(*this) {}

  /// Plugs a device in. References stay valid.
  FakePort& plug(const PidLayout& layout, const std::string& serial = "0001");
  FakePort& plug(const CapLayout& layout, const std::string& serial = "0001");
  FakePort& plug(std::shared_ptr<FirmwareModel> model, std::vector<std::uint8_t> descriptor);
  FakePort& plug(std::shared_ptr<VirtualHid> other, HidEntry entry);

  [[nodiscard]] std::vector<HidEntry> devices() override;
  [[nodiscard]] Descriptor descriptor(const HidEntry& entry) override;
  [[nodiscard]] Opened open(const HidEntry& entry) override;

  /// Lets time pass for all devices.
  void advance(int duration_ms);
  /// Runs with nobody else on the bus.
  template<class Body>
  auto alone(Body body)
  {
    const std::lock_guard lock(this->mutex_);
    return body();
  }
  /// Ends a stall.
  void release(FakePort& port);
  [[nodiscard]] const Clock& time() const noexcept { return this->time_; }

private:
  friend class FakeConnection;
  [[nodiscard]] bool answers(FakePort& port);
  void pass(int duration_ms);
  FakePort& place(HidEntry entry);

  bool virtualTime_;
  Time time_;
  mutable std::mutex mutex_;
  std::condition_variable released_;
  std::int64_t now_ms_ = 0;
  std::vector<std::unique_ptr<FakePort>> ports_;
};

} // namespace palpate::test
