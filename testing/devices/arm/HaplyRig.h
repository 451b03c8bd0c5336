// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/arm/ArmDevice.h"
#include "devices/arm/kit/Kits.h"
#include "testing/devices/arm/FakeService.h"
#include "testing/devices/arm/ServoSide.h"

namespace palpate::test
{

/// An arm of that service: a tick of the servo, then an exchange, of a millisecond of the link's clock each.
struct HaplyRig : ServoSide
{
  HaplyRig() { this->device.prove(); }

  void run(int exchanges) { this->exchange(this->device, this->time, exchanges); }

  FakeService service;
  FakeService::Says says;
  ModelTime time;
  HaplyPorts ports{ service.port(), service.questionPort(), service.eventPort(), "/nowhere" };
  ArmKit kit = haplyKit(ports);
  ArmDevice device{ "haply", kit.bus, { "049D", 0, 0, "049D", "Haply inverse3" }, kit.setup, { false, &time } };
};

} // namespace palpate::test
