// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/support/FrictionCone.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "testing/support/ExactTriangles.h"
#include "testing/support/Linear.h"

namespace palpate::test
{
namespace
{

/// Normals that differ by less are one.
constexpr double sameShare = 1e-9;
/// The tip of a cone of thousands of faces is asked about its faces one by one and about the best choice of them, and
/// in pairs or threes no longer.
constexpr std::size_t mostInPairs = 300, mostInThrees = 24;

Vec3 rounded(const Rational::Vector_3& v)
{
  // A sliver's exact normal may be too small for its square to be a double.
  const auto largest = std::max({ CGAL::abs(v.x()), CGAL::abs(v.y()), CGAL::abs(v.z()) });
  return Vec3(CGAL::to_double(v.x() / largest), CGAL::to_double(v.y() / largest), CGAL::to_double(v.z() / largest))
    .normalized();
}

Vec3 faceNormal(const TriangleMesh& mesh, std::uint32_t t, const Vec3& seenFrom_W)
{
  const auto triangle = triangleOf<Rational>(mesh, t);
  const auto normal = CGAL::normal(triangle.vertex(0), triangle.vertex(1), triangle.vertex(2));
  const auto height = normal * (pointOf<Rational>(seenFrom_W) - triangle.vertex(0));
  return height == 0 ? Vec3(Vec3::Zero()) : Vec3(CGAL::sign(height) * rounded(normal));
}

Vec3 nearestPoint(const TriangleMesh& mesh, std::uint32_t t, const Vec3& x_W)
{
  const auto nearest =
    Filtered().construct_projected_point_3_object()(triangleOf<Filtered>(mesh, t), pointOf<Filtered>(x_W));
  return { nearest.x(), nearest.y(), nearest.z() };
}

/// The least rest of the pull beside the cone of all normals, by active sets (Lawson & Hanson 1974): the tip of a cone
/// of thousands of faces may rest on any three of them.
Eigen::Matrix3Xd nearestChoice(std::span<const Vec3> normals, const Vec3& pull_W)
{
  constexpr int mostRounds = 100;
  Eigen::Matrix3Xd chosen(3, 0);
  Vec3 left = pull_W;
  for (int round = 0; round < mostRounds && !normals.empty(); ++round)
  {
    const auto against = [&left](const Vec3& a, const Vec3& b) { return a.dot(left) < b.dot(left); };
    const Vec3& next = *std::min_element(normals.begin(), normals.end(), against);
    if (next.dot(left) >= -sameShare * pull_W.norm())
    {
      break;
    }
    chosen.conservativeResize(3, chosen.cols() + 1);
    chosen.rightCols(1) = next;
    Eigen::VectorXd depths = solved(chosen, -pull_W);
    for (Eigen::Index worst = 0; depths.size() > 1 && depths.minCoeff(&worst) < 0.0;)
    {
      chosen.col(worst) = chosen.rightCols(1).eval();
      chosen.conservativeResize(3, chosen.cols() - 1);
      depths = solved(chosen, -pull_W);
    }
    left = pull_W + chosen * depths;
  }
  return chosen;
}

/// One choice of normals: the rest of the pull in their planes beyond their friction; infinite if one would pull.
double beyond(const Eigen::Matrix3Xd& normals, const Vec3& pull_W, double mu)
{
  const Eigen::VectorXd depths = solved(normals, -pull_W);
  const Vec3 left = pull_W + normals * depths;
  return depths.minCoeff() < 0.0 ? std::numeric_limits<double>::infinity() : left.norm() - mu * depths.sum();
}

} // namespace

std::vector<Vec3> touchedNormals(const TriangleGrid& grid, const Vec3& centre_W, double radius_u, double reach_u)
{
  std::vector<Vec3> normals;
  for (const std::uint32_t t : grid.near(centre_W, centre_W, radius_u + reach_u))
  {
    const Vec3 way = centre_W - nearestPoint(grid.mesh(), t, centre_W);
    if (way.norm() > radius_u + reach_u)
    {
      continue;
    }
    const Vec3 normal = radius_u > 0.0 ? Vec3(way.normalized()) : faceNormal(grid.mesh(), t, centre_W);
    const auto same = [&](const Vec3& other) { return (other - normal).norm() <= sameShare; };
    if (normal != Vec3::Zero() && std::none_of(normals.begin(), normals.end(), same))
    {
      normals.push_back(normal);
    }
  }
  return normals;
}

bool touches(const TriangleGrid& grid, const Vec3& centre_W, double reach_u)
{
  const std::vector<std::uint32_t> near = grid.near(centre_W, centre_W, reach_u);
  return std::any_of(near.begin(), near.end(),
    [&](std::uint32_t t) { return (nearestPoint(grid.mesh(), t, centre_W) - centre_W).norm() <= reach_u; });
}

double beyondFriction(std::span<const Vec3> normals, const Vec3& pull_W, double mu)
{
  double least = std::numeric_limits<double>::infinity();
  const auto take = [&](const Eigen::Matrix3Xd& chosen) { least = std::min(least, beyond(chosen, pull_W, mu)); };
  if (normals.size() > mostInThrees)
  {
    take(nearestChoice(normals, pull_W));
  }
  for (std::size_t i = 0; i < normals.size() && least > 0.0; ++i)
  {
    take(normals[i]);
    for (std::size_t j = i + 1; j < normals.size() && normals.size() <= mostInPairs && least > 0.0; ++j)
    {
      Eigen::Matrix3Xd two(3, 2);
      two << normals[i], normals[j];
      take(two);
      for (std::size_t k = j + 1; k < normals.size() && normals.size() <= mostInThrees && least > 0.0; ++k)
      {
        Eigen::Matrix3Xd three(3, 3);
        three << normals[i], normals[j], normals[k];
        take(three);
      }
    }
  }
  return std::max(0.0, least);
}

} // namespace palpate::test
