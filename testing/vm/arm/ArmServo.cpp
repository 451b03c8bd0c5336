// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/vm/arm/ArmServo.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>

#include "devices/arm/kit/Kits.h"
#include "devices/hid/HidapiBus.h"
#include "testing/devices/arm/WoodenHapticsModel.h"

namespace palpate::test
{
namespace
{

HidEntry waitForArm(ArmBus& bus, const std::string& serial)
{
  HidEntry found;
  const auto look = [&]
  {
    const std::vector<HidEntry> all = bus.devices();
    const auto it = std::find_if(all.begin(), all.end(), [&](const HidEntry& entry) { return entry.serial == serial; });
    found = it != all.end() ? *it : HidEntry{};
    return it != all.end() && bus.refusal(found).empty();
  };
  if (!waitUntil(look))
  {
    throw std::runtime_error("no arm " + serial + " has come");
  }
  return found;
}

} // namespace

ArmKit systemKit(const std::string& road)
{
  if (road == "woodenhaptics")
  {
    const std::string file = (std::filesystem::temp_directory_path() / "woodenhaptics.json").string();
    std::ofstream(file) << WoodenHapticsModel::file();
    return woodenHapticsKit(systemHidBus(), file);
  }
  return road == "falcon" ? falconKit() : twoDiyKit();
}

ArmServo::ArmServo(const std::string& road, const std::string& serial, const Clock* clock)
  : Ticking(device), kit(systemKit(road)), entry(waitForArm(*kit.bus, serial)),
    device(road, kit.bus, entry, kit.setup, { true, clock })
{
  this->device.prove();
}

bool ArmServo::prepare()
{
  constexpr int patient = 100; // ticks: a person does not press again before it can have been heard
  int ticks = 0;
  return this->runUntil(
    [this, &ticks]
    {
      const std::optional<DeviceStep> step = this->device.step();
      if (step && !step->button.empty() && !step->wantsFile && ticks++ % patient == 0)
      {
        this->device.stepDone("");
      }
      return this->status == DeviceStatus::Ok && !step;
    });
}

void ArmServo::ask(const Vec3& force_N)
{
  this->command = {};
  this->run(30);
  this->command.wrench_D.force = force_N;
}

std::string pushArm(const std::string& road, const std::string& serial)
{
  ArmServo servo(road, serial);
  if (std::string problem = servo.device.open(); !problem.empty())
  {
    return problem;
  }
  while (servo.prepare())
  {
    servo.ask({ 0.6, 0.6, 0.6 });
    static_cast<void>(
      servo.runUntil([&servo] { return servo.status != DeviceStatus::Ok; }, std::numeric_limits<int>::max()));
  }
  return "the arm does not come: " + servo.device.linkReport().lostFor;
}

} // namespace palpate::test
