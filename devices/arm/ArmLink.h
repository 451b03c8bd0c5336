// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "devices/arm/ArmLine.h"
#include "devices/arm/ArmSetup.h"
#include "devices/arm/CounterUnwrap.h"
#include "devices/arm/StillReading.h"
#include "devices/common/LinkedDevice.h"
#include "devices/io/AttachedDevice.h"
#include "devices/io/FindAgain.h"
#include "devices/io/HandExchange.h"
#include "devices/io/LinkCounts.h"
#include "haptics/arm/Arm.h"
#include "haptics/core/Clock.h"

namespace palpate
{

/// An arm that comes and goes, between one thread that exchanges messages, which may be blocked in it, and a servo,
/// which never waits. An answer that is late or wrong is followed by "no force" at once. A single one is forgiven, as
/// every computer stalls now and then. After a loss there is no force until the servo has asked for none once: only a
/// person brings it back.
class ArmLink
{
public:
  static constexpr int answer_ms = 5;                       ///< later is no answer
  static constexpr std::int64_t lostAfter_ns = 10000000;    ///< without a good answer
  static constexpr std::int64_t silence_ns = 20 * perMs_ns; ///< without a new command there is no force

  /// `clock` must outlive the link.
  ArmLink(std::shared_ptr<ArmBus> bus, HidEntry entry, const ArmSetup& setup, const Clock& clock);

  /// Finds and opens the device. Empty, or why not. Exchange thread, or before there is one.
  [[nodiscard]] std::string attach();
  /// Leaves the device without force and lets it go. Exchange thread, or after it.
  void detach() noexcept;
  /// One order out, one reading back. False: there is no device. Exchange thread.
  bool pass();

  /// The newest. Servo thread; wait-free.
  [[nodiscard]] HandExchange::Heard heard() noexcept { return this->exchange_.heard(); }
  void command(const DeviceCommand& command) noexcept { this->exchange_.command(command); }
  /// Answers so far. Any thread; wait-free.
  [[nodiscard]] std::uint64_t answers() const noexcept { return this->counts_.inputs; }

  /// The largest force from now on. Any thread.
  void limit(double force_N) noexcept { this->limit_N_ = force_N; }
  /// The step that a person has to do next. Any thread but the servo's.
  [[nodiscard]] std::optional<DeviceStep> step() const;
  void stepDone(const std::string& file);
  [[nodiscard]] LinkReport report() const;

private:
  /// All that lives as long as the arm stays attached.
  struct Attached
  {
    std::unique_ptr<ArmLine> line;
    CounterUnwrap unwrap{ 0 };
    struct Reached
    {
      JointVector joints;
      Posture posture;
    };
    std::optional<Reached> reached; ///< by the last good answer, of an arm with a plan
    std::int64_t good_ns = 0;       ///< when that was
    int doubts = 0;                 ///< answers since that were none, or late
    bool mayPush = false;           ///< it is homed and says nothing against it
    bool usable = false;            ///< moreover its counters are set, all by the last good answer
    StillReading still;
    double pushed_N = 0.0;                            ///< asked for by the last order that may push
    bool ended = false;                               ///< it became useless, and has not pushed since
    std::atomic<bool> faded = false;                  ///< no force is left, as the readings stay the same
    int settling = 0;                                 ///< answers that may still show the counters of before
    std::atomic<bool> homed = false, counted = false; ///< its places mean something
    std::atomic<bool> setCounters = false;            ///< the person has said that it is in its pose
  };

  [[nodiscard]] std::string prepare(const FoundDevice& found);
  void reattach(std::int64_t now_ns);
  [[nodiscard]] WireOrder orderOf(Attached& device, std::int64_t now_ns) noexcept;
  [[nodiscard]] bool fallsSilent(std::uint64_t beat, std::int64_t now_ns) noexcept;
  void push(Attached& device, const Wrench& wrench_D, WireOrder& order) noexcept;
  void forgetEnd(Attached& device) noexcept;
  void take(const std::shared_ptr<Attached>& device, ArmLine::Answer& answer, std::int64_t asked_ns);
  void takeReading(Attached& device, WireReading& reading);
  void judgeUse(Attached& device, const WireReading& reading, bool hasHand);
  void takeCounters(Attached& device, const WireReading& reading) noexcept;
  [[nodiscard]] std::optional<HandExchange::Hand> handOf(Attached& device, const WireReading& reading) const noexcept;
  void lose(const std::shared_ptr<Attached>& device, const std::string& why);

  std::shared_ptr<ArmBus> bus_;
  DeviceSearch search_; ///< exchange thread's, and the owner's before
  const ArmSetup setup_;
  const std::optional<Arm> arm_;
  const Clock& clock_;

  AttachedDevice<Attached> held_; ///< exchange thread and owner only
  HandExchange exchange_{ HeldTrust{} };
  LinkCounts counts_;
  std::atomic<double> limit_N_;
  std::atomic<std::int64_t> asking_ns_ = notAsking; ///< since when an answer is waited for
  mutable std::mutex stopMutex_;                    ///< exchange thread and owner only
  std::string stopped_;                             ///< the device's own reason for giving no force
  std::string endedFor_;                            ///< likewise, when it became useless while it was attached
  SearchPause pause_;                               ///< exchange thread's
  std::uint64_t beat_ = 0;                          ///< exchange thread's
  std::int64_t beat_ns_ = 0;                        ///< exchange thread's
  static constexpr std::int64_t notAsking = -1, stuckAfter_ns = 50 * perMs_ns;
};

} // namespace palpate
