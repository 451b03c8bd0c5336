// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/compliance/body/NaturalPeriod.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace palpate
{
namespace
{

/// Mass of each node [kg]: every point's volume goes to its nodes in equal parts.
std::vector<double> massOfNodes(const StrainPoints& points, double kg_per_u3)
{
  std::vector<double> mass(points.rest_W.size(), 0.0);
  for (const StrainPoint& p : points.points)
  {
    for (const std::uint32_t node : points.nodesOf(p))
    {
      mass[node] += kg_per_u3 * p.volume_u3 / static_cast<double>(p.count);
    }
  }
  return mass;
}

} // namespace

double naturalPeriod_s(const SoftBody& body, double density_kg_per_m3, double unit_m)
{
  const std::vector<double> mass = massOfNodes(body.points(), density_kg_per_m3 * unit_m * unit_m * unit_m);
  double longest_s = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    Eigen::VectorXd weight = Eigen::VectorXd::Zero(body.displacement().size());
    for (std::size_t n = 0; n < mass.size(); ++n)
    {
      weight[3 * static_cast<Eigen::Index>(n) + axis] = mass[n];
    }
    const Eigen::VectorXd shape = body.linearAnswer(weight);
    double moved = 0.0; // kg u^2
    for (std::size_t n = 0; n < mass.size(); ++n)
    {
      moved += mass[n] * shape.segment<3>(3 * static_cast<Eigen::Index>(n)).squaredNorm();
    }
    // A newton accelerates a kilogram by 1 / unit_m units per second squared.
    longest_s = std::max(longest_s, 2.0 * std::numbers::pi * std::sqrt(moved * unit_m / shape.dot(weight)));
  }
  return longest_s;
}

} // namespace palpate
