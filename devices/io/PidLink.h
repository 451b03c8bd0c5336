// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "devices/hid/HidConnection.h"
#include "devices/hid/PidInput.h"
#include "devices/hid/PidOutput.h"
#include "haptics/core/Clock.h"
#include "haptics/realtime/TripleBuffer.h"

namespace palpate
{

/// Which of the devices that are there is meant: the one with that serial number; without one, the only one of its
/// kind.
struct FoundDevice
{
  std::optional<HidEntry> entry;
  std::string problem;
};
[[nodiscard]] FoundDevice findAgain(HidBus& bus, const HidEntry& wanted);

/// How the link went so far.
struct LinkReport
{
  std::uint64_t inputs = 0;     ///< reports with the hand
  std::uint64_t strange = 0;    ///< neither that nor a state: another ID, or too short
  std::uint64_t outOfRange = 0; ///< positions beyond what the descriptor allows
  std::uint64_t losses = 0;     ///< times the device was lost
  bool attached = false;
  bool frozen = false; ///< it shows the same place although it pushes
  std::string message; ///< what was wrong last, for a person; empty: nothing
};

/// A force-feedback joystick that comes and goes, between a reader, a writer and a servo. The reader and the writer
/// each call their pass again and again and may be blocked in it for seconds; the servo exchanges newest values with
/// them and never waits. After a loss the writer opens the device again, but gives no force until the servo has asked
/// for none once: only a person brings it back.
class PidLink
{
public:
  /// Numbers are those of a device of the PID class; `clock` must outlive the link.
  PidLink(std::shared_ptr<HidBus> bus, HidEntry entry, const PidOutputOptions& options, const Clock& clock);

  /// Finds, opens and prepares the device. Empty, or why not. Writer thread, or before there is one.
  [[nodiscard]] std::string attach();
  /// Leaves the device without force and lets it go. Writer thread, or after it.
  void detach() noexcept;

  /// Waits for input, keeps the newest, watches the writer. False: there is no device. Reader thread.
  bool readPass(int timeout_ms);
  /// Sends what is most urgent. False: nothing to do now. Writer thread.
  bool writePass();

  struct Hand
  {
    Vec3 p_D = Vec3::Zero(); ///< [m]
    std::uint32_t buttons = 0;
  };
  /// The newest hand; none: the device is lost, or was since the last call. Servo thread; wait-free.
  [[nodiscard]] std::optional<Hand> hand() noexcept;
  /// Servo thread; wait-free.
  void command(const DeviceCommand& command) noexcept;

  /// Any thread but the servo's.
  [[nodiscard]] LinkReport report() const;
  /// What the device cannot do. Any thread but the servo's.
  [[nodiscard]] std::string shortcomings() const;

private:
  /// All that lives as long as a device stays plugged in.
  struct Attached
  {
    HidEntry entry;
    std::unique_ptr<HidConnection> connection;
    ReportDescriptor descriptor;
    std::optional<PidInput> input;
    std::optional<PidEngine> engine;
    std::optional<PidOutput> output;
    [[nodiscard]] std::string begin(HidBus& bus, const PidOutputOptions& options);
    void drain() const noexcept;
  };
  struct Outgoing
  {
    DeviceCommand command;
    std::uint64_t beat = 0;
  };

  [[nodiscard]] std::shared_ptr<Attached> attached() const;
  void lose(const std::string& why);
  void reattach(std::int64_t now_ns);
  [[nodiscard]] bool disturbed(const PidOutput& output) noexcept;
  void take(const Attached& device, std::span<const std::uint8_t> report, std::optional<Hand>& newest);
  void watchWriter(const Attached& device);
  void watchHand(std::int64_t now_ns, const PidOutput::Wish& wish) noexcept;

  std::shared_ptr<HidBus> bus_;
  HidEntry entry_;
  PidOutputOptions options_;
  const Clock& clock_;

  mutable std::mutex mutex_; ///< reader, writer and owner only
  std::shared_ptr<Attached> attached_;
  std::string message_, shortcomings_;

  TripleBuffer<Hand> handToServo_;  ///< reader -> servo
  TripleBuffer<Hand> handToWriter_; ///< reader -> writer
  TripleBuffer<Outgoing> commands_; ///< servo -> writer
  std::atomic<bool> live_ = false;
  std::atomic<bool> frozen_ = false;
  std::atomic<bool> actuatorsOff_ = false;
  std::atomic<int> stoppedBlock_ = 0;
  std::atomic<std::uint64_t> losses_ = 0, inputs_ = 0, strange_ = 0, outOfRange_ = 0;
  std::atomic<std::int64_t> writingSince_ns_ = notWriting;
  static constexpr std::int64_t notWriting = -1;

  std::uint64_t seenLosses_ = 0;   ///< servo's
  std::uint64_t beat_ = 0;         ///< servo's
  bool muted_ = false;             ///< writer's: until no force is asked for
  std::int64_t triedAt_ns_ = 0;    ///< writer's
  Vec3 stillAt_D_ = Vec3::Zero();  ///< writer's
  std::int64_t stillSince_ns_ = 0; ///< writer's
  bool writerStuck_ = false;       ///< reader's
};

} // namespace palpate
