// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "devices/arm/kit/ArmKit.h"
#include "devices/arm/link/Plugs.h"
#include "devices/arm/protocol/TwoDiyWire.h"

namespace palpate
{

/// All of these kits, as they are on this computer.
[[nodiscard]] std::vector<ArmKit> systemArmKits();

/// WoodenHaptics and Polhem arms on USB HID. `file`: the owner's woodenhaptics.json.
[[nodiscard]] ArmKit woodenHapticsKit(const std::shared_ptr<HidBus>& hid, const std::string& file);

/// Novint Falcons on USB, below `sys`. `access`: whether this process may use their files.
[[nodiscard]] ArmKit falconKit(const std::string& sys = "/sys", FileAccess access = ::access);
[[nodiscard]] ArmSetup falconSetup();

/// Where the service of Haply's arms listens on this computer.
struct HaplyPorts
{
  std::uint16_t states = 10001, questions = 10000, events = 10020;
  std::string installed = "/etc/haply-inverse-service"; ///< is there where the service is installed
};
/// Haply Inverse3, Inverse3X and Minverse through that service.
[[nodiscard]] ArmKit haplyKit(const HaplyPorts& ports = {});
/// `type`: as the service calls it; empty: not known yet.
[[nodiscard]] ArmSetup haplySetup(const std::string& type = {});

/// Arms of Force Dimension by the vendor's library, which is looked for at run time.
[[nodiscard]] ArmKit forceDimensionKit(const std::string& library = "libdhd.so.3");

/// Touch and Phantom arms by OpenHaptics' library, likewise; plugs are looked for below `sys`.
[[nodiscard]] ArmKit openHapticsKit(const std::string& library = "libHD.so", const std::string& sys = "/sys");

/// Haply 2DIY boards on serial lines, likewise.
[[nodiscard]] ArmKit twoDiyKit(const std::string& sys = "/sys", FileAccess access = ::access);
[[nodiscard]] ArmSetup twoDiySetup();
[[nodiscard]] TwoDiyWire::Setup twoDiyBoard();
/// Sets the board up, with a guard beside it.
[[nodiscard]] ArmBus::Opened openTwoDiy(const std::string& path);

} // namespace palpate
