// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <string>

#include "testing/devices/arm/LedArm.h"
#include "testing/devices/hid/VirtualHid.h"

namespace palpate::test
{

/// A WoodenHaptics of 2015: its mechanics, its motors and its firmware, from the facts that are public
/// (forsslund/haptikfabrikenapi). Reports wait for one another; amplifiers go off half a second after the last order.
class WoodenHapticsModel final
  : public VirtualHid
  , public LedArm
{
public:
  static constexpr std::uint16_t vendor = 0x1234, product = 0x0006;
  static constexpr int watchdog_ms = 500, period_ms = 1; ///< of its reports: it looks at its watchdog as often

  WoodenHapticsModel();

  bool take(HidReportKind kind, std::span<const std::uint8_t> bytes) override;
  [[nodiscard]] std::vector<std::uint8_t> feature(std::uint8_t) override { return {}; }
  [[nodiscard]] std::vector<std::uint8_t> nextInput() override;
  void advance(int duration_ms) override;
  [[nodiscard]] Vec3 tipOf(const Vec3& joints_rad) const override;

  /// Force of the motors on the hand now [N].
  [[nodiscard]] Vec3 force_N() const;
  /// The same for a current of 0.5 mA, half a step, in each motor at once, whatever their signs, at most [N].
  [[nodiscard]] double halfStep_N() const;
  /// The arm stands in its pose of calibration, and its power is just on.
  void standInPose();
  /// The owner's file for it.
  [[nodiscard]] static std::string file();

  std::array<double, 3> constants_Nm_per_A{ 0.0259, 0.0259, 0.0259 }; ///< of its motors
  std::array<double, 3> current_mA{};
  std::int16_t fourth = 0;       ///< its fourth counter
  std::size_t reportBytes = 14;  ///< that it takes
  bool frozen = false;           ///< it takes nothing and says nothing more
  bool pressed = false;          ///< its calibration button
  int cutAnswers = 0;            ///< so many answers are half as long
  int wrongAnswers = 0;          ///< so many answers have one byte
  int silentFor = 0;             ///< so many answers do not come
  int orders = 0, setOrders = 0; ///< messages so far
  int wentOffAfter_ms = 0;       ///< without an order, when its amplifiers went off last

private:
  [[nodiscard]] std::array<double, 3> bodyTurns() const;
  [[nodiscard]] std::array<std::int16_t, 6> counters() const;
  void say();

  std::array<double, 6> offset_{}; ///< counter that was set, less the count at that time
  std::deque<std::vector<std::uint8_t>> waiting_;
  int silence_ms_ = 0;
};

} // namespace palpate::test
