// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/field/laws/Detent.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{

/// Largest slope of 1 - (1 - 4 s^2)^2, which is 16 s (1 - 4 s^2), at s = 1 / sqrt(12): 32 / (3 sqrt(12)).
constexpr double steepest = 3.0792014356780046;
constexpr int mostSteps = 40;
constexpr double leastStep = 1e-14; ///< [spacings of the grid]
constexpr double leastStiff = 0.05; ///< of the spring: on a top of the potential steps are not to be too long

} // namespace

DetentEnergy detentEnergy(const DetentPlan& plan, double value) noexcept
{
  const double turns = (value - plan.origin) / plan.spacing;
  const double s = turns - std::floor(turns + 0.5); // -0.5 to 0.5 from the nearest level
  const double w = 1.0 - 4.0 * s * s;
  const double height = plan.strength_N * plan.spacing / (steepest * plan.slope_per_u);
  return { height * (1.0 - w * w), height * 16.0 * s * w / plan.spacing,
    height * (16.0 * w - 128.0 * s * s) / (plan.spacing * plan.spacing) };
}

Vec3 smoothDetent(
  const Brick& brick, const DetentPlan& plan, double stiffness_N_per_u, const Vec3& p_W, const Vec3& from_W) noexcept
{
  const double k = stiffness_N_per_u, h_u = brick.grid().spacing_u.minCoeff();
  Vec3 x_W = from_W;
  for (int step = 0; step < mostSteps; ++step)
  {
    const std::optional<FieldSample> f = brick.sample(BrickRole::Scalar, x_W);
    if (!f)
    {
      return p_W;
    }
    const DetentEnergy e = detentEnergy(plan, f->value);
    // Newton's step with (k + e'' |grad f|^2) along the gradient and k across it.
    const Vec3 residual_W = k * (x_W - p_W) + e.slope * f->gradient_W;
    const double square = f->gradient_W.squaredNorm();
    const double along = std::max(k + e.bend * square, leastStiff * k);
    const Vec3 part_W =
      square > 0.0 ? Vec3(residual_W.dot(f->gradient_W) / square * f->gradient_W) : Vec3(Vec3::Zero());
    Vec3 change_W = -(residual_W - part_W) / k - part_W / along;
    const double length_u = change_W.norm();
    change_W *= length_u > h_u ? h_u / length_u : 1.0;
    x_W += change_W;
    if (length_u <= leastStep * h_u)
    {
      break;
    }
  }
  return x_W;
}

double nextLevel(const DetentPlan& plan, double proxyValue, bool above) noexcept
{
  const double turns = (proxyValue - plan.origin) / plan.spacing;
  return plan.origin + plan.spacing * (above ? std::floor(turns) + 1.0 : std::ceil(turns) - 1.0);
}

} // namespace palpate
