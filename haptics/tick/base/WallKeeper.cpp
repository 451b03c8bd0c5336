// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tick/base/WallKeeper.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "haptics/contact/planes/FeatureGeometry.h"
#include "haptics/contact/sweep/Sweep.h"
#include "haptics/contact/view/Resolution.h"
#include "haptics/contact/view/SceneView.h"

namespace palpate
{
namespace
{

constexpr double leastLean = 0.02; // a direction that leans less counts as along the axis
constexpr std::uint32_t mostNodes = 4000;

/// A hand that is this fast stays within reach for two updates.
constexpr double fast_m_per_s = 0.5;

template<SceneView AnyScene>
FeaturePlane planeAt(const AnyScene& scene, const WallTick& tick, const ActiveFeature& f, const Vec3& x_W) noexcept
{
  return planeOf(surfaceOf(scene, f.surface), f, x_W, tick.contact.radius_u);
}

template<SceneView AnyScene>
AxisWalls touchedWalls(const AnyScene& scene, const WallTick& tick, const Vec3& x_D) noexcept
{
  std::array<NearWall, GodObjectState::maxFeatures> near{};
  const auto count = static_cast<std::size_t>(tick.state.count);
  for (std::size_t i = 0; i < count; ++i)
  {
    near[i].normal_D = tick.map.directionToDevice(planeAt(scene, tick, tick.state.features[i], tick.state.x_W).n);
  }
  return wallsAround(x_D, { near.data(), count }, leastLean);
}

/// How far the displacement along direction i is proven free [m]; all of it where nothing that stands across it is met.
template<SceneView AnyScene>
double freeAlong(const AnyScene& scene, const WallTick& tick, int i, double reach_m, std::uint32_t& nodes) noexcept
{
  SweepQuery query;
  const Vec3 way_W = -reach_m * tick.map.scale_u_per_m * tick.map.directionToScene(AxisWalls::direction(i));
  query.from_W = tick.state.x_W;
  query.to_W = tick.state.x_W + way_W;
  query.radius_u = tick.contact.radius_u;
  query.resolution.include(query.from_W);
  query.resolution.include(query.to_W);
  query.touched = { tick.state.features.data(), static_cast<std::size_t>(tick.state.count) };
  const SweepHit hit = sweepBall(scene, query, mostNodes);
  nodes += hit.work;
  if (!hit.hit)
  {
    return hit.freeUntil * reach_m; // the part not looked at for want of time may be a wall
  }
  const Vec3 normal_D = tick.map.directionToDevice(planeAt(scene, tick, hit.feature, query.from_W + hit.t * way_W).n);
  return AxisWalls::direction(i).dot(normal_D) > leastLean ? hit.t * reach_m : reach_m;
}

template<SceneView AnyScene>
AxisWalls wallsIn(const AnyScene& scene, const WallTick& tick, double reach_m, std::uint32_t& nodes) noexcept
{
  const Vec3 x_D = tick.map.toDevice(tick.state.x_W);
  AxisWalls walls = touchedWalls(scene, tick, x_D);
  for (int i = 0; i < AxisWalls::count; ++i)
  {
    std::optional<double>& offset_m = walls.offset_m[static_cast<std::size_t>(i)];
    const double free_m = offset_m ? reach_m : freeAlong(scene, tick, i, reach_m, nodes);
    if (free_m < reach_m)
    {
      offset_m = AxisWalls::direction(i).dot(x_D) - free_m;
    }
  }
  return walls;
}

} // namespace

AxisWalls lookForWalls(const WallTick& tick, double reach_m, std::uint32_t& nodes) noexcept
{
  return tick.scene.moves() ? wallsIn(MovingScene(tick.scene, tick.share), tick, reach_m, nodes)
                            : wallsIn(tick.scene, tick, reach_m, nodes);
}

std::uint32_t keepWalls(const DeviceWallPlan& plan, const WallTick& tick, DeviceWallState& held) noexcept
{
  held.since_s += tick.dt_s;
  if (held.since_s + 0.5 * tick.dt_s < plan.every_s)
  {
    return 0;
  }
  std::uint32_t nodes = 0;
  const AxisWalls wanted = lookForWalls(tick, 2.0 * fast_m_per_s * std::max(plan.every_s, tick.dt_s), nodes);
  // Where no wall stood a tick ago no time has been saved up: the device has had that one tick at most.
  const double since_s =
    std::isfinite(held.since_s) ? std::min(held.since_s, std::max(plan.every_s, tick.dt_s)) : tick.dt_s;
  const double most_m = tick.stiffness_N_per_m > 0.0 ? tick.maxRise_N_per_s * since_s / tick.stiffness_N_per_m : 0.0;
  const AxisWalls next = ledTo(held.walls, wanted, tick.handle_D, most_m);
  if (differ(held.walls, next, plan.step_m))
  {
    held.walls = next;
  }
  held.since_s = 0.0;
  return nodes;
}

double heldStiffness(double wanted_N_per_m, const WallTick& tick, DeviceWallState& held) noexcept
{
  DeviceCommand unit;
  command(held.walls, 1.0, unit);
  const double behind_m = forceOfWalls(unit, tick.handle_D).norm();
  const bool presses = held.stiffness_N_per_m > 0.0 && behind_m > 0.0;
  const double more_N = tick.maxRise_N_per_s * tick.dt_s;
  held.stiffness_N_per_m =
    presses ? std::min(wanted_N_per_m, held.stiffness_N_per_m + more_N / behind_m) : wanted_N_per_m;
  return held.stiffness_N_per_m;
}

void rampLimits(const WallTick& tick, DeviceWallState& held, DeviceCommand& command) noexcept
{
  const double most_N = held.each_N + tick.maxRise_N_per_s * tick.dt_s;
  for (std::size_t i = 0; i < command.wallCount; ++i)
  {
    held.each_N = command.walls[i].largest_N = std::min(command.walls[i].largest_N, most_N);
  }
}

} // namespace palpate
