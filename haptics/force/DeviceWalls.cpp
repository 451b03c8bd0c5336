// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/force/DeviceWalls.h"

#include <algorithm>
#include <cmath>

namespace palpate
{

Vec3 AxisWalls::direction(int i) noexcept
{
  const double way = i < 2 ? 1.0 : -1.0;
  return i % 2 == 0 ? Vec3(way, 0, 0) : Vec3(0, way, 0);
}

AxisWalls wallsAround(const Vec3& x_D, std::span<const NearWall> near, double leastLean) noexcept
{
  AxisWalls walls;
  for (int i = 0; i < AxisWalls::count; ++i)
  {
    std::optional<double>& offset_m = walls.offset_m[static_cast<std::size_t>(i)];
    const Vec3 direction = AxisWalls::direction(i);
    for (const NearWall& wall : near)
    {
      const double lean = direction.dot(wall.normal_D);
      if (lean > leastLean)
      {
        const double met_m = direction.dot(x_D) - wall.gap_m / lean;
        offset_m = std::max(offset_m.value_or(met_m), met_m);
      }
    }
  }
  return walls;
}

AxisWalls ledTo(const AxisWalls& held, const AxisWalls& wanted, const Vec3& handle_D, double most_m) noexcept
{
  AxisWalls next;
  for (int i = 0; i < AxisWalls::count; ++i)
  {
    const auto slot = static_cast<std::size_t>(i);
    if (wanted.offset_m[slot])
    {
      const double handle_m = AxisWalls::direction(i).dot(handle_D);
      const double from_m = std::max(held.offset_m[slot].value_or(handle_m), handle_m);
      next.offset_m[slot] = std::min(*wanted.offset_m[slot], from_m + most_m);
    }
  }
  return next;
}

bool differ(const AxisWalls& sent, const AxisWalls& now, double step_m) noexcept
{
  for (std::size_t i = 0; i < AxisWalls::count; ++i)
  {
    const std::optional<double>&a = sent.offset_m[i], &b = now.offset_m[i];
    if (a.has_value() != b.has_value() || (a && a != b && std::fabs(*a - *b) >= step_m))
    {
      return true;
    }
  }
  return false;
}

void command(const AxisWalls& walls, double stiffness_N_per_m, DeviceCommand& command, double largest_N) noexcept
{
  const auto& offsets = walls.offset_m;
  const bool bothAxes = (offsets[0] || offsets[2]) && (offsets[1] || offsets[3]);
  const double each_N = bothAxes ? largest_N / std::sqrt(2.0) : largest_N;
  command.wallCount = 0;
  for (int i = 0; i < AxisWalls::count; ++i)
  {
    if (const std::optional<double>& offset_m = walls.offset_m[static_cast<std::size_t>(i)])
    {
      command.walls[command.wallCount++] = { AxisWalls::direction(i), *offset_m, stiffness_N_per_m, each_N };
    }
  }
}

bool isFinite(const DeviceCommand& command) noexcept
{
  const auto last = command.walls.begin() + std::min<std::size_t>(command.wallCount, command.walls.size());
  const auto usable = [](const DeviceWall& wall)
  {
    return wall.normal_D.allFinite() && std::isfinite(wall.offset_m) && std::isfinite(wall.stiffness_N_per_m) &&
           wall.largest_N >= 0.0;
  };
  return std::isfinite(command.viscosity_Ns_per_m) && std::all_of(command.walls.begin(), last, usable);
}

Vec3 forceOfWalls(const DeviceCommand& command, const Vec3& p_D) noexcept
{
  Vec3 force = Vec3::Zero();
  for (std::size_t i = 0; i < std::min<std::size_t>(command.wallCount, command.walls.size()); ++i)
  {
    const DeviceWall& wall = command.walls[i];
    const double depth_m = std::max(0.0, wall.offset_m - wall.normal_D.dot(p_D));
    force += std::min(wall.stiffness_N_per_m * depth_m, wall.largest_N) * wall.normal_D;
  }
  return force;
}

Velvet velvet(const Slide& slide) noexcept
{
  // Period k of n after an update: the corner is k steps of the handle behind.
  const double n = std::max(1.0, static_cast<double>(static_cast<long>(slide.host_s / slide.device_s + 0.5)));
  const double step_m = slide.speed_m_per_s * slide.device_s, stiffness_N_per_m = slide.stiffness_N_per_m;
  const double upright = std::sqrt(1.0 - slide.lean * slide.lean);
  const double detached_m = slide.depth_m * slide.lean / upright;
  // Periods 0 .. both - 1 press both walls.
  const double most = step_m > 0.0 ? detached_m / step_m : n;
  const double both = most < n - 1.0 ? static_cast<double>(static_cast<long>(most)) + 1.0 : n;
  const auto alone_N = [&](double behind_m)
  { return stiffness_N_per_m * slide.lean * (slide.depth_m * upright + behind_m * slide.lean); };
  const double last_m = (n - 1.0) * step_m;
  const double sumBoth_m = step_m * both * (both - 1.0) / 2.0;
  const double sumAlone_N = (n - both) * alone_N(step_m * (both + n - 1.0) / 2.0);
  return { (stiffness_N_per_m * sumBoth_m + sumAlone_N) / n, both == n ? stiffness_N_per_m * last_m : alone_N(last_m) };
}

} // namespace palpate
