// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>

#include "haptics/contact/moves/TickState.h"
#include "haptics/contact/moves/VertexDescent.h"

namespace palpate
{

/// A face that was left obstructs if the way dips into the face's plane and leads back over the face.
template<SceneView AnyScene>
[[nodiscard]] bool obstructs(const TickState<AnyScene>& tick, const ActiveFeature& f, const Vec3& y) noexcept
{
  const auto& s = tick.contacts.surface(f);
  if (f.side * s.face(f.a).normal_W.dot(y) >= 0.0)
  {
    return false;
  }
  for (int k = 0; k < 3; ++k)
  {
    // Within twice the 4 del by which a slide ends outside of a face (walkFace) the point may be on either side.
    if (outsideOfEdge(s, f.a, k, tick.x()) > -8 * tick.del() && outwardNormal(s, f.a, k).dot(y) > 0.0)
    {
      return false;
    }
  }
  return true;
}

/// Nearest point under the touched planes and those left faces that turn out to obstruct it.
template<SceneView AnyScene>
void project(TickState<AnyScene>& tick) noexcept
{
  bool again = true;
  while (again)
  {
    tick.solution = tick.contacts.solve(tick.p_W - tick.x(), tick.contacts.lift());
    tick.result.work += static_cast<std::uint32_t>(tick.solution.sets) * work::planeSet;
    again = false;
    for (int i = 0; i < tick.left.count() && !again; ++i)
    {
      if (obstructs(tick, tick.left[i].face, tick.solution.y))
      {
        tick.contacts.add(tick.left[i].face);
        tick.left.remove(i);
        again = true;
      }
    }
  }
  tick.result.infeasible = !tick.solution.feasible;
}

/// True if a point may pass beside face f on its straight way along q: the way meets the plane of f beyond a side that
/// no other face continues, or so near to such a side that rounding cannot tell.
template<SceneView AnyScene>
[[nodiscard]] bool mayPassBeside(const TickState<AnyScene>& tick, const ActiveFeature& f, const Vec3& q) noexcept
{
  const auto& s = tick.contacts.surface(f);
  const FeaturePlane plane = tick.contacts.plane(f);
  const double sinks = -plane.n.dot(q);
  if (sinks <= 0.0)
  {
    return true;
  }
  const Vec3 there_W = tick.x() + std::max(0.0, plane.gap) / sinks * q;
  const auto& corners = s.corners(f.a);
  for (int k = 0; k < 3; ++k)
  {
    if (outsideOfEdge(s, f.a, k, there_W) > -tick.del() &&
        s.neighbour(f.a, corners[k], corners[(k + 1) % 3]) == SurfaceData::none)
    {
      return true;
    }
  }
  return false;
}

/// True if the faces that hold the point may all be beside its straight way to the device. Only exact arithmetic can
/// tell then whether their planes hold the point rightly.
template<SceneView AnyScene>
[[nodiscard]] bool mayPassBesideAll(const TickState<AnyScene>& tick) noexcept
{
  const Vec3 q = tick.p_W - tick.x();
  for (int k = 0; k < tick.solution.count; ++k)
  {
    const int i = tick.solution.active[static_cast<std::size_t>(k)];
    if (!mayPassBeside(tick, tick.contacts.features()[static_cast<std::size_t>(i)], q))
    {
      return false;
    }
  }
  return true;
}

/// True if the holders of a point have been looked for often enough at this place. A stop before an obstacle moves the
/// point by less than rounding, and from there the answer may be another one. Asked without a limit, two answers could
/// take turns for ever.
template<SceneView AnyScene>
[[nodiscard]] bool isReconsidered(TickState<AnyScene>& tick) noexcept
{
  constexpr int often = 4; // by then two answers that take turns have each been given twice
  const double moved = (tick.x() - tick.reconsideredAt_W).norm();
  tick.reconsidered = moved <= 4 * tick.tol() ? tick.reconsidered : 0;
  return moved == 0.0 || tick.reconsidered >= often;
}

/// A point at a vertex is held by half-spaces. On a saddle not each of them is an obstacle, and which of them the point
/// brought along depends on the way it came. So the planes that hold the point are computed anew from the surface
/// itself.
template<SceneView AnyScene>
void reconsiderVertex(TickState<AnyScene>& tick) noexcept
{
  if (tick.isBall() || tick.solution.count == 0 || isReconsidered(tick))
  {
    return;
  }
  for (int k = 0; k < tick.solution.count; ++k)
  {
    const ActiveFeature f = tick.contacts.feature(tick.solution.active[static_cast<std::size_t>(k)]);
    const auto& s = tick.contacts.surface(f);
    const std::uint32_t v = cornerAt(s, f, tick.x(), tick.tol());
    if (v == SurfaceData::none)
    {
      continue;
    }
    tick.reconsideredAt_W = tick.x();
    ++tick.reconsidered;
    const std::optional<Descent> descent = descendFromVertex(s, tick.fanAt(f, v), v, tick.x(), tick.p_W - tick.x());
    if (descent && descent->gain > tick.tol())
    {
      tick.forgetContacts();
      for (int i = 0; i < descent->count; ++i)
      {
        tick.contacts.add(descent->faces[static_cast<std::size_t>(i)]);
      }
      project(tick);
    }
    return;
  }
}

/// Discards the planes that hold the ball, once per tick, so that sweeps find its holders anew. False: that has been
/// done already.
template<SceneView AnyScene>
[[nodiscard]] bool startAnew(TickState<AnyScene>& tick) noexcept
{
  if (tick.startedAnew)
  {
    return false;
  }
  tick.forgetContacts();
  tick.reconsidered = 0;
  tick.reconsideredAt_W = nowhere_W();
  tick.result.infeasible = false;
  tick.startedAnew = true;
  return true;
}

/// A point that rests in a corner of planes may be held by the plane of a face that is not there: the point stands
/// beside the face by less than rounding. Where the point has not moved in a tick, the planes are found anew from the
/// faces themselves, in exact arithmetic. In a tick that moves, the search would cost more than it could find.
template<SceneView AnyScene>
[[nodiscard]] bool lookAgain(TickState<AnyScene>& tick) noexcept
{
  constexpr double hardly = 1e-6; // of the way to the device; nothing here may depend on rounding
  const double moved = (tick.x() - tick.start_W).norm(), left = (tick.p_W - tick.x()).norm();
  if (tick.isBall() || tick.solution.count < 2 || moved > hardly * left)
  {
    return false;
  }
  return startAnew(tick);
}

} // namespace palpate
