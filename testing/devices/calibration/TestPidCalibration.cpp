// SPDX-License-Identifier: GPL-3.0-or-later
// A calibration through the whole of a USB link: the reports push where they should.
#include <cmath>
#include <memory>
#include <numbers>

#include <gtest/gtest.h>

#include "devices/calibration/CalibratedDevice.h"
#include "testing/devices/hid/PidRig.h"

namespace palpate
{
namespace
{

using test::PidLayout;

/// A stick whose motors push in the reverse direction, as its calibration says; its own walls were not felt.
class ReversedStick
{
public:
  ReversedStick() : port_(this->bus_->plug(layout(), "1"))
  {
    auto pid = std::make_unique<PidDevice>("pid", this->bus_, this->port_.entry, test::virtualOptions(*this->bus_));
    this->link_ = &pid->link();
    const double half_m = PidScale().halfTravel_m;
    Calibration calibration{ "pid", "1", "2026-01-31", 2, {} };
    calibration.axes[0] = { 0, 1, -half_m, half_m, 0, -1, 0.0, 0.0 };
    calibration.axes[1] = { 1, 1, -half_m, half_m, 1, -1, 0.0, 0.0 };
    this->device_ = std::make_unique<CalibratedDevice>(std::move(pid), calibration);
  }

  /// The force on a hand that stays at one place for a while, in shares of the largest force, in D.
  Vec3 felt(const DeviceCommand& command, const Vec3& at_D)
  {
    EXPECT_EQ(this->device_->open(), "");
    for (int ms = 0; ms < 2000; ++ms)
    {
      DeviceSample sample;
      static_cast<void>(this->device_->read(0.0, sample));
      this->device_->write(command);
      this->port_.device->position = { at_D.x() / PidScale().halfTravel_m, -at_D.y() / PidScale().halfTravel_m };
      this->port_.device->velocity = {};
      static_cast<void>(this->link_->readPass(0));
      if (!this->link_->writePass())
      {
        this->bus_->advance(1);
      }
    }
    const auto force = this->port_.device->force();
    return { force[0], -force[1], 0.0 };
  }

private:
  static PidLayout layout()
  {
    PidLayout layout = test::plainLayout();
    layout.habits.pointsTo = true;
    return layout;
  }

  std::shared_ptr<test::FakeHidBus> bus_ = std::make_shared<test::FakeHidBus>();
  test::FakePort& port_;
  PidLink* link_ = nullptr;
  std::unique_ptr<CalibratedDevice> device_;
};

TEST(PidCalibration, AForceOfTheTickPushesWhereItPoints)
{
  ReversedStick stick;
  DeviceCommand command;
  command.wrench_D.force = Vec3(0.5, -1.0, 0.0);
  const Vec3 felt = stick.felt(command, Vec3::Zero()) * PidScale().maxForce_N;
  EXPECT_LT((felt - command.wrench_D.force).norm(), 2e-3);
}

// The host closes it: it lies along no axis, and the device's own walls were never felt.
TEST(PidCalibration, ADiagonalWallPushesTheHandOutOfIt)
{
  ReversedStick stick;
  const double root = std::numbers::sqrt2 / 2.0, stiffness_N_per_m = 100.0, depth_m = 0.01;
  DeviceCommand command;
  command.wallCount = 1;
  command.walls[0] = { Vec3(root, -root, 0.0), 0.0, stiffness_N_per_m };
  const Vec3 felt = stick.felt(command, -depth_m * command.walls[0].normal_D) * PidScale().maxForce_N;
  EXPECT_LT((felt - stiffness_N_per_m * depth_m * command.walls[0].normal_D).norm(), 2e-3);
}

TEST(PidCalibration, AWallAlongAnAxisPushesTheHandOutOfIt)
{
  for (const Vec3& normal_D : { Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0) })
  {
    ReversedStick stick;
    DeviceCommand command;
    command.wallCount = 1;
    command.walls[0] = { normal_D, 0.0, 100.0 };
    const Vec3 felt = stick.felt(command, -0.01 * normal_D) * PidScale().maxForce_N;
    EXPECT_LT((felt - normal_D).norm(), 2e-3);
  }
}

} // namespace
} // namespace palpate
