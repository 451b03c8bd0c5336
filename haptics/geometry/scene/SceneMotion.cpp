// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/scene/SceneMotion.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{

bool sameSurface(const Surface& a, const Surface& b)
{
  return a.name == b.name && a.tree->contentHash() == b.tree->contentHash();
}

/// True if the tree of `next` has bounds of a motion from anywhere that `was` is in its own, in the frame of both.
bool comesFrom(const Surface& was, const Surface& next)
{
  return was.name == next.name && next.tree->wayName() == wayNameOf(was) && inOneFrame(was, next.frame, next.motion);
}

/// Still in a motion whose bounds the same tree has.
bool goesOn(const Surface& was, const Surface& next, double share)
{
  return was.name == next.name && was.tree == next.tree && was.from && share < 1.0;
}

/// The surface in `now` that `surface` is, at the same place in the list if it can be; null if there is none.
const Surface* find(const std::vector<Surface>& now, const Surface& surface, std::size_t index)
{
  if (index < now.size() && sameSurface(now[index], surface))
  {
    return &now[index];
  }
  const auto found =
    std::find_if(now.begin(), now.end(), [&surface](const Surface& s) { return sameSurface(s, surface); });
  return found != now.end() ? &*found : nullptr;
}

const Surface* findBent(const std::vector<Surface>& now, double share, const Surface& surface)
{
  if (surface.tree->wayName() == 0)
  {
    return nullptr;
  }
  const auto found = std::find_if(
    now.begin(), now.end(), [&](const Surface& s) { return comesFrom(s, surface) || goesOn(s, surface, share); });
  return found != now.end() ? &*found : nullptr;
}

/// Weights of the places of `next` that give where `was` is now. On the same motion they are the rest of its start;
/// otherwise, and where `was` stands at the end of that motion, the places are the vertices of `was`, then those that
/// `was` comes from (wayFrom in SceneBuilder.cpp).
std::array<double, 2> ofPlaces(const Surface& was, double share, const Surface& next)
{
  if (was.tree == next.tree && was.from)
  {
    return { (1.0 - share) * was.from->ofPlaces[0], (1.0 - share) * was.from->ofPlaces[1] };
  }
  return { share, 1.0 - share };
}

std::shared_ptr<const VertexStart> startAt(const Surface& was, double share, const Surface& next)
{
  std::vector<Vec3> places_W = was.tree->mesh().vertices_W;
  const bool onWay = was.from && share < 1.0;
  if (onWay)
  {
    std::transform(was.from->vertices_W.begin(), was.from->vertices_W.end(), places_W.begin(), places_W.begin(),
      [share](const Vec3& begin, const Vec3& end) { return alongWay(begin, end, share); });
  }
  return std::make_shared<const VertexStart>(
    std::move(places_W), was.tree->contentHash(), ofPlaces(was, onWay ? share : 1.0, next));
}

} // namespace

std::shared_ptr<const Scene> movingFrom(
  const Scene& now, double share, const std::shared_ptr<const Scene>& next, double motion_s)
{
  if (!next || !(motion_s > 0.0))
  {
    return next;
  }
  std::vector<Surface> surfaces = next->surfaces();
  bool moves = false;
  for (std::size_t i = 0; i < surfaces.size(); ++i)
  {
    if (const Surface* const was = find(now.surfaces(), surfaces[i], i))
    {
      surfaces[i].motion.begin_WS = was->motion.at(share);
      moves = moves || surfaces[i].motion.moves();
      // Built anew, the same vertices have a tree without the bounds of the motion that they are still in.
      if (was->from && share < 1.0 && inOneFrame(*was, surfaces[i].frame, surfaces[i].motion))
      {
        surfaces[i].tree = was->tree;
      }
    }
    if (const Surface* const was = findBent(now.surfaces(), share, surfaces[i]))
    {
      surfaces[i].motion.begin_WS = was->motion.at(share);
      surfaces[i].from = startAt(*was, share, surfaces[i]);
      moves = true;
    }
  }
  return moves ? std::make_shared<const Scene>(next->revision(), std::move(surfaces), motion_s) : next;
}

} // namespace palpate
