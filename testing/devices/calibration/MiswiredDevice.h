// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <deque>
#include <limits>

#include "devices/simulated/SimulatedDevice.h"

namespace palpate::test
{

/// Faults between a simulated device and its driver. Nothing by default.
struct Wiring
{
  Mat3 sensors = Mat3::Identity(); ///< from the hand's place to the driver's measurement
  Mat3 motors = Mat3::Identity();  ///< from the driver's force to that of the motors
  double springs = 1.0;            ///< stiffness of the device's own walls, as a share of the command's
  std::array<double, 4> sides{ 1.0, 1.0, 1.0, 1.0 }; ///< besides, each whose normal is x, y, -x, -y
  double brake = 1.0;                                ///< its viscosity, as a share of the command's
  std::size_t late_ticks = 0;                        ///< every command comes so much later
  int failsEach = 0;                                 ///< each such push does nothing; 0: all are as they should be
  double keeps = 1.0;                                ///< of the force from push to push
  Vec3 travel_m = Vec3::Constant(std::numeric_limits<double>::infinity()); ///< positions are stuck beyond +- this
  int lostAfter_ticks = -1;
};

/// A simulated device whose wires are swapped, turned round, weak or cut, led by somebody.
class MiswiredDevice final : public HapticDevice
{
public:
  MiswiredDevice(const DeviceModel& model, const HandModel& hand, const Wiring& wiring);

  [[nodiscard]] const DeviceInfo& info() const noexcept override { return this->info_; }
  [[nodiscard]] std::string open() override { return this->device_.open(); }
  void close() noexcept override {}
  [[nodiscard]] DeviceStatus read(double tickTime_s, DeviceSample& sample) noexcept override;
  void write(const DeviceCommand& command) noexcept override;

  /// Where the person takes the hand, in true directions [m].
  void lead(const Vec3& place_D) noexcept { this->device_.lead(place_D); }
  [[nodiscard]] const DeviceCommand& told() const noexcept { return this->told_; }

private:
  [[nodiscard]] double strengthNow(const DeviceCommand& command) noexcept;

  DeviceInfo info_;
  SimulatedDevice device_;
  Wiring wiring_;
  DeviceCommand told_;
  std::deque<DeviceCommand> onTheWay_;
  int ticks_ = 0, pushes_ = 0;
  bool pushing_ = false;
};

} // namespace palpate::test
