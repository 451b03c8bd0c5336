// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/compliance/servo/SoftSurfaceRef.h"
#include "haptics/contact/view/SceneView.h"

namespace palpate
{

/// A god-object in material space: moves the ball towards the device point p_W [u] in a scene some surfaces of which
/// give way.
///
/// Where surfaces yield by u under the force f = K (y - p), f is that of a ball y - u among surfaces that do not yield,
/// drawn to p - u. So the rigid core moves among the surfaces as they are without the tool (their snapshots' free_W),
/// and stops at the first contact there; the contacts it rests on are solved exactly with the compliance that they
/// share, coupling and friction included; and both take turns until they agree. It cannot pass through, as the core
/// cannot. Where nothing soft is touched and nothing has yielded, the answer is the rigid core's, bit for bit.
/// plan.coupling_N_per_m is here K [N/u]. Friction of soft contacts is kinetic. Deterministic, allocates nothing.
/// Bounded by plan.workBudget over all turns: where it is used up, the answer is that of the last turn, whose forces
/// lie in their cones and whose ball has crossed nothing; the next tick goes on.
template<SceneView AnyScene>
[[nodiscard]] SoftResult moveOnSoft(const AnyScene& scene, const ContactPlan& plan,
  std::span<const SoftSurfaceRef> soft, const Vec3& p_W, SoftState& state, SoftScratch& room) noexcept;

/// Packets have been replaced by later ones of the same surfaces, whose vertices are still where they were felt. Under
/// the same forces the surfaces would be elsewhere by the new compliance: that much offset keeps ball and force where
/// they are. `now` must outlive the next tick.
void changeSnapshots(std::span<const SoftSurfaceRef> now, SoftState& state) noexcept;

/// Fades the offset of changeSnapshots(): once per tick, before the ball moves.
void fadeChange(double dt_s, SoftState& state) noexcept;

} // namespace palpate
