// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/io/FindAgain.h"

#include <utility>
#include <vector>

namespace palpate
{
namespace
{

bool sameKind(const HidEntry& a, const HidEntry& b) noexcept
{
  return a.vendor == b.vendor && a.product == b.product && a.serial == b.serial;
}

} // namespace

FoundDevice findAgain(HidBus& bus, const HidEntry& wanted)
{
  std::vector<HidEntry> alike;
  for (HidEntry& entry : bus.devices())
  {
    if (sameKind(entry, wanted))
    {
      alike.push_back(std::move(entry));
    }
  }
  const std::string name = "\"" + wanted.name + "\"" + (wanted.serial.empty() ? "" : " " + wanted.serial);
  if (alike.empty())
  {
    return { std::nullopt, name + " is not there: plug it in" };
  }
  for (const HidEntry& entry : alike)
  {
    if (alike.size() == 1 || entry.path == wanted.path)
    {
      return { entry, {} };
    }
  }
  return { std::nullopt,
    "there are " + std::to_string(alike.size()) + " of " + name + " and nothing tells them apart: plug in only one" };
}

} // namespace palpate
