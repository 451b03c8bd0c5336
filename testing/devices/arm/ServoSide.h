// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/arm/ArmDevice.h"
#include "testing/devices/arm/ModelTime.h"

namespace palpate::test
{

/// The servo's side of a test of an arm, in virtual time.
struct ServoSide
{
  /// A tick reads and writes once.
  void tick(ArmDevice& device, std::int64_t now_ns)
  {
    this->status = device.read(1e-9 * static_cast<double>(now_ns), this->sample);
    this->lostTicks += this->status == DeviceStatus::Lost ? 1 : 0;
    device.write(this->command);
  }
  /// A tick and an exchange, so many times. An exchange takes a millisecond, one without an answer as long as the link
  /// waits for it.
  void exchange(ArmDevice& device, ModelTime& time, int times)
  {
    for (int i = 0; i < times; ++i)
    {
      this->tick(device, time.now_ns());
      const std::uint64_t before = device.link().answers();
      static_cast<void>(device.link().pass());
      time.pass(device.link().answers() != before ? perMs_ns : ArmLink::answer_ms * perMs_ns);
    }
  }

  DeviceCommand command;
  DeviceSample sample;
  DeviceStatus status = DeviceStatus::Ok;
  int lostTicks = 0;
};

/// A person lets go of all force, then this is asked for and `run_ms` go by.
template<class Rig>
void ask(Rig& rig, const Vec3& force_N, int run_ms = 50)
{
  rig.command = {};
  rig.run(5);
  rig.command.wrench_D.force = force_N;
  rig.run(run_ms);
}

} // namespace palpate::test
