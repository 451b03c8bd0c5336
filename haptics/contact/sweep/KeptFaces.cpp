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
  forEachNear(from, NearFilter(still, from.frame()), [&](int i) { list.take(from, i); });
}

/// The same of balls that go with faces: the list gets the discs of the faces as they are now.
template<SceneView AnyScene>
void placeFaces(const AnyScene& scene, double share, const Reach& reach, FacesAround& around) noexcept
{
  around.near.begin(reach);
  SweptBall still = standing(reach, {});
  still.r += sceneOf(scene).mostCoat_u();
  OneSurface<AnyScene> surface;
  const double moment = (share - around.since) / (1.0 - around.since);
  forEachNear(around.far, GoingFilter(still, around.far.frame(), moment),
    [&](int i)
    {
      const FaceList::Face& face = around.far.face(i);
      around.near.add(discOf(surface.of(scene, face.surface).face(face.triangle)), face);
    });
}

double shareOf(const Scene&) noexcept
{
  return 1.0;
}
double shareOf(const MovingScene& moving) noexcept
{
  return moving.share();
}

template<SceneView AnyScene>
void pick(const AnyScene& scene, const Reach& reach, FacesAround& around) noexcept
{
  if (around.bends())
  {
    placeFaces(scene, shareOf(scene), reach, around);
  }
  else
  {
    pickFaces(around.far, reach, sceneOf(scene).mostCoat_u(), around.near);
  }
}

/// Of the list's room a point takes this share for the faces that are picked: found by trying, as room in reachFor().
constexpr double roomShare = 0.4;

/// The reach that a motion needs of a kept list. The reach of a point's motion is small: with a share of the list's
/// room the faces that are picked serve some ticks.
Reach pickedReach(const SweptBall& m, const FacesAround& around) noexcept
{
  Reach reach = reachFor(m);
  const Reach& whole = around.far.reach();
  if (m.r == 0.0 && whole.covers(reach))
  {
    const double most = whole.reach_u - (reach.centre_W - whole.centre_W).norm();
    reach.reach_u = std::min(reach.reach_u + roomShare * around.room_u, most);
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

/// Whether a list can hold for more than this moment: a surface that turns leaves all hulls of its vertices.
bool mayKeep(const Scene&) noexcept
{
  return true;
}
bool mayKeep(const MovingScene& moving) noexcept
{
  return moving.share() >= 1.0 || !moving.scene().changesPoses();
}

} // namespace

template<SceneView AnyScene>
void openKept(const AnyScene& scene, FacesAround& around) noexcept
{
  around.openFor(sceneOf(scene).contentHash(), shareOf(scene));
}

template<SceneView AnyScene>
const FaceList* keptFor(const AnyScene& scene, const SweptBall& m, FacesAround& around, std::uint32_t& work) noexcept
{
  if (covers(around.near.reach(), m))
  {
    return &around.near;
  }
  const Reach reach = pickedReach(m, around);
  if (around.far.reach().covers(reach))
  {
    pick(scene, reach, around);
    work += static_cast<std::uint32_t>(around.far.quads()) / 2; // eight discs are a leaf's
    return &around.near;
  }
  return !around.bends() && covers(around.far.reach(), m) ? &around.far : nullptr;
}

template<SceneView AnyScene>
void pickAround(const AnyScene& scene, const Vec3& x_W, double radius_u, FacesAround& around) noexcept
{
  constexpr double room = 0.15; // in radii, for the way of a tick; found by trying
  if (around.content != sceneOf(scene).contentHash() || !(shareOf(scene) >= around.since))
  {
    return;
  }
  const Reach most = around.far.reach();
  Reach reach{ x_W, radius_u > 0.0 ? (1.0 + room) * radius_u : roomShare * around.room_u };
  reach.reach_u = std::min(reach.reach_u, most.reach_u - (1.0 + 1e-12) * (x_W - most.centre_W).norm());
  if (around.bends() && reach.reach_u > radius_u)
  {
    pick(scene, reach, around);
  }
}

template<SceneView AnyScene>
const FaceList* listAround(const AnyScene& scene, const SweptBall& m, const FacesAround& around) noexcept
{
  const double share = shareOf(scene);
  if (around.content != sceneOf(scene).contentHash())
  {
    return nullptr;
  }
  if (share == around.share && covers(around.near.reach(), m))
  {
    return &around.near;
  }
  return !around.bends() && covers(around.far.reach(), m) ? &around.far : nullptr;
}

template<SceneView AnyScene>
void renewKept(const AnyScene& scene, double radius_u, const Vec3& from_W, GodObjectState& state) noexcept
{
  FacesAround& around = state.around;
  const double share = shareOf(scene);
  const Vec3 way_W = state.x_W - from_W;
  const SweepQuery next = straightQuery(state.x_W, state.x_W + way_W, radius_u);
  const Reach needed = reachFor(sweptBallOf(next));
  if (!mayKeep(scene))
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
  const bool served = !around.isOwed || around.served >= worthwhile;
  // A ball sweeps often in a tick, and a long list costs less than gathering again; a point mostly once or twice.
  const int most = radius_u > 0.0 ? 400 : 40;
  constexpr std::uint32_t mostNodes = 2000;
  std::uint32_t nodes = 0;
  const Reach reach = aheadOf(needed, way_W, around);
  const Moments moments = share < 1.0 ? Moments::ToTheEnd : Moments::Now;
  const bool fits = gatherFaces(scene, moments, reach, next.resolution, most, mostNodes, nodes, around.far);
  around.since = share;
  learnRoom(fits, most, around);
  waitAfter(fits && served, around);
  around.isOwed = fits && around.far.count() > 0;
  around.served = 0;
}

template void openKept(const Scene&, FacesAround&) noexcept;
template void openKept(const MovingScene&, FacesAround&) noexcept;
template const FaceList* keptFor(const Scene&, const SweptBall&, FacesAround&, std::uint32_t&) noexcept;
template const FaceList* keptFor(const MovingScene&, const SweptBall&, FacesAround&, std::uint32_t&) noexcept;
template void pickAround(const Scene&, const Vec3&, double, FacesAround&) noexcept;
template void pickAround(const MovingScene&, const Vec3&, double, FacesAround&) noexcept;
template const FaceList* listAround(const Scene&, const SweptBall&, const FacesAround&) noexcept;
template const FaceList* listAround(const MovingScene&, const SweptBall&, const FacesAround&) noexcept;
template void renewKept(const Scene&, double, const Vec3&, GodObjectState&) noexcept;
template void renewKept(const MovingScene&, double, const Vec3&, GodObjectState&) noexcept;

} // namespace palpate
