// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "devices/arm/HidArmBus.h"
#include "devices/arm/kit/Kits.h"
#include "devices/arm/kit/WoodenHapticsFile.h"
#include "devices/arm/protocol/WoodenHapticsWire.h"
#include "devices/common/AttributeFile.h"

namespace palpate
{
namespace
{

/// An mbed has reports as long as the message; a Teensy always sends 64 bytes and has a part for text beside it.
std::size_t reportBytes(const HidEntry& entry)
{
  constexpr std::size_t teensyBytes = 64;
  constexpr HidUsage textPage = 0xFFC9;
  const bool mbed = entry.vendor == 0x1234 && entry.product == 0x0006;
  const bool teensy = entry.vendor == 0x16C0 && entry.product == 0x0486 && entry.usage >> 16U != textPage;
  return mbed ? WoodenHapticsWire::length : teensy ? teensyBytes : 0;
}

} // namespace

ArmKit woodenHapticsKit(const std::shared_ptr<HidBus>& hid, const std::string& file)
{
  const std::string text = contentOf(file);
  Outcome<WoodenHapticsArm> arm =
    !text.empty()
      ? readWoodenHapticsFile(text)
      : Outcome<WoodenHapticsArm>{ {}, "it is missing or empty: put the file that came with the arm there" };
  ArmKit kit;
  kit.road = "woodenhaptics";
  kit.bus =
    std::make_shared<HidArmBus>(hid, std::make_shared<WoodenHapticsWire>(arm.value.constants_Nm_per_A), reportBytes);
  kit.setup = std::move(arm.value.setup);
  kit.setup.what = "WoodenHaptics or Polhem arm";
  kit.setup.problem = arm.ok() ? "" : "the arm's geometry cannot be read from " + file + ": " + arm.problem;
  return kit;
}

} // namespace palpate
