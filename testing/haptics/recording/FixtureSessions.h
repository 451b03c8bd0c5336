// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace palpate::test
{

/// A hand on surfaces: friction, texture, shading, a ball, scenes that are replaced, move and bend, bad samples, a late
/// loop, a device that waits and one that is lost. Returns empty, or the fault.
[[nodiscard]] std::string recordSolid(const std::string& path);

/// A hand on lines in a plane: the guide to it, a labyrinth's game with walls of the host and of the device, and a
/// button that is let go. Returns empty, or the fault.
[[nodiscard]] std::string recordPlane(const std::string& path);

} // namespace palpate::test
