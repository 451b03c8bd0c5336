// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/support/FieldOracle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace palpate::test
{
namespace
{

using Quad = __float128;
using Quad3 = std::array<Quad, 3>;

Quad3 indexOf(const GridPlace& place)
{
  Quad3 index;
  for (int k = 0; k < 3; ++k)
  {
    index[k] = static_cast<Quad>(place.cell[k]) + static_cast<Quad>(place.t[k]);
  }
  return index;
}

/// The polynomial of a cell as the sum over its corners of a value times three weights.
Quad polynomial(const FieldBlockComponent& field, const GridIndex& cell, const Quad3& at, double level, double side)
{
  const TrilinearCell corners = field.cell(cell);
  Quad sum = 0;
  for (int i = 0; i < 8; ++i)
  {
    Quad weight = 1;
    for (int k = 0; k < 3; ++k)
    {
      const Quad t = at[k] - static_cast<Quad>(cell[k]);
      weight *= (i >> k & 1) != 0 ? t : 1 - t;
    }
    sum += weight * (static_cast<Quad>(corners.corner[i]) - static_cast<Quad>(level));
  }
  return side > 0.0 ? sum : -sum;
}

Quad3 along(const Quad3& from, const Quad3& to, Quad s)
{
  return { from[0] + s * (to[0] - from[0]), from[1] + s * (to[1] - from[1]), from[2] + s * (to[2] - from[2]) };
}

/// The least value of a cubic with these Bernstein coefficients, from below, as long as it is below `floor`.
Quad leastOf(const std::array<Quad, 4>& b, Quad floor, int depth)
{
  const Quad lowest = *std::min_element(b.begin(), b.end());
  if (lowest >= floor || depth == 0)
  {
    return lowest;
  }
  const Quad m01 = (b[0] + b[1]) / 2, m12 = (b[1] + b[2]) / 2, m23 = (b[2] + b[3]) / 2;
  const Quad l = (m01 + m12) / 2, r = (m12 + m23) / 2, m = (l + r) / 2;
  return std::min(leastOf({ b[0], m01, l, m }, floor, depth - 1), leastOf({ m, r, m23, b[3] }, floor, depth - 1));
}

/// Bernstein coefficients of a cubic from its values at 0, 1/3, 2/3 and 1.
std::array<Quad, 4> bernstein(const std::array<Quad, 4>& v)
{
  return { v[0], (-5 * v[0] + 18 * v[1] - 9 * v[2] + 2 * v[3]) / 6, (2 * v[0] - 9 * v[1] + 18 * v[2] - 5 * v[3]) / 6,
    v[3] };
}

/// Where a straight segment passes from cell to cell, 0 to 1.
std::vector<Quad> cuts(const Quad3& from, const Quad3& to)
{
  std::vector<Quad> cuts{ 0, 1 };
  for (int k = 0; k < 3; ++k)
  {
    const Quad low = std::min(from[k], to[k]), high = std::max(from[k], to[k]);
    for (auto plane = static_cast<long>(low); static_cast<Quad>(plane) <= high; ++plane)
    {
      const Quad s = from[k] == to[k] ? Quad(0) : (static_cast<Quad>(plane) - from[k]) / (to[k] - from[k]);
      if (s > 0 && s < 1)
      {
        cuts.push_back(s);
      }
    }
  }
  std::sort(cuts.begin(), cuts.end());
  return cuts;
}

} // namespace

double FieldOracle::largest(double level) const noexcept
{
  if (this->largest_ < 0.0 || this->largestLevel_ != level)
  {
    this->largest_ = 0.0;
    this->largestLevel_ = level;
    const GridIndex& size = this->field_.size();
    for (int z = 0; z + 1 < size[2]; ++z)
    {
      for (int y = 0; y + 1 < size[1]; ++y)
      {
        for (int x = 0; x + 1 < size[0]; ++x)
        {
          const TrilinearCell cell = this->field_.cell({ x, y, z }, level);
          this->largest_ = std::max(this->largest_, cell.valid() ? cell.largestMagnitude() : 0.0);
        }
      }
    }
  }
  return this->largest_;
}

double FieldOracle::value(const GridPlace& at, double level, double side) const noexcept
{
  const std::optional<GridPlace> place = this->field_.within(at);
  return static_cast<double>(polynomial(this->field_, place->cell, indexOf(*place), level, side));
}

void FieldOracle::piece(const GridPlace& from, const GridPlace& to, double level, double side) noexcept
{
  ++this->pieces;
  const Quad3 a = indexOf(from), b = indexOf(to);
  const Quad floor = -1e-12 * static_cast<Quad>(this->largest(level));
  const std::vector<Quad> ends = cuts(a, b);
  bool crossed = false;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i)
  {
    const Quad begin = ends[i], step = ends[i + 1] - ends[i];
    const Quad3 middle = along(a, b, begin + step / 2);
    GridIndex cell;
    for (int k = 0; k < 3; ++k)
    {
      cell[k] = std::min(static_cast<int>(middle[k]), this->field_.size()[k] - 2);
    }
    std::array<Quad, 4> values;
    for (int j = 0; j < 4; ++j)
    {
      values[j] = polynomial(this->field_, cell, along(a, b, begin + step * j / 3), level, side);
    }
    crossed = crossed || leastOf(bernstein(values), floor, 60) < floor;
  }
  this->crossed += crossed;
  const std::optional<GridPlace> end = this->field_.within(to);
  this->wrongEnds += !end || polynomial(this->field_, end->cell, b, level, side) < 0;
}

} // namespace palpate::test
