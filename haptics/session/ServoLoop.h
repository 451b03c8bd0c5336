// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <stop_token>

#include "haptics/core/Clock.h"
#include "haptics/core/HapticDevice.h"
#include "haptics/realtime/PeriodicTimer.h"
#include "haptics/realtime/SpscRing.h"
#include "haptics/realtime/TripleBuffer.h"
#include "haptics/recording/writing/Recorder.h"
#include "haptics/session/LoopReport.h"
#include "haptics/tick/ForceRenderer.h"

namespace palpate
{

/// Buffers between other threads and the servo. Each has one writer and one reader (ARCHITECTURE.md).
struct ServoLinks : TickInputs::Links
{
  struct Versioned
  {
    std::uint64_t version = 0;
    HapticParameters parameters;
  };
  TripleBuffer<Versioned> parameters; ///< owner -> servo
  SpscRing<HapticEvent, 64> events;   ///< owner -> servo
  TripleBuffer<HapticState> state;    ///< servo -> owner
  TripleBuffer<LoopReport> report;    ///< servo -> owner, four times a second
  /// owner -> servo: the recorder; null: none. The servo's last push into one says that it has let go of it.
  std::atomic<Recorder*> recorder = nullptr;
};

/// Drives the tick: timer, device, scene, parameters, events in; command, state, statistics, recording out.
/// The same loop runs on a thread with the wall clock and in the caller's with a virtual one.
class ServoLoop
{
public:
  ServoLoop(
    HapticDevice& device, TickTimer& timer, ServoLinks& links, const Clock& costClock, double period_s) noexcept;

  /// Runs until a stop is asked for or the device ends; then the device gets a zero command. The caller queues a
  /// release before a stop: a hand that is still pushed then is let go in the release ramp, or in the first half second
  /// of that ramp. Servo thread.
  void run(const std::stop_token& stop) noexcept;
  /// One period. False when the device has ended. Servo thread; real-time safe.
  bool tick() noexcept;
  /// Between two ticks a recording ends, and another one begins with the recordable part of the last tick's state, from
  /// which the next tick goes on. Servo thread; every tick does it.
  void followRecorder() noexcept;
  /// Zero force, last report.
  void finish() noexcept;
  /// Makes the report of the ticks so far visible. Servo thread; run() does it four times a second.
  void publishReport() noexcept;

private:
  void letGo() noexcept;
  void takeChanges() noexcept;
  void takeInputs() noexcept;
  /// Whether this tick goes over from another value of an input.
  [[nodiscard]] bool replacesInput() const noexcept;
  void pushInputs() noexcept;
  void tellWorkers(const TickOutput& output) noexcept;
  void recordTick(const TickOutput& output) noexcept;
  /// How much later the thread ran than its next period began, missed periods included [s].
  [[nodiscard]] double behind_s(const Wakeup& wakeup) const noexcept;
  void account(const Wakeup& wakeup, const TickOutput& output, double cost_us) noexcept;

  HapticDevice& device_;
  TickTimer& timer_;
  ServoLinks& links_;
  const Clock& clock_;
  double period_s_;
  std::uint64_t period_ = 0; ///< number of the current period, from 1
  std::uint64_t version_ = 0;
  HapticParameters parameters_;
  std::uint32_t maps_ = 0; ///< that were changed so far
  RendererState renderer_;
  TickInput input_;
  TickInputs::Each<input::WorkspaceOf> workspaces_;
  Recorder* recorder_ = nullptr; ///< has its start, and not its end
  std::array<HapticEvent, 16> events_;
  Fault fault_ = Fault::None; ///< of the last tick
  bool pushes_ = false;       ///< the device was told to push, or to hold something, in the last tick
  DurationHistogram cost_;
  SlidingHistogram lateness_;
  double latenessP99_s_ = 0.0;
  LoopReport report_;
};

} // namespace palpate
