// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "haptics/session/settings/Setting.h"
#include "haptics/tick/HapticParameters.h"

namespace palpate
{

/// Settings that are a field of a stage's plan, found by the name under which the field is recorded. A rotation is (w,
/// x, y, z), a switch 0 or 1. All of them throw std::logic_error where the table names no such field.

/// The field of `setting` gets these values, which the setting allows; a rotation gets its unit length.
void setField(HapticParameters& parameters, const Setting& setting, std::span<const double> values);

[[nodiscard]] std::vector<double> fieldOf(const HapticParameters& parameters, const Setting& setting);

/// Initial values of a session: the table's default in every field that a setting names, the stages' own in the others.
[[nodiscard]] HapticParameters sessionDefaults();

} // namespace palpate
