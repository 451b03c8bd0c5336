// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/compliance/material/PrincipalStretches.h"

#include <cmath>
#include <limits>
#include <utility>

#include "haptics/core/Across.h"

namespace palpate
{
namespace
{

/// Rotates columns i and j of b = F v in their plane until they are orthogonal; false if they were.
bool straighten(Mat3& b, Mat3& v, int i, int j)
{
  const double both = b.col(i).dot(b.col(j));
  const double first = b.col(i).squaredNorm();
  const double second = b.col(j).squaredNorm();
  if (std::abs(both) <= std::numeric_limits<double>::epsilon() * std::sqrt(first * second))
  {
    return false;
  }
  const double ratio = (second - first) / (2.0 * both);
  const double tangent = (ratio >= 0.0 ? 1.0 : -1.0) / (std::abs(ratio) + std::sqrt(1.0 + ratio * ratio));
  const double cosine = 1.0 / std::sqrt(1.0 + tangent * tangent);
  const double sine = tangent * cosine;
  for (Mat3* const m : { &b, &v })
  {
    const Vec3 before = m->col(i);
    m->col(i) = cosine * before - sine * m->col(j);
    m->col(j) = sine * before + cosine * m->col(j);
  }
  return true;
}

/// Sorts the columns of b, and of v alike, from the longest to the shortest; v stays a rotation.
void sortColumns(Mat3& b, Mat3& v)
{
  for (const auto& [i, j] : { std::pair(0, 1), std::pair(1, 2), std::pair(0, 1) })
  {
    if (b.col(i).squaredNorm() < b.col(j).squaredNorm())
    {
      b.col(i).swap(b.col(j));
      v.col(i).swap(v.col(j));
      b.col(j) *= -1.0;
      v.col(j) *= -1.0;
    }
  }
}

} // namespace

PrincipalStretches principalStretches(const Mat3& f)
{
  constexpr int mostSweeps = 12; // four are usual
  PrincipalStretches p;
  Mat3 b = f;
  bool straight = false;
  for (int sweep = 0; sweep < mostSweeps && !straight; ++sweep)
  {
    straight = true;
    for (const auto& [i, j] : { std::pair(0, 1), std::pair(0, 2), std::pair(1, 2) })
    {
      straight = !straighten(b, p.v, i, j) && straight;
    }
  }
  sortColumns(b, p.v);
  const double longest = b.col(0).norm();
  const Vec3 first = longest > 0.0 ? Vec3(b.col(0) / longest) : Vec3(Vec3::UnitX());
  const Vec3 across = b.col(1) - first.dot(b.col(1)) * first;
  p.u.col(0) = first;
  p.u.col(1) = across.norm() > 1e-14 * longest ? Vec3(across.normalized()) : acrossOf(first);
  p.u.col(2) = p.u.col(0).cross(p.u.col(1));
  p.s = p.u.cwiseProduct(b).colwise().sum();
  return p;
}

} // namespace palpate
