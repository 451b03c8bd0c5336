// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "devices/common/LinkedDevice.h"
#include "devices/evdev/EvdevBus.h"
#include "devices/evdev/EvdevEngine.h"
#include "devices/evdev/EvdevInput.h"
#include "devices/hid/pid/PidOutput.h"
#include "devices/io/FindAgain.h"
#include "devices/io/HandExchange.h"
#include "devices/io/HeldDevice.h"
#include "devices/io/LinkCounts.h"
#include "devices/io/WriterWatch.h"
#include "haptics/core/Clock.h"

namespace palpate
{

/// A joystick behind the kernel's own driver that comes and goes, between a reader, a writer and a servo, as PidLink is
/// for one that is driven past it. The kernel takes away the effects of a program that dies. A driver that hangs keeps
/// every other call to its device waiting, so there is nothing to stop it by: its effects end by themselves.
class EvdevLink
{
public:
  /// `clock` must outlive the link.
  EvdevLink(std::shared_ptr<EvdevBus> bus, HidEntry entry, const PidOutputOptions& options, const Clock& clock);

  /// Finds, opens and prepares the device; what it can do to a hand then is what it must be able to do whenever it
  /// comes back. Empty, or why not. Before there is a writer thread.
  [[nodiscard]] std::string attach();
  /// Leaves the device without force and lets it go. Writer thread, or after it.
  void detach() noexcept;

  /// Waits for events, keeps the newest hand, watches the writer. False: there is no device. Reader thread.
  bool readPass(int timeout_ms);
  /// Gives the driver what is most urgent. False: nothing to do now. Writer thread.
  bool writePass();

  using Hand = HandExchange::Hand;
  using Heard = HandExchange::Heard;
  /// The newest. Servo thread; wait-free.
  [[nodiscard]] Heard heard() noexcept { return this->exchange_.heard(); }
  /// Servo thread; wait-free.
  void command(const DeviceCommand& command) noexcept { this->exchange_.command(command); }

  /// Any thread but the servo's.
  [[nodiscard]] LinkReport report() const;
  /// What it is believed from now on. Any thread.
  void trust(HeldTrust trust) noexcept { this->exchange_.trust(trust); }
  struct Found
  {
    DeviceAbilities abilities; ///< that it offers
    double step = 0.0;         ///< of an axis, as a share of half its travel
  };
  /// What showed when it was opened; none before. Any thread but the servo's.
  [[nodiscard]] std::optional<Found> found() const;
  [[nodiscard]] std::optional<DeviceAbilities> abilities() const;

private:
  /// All that lives as long as a device stays plugged in.
  struct Attached
  {
    HidEntry entry;
    std::unique_ptr<EvdevConnection> connection;
    std::optional<EvdevInput> input; ///< reader's
    std::optional<EvdevEngine> engine;
    std::optional<PidOutput> output;
    [[nodiscard]] std::string begin(EvdevBus& bus, const PidOutputOptions& options);
  };
  [[nodiscard]] std::string prepare(FoundDevice found, const DeviceAbilities& least);
  [[nodiscard]] std::optional<Hand> handOf(const EvdevInput& input) noexcept;
  void lose(const std::shared_ptr<Attached>& device, const std::string& why);
  void reattach(std::int64_t now_ns);
  void watchWriter();
  [[nodiscard]] PidStep giveNext(Attached& device, std::int64_t now_ns);

  std::shared_ptr<EvdevBus> bus_;
  DeviceSearch search_; ///< writer's, and the owner's before
  PidOutputOptions options_;
  const Clock& clock_;

  HeldDevice<Attached> held_;     ///< reader, writer and owner only
  mutable std::mutex foundMutex_; ///< writer and owner only
  std::optional<Found> found_;

  HandExchange exchange_;
  LinkCounts counts_;
  WriterWatch writer_;

  DeviceAbilities opened_; ///< writer's, and the owner's before: what it could do when it was opened
  SearchPause pause_;      ///< writer's
};

} // namespace palpate
