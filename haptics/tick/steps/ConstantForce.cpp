// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tick/stages/ConstantForce.h"

#include "haptics/safety/ForceLimits.h"
#include "haptics/tick/TickContext.h"

namespace palpate::stage
{

/// Before any force is let through there is none: the hand engages from a small force, and this one may be large.
void ConstantForce::step(TickContext& tick) noexcept
{
  if (tick.s.gain > 0.0)
  {
    const Vec3 force_W = clampMagnitude(tick.p.constantForce_W, tick.p.safety.maxForce_N);
    tick.addBesideContact(tick.p.map.directionToDevice(force_W));
  }
}

} // namespace palpate::stage
