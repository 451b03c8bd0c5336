// SPDX-License-Identifier: GPL-3.0-or-later
// Pushes a point into a sphere along a line and prints the force: a program that uses the installed library.

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <numbers>

#include "haptics/geometry/scene/SceneBuilder.h"
#include "haptics/tick/ForceRenderer.h"

namespace
{
using palpate::Vec3;

constexpr double radius_u = 0.050; // one scene unit is one metre of the hand: HapticParameters::map
constexpr double stiffness_N_per_m = 500.0;

/// A sphere of triangles, its vertices on `rows` steps from pole to pole and twice as many around.
std::shared_ptr<const palpate::TriangleMesh> sphere(std::uint32_t rows)
{
  auto mesh = std::make_shared<palpate::TriangleMesh>();
  const std::uint32_t columns = 2 * rows;
  for (std::uint32_t row = 0; row <= rows; ++row)
  {
    for (std::uint32_t column = 0; column < columns; ++column)
    {
      const double down = std::numbers::pi * row / rows;
      const double around = std::numbers::pi * column / rows;
      mesh->vertices_W.push_back(
        radius_u * Vec3(std::sin(down) * std::cos(around), std::sin(down) * std::sin(around), std::cos(down)));
      if (row < rows)
      {
        const std::uint32_t right = (column + 1) % columns;
        const std::uint32_t here = row * columns;
        const std::uint32_t below = here + columns;
        mesh->triangles.push_back({ here + column, below + column, below + right });
        mesh->triangles.push_back({ here + column, below + right, here + right });
      }
    }
  }
  return mesh;
}
} // namespace

int main()
{
  // A scene is built once, off the servo thread; meshes are cleaned, and the report names the parts left out.
  const palpate::SceneBuildResult built = palpate::SceneBuilder().build({ { .name = "sphere", .mesh = sphere(100) } });
  if (!built.scene)
  {
    std::fprintf(stderr, "nothing to touch: %s\n", built.reports.front().refusal.c_str());
    return 1;
  }

  palpate::HapticParameters parameters;
  parameters.stiffness_N_per_m = stiffness_N_per_m;
  parameters.safety = palpate::SafetyLimits::none(); // no hand is on a device here

  // One tick a millisecond, a millimetre each: towards the centre along a line that meets the sphere off its axes.
  const Vec3 direction_W = Vec3(2.0, -1.0, 3.0).normalized();
  palpate::RendererState state;
  std::printf("distance_m,force_N\n");
  for (std::uint64_t tick = 0; tick <= 60; ++tick)
  {
    const Vec3 p_W = (0.070 - 0.001 * static_cast<double>(tick)) * direction_W;
    palpate::TickInput input;
    input.tick = tick;
    input.sample.time_s = 1e-3 * static_cast<double>(tick);
    input.sample.pose_D.p = parameters.map.toDevice(p_W);
    input.scene = built.scene.get();
    const palpate::TickOutput output = palpate::renderTick(input, parameters, state);
    std::printf("%.17g,%.17g\n", p_W.norm(), output.command.wrench_D.force.dot(direction_W));
  }
  return 0;
}
