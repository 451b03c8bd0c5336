// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fstream>
#include <string>
#include <vector>

#include "devices/arm/kit/Kits.h"
#include "testing/devices/arm/FakeSys.h"
#include "testing/devices/arm/TwoDiyModel.h"
#include "testing/devices/hid/FakeHidBus.h"
#include "testing/support/TemporaryFolder.h"

namespace palpate::test
{

/// A pantograph of other lengths than those of the 2DIY, behind gears, wired the other way round in part.
inline std::string ownPantograph()
{
  return R"({ "format": "palpate arm", "version": 1, "name": "My pantograph", "kind": "five-bar",
  "base_m": 0.04, "arm_m": 0.06, "forearm_m": 0.09, "at_m": [0.02, 0, 0],
  "joints": [
    { "low_deg": 60, "high_deg": 240, "zero_deg": 135, "counts_per_turn": 4000, "gear": -2, "max_torque_Nm": 0.1 },
    { "low_deg": -60, "high_deg": 120, "zero_deg": 45, "counts_per_turn": 4000, "gear": 4, "max_torque_Nm": 0.1 }
  ],
  "work_space": { "centre_m": [0.02, 0.11, 0], "radius_m": 0.025 },
  "wire": { "protocol": "2diy", "usb": ["16d0:1234"], "pose": "Hold both arms against their pegs.", "device": 7,
    "motors_turned": [true, false], "encoders_turned": [false, true] } })";
}

/// Its mechanics and its wiring.
inline TwoDiyBody ownPantographBody()
{
  TwoDiyBody body{ 0.06, 0.09, 0.04, { 135.0, 45.0 }, { -2.0, 4.0 }, 4000.0, { true, false }, { false, true } };
  return body;
}

/// A WoodenHaptics of 2015 with other motors and other USB numbers.
inline std::string ownWoodenHaptics()
{
  return R"({ "format": "palpate arm", "version": 1, "name": "My wooden arm", "kind": "woodenhaptics",
  "column_m": 0.08, "upper_m": 0.205, "fore_m": 0.245, "at_m": [-0.22, 0, -0.08],
  "joints": [
    { "counts_per_turn": 2000, "gear": 16, "torque_constant_Nm_per_A": 0.02, "low_deg": -100, "high_deg": 100 },
    { "counts_per_turn": 2000, "gear": 12, "torque_constant_Nm_per_A": 0.03, "low_deg": -80, "high_deg": 80 },
    { "counts_per_turn": 2000, "gear": 12, "torque_constant_Nm_per_A": 0.05, "low_deg": -10, "high_deg": 170,
      "calibrated": 6000 }
  ],
  "work_space": { "radius_m": 0.1 }, "max_force_N": 5,
  "wire": { "protocol": "woodenhaptics", "usb": ["16d0:0f4c"], "serial": "7", "pose": "Fold the arm." } })";
}

/// The text with one part changed, which must be there.
inline std::string with(std::string text, const std::string& old, const std::string& fresh)
{
  const std::size_t at = text.find(old);
  return at == std::string::npos ? "there is no " + old : text.replace(at, old.size(), fresh);
}

/// An owner's folder of arms, and the attached devices.
struct OwnArms
{
  void write(const std::string& name, const std::string& text) const { std::ofstream(this->folder.file(name)) << text; }
  /// The kits that are built in for both protocols, and those of the files.
  [[nodiscard]] std::vector<ArmKit> kits() const
  {
    std::vector<ArmKit> all{ woodenHapticsKit(this->hid, this->folder.file("none")),
      twoDiyKit(this->sys.path(), mayUse) };
    for (ArmKit& own : ownArmKits(this->folder.path(), { this->hid, this->sys.path(), mayUse }))
    {
      all.push_back(std::move(own));
    }
    return all;
  }
  /// Names of the arms that are found, each with its problem.
  [[nodiscard]] std::vector<std::string> found() const
  {
    std::vector<std::string> lines;
    const std::vector<ArmKit> all = this->kits();
    for (const FoundArm& arm : findArms(all))
    {
      lines.push_back(arm.name + (arm.problem.empty() ? "" : ": " + arm.problem));
    }
    return lines;
  }

  static int mayUse(const char*, int) { return 0; }

  TemporaryFolder folder;
  FakeSys sys;
  std::shared_ptr<FakeHidBus> hid = std::make_shared<FakeHidBus>();
};

} // namespace palpate::test
