// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/tool/servo/AllowedMotion.h"

namespace palpate
{

/// Coupling of hand and tool.
enum class ToolCoupling : std::uint8_t
{
  Constraints, ///< the force of the contacts: no drag while the update lags behind a slide
  Virtual,     ///< a spring from the tool to the hand: a drag of k v T while it lags
};

/// The pull on the hand, as a whitened motion.
struct ToolPull
{
  Vec6 pull_u = Vec6::Zero();
  int active = 0;                                   ///< contacts that push
  std::array<ToolPress, ToolPress::most> presses{}; ///< the pushing ones; where they are not unique their sum is
};

/// The pull from which toolPush() makes a force. `friction`: of each contact, see frictionTarget(). Zero for an
/// invalid device pose. Real-time safe.
[[nodiscard]] ToolPull toolPull(
  const ToolContacts& contacts, const Pose& device_W, ToolCoupling coupling, double friction = 0.0) noexcept;

/// Force and torque of the tool on the hand.
struct ToolPush
{
  Wrench wrench_W;     ///< on the hand, about the tool's centre where it is led: N, and N u per the stiffness' unit
  int active = 0;      ///< contacts that push
  double stored = 0.0; ///< half the stiffness times the squared length of the spring that pulls
};

/// Force and torque in every tick, from the newest contacts: F = M (a_c - a_u), a_u the motion to the device and a_c
/// the nearest one that the contacts allow (Ortega, Redon & Coquillart 2007). Within one set it is the gradient of 1/2
/// dist^2, so its stiffness is never above the given one, and exactly zero at a pose that the contacts allow. With the
/// virtual coupling F = -M a_u. Zero for an invalid device pose. Real-time safe: no allocation, at most some
/// hundred projections.
[[nodiscard]] ToolPush toolPush(const ToolContacts& contacts, const Pose& device_W, double stiffness_N_per_u,
  ToolCoupling coupling, double friction = 0.0) noexcept;

} // namespace palpate
