// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/contact/sweep/Neighbourhood.h"

#include <algorithm>

#include "haptics/contact/sweep/BoxTest.h"
#include "haptics/contact/sweep/DiscFilter.h"
#include "haptics/contact/sweep/TreeWalk.h"
#include "haptics/contact/view/SceneView.h"
#include "haptics/geometry/tree/SurfaceRecords.h"

namespace palpate
{
namespace
{

/// A face's disc where the surface is now.
struct Placed
{
  Vec3 origin_W, centre_W, normal_W;
  double radius_u, extent_u;
};

Vec3 centreOf(const DiscQuad& quad, std::uint32_t k) noexcept
{
  return { quad.cx[k], quad.cy[k], quad.cz[k] };
}

Vec3 normalOf(const DiscQuad& quad, std::uint32_t k) noexcept
{
  return { quad.nx[k], quad.ny[k], quad.nz[k] };
}

Placed place(const SurfaceData&, const SurfaceData& data, std::uint32_t leaf, std::uint32_t lane) noexcept
{
  const DiscQuad& quad = data.discs[2 * leaf + lane / 4];
  const Vec3& origin = data.leaves[leaf].origin_W;
  const double unit_u = 1.0 / data.leaves[leaf].perUnit;
  return { origin, origin + unit_u * centreOf(quad, lane % 4), normalOf(quad, lane % 4), unit_u * quad.radius[lane % 4],
    unit_u };
}

/// The disc of a face that is on its way, where the face is now: the tree has only a ball there.
Placed placeBent(const BentSurface& shape, std::uint32_t triangle) noexcept
{
  const auto corners = shape.cornersOf(triangle);
  const Disc disc = discOf(corners);
  const Vec3 cross = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  const double area = cross.norm();
  // A triangle a thousand times as long as it is high would need an exact normal, and one without area has none. The
  // radius is laid down in single precision, which loses 1e-7 of it: a millionth more holds the triangle all the same.
  const bool flat = area > 1e-3 * disc.radius_u * disc.radius_u;
  return { disc.centre_W, disc.centre_W, flat ? Vec3(cross / area) : Vec3(Vec3::Zero()), 1.000001 * disc.radius_u,
    disc.radius_u };
}

Placed place(const PosedSurface& posed, const SurfaceData& data, std::uint32_t leaf, std::uint32_t lane) noexcept
{
  Placed placed =
    posed.shape().bends() ? placeBent(posed.shape(), data.leaves[leaf].first + lane) : place(data, data, leaf, lane);
  placed.origin_W = posed.toWorld(placed.origin_W);
  placed.centre_W = posed.toWorld(placed.centre_W);
  placed.normal_W = posed.turned(placed.normal_W);
  placed.extent_u *= 1.75; // a cube's corner is sqrt 3 times as far as its faces
  return placed;
}

} // namespace

bool Neighbourhood::covers(const SweptBall& m) const noexcept
{
  const double furthest = std::max((m.x_W - this->centre_W_).norm(), (m.e_W - this->centre_W_).norm());
  return this->reach_u_ > 0.0 && furthest + m.r + 2 * m.tol <= this->reach_u_;
}

template<SceneView AnyScene>
bool Neighbourhood::gather(
  const AnyScene& scene, const SweptBall& m, std::uint32_t budget, std::uint32_t& nodes) noexcept
{
  if (this->crowded_)
  {
    return false;
  }
  // Later motions of a tick are mostly shorter than this one and start where this one ends. Room in radii, and the 1.1
  // below in lengths of the motion, were found by trying on a noisy sphere: more gathers faces that nobody asks for.
  constexpr double room = 0.15;
  this->centre_W_ = m.x_W + 0.5 * m.d;
  this->reach_u_ = 1.1 * m.length + (1.0 + room) * m.r + 8 * m.tol;
  this->count_ = 0;
  this->perUnit_ = 1.0 / this->reach_u_;
  this->extent_ = 0.0;
  SweptBall still = m;
  still.x_W = still.e_W = this->centre_W_;
  still.d = Vec3::Zero();
  still.dd = still.length = 0.0;
  still.r = this->reach_u_;
  const BoxTest test(still); // of whole surfaces: their boxes are in W
  const bool fits = walkWithin(sceneOf(scene).surfaceTree().nodes, test, budget, nodes,
    [&](std::uint32_t s) noexcept { return this->gatherSurface(surfaceOf(scene, s), s, still, budget, nodes); });
  if (!fits)
  {
    this->crowded_ = true;
    this->reach_u_ = -1.0;
  }
  return fits;
}

template<class View>
bool Neighbourhood::gatherSurface(
  const View& view, std::uint32_t surface, const SweptBall& still, std::uint32_t budget, std::uint32_t& nodes) noexcept
{
  return askTree(view, still,
    [&](const SweptBall& inSurface) noexcept
    {
      return askShape(view,
        [&](const auto& shape) noexcept { return this->gatherLeaves(view, shape, surface, inSurface, budget, nodes); });
    });
}

template<class View, class Shape>
bool Neighbourhood::gatherLeaves(const View& view, const Shape& shape, std::uint32_t surface,
  const SweptBall& inSurface, std::uint32_t budget, std::uint32_t& nodes) noexcept
{
  const SurfaceData& data = dataOf(view);
  const BoxTest test(inSurface);
  return walkWithin(nodesOf(shape), test, budget, nodes,
    [&](std::uint32_t index) noexcept
    {
      const Leaf& leaf = data.leaves[index];
      const DiscFilter filter(inSurface, leaf.origin_W, leaf.perUnit);
      const int lanes = filter.touched(discsOf(shape, 2 * index)) | filter.touched(discsOf(shape, 2 * index + 1)) << 4;
      for (std::uint32_t lane = 0; lane < leaf.count; ++lane)
      {
        if ((lanes >> lane) & 1)
        {
          if (this->count_ == capacity)
          {
            return false;
          }
          this->add(view, surface, index, lane);
        }
      }
      return true;
    });
}

template<class View>
void Neighbourhood::add(const View& view, std::uint32_t surface, std::uint32_t leaf, std::uint32_t lane) noexcept
{
  const SurfaceData& data = dataOf(view);
  const Placed placed = place(view, data, leaf, lane);
  const Vec3 centre = this->perUnit_ * (placed.centre_W - this->centre_W_);
  // Discs of one leaf lie within its extent, also where it has been turned.
  const Vec3 origin = placed.origin_W - this->centre_W_;
  this->extent_ = std::max(this->extent_, this->perUnit_ * (placed.extent_u + origin.cwiseAbs().maxCoeff()));
  DiscQuad& to = this->discs_[this->count_ / 4];
  const int at = this->count_ % 4;
  to.cx[at] = static_cast<float>(centre.x());
  to.cy[at] = static_cast<float>(centre.y());
  to.cz[at] = static_cast<float>(centre.z());
  to.nx[at] = static_cast<float>(placed.normal_W.x());
  to.ny[at] = static_cast<float>(placed.normal_W.y());
  to.nz[at] = static_cast<float>(placed.normal_W.z());
  to.radius[at] = static_cast<float>(this->perUnit_ * placed.radius_u);
  this->faces_[this->count_++] = { surface, data.leaves[leaf].first + lane };
}

template bool Neighbourhood::gather(const Scene&, const SweptBall&, std::uint32_t, std::uint32_t&) noexcept;
template bool Neighbourhood::gather(const MovingScene&, const SweptBall&, std::uint32_t, std::uint32_t&) noexcept;

} // namespace palpate
