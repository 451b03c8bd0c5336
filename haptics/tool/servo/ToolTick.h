// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/safety/SafetyLimits.h"
#include "haptics/tool/servo/ToolForce.h"

namespace palpate
{

/// How a tool is felt. Lengths in metres: what was touched in scene units is brought to the hand's by the map.
struct ToolFeel
{
  double stiffness_N_per_m = 0.0;
  ToolCoupling coupling = ToolCoupling::Constraints;
  SafetyLimits limits;
};

/// What one tick gave.
struct ToolFelt
{
  Wrench wrench;           ///< after all limits [N, N m]
  bool limited = false;    ///< less than the tool pushes with
  double injected_J = 0.0; ///< by contacts that were replaced in this tick: V of the new set less V of the old one
  int active = 0;
};

/// The tool's share of a tick: force and torque by the newest contacts, each within its limit and growing no faster
/// than its own. A new set of contacts steps the energy by what is told. Servo thread; real-time safe.
class ToolTick
{
public:
  [[nodiscard]] ToolFelt step(
    const ToolContacts& newest, const Pose& device_W, const ToolFeel& feel, double dt_s) noexcept;

private:
  ToolContacts set_; ///< of the last tick: what it stored is asked once more when another comes
  Wrench last_;
};

} // namespace palpate
