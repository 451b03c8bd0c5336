// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/field/laws/Follow.h"

#include <algorithm>

namespace palpate
{
namespace
{

constexpr int mostRounds = 30;
constexpr double still = 1e-15, abreast = 1e-13; ///< [spacings of the grid]

/// The vector at a place, or the axis on the side of `like`.
std::optional<Vec3> vectorAt(const FieldBlock& brick, const Vec3& at_W, const Vec3& like) noexcept
{
  return brick.component(FieldBlockRole::Vector).exists() ? brick.vector(at_W) : brick.axis(at_W, like);
}

/// The direction of the vectors at a place, on the side of `like`; none where they have none.
std::optional<Vec3> directionAt(const FieldBlock& brick, const Vec3& at_W, const Vec3& like) noexcept
{
  const std::optional<Vec3> v_W = vectorAt(brick, at_W, like);
  const double length = v_W ? v_W->norm() : 0.0;
  if (!(length > 0.0))
  {
    return {};
  }
  return *v_W / (v_W->dot(like) < 0.0 ? -length : length);
}

/// y' = y + length direction((y + y') / 2), by rounds.
std::optional<Vec3> midpointStep(
  const FieldBlock& brick, const Vec3& y_W, const Vec3& along_W, double length_u, double h_u) noexcept
{
  Vec3 next_W = y_W + length_u * along_W;
  for (int round = 0; round < mostRounds; ++round)
  {
    const std::optional<Vec3> middle = directionAt(brick, 0.5 * (y_W + next_W), along_W);
    if (!middle)
    {
      return {};
    }
    const Vec3 better_W = y_W + length_u * *middle;
    const double change_u = (better_W - next_W).norm();
    next_W = better_W;
    if (change_u <= still * h_u)
    {
      break;
    }
  }
  return next_W;
}

} // namespace

std::optional<Followed> followStreamline(
  const FieldBlock& brick, const Vec3& x_W, const Vec3& p_W, int mostSteps) noexcept
{
  const double h_u = brick.grid().spacing_u.minCoeff();
  const std::optional<Vec3> first = vectorAt(brick, x_W, Vec3::Zero());
  if (!first || !(first->norm() > 0.0))
  {
    return {};
  }
  Followed at{ x_W, first->normalized(), first->norm() };
  for (int step = 0; step < mostSteps; ++step)
  {
    const double ahead_u = std::clamp((p_W - at.y_W).dot(at.along_W), -h_u, h_u);
    const std::optional<Vec3> y_W = midpointStep(brick, at.y_W, at.along_W, ahead_u, h_u);
    const std::optional<Vec3> along_W = y_W ? directionAt(brick, *y_W, at.along_W) : std::nullopt;
    if (!along_W)
    {
      break; // the vectors end: no further
    }
    at = { *y_W, *along_W, vectorAt(brick, *y_W, *along_W)->norm() };
    if (ahead_u < abreast * h_u && ahead_u > -abreast * h_u)
    {
      break;
    }
  }
  return at;
}

} // namespace palpate
