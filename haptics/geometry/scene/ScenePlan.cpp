// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/scene/ScenePlan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <numbers>
#include <sstream>
#include <stdexcept>

#include "haptics/geometry/tree/SurfaceData.h"

namespace palpate
{
namespace
{

constexpr double sharpest_rad = std::numbers::pi / 6;

/// A triangle in its own plane: where its edges' middles are, and how the smooth surface is tilted there.
struct Facet
{
  std::array<Vec3, 3> middle_W; ///< of edge k, which joins corners k and (k + 1) % 3
  std::array<Vec3, 3> tilt;     ///< of the normal in the middle of edge k, in the plane of the triangle
  int sharp = 0;                ///< edges that are meant to be sharp
};

Vec3 normalOf(const SurfaceData& data, std::uint32_t triangle)
{
  const auto& [a, b, c] = data.mesh.triangles[triangle];
  return (data.vertex(b) - data.vertex(a)).cross(data.vertex(c) - data.vertex(a)).normalized();
}

/// How a smooth surface bends across an edge.
struct Bend
{
  double angle_rad = 0.0; ///< from one triangle to the other, positive where it falls away from the normal
  double share = 0.5;     ///< of it up to the edge: as far as this triangle reaches from the edge, of both
};

/// From triangle (i, j, ...) across its edge; none where there is no single other triangle. `outward` lies in the
/// triangle's plane, across the edge.
Bend bendAcross(const SurfaceData& data, std::uint32_t triangle, std::uint32_t i, std::uint32_t j, const Vec3& normal,
  const Vec3& outward)
{
  const std::uint32_t other = data.neighbour(triangle, i, j);
  if (other == SurfaceData::none)
  {
    return {};
  }
  // Corners stand in ascending order, so the sides of two triangles need not agree; seen from the edge they do.
  const Vec3 edge = data.vertex(j) - data.vertex(i);
  const Vec3 across = data.vertex(data.opposite(other, i, j)) - data.vertex(i);
  const Vec3 away = across - across.dot(edge) / edge.squaredNorm() * edge;
  const double reach = -outward.dot(data.vertex(data.opposite(triangle, i, j)) - data.vertex(i));
  return { -std::atan2(away.dot(normal), away.dot(outward)), reach / (reach + away.norm()) };
}

Facet facetOf(const SurfaceData& data, std::uint32_t triangle)
{
  Facet facet;
  const auto& corners = data.mesh.triangles[triangle];
  const Vec3 normal = normalOf(data, triangle);
  for (std::size_t k = 0; k < 3; ++k)
  {
    const std::uint32_t i = corners[k], j = corners[(k + 1) % 3];
    const Vec3 outward = (data.vertex(j) - data.vertex(i)).normalized().cross(normal);
    const Bend bend = bendAcross(data, triangle, i, j, normal, outward);
    const bool sharp = std::abs(bend.angle_rad) > sharpest_rad;
    facet.middle_W[k] = 0.5 * (data.vertex(i) + data.vertex(j));
    facet.tilt[k] = sharp ? Vec3(Vec3::Zero()) : Vec3(std::tan(bend.share * bend.angle_rad) * outward);
    facet.sharp += sharp;
  }
  return facet;
}

/// The largest of |x l0 l1 + y l1 l2 + z l2 l0| over weights l >= 0 that add up to 1: how far a quadratic that passes
/// through the corners stands off the triangle.
double furthest(double x, double y, double z)
{
  const double onEdges = std::max({ std::abs(x), std::abs(y), std::abs(z) }) / 4;
  const double d = 2 * (x * y + y * z + z * x) - x * x - y * y - z * z;
  const std::array<double, 3> weights{ y * (x + z - y), z * (x + y - z), x * (y + z - x) };
  // Where d is lost in rounding the extremum lies on an edge, or nowhere.
  const bool inside = d > 1e-6 * (x * x + y * y + z * z) &&
                      std::all_of(weights.begin(), weights.end(), [](double w) { return w >= 0.0; });
  return inside ? std::max(onEdges, std::abs(x * y * z / d)) : onEdges;
}

/// Between the middles of two edges the normal turns by the surface's bend along half of the third.
double sagitta_u(const Facet& facet)
{
  const auto bendAlong = [&facet](std::size_t first, std::size_t second)
  { return 2 * (facet.middle_W[second] - facet.middle_W[first]).dot(facet.tilt[second] - facet.tilt[first]); };
  return furthest(bendAlong(1, 2), bendAlong(2, 0), bendAlong(0, 1));
}

void check(const TouchConditions& conditions)
{
  const auto positive = [](double value) { return std::isfinite(value) && value > 0.0; };
  if (!positive(conditions.scale_u_per_m) || !positive(conditions.penetration_m) ||
      !std::isfinite(conditions.stiffness_N_per_m) || conditions.stiffness_N_per_m < 0.0 ||
      !std::isfinite(conditions.resolution_m) || conditions.resolution_m < 0.0)
  {
    throw std::invalid_argument("scale and penetration must be above 0, stiffness and resolution must not be negative");
  }
}

} // namespace

ScenePlan planTouch(const SurfaceTree& surface, const TouchConditions& conditions)
{
  check(conditions);
  const SurfaceData& data = surface.data();
  ScenePlan plan;
  plan.conditions = conditions;
  plan.triangles = data.mesh.triangles.size();
  std::size_t sharpSides = 0;
  for (std::uint32_t t = 0; t < plan.triangles && surface.coat_u() == 0.0; ++t)
  {
    const Facet facet = facetOf(data, t);
    plan.deviation_u = std::max(plan.deviation_u, sagitta_u(facet));
    sharpSides += static_cast<std::size_t>(facet.sharp);
  }
  plan.sharpEdges = sharpSides / 2;
  plan.deviation_m = plan.deviation_u / conditions.scale_u_per_m;
  plan.forceError = plan.deviation_m / conditions.penetration_m;
  const double limit_m = plan.unnoticed_u() / conditions.scale_u_per_m;
  plan.felt = plan.deviation_m > limit_m;
  const double needed = std::ceil(static_cast<double>(plan.triangles) * plan.deviation_m / limit_m);
  plan.trianglesNeeded = static_cast<std::size_t>(std::min(needed, 1e15));
  return plan;
}

double ScenePlan::unnoticed_u() const
{
  return std::max(noticed * this->conditions.penetration_m, this->conditions.resolution_m) *
         this->conditions.scale_u_per_m;
}

std::string ScenePlan::sentence() const
{
  std::ostringstream text;
  text.precision(3);
  text << "pressed " << 1e3 * this->conditions.penetration_m << " mm deep at " << std::setprecision(6)
       << this->conditions.stiffness_N_per_m << std::setprecision(3) << " N/m, facets change the force by up to "
       << 100 * this->forceError << " % (" << 1e3 * this->deviation_m << " mm at the hand, "
       << this->deviation_m * this->conditions.stiffness_N_per_m << " N): ";
  if (!this->felt)
  {
    text << "below the perceptible force";
  }
  else
  {
    text << "felt; about " << this->trianglesNeeded << " triangles would feel smooth, it has " << this->triangles;
  }
  if (this->sharpEdges > 0)
  {
    text << "; " << this->sharpEdges << " edges sharper than 30 degrees are kept as features";
  }
  return text.str();
}

} // namespace palpate
