// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/support/FreeWay.h"

#include <vector>

#include "testing/support/ExactTriangles.h"

namespace palpate::test
{
namespace
{

/// Of a length, by which a ball may come nearer; of squares twice that.
constexpr double nearerShare = 1e-9;
/// Of a squared length: the error of doubles where a ball is small against its coordinates.
constexpr double doubtShare = 1e-4;

/// Squared distance of a displacement from a triangle against the required one, in one kernel.
template<class Kernel>
bool keepsAway(const typename Kernel::Segment_3& way, const typename Kernel::Triangle_3& triangle,
  const typename Kernel::FT& radius2_u2, double share)
{
  const auto atStart = CGAL::squared_distance(way.source(), triangle);
  const typename Kernel::FT least = std::min(radius2_u2, atStart) * typename Kernel::FT(1.0 - share);
  return squaredDistance<Kernel>(way, triangle) >= least;
}

} // namespace

bool wayIsFree(const TriangleGrid& grid, const Vec3& from_W, const Vec3& to_W)
{
  const auto way = segmentOf<Filtered>(from_W, to_W);
  for (const std::uint32_t t : grid.near(from_W, to_W, 0.0))
  {
    if (CGAL::do_intersect(way, triangleOf<Filtered>(grid.mesh(), t)))
    {
      return false;
    }
  }
  return true;
}

bool wayIsFree(const TriangleGrid& grid, const Vec3& from_W, const Vec3& to_W, double radius_u)
{
  const auto way = segmentOf<Filtered>(from_W, to_W);
  const std::vector<std::uint32_t> near = grid.near(from_W, to_W, radius_u);
  for (const std::uint32_t t : near)
  {
    const auto triangle = triangleOf<Filtered>(grid.mesh(), t);
    if (CGAL::do_intersect(way, triangle) || !keepsAway<Filtered>(way, triangle, radius_u * radius_u, doubtShare))
    {
      return false;
    }
  }
  const auto exactWay = segmentOf<Rational>(from_W, to_W);
  const CGAL::Exact_rational exactRadius(radius_u);
  for (const std::uint32_t t : near)
  {
    if (!keepsAway<Rational>(
          exactWay, triangleOf<Rational>(grid.mesh(), t), exactRadius * exactRadius, 2 * nearerShare))
    {
      return false;
    }
  }
  return true;
}

} // namespace palpate::test
