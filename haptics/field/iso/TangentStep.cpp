// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/field/iso/TangentStep.h"

#include <algorithm>
#include <cmath>

#include "haptics/core/Across.h"

namespace palpate
{
namespace
{

constexpr double leastCurvature = 0.1; ///< of the Lagrangian: a saddle is left by steps that are not too long

double away(double curvature) noexcept
{
  return std::max(std::fabs(curvature), leastCurvature);
}

double hessian(const IsoRows& rows, const ProjectionResult& y_u, const Vec3& a, const Vec3& b) noexcept
{
  double sum = a.dot(b);
  for (int i = 0; i < y_u.count; ++i)
  {
    sum -= y_u.lambda[i] * rows.row[y_u.active[i]].bending(a, b);
  }
  return sum;
}

/// Solves [[xx, xy], [xy, yy]] u = (x, y) with eigenvalues made positive.
Eigen::Vector2d solvePositive(double xx, double xy, double yy, const Eigen::Vector2d& right) noexcept
{
  const double mean = 0.5 * (xx + yy), half = 0.5 * (xx - yy), radius = std::sqrt(half * half + xy * xy);
  if (radius == 0.0)
  {
    return right / away(mean);
  }
  // The eigenvector of the larger one, by the longer of its two forms.
  Eigen::Vector2d e = half >= 0.0 ? Eigen::Vector2d(radius + half, xy) : Eigen::Vector2d(xy, radius - half);
  e.normalize();
  const Eigen::Vector2d f(-e.y(), e.x());
  return (e.dot(right) / away(mean + radius)) * e + (f.dot(right) / away(mean - radius)) * f;
}

} // namespace

Vec3 tangentStep(const IsoRows& rows, const ProjectionResult& y_u) noexcept
{
  const Vec3& n = rows.row[y_u.active[0]].n;
  if (y_u.count == 1)
  {
    const auto [a, b] = tangentsOf(n);
    const Eigen::Vector2d right(a.dot(y_u.y), b.dot(y_u.y));
    const Eigen::Vector2d u =
      solvePositive(hessian(rows, y_u, a, a), hessian(rows, y_u, a, b), hessian(rows, y_u, b, b), right);
    return y_u.y + (u.x() - right.x()) * a + (u.y() - right.y()) * b;
  }
  if (y_u.count == 2)
  {
    const Vec3 along = n.cross(rows.row[y_u.active[1]].n).normalized();
    const double right = along.dot(y_u.y);
    return y_u.y + (right / away(hessian(rows, y_u, along, along)) - right) * along;
  }
  return y_u.y;
}

} // namespace palpate
