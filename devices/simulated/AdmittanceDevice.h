// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "devices/simulated/DeviceModels.h"
#include "devices/simulated/LedPath.h"
#include "haptics/core/HapticDevice.h"
#include "haptics/force/LinearPlant.h"

namespace palpate
{

/// A device with a force sensor and a position loop.
struct AdmittancePlan
{
  double mass_kg = 2.0;           ///< virtual mass that the hand moves
  double damping_Ns_per_m = 10.0; ///< virtual damping, in free motion too
  double lag_s = 0.005;           ///< of the position loop, of first order
  double noise_N = 0.0;           ///< of the sensor: uniform between - and + this
  double period_s = 1e-3;
  double workspaceRadius_m = 0.1;
};

/// The largest stiffness against which such a device is stable [N/m], by the criterion of Routh for a
/// lag of the loop and one period of hold: B (M + B t) / (M t) with t = lag + T.
[[nodiscard]] double stiffestHold(const AdmittancePlan& plan) noexcept;

/// A simulated device of that kind in a hand: the dual of an impedance device. The sensed force and the force of the
/// command move a virtual mass, exactly over each period; the tick sees that mass as the hand; the position loop goes
/// to the command's pose target, which is the proxy with all limits applied. The rotation of the hand is constant.
class AdmittanceDevice final : public HapticDevice
{
public:
  /// The mass of the hand is not simulated: the position loop carries it.
  AdmittanceDevice(const AdmittancePlan& plan, HandModel hand, HandPath path);

  [[nodiscard]] const DeviceInfo& info() const noexcept override { return this->info_; }
  [[nodiscard]] std::string open() override;
  void close() noexcept override {}
  [[nodiscard]] DeviceStatus read(double tickTime_s, DeviceSample& sample) noexcept override;
  void write(const DeviceCommand& command) noexcept override { this->command_ = command; }

  /// Position of the handle; a sample has that of the virtual mass [m].
  [[nodiscard]] const Vec3& handle_D() const noexcept { return this->handle_D_; }
  /// Force of the hand on the handle, without the noise of the sensor [N].
  [[nodiscard]] const Vec3& handForce_D() const noexcept { return this->hand_N_; }

private:
  void advance() noexcept;
  [[nodiscard]] Vec3 noise() noexcept;

  AdmittancePlan plan_;
  HandModel hand_;
  LedPath path_;
  DeviceInfo info_;
  LinearPlant virtual_;
  double follow_; ///< share of the distance to the target that the loop covers in a period
  DeviceCommand command_;
  Vec3 mass_D_ = Vec3::Zero(), massSpeed_D_ = Vec3::Zero();
  Vec3 handle_D_ = Vec3::Zero(), handleSpeed_D_ = Vec3::Zero();
  Vec3 hand_N_ = Vec3::Zero(), sensed_N_ = Vec3::Zero();
  std::uint64_t noiseState_ = 1;
  double time_s_ = 0.0;
};

} // namespace palpate
