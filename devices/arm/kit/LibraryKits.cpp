// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdlib>
#include <utility>

#include "devices/arm/ListedArmBus.h"
#include "devices/arm/kit/Kits.h"
#include "devices/arm/library/DhdLine.h"
#include "devices/arm/library/HdLine.h"
#include "devices/arm/link/Plugs.h"

namespace palpate
{
namespace
{

/// Arms that the library sees; where it is missing or sees none, the plugs, so that the reason is reported.
std::vector<HidEntry> listDhd(const DhdFunctions& dhd, const UsbIds& plugs, const std::string& sys)
{
  const int count = dhd.library.problem().empty() ? dhd.count() : 0;
  std::vector<HidEntry> all = count > 0 ? std::vector<HidEntry>() : usbPlugs(plugs, sys);
  for (int i = 0; i < count; ++i)
  {
    all.push_back({ std::to_string(i), plugs.front().first, 0, "", "Force Dimension device" });
  }
  return all;
}

/// A plug has the path of a file, an arm that the library sees its number there.
std::string refuseDhd(const DhdFunctions& dhd, const HidEntry& entry, FileAccess access)
{
  if (!dhd.library.problem().empty() || !entry.path.starts_with('/'))
  {
    return dhd.library.problem();
  }
  const std::string file = fileRefusal(entry.path, access);
  return !file.empty() ? file : "the vendor's library does not see the device: plug the device in again";
}

ArmBus::Opened openDhd(const std::shared_ptr<DhdFunctions>& dhd, const HidEntry& entry, FileAccess access)
{
  std::string problem = refuseDhd(*dhd, entry, access);
  return problem.empty() ? DhdLine::open(dhd, std::atoi(entry.path.c_str())) : ArmBus::Opened{ nullptr, problem };
}

} // namespace

ArmKit forceDimensionKit(const std::string& library, const std::string& sys, FileAccess access)
{
  constexpr double omegaRadius_m = 0.075, omegaForce_N = 12.0;
  const auto dhd = std::make_shared<DhdFunctions>(library);
  const UsbIds plugs{ { 0x1451, 0 } };
  ArmSetup setup;
  setup.what = "Force Dimension omega, delta, sigma or lambda";
  setup.turns = true;
  setup.radius_m = { omegaRadius_m, false };
  setup.force_N = { omegaForce_N, false };
  setup.grips = dhd->gripper != nullptr; // which arms have a gripper is known once they are opened
  return { "dhd",
    std::make_shared<ListedArmBus>(ListedArmBus::Ways{ [dhd, plugs, sys] { return listDhd(*dhd, plugs, sys); },
      [dhd, access](const HidEntry& entry) { return openDhd(dhd, entry, access); },
      [dhd, access](const HidEntry& entry) { return refuseDhd(*dhd, entry, access); } }),
    std::move(setup) };
}

ArmKit openHapticsKit(const std::string& library, const std::string& sys)
{
  constexpr double touchRadius_m = 0.06, touchForce_N = 3.3;
  const auto hd = std::make_shared<HdFunctions>(library);
  const UsbIds plugs{ { 0x0301, 0x2988 } };
  ArmSetup setup;
  setup.what = "3D Systems Touch, Sensable Phantom";
  setup.turns = true;
  setup.radius_m = { touchRadius_m, false };
  setup.force_N = { touchForce_N, false };
  setup.pacing = Pacing::Callback;
  setup.period_s = 0.0; // the scheduler's calls are waited for
  // Whether a device is there is known once it is opened, for some are on Ethernet: the vendor's default one is offered
  // where the library is, but nobody's first choice without a plug.
  const auto list = [hd, plugs, sys]
  {
    return hd->library.found()
             ? std::vector<HidEntry>{ { "default", 0x0301, 0x2988, "", "the vendor's default device" } }
             : usbPlugs(plugs, sys);
  };
  return { "openhaptics",
    std::make_shared<ListedArmBus>(ListedArmBus::Ways{ list, [hd](const HidEntry&) { return HdLine::open(hd, ""); },
      [hd](const HidEntry&) { return hd->library.problem(); } }),
    std::move(setup), [plugs, sys] { return !usbPlugs(plugs, sys).empty(); } };
}

} // namespace palpate
