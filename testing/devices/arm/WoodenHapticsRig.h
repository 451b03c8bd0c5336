// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fstream>
#include <memory>

#include "devices/arm/ArmDevice.h"
#include "devices/arm/kit/Kits.h"
#include "testing/devices/arm/ServoSide.h"
#include "testing/devices/arm/WoodenHapticsModel.h"
#include "testing/devices/hid/FakeHidBus.h"
#include "testing/support/TemporaryFolder.h"

namespace palpate::test
{

/// A WoodenHaptics on a bus in virtual time: a tick of the servo, then an exchange.
struct WoodenHapticsRig : ServoSide
{
  using KitOf = ArmKit (*)(const std::shared_ptr<FakeHidBus>& bus, const TemporaryFolder& folder);

  explicit WoodenHapticsRig(bool proven = true, const HidEntry& plug = plugOf(), KitOf kitOf = kitOn)
    : port(bus->plug(model, plug)), kit(kitOf(bus, folder))
  {
    if (proven)
    {
      this->device.prove();
    }
  }

  static HidEntry plugOf() { return { "", WoodenHapticsModel::vendor, WoodenHapticsModel::product, "7", "arm" }; }
  static ArmKit kitOn(const std::shared_ptr<FakeHidBus>& bus, const TemporaryFolder& folder)
  {
    const std::string file = folder.file("woodenhaptics.json");
    std::ofstream(file) << WoodenHapticsModel::file();
    return woodenHapticsKit(bus, file);
  }

  /// Opens it, and a person sets its counters in its pose.
  [[nodiscard]] std::string open()
  {
    std::string problem = this->device.open();
    this->run(5);
    this->device.stepDone("");
    this->run(30);
    return problem;
  }
  void tick() { ServoSide::tick(this->device, this->bus->time().now_ns()); }
  void pass()
  {
    const std::int64_t before_ns = this->bus->time().now_ns();
    static_cast<void>(this->device.link().pass());
    if (this->bus->time().now_ns() == before_ns)
    {
      this->bus->advance(1);
    }
  }
  void run(int duration_ms)
  {
    const std::int64_t until_ns = this->bus->time().now_ns() + duration_ms * std::int64_t{ 1000000 };
    while (this->bus->time().now_ns() < until_ns)
    {
      this->tick();
      this->pass();
    }
  }

  TemporaryFolder folder;
  std::shared_ptr<FakeHidBus> bus = std::make_shared<FakeHidBus>();
  std::shared_ptr<WoodenHapticsModel> model = std::make_shared<WoodenHapticsModel>();
  FakePort& port;
  ArmKit kit;
  ArmDevice device{ "woodenhaptics", kit.bus, port.entry, kit.setup, { false, &bus->time() } };
};

} // namespace palpate::test
