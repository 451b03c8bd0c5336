// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "haptics/force/LinearPlant.h"
#include "haptics/core/HapticDevice.h"

namespace palpate
{

/// A device's moving part and the hand that holds it, a parallel spring, damper and mass.
struct HandModel
{
  std::string name;
  double deviceMass_kg = 0.1;
  double deviceDamping_Ns_per_m = 0.0;
  double handStiffness_N_per_m = 500.0; ///< of the stylus grip H2
  double handDamping_Ns_per_m = 5.0;
  double handMass_kg = 0.1;
};

/// D0: 0.1 kg and nothing else. D1: 0.1 kg and 1 N s/m. Both held by the stylus grip H2.
[[nodiscard]] HandModel idealHand();
[[nodiscard]] HandModel genericHand();

/// Where the hand is led, in the device frame.
struct HandPath
{
  std::vector<Vec3> points_D; ///< polyline [m]; one point: the hand holds still there
  double speed_m_per_s = 0.05;
  bool loops = true; ///< goes back and forth along it; else it stops at the end
};

/// A device in the grip of a spring-damper hand that is led along a polyline: deterministic, exact between ticks.
class SimulatedHand final : public HapticDevice
{
public:
  SimulatedHand(HandModel model, HandPath path, double period_s = 1e-3);

  [[nodiscard]] const DeviceInfo& info() const noexcept override { return this->info_; }
  /// Needs at least one point, all finite, and a positive speed.
  [[nodiscard]] std::string open() override;
  void close() noexcept override {}
  [[nodiscard]] DeviceStatus read(double tickTime_s, DeviceSample& sample) noexcept override;
  void write(const DeviceCommand& command) noexcept override { this->force_D_ = command.wrench_D.force; }

  /// Where the hand is led to at a time since the start [s], in D.
  [[nodiscard]] Vec3 target(double time_s) const noexcept;

private:
  DeviceInfo info_;
  HandModel model_;
  HandPath path_;
  double period_s_;
  LinearPlant plant_;
  std::vector<double> reached_m_; ///< length of the path up to each point
  Vec3 x_D_ = Vec3::Zero();
  Vec3 v_D_ = Vec3::Zero();
  Vec3 force_D_ = Vec3::Zero();
  double time_s_ = 0.0;
};

} // namespace palpate
