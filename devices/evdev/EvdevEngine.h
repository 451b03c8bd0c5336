// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "devices/evdev/EvdevBus.h"
#include "devices/hid/EffectEngine.h"
#include "devices/hid/pid/PidStep.h"

namespace palpate
{

/// Effects through the kernel's own driver for a device. An effect is always given whole, so its numbers are kept here
/// and given again with each change.
///
/// A direction says, as with PID, where a force comes from, but 0 is called "down": 0x4000 pushes to the left and
/// 0xC000 to the right (linux/input.h, ff_effect; drivers/input/ff-memless.c gives a driver sin and -cos of it as x and
/// y, which drivers/hid/hid-lg4ff.c sends a wheel as 0x80 + x; drivers/hid/usbhid/hid-pidff.c hands it on as PID's
/// angle).
class EvdevEngine final : public EffectEngine
{
public:
  /// `connection` must outlive the engine.
  EvdevEngine(EvdevConnection& connection, const EvdevTraits& traits) noexcept;

  /// Full gain, and the device's own spring to its middle off. Empty, or why not.
  [[nodiscard]] std::string open();
  /// Stops and takes away all effects. The device's own spring gets back the strength that the driver told before. Most
  /// drivers tell none: the spring then stays off, as those drivers leave a device that is plugged in.
  void close() noexcept;

  [[nodiscard]] Created create(HidUsage type) override;
  [[nodiscard]] bool setEffect(int block, const EffectSettings& settings) noexcept override;
  [[nodiscard]] bool setCondition(int block, int axis, const Condition& condition) noexcept override;
  [[nodiscard]] bool setConstantForce(int block, double share) noexcept override;
  [[nodiscard]] bool setPeriodic(int block, double magnitude, double period_ms) noexcept override;
  /// Gives the whole effect once more: drivers without a memory of their own (ff-memless) may play an old force if
  /// their timer fires between taking an effect and storing it, and would do so until the next change.
  [[nodiscard]] bool start(int block) noexcept override;
  [[nodiscard]] bool stop(int block) noexcept override;
  [[nodiscard]] bool control(HidUsage what) noexcept override;

  [[nodiscard]] std::int64_t constantForceSteps(double share) const noexcept override;
  [[nodiscard]] std::string error() const override { return this->connection_.error(); }

  /// Gives an effect that the driver was too busy for; such a driver (iforce) takes one change at a time.
  [[nodiscard]] PidStep catchUp() noexcept;

private:
  struct Effect
  {
    ff_effect told{};
    bool late = false; ///< the driver has not taken it as it is told
  };
  [[nodiscard]] bool give(Effect& effect) noexcept;
  [[nodiscard]] Effect& at(int block) noexcept { return this->effects_[static_cast<std::size_t>(block) - 1]; }

  EvdevConnection& connection_;
  EvdevTraits traits_;
  std::vector<Effect> effects_;  ///< block - 1
  std::optional<int> ownSpring_; ///< as it was before
};

} // namespace palpate
