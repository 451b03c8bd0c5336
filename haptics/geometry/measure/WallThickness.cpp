// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/measure/WallThickness.h"

#include "haptics/geometry/measure/RayWalk.h"
#include "haptics/geometry/tree/SurfaceData.h"

namespace palpate
{

std::optional<double> wallThickness_u(const SurfaceTree& surface, const Vec3& p_W, const Vec3& inward_W)
{
  const SurfaceData& data = surface.data();
  const double largest_u = data.low_W.cwiseAbs().cwiseMax(data.high_W.cwiseAbs()).maxCoeff();
  const std::optional<RayHit> hit = firstHit(surface, p_W, inward_W, 1e-12 * largest_u);
  return hit ? std::optional<double>(hit->way_u) : std::nullopt;
}

} // namespace palpate
