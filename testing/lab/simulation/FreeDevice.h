// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "devices/simulated/SimulatedDevice.h"

namespace palpate::lab
{

/// A device that nobody holds and that moves along z.
struct FreeDevice
{
  DeviceModel model = *deviceModel("simulated-generic");
  int delay_ticks = 0;
  double push_N = 0.0;        ///< constant, downwards
  double z_m = 0.0;           ///< start
  double speed_m_per_s = 0.0; ///< start, upwards

  /// The same without friction, encoder steps and force limit: what linear theory speaks of.
  [[nodiscard]] FreeDevice linear() const;
};

[[nodiscard]] std::unique_ptr<SimulatedDevice> makeFree(const FreeDevice& what, double period_s);

} // namespace palpate::lab
