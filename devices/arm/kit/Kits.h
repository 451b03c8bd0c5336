// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "devices/arm/kit/ArmKit.h"
#include "devices/arm/kit/WiredArm.h"
#include "devices/arm/link/Plugs.h"

namespace palpate
{

/// All of these kits, as they are on this computer, and those of the owner's files.
[[nodiscard]] std::vector<ArmKit> systemArmKits();

/// Where arms of known wires are looked for.
struct ArmPlaces
{
  std::shared_ptr<HidBus> hid;  ///< those on USB HID
  std::string sys = "/sys";     ///< serial lines, as the kernel lists them
  FileAccess access = ::access; ///< whether this process may use their files
};

/// The kit of an arm of a known wire; `road`: first word of the names of its devices. Its problem is that of `arm`, and
/// the devices that it names are listed all the same. A board that keeps its torque has a guard.
[[nodiscard]] ArmKit wiredKit(const std::string& road, const Outcome<WiredArm>& arm, const ArmPlaces& places);

/// The kits of an owner's arm files, NAME.json in that folder, by name: an arm file with the object "wire". A file that
/// is wrong is a kit with a problem, which names the file.
[[nodiscard]] std::vector<ArmKit> ownArmKits(const std::string& folder, const ArmPlaces& places);

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

/// Arms of Force Dimension by the vendor's library, which is looked for at run time. Plugs are looked for below `sys`
/// where the library is missing or sees no arm; `access`: whether this process may use their files.
[[nodiscard]] ArmKit forceDimensionKit(
  const std::string& library = "libdhd.so.3", const std::string& sys = "/sys", FileAccess access = ::access);

/// Touch and Phantom arms by OpenHaptics' library, likewise; plugs are looked for below `sys`.
[[nodiscard]] ArmKit openHapticsKit(const std::string& library = "libHD.so", const std::string& sys = "/sys");

/// Haply 2DIY boards on serial lines, likewise.
[[nodiscard]] ArmKit twoDiyKit(const std::string& sys = "/sys", FileAccess access = ::access);
/// The arm of data/arms/pantograph.json.
[[nodiscard]] WiredArm twoDiyArm();

} // namespace palpate
