// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/hid/pid/PidWalls.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace palpate
{
namespace
{

constexpr double alongAxis = 1.0 - 1e-9;

/// A wall across one axis of HID: the handle stays above a lower one and below an upper one.
struct Edge
{
  std::size_t wall = 0;
  double at = 0.0; ///< share, -1 .. 1
  double coefficient = 0.0;
  double largest = 1.0; ///< share of the largest force
};

struct AxisEdges
{
  std::optional<Edge> lower;
  std::optional<Edge> upper;
};

std::size_t wallsOf(const DeviceCommand& command) noexcept
{
  return std::min<std::size_t>(command.wallCount, command.walls.size());
}

/// The tightest wall of each direction across the axis.
AxisEdges edgesAcross(int axis, const DeviceCommand& command, const PidScale& scale) noexcept
{
  AxisEdges edges;
  for (std::size_t i = 0; i < wallsOf(command); ++i)
  {
    const DeviceWall& wall = command.walls[i];
    const double facing = PidScale::sign(axis) * wall.normal_D[axis];
    if (!(std::fabs(facing) >= alongAxis) || !std::isfinite(wall.offset_m))
    {
      continue;
    }
    const double offset = wall.offset_m / scale.halfTravel_m;
    const double coefficient = std::clamp(wall.stiffness_N_per_m / scale.springStiffness_N_per_m, 0.0, 1.0);
    const double largest = std::max(0.0, wall.largest_N) / scale.maxForce_N;
    const Edge edge{ i, std::clamp(facing > 0.0 ? offset : -offset, -1.0, 1.0), coefficient, largest };
    std::optional<Edge>& side = facing > 0.0 ? edges.lower : edges.upper;
    const bool tighter = !side || (facing > 0.0 ? edge.at > side->at : edge.at < side->at);
    side = tighter ? edge : *side;
  }
  return edges;
}

/// One wall; without a coefficient for each side the other edge of the dead band lies at the end of the travel.
Condition oneWall(const Edge& edge, bool lower, const ConditionAbilities& abilities) noexcept
{
  Condition wall;
  if (!abilities.twoCoefficients)
  {
    wall = lower ? corridor(edge.at, 1.0, edge.coefficient, edge.coefficient)
                 : corridor(-1.0, edge.at, edge.coefficient, edge.coefficient);
  }
  else
  {
    wall.centre = edge.at;
    (lower ? wall.negativeCoefficient : wall.positiveCoefficient) = edge.coefficient;
  }
  wall.positiveSaturation = wall.negativeSaturation = edge.largest;
  return wall;
}

Condition twoWalls(const Edge& low, const Edge& high) noexcept
{
  Condition walls = corridor(low.at, high.at, low.coefficient, high.coefficient);
  walls.negativeSaturation = low.largest;
  walls.positiveSaturation = high.largest;
  return walls;
}

std::optional<Condition> holdAcross(
  const AxisEdges& edges, const ConditionAbilities& abilities, std::array<bool, 4>& held) noexcept
{
  if (edges.lower && edges.upper)
  {
    const Edge &low = *edges.lower, &high = *edges.upper;
    const bool room = low.at <= high.at;
    if (room && abilities.deadBand && (abilities.twoCoefficients || low.coefficient == high.coefficient))
    {
      held[low.wall] = held[high.wall] = true;
      return twoWalls(low, high);
    }
    if (!room)
    {
      return std::nullopt;
    }
  }
  const bool lower = edges.lower.has_value();
  if (lower || edges.upper)
  {
    const Edge& edge = lower ? *edges.lower : *edges.upper;
    held[edge.wall] = true;
    return oneWall(edge, lower, abilities);
  }
  return std::nullopt;
}

} // namespace

WallPlan planWalls(const DeviceCommand& command, const PidScale& scale, const ConditionAbilities& abilities,
  double largestShare) noexcept
{
  WallPlan plan;
  if (!abilities.saturation || (!abilities.deadBand && !abilities.twoCoefficients))
  {
    return plan;
  }
  for (const int axis : { 0, 1 })
  {
    Condition& spring = plan.springs[static_cast<std::size_t>(axis)];
    if (const std::optional<Condition> held = holdAcross(edgesAcross(axis, command, scale), abilities, plan.held))
    {
      spring = *held;
      spring.positiveSaturation = std::min(spring.positiveSaturation, largestShare);
      spring.negativeSaturation = std::min(spring.negativeSaturation, largestShare);
    }
  }
  return plan;
}

Vec3 hostWallForce(const DeviceCommand& command, const WallPlan& plan, const Vec3& p_D) noexcept
{
  Vec3 force = Vec3::Zero();
  for (std::size_t i = 0; i < wallsOf(command); ++i)
  {
    if (!plan.held[i])
    {
      const DeviceWall& wall = command.walls[i];
      Condition spring = lowerWall(wall.offset_m, wall.stiffness_N_per_m);
      spring.negativeSaturation = std::max(0.0, wall.largest_N);
      force += conditionForce(spring, wall.normal_D.dot(p_D)) * wall.normal_D;
    }
  }
  return force;
}

Condition planDamper(const DeviceCommand& command, const PidScale& scale, double largestShare) noexcept
{
  if (!(command.viscosity_Ns_per_m > 0.0))
  {
    return {};
  }
  Condition braking = damper(std::min(command.viscosity_Ns_per_m / scale.damperViscosity_Ns_per_m, 1.0));
  braking.positiveSaturation = braking.negativeSaturation =
    std::min(largestShare, std::max(0.0, command.brakeLargest_N) / scale.maxForce_N);
  return braking;
}

} // namespace palpate
