// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/field/iso/Crossing.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{

/// The ends of the pieces on which a cubic only rises or only falls.
struct Pieces
{
  std::array<double, 3> end{};
  int count = 0;

  void add(double u) noexcept
  {
    if (u > 0.0 && u < 1.0)
    {
      this->end[this->count++] = u;
    }
  }
};

/// Roots of the derivative without the difference of two numbers that are nearly the same.
Pieces piecesOf(const std::array<double, 4>& b) noexcept
{
  const double d0 = b[1] - b[0], d1 = b[2] - b[1], d2 = b[3] - b[2];
  const double half = d1 - d0, square = (d0 - d1) + (d2 - d1), discriminant = half * half - square * d0;
  Pieces pieces;
  if (discriminant > 0.0)
  {
    const double sum = -(half + std::copysign(std::sqrt(discriminant), half));
    pieces.add(d0 / sum);
    pieces.add(sum / square);
    if (pieces.count == 2 && pieces.end[0] > pieces.end[1])
    {
      std::swap(pieces.end[0], pieces.end[1]);
    }
  }
  pieces.end[pieces.count++] = 1.0;
  return pieces;
}

/// The root between a place that is not negative and one that is, on a piece that only falls: Newton's steps, halved
/// where they leave the bracket.
double rootBetween(const WayCubic& cubic, double above, double below) noexcept
{
  constexpr int mostSteps = 60;
  constexpr double rounding = 2e-16;
  const double d0 = cubic.b[1] - cubic.b[0], d1 = cubic.b[2] - cubic.b[1], d2 = cubic.b[3] - cubic.b[2];
  const double from = cubic.at(above), to = cubic.at(below);
  double u = above + (below - above) * (from / (from - to));
  for (int i = 0; i < mostSteps; ++i)
  {
    const double value = cubic.at(u);
    (value >= 0.0 ? above : below) = u;
    const double slope = 3.0 * ((1.0 - u) * ((1.0 - u) * d0 + 2.0 * u * d1) + u * u * d2);
    double next = u - value / slope;
    if (!(next > above && next < below))
    {
      next = 0.5 * (above + below);
    }
    const double step = std::fabs(next - u);
    u = next;
    if (step <= rounding || below - above <= rounding)
    {
      break;
    }
  }
  return u;
}

} // namespace

WayCubic::WayCubic(const TrilinearCell& cell, const Vec3& from, const Vec3& to) noexcept
  : b{ cell.value(from),
      (cell.value({ to.x(), from.y(), from.z() }) + cell.value({ from.x(), to.y(), from.z() }) +
        cell.value({ from.x(), from.y(), to.z() })) /
        3.0,
      (cell.value({ from.x(), to.y(), to.z() }) + cell.value({ to.x(), from.y(), to.z() }) +
        cell.value({ to.x(), to.y(), from.z() })) /
        3.0,
      cell.value(to) }
{
}

double WayCubic::at(double u) const noexcept
{
  const double v = 1.0 - u;
  const double low = v * (v * this->b[0] + u * this->b[1]) + u * (v * this->b[1] + u * this->b[2]);
  const double high = v * (v * this->b[1] + u * this->b[2]) + u * (v * this->b[2] + u * this->b[3]);
  return v * low + u * high;
}

std::optional<double> WayCubic::firstCrossing() const noexcept
{
  const Pieces pieces = piecesOf(this->b);
  double begin = 0.0;
  for (int i = 0; i < pieces.count; ++i)
  {
    if (this->at(pieces.end[i]) < 0.0)
    {
      return rootBetween(*this, begin, pieces.end[i]);
    }
    begin = pieces.end[i];
  }
  return {};
}

} // namespace palpate
