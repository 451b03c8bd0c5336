// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/arm/kit/ArmKit.h"

#include <algorithm>
#include <utility>

#include "devices/hid/NamedDevices.h"

namespace palpate
{
namespace
{

using Entries = std::vector<HidEntry>;

/// How closely a kit names a device: 0 for a kit that is built in, or that does not name it.
int closeness(const ArmKit& kit, const HidEntry& entry)
{
  const std::optional<ArmClaim>& claim = kit.claim;
  return !claim || !claim->devices.have(entry) ? 0 : claim->devices.serial.empty() ? 1 : 2;
}

/// The kit that names a device most closely, the first among equals; at least one.
std::size_t closestOf(const std::vector<ArmKit>& kits, const HidEntry& entry)
{
  const auto closest = std::max_element(kits.begin(), kits.end(),
    [&entry](const ArmKit& a, const ArmKit& b) { return closeness(a, entry) < closeness(b, entry); });
  return static_cast<std::size_t>(closest - kits.begin());
}

std::vector<Entries> listAll(const std::vector<ArmKit>& kits)
{
  std::vector<Entries> all;
  for (const ArmKit& kit : kits)
  {
    all.push_back(kit.bus->devices());
    std::sort(all.back().begin(), all.back().end(), [](const auto& a, const auto& b) { return a.path < b.path; });
  }
  return all;
}

FoundArm armOf(const ArmKit& kit, const HidEntry& entry)
{
  FoundArm arm{ {}, entry, &kit, kit.setupOf ? kit.setupOf(entry) : kit.setup, kit.setup.problem, {} };
  arm.problem = arm.problem.empty() ? kit.bus->refusal(entry) : arm.problem;
  arm.note = arm.problem.empty() ? kit.bus->note(entry) : "";
  return arm;
}

void add(std::vector<FoundArm>& found, FoundArm arm)
{
  const std::string road = arm.kit->road;
  addNamed(found, road, std::move(arm),
    [](const FoundArm& a, const FoundArm& b) { return a.kit == b.kit && sameKind(a.entry, b.entry); });
}

/// A device that one kit lists and a file of another kit names: it is that file's, as far as the file's kit lists it.
void addClaimed(std::vector<FoundArm>& found, const ArmKit& owner, const Entries& ofOwner, const HidEntry& entry)
{
  const auto isIt = [&entry](const HidEntry& other) { return sameKind(entry, other); };
  if (std::none_of(ofOwner.begin(), ofOwner.end(), isIt))
  {
    const std::string elsewhere =
      owner.claim->file + ": this device is attached, but not where the protocol of the file looks for it";
    const std::string& wrong = owner.setup.problem;
    add(found, { {}, entry, &owner, owner.setup, wrong.empty() ? elsewhere : wrong, {} });
  }
}

/// A file that is wrong, where no device of it is attached.
void addFile(std::vector<FoundArm>& found, const ArmKit& kit)
{
  const auto isOfIt = [&kit](const FoundArm& arm) { return arm.kit == &kit; };
  if (kit.claim && !kit.setup.problem.empty() && std::none_of(found.begin(), found.end(), isOfIt))
  {
    found.push_back({ kit.road, {}, &kit, kit.setup, kit.setup.problem, {} });
  }
}

} // namespace

std::vector<FoundArm> findArms(const std::vector<ArmKit>& kits)
{
  std::vector<FoundArm> found;
  const std::vector<Entries> listed = listAll(kits);
  for (std::size_t k = 0; k < kits.size(); ++k)
  {
    const ArmKit& kit = kits[k];
    const bool isAssumed = kit.isPlugged && !kit.isPlugged();
    for (const HidEntry& entry : listed[k])
    {
      const std::size_t closest = closestOf(kits, entry);
      const ArmKit& owner = kits[closest];
      if (closeness(owner, entry) > closeness(kit, entry))
      {
        addClaimed(found, owner, listed[closest], entry);
        continue;
      }
      FoundArm arm = armOf(kit, entry);
      arm.isAssumed = isAssumed;
      if (kit.claim && &owner != &kit && kit.setup.problem.empty())
      {
        arm.problem = kit.claim->file + ": " + owner.claim->file +
                      " names this device, too: remove one of the two, or give each the serial number of its device";
      }
      add(found, std::move(arm));
    }
    addFile(found, kit);
  }
  return found;
}

bool isClaimed(const std::vector<ArmKit>& kits, const HidEntry& entry)
{
  return std::any_of(kits.begin(), kits.end(), [&entry](const ArmKit& kit) { return closeness(kit, entry) > 0; });
}

} // namespace palpate
