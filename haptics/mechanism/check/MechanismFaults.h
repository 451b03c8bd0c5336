// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/mechanism/check/MechanismCheck.h"

namespace palpate
{

/// The faults of bodies and constraints one by one, a sentence each.
[[nodiscard]] std::vector<std::string> faultsOf(const Mechanism& mechanism, std::span<const MechanismSoft> soft);

/// The point of a soft body's surface that is nearest to p_W, at rest.
[[nodiscard]] SurfacePoint nearestPlace(const PressedBody& body, const Vec3& p_W);

/// By its name, or null.
[[nodiscard]] const MechanismSoft* softNamed(std::span<const MechanismSoft> soft, const std::string& name);

/// By its name, or -1.
[[nodiscard]] int bodyNamed(const Mechanism& mechanism, const std::string& name);

} // namespace palpate
