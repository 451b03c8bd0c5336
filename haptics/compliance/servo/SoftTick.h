// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/compliance/servo/SoftSurfaceRef.h"
#include "haptics/contact/view/SceneView.h"

namespace palpate
{

/// A god-object in material space: moves the ball towards the device point p_W [u] in a scene with soft
/// surfaces.
///
/// Where surfaces are displaced by u under the force f = K (y - p), f is that of a ball y - u among surfaces in their
/// free place, drawn to p - u. So the rigid core moves among the surfaces without the tool (their snapshots' free_W),
/// and stops at the first contact there; its contacts are solved exactly with the compliance that they
/// share, coupling and friction included; and both alternate until they agree. The ball cannot pass through, as the
/// core cannot. Where no soft surface is touched or displaced, the answer is the rigid core's, bit for bit.
/// plan.coupling_N_per_m is here K [N/u]. Friction of soft contacts is kinetic. Deterministic, allocates nothing.
/// Bounded by plan.workBudget over all iterations: where it is used up, the answer is that of the last one, whose
/// forces lie in their cones and whose ball has crossed nothing; the next tick goes on.
template<SceneView AnyScene>
[[nodiscard]] SoftResult moveOnSoft(const AnyScene& scene, const ContactPlan& plan,
  std::span<const SoftSurfaceRef> soft, const Vec3& p_W, SoftState& state, SoftScratch& room) noexcept;

/// Snapshots have been replaced by later ones of the same surfaces, whose vertices are still where they were felt. With
/// the new compliance the same forces would displace the surfaces differently: that offset keeps ball and force where
/// they are. `now` must outlive the next tick.
void changeSnapshots(std::span<const SoftSurfaceRef> now, SoftState& state) noexcept;

/// Fades the offset of changeSnapshots(): once per tick, before the ball moves.
void fadeChange(double dt_s, SoftState& state) noexcept;

} // namespace palpate
