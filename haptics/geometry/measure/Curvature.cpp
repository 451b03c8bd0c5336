// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/measure/Curvature.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include <Eigen/QR>

#include "haptics/core/PoseMath.h"
#include "haptics/geometry/tree/SurfaceData.h"

namespace palpate
{
namespace
{

constexpr int unknowns = 6; // z = a x^2 / 2 + b x y + c y^2 / 2 + d x + e y + f

/// Vertices of the triangle and of those around its vertices, `rings` times.
std::set<std::uint32_t> verticesAround(const SurfaceData& data, std::uint32_t triangle, int rings)
{
  constexpr double smallestCosine = 0.5; // 60 degrees
  const Vec3& normal_W = data.plane(triangle).normal_W;
  const auto& corners = data.corners(triangle);
  std::set<std::uint32_t> found(corners.begin(), corners.end());
  std::vector<std::uint32_t> rim(corners.begin(), corners.end());
  for (int ring = 0; ring < rings; ++ring)
  {
    std::vector<std::uint32_t> next;
    for (const std::uint32_t v : rim)
    {
      data.forEachAround(v,
        [&](std::uint32_t t)
        {
          if (std::abs(data.plane(t).normal_W.dot(normal_W)) < smallestCosine) // corners are sorted: sides say nothing
          {
            return;
          }
          for (const std::uint32_t corner : data.corners(t))
          {
            if (found.insert(corner).second)
            {
              next.push_back(corner);
            }
          }
        });
    }
    rim = std::move(next);
  }
  return found;
}

/// Coefficients a to f, in a unit in which the vertices are about 1 away; nothing if they do not say.
std::optional<Eigen::Matrix<double, unknowns, 1>> fit(const std::vector<Vec3>& local)
{
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(local.size()), unknowns);
  Eigen::VectorXd heights(rows.rows());
  for (Eigen::Index i = 0; i < rows.rows(); ++i)
  {
    const Vec3& p = local[static_cast<std::size_t>(i)];
    rows.row(i) << 0.5 * p.x() * p.x(), p.x() * p.y(), 0.5 * p.y() * p.y(), p.x(), p.y(), 1.0;
    heights[i] = p.z();
  }
  constexpr double rounding = 1e-10;
  if (heights.cwiseAbs().maxCoeff() < rounding)
  {
    return Eigen::Matrix<double, unknowns, 1>::Zero(); // flat, however few they are
  }
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> solver(rows.rows(), unknowns);
  solver.setThreshold(1e-8);
  solver.compute(rows);
  if (solver.rank() < unknowns)
  {
    return std::nullopt;
  }
  return solver.solve(heights);
}

/// From the first and second fundamental form of the quadric over the origin, the second along two orthonormal
/// tangents.
Curvature curvatureOf(const Eigen::Matrix<double, unknowns, 1>& k, double unit_u)
{
  const double d = k[3], e = k[4], along2 = 1.0 + d * d, w2 = along2 + e * e;
  const Eigen::Vector2d first(1.0 / std::sqrt(along2), 0.0);
  const Eigen::Vector2d second = Eigen::Vector2d(-d * e, along2) / std::sqrt(along2 * w2);
  Eigen::Matrix2d form;
  form << k[0], k[1], k[1], k[2];
  form /= std::sqrt(w2);
  const double mean = 0.5 * (first.dot(form * first) + second.dot(form * second));
  const double half = 0.5 * (first.dot(form * first) - second.dot(form * second));
  const double apart = std::hypot(half, first.dot(form * second));
  return { -(mean - apart) / unit_u, -(mean + apart) / unit_u }; // a bulge has its vertices below
}

} // namespace

std::optional<Curvature> curvatureAt(
  const SurfaceTree& surface, std::uint32_t triangle, const Vec3& p_W, const Vec3& outward_W)
{
  const SurfaceData& data = surface.data();
  if (data.coat_u > 0.0)
  {
    return std::nullopt;
  }
  constexpr int rings = 2;
  const std::set<std::uint32_t> around = verticesAround(data, triangle, rings);
  const Quat toLocal = shortestTurn(outward_W, Vec3::UnitZ());
  double unit_u = 0.0;
  for (const std::uint32_t v : around)
  {
    unit_u += (data.vertex(v) - p_W).norm() / static_cast<double>(around.size());
  }
  std::vector<Vec3> local;
  for (const std::uint32_t v : around)
  {
    local.emplace_back(toLocal * (data.vertex(v) - p_W) / unit_u);
  }
  const auto fitted = fit(local);
  return fitted ? std::optional<Curvature>(curvatureOf(*fitted, unit_u)) : std::nullopt;
}

} // namespace palpate
