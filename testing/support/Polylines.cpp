// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/support/Polylines.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "testing/support/Random.h"

namespace palpate::test
{
namespace
{

double oneWay(const std::vector<Vec3>& from_W, const std::vector<Vec3>& to_W, int samples)
{
  double most_u = 0.0;
  for (std::size_t i = 1; i < from_W.size(); ++i)
  {
    for (int k = 0; k <= samples; ++k)
    {
      const double share = static_cast<double>(k) / samples;
      const Vec3 p_W = (1.0 - share) * from_W[i - 1] + share * from_W[i];
      most_u = std::max(most_u, distanceToPolyline(p_W, to_W));
    }
  }
  return most_u;
}

} // namespace

std::vector<Vec3> wavyLine(std::uint64_t seed, std::size_t points, bool ring)
{
  Random random(seed);
  double size[5], phase[5];
  for (int k = 0; k < 5; ++k)
  {
    size[k] = random.uniform(0.0, 0.3 / (k + 1));
    phase[k] = random.uniform(0.0, 2 * std::numbers::pi);
  }
  std::vector<Vec3> line_W;
  const double whole = (ring ? 2.0 : 1.3) * std::numbers::pi;
  for (std::size_t i = 0; i < points; ++i)
  {
    const double t = whole * static_cast<double>(i) / static_cast<double>(points - 1);
    double r = 1.0;
    for (int k = 0; k < 5; ++k)
    {
      r += size[k] * std::sin((1 << k) * t + phase[k]);
    }
    line_W.emplace_back(r * std::cos(t), r * std::sin(t), 0.0);
  }
  if (ring)
  {
    line_W.back() = line_W.front();
  }
  return line_W;
}

std::vector<Vec3> pick(const std::vector<Vec3>& points_W, const std::vector<std::uint32_t>& indices)
{
  std::vector<Vec3> picked_W;
  for (const std::uint32_t i : indices)
  {
    picked_W.push_back(points_W[i]);
  }
  return picked_W;
}

double distanceToPolyline(const Vec3& p_W, const std::vector<Vec3>& polyline_W)
{
  double least_u = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < polyline_W.size(); ++i)
  {
    const Vec3 a_W = polyline_W[i - 1], along = polyline_W[i] - a_W;
    const double length2 = along.squaredNorm();
    const double t = length2 > 0.0 ? (p_W - a_W).dot(along) / length2 : 0.0;
    least_u = std::min(least_u, (p_W - a_W - std::clamp(t, 0.0, 1.0) * along).norm());
  }
  return least_u;
}

double hausdorffFromBelow(const std::vector<Vec3>& a_W, const std::vector<Vec3>& b_W, int samples)
{
  return std::max(oneWay(a_W, b_W, samples), oneWay(b_W, a_W, samples));
}

} // namespace palpate::test
