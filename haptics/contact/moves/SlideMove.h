// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>

#include "haptics/contact/moves/StopPoint.h"
#include "haptics/contact/moves/TickState.h"

namespace palpate
{

/// The limits of a straight slide: how far every holding feature supports it, and which one ends first.
struct SlideLimit
{
  double t = 1.0;
  int ends = -1;              ///< index of the feature that is left at t, or -1
  ActiveFeature successor;    ///< the edge or vertex over which it is left
  std::uint32_t lastFace = 0; ///< the face from which that edge was reached
};

/// Distance over which feature i supports a slide along y, and the next feature of the ball.
template<SceneView AnyScene>
[[nodiscard]] SlideLimit limitBy(TickState<AnyScene>& tick, int i, const Vec3& y) noexcept
{
  const ActiveFeature& f = tick.contacts.feature(i);
  const auto& s = tick.contacts.surface(f);
  SlideLimit slide{ 1.0, i, f };
  if (f.kind == FeatureKind::Face)
  {
    const FaceExit exit = walkFace(s, f.a, tick.x(), y, tick.del());
    slide.t = exit.t;
    slide.successor = { f.surface, exit.i, exit.j, FeatureKind::Edge, 1, false };
    slide.lastFace = exit.triangle;
    return slide;
  }
  slide.t = exitRound(s, f, tick.x(), y, tick.plan.radius_u, tick.del());
  if (f.kind == FeatureKind::Edge)
  {
    const std::uint32_t end = edgeLine(s, f.a, f.b).unit.dot(y) > 0.0 ? f.b : f.a;
    slide.successor = { f.surface, end, 0, FeatureKind::Vertex, 1, false };
  }
  return slide;
}

template<SceneView AnyScene>
[[nodiscard]] SlideLimit limitSlide(TickState<AnyScene>& tick) noexcept
{
  SlideLimit least;
  const Vec3& y = tick.solution.y;
  for (int k = 0; k < tick.solution.count; ++k)
  {
    const int i = tick.solution.active[k];
    const ActiveFeature& f = tick.contacts.feature(i);
    if (tick.solution.lambda[k] <= 0.0)
    {
      continue;
    }
    SlideLimit slide = limitBy(tick, i, y);
    if (f.stuck && slide.t * y.norm() <= 4 * tick.tol())
    {
      const FaceRecord& face = tick.contacts.surface(f).face(f.a);
      // A stuck face lets the point go on for a way that progress is measured by: far more than rounding, far less than
      // the face.
      slide = { 1e-4 * (face.corner_W[1] - face.corner_W[0]).norm() / y.norm(), -1, f };
    }
    if (slide.t < least.t)
    {
      least = slide;
    }
  }
  return least;
}

/// A ball that slides off a face lies on its edge, off an edge on its end; a point comes over the next face.
template<SceneView AnyScene>
void leave(TickState<AnyScene>& tick, const SlideLimit& limit) noexcept
{
  const ActiveFeature left = tick.contacts.feature(limit.ends);
  tick.contacts.remove(limit.ends);
  if (tick.isBall())
  {
    tick.contacts.add(limit.successor);
    return;
  }
  tick.left.add(left, tick.x());
  const auto& s = tick.contacts.surface(left);
  const std::uint32_t neighbour = s.neighbour(limit.lastFace, limit.successor.a, limit.successor.b);
  if (neighbour == SurfaceData::none)
  {
    return;
  }
  const ActiveFeature last = onSamePlane(s, left, limit.lastFace);
  const ActiveFeature next = continued(s, last, neighbour, limit.successor.a, limit.successor.b);
  // Just beyond a sharp crest the point lies on the inner side of the next face's plane: nothing holds it there.
  if (sideOf(s, next.a, tick.x()) == next.side)
  {
    tick.contacts.add(next); // settle() drops it again where it does not hold
  }
}

/// True if a face is among the features on which a ball lies.
template<SceneView AnyScene>
[[nodiscard]] bool liesOnFace(const TickState<AnyScene>& tick) noexcept
{
  const auto isFace = [&tick](int i)
  { return tick.contacts.features()[static_cast<std::size_t>(i)].kind == FeatureKind::Face; };
  return std::any_of(tick.solution.active.begin(), tick.solution.active.begin() + tick.solution.count, isFace);
}

/// A ball that lies on the border of a face and is about to leave the face leaves it at once: a slide over the rest of
/// the face would be a whole pass for a way of nothing.
template<SceneView AnyScene>
[[nodiscard]] bool leaveBorder(TickState<AnyScene>& tick) noexcept
{
  if (!tick.isBall() || tick.rests() || !liesOnFace(tick))
  {
    return false;
  }
  const SlideLimit limit = limitSlide(tick);
  if (limit.ends < 0 || limit.t * tick.solution.y.norm() > tick.tol())
  {
    return false;
  }
  leave(tick, limit);
  return true;
}

template<SceneView AnyScene>
void stopBall(TickState<AnyScene>& tick, const SweepHit& hit, const Vec3& to_W) noexcept
{
  tick.moveTo(tick.x() + hit.t * (to_W - tick.x()));
  tick.touch(hit);
}

/// Slides under the touched planes to the last supported point or to the next obstacle. False: the tick is over.
template<SceneView AnyScene>
[[nodiscard]] bool slideOn(TickState<AnyScene>& tick) noexcept
{
  const SlideLimit limit = limitSlide(tick);
  const bool straight = tick.solution.count == 0 && limit.t >= 1.0;
  const Vec3 to_W = straight ? tick.p_W : Vec3(tick.x() + limit.t * tick.solution.y);
  const SweepHit hit = tick.sweep(tick.x(), to_W);
  if (hit.freeUntil < 1.0 && !hit.hit)
  {
    if (tick.isBall())
    {
      tick.moveTo(tick.x() + hit.freeUntil * (to_W - tick.x()));
      tick.settle();
    }
    return false;
  }
  if (hit.hit)
  {
    tick.isBall() ? stopBall(tick, hit, to_W) : stopPoint(tick, hit, to_W);
    return !tick.result.overBudget;
  }
  tick.moveTo(to_W);
  if (limit.ends >= 0)
  {
    leave(tick, limit);
  }
  tick.settle();
  return !(tick.contacts.count() == 0 && tick.x() == tick.p_W);
}

} // namespace palpate
