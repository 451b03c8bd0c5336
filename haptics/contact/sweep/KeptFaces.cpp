// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/contact/sweep/KeptFaces.h"

#include <algorithm>
#include <utility>

#include "haptics/contact/sweep/NearFilter.h"
#include "haptics/contact/sweep/Neighbourhood.h"

namespace palpate
{
namespace
{

/// Fills the list with those faces of another one that are within reach, where the other one covers that.
void pickFaces(const FaceList& from, const Reach& reach, double coat_u, FaceList& list) noexcept
{
  list.beginFrom(from, reach);
  SweptBall still = standing(reach, {});
  still.r += coat_u;
  const NearFilter filter(still, from.frame());
  for (int quad = 0; quad < from.quads(); ++quad)
  {
    int lanes = filter.near(from.discs(quad)) & ((1 << std::min(4, from.count() - quad * 4)) - 1);
    for (; lanes != 0; lanes &= lanes - 1)
    {
      list.take(from, quad * 4 + __builtin_ctz(static_cast<unsigned>(lanes)));
    }
  }
}

/// What a motion needs of a list that is kept. The reach of a point's motion is small: with a share of the list's room
/// the faces that are picked serve some ticks.
Reach pickedReach(const SweptBall& m, const FacesAround& around) noexcept
{
  constexpr double share = 0.4; // found by trying, as room in reachFor()
  Reach reach = reachFor(m);
  const Reach& whole = around.far.reach();
  if (m.r == 0.0 && whole.covers(reach))
  {
    const double most = whole.reach_u - (reach.centre_W - whole.centre_W).norm();
    reach.reach_u = std::min(reach.reach_u + share * around.room_u, most);
  }
  return reach;
}

/// The reach of a list for some ticks like the last one, of which the first needs `needed`.
Reach aheadOf(const Reach& needed, const Vec3& way_W, FacesAround& around) noexcept
{
  constexpr double ticks = 8.0; // found by trying: more make lists longer that are read in each tick
  const double length = way_W.norm();
  around.room_u = std::min(around.mostRoom_u, std::max(ticks * length, 0.5 * around.room_u));
  const Vec3 ahead_W = length > 0.0 ? Vec3(0.5 * around.room_u / length * way_W) : Vec3(Vec3::Zero());
  return { needed.centre_W + ahead_W, needed.reach_u + around.room_u };
}

/// After some lists that were of no use many ticks go by before the next try.
void waitAfter(bool useful, FacesAround& around) noexcept
{
  constexpr int mostUseless = 5; // 31 ticks
  around.useless = useful ? 0 : std::min(around.useless + 1, mostUseless);
  around.pause = (1 << around.useless) - 1;
}

/// Where the faces were too many for a list, the next one has less room.
void learnRoom(bool fits, int most, FacesAround& around) noexcept
{
  around.mostRoom_u *= fits && around.far.count() < most / 2 ? 1.5 : 1.0;
  around.mostRoom_u = fits ? around.mostRoom_u : 0.6 * std::exchange(around.room_u, 0.0);
}

double shareOf(const Scene&) noexcept
{
  return 1.0;
}
double shareOf(const MovingScene& moving) noexcept
{
  return moving.share();
}

} // namespace

template<SceneView AnyScene>
void openKept(const AnyScene& scene, FacesAround& around) noexcept
{
  around.openFor(sceneOf(scene).contentHash(), shareOf(scene));
}

const FaceList* keptFor(const SweptBall& m, double coat_u, FacesAround& around, std::uint32_t& work) noexcept
{
  if (covers(around.near.reach(), m))
  {
    return &around.near;
  }
  const Reach reach = pickedReach(m, around);
  if (around.far.reach().covers(reach))
  {
    pickFaces(around.far, reach, coat_u, around.near);
    work += static_cast<std::uint32_t>(around.far.quads()) / 2; // eight discs are a leaf's
    return &around.near;
  }
  return covers(around.far.reach(), m) ? &around.far : nullptr;
}

template<SceneView AnyScene>
void renewKept(const AnyScene& scene, double radius_u, const Vec3& from_W, GodObjectState& state) noexcept
{
  FacesAround& around = state.around;
  const bool isNew = std::exchange(around.isNew, false);
  const Vec3 way_W = state.x_W - from_W;
  const SweepQuery next = straightQuery(state.x_W, state.x_W + way_W, radius_u);
  const Reach needed = reachFor(sweptBallOf(next));
  if (isNew || shareOf(scene) < 1.0)
  {
    return;
  }
  if (around.far.reach().covers(needed))
  {
    ++around.served;
    return;
  }
  if (around.pause > 0)
  {
    --around.pause;
    return;
  }
  constexpr int worthwhile = 3; // ticks
  const bool served = around.far.count() == 0 || around.served >= worthwhile;
  // A ball sweeps often in a tick, and a long list costs less than gathering again; a point mostly once or twice.
  const int most = radius_u > 0.0 ? 400 : 40;
  constexpr std::uint32_t mostNodes = 2000;
  std::uint32_t nodes = 0;
  const Reach reach = aheadOf(needed, way_W, around);
  const bool fits = gatherFaces(scene, reach, next.resolution, most, mostNodes, nodes, around.far);
  learnRoom(fits, most, around);
  waitAfter(fits && served, around);
  around.served = 0;
}

template void openKept(const Scene&, FacesAround&) noexcept;
template void openKept(const MovingScene&, FacesAround&) noexcept;
template void renewKept(const Scene&, double, const Vec3&, GodObjectState&) noexcept;
template void renewKept(const MovingScene&, double, const Vec3&, GodObjectState&) noexcept;

} // namespace palpate
