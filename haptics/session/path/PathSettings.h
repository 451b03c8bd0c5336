// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>

#include "haptics/session/settings/SettingStore.h"
#include "haptics/tick/HapticParameters.h"

namespace palpate
{

/// Settings of a session that are felt along a path as well. In every sentence of this folder a setting stands by its
/// name in braces, "{Radius}", which the caller replaces by the name in its interface.

[[nodiscard]] bool isOfPath(const Setting& setting);

/// The sentence with the interface's name of each setting in place of its name in braces.
[[nodiscard]] std::string withNames(std::string sentence, const std::function<std::string(std::string_view)>& known);

/// Whether curves are walls in the plane z = 0.
[[nodiscard]] bool areWalls(const SettingStore& settings);

/// All settings, with the defaults of a path.
[[nodiscard]] SettingStore pathSettings();

/// "", or the first setting of a path with a value that cannot be.
[[nodiscard]] std::string refusePathSettings(const SettingStore& settings);

/// "", or the first setting of a path, in braces, that is neither among `felt` nor as it is by default.
[[nodiscard]] std::string setBeside(const SettingStore& settings, std::initializer_list<std::string_view> felt);
/// Likewise the first that is among these.
[[nodiscard]] std::string setAmong(const SettingStore& settings, std::initializer_list<std::string_view> unfelt);

/// The tick's parameters. The path is given in the scene, so that device frame and scene are one and a metre is a unit:
/// the scale enters through the stiffness alone. Dividing the path by the scale and multiplying it again would move the
/// hand by its rounding.
[[nodiscard]] HapticParameters pathParameters(const SettingStore& settings);

} // namespace palpate
