// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/mechanism/servo/TipPlace.h"

#include <algorithm>

#include "haptics/geometry/measure/RayWalk.h"
#include "haptics/geometry/mesh/TriangleWeights.h"
#include "haptics/geometry/tree/SurfaceData.h"

namespace palpate
{
namespace
{

/// Rounding of a place, as a share of a body's size.
constexpr double ofBody = 1e-6;

const SurfaceTree& treeOf(const PressedBody& body) noexcept
{
  return *body.scene->surfaces()[body.touch.surface].tree;
}

double sizeOf(const PressedBody& body) noexcept
{
  const SurfaceData& data = treeOf(body).data();
  return (data.high_W - data.low_W).norm();
}

/// The first of the body's surface on a displacement, its normal against the displacement: triangles have no outer side
/// of their own.
bool place(const PressedBody& body, const Vec3& from_W, const Vec3& way_W, ConstraintState& state) noexcept
{
  const double length_u = way_W.norm();
  if (!(length_u > 0.0))
  {
    return false;
  }
  const SurfaceTree& tree = treeOf(body);
  const auto hit = firstHit(tree, from_W, way_W / length_u, 0.0);
  if (!hit || hit->way_u > length_u)
  {
    return false;
  }
  const auto& corners = tree.mesh().triangles[hit->triangle];
  const auto corner = [&tree, &corners](int c) -> const Vec3& { return tree.mesh().vertices_W[corners[c]]; };
  const Vec3 normal_W = (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized();
  state.normal_W = normal_W.dot(way_W) < 0.0 ? normal_W : Vec3(-normal_W);
  state.place_B = { corners, weightsOnTriangle(corner(0), corner(1), corner(2), hit->p_W), hit->p_W };
  return true;
}

/// Whether the end of a displacement lies in the body: by the side behind it, so that a wall of no thickness is met
/// from either side.
bool isInside(const PressedBody& body, const Vec3& p_W, const Vec3& way_W) noexcept
{
  const PointSide behind = sideOf(treeOf(body), p_W, -way_W.normalized());
  return (behind == PointSide::Unknown ? sideOf(treeOf(body), p_W) : behind) == PointSide::Inside;
}

} // namespace

bool meetSurface(const PressedBody& body, const Vec3& from_W, const Vec3& to_W, ConstraintState& state) noexcept
{
  // A tip may have come to rest on the surface itself, but for rounding: the end of the last displacement is looked at
  // again.
  constexpr double most = 0.1;
  const Vec3 way_W = to_W - from_W;
  const double again = std::min(most, ofBody * sizeOf(body) / std::max(way_W.norm(), 1e-300));
  const Vec3 start_W = from_W - again * way_W;
  ConstraintState met = state;
  const bool enters = place(body, start_W, to_W - start_W, met) && !isInside(body, start_W, way_W);
  state = enters ? met : state;
  return enters;
}

bool slideOnSurface(const PressedBody& body, const Vec3& aside_W, ConstraintState& state) noexcept
{
  // As far up as aside: a surface that bends by less than 45 degrees meanwhile is found.
  const double up_u = std::max(aside_W.norm(), ofBody * sizeOf(body));
  return place(body, state.place_B.x_W + aside_W + up_u * state.normal_W, -2.0 * up_u * state.normal_W, state);
}

} // namespace palpate
