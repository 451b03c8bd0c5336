// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "devices/evdev/EvdevBus.h"

namespace palpate::test
{

/// Treatment of effects by the kernel and the driver of a force-feedback device (Documentation/input/ff.rst, ff-core.c
/// and ff-memless.c under drivers/input), and the handle that they push: a mass with friction between two stops.
/// Positions are shares of half the travel and forces of the largest, x to the right and y towards the person.
class VirtualDriver
{
public:
  using Axes = std::array<double, 2>;

  /// Force of a condition's coefficient of 1 at a distance of 1, and a damper's metric as a share of the speed.
  static constexpr double springGain = 10.0, damperMetric = 0.2;
  static constexpr double handleMass = 0.01, handleFriction = 0.6;
  static constexpr std::size_t memory = 16;
  /// ff-memless counts the force in so many steps from none to the largest, and rounds down; of 128 parts it makes 127.
  static constexpr double steps = 127.0, rounding = 2.0 / steps;

  explicit VirtualDriver(const EvdevTraits& traits) noexcept : traits_(traits) {}

  /// 0, or the error of errno.h. A new effect, -1, gets its number.
  int upload(ff_effect& effect);
  /// The driver's part of that once the kernel has given the effect its number.
  void store(const ff_effect& effect);
  int erase(int effect);
  /// A written EV_FF event.
  void told(std::uint16_t code, std::int32_t value);
  void advance(int duration_ms);
  /// The program that owned the effects is gone.
  void flush();

  /// Of all effects now.
  [[nodiscard]] Axes force() const;
  [[nodiscard]] int held() const;
  [[nodiscard]] int playing() const;
  /// The first of that type that is stored.
  [[nodiscard]] const ff_effect* of(std::uint16_t type) const;

  Axes push{}; ///< of the hand
  Axes position{}, velocity{};
  int gain = 0x1000, autocentre = 0x4000; ///< as the last program has left them
  /// Its timer fires once between taking an effect and storing it: the played effect stays as it was until the next
  /// change.
  bool missesNext = false;

private:
  struct Slot
  {
    std::optional<ff_effect> effect; ///< in its memory
    ff_effect played{};              ///< the one that is felt
    bool plays = false;
    int age_ms = 0;
  };
  [[nodiscard]] double forceOf(const Slot& slot, std::size_t axis) const;
  void step();

  EvdevTraits traits_;
  std::array<Slot, memory> slots_{};
};

/// The direction in which a force of positive level pushes: it comes from the other side, and 0 is "down", the top.
[[nodiscard]] VirtualDriver::Axes pushedBy(std::uint16_t direction);

} // namespace palpate::test
