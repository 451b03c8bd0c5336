// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/field/laws/SmoothScalar.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace palpate
{
namespace
{

/// Shares of three values next to one another, and how those change from place to place.
struct Shares
{
  int first = 0; ///< of the three
  std::array<double, 3> value{}, slope{};
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
  const bool below = middle == 0, above = middle == points - 1;
  if (below || above)
  {
    for (std::array<double, 3>* s : { &shares.value, &shares.slope })
    {
      // A value v[-1] = 2 v[0] - v[1] in terms of those that are there; of two points neither side is left.
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

std::optional<FieldSample> smoothScalar(const Brick& brick, const Vec3& p_W) noexcept
{
  const BrickComponent scalar = brick.component(BrickRole::Scalar);
  const Vec3 index = brick.grid().toIndex(p_W);
  const GridIndex& size = brick.grid().size;
  if (!scalar.exists() || !scalar.within(GridPlace::at(index)) || *std::ranges::min_element(size) < 3)
  {
    return brick.sample(BrickRole::Scalar, p_W);
  }
  const Shares x = sharesAt(index.x(), size[0]), y = sharesAt(index.y(), size[1]), z = sharesAt(index.z(), size[2]);
  double value = 0.0;
  Vec3 slope = Vec3::Zero();
  for (int k = 0; k < 3; ++k)
  {
    for (int j = 0; j < 3; ++j)
    {
      double row = 0.0, change = 0.0;
      for (int i = 0; i < 3; ++i)
      {
        const double v = scalar.at({ x.first + i, y.first + j, z.first + k });
        row += x.value[i] * v;
        change += x.slope[i] * v;
      }
      value += y.value[j] * z.value[k] * row;
      slope += Vec3(y.value[j] * z.value[k] * change, y.slope[j] * z.value[k] * row, y.value[j] * z.slope[k] * row);
    }
  }
  return std::isfinite(value) ? std::optional<FieldSample>({ value, brick.grid().gradientToWorld(slope) })
                              : std::nullopt;
}

} // namespace palpate
