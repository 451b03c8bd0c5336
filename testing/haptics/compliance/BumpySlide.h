// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "SoftScenes.h"
#include "testing/support/Random.h"

namespace palpate::test
{

/// A slide of a ball or point over bumps that yield.
namespace slide
{

inline constexpr double stiffness = 1000.0;

/// The bumps and the ball that slides over them.
struct Bumps
{
  double young_Pa = 20e3;
  double height = 0.001; ///< of its vertices at random, up and down [m]
  double radius = 0.0;
  double friction = 0.0;
  std::uint64_t seed = 191;
  double depth = 0.0; ///< of the hand [m]; 0: 6 mm into a soft pad, 1.5 mm into a stiff one
};

inline SoftPad padOf(const Bumps& bumps)
{
  Random random(testSeed(bumps.seed));
  return SoftPad(16, patchEdges, ElementKind::EdgeSmoothed,
    [&](SoftBodyInput& input)
    {
      input.young_Pa = { bumps.young_Pa };
      for (Vec3& p : input.mesh.vertices_W)
      {
        p.z() += std::abs(p.z() - 0.05) < 1e-9 ? bumps.height * random.uniform(-1.0, 1.0) : 0.0;
      }
    });
}

/// A slide of 50 mm/s in ticks of 1 ms.
inline Vec3 handAt(const Bumps& bumps, int tick)
{
  const double usual = bumps.young_Pa < 1e6 ? 0.006 : 0.0015;
  const double depth = bumps.depth > 0.0 ? bumps.depth : usual;
  const double down = std::min(1.0, tick / 100.0);
  return { 0.013 + 5e-5 * tick, 0.0513 + 0.01 * std::sin(0.003 * tick), 0.054 + bumps.radius - down * (depth + 0.004) };
}

/// How much a force may change from tick to tick: with the hand's displacement by the spring, and by a tenth of itself.
inline double stepAllowed_N(const Vec3& way_u, const Vec3& before_N, const Vec3& now_N)
{
  return stiffness * way_u.norm() + 0.1 * std::max(before_N.norm(), now_N.norm());
}

inline constexpr int ticksOfSlide = 1500;

} // namespace slide

} // namespace palpate::test
