// SPDX-License-Identifier: GPL-3.0-or-later
// Row 46: a handle slides along a line at 45 degrees that the device holds as a vertical and a horizontal wall, moved
// on by the host. Between two updates the corner stays behind by s = speed * time and pulls back.
#include <algorithm>
#include <cmath>
#include <string>

#include "devices/common/Condition.h"
#include "haptics/force/DeviceWalls.h"
#include "testing/lab/Experiments.h"
#include "testing/lab/Felt.h"

namespace palpate::lab
{
namespace slanted_wall_experiment
{

constexpr double K = 200.0, device_s = 1e-3, maxForce_N = 5.0; // the joystick of the nineties

struct How
{
  double speed_m_per_s, host_s, depth_m;
};

struct Drag
{
  double mean_N = 0.0, peak_N = 0.0;
};

/// The force of the walls of a command on a handle, as the device's own loop makes it.
Vec3 heldForce(const DeviceCommand& command, const Vec3& p_D)
{
  Vec3 force = Vec3::Zero();
  for (std::size_t i = 0; i < command.wallCount; ++i)
  {
    const DeviceWall& wall = command.walls[i];
    const Condition spring = lowerWall(wall.offset_m, wall.stiffness_N_per_m);
    force += conditionForce(spring, wall.normal_D.dot(p_D)) * wall.normal_D;
  }
  return force;
}

/// Ten updates of the host, the handle led along the line; `way` +1 or -1.
Drag slideAlong(const How& how, double way)
{
  const double half = std::sqrt(0.5);
  const Vec3 n(half, half, 0), along = way * Vec3(half, -half, 0);
  const int ratio = static_cast<int>(std::lround(how.host_s / device_s)), ticks = 10 * ratio;
  DeviceCommand walls;
  Drag drag;
  for (int tick = 0; tick < ticks; ++tick)
  {
    const Vec3 virtual_D = how.speed_m_per_s * tick * device_s * along;
    if (tick % ratio == 0)
    {
      const NearWall touched{ n, 0.0 };
      command(wallsAround(virtual_D, { &touched, 1 }), K, walls);
    }
    const double drag_N = -along.dot(heldForce(walls, virtual_D - how.depth_m * n));
    drag.mean_N += drag_N / ticks;
    drag.peak_N = std::max(drag.peak_N, drag_N);
  }
  return drag;
}

/// K s while both walls press, K (p + s) / 2 once the handle is off one of them, over the periods of one update.
Drag truth(const How& how)
{
  const int ratio = static_cast<int>(std::lround(how.host_s / device_s));
  Drag drag;
  for (int tick = 0; tick < ratio; ++tick)
  {
    const double behind_m = how.speed_m_per_s * tick * device_s;
    const double drag_N = behind_m <= how.depth_m ? K * behind_m : K * (how.depth_m + behind_m) / 2;
    drag.mean_N += drag_N / ratio;
    drag.peak_N = std::max(drag.peak_N, drag_N);
  }
  return drag;
}

void judge(const How& how, Table& table)
{
  const std::string name =
    caseName({ { "speed", how.speed_m_per_s }, { "host", 1 / how.host_s }, { "depth", how.depth_m } });
  const Drag expected = truth(how);
  for (const double way : { 1.0, -1.0 })
  {
    const std::string method = way > 0 ? "two held walls, down" : "two held walls, up";
    const Drag drag = slideAlong(how, way);
    table.within({ name, method, "mean drag", "N" }, drag.mean_N, expected.mean_N, 0.01 * expected.mean_N + 1e-12);
    table.within({ name, method, "peak drag", "N" }, drag.peak_N, expected.peak_N, 0.01 * expected.peak_N + 1e-12);
  }
  const Velvet said = velvet({ K, how.speed_m_per_s, how.depth_m, how.host_s, device_s, std::sqrt(0.5) });
  table.within({ name, "what is said of it", "mean drag", "N" }, said.mean_N, expected.mean_N, 1e-9);
  table.within({ name, "what is said of it", "peak drag", "N" }, said.peak_N, expected.peak_N, 1e-9);
}

} // namespace slanted_wall_experiment

void runSlantedWall(const Conditions&, Table& table)
{
  using namespace slanted_wall_experiment;
  for (const double rate_Hz : { 20.0, 25.0, 50.0, 100.0, 125.0, 200.0, 250.0, 500.0, 1000.0 })
  {
    for (const double speed : { 0.05, 0.2 })
    {
      for (const double depth_m : { 0.02, 0.002 })
      {
        judge({ speed, 1 / rate_Hz, depth_m }, table);
      }
    }
  }
  // A fast slide as a share of the motors' largest force: the rate of the original is felt, the rate of a USB joystick
  // not.
  constexpr double fast = 0.2, deep_m = 0.02;
  const auto share = [](double rate_Hz) { return slideAlong({ fast, 1 / rate_Hz, deep_m }, 1.0).mean_N / maxForce_N; };
  table.atLeast({ "speed=0.2 host=20", "original rate", "mean drag over largest force" }, share(20.0), forceJnd);
  table.atMost({ "speed=0.2 host=125", "two held walls", "mean drag over largest force" }, share(125.0), forceJnd);
}

} // namespace palpate::lab
