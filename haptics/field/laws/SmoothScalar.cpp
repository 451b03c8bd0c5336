// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/field/laws/SmoothScalar.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace palpate
{
namespace
{

/// Shares of three values next to one another, and their first and second derivatives along the axis.
struct Shares
{
  int first = 0; ///< of the three
  std::array<double, 3> value{}, slope{}, bend{};
};

/// Along one axis; beyond the last value the line through the last two goes on.
Shares sharesAt(double index, int points) noexcept
{
  const int middle = std::clamp(static_cast<int>(std::floor(index + 0.5)), 0, points - 1);
  const double t = index - middle;
  Shares shares;
  shares.first = middle - 1;
  shares.value = { 0.5 * (0.5 - t) * (0.5 - t), 0.75 - t * t, 0.5 * (0.5 + t) * (0.5 + t) };
  shares.slope = { t - 0.5, -2.0 * t, t + 0.5 };
  shares.bend = { 1.0, -2.0, 1.0 };
  const bool below = middle == 0, above = middle == points - 1;
  if (below || above)
  {
    for (std::array<double, 3>* s : { &shares.value, &shares.slope, &shares.bend })
    {
      // A value v[-1] = 2 v[0] - v[1] in terms of those that are there.
      auto& [a, b, c] = *s;
      const double outer = below ? a : c, inner = below ? c : a;
      const double near = b + 2.0 * outer, far = inner - outer;
      *s = below ? std::array<double, 3>{ near, far, 0.0 } : std::array<double, 3>{ 0.0, far, near };
    }
    shares.first = below ? 0 : points - 3;
  }
  return shares;
}

} // namespace

std::optional<SmoothSample> smoothScalar(const FieldBlock& brick, const Vec3& p_W) noexcept
{
  const FieldBlockComponent scalar = brick.component(FieldBlockRole::Scalar);
  const FieldBlockGrid& grid = brick.grid();
  const Vec3 index = grid.toIndex(p_W);
  if (!scalar.exists() || !scalar.within(GridPlace::at(index)) || *std::ranges::min_element(grid.size) < 3)
  {
    return std::nullopt;
  }
  const Shares x = sharesAt(index.x(), grid.size[0]), y = sharesAt(index.y(), grid.size[1]),
               z = sharesAt(index.z(), grid.size[2]);
  double value = 0.0;
  Vec3 slope = Vec3::Zero(), own = Vec3::Zero(), mixed = Vec3::Zero(); // mixed: yz, zx, xy
  for (int k = 0; k < 3; ++k)
  {
    for (int j = 0; j < 3; ++j)
    {
      double row = 0.0, change = 0.0, bend = 0.0;
      for (int i = 0; i < 3; ++i)
      {
        const double v = scalar.at({ x.first + i, y.first + j, z.first + k });
        row += x.value[i] * v;
        change += x.slope[i] * v;
        bend += x.bend[i] * v;
      }
      const double yz = y.value[j] * z.value[k];
      value += yz * row;
      slope += Vec3(yz * change, y.slope[j] * z.value[k] * row, y.value[j] * z.slope[k] * row);
      own += Vec3(yz * bend, y.bend[j] * z.value[k] * row, y.value[j] * z.bend[k] * row);
      mixed += Vec3(y.slope[j] * z.slope[k] * row, y.value[j] * z.slope[k] * change, y.slope[j] * z.value[k] * change);
    }
  }
  if (!std::isfinite(value))
  {
    return std::nullopt;
  }
  Mat3 bend;
  bend << own.x(), mixed.z(), mixed.y(), mixed.z(), own.y(), mixed.x(), mixed.y(), mixed.x(), own.z();
  const Vec3 less = grid.spacing_u.cwiseInverse();
  const Mat3 axes_W = grid.pose_W.q.toRotationMatrix();
  return SmoothSample{ value, grid.gradientToWorld(slope),
    axes_W * less.asDiagonal() * bend * less.asDiagonal() * axes_W.transpose() };
}

} // namespace palpate
