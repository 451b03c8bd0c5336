// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "devices/arm/ArmLine.h"
#include "devices/arm/ArmSetup.h"
#include "devices/arm/link/Plugs.h"

namespace palpate
{

/// A file of an owner that says which devices are its arm.
struct ArmClaim
{
  std::string file;
  UsbDevices devices;
};

/// One kind of arm to look for: the places to look in, and its properties.
struct ArmKit
{
  std::string road; ///< first word of the names of its devices
  std::shared_ptr<ArmBus> bus;
  ArmSetup setup;
  std::function<bool()> isPlugged = {}; ///< tells whether a listed arm is attached; null: every listed one is
  std::function<ArmSetup(const HidEntry&)> setupOf = {}; ///< of one arm, where the arms differ; null: `setup` of all
  std::optional<ArmClaim> claim = {};                    ///< none: the kit is built in
};

/// An arm that is attached, as far as is known, usable or not.
struct FoundArm
{
  std::string name; ///< for the factory: the same as long as the same devices are plugged in
  HidEntry entry;
  const ArmKit* kit = nullptr;
  ArmSetup setup;         ///< of this arm
  std::string problem;    ///< empty, or the reason why it cannot be used, and the remedy
  std::string note;       ///< of a usable arm: empty, or the step of a person that it awaits before it pushes
  bool hasTwin = false;   ///< another one is attached that neither kind nor serial number tells apart
  bool isAssumed = false; ///< nothing shows that it is attached
};

/// The arms of these kits that are attached. A device that an owner's file names belongs to that file alone; a file
/// with a serial number goes before one without. A file with a problem is told also where no device of it is attached.
/// Tells no device anything.
[[nodiscard]] std::vector<FoundArm> findArms(const std::vector<ArmKit>& kits);

/// True if one of these files names the device.
[[nodiscard]] bool isClaimed(const std::vector<ArmKit>& kits, const HidEntry& entry);

} // namespace palpate
