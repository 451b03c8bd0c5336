// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace palpate
{

/// A folder of a person's settings of Palpate, "calibration" or "arms", from the values of XDG_CONFIG_HOME and HOME
/// (null: not set), as the XDG Base Directory Specification says; empty: nowhere.
[[nodiscard]] std::string userFolder(const char* xdgConfigHome, const char* home, const std::string& name);

} // namespace palpate
