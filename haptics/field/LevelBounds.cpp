// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/field/LevelBounds.h"

#include <array>
#include <cmath>
#include <vector>

namespace palpate
{
namespace
{

constexpr int edge = 4;            ///< cells of a block along each axis
constexpr double closeTo = 1.05;   ///< a block that may exceed the largest coefficient by no more is not looked at
constexpr int mostCells = 1 << 18; ///< looked at one by one, which is half of a second; the bound of a block for all
                                   ///< others

/// Coefficients of a polynomial of degree 2 along each axis.
using Controls = std::array<double, 27>;
constexpr std::array<int, 3> stride{ 1, 3, 9 };

/// Changes each line of three coefficients along an axis.
template<class Change>
void alongAxis(Controls& controls, int axis, const Change& change) noexcept
{
  const int step = stride[axis], one = stride[(axis + 1) % 3], two = stride[(axis + 2) % 3];
  for (int line = 0; line < 9; ++line)
  {
    double* const c = controls.data() + (line % 3) * one + (line / 3) * two;
    change(c[0], c[step], c[2 * step]);
  }
}

/// The derivative, of degree 1 along that axis, as a polynomial of degree 2.
Controls derivative(const Controls& of, int axis, double length_u) noexcept
{
  Controls slope = of;
  alongAxis(slope, axis,
    [length_u](double& a, double& b, double& c)
    {
      const double low = 2.0 * (b - a) / length_u, high = 2.0 * (c - b) / length_u;
      a = low;
      b = 0.5 * (low + high);
      c = high;
    });
  return slope;
}

/// The values of a grid, and bounds of the spline on the cells round each point.
class SplineValues
{
public:
  SplineValues(std::span<const float> values, const GridIndex& size, const Vec3& spacing_u) noexcept
    : values_(values), size_(size), spacing_u_(spacing_u)
  {
  }

  [[nodiscard]] const GridIndex& size() const noexcept { return this->size_; }

  [[nodiscard]] double value(const GridIndex& p) const noexcept
  {
    return this->values_[p[0] + static_cast<std::size_t>(this->size_[0]) *
                                  (p[1] + static_cast<std::size_t>(this->size_[1]) * p[2])];
  }

  /// The largest coefficients on the cell round a point; 0 where a value is missing.
  [[nodiscard]] LevelBounds onCell(const GridIndex& point) const noexcept
  {
    Controls controls = this->around(point);
    Vec3 length_u = this->spacing_u_;
    for (int axis = 0; axis < 3; ++axis)
    {
      this->toBernstein(controls, axis, point[axis], length_u[axis]);
    }
    std::array<Controls, 3> slope;
    std::array<std::array<Controls, 3>, 3> bend;
    for (int a = 0; a < 3; ++a)
    {
      slope[a] = derivative(controls, a, length_u[a]);
      for (int b = 0; b <= a; ++b)
      {
        bend[a][b] = derivative(slope[b], a, length_u[a]);
      }
    }
    return largest(slope, bend);
  }

private:
  [[nodiscard]] Controls around(const GridIndex& point) const noexcept
  {
    Controls values{};
    for (int n = 0; n < 27; ++n)
    {
      GridIndex p{ point[0] + n % 3 - 1, point[1] + n / 3 % 3 - 1, point[2] + n / 9 - 1 };
      for (int k = 0; k < 3; ++k)
      {
        p[k] = std::clamp(p[k], 0, this->size_[k] - 1);
      }
      values[n] = this->value(p);
    }
    return values;
  }

  /// From three values to the coefficients between the middles of the steps beside the point. Half of a step is left at
  /// a face, over which the function is linear.
  void toBernstein(Controls& controls, int axis, int point, double& length_u) const noexcept
  {
    const bool below = point == 0, above = point == this->size_[axis] - 1;
    length_u *= below || above ? 0.5 : 1.0;
    alongAxis(controls, axis,
      [=](double& a, double& b, double& c)
      {
        const double low = below ? b : 0.5 * (a + b), high = above ? b : 0.5 * (b + c);
        a = low;
        b = below || above ? 0.5 * (low + high) : b;
        c = high;
      });
  }

  static LevelBounds largest(
    const std::array<Controls, 3>& slope, const std::array<std::array<Controls, 3>, 3>& bend) noexcept
  {
    double slope2 = 0.0, bend2 = 0.0;
    for (int n = 0; n < 27; ++n)
    {
      double sum2 = 0.0, norm2 = 0.0;
      for (int a = 0; a < 3; ++a)
      {
        sum2 += slope[a][n] * slope[a][n];
        norm2 += bend[a][a][n] * bend[a][a][n];
        for (int b = 0; b < a; ++b)
        {
          norm2 += 2.0 * bend[a][b][n] * bend[a][b][n];
        }
      }
      slope2 = std::fmax(slope2, sum2); // of one that is no number the other
      bend2 = std::fmax(bend2, norm2);
    }
    return { std::sqrt(slope2), std::sqrt(bend2) };
  }

  std::span<const float> values_;
  GridIndex size_;
  Vec3 spacing_u_;
};

/// Some neighbouring cells and bounds of the spline on them: of each component the largest difference.
struct Block
{
  GridIndex first{};
  LevelBounds most;
};

/// The largest of each kind of difference whose stencil begins at a point of a block or beside it. Coefficients are
/// convex combinations of such differences.
LevelBounds mostOn(const SplineValues& spline, const GridIndex& first, const Vec3& spacing_u) noexcept
{
  std::array<double, 3> slope{}, own{}, cross{};
  GridIndex p{}, low{}, high{};
  for (int k = 0; k < 3; ++k)
  {
    low[k] = std::max(0, first[k] - 1);
    high[k] = std::min(spline.size()[k] - 1, first[k] + edge);
  }
  for (p[2] = low[2]; p[2] <= high[2]; ++p[2])
  {
    for (p[1] = low[1]; p[1] <= high[1]; ++p[1])
    {
      for (p[0] = low[0]; p[0] <= high[0]; ++p[0])
      {
        const double value = spline.value(p);
        for (int k = 0; k < 3; ++k)
        {
          const int l = (k + 1) % 3;
          GridIndex next = p, beside = p, both = p;
          next[k] = both[k] = std::min(high[k], p[k] + 1);
          beside[l] = both[l] = std::min(high[l], p[l] + 1);
          GridIndex before = p;
          before[k] = std::max(low[k], p[k] - 1);
          const double step = spline.value(next) - value;
          slope[k] = std::fmax(slope[k], std::fabs(step));
          cross[k] = std::fmax(cross[k], std::fabs(spline.value(both) - spline.value(beside) - step));
          const bool inside = before[k] < p[k] && p[k] < next[k];
          own[k] = std::fmax(own[k], inside ? std::fabs(step - (value - spline.value(before))) : 0.0);
        }
      }
    }
  }
  double slope2 = 0.0, bend2 = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    const double h = spacing_u[k], beside = spacing_u[(k + 1) % 3];
    slope2 += slope[k] * slope[k] / (h * h);
    bend2 += own[k] * own[k] / (h * h * h * h) + 2.0 * cross[k] * cross[k] / (h * h * beside * beside);
  }
  return { std::sqrt(slope2), std::sqrt(bend2) };
}

std::vector<Block> blocksOf(const SplineValues& spline, const Vec3& spacing_u)
{
  std::vector<Block> blocks;
  GridIndex at{};
  for (at[2] = 0; at[2] < spline.size()[2]; at[2] += edge)
  {
    for (at[1] = 0; at[1] < spline.size()[1]; at[1] += edge)
    {
      for (at[0] = 0; at[0] < spline.size()[0]; at[0] += edge)
      {
        blocks.push_back({ at, mostOn(spline, at, spacing_u) });
      }
    }
  }
  return blocks;
}

LevelBounds onBlock(const SplineValues& spline, const GridIndex& first) noexcept
{
  LevelBounds bounds;
  for (int n = 0; n < edge * edge * edge; ++n)
  {
    const GridIndex p{ first[0] + n % edge, first[1] + n / edge % edge, first[2] + n / (edge * edge) };
    if (p[0] < spline.size()[0] && p[1] < spline.size()[1] && p[2] < spline.size()[2])
    {
      bounds = bounds.with(spline.onCell(p));
    }
  }
  return bounds;
}

/// Looks at the blocks that may be the largest in one bound, in decreasing order of that bound. The bounds of the other
/// blocks stand.
void lookAt(const SplineValues& spline, std::vector<Block>& blocks, double LevelBounds::*bound, LevelBounds& found)
{
  std::ranges::sort(blocks, std::ranges::greater{}, [bound](const Block& block) { return block.most.*bound; });
  int cells = 0;
  for (const Block& block : blocks)
  {
    if (!(block.most.*bound > closeTo * found.*bound) || cells > mostCells)
    {
      found.*bound = std::max(found.*bound, block.most.*bound);
      return;
    }
    found = found.with(onBlock(spline, block.first));
    cells += edge * edge * edge;
  }
}

} // namespace

LevelBounds levelBounds(std::span<const float> values, const GridIndex& size, const Vec3& spacing_u)
{
  if (*std::ranges::min_element(size) < 3)
  {
    return unknownLevels;
  }
  const SplineValues spline(values, size, spacing_u);
  std::vector<Block> blocks = blocksOf(spline, spacing_u);
  LevelBounds found;
  lookAt(spline, blocks, &LevelBounds::gradient_per_u, found);
  lookAt(spline, blocks, &LevelBounds::bend_per_u2, found);
  return found;
}

} // namespace palpate
