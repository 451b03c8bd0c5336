// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/field/Smoothing.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace palpate
{
namespace
{

/// Points of a grid as lines along one axis.
struct Lines
{
  std::ptrdiff_t stride = 1; ///< from a point to the next along the axis
  int points = 0;            ///< of a line
};

Lines linesAlong(const GridIndex& size, int axis) noexcept
{
  const std::ptrdiff_t strides[3] = { 1, size[0], static_cast<std::ptrdiff_t>(size[0]) * size[1] };
  return { strides[axis], size[axis] };
}

/// Calls visit(at, x, y, z) for every point.
template<class Visit>
void forEachPoint(const GridIndex& size, const Visit& visit)
{
  std::ptrdiff_t at = 0;
  for (int z = 0; z < size[2]; ++z)
  {
    for (int y = 0; y < size[1]; ++y)
    {
      for (int x = 0; x < size[0]; ++x, ++at)
      {
        visit(at, GridIndex{ x, y, z });
      }
    }
  }
}

void smoothAlong(const std::vector<float>& from, std::vector<float>& to, const GridIndex& size, int axis)
{
  const Lines lines = linesAlong(size, axis);
  forEachPoint(size,
    [&](std::ptrdiff_t at, const GridIndex& index)
    {
      to[at] = from[at];
      if (index[axis] > 0 && index[axis] + 1 < lines.points)
      {
        const double mean = 0.25 * from[at - lines.stride] + 0.5 * from[at] + 0.25 * from[at + lines.stride];
        to[at] = std::isfinite(mean) ? static_cast<float>(mean) : from[at];
      }
    });
}

/// By central differences, 0 along an axis without both neighbours.
double slopeAt(const std::vector<float>& values, const GridIndex& size, const GridIndex& index, std::ptrdiff_t at)
{
  double square = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const Lines lines = linesAlong(size, axis);
    if (index[axis] > 0 && index[axis] + 1 < lines.points)
    {
      const double slope = 0.5 * (static_cast<double>(values[at + lines.stride]) - values[at - lines.stride]);
      square += slope * slope;
    }
  }
  return std::sqrt(square);
}

/// True if the values of a point and of its next neighbour along any axis lie on both sides of the level.
bool besideLevel(
  const std::vector<float>& values, const GridIndex& size, const GridIndex& index, std::ptrdiff_t at, double level)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const Lines lines = linesAlong(size, axis);
    if (index[axis] + 1 < lines.points && (values[at] < level) != (values[at + lines.stride] < level))
    {
      return true;
    }
  }
  return false;
}

/// The residual of smoothing and its correlation from point to point.
class Residual
{
public:
  Residual(const std::vector<float>& values, const std::vector<float>& smooth, const GridIndex& size) noexcept
    : values_(values), smooth_(smooth), size_(size)
  {
  }

  [[nodiscard]] double at(std::ptrdiff_t point) const noexcept
  {
    return static_cast<double>(this->values_[point]) - this->smooth_[point];
  }

  /// Takes a point with its neighbours along all axes into account.
  void add(const GridIndex& index, std::ptrdiff_t point) noexcept
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const Lines lines = linesAlong(this->size_, axis);
      this->pair(point, index[axis] > 0 ? point - lines.stride : point);
      this->pair(point, index[axis] + 1 < lines.points ? point + lines.stride : point);
    }
  }

  /// -1 to 1, of neighbours that are looked at; 1 where there is nothing to compare.
  [[nodiscard]] double likeness() const noexcept
  {
    return this->squares_ > 0.0 ? this->products_ / this->squares_ : 1.0;
  }

private:
  void pair(std::ptrdiff_t point, std::ptrdiff_t neighbour) noexcept
  {
    const double one = this->at(point), other = this->at(neighbour);
    if (neighbour != point && std::isfinite(one) && std::isfinite(other))
    {
      this->products_ += one * other;
      this->squares_ += 0.5 * (one * one + other * other);
    }
  }

  const std::vector<float>& values_;
  const std::vector<float>& smooth_;
  GridIndex size_;
  double products_ = 0.0, squares_ = 0.0;
};

/// A wave along one axis, however fine, is alike along the other two: (1 + 1 + cos) / 3 is 1/3 at least. White noise
/// has -0.11, and noise over a smooth field comes below a third where the noise is three fifths of the residual.
constexpr double noiseIsLess = 1.0 / 3.0;

} // namespace

std::vector<float> smoothed(std::vector<float> values, const GridIndex& size, int passes)
{
  std::vector<float> other(values.size());
  for (int i = 0; i < passes; ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      smoothAlong(values, other, size, axis);
      values.swap(other);
    }
  }
  return values;
}

double measuredNoise(const std::vector<float>& values, const GridIndex& size, double level)
{
  const std::vector<float> smooth = smoothed(values, size, 1);
  Residual residual(values, smooth, size);
  std::vector<double> shifts;
  forEachPoint(size,
    [&](std::ptrdiff_t at, const GridIndex& index)
    {
      if (besideLevel(smooth, size, index, at, level))
      {
        const double slope = slopeAt(smooth, size, index, at);
        const double shift = std::fabs(residual.at(at)) / slope;
        residual.add(index, at);
        if (std::isfinite(shift))
        {
          shifts.push_back(shift);
        }
      }
    });
  if (shifts.empty() || residual.likeness() >= noiseIsLess)
  {
    return 0.0;
  }
  const auto middle = shifts.begin() + static_cast<std::ptrdiff_t>(shifts.size() / 2);
  std::ranges::nth_element(shifts, middle);
  return *middle;
}

} // namespace palpate
