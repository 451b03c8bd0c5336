// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/simulated/SimulatedDevice.h"
#include "haptics/geometry/curves/CurveSet.h"
#include "haptics/session/HapticSession.h"

namespace palpate::lab
{

/// Who closes the walls.
enum class Closed
{
  ByDevice,
  ByHost,
};

/// A plane world under a handle that nobody holds.
struct PlaneGameSetup
{
  DeviceModel model;
  CurveSet curves;
  double stiffness_N_per_m = 200.0;
  double rate_Hz = 1000.0; ///< of the host
  Closed closed = Closed::ByDevice;
  Vec3 push_D = Vec3::Zero();     ///< [N]
  Vec3 velocity_D = Vec3::Zero(); ///< at the start [m/s]
};

/// The whole session on it, without safety limits, in virtual time.
class PlaneGame
{
public:
  explicit PlaneGame(const PlaneGameSetup& setup);

  /// One update of the host.
  void step() { static_cast<void>(this->session_.step(1)); }
  [[nodiscard]] const SimulatedDevice& device() const { return *this->device_; }

private:
  HapticSession session_;
  SimulatedDevice* device_ = nullptr;
};

} // namespace palpate::lab
