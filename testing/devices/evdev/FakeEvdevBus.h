// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <functional>
#include <initializer_list>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "devices/evdev/EvdevBus.h"
#include "haptics/core/Clock.h"
#include "testing/devices/evdev/VirtualDriver.h"

namespace palpate::test
{

/// Traits by the kernel's numbers.
[[nodiscard]] EvdevTraits traitsWith(
  std::initializer_list<int> axes, std::initializer_list<int> keys, std::initializer_list<int> forces);
/// A stick that can do all that a driver may offer, such as the old ones of I-Force.
[[nodiscard]] EvdevTraits stickTraits();
/// A wheel with three pedals, as hid-logitech offers a G29: constant force alone.
[[nodiscard]] EvdevTraits wheelTraits();

/// An event device on the fake bus, and its faults.
struct FakeEvdevPort
{
  FakeEvdevPort(HidEntry is, const EvdevTraits& has) : entry(std::move(is)), traits(has), driver(has) {}

  HidEntry entry;
  EvdevTraits traits;
  VirtualDriver driver;
  std::vector<std::vector<std::uint8_t>> behindPlug;
  std::string openProblem;
  std::map<std::string, int> settings; ///< files of the driver's own
  std::map<int, input_absinfo> axes;   ///< ranges and newest values
  std::bitset<KEY_CNT> keys;
  std::deque<input_event> events;
  bool present = true;
  int busyFor = 0; ///< so many uploads are to come again
  int uploadsThatFail = 0;
  std::function<void()> whileUploading; ///< happens once, while one waits
  int opened = 0, closed = 0;

  /// The device says where an axis or a button is, in its own numbers; a report ends with end().
  void say(std::uint16_t type, std::uint16_t code, std::int32_t value);
  void end() { this->say(EV_SYN, SYN_REPORT, 0); }
  /// An axis by its share, -1 .. 1, and the end of the report.
  void move(std::uint16_t axis, double share);
};

/// Event devices without a kernel, in virtual time.
class FakeEvdevBus final : public EvdevBus
{
public:
  class Time final : public Clock
  {
  public:
    [[nodiscard]] std::int64_t now_ns() const noexcept override { return this->now_ms * 1000000; }
    std::int64_t now_ms = 0;
  };

  /// Plugs a device in. References stay valid.
  FakeEvdevPort& plug(const EvdevTraits& traits, const std::string& serial = "", std::uint16_t vendor = 0x046D,
    std::uint16_t product = 0xC281);

  [[nodiscard]] std::vector<HidEntry> devices() override;
  [[nodiscard]] Descriptor descriptor(const HidEntry& entry) override;
  [[nodiscard]] EvdevTraits traits(const HidEntry& entry) override;
  [[nodiscard]] std::vector<std::vector<std::uint8_t>> behindPlug(const HidEntry& entry) override;
  [[nodiscard]] Opened open(const HidEntry& entry) override;

  void advance(int duration_ms);
  Time time;

private:
  [[nodiscard]] FakeEvdevPort* at(const std::string& path);

  std::vector<std::unique_ptr<FakeEvdevPort>> ports_;
};

} // namespace palpate::test
