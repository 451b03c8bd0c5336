// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/contact/Roll.h"

#include <algorithm>
#include <array>
#include <limits>

namespace palpate
{
namespace
{

struct Pivot
{
  FeaturePlane plane;
  Vec3 axis = Vec3::Zero(); ///< unit along an edge, zero for a vertex
  Vec3 w = Vec3::Zero();    ///< unit tangential direction in which the ball wants to go
};

/// Tangent of the largest angle by which n may turn towards w before the ball comes to lie on an incident face.
double coneLimit(const SurfaceData& s, const ActiveFeature& f, const Pivot& pivot) noexcept
{
  double limit = std::numeric_limits<double>::infinity();
  const auto include = [&](const Vec3& t)
  {
    const double turn = t.dot(pivot.w);
    if (turn > 0.0)
    {
      limit = std::min(limit, std::max(0.0, -t.dot(pivot.plane.n) / turn));
    }
  };
  if (f.kind == FeatureKind::Edge)
  {
    s.forEachAtEdge(f.a, f.b,
      [&](std::uint32_t triangle)
      {
        const Vec3 inward = s.vertex(s.opposite(triangle, f.a, f.b)) - s.vertex(f.a);
        include(inward - inward.dot(pivot.axis) * pivot.axis);
      });
    return limit;
  }
  for (std::uint32_t k = s.fanStart[f.a]; k < s.fanStart[f.a + 1]; ++k)
  {
    for (const std::uint32_t corner : s.mesh.triangles[s.fan[k]])
    {
      include(s.vertex(corner) - s.vertex(f.a));
    }
  }
  return limit;
}

/// The normal the ball is to have after the roll.
Vec3 targetNormal(const SurfaceData& s, const ActiveFeature& f, const Pivot& pivot, const Vec3& pull_W, double r) noexcept
{
  const double limit = coneLimit(s, f, pivot);
  Vec3 v = pull_W - pivot.plane.foot_W;
  v -= v.dot(pivot.axis) * pivot.axis;
  const double along = v.dot(pivot.plane.n);
  if (v.squaredNorm() < r * r && along > 0.0 && v.dot(pivot.w) <= limit * along)
  {
    return v.normalized();
  }
  return (pivot.plane.n + std::min(limit, 1.0) * pivot.w).normalized();
}

} // namespace

RollPlan planRoll(const ContactSet& contacts, const Vec3& x_W, const Vec3& p_W, double radius_u,
  const ProjectionResult& solution) noexcept
{
  constexpr int most = GodObjectState::maxFeatures;
  std::array<PlaneRow, most + 3> both;
  std::array<PlaneRow, most> replaced;
  const int count = contacts.count();
  for (int i = 0; i < count; ++i)
  {
    both[i] = replaced[i] = contacts.row(i, 0.0);
  }
  int targets = 0;
  for (int k = 0; k < solution.count; ++k)
  {
    const int i = solution.active[k];
    const ActiveFeature& f = contacts.features()[i];
    if (f.kind == FeatureKind::Face || solution.lambda[k] <= 0.0)
    {
      continue;
    }
    const SurfaceData& s = contacts.dataOf(f);
    Pivot pivot{ contacts.plane(f) };
    if (f.kind == FeatureKind::Edge)
    {
      pivot.axis = edgeLine(s, f.a, f.b).unit;
    }
    pivot.w = solution.y - solution.y.dot(pivot.plane.n) * pivot.plane.n;
    pivot.w -= pivot.w.dot(pivot.axis) * pivot.axis;
    const double reach = pivot.w.norm();
    if (reach <= contacts.resolution().tol())
    {
      continue;
    }
    pivot.w /= reach;
    const Vec3 pull_W = x_W + (solution.y - solution.lambda[k] * pivot.plane.n); // p and the other reactions
    const Vec3 n = targetNormal(s, f, pivot, pull_W, radius_u);
    if ((n - pivot.plane.n).norm() * radius_u <= contacts.resolution().tol())
    {
      continue;
    }
    replaced[i] = { n, radius_u - n.dot(x_W - pivot.plane.foot_W) };
    both[count + targets++] = replaced[i];
  }
  RollPlan plan;
  if (targets == 0)
  {
    return plan;
  }
  const double slack = 0.25 * contacts.resolution().tol();
  const Vec3 q = p_W - x_W;
  const ProjectionResult first = projectOntoPlanes({ both.data(), static_cast<std::size_t>(count + targets) }, q, slack);
  const ProjectionResult second = projectOntoPlanes({ replaced.data(), static_cast<std::size_t>(count) }, q, slack);
  plan.worthwhile = first.feasible && second.feasible && (second.y - q).squaredNorm() < q.squaredNorm();
  plan.first = first.y;
  plan.second = second.y;
  return plan;
}

} // namespace palpate
