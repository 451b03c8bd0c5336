// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "haptics/geometry/scene/SceneBuilder.h"
#include "haptics/session/mechanism/LooseSources.h"
#include "testing/haptics/session/PressingHand.h"

namespace palpate::test
{

inline constexpr double g_m_per_s2 = 9.81, stone_kg_per_m3 = 2500.0, handTick_s = 1e-3;
inline constexpr double fingertip_m = 0.005; ///< radius of the ball
inline const Vec3 half_m(0.03, 0.02, 0.01);
inline const double mass_kg = stone_kg_per_m3 * 8.0 * half_m.prod();
inline const double weight_N = mass_kg * g_m_per_s2;

[[nodiscard]] inline SurfaceInput floorInput()
{
  return surfaceOf("floor", makeBox(Vec3(-0.5, -0.5, -0.1), Vec3(0.5, 0.5, 0.0)));
}

/// A block that stands on the floor, whose data has its origin somewhere else.
[[nodiscard]] inline SurfaceInput stoneInput(const Vec3& at_W = Vec3::Zero())
{
  const Vec3 low(at_W.x() - half_m.x(), at_W.y() - half_m.y(), at_W.z());
  return surfaceOf("stone", makeBox(low, low + 2.0 * half_m));
}

[[nodiscard]] inline std::shared_ptr<const Scene> sceneOfAll(const std::vector<SurfaceInput>& surfaces)
{
  return SceneBuilder(1).build(surfaces).scene;
}

[[nodiscard]] inline LooseSources stones(double density_kg_per_m3 = stone_kg_per_m3)
{
  LooseSources loose;
  loose.density_kg_per_m3 = { { "stone", density_kg_per_m3 } };
  loose.unit_m = 1.0;
  return loose;
}

} // namespace palpate::test
