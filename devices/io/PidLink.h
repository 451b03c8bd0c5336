// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>

#include "devices/hid/HidConnection.h"
#include "devices/hid/pid/PidInput.h"
#include "devices/hid/pid/PidOutput.h"
#include "devices/hid/pid/PidWatch.h"
#include "devices/io/PushedLink.h"

namespace palpate
{

/// A device of the PID class while it is plugged in.
struct AttachedPid
{
  HidEntry entry;
  std::unique_ptr<HidConnection> connection;
  std::unique_ptr<HidConnection> spare; ///< for the order to stop while a write hangs; null: there is none
  ReportDescriptor descriptor;
  std::optional<PidInput> input;
  std::optional<PidEngine> engine;
  std::optional<PidOutput> output;
  std::optional<PidWatch> watch;
  std::mutex spareMutex;
  std::optional<HandExchange::Hand> last;          ///< reader's
  bool gripped = false, switchSeen = false;        ///< reader's
  std::atomic<const char*> withoutForce = nullptr; ///< why its motors give no force, by its own report; null: they do
  std::atomic<bool> actuatorsOff = false;          ///< by its own report
  std::atomic<int> stoppedBlock = 0;               ///< last block that it reported as stopped
  std::atomic<bool> stalled = false;               ///< a write hung, and the device was ordered to stop

  [[nodiscard]] std::string begin(HidBus& bus, const PidOutputOptions& options);
  [[nodiscard]] PidStep step(std::int64_t now_ns, const PidOutput::Wish& wish) noexcept
  {
    return this->output->step(now_ns, wish);
  }
  void drain() const noexcept;
  void stopPastTheWriter() noexcept;
  [[nodiscard]] const char* disturbance(std::int64_t now_ns) noexcept;
};

/// The link to a force-feedback joystick of the USB PID class, which may be unplugged and plugged in again.
class PidLink final : public PushedLink<HidBus, AttachedPid>
{
public:
  /// Numbers are those of a device of the PID class; `clock` must outlive the link.
  PidLink(std::shared_ptr<HidBus> bus, HidEntry entry, const PidOutputOptions& options, const Clock& clock)
    : PushedLink(std::move(bus), std::move(entry), options, clock)
  {
  }

private:
  [[nodiscard]] std::optional<Hand> firstHand(AttachedPid& device) override;
  [[nodiscard]] bool listen(AttachedPid& device, int timeout_ms, std::optional<Hand>& newest) override;
  void unplugged(const std::shared_ptr<AttachedPid>& device) override;
  void giveUp(const std::shared_ptr<AttachedPid>& device, std::int64_t since_ns, const std::string& why) override;
  void stalled(AttachedPid& device) override;
  [[nodiscard]] bool mayReattach() const noexcept override { return !this->stopping_; }
  void takeState(AttachedPid& device, const PidState& state, std::optional<Hand>& newest);
  void take(AttachedPid& device, std::span<const std::uint8_t> report, std::optional<Hand>& newest);

  std::atomic<bool> stopping_ = false; ///< reader's: a lost device is ordered to stop, which no other one must receive
};

} // namespace palpate
