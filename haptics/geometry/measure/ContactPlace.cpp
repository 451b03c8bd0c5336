// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/measure/ContactPlace.h"

#include <limits>

#include "haptics/core/PoseMath.h"
#include "haptics/geometry/measure/WallThickness.h"
#include "haptics/geometry/simplify/SurfaceDistance.h"
#include "haptics/geometry/tree/SurfaceData.h"

namespace palpate
{
namespace
{

/// Across the triangle, or from the line, to the side of the proxy: the direction from the device where that rests on
/// it.
Vec3 normalOf(const SurfaceData& data, const NearestPoint& at, const Vec3& proxy_S, const Vec3& device_S)
{
  const Vec3 away_S = proxy_S - at.p_W;
  const double rounding_u = 1e-12 * (at.p_W.cwiseAbs().maxCoeff() + (proxy_S - device_S).norm());
  const Vec3 outward_S = away_S.norm() > rounding_u ? away_S : Vec3(proxy_S - device_S);
  if (isSegment(data.corners(at.triangle)))
  {
    return outward_S.normalized();
  }
  const Vec3& normal_S = data.plane(at.triangle).normal_W;
  return normal_S.dot(outward_S) < 0.0 ? Vec3(-normal_S) : normal_S;
}

} // namespace

std::optional<ContactPlace> placeOf(const Scene& scene, const Vec3& proxy_W, const Vec3& device_W)
{
  NearestPoint best;
  double least_u = std::numeric_limits<double>::infinity();
  const Surface* nearest = nullptr;
  for (const Surface& surface : scene.surfaces())
  {
    const NearestPoint at = nearestOn(surface.tree->data(), into(surface.motion.end_WS, proxy_W));
    if (const double gap_u = at.distance_u - surface.tree->coat_u(); gap_u < least_u)
    {
      least_u = gap_u;
      best = at;
      nearest = &surface;
    }
  }
  if (nearest == nullptr)
  {
    return std::nullopt;
  }
  const Pose& pose_WS = nearest->motion.end_WS;
  const SurfaceTree& tree = *nearest->tree;
  const Vec3 normal_S = normalOf(tree.data(), best, into(pose_WS, proxy_W), into(pose_WS, device_W));
  ContactPlace place{ nearest->name, best.triangle, pose_WS * best.p_W, pose_WS.q * normal_S,
    curvatureAt(tree, best.triangle, best.p_W, normal_S), std::nullopt };
  if (tree.coat_u() == 0.0)
  {
    place.thickness_u = wallThickness_u(tree, best.p_W, -normal_S);
  }
  return place;
}

} // namespace palpate
