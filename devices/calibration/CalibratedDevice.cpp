// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/calibration/CalibratedDevice.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "devices/common/HeldTrust.h"

namespace palpate
{
namespace
{

/// Axes that nobody checked stay as they are; those of a wheel beside its one move and push nothing.
Mat3 unchecked(const Calibration& calibration)
{
  return calibration.axisCount == 1 ? Mat3(Mat3::Zero()) : Mat3(Mat3::Identity());
}

Mat3 sensorsOf(const Calibration& calibration)
{
  Mat3 sensors = unchecked(calibration);
  for (int i = 0; i < calibration.axisCount; ++i)
  {
    const AxisCalibration& axis = calibration.axes[static_cast<std::size_t>(i)];
    sensors.row(i).setZero();
    sensors(i, axis.sensor) = axis.sensorSign;
  }
  return sensors;
}

Mat3 motorsOf(const Calibration& calibration)
{
  Mat3 motors = unchecked(calibration);
  for (int i = 0; i < calibration.axisCount; ++i)
  {
    const AxisCalibration& axis = calibration.axes[static_cast<std::size_t>(i)];
    motors.col(i).setZero();
    motors(axis.motor, i) = axis.motorSign;
  }
  return motors;
}

Vec3 middleOf(const Calibration& calibration)
{
  Vec3 middle_D = Vec3::Zero();
  for (int i = 0; i < calibration.axisCount; ++i)
  {
    const AxisCalibration& axis = calibration.axes[static_cast<std::size_t>(i)];
    middle_D[i] = 0.5 * axis.sensorSign * (axis.low_m + axis.high_m);
  }
  return middle_D;
}

} // namespace

DeviceInfo calibratedInfo(DeviceInfo info, const Calibration& calibration)
{
  double radius_m = std::numeric_limits<double>::infinity();
  for (int i = 0; i < calibration.axisCount; ++i)
  {
    const AxisCalibration& axis = calibration.axes[static_cast<std::size_t>(i)];
    radius_m = std::min(radius_m, 0.5 * (axis.high_m - axis.low_m));
  }
  info.workspaceRadius_m = { radius_m, true };
  if (!info.simulated)
  {
    info.heldProof = calibration.held;
    info.abilities.holdsWalls = info.abilities.viscous = info.offersWalls && calibration.held == HeldProof::Felt;
  }
  return calibration.axisCount == 1 ? asWheel(info) : info;
}

DeviceInfo asWheel(DeviceInfo info)
{
  if (info.deviceClass == DeviceClass::Joystick2D && !info.knowsAxes)
  {
    info.deviceClass = DeviceClass::Wheel1D;
    info.abilities.sensedAxes = 1;
  }
  return info;
}

Calibration wheelCalibration(const DeviceInfo& info, const std::string& date)
{
  Calibration wheel{ info.name, info.serial, date, 1, {} };
  const double radius_m = info.workspaceRadius_m.value;
  wheel.axes[0] = { 0, 1, -radius_m, radius_m, 0, 1, 0.0, 0.0 };
  return wheel;
}

CalibratedDevice::CalibratedDevice(std::unique_ptr<HapticDevice> device, const Calibration& calibration)
  : device_(std::move(device)), calibration_(calibration), info_(calibratedInfo(this->device_->info(), calibration)),
    sensors_(sensorsOf(calibration)), motors_(motorsOf(calibration)), middle_D_(middleOf(calibration))
{
  if (auto* const holder = dynamic_cast<WallHolder*>(this->device_.get()))
  {
    const bool felt = calibration.held == HeldProof::Felt;
    holder->trust({ felt, felt });
  }
}

std::string CalibratedDevice::open()
{
  std::string problem = this->device_->open();
  // Some devices know their abilities only once they are open.
  this->info_ = calibratedInfo(this->device_->info(), this->calibration_);
  return problem;
}

DeviceStatus CalibratedDevice::read(double tickTime_s, DeviceSample& sample) noexcept
{
  const DeviceStatus status = this->device_->read(tickTime_s, sample);
  if (status != DeviceStatus::Ok)
  {
    return status; // the sample is still that of before, calibrated then
  }
  sample.pose_D.p = (this->sensors_ * sample.pose_D.p - this->middle_D_).eval();
  sample.velocity_D.linear = (this->sensors_ * sample.velocity_D.linear).eval();
  sample.sensed_D.force = (this->sensors_ * sample.sensed_D.force).eval();
  return status;
}

void CalibratedDevice::write(const DeviceCommand& command) noexcept
{
  DeviceCommand raw = command;
  raw.wrench_D.force = this->motors_ * command.wrench_D.force;
  // A torque turns the other way where an axis is turned round.
  raw.wrench_D.torque = this->motors_.determinant() * this->motors_ * command.wrench_D.torque;
  raw.target.pose_D.p = this->sensors_.transpose() * (command.target.pose_D.p + this->middle_D_);
  raw.wallMotors = this->motors_ * command.wallMotors * this->sensors_;
  // The device measures its own walls along its own axes.
  for (std::size_t i = 0; i < std::min<std::size_t>(raw.wallCount, raw.walls.size()); ++i)
  {
    const DeviceWall& wall = command.walls[i];
    raw.walls[i].normal_D = this->sensors_.transpose() * wall.normal_D;
    raw.walls[i].offset_m = wall.offset_m + wall.normal_D.dot(this->middle_D_);
  }
  this->device_->write(raw);
}

} // namespace palpate
