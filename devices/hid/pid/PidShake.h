// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "devices/hid/Rumble.h"
#include "devices/hid/pid/PidEngine.h"
#include "devices/hid/pid/PidStep.h"
#include "haptics/core/DeviceCommand.h"

namespace palpate
{

/// The one effect with which a device shakes: a signal that is played once, or a vibration that goes on as long as it
/// is wanted and is armed again and again, so that it ends by itself without renewal. One thread, not the servo's.
class PidShake
{
public:
  struct Timing
  {
    int duration_ms = 200;
    int restartEvery_ms = 100;
    int changeEvery_ms = 16;
  };
  PidShake(EffectEngine& engine, const Timing& timing) noexcept : engine_(engine), timing_(timing) {}

  /// Makes the effect, of a periodic kind or of constant force. Empty, or why there is none.
  [[nodiscard]] std::string begin(HidUsage type);
  [[nodiscard]] bool exists() const noexcept { return this->block_ > 0; }

  /// A signal that is new is played once, which takes three reports, and no longer than it is asked for: without force
  /// nothing may shake.
  [[nodiscard]] PidStep play(Signal signal) noexcept;
  [[nodiscard]] PidStep vibrate(std::int64_t now_ns, const Vibration& wanted) noexcept;
  /// Vibrations that were armed again before they ended.
  [[nodiscard]] std::uint64_t restarts() const noexcept { return this->restarts_; }
  /// Everything was stopped; a signal that was begun is stopped by itself once more, for some devices only pause.
  void forget() noexcept;

private:
  [[nodiscard]] PidStep end() noexcept;
  [[nodiscard]] EffectSettings settings() const noexcept;
  [[nodiscard]] bool setStrength(const Vibration& vibration) noexcept;

  EffectEngine& engine_;
  Timing timing_;
  HidUsage type_ = pid::sine;
  int block_ = 0;
  Signal lastSignal_ = Signal::None;
  bool sends_ = false; ///< a signal is being sent
  int part_ = 0;       ///< of that
  bool begun_ = false; ///< it was started, and not stopped since
  Vibration sent_;
  std::uint64_t restarts_ = 0;
  static constexpr std::int64_t never = -1;
  std::int64_t started_ns_ = never, changed_ns_ = never;
};

} // namespace palpate
