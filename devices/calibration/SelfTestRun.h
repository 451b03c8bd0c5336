// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "devices/calibration/SelfTest.h"
#include "devices/common/DeviceSteps.h"
#include "devices/common/LinkedDevice.h"
#include "haptics/realtime/RealtimeThread.h"

namespace palpate
{

/// How a self-test is to run. Fixed while it runs.
struct SelfTestOptions
{
  double period_s = 1e-3;
  bool virtualTime = false; ///< nothing runs by itself: step() computes ticks in the caller's thread
  DeadMan deadMan;
  bool wheel = false;      ///< the person says that it is one
  RealtimeBrokers brokers; ///< who is asked for real-time priority where the user's limits do not allow it
};

/// Owner of a device that is being tested, and of the thread that tests it. A simulated hand goes where it is asked to.
/// One thread, the owner's, calls every method; none waits for the other but stop() and the destructor, which end it
/// with zero force.
class SelfTestRun
{
public:
  SelfTestRun();
  ~SelfTestRun();
  SelfTestRun(const SelfTestRun&) = delete;
  SelfTestRun& operator=(const SelfTestRun&) = delete;

  /// Opens the device and begins. Empty, or one sentence why not; then nothing runs.
  [[nodiscard]] std::string start(std::unique_ptr<HapticDevice> device, const SelfTestOptions& options = {});
  /// Zero force, thread joined, device closed. Without a verdict by then it was stopped.
  void stop();
  /// A device is open.
  [[nodiscard]] bool running() const noexcept { return this->run_ != nullptr; }
  /// Virtual time: computes up to that many ticks now.
  void step(int ticks);

  /// The step that a person has to do before the device can be pushed; none: no step.
  [[nodiscard]] std::optional<DeviceStep> need() const;
  /// The person has done it.
  void needDone(const std::string& file);

  /// The newest state; after stop() the last one.
  [[nodiscard]] const SelfTestState& state();
  /// Of the device that was tested last.
  [[nodiscard]] const SelfTestPlan& plan() const noexcept { return this->plan_; }
  [[nodiscard]] const DeviceInfo& device() const noexcept { return this->device_; }
  /// How the link to it went, once the run was stopped.
  [[nodiscard]] const LinkReport& link() const noexcept { return this->link_; }

private:
  struct Run;

  SelfTestPlan plan_;
  DeviceInfo device_;
  SelfTestState lastState_;
  LinkReport link_;
  std::unique_ptr<Run> run_;
};

} // namespace palpate
