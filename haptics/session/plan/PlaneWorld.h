// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "haptics/core/DeviceInfo.h"
#include "haptics/force/StabilityLimits.h"
#include "haptics/session/settings/AutoChoice.h"
#include "haptics/tick/HapticParameters.h"

namespace palpate
{

/// Settings of a person in a plane world.
struct PlaneWishes
{
  bool holdWalls = true; ///< by the device, where it can
  bool guide = true;     ///< to the plane
};

/// Whether lines that lie in a plane are walls across it, for that device.
[[nodiscard]] bool raisesLines(AutoChoice choice, const DeviceInfo& device) noexcept;

/// The parameters with the guide to the plane that all that is touched stands across, and with walls that a device
/// which moves in that plane may hold; with neither where there is none (nothing). No guide pushes a device that has no
/// motor in that direction.
[[nodiscard]] HapticParameters inPlane(HapticParameters parameters, const std::optional<Pose>& plane_WP,
  const PlaneWishes& wishes, const DeviceInfo& device);

/// Stiffness that a hand feels with these parameters: no more than the device can hold [N/m].
[[nodiscard]] double feltStiffness_N_per_m(
  const HapticParameters& parameters, const DeviceInfo& device, const StabilityLimits& limits) noexcept;

/// Mean braking force of a device's walls on a slide of 0.1 m/s along a line that leans by 45 degrees [N].
[[nodiscard]] double slantDrag_N(const HapticParameters& parameters, double stiffness_N_per_m, double period_s);

/// Who closes the walls of a plane world, why, and whether the hand is led to it: the end of the plan's sentence.
/// `whyNotHeld`: why walls are not left to a device that offers to hold them; `drag_N`: slantDrag_N().
[[nodiscard]] std::string planeText(const HapticParameters& parameters, const PlaneWishes& wishes,
  const DeviceInfo& device, double drag_N, const std::string& whyNotHeld);

} // namespace palpate
