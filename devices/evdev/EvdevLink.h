// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "devices/evdev/EvdevBus.h"
#include "devices/evdev/EvdevEngine.h"
#include "devices/evdev/EvdevInput.h"
#include "devices/hid/pid/PidOutput.h"
#include "devices/io/PushedLink.h"

namespace palpate
{

/// A joystick behind the kernel's own driver as long as it stays plugged in.
struct AttachedEvdev
{
  HidEntry entry;
  std::unique_ptr<EvdevConnection> connection;
  std::optional<EvdevInput> input; ///< reader's
  std::optional<EvdevEngine> engine;
  std::optional<PidOutput> output;
  std::atomic<const char*> withoutForce = nullptr; ///< the kernel does not tell

  [[nodiscard]] std::string begin(EvdevBus& bus, const PidOutputOptions& options);
  [[nodiscard]] PidStep step(std::int64_t now_ns, const PidOutput::Wish& wish);
  [[nodiscard]] static const char* disturbance(std::int64_t /*now_ns*/) noexcept { return nullptr; }
};

/// A joystick behind the kernel's own driver that comes and goes, as PidLink is for one that is driven past it. The
/// kernel takes away the effects of a program that dies. A driver that hangs keeps every other call to its device
/// waiting, so there is nothing to stop it by: its effects end by themselves.
class EvdevLink final : public PushedLink<EvdevBus, AttachedEvdev>
{
public:
  /// `clock` must outlive the link.
  EvdevLink(std::shared_ptr<EvdevBus> bus, HidEntry entry, const PidOutputOptions& options, const Clock& clock)
    : PushedLink(std::move(bus), std::move(entry), options, clock)
  {
  }

  /// Of an axis, as a share of half its travel, as it showed when the device was opened; 0 before. Any thread.
  [[nodiscard]] double step() const noexcept { return this->step_; }

private:
  [[nodiscard]] std::optional<Hand> firstHand(AttachedEvdev& device) override;
  [[nodiscard]] bool listen(AttachedEvdev& device, int timeout_ms, std::optional<Hand>& newest) override;
  void unplugged(const std::shared_ptr<AttachedEvdev>& device) override;
  void giveUp(const std::shared_ptr<AttachedEvdev>& device, std::int64_t since_ns, const std::string& why) override;
  [[nodiscard]] std::optional<Hand> handIn(const EvdevInput& input) noexcept;

  std::atomic<double> step_ = 0.0;
};

} // namespace palpate
