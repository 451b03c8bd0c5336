// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/support/QpOracle.h"

#include <array>
#include <optional>
#include <vector>

#include <CGAL/Exact_rational.h>

namespace palpate::test
{
namespace
{

using Rational = CGAL::Exact_rational;
using Exact3 = std::array<Rational, 3>;

Exact3 exact(const Vec3& v)
{
  return { Rational(v.x()), Rational(v.y()), Rational(v.z()) };
}

Rational dot(const Exact3& a, const Exact3& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

struct ExactRow
{
  Exact3 n;
  Rational bound;
};

/// Gauss elimination of the k x k system; nothing if it is singular.
std::optional<std::vector<Rational>> solved(std::vector<std::vector<Rational>> a)
{
  const std::size_t k = a.size();
  for (std::size_t column = 0; column < k; ++column)
  {
    std::size_t pivot = column;
    while (pivot < k && a[pivot][column] == 0)
    {
      ++pivot;
    }
    if (pivot == k)
    {
      return std::nullopt;
    }
    std::swap(a[pivot], a[column]);
    for (std::size_t row = 0; row < k; ++row)
    {
      const Rational factor = row == column ? Rational(0) : Rational(a[row][column] / a[column][column]);
      for (std::size_t c = column; factor != 0 && c <= k; ++c)
      {
        a[row][c] -= factor * a[column][c];
      }
    }
  }
  std::vector<Rational> x;
  for (std::size_t row = 0; row < k; ++row)
  {
    x.push_back(a[row][k] / a[row][row]);
  }
  return x;
}

/// The point q + sum l_i n_i on all planes of the set, if the set is independent, l >= 0 and all rows hold.
std::optional<Exact3> candidate(const std::vector<ExactRow>& rows, const Exact3& q, const std::vector<std::size_t>& set)
{
  std::vector<std::vector<Rational>> system;
  for (const std::size_t i : set)
  {
    system.emplace_back();
    for (const std::size_t j : set)
    {
      system.back().push_back(dot(rows[i].n, rows[j].n));
    }
    system.back().push_back(rows[i].bound - dot(rows[i].n, q));
  }
  const auto l = solved(std::move(system));
  if (!l)
  {
    return std::nullopt;
  }
  Exact3 y = q;
  for (std::size_t m = 0; m < set.size(); ++m)
  {
    if ((*l)[m] < 0)
    {
      return std::nullopt;
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      y[axis] += (*l)[m] * rows[set[m]].n[axis];
    }
  }
  for (const ExactRow& row : rows)
  {
    if (dot(row.n, y) < row.bound)
    {
      return std::nullopt;
    }
  }
  return y;
}

std::vector<std::vector<std::size_t>> setsOfAtMostThree(std::size_t count)
{
  std::vector<std::vector<std::size_t>> sets = { {} };
  for (std::size_t begin = 0, size = 0; size < 3; ++size)
  {
    const std::size_t end = sets.size();
    for (; begin < end; ++begin)
    {
      for (std::size_t next = sets[begin].empty() ? 0 : sets[begin].back() + 1; next < count; ++next)
      {
        sets.push_back(sets[begin]);
        sets.back().push_back(next);
      }
    }
  }
  return sets;
}

} // namespace

ExactProjection projectExactly(std::span<const PlaneRow> rows, const Vec3& q)
{
  std::vector<ExactRow> exactRows;
  for (const PlaneRow& row : rows)
  {
    exactRows.push_back({ exact(row.n), Rational(row.bound) });
  }
  for (const auto& set : setsOfAtMostThree(rows.size()))
  {
    if (const auto y = candidate(exactRows, exact(q), set))
    {
      return { true, { CGAL::to_double((*y)[0]), CGAL::to_double((*y)[1]), CGAL::to_double((*y)[2]) } };
    }
  }
  return {};
}

} // namespace palpate::test
