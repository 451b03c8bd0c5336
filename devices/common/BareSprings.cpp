// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/common/BareSprings.h"

#include <algorithm>
#include <cstddef>

namespace palpate
{

Condition bareSpring(double centre, double coefficient) noexcept
{
  Condition spring;
  spring.centre = centre;
  spring.positiveCoefficient = coefficient;
  spring.negativeCoefficient = coefficient;
  return spring;
}

void switchSprings(const Vec3& p_D, DeviceCommand& command) noexcept
{
  const std::size_t walls = std::min<std::size_t>(command.wallCount, command.walls.size());
  command.wallCount = 0;
  for (std::size_t i = 0; i < walls; ++i)
  {
    DeviceWall wall = command.walls[i];
    const double depth_m = wall.offset_m - wall.normal_D.dot(p_D);
    if (depth_m > 0.0)
    {
      wall.stiffness_N_per_m = std::min(wall.stiffness_N_per_m, wall.largest_N / depth_m);
      command.walls[command.wallCount++] = wall;
    }
  }
}

} // namespace palpate
