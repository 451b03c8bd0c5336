// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "testing/devices/hid/VirtualHid.h"

namespace palpate::test
{

/// How one generation of SpaceMice arranges its reports.
struct CapLayout
{
  std::string name;
  bool split = true;        ///< translation in report 1, rotation in report 2; else all six in report 1
  bool relative = true;     ///< the older ones call their axes so, and mean the same
  bool numbered = true;     ///< false: one report without an ID holds the axes and the buttons
  bool buttonArray = false; ///< the numbers of the buttons that are down
  bool battery = false;     ///< a radio link tells its charge now and then
  std::int64_t range = 350;
};
[[nodiscard]] CapLayout wiredCap();   ///< of 2006: two reports
[[nodiscard]] CapLayout newerCap();   ///< one report, absolute
[[nodiscard]] CapLayout radioCap();   ///< the same behind a receiver
[[nodiscard]] CapLayout manyKeyCap(); ///< keys by their numbers
[[nodiscard]] CapLayout plainCap();   ///< a hobby project without report IDs
[[nodiscard]] std::vector<CapLayout> allCaps();
[[nodiscard]] std::vector<std::uint8_t> descriptorOf(const CapLayout& layout);

/// A SpaceMouse without hardware. While its cap is out of its rest it tells so every 16 ms, then once more.
class VirtualSpaceMouse final : public VirtualHid
{
public:
  explicit VirtualSpaceMouse(const CapLayout& layout) : layout_(layout) {}

  bool take(HidReportKind, std::span<const std::uint8_t>) override { return false; }
  [[nodiscard]] std::vector<std::uint8_t> feature(std::uint8_t) override { return {}; }
  [[nodiscard]] std::vector<std::uint8_t> nextInput() override;
  void advance(int duration_ms) override;

  std::array<std::int64_t, 6> cap{}; ///< counts along HID's axes
  std::uint8_t buttons = 0;          ///< bit i: button i + 1 is down
  bool silent = false;               ///< its radio link is broken
  std::deque<std::vector<std::uint8_t>> inputs;

private:
  void tell(std::uint8_t id, std::size_t first, std::size_t count);
  void tellAxes();
  void tellButtons();
  void appendButtons(std::vector<std::uint8_t>& bytes) const;

  CapLayout layout_;
  std::array<std::int64_t, 6> told_{};
  std::uint8_t toldButtons_ = 0;
  int age_ms_ = 0;
};

} // namespace palpate::test
