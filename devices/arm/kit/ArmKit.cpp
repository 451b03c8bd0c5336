// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/arm/kit/ArmKit.h"

#include <algorithm>
#include <utility>

#include "devices/hid/NamedDevices.h"

namespace palpate
{

std::vector<FoundArm> findArms(const std::vector<ArmKit>& kits)
{
  std::vector<FoundArm> found;
  for (const ArmKit& kit : kits)
  {
    std::vector<HidEntry> entries = kit.bus->devices();
    std::sort(entries.begin(), entries.end(), [](const HidEntry& a, const HidEntry& b) { return a.path < b.path; });
    const bool isAssumed = kit.isPlugged && !kit.isPlugged();
    for (HidEntry& entry : entries)
    {
      std::string problem = kit.setup.problem.empty() ? kit.bus->refusal(entry) : kit.setup.problem;
      std::string note = problem.empty() ? kit.bus->note(entry) : std::string();
      ArmSetup setup = kit.setupOf ? kit.setupOf(entry) : kit.setup;
      FoundArm arm{ {}, std::move(entry), &kit, std::move(setup), std::move(problem), std::move(note) };
      arm.isAssumed = isAssumed;
      addNamed(found, kit.road, std::move(arm),
        [](const FoundArm& a, const FoundArm& b) { return a.kit == b.kit && sameKind(a.entry, b.entry); });
    }
  }
  return found;
}

} // namespace palpate
