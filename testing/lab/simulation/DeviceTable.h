// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "testing/lab/simulation/FreeDevice.h"

namespace palpate::lab
{

/// One of the simulated devices a person can pick, D0 to D6.
struct TableDevice
{
  std::string id;
  FreeDevice model;
};

[[nodiscard]] std::vector<TableDevice> tableDevices();

} // namespace palpate::lab
