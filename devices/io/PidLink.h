// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "devices/common/LinkedDevice.h"
#include "devices/hid/HidConnection.h"
#include "devices/hid/pid/PidInput.h"
#include "devices/hid/pid/PidOutput.h"
#include "devices/hid/pid/PidWatch.h"
#include "devices/io/FindAgain.h"
#include "devices/io/HandExchange.h"
#include "devices/io/HeldDevice.h"
#include "devices/io/LinkCounts.h"
#include "devices/io/WriterWatch.h"
#include "haptics/core/Clock.h"

namespace palpate
{

/// A force-feedback joystick that comes and goes, between a reader, a writer and a servo. The reader and the writer
/// each call their pass again and again and may be blocked in it for seconds; the servo exchanges newest values with
/// them and never waits. After a loss the writer opens the device again, but gives no force until the servo has asked
/// for none once: only a person brings it back.
class PidLink
{
public:
  /// Numbers are those of a device of the PID class; `clock` must outlive the link.
  PidLink(std::shared_ptr<HidBus> bus, HidEntry entry, const PidOutputOptions& options, const Clock& clock);

  /// Finds, opens and prepares the device; what it can do to a hand then is what it must be able to do whenever it
  /// comes back. Empty, or why not. Before there is a writer thread.
  [[nodiscard]] std::string attach();
  /// Leaves the device without force and lets it go. Writer thread, or after it.
  void detach() noexcept;

  /// Waits for input, keeps the newest, watches the writer. False: there is no device. Reader thread.
  bool readPass(int timeout_ms);
  /// Sends what is most urgent. False: nothing to do now. Writer thread.
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
  /// What the device offers; none before it was attached. Any thread but the servo's.
  [[nodiscard]] std::optional<DeviceAbilities> abilities() const;

private:
  /// All that lives as long as a device stays plugged in.
  struct Attached
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
    std::optional<Hand> last;                        ///< reader's
    bool gripped = false, switchSeen = false;        ///< reader's
    std::atomic<const char*> withoutForce = nullptr; ///< why its motors give none, as it says itself; null: they do
    std::atomic<bool> actuatorsOff = false;          ///< so it said
    std::atomic<int> stoppedBlock = 0;               ///< the last one it said so of
    std::atomic<bool> stalled = false;               ///< a write hung, and so it was told to stop
    [[nodiscard]] std::string begin(HidBus& bus, const PidOutputOptions& options);
    void drain() const noexcept;
    void stopPastTheWriter() noexcept;
    [[nodiscard]] const char* disturbance(std::int64_t now_ns) noexcept;
  };
  [[nodiscard]] std::string prepare(FoundDevice found, const DeviceAbilities& least);
  [[nodiscard]] std::optional<Hand> firstHand(Attached& device);
  [[nodiscard]] bool lose(const std::shared_ptr<Attached>& device, const std::string& why);
  void loseAndStop(const std::shared_ptr<Attached>& device);
  void loseAndStop(const std::shared_ptr<Attached>& device, std::int64_t since_ns, const std::string& why);
  void reattach(std::int64_t now_ns);
  [[nodiscard]] bool writeTo(const std::shared_ptr<Attached>& device, std::int64_t now_ns);
  void takeState(Attached& device, const PidState& state, std::optional<Hand>& newest);
  void take(Attached& device, std::span<const std::uint8_t> report, std::optional<Hand>& newest);
  void watchWriter(Attached& device);

  std::shared_ptr<HidBus> bus_;
  DeviceSearch search_; ///< writer's, and the owner's before
  PidOutputOptions options_;
  const Clock& clock_;

  HeldDevice<Attached> held_;         ///< reader, writer and owner only
  mutable std::mutex abilitiesMutex_; ///< writer and owner only
  std::optional<DeviceAbilities> abilities_;

  HandExchange exchange_;
  LinkCounts counts_;
  WriterWatch writer_;
  std::atomic<bool> stopping_ = false; ///< reader's: it tells a lost device to stop, and no other one must hear that

  DeviceAbilities opened_; ///< writer's, and the owner's before: what it could do when it was opened
  SearchPause pause_;      ///< writer's
};

} // namespace palpate
