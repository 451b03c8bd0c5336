// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

#include "haptics/contact/moves/TickState.h"
#include "haptics/contact/moves/VertexBypass.h"

namespace palpate
{

/// The vertex that is shared by all faces that hold the point; of several the nearest; SurfaceData::none without one.
template<SceneView AnyScene>
[[nodiscard]] std::uint32_t commonCorner(const TickState<AnyScene>& tick) noexcept
{
  const ProjectionResult& held = tick.solution;
  const ActiveFeature& first = tick.contacts.features()[static_cast<std::size_t>(held.active[0])];
  const auto& s = tick.contacts.surface(first);
  std::uint32_t nearest = SurfaceData::none;
  for (const std::uint32_t corner : s.corners(first.a))
  {
    bool shared = true;
    for (int k = 1; k < held.count; ++k)
    {
      const ActiveFeature& f =
        tick.contacts.features()[static_cast<std::size_t>(held.active[static_cast<std::size_t>(k)])];
      shared = shared && f.surface == first.surface && s.hasCorner(f.a, corner);
    }
    const auto away = [&](std::uint32_t v) { return (tick.x() - s.vertex(v)).norm(); };
    if (shared && (nearest == SurfaceData::none || away(corner) < away(nearest)))
    {
      nearest = corner;
    }
  }
  return nearest;
}

/// True if the whole way is free, by exact sweeps, and leads nearer to the device.
template<SceneView AnyScene>
[[nodiscard]] bool isOpen(TickState<AnyScene>& tick, const VertexBypass& way) noexcept
{
  Vec3 from_W = tick.x();
  for (int i = 0; i < way.count; ++i)
  {
    const Vec3& to_W = way.places_W[static_cast<std::size_t>(i)];
    if (!to_W.allFinite())
    {
      return false; // vertices that move may meet for a moment
    }
    const SweepHit hit = tick.sweepOnce(from_W, to_W);
    if (hit.hit || hit.freeUntil < 1.0)
    {
      return false;
    }
    from_W = to_W;
  }
  return (tick.p_W - from_W).norm() < (tick.p_W - tick.x()).norm();
}

/// Leads a point round vertex v, over the faces that are seen from side f.side of face f, to where they fall off most.
template<SceneView AnyScene>
[[nodiscard]] bool leadRound(
  TickState<AnyScene>& tick, const ActiveFeature& f, std::uint32_t v, double reach_u) noexcept
{
  const auto& s = tick.contacts.surface(f);
  const Vec3 q = tick.p_W - s.vertex(v);
  const VertexFan fan = fanAround(s, f, v, FreeEdge::Turns);
  if (!fan.whole)
  {
    return false;
  }
  const Descent descent = steepestIn(s, fan, v, q, nullptr);
  if (descent.gain <= tick.tol())
  {
    return false;
  }
  // Twice as high as a point is kept above its faces: the way round must not touch them.
  const VertexBypass way = bypassVertex(s, fan, v, descent, q, { reach_u, 2 * tick.contacts.lift() });
  if (!isOpen(tick, way))
  {
    return false;
  }
  tick.forgetContacts();
  for (int i = 0; i < way.count; ++i)
  {
    tick.moveTo(way.places_W[static_cast<std::size_t>(i)]);
  }
  for (int i = 0; i < descent.count; ++i)
  {
    tick.contacts.add(descent.faces[static_cast<std::size_t>(i)]);
  }
  tick.settle();
  return true;
}

/// Rounding keeps a point off its faces, and so off the vertex at which the faces meet. Beside the vertex such a point
/// may rest in a pocket, where a point that lay on the faces would pass over the vertex. Once a tick the point is led
/// round the vertex: every piece of the way is one that the exact sweep found free, and the end of the way is nearer to
/// the device.
template<SceneView AnyScene>
[[nodiscard]] bool goRoundVertex(TickState<AnyScene>& tick) noexcept
{
  // In tol. A wedge of angle a is a * reach high there: from 1e-4 rad on higher than a point is led above its faces.
  constexpr double reach = 4096;
  if (tick.isBall() || tick.bypassed || tick.solution.count < 2)
  {
    return false;
  }
  const std::uint32_t v = commonCorner(tick);
  const double reach_u = reach * tick.tol();
  const auto& faces = tick.solution.active;
  if (v == SurfaceData::none ||
      // Nearer by so much that the way out to the reach leads away from the vertex.
      (tick.contacts.surface(tick.contacts.feature(faces[0])).vertex(v) - tick.x()).norm() > 0.25 * reach_u)
  {
    return false;
  }
  for (int k = 0; k < tick.solution.count && !tick.bypassed; ++k)
  {
    const ActiveFeature f = tick.contacts.feature(faces[static_cast<std::size_t>(k)]);
    tick.bypassed = leadRound(tick, f, v, reach_u);
  }
  return tick.bypassed;
}

} // namespace palpate
