// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "haptics/session/settings/Setting.h"

namespace palpate
{

/// All that can be set of a session, in the order in which a state file applies it. Validation, panel and program take
/// it from here; a test compares properties and user guide with it (plugin.properties).
[[nodiscard]] std::span<const Setting> sessionSettings();

/// All that a session says of itself.
[[nodiscard]] std::span<const Readout> sessionReadouts();

/// One of sessionSettings() by its name, which must be known.
[[nodiscard]] const Setting& sessionSetting(std::string_view name);

/// One of sessionSettings() by its name; null: there is none.
[[nodiscard]] const Setting* findSetting(std::string_view name);

/// Both tables as one JSON object, {"settings": [...], "readouts": [...]}.
[[nodiscard]] std::string describedAsJson();

} // namespace palpate
