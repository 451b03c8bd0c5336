// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdlib>

#include "devices/arm/kit/Kits.h"
#include "devices/hid/HidapiBus.h"

namespace palpate
{

std::vector<ArmKit> systemArmKits()
{
  const char* const home = std::getenv("HOME");
  return { woodenHapticsKit(systemHidBus(), std::string(home != nullptr ? home : "") + "/woodenhaptics.json"),
    haplyKit(), falconKit(), forceDimensionKit(), openHapticsKit(), twoDiyKit() };
}

} // namespace palpate
