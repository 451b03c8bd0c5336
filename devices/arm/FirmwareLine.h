// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "devices/arm/ArmLine.h"
#include "devices/arm/WireLine.h"
#include "devices/arm/link/FtdiPort.h"
#include "haptics/core/Clock.h"

namespace palpate
{

/// A Falcon from its chip on: it takes packets at once if its firmware runs already; else a person chooses the file.
/// There is no exchange before a guard stands by.
class FirmwareLine final : public ArmLine
{
public:
  /// `clock`: for the time that the loader is waited for; it outlives this. None: the system's.
  explicit FirmwareLine(std::unique_ptr<FtdiPort> port, const Clock* clock = nullptr)
    : port_(std::move(port)), clock_(clock != nullptr ? *clock : ownClock_)
  {
  }

  /// Sets the chip, looks whether the firmware runs. Empty, or why the device cannot be used at all.
  [[nodiscard]] std::string begin();

  [[nodiscard]] Answer exchange(const WireOrder& order, int timeout_ms) override;
  void letGo() noexcept override;
  [[nodiscard]] std::string error() const override;
  [[nodiscard]] std::optional<DeviceStep> step() const override;
  void stepDone(const std::string& file) override;
  void proceed() override;

private:
  [[nodiscard]] bool runs();
  [[nodiscard]] bool isThere() noexcept;
  [[nodiscard]] std::string load(const std::string& file);
  [[nodiscard]] std::string guarded();

  MonotonicClock ownClock_;
  std::shared_ptr<FtdiPort> port_;
  const Clock& clock_;
  std::unique_ptr<WireLine> line_;
  std::atomic<bool> running_ = false;
  std::atomic<bool> gone_ = false; ///< it vanished before it ran
  mutable std::mutex mutex_;       ///< of the members below
  std::optional<std::string> chosen_;
  std::string failed_;    ///< the last loading, as a sentence
  std::string unguarded_; ///< the firmware runs, but no guard: why
};

} // namespace palpate
