// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include "haptics/contact/GodObject.h"
#include "haptics/force/DeviceWalls.h"
#include "haptics/force/WorkspaceMap.h"
#include "haptics/geometry/scene/Scene.h"

namespace palpate
{

/// The walls that a device holds, from tick to tick.
struct DeviceWallState
{
  AxisWalls walls;
  double since_s = std::numeric_limits<double>::infinity(); ///< since walls were looked for; infinite: none stand
  double stiffness_N_per_m = 0.0;                           ///< that the walls were given last
  double each_N = std::numeric_limits<double>::infinity();  ///< largest force of one wall then
};

/// Data of a tick after contact.
struct WallTick
{
  const Scene& scene;
  const ContactPlan& contact;
  const GodObjectState& state; ///< position of the virtual location and its contacts
  const WorkspaceMap& map;
  Vec3 handle_D = Vec3::Zero();   ///< [m]
  double stiffness_N_per_m = 0.0; ///< of the walls
  double maxRise_N_per_s = std::numeric_limits<double>::infinity();
  double dt_s = 1e-3;
  double share = 1.0; ///< of the motion between its snapshots, where the scene moves
};

/// The walls round the virtual location: those it touches, and along each of the device's four directions the first
/// line that is met within `reach_m` of it. Real-time safe; four sweeps.
[[nodiscard]] AxisWalls lookForWalls(const WallTick& tick, double reach_m, std::uint32_t& nodes) noexcept;

/// Renews the walls once their time has come. A wall enters the hand no further than adds, at its stiffness, the force
/// that may be added in the time since the last renewal; where none stood before, in one tick. Returns the tree nodes
/// visited.
std::uint32_t keepWalls(const DeviceWallPlan& plan, const WallTick& tick, DeviceWallState& held) noexcept;

/// How stiff these walls may be now, at most `wanted` [N/m]. Where the handle is behind them already, they grow stiffer
/// by no more than adds the force that may be added in a tick.
[[nodiscard]] double heldStiffness(double wanted_N_per_m, const WallTick& tick, DeviceWallState& held) noexcept;

/// Lets the largest force of each wall go up no faster than a force may rise: where a wall across the other axis is
/// gone, a wall that is pressed to its limit may push harder.
void rampLimits(const WallTick& tick, DeviceWallState& held, DeviceCommand& command) noexcept;

} // namespace palpate
