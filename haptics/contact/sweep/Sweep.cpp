// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/contact/sweep/Sweep.h"

#include <array>
#include <type_traits>

#include "haptics/contact/sweep/DiscFilter.h"
#include "haptics/contact/sweep/NearFilter.h"
#include "haptics/contact/sweep/SurfaceSweep.h"
#include "haptics/contact/sweep/TreeWalk.h"
#include "haptics/contact/sweep/Work.h"
#include "haptics/contact/view/SceneView.h"
#include "haptics/geometry/tree/SurfaceData.h"

namespace palpate
{
namespace
{

/// Near-first walk of one surface's tree.
template<class Shape>
void sweepSurface(const Shape& shape, std::uint32_t surface, const SweepQuery& query, const SweptBall& m,
  std::uint32_t budget, SweepHit& best) noexcept
{
  SurfaceSweep sweep(shape, surface, query, m, best);
  walkNearFirst(
    nodesOf(shape), boundsOf(shape), m, budget, best, [&sweep](std::uint32_t leaf) noexcept { sweep.testLeaf(leaf); });
}

} // namespace

/// A motion as the surfaces of listed faces see it: it is taken to one that moves once for all of its faces in a row.
template<SceneView AnyScene>
class MotionInSurfaces
{
public:
  MotionInSurfaces(const AnyScene& scene, const SweptBall& m) noexcept : scene_(scene), m_(m) {}

  /// Calls ask(shape, motion) with a surface in its own frame.
  template<class Ask>
  void ask(std::uint32_t surface, Ask ask) noexcept
  {
    if constexpr (std::is_same_v<AnyScene, MovingScene>)
    {
      const auto& view = this->surfaces_.of(this->scene_, surface,
        [this](const PosedSurface& placed) noexcept
        { this->inSurface_ = askTree(placed, this->m_, [](const SweptBall& m) noexcept { return m; }); });
      askShape(view, [&](const auto& shape) noexcept { ask(shape, this->inSurface_); });
    }
    else
    {
      const SurfaceData& data = surfaceOf(this->scene_, surface);
      askTree(data, this->m_, [&](const SweptBall& m) noexcept { ask(data, m); });
    }
  }

private:
  const AnyScene& scene_;
  const SweptBall& m_;
  OneSurface<AnyScene> surfaces_;
  SweptBall inSurface_;
};

namespace
{

/// A hit beyond the part that is proven free may not be the first.
SweepHit settled(SweepHit best) noexcept
{
  best.hit = best.hit && (best.freeUntil >= 1.0 || best.t <= best.freeUntil);
  return best;
}

} // namespace

template<class Shape>
SweepHit sweepSurface(const Shape& shape, std::uint32_t surface, const SweepQuery& query, std::uint32_t budget) noexcept
{
  SweepHit best;
  askTree(dataOf(shape), sweptBallOf(query),
    [&](const SweptBall& m) noexcept { sweepSurface(shape, surface, query, m, budget, best); });
  return best;
}

template<SceneView AnyScene>
SweepHit sweepListed(
  const AnyScene& scene, const SweepQuery& query, const FaceList& list, std::uint32_t budget) noexcept
{
  SweepHit best;
  const SweptBall m = sweptBallOf(query);
  SweptBall widest = m;
  widest.r += sceneOf(scene).mostCoat_u();
  const FaceList::Frame& frame = list.frame();
  DiscFilter filter(widest, frame.centre_W, frame.perUnit, frame.extent);
  NearFilter near(widest, frame);
  double looked = 1.0; // so much of the way still matters
  MotionInSurfaces motion(scene, m);
  for (int quad = 0; quad < list.quads(); ++quad)
  {
    if (best.work >= budget)
    {
      best.freeUntil = 0.0;
      break;
    }
    best.work += static_cast<std::uint32_t>(quad % 2); // eight discs are a leaf's
    int lanes = near.near(list.discs(quad)) & list.lanesOf(quad);
    if (lanes != 0)
    {
      lanes &= filter.touched(list.discs(quad));
    }
    forEachLane(lanes,
      [&](std::uint32_t lane) noexcept
      {
        const FaceList::Face& face = list.face(quad * 4 + static_cast<int>(lane));
        motion.ask(face.surface, [&](const auto& shape, const SweptBall& inSurface) noexcept
          { SurfaceSweep(shape, face.surface, query, inSurface, best).testTriangle(face.triangle); });
      });
    if (best.t < 0.5 * looked)
    {
      looked = best.t;
      widest.d = looked * m.d;
      filter = DiscFilter(widest, frame.centre_W, frame.perUnit, frame.extent);
      near = NearFilter(widest, frame);
    }
  }
  return settled(best);
}

template<SceneView AnyScene>
SweepHit sweepBall(const AnyScene& scene, const SweepQuery& query, std::uint32_t budget) noexcept
{
  SweepHit best;
  const SweptBall m = sweptBallOf(query);
  const auto sweepOne = [&](std::uint32_t s) noexcept
  {
    const auto& surface = surfaceOf(scene, s);
    askTree(surface, m,
      [&](const SweptBall& inSurface) noexcept {
        askShape(surface, [&](const auto& shape) noexcept { sweepSurface(shape, s, query, inSurface, budget, best); });
      });
  };
  const Scene& whole = sceneOf(scene);
  if (whole.surfaces().size() == 1)
  {
    sweepOne(0); // its own root is all a tree above it could test
  }
  else if (!whole.empty())
  {
    walkNearFirst(whole.surfaceTree().nodes, whole.surfaceTree().bounds, m, budget, best, sweepOne);
  }
  return settled(best);
}

template<SceneView AnyScene>
SweepHit sweepFaces(const AnyScene& scene, const SweepQuery& query, std::span<const FaceList::Face> faces) noexcept
{
  SweepHit best;
  const SweptBall m = sweptBallOf(query);
  MotionInSurfaces motion(scene, m);
  for (const FaceList::Face& face : faces)
  {
    motion.ask(face.surface, [&](const auto& shape, const SweptBall& inSurface) noexcept
      { SurfaceSweep(shape, face.surface, query, inSurface, best).testTriangle(face.triangle); });
  }
  return best;
}

template<SceneView AnyScene>
bool meetsFace(const AnyScene& scene, const ActiveFeature& f, const SweepQuery& query) noexcept
{
  return sweepFaces(scene, query, std::array{ FaceList::Face{ f.surface, f.a } }).hit;
}

template SweepHit sweepFaces(const Scene&, const SweepQuery&, std::span<const FaceList::Face>) noexcept;
template SweepHit sweepFaces(const MovingScene&, const SweepQuery&, std::span<const FaceList::Face>) noexcept;
template bool meetsFace(const Scene&, const ActiveFeature&, const SweepQuery&) noexcept;
template bool meetsFace(const MovingScene&, const ActiveFeature&, const SweepQuery&) noexcept;
template SweepHit sweepSurface(const SurfaceData&, std::uint32_t, const SweepQuery&, std::uint32_t) noexcept;
template SweepHit sweepSurface(const BentSurface&, std::uint32_t, const SweepQuery&, std::uint32_t) noexcept;
template SweepHit sweepListed(const Scene&, const SweepQuery&, const FaceList&, std::uint32_t) noexcept;
template SweepHit sweepListed(const MovingScene&, const SweepQuery&, const FaceList&, std::uint32_t) noexcept;
template SweepHit sweepBall(const Scene&, const SweepQuery&, std::uint32_t) noexcept;
template SweepHit sweepBall(const MovingScene&, const SweepQuery&, std::uint32_t) noexcept;

} // namespace palpate
