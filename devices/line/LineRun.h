// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "devices/common/DeviceLoop.h"
#include "haptics/line/LineTick.h"

namespace palpate
{

/// A line that is felt by turning: owner of a device, a world of one dimension and the thread between them. One thread,
/// the owner's, calls every method.
class LineRun
{
public:
  LineRun();
  ~LineRun();
  LineRun(const LineRun&) = delete;
  LineRun& operator=(const LineRun&) = delete;

  /// Opens the device and begins, without force. Empty, or one sentence why not: a device without force, a world that
  /// is refused or stiffer than this device can hold at this rate.
  [[nodiscard]] std::string start(std::unique_ptr<HapticDevice> device, LineWorld world, const DeadMan& deadMan = {},
    const DeviceLoopOptions& options = {});
  /// The person asks for force; after a fault again.
  void engage() noexcept;
  /// Zero force, device closed.
  void stop();
  [[nodiscard]] bool running() const noexcept { return this->run_ != nullptr; }
  /// Virtual time: computes that many ticks now.
  void step(int ticks);
  /// The newest; after stop() the last one.
  [[nodiscard]] const LineState& state();

private:
  struct Run;

  LineState lastState_;
  std::unique_ptr<Run> run_;
};

} // namespace palpate
