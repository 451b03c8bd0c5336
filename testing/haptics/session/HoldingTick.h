// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <memory>

#include "haptics/geometry/curves/CurveSet.h"
#include "haptics/tick/ForceRenderer.h"
#include "testing/support/Meshes.h"

namespace palpate::test
{

/// Stiffness of the walls [N/m].
inline constexpr double K = 200.0;

inline std::shared_ptr<const Scene> sceneOf(const CurveSet& curves)
{
  return sceneOf(raiseWalls(curves, 0.01));
}

/// Along x between y = -half and +half [m], closed at neither end.
inline CurveSet corridor(double half_m)
{
  return { { { -0.04, half_m }, { 0.04, half_m }, { -0.04, -half_m }, { 0.04, -half_m } }, { { 0, 1 }, { 2, 3 } } };
}

/// Through the origin, the free place on the side of (sin, cos) of the angle to the x axis.
inline CurveSet slant(double angle_rad)
{
  const Eigen::Vector2d along(0.04 * std::cos(angle_rad), -0.04 * std::sin(angle_rad));
  return { { -along, along }, { { 0, 1 } } };
}

inline HapticParameters holding()
{
  HapticParameters parameters;
  parameters.stiffness_N_per_m = K;
  parameters.safety = SafetyLimits::none();
  parameters.walls.hold = true;
  return parameters;
}

/// The tick by itself, with a hand that is put where it is wanted.
struct HoldingTick
{
  std::shared_ptr<const Scene> scene;
  HapticParameters parameters = holding();
  RendererState state = {};
  std::uint64_t tick = 0;

  TickOutput at(double x_m, double y_m, double dt_s = 1e-3, std::uint32_t buttons = 0)
  {
    TickInput input;
    input.sample.buttons = buttons;
    input.tick = ++this->tick;
    input.dt_s = dt_s;
    input.scene = this->scene.get();
    input.sample.time_s = dt_s * static_cast<double>(this->tick);
    input.sample.pose_D.p = { x_m, y_m, 0 };
    return renderTick(input, this->parameters, this->state);
  }
};

} // namespace palpate::test
