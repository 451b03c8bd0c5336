// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/field/cells/CellMap.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

namespace palpate
{
namespace
{

constexpr int mostNewtonSteps = 16;
constexpr double found = 1e-12;     ///< a step of the search that is shorter ends it
constexpr double enough = 1e-7;     ///< where steps are left that are no longer, rounding of a flat cell makes them
constexpr double besideEdge = 1e-6; ///< as far from corners that coincide derivatives still have ten digits

Vec3 lerp(const Vec3& a, const Vec3& b, double t) noexcept
{
  return (1.0 - t) * a + t * b;
}

} // namespace

CellMap::CellMap(const std::array<Vec3, 8>& corners_W) noexcept : corner_W_(corners_W)
{
  double longest_u2 = 0.0, shortest_u2 = HUGE_VAL;
  for (std::size_t i = 0; i < 8; ++i)
  {
    for (const std::size_t bit : { 1U, 2U, 4U })
    {
      shortest_u2 =
        (i & bit) == 0 ? std::min(shortest_u2, (corners_W[i | bit] - corners_W[i]).squaredNorm()) : shortest_u2;
    }
    longest_u2 = i < 4 ? std::max(longest_u2, (corners_W[7 - i] - corners_W[i]).squaredNorm()) : longest_u2;
  }
  constexpr double coincide2 = 1e-24; // of the squared size: two corners that are one but for rounding
  this->size_u_ = std::sqrt(longest_u2);
  this->collapsed_ = !(shortest_u2 > coincide2 * longest_u2);
}

Vec3 CellMap::at(const Vec3& t) const noexcept
{
  const auto& c = this->corner_W_;
  return lerp(lerp(lerp(c[0], c[1], t.x()), lerp(c[2], c[3], t.x()), t.y()),
    lerp(lerp(c[4], c[5], t.x()), lerp(c[6], c[7], t.x()), t.y()), t.z());
}

Vec3 CellMap::regular(const Vec3& t) const noexcept
{
  return this->collapsed_ ? Vec3(t.cwiseMax(besideEdge).cwiseMin(1.0 - besideEdge)) : t;
}

Mat3 CellMap::jacobian(const Vec3& place) const noexcept
{
  const Vec3 t = this->regular(place);
  const auto& c = this->corner_W_;
  Mat3 j;
  j.col(0) = lerp(lerp(c[1] - c[0], c[3] - c[2], t.y()), lerp(c[5] - c[4], c[7] - c[6], t.y()), t.z());
  j.col(1) = lerp(lerp(c[2] - c[0], c[3] - c[1], t.x()), lerp(c[6] - c[4], c[7] - c[5], t.x()), t.z());
  j.col(2) = lerp(lerp(c[4] - c[0], c[5] - c[1], t.x()), lerp(c[6] - c[2], c[7] - c[3], t.x()), t.y());
  return j;
}

std::optional<Vec3> CellMap::find(const Vec3& p_W, const Vec3& start) const noexcept
{
  constexpr double outside = 1.0; // a search that is further from the cell than its length is not of this cell
  Vec3 t = start;
  double last = HUGE_VAL;
  for (int i = 0; i < mostNewtonSteps; ++i)
  {
    const Vec3 step = this->jacobian(t).inverse() * (p_W - this->at(t));
    last = step.cwiseAbs().maxCoeff();
    if (!(last < HUGE_VAL))
    {
      return {};
    }
    t = (t + step).cwiseMax(-outside).cwiseMin(1.0 + outside);
    if (last <= found)
    {
      break;
    }
  }
  // Beside corners that coincide a direction without length makes steps that never end, though the place has been
  // found.
  const bool there = (p_W - this->at(t)).norm() <= found * this->size_u_;
  return there || last <= enough ? std::optional(t) : std::nullopt;
}

} // namespace palpate
