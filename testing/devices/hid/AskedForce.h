// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "devices/hid/pid/PidOutput.h"

namespace palpate::test
{

/// How strong a force along an axis may be [share], by everything that was asked for while effects may still play: a
/// spring and its host's half, a damper, a force and a shake at once.
class AskedForce
{
public:
  void note(const DeviceCommand& command, const PidOutputOptions& options, std::int64_t now_ms)
  {
    const double most = options.largestShare;
    const double held = (command.wallCount > 0 ? 2.0 * most : 0.0) + (command.viscosity_Ns_per_m > 0.0 ? most : 0.0);
    const double force = command.wrench_D.force.cwiseAbs().maxCoeff() / options.scale.maxForce_N;
    constexpr double shake = 0.3;
    this->now_ = held + force + (command.signal != Signal::None ? shake : 0.0);
    this->all_.emplace_back(now_ms, this->now_);
  }
  /// The force that is felt may be late by the time in which an effect runs out.
  [[nodiscard]] double most(std::int64_t now_ms, int late_ms) const
  {
    double most = this->now_;
    for (const auto& [at_ms, share] : this->all_)
    {
      most = now_ms - at_ms <= late_ms ? std::max(most, share) : most;
    }
    return most;
  }

private:
  double now_ = 0.0;
  std::vector<std::pair<std::int64_t, double>> all_;
};

} // namespace palpate::test
