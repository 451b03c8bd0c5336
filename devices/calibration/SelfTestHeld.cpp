// SPDX-License-Identifier: GPL-3.0-or-later
// Findings of the pushes into the device's own walls and against its viscosity.
#include <algorithm>
#include <array>
#include <cmath>

#include "devices/calibration/SelfTestFindings.h"

namespace palpate
{
namespace
{

/// A hand of stiffness K yields by 1 / K per N of a push, and by 1 / (K + k) into a wall k. The ratio gives the
/// stiffness of the wall as a share of the one asked for. A displacement of a few encoder steps gives a lower bound of
/// it.
struct WallSize
{
  double share = 0.0;
  bool atLeast = false;
};
WallSize wallSize(const SelfTestPlan& plan, double asked_N_per_m, const PushAnswer& free, const PushAnswer& held)
{
  constexpr double steps = 5.0;
  const double readable_m_per_N = steps * plan.resolution_m / plan.push_N;
  const double free_m_per_N = std::fabs(free.response_m_per_N);
  const bool sameWay = held.response_m_per_N * free.response_m_per_N > 0.0;
  const double held_m_per_N = sameWay ? std::fabs(held.response_m_per_N) : 0.0;
  const bool readable = held_m_per_N > 0.0 && std::fabs(held.moved_m) >= steps * plan.resolution_m;
  const double way_m_per_N = readable ? held_m_per_N : std::max(readable_m_per_N, held_m_per_N);
  return { way_m_per_N > 0.0 && free_m_per_N > 0.0 ? (1.0 / way_m_per_N - 1.0 / free_m_per_N) / asked_N_per_m : 0.0,
    !readable };
}

constexpr double rightWithin = 0.25;

/// One side of an axis, from both repetitions.
HeldProof judgeWall(const WallSize& first, const WallSize& second, double mean)
{
  if (first.atLeast || second.atLeast)
  {
    return std::min(first.share, second.share) > 1.0 + rightWithin ? HeldProof::WrongSize : HeldProof::Unclear;
  }
  if (mean < -rightWithin)
  {
    return HeldProof::WrongWay;
  }
  if (mean < rightWithin)
  {
    return HeldProof::NoForce;
  }
  if (std::fabs(mean - 1.0) > rightWithin)
  {
    return HeldProof::WrongSize;
  }
  return std::fabs(first.share - second.share) > 2.0 * rightWithin ? HeldProof::Unclear : HeldProof::Felt;
}

HeldProof judgeBraking(double share)
{
  constexpr double brakes = 0.92, drives = 1.08; // a hand is never quite the same
  return share < brakes ? HeldProof::Felt : share > drives ? HeldProof::Drives : HeldProof::NoBrake;
}

/// Felt by a push into its wall and not by one into its room.
HeldProof judgeCorridor(const SelfTestPlan& plan, const MotorAnswers& answers, double asked_N_per_m, int sensor)
{
  constexpr double half = 0.5;
  std::array<double, 2> shares{};
  for (const std::size_t direction : { 0U, 1U })
  {
    const PushAnswer& free = along(answers.free[1], direction, sensor);
    shares[direction] = wallSize(plan, asked_N_per_m, free, along(answers.corridor, direction, sensor)).share;
  }
  return shares[0] > half && shares[1] < half ? HeldProof::Felt : HeldProof::Misplaced;
}

/// The force that a wall takes of a push shortens the displacement by as much, whatever the friction. A limited wall
/// takes a quarter of the force of an unlimited one, and more of the rest after friction. A firmware without limits
/// takes all.
HeldProof judgeLimits(const MotorAnswers& answers, int sensor)
{
  constexpr double most = 0.75;
  for (const std::size_t direction : { 0U, 1U })
  {
    const double free_m = along(answers.free[1], direction, sensor).moved_m;
    const double taken_m = free_m - along(answers.walls[1], direction, sensor).moved_m;
    const double takenByLimited_m = free_m - along(answers.limited, direction, sensor).moved_m;
    if (std::fabs(takenByLimited_m) > most * std::fabs(taken_m))
    {
      return HeldProof::NoLimit;
    }
  }
  return HeldProof::Felt;
}

/// Findings that endanger a hand come before missing abilities.
HeldProof worse(HeldProof a, HeldProof b)
{
  constexpr std::array<HeldProof, 10> order{ HeldProof::WrongWay, HeldProof::Drives, HeldProof::WrongSize,
    HeldProof::NoForce, HeldProof::Misplaced, HeldProof::NoLimit, HeldProof::NoBrake, HeldProof::Unclear,
    HeldProof::Unfelt, HeldProof::Felt };
  const auto rank = [&](HeldProof proof) { return std::find(order.begin(), order.end(), proof); };
  return rank(a) < rank(b) ? a : b;
}

} // namespace

double wallStiffness_N_per_m(const SelfTestPlan& plan, const SelfTestState& state, int motor) noexcept
{
  return std::min(plan.stiffest_N_per_m, 1.0 / findMotor(plan, state, motor, 1).response_m_per_N);
}

double strengthOf(const HeldFinding& held) noexcept
{
  const double size = 0.5 * (held.walls[0] + held.walls[1]);
  return held.proof != HeldProof::Unclear && size > rightWithin ? 1.0 / size : 0.0;
}

HeldFinding findHeld(const SelfTestPlan& plan, const SelfTestState& state, int motor) noexcept
{
  HeldFinding held;
  const MotorFinding found = findMotor(plan, state, motor);
  if (!plan.offersWalls || state.broke != HeldProof::Unfelt || found.motion != MotorMotion::Clear)
  {
    held.proof = state.broke;
    return held;
  }
  const MotorAnswers& answers = state.motors[static_cast<std::size_t>(motor)];
  const double asked_N_per_m = wallStiffness_N_per_m(plan, state, motor);
  held.proof = HeldProof::Felt;
  for (const std::size_t direction : { 0U, 1U })
  {
    std::array<WallSize, 2> sizes;
    double left = 0.0, way = 0.0;
    for (const std::size_t r : { 0U, 1U })
    {
      const PushAnswer& free = along(answers.free[r], direction, found.sensor);
      sizes[r] = wallSize(plan, asked_N_per_m, free, along(answers.walls[r], direction, found.sensor));
      left += along(answers.braked[r], direction, found.sensor).mean_m;
      way += free.mean_m;
    }
    held.walls[direction] = 0.5 * (sizes[0].share + sizes[1].share);
    held.braking[direction] = way != 0.0 ? left / way : 1.0;
    held.proof = worse(held.proof, judgeWall(sizes[0], sizes[1], held.walls[direction]));
    held.proof = worse(held.proof, judgeBraking(held.braking[direction]));
  }
  if (held.proof == HeldProof::Felt)
  {
    held.proof = worse(judgeCorridor(plan, answers, asked_N_per_m, found.sensor), judgeLimits(answers, found.sensor));
  }
  return held;
}

HeldProof heldProofOf(const SelfTestPlan& plan, const SelfTestState& state) noexcept
{
  if (!plan.offersWalls || state.broke != HeldProof::Unfelt)
  {
    return state.broke;
  }
  HeldProof worst = HeldProof::Felt;
  for (int axis = 0; axis < state.axes(plan); ++axis)
  {
    const int motor = motorOf(plan, state, findAxis(plan, state, axis).sensor);
    worst = worse(worst, motor < 0 ? HeldProof::Unfelt : findHeld(plan, state, motor).proof);
  }
  return worst;
}

} // namespace palpate
