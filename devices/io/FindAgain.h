// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "devices/hid/HidConnection.h"

namespace palpate
{

/// Which of the devices that are there is meant: the one with that serial number; without one, the only one of its
/// kind.
struct FoundDevice
{
  std::optional<HidEntry> entry;
  std::string problem;
};
[[nodiscard]] FoundDevice findAgain(HidBus& bus, const HidEntry& wanted);

} // namespace palpate
