// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/contact/sweep/Neighbourhood.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <utility>

#include "haptics/contact/sweep/BoxTest.h"
#include "haptics/contact/sweep/DiscFilter.h"
#include "haptics/contact/sweep/TreeWalk.h"
#include "haptics/contact/view/RestOfWay.h"
#include "haptics/contact/view/SceneView.h"

namespace palpate
{
namespace
{

Vec3 centreOf(const DiscQuad& quad, std::uint32_t k) noexcept
{
  return { quad.cx[k], quad.cy[k], quad.cz[k] };
}

Vec3 normalOf(const DiscQuad& quad, std::uint32_t k) noexcept
{
  return { quad.nx[k], quad.ny[k], quad.nz[k] };
}

/// The disc of a face where the tree has it.
PlacedDisc discIn(const SurfaceData& data, std::uint32_t leaf, std::uint32_t lane) noexcept
{
  const DiscQuad& quad = data.discs[2 * leaf + lane / 4];
  const Vec3& origin = data.leaves[leaf].origin_W;
  const double unit_u = 1.0 / data.leaves[leaf].perUnit;
  return { origin, origin + unit_u * centreOf(quad, lane % 4), normalOf(quad, lane % 4), unit_u * quad.radius[lane % 4],
    unit_u };
}

/// A list keeps radii in single precision, which takes up to 6e-8 of them away: one that is larger by a millionth still
/// holds its face.
constexpr double wider = 1.000001;

double radius2Of(const std::array<Vec3, 3>& corners, const Vec3& centre) noexcept
{
  const auto& [a, b, c] = corners;
  return std::max({ (a - centre).squaredNorm(), (b - centre).squaredNorm(), (c - centre).squaredNorm() });
}

/// A disc that holds a face where it is now: around the centroid, which is quick to find, so not the least one. Of a
/// face that is on its way the tree has no disc but a ball.
PlacedDisc discOn(const std::array<Vec3, 3>& corners) noexcept
{
  const auto& [a, b, c] = corners;
  const Vec3 centre = (a + b + c) / 3.0, cross = (b - a).cross(c - a);
  const double radius2 = radius2Of(corners, centre);
  const double radius_u = std::sqrt(radius2), area = cross.norm();
  // A triangle a thousand times as long as it is high would need an exact normal, and one without area has none.
  const bool flat = area > 1e-3 * radius2;
  return { centre, centre, flat ? Vec3(cross / area) : Vec3(Vec3::Zero()), wider * radius_u, radius_u };
}

PlacedDisc discIn(const BentSurface& shape, std::uint32_t leaf, std::uint32_t lane) noexcept
{
  return discOn(shape.cornersOf(shape.data().leaves[leaf].first + lane));
}

/// A ball that goes with a face on all the rest of its way: corners go evenly, and so does their centroid. A distance
/// between two points that go evenly is largest at an end.
PlacedDisc discIn(const RestOfWay& rest, std::uint32_t leaf, std::uint32_t lane) noexcept
{
  const auto [now, end] = rest.cornersOf(rest.data().leaves[leaf].first + lane);
  const Vec3 centre = (now[0] + now[1] + now[2]) / 3.0, last = (end[0] + end[1] + end[2]) / 3.0, way = last - centre;
  const double radius_u = std::sqrt(std::max(radius2Of(now, centre), radius2Of(end, last)));
  return { centre, centre, way, wider * radius_u, radius_u + way.cwiseAbs().maxCoeff() };
}

/// A disc for a list that holds to the end: ways are in the unit of the list. The ball around a face that stands goes
/// nowhere.
template<class Shape>
PlacedDisc toTheEnd(PlacedDisc disc, double perUnit) noexcept
{
  disc.normal_W *= std::is_same_v<Shape, RestOfWay> ? perUnit : 0.0;
  return disc;
}

PlacedDisc placed(const SurfaceData&, const PlacedDisc& inSurface) noexcept
{
  return inSurface;
}

PlacedDisc placed(const PosedSurface& posed, PlacedDisc disc) noexcept
{
  disc.origin_W = posed.toWorld(disc.origin_W);
  disc.centre_W = posed.toWorld(disc.centre_W);
  disc.normal_W = posed.turned(disc.normal_W);
  disc.extent_u *= 1.75; // a cube's corner is sqrt 3 times as far as its faces
  return disc;
}

/// One walk that fills a list.
template<SceneView AnyScene>
class Gathering
{
public:
  Gathering(const AnyScene& scene, Moments moments, int most, std::uint32_t budget, std::uint32_t& nodes,
    FaceList& list) noexcept
    : scene_(scene), toEnd_(moments == Moments::ToTheEnd), most_(most), budget_(budget), nodes_(nodes), list_(list)
  {
  }

  [[nodiscard]] bool run(const SweptBall& still) noexcept
  {
    const BoxTest test(still); // of whole surfaces: their boxes are in W
    return walkWithin(sceneOf(this->scene_).surfaceTree().nodes, test, this->budget_, this->nodes_,
      [&](std::uint32_t s) noexcept { return this->surface(surfaceOf(this->scene_, s), s, still); });
  }

private:
  template<class View>
  [[nodiscard]] bool surface(const View& view, std::uint32_t surface, const SweptBall& still) noexcept
  {
    return askTree(view, still,
      [&](const SweptBall& inSurface) noexcept
      {
        return askShape(
          view, [&](const auto& shape) noexcept { return this->atMoments(view, shape, surface, inSurface); });
      });
  }

  template<class View>
  [[nodiscard]] bool atMoments(
    const View& view, const BentSurface& shape, std::uint32_t surface, const SweptBall& inSurface) noexcept
  {
    return this->toEnd_ ? this->leaves(view, RestOfWay(shape), surface, inSurface)
                        : this->leaves(view, shape, surface, inSurface);
  }
  template<class View>
  [[nodiscard]] bool atMoments(
    const View& view, const SurfaceData& shape, std::uint32_t surface, const SweptBall& inSurface) noexcept
  {
    return this->leaves(view, shape, surface, inSurface);
  }

  template<class View, class Shape>
  [[nodiscard]] bool leaves(
    const View& view, const Shape& shape, std::uint32_t surface, const SweptBall& inSurface) noexcept
  {
    // Leaves of a large mesh are not in the cache: some are fetched while the walk goes on.
    std::array<std::uint32_t, 16> met;
    std::size_t count = 0;
    const auto testAll = [&]() noexcept
    {
      const auto end = met.begin() + std::exchange(count, 0);
      return std::all_of(
        met.begin(), end, [&](std::uint32_t leaf) { return this->leaf(view, shape, surface, inSurface, leaf); });
    };
    const bool fits = walkWithin(nodesOf(shape), BoxTest(inSurface), this->budget_, this->nodes_,
      [&](std::uint32_t leaf) noexcept
      {
        prefetch(dataOf(view), leaf);
        met[count++] = leaf;
        return count < met.size() || testAll();
      });
    return fits && testAll();
  }

  template<class View, class Shape>
  [[nodiscard]] bool leaf(const View& view, const Shape& shape, std::uint32_t surface, const SweptBall& inSurface,
    std::uint32_t index) noexcept
  {
    const SurfaceData& data = dataOf(view);
    const Leaf& leaf = data.leaves[index];
    const DiscFilter filter(inSurface, leaf.origin_W, leaf.perUnit);
    int lanes = filter.touched(discsOf(shape, 2 * index)) | filter.touched(discsOf(shape, 2 * index + 1)) << 4;
    lanes &= (1 << leaf.count) - 1;
    if (this->list_.count() + __builtin_popcount(static_cast<unsigned>(lanes)) > this->most_)
    {
      return false;
    }
    forEachLane(lanes,
      [&](std::uint32_t lane) noexcept
      {
        const PlacedDisc disc = placed(view, discIn(shape, index, lane));
        this->list_.add(
          this->toEnd_ ? toTheEnd<Shape>(disc, this->list_.frame().perUnit) : disc, { surface, leaf.first + lane });
      });
    return true;
  }

  static void prefetch(const SurfaceData& data, std::uint32_t leaf) noexcept
  {
    const auto* const discs = reinterpret_cast<const char*>(&data.discs[2 * std::size_t{ leaf }]);
    for (std::size_t line = 0; line < 2 * sizeof(DiscQuad); line += 64)
    {
      __builtin_prefetch(discs + line);
    }
    __builtin_prefetch(&data.leaves[leaf]);
  }

  const AnyScene& scene_;
  const bool toEnd_;
  const int most_;
  const std::uint32_t budget_;
  std::uint32_t& nodes_;
  FaceList& list_;
};

} // namespace

/// A ball of that reach that stands still.
SweptBall standing(const Reach& reach, const Resolution& resolution) noexcept
{
  SweepQuery query{ reach.centre_W, reach.centre_W, reach.reach_u, resolution, {} };
  query.resolution.include(reach.centre_W);
  return sweptBallOf(query);
}

Reach reachFor(const SweptBall& m) noexcept
{
  // Later motions of a tick are mostly shorter than this one and start where this one ends. Room in radii, and the 1.1
  // below in lengths of the motion, were found by trying on a noisy sphere: more gathers faces that nobody asks for.
  constexpr double room = 0.15;
  return { m.x_W + 0.5 * m.d, 1.1 * m.length + (1.0 + room) * m.r + 8 * m.tol };
}

template<SceneView AnyScene>
bool gatherFaces(const AnyScene& scene, Moments moments, const Reach& reach, const Resolution& resolution, int most,
  std::uint32_t budget, std::uint32_t& nodes, FaceList& list) noexcept
{
  list.begin(reach);
  const bool fits = Gathering(scene, moments, most, budget, nodes, list).run(standing(reach, resolution));
  if (!fits)
  {
    list.clear();
  }
  return fits;
}

PlacedDisc discOf(const FaceRecord& face) noexcept
{
  const Vec3 centre = (face.corner_W[0] + face.corner_W[1] + face.corner_W[2]) / 3.0;
  const double radius_u = std::sqrt(radius2Of(face.corner_W, centre));
  constexpr float flat = 1e3F; // the normal of a face that is more of a needle would have to be exact
  return { centre, centre, face.sliver < flat ? face.normal_W : Vec3(Vec3::Zero()), wider * radius_u, radius_u };
}

template bool gatherFaces(
  const Scene&, Moments, const Reach&, const Resolution&, int, std::uint32_t, std::uint32_t&, FaceList&) noexcept;
template bool gatherFaces(
  const MovingScene&, Moments, const Reach&, const Resolution&, int, std::uint32_t, std::uint32_t&, FaceList&) noexcept;

} // namespace palpate
