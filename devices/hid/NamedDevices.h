// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "devices/hid/HidConnection.h"

namespace palpate
{

/// Neither maker, product nor serial number tells one from the other.
[[nodiscard]] inline bool sameKind(const HidEntry& a, const HidEntry& b) noexcept
{
  return a.vendor == b.vendor && a.product == b.product && a.serial == b.serial;
}

/// Adds a device that was found and gives it a name for the factory, "ROAD-VENDOR-PRODUCT-SERIAL": the same as long as
/// the same devices are plugged in. One that nothing tells from another gets a number, and both know of their twin.
template<class Found, class Alike>
void addNamed(std::vector<Found>& found, const std::string& road, Found one, Alike alike)
{
  std::array<char, 16> ids{};
  std::snprintf(ids.data(), ids.size(), "-%04x-%04x", one.entry.vendor, one.entry.product);
  one.name = road + ids.data() + (one.entry.serial.empty() ? "" : "-" + one.entry.serial);
  int before = 0;
  for (Found& other : found)
  {
    if (alike(other, one))
    {
      other.hasTwin = one.hasTwin = true;
      ++before;
    }
  }
  one.name += before == 0 ? "" : "-" + std::to_string(before + 1);
  found.push_back(std::move(one));
}

} // namespace palpate
