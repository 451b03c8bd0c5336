// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "devices/simulated/SimulatedDevice.h"

namespace palpate::lab
{

class WallRig;

/// A device that nobody holds and that moves along z.
struct FreeDevice
{
  DeviceModel model = *deviceModel("simulated-generic");
  int delay_ticks = 0;
  double push_N = 0.0;        ///< constant, downwards
  double z_m = 0.0;           ///< start
  double speed_m_per_s = 0.0; ///< start, upwards

  /// The same without friction, encoder steps and force limit: the assumptions of linear theory.
  [[nodiscard]] FreeDevice linear() const;
};

[[nodiscard]] std::unique_ptr<SimulatedDevice> makeFree(const FreeDevice& what, double period_s);

/// Lets the rig run for `ticks`: peak to peak of its device's true height from tick `from` on [m], none once it leaves
/// +-1 m.
[[nodiscard]] std::optional<double> swing_m(WallRig& rig, const SimulatedDevice& device, int ticks, int from);

} // namespace palpate::lab
