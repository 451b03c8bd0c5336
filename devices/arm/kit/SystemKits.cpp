// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdlib>
#include <iterator>

#include "devices/arm/kit/Kits.h"
#include "devices/common/UserFolder.h"
#include "devices/hid/HidapiBus.h"

namespace palpate
{

std::vector<ArmKit> systemArmKits()
{
  const char* const home = std::getenv("HOME");
  const std::shared_ptr<HidBus> hid = systemHidBus();
  std::vector<ArmKit> kits{ woodenHapticsKit(hid, std::string(home != nullptr ? home : "") + "/woodenhaptics.json"),
    haplyKit(), falconKit(), forceDimensionKit(), openHapticsKit(), twoDiyKit() };
  std::vector<ArmKit> own = ownArmKits(userFolder(std::getenv("XDG_CONFIG_HOME"), home, "arms"), { hid });
  kits.insert(kits.end(), std::make_move_iterator(own.begin()), std::make_move_iterator(own.end()));
  return kits;
}

} // namespace palpate
