// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "haptics/core/HapticDevice.h"

namespace palpate::lab
{

/// What moves along z: a device nobody holds, or one in a hand that holds still where it started.
struct FreeDevice
{
  double mass_kg = 0.1;
  double damping_Ns_per_m = 1.0;
  double friction_N = 0.0;
  double encoderStep_m = 0.0;
  double maxForce_N = std::numeric_limits<double>::infinity();
  double maxStiffness_N_per_m = std::numeric_limits<double>::infinity(); ///< what it is made for
  int delay_ticks = 0;
  double push_N = 0.0;      ///< constant, downwards
  double z_m = 0.0;         ///< start
  double speed_m_per_s = 0.0; ///< start, upwards

  /// The same without friction, encoder steps and force limit: what linear theory speaks of.
  [[nodiscard]] FreeDevice linear() const;
};

/// A simulated device with its true state, which an encoder does not show.
class ObservedDevice
{
public:
  virtual ~ObservedDevice() = default;
  [[nodiscard]] virtual HapticDevice& device() = 0;
  [[nodiscard]] virtual double z_m() const = 0;
  [[nodiscard]] virtual double speed_m_per_s() const = 0;
};

[[nodiscard]] std::unique_ptr<ObservedDevice> makeFree(const FreeDevice& what, double period_s);

} // namespace palpate::lab
