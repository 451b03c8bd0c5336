// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/contact/moves/TickState.h"

namespace palpate
{

/// A face that was left here and is hit again without progress comes back, with all faces that were left after it.
template<SceneView AnyScene>
void returnStuck(TickState<AnyScene>& tick, const ActiveFeature& f, const Vec3& wanted) noexcept
{
  for (int i = 0; i < tick.left.count(); ++i)
  {
    const DepartedFaces::Entry& entry = tick.left[i];
    const double near = 4 * tick.tol(); // no progress, as TickState::moveOver() has it
    if (entry.face.surface == f.surface && entry.face.a == f.a && (tick.x() - entry.leftAt_W).norm() <= near &&
        wanted.norm() <= near)
    {
      for (int j = i; j < tick.left.count(); ++j)
      {
        ActiveFeature back = tick.left[j].face;
        back.stuck = true;
        tick.contacts.add(back);
      }
      tick.left.clear();
      return;
    }
  }
}

/// Stops a point just before its contact. The exact sweep has proven each committed path free.
template<SceneView AnyScene>
void stopPoint(TickState<AnyScene>& tick, const SweepHit& hit, const Vec3& to_W) noexcept
{
  const Vec3 wanted = hit.t * (to_W - tick.x());
  returnStuck(tick, hit.feature, wanted);
  if (wanted.norm() <= tick.tol() && tick.contacts.has(hit.feature))
  {
    tick.contacts.raise(); // the point stands on that face already, but too low to go along it
  }
  SweepHit next = hit;
  while (true)
  {
    tick.contacts.add(next.feature);
    const ProjectionResult stop = tick.contacts.solve(wanted, tick.contacts.lift());
    tick.result.work += static_cast<std::uint32_t>(stop.sets) * work::planeSet;
    if (!stop.feasible)
    {
      return;
    }
    const Vec3 end_W = tick.x() + stop.y;
    next = tick.sweep(tick.x(), end_W);
    if (next.freeUntil < 1.0)
    {
      return;
    }
    if (!next.hit)
    {
      tick.moveTo(end_W);
      tick.settle(&hit.feature);
      return;
    }
    if (!tick.contacts.raise())
    {
      return;
    }
  }
}

} // namespace palpate
