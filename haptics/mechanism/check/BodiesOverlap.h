// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "haptics/mechanism/check/MechanismCheck.h"

namespace palpate
{

/// Which rigid and soft bodies share room as they stand, by their names, each pair once. Such as only touch do not;
/// what the hand holds stands nowhere yet. Of surfaces: an edge of one passes through the other, or one lies in the
/// other. Not real-time safe.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> overlapsOf(
  const Mechanism& mechanism, std::span<const MechanismSoft> soft);

} // namespace palpate
