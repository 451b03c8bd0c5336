// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>

#include "haptics/core/HapticDevice.h"
#include "haptics/geometry/scene/Scene.h"
#include "haptics/tick/ForceRenderer.h"

namespace palpate::lab
{

/// A simulated device above a floor (the plane z = 0, a mesh of two triangles), moving along z.
struct WallSetup
{
  double period_s = 1e-3;
  HapticParameters parameters; ///< a rig has no safety limits and is engaged at once
  /// The force that a method outside of the product makes of the force of a tick [N]; null: none.
  std::function<Vec3(const HapticState&)> afterwards = {};
};

/// Parameters for a rig: nothing but the spring.
[[nodiscard]] HapticParameters plainSpring(double stiffness_N_per_m);
/// A spring and a damper whose velocity is the backward difference, as the theory of sampled walls has it.
[[nodiscard]] HapticParameters springDamper(double stiffness_N_per_m, double damping_Ns_per_m);
/// The product's chain: passivity controller and adaptive window on.
[[nodiscard]] HapticParameters passiveSpring(double stiffness_N_per_m, double delay_ticks = 0.0);

/// The whole tick in virtual time: device, god-object, force chain.
class WallRig
{
public:
  WallRig(HapticDevice& device, const WallSetup& setup);

  /// One period: reads the device, renders, writes the command.
  const HapticState& tick();

private:
  void placeAbove();

  HapticDevice& device_;
  WallSetup setup_;
  std::shared_ptr<const Scene> floor_;
  RendererState state_;
  TickOutput output_;
  std::uint64_t tick_ = 0;
};

} // namespace palpate::lab
