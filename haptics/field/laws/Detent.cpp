// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/field/laws/Detent.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include <Eigen/Cholesky>

#include "haptics/field/laws/SmoothScalar.h"

namespace palpate
{
namespace
{

/// Largest slope of 1 - (1 - 4 s^2)^2, which is 16 s (1 - 4 s^2), at s = 1 / sqrt(12): 32 / (3 sqrt(12)).
constexpr double steepest = 3.0792014356780046;
constexpr int mostSteps = 40;
constexpr double leastStep = 1e-14; ///< [spacings of the grid]
constexpr double worth = 1e-4;      ///< of the force that a step removes: with less it is a miss, and half is tried
constexpr double beyondAll = 1e300; ///< larger than any single-precision value, and finite

/// Where a value is in the hollow of its nearest level.
struct InHollow
{
  double s = 0.0; ///< from the level, in widths; from -0.5 to 0.5 inside
  double width = 1.0;
};

InHollow hollowAt(const DetentPlan& plan, double value) noexcept
{
  if (plan.levelCount == 0)
  {
    const double turns = (value - plan.origin) / plan.spacing;
    return { turns - std::floor(turns + 0.5), plan.spacing };
  }
  double nearest = plan.levels[0] - value, width = plan.spacing;
  for (std::int32_t i = 1; i < plan.levelCount; ++i)
  {
    const double away = plan.levels[i] - value;
    nearest = std::fabs(away) < std::fabs(nearest) ? away : nearest;
    width = std::min(width, plan.levels[i] - plan.levels[i - 1]);
  }
  return { -nearest / width, width };
}

/// The energy of spring and potential around a place: gradient and Hessian.
struct Balance
{
  bool exists = false; ///< false: there is no value
  Vec3 x_W = Vec3::Zero();
  Vec3 slope = Vec3::Zero(); ///< [N]
  Mat3 bend = Mat3::Zero();
};

Balance balanceAt(const FieldBlock& brick, const DetentPlan& plan, double k, const Vec3& p_W, const Vec3& x_W) noexcept
{
  const std::optional<SmoothSample> f = smoothScalar(brick, x_W);
  if (!f)
  {
    return {};
  }
  const DetentEnergy e = detentEnergy(plan, f->value);
  Balance balance{ true, x_W };
  balance.slope = k * (x_W - p_W) + e.slope * f->gradient_W;
  balance.bend = k * Mat3::Identity() + e.bend * f->gradient_W * f->gradient_W.transpose() + e.slope * f->bend_W;
  return balance;
}

/// Empty, or the first thing in a list of numbers that is none.
std::string readNumbers(std::string_view text, std::vector<double>& numbers)
{
  constexpr std::string_view between = ", ;\t\n";
  for (std::size_t at = text.find_first_not_of(between); at != std::string_view::npos;
       at = text.find_first_not_of(between, at))
  {
    const std::string_view word = text.substr(at, text.find_first_of(between, at) - at);
    double number = 0.0;
    const auto read = std::from_chars(word.data(), word.data() + word.size(), number);
    if (read.ec != std::errc() || read.ptr != word.data() + word.size() || !std::isfinite(number))
    {
      return std::string(word);
    }
    numbers.push_back(number);
    at += word.size();
  }
  return "";
}

} // namespace

std::string setLevels(DetentPlan& plan, std::string_view text)
{
  std::vector<double> numbers;
  if (const std::string word = readNumbers(text, numbers); !word.empty())
  {
    return "levels: '" + word + "' is not a number; use numbers separated by commas";
  }
  if (numbers.size() > DetentPlan::mostLevels)
  {
    return "levels: at most " + std::to_string(DetentPlan::mostLevels) + " can be chosen; use equal distances for more";
  }
  std::ranges::sort(numbers);
  DetentPlan changed = plan;
  changed.levels = {};
  std::ranges::copy(numbers, changed.levels.begin());
  changed.levelCount = static_cast<std::int32_t>(numbers.size());
  std::string problem = refuseLevels(changed);
  plan = problem.empty() ? changed : plan;
  return problem;
}

std::string refuseLevels(const DetentPlan& plan)
{
  if (plan.levelCount < 0 || static_cast<std::size_t>(plan.levelCount) > DetentPlan::mostLevels)
  {
    return "levels: at most " + std::to_string(DetentPlan::mostLevels) + " can be chosen";
  }
  const std::span<const double> levels(plan.levels.data(), static_cast<std::size_t>(plan.levelCount));
  if (!std::ranges::all_of(levels, [](double level) { return std::isfinite(level); }))
  {
    return "levels: they must be finite numbers";
  }
  const bool rise = std::ranges::adjacent_find(levels, std::ranges::greater_equal{}) == levels.end();
  return rise ? "" : "levels: two of them are the same";
}

DetentEnergy detentEnergy(const DetentPlan& plan, double value) noexcept
{
  const InHollow at = hollowAt(plan, value);
  const double height = plan.strength_N * at.width / (steepest * plan.slope_per_u);
  if (std::fabs(at.s) >= 0.5)
  {
    return { height, 0.0, 0.0 };
  }
  const double w = 1.0 - 4.0 * at.s * at.s;
  return { height * (1.0 - w * w), height * 16.0 * at.s * w / at.width,
    height * (16.0 * w - 128.0 * at.s * at.s) / (at.width * at.width) };
}

double mostSmooth_N(const DetentPlan& plan, double stiffness_N_per_u) noexcept
{
  constexpr double leastBend = 32.0;
  constexpr double share = 0.9; // of the spring: the rest keeps the balance well conditioned
  double width = plan.spacing;
  for (std::int32_t i = 1; i < plan.levelCount; ++i)
  {
    width = std::min(width, plan.levels[i] - plan.levels[i - 1]);
  }
  const double square = plan.bounds.gradient_per_u * plan.bounds.gradient_per_u;
  const double softest_per_u2 = leastBend * square / (steepest * width) + plan.bounds.bend_per_u2;
  return softest_per_u2 > 0.0 ? share * stiffness_N_per_u * plan.slope_per_u / softest_per_u2
                              : std::numeric_limits<double>::infinity();
}

double mostFelt_N(const DetentPlan& plan, double stiffness_N_per_u) noexcept
{
  const double most_N = mostSmooth_N(plan, stiffness_N_per_u);
  return std::min(plan.strength_N, most_N) * plan.bounds.gradient_per_u / plan.slope_per_u;
}

/// Newton's steps on an energy that is strictly convex up to mostSmooth_N(). Its second derivatives jump between cells,
/// so a step may be too long: it is halved until less force is left.
Vec3 smoothDetent(const FieldBlock& brick, const DetentPlan& plan, double stiffness_N_per_u, const Vec3& p_W,
  const Vec3& from_W) noexcept
{
  const double k = stiffness_N_per_u, h_u = brick.grid().spacing_u.minCoeff();
  Balance at = balanceAt(brick, plan, k, p_W, from_W);
  at = at.exists ? at : balanceAt(brick, plan, k, p_W, p_W);
  for (int step = 0; at.exists && step < mostSteps;)
  {
    const Eigen::LDLT<Mat3> factors(at.bend);
    Vec3 change_W = -(factors.isPositive() ? Vec3(factors.solve(at.slope)) : Vec3(at.slope / k));
    const double length_u = change_W.norm();
    if (length_u <= leastStep * h_u)
    {
      break;
    }
    change_W *= length_u > h_u ? h_u / length_u : 1.0;
    bool gains = false;
    for (double share = std::min(1.0, h_u / length_u); !gains && step < mostSteps; ++step)
    {
      const Balance next = balanceAt(brick, plan, k, p_W, at.x_W + change_W);
      gains = next.exists && next.slope.norm() <= (1.0 - worth * share) * at.slope.norm();
      at = gains ? next : at;
      change_W *= 0.5;
      share *= 0.5;
    }
    if (!gains)
    {
      break;
    }
  }
  return at.exists ? at.x_W : p_W;
}

double nextLevel(const DetentPlan& plan, double proxyValue, bool above) noexcept
{
  if (plan.levelCount > 0)
  {
    const auto* const begin = plan.levels.data();
    const auto* const end = begin + plan.levelCount;
    const auto* const next = std::upper_bound(begin, end, proxyValue);
    const auto* const least = std::lower_bound(begin, end, proxyValue);
    return above ? (next == end ? beyondAll : *next) : (least == begin ? -beyondAll : *(least - 1));
  }
  const double turns = (proxyValue - plan.origin) / plan.spacing;
  return plan.origin + plan.spacing * (above ? std::floor(turns) + 1.0 : std::ceil(turns) - 1.0);
}

} // namespace palpate
