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
#include "devices/io/HeldDevice.h"
#include "devices/io/Presence.h"
#include "devices/io/ReportRate.h"
#include "haptics/core/Clock.h"
#include "haptics/realtime/TripleBuffer.h"

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

  struct Hand
  {
    Vec3 p_D = Vec3::Zero(); ///< [m]
    std::uint32_t buttons = 0;
  };
  struct Heard
  {
    bool there = false;       ///< now, and all the time since the last call
    std::optional<Hand> hand; ///< none: it has not said yet where the hand is
  };
  /// The newest. Servo thread; wait-free.
  [[nodiscard]] Heard heard() noexcept;
  /// Servo thread; wait-free.
  void command(const DeviceCommand& command) noexcept;

  /// Any thread but the servo's.
  [[nodiscard]] LinkReport report() const;
  /// What it is believed from now on. Any thread.
  void trust(HeldTrust trust) noexcept { this->trust_ = trust; }
  struct Found
  {
    DeviceAbilities abilities; ///< that it offers
    double step = 0.0;         ///< of an axis, as a share of half its travel
  };
  /// What showed when it was opened; none before. Any thread but the servo's.
  [[nodiscard]] std::optional<Found> found() const;

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
  void tell(const std::optional<Hand>& hand) noexcept;
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

  TripleBuffer<std::optional<Hand>> handToServo_;  ///< reader -> servo; none: not known yet
  TripleBuffer<std::optional<Hand>> handToWriter_; ///< reader -> writer
  TripleBuffer<DeviceCommand> commands_;           ///< servo -> writer
  // Lines of their own: the servo reads and writes these every tick, and the reader counts every report.
  alignas(64) Presence presence_;
  alignas(64) std::atomic<std::uint64_t> beat_ = 0; ///< servo's: commands so far
  alignas(64) ReportRate rate_;
  std::atomic<HeldTrust> trust_;
  std::atomic<bool> handKnown_ = false;
  std::atomic<std::uint64_t> inputs_ = 0, outOfRange_ = 0; ///< reader's
  std::atomic<std::uint64_t> stalls_ = 0;                  ///< reader's
  std::atomic<std::uint64_t> outputs_ = 0, restarts_ = 0;  ///< writer's
  std::atomic<std::int64_t> writingSince_ns_ = notWriting;
  static constexpr std::int64_t notWriting = -1;

  DeviceAbilities opened_;   ///< writer's, and the owner's before: what it could do when it was opened
  bool muted_ = false;       ///< writer's: until no force is asked for
  SearchPause pause_;        ///< writer's
  bool writerStuck_ = false; ///< reader's
};

} // namespace palpate
