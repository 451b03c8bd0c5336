// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "devices/simulated/PrincipalPlant.h"
#include "haptics/force/LinearPlant.h"
#include "testing/support/Random.h"

namespace palpate
{
namespace
{

constexpr double tick_s = 1e-3;
const Vec3 masses_kg(0.05, 0.12, 0.4), dampings_Ns_per_m(0.3, 0.0, 2.0);
const HandModel holder{ "holder", 300.0, 1.5, 0.02 };

Mat3 anyTurn(test::Random& random)
{
  const Vec3 axis = random.direction();
  return Eigen::AngleAxisd(random.uniform(0.0, std::numbers::pi), axis).toRotationMatrix();
}

PrincipalPart along(const Mat3& directions_D)
{
  PrincipalPart part;
  part.directions_D = directions_D;
  part.mass_kg = masses_kg;
  part.damping_Ns_per_m = dampings_Ns_per_m;
  return part;
}

// Judge: the closed form of each mass alone, in coordinates along its direction.
TEST(PrincipalPlant, MovesEachDirectionAsItsOwnMassInTheHandWhicheverWayItPoints)
{
  test::Random random(test::testSeed(4409));
  for (std::size_t round = 0; round < test::testCount(20); ++round)
  {
    SCOPED_TRACE(round);
    const Mat3 R = anyTurn(random);
    const PrincipalPlant plant(along(R), holder, tick_s);
    Vec3 p_D = 0.01 * random.direction(), v_D = 0.1 * random.direction();
    Vec3 y = R.transpose() * p_D, w = R.transpose() * v_D;
    for (int tick = 0; tick < 200; ++tick)
    {
      const Vec3 force_N = 2.0 * random.direction();
      plant.step(p_D, v_D, force_N);
      for (int i = 0; i < 3; ++i)
      {
        const LinearPlant one(masses_kg[i] + holder.mass_kg, dampings_Ns_per_m[i] + holder.damping_Ns_per_m,
          holder.stiffness_N_per_m, tick_s);
        const Eigen::Vector2d next = one.free() * Eigen::Vector2d(y[i], w[i]) + one.held() * R.col(i).dot(force_N);
        y[i] = next[0];
        w[i] = next[1];
      }
      ASSERT_LE((p_D - R * y).norm(), 1e-14);
      ASSERT_LE((v_D - R * w).norm(), 1e-12);
    }
  }
}

TEST(PrincipalPlant, StaysInThePlaneOfItsTwoDirections)
{
  test::Random random(test::testSeed(4410));
  const Mat3 R = anyTurn(random);
  PrincipalPart part = along(R);
  part.count = 2;
  const PrincipalPlant plant(part, holder, tick_s);
  Vec3 p_D = 0.01 * R.col(2), v_D = Vec3::Zero();
  for (int tick = 0; tick < 200; ++tick)
  {
    plant.step(p_D, v_D, 2.0 * random.direction());
    ASSERT_NEAR(R.col(2).dot(p_D), 0.01, 1e-14);
    ASSERT_NEAR(R.col(2).dot(v_D), 0.0, 1e-14);
  }
  EXPECT_GT((p_D - 0.01 * R.col(2)).norm(), 1e-5);
}

// Damping across the directions, as of the start of a period: it goes to that of a coupled pair as the period goes to
// none.
TEST(PrincipalPlant, WithDampingAcrossConvergesToTheDecayOfTheCoupledPair)
{
  constexpr double mass_kg = 0.1, own = 1.0, across = 0.6, time_s = 0.08;
  PrincipalPart part;
  part.mass_kg.setConstant(mass_kg);
  part.damping_Ns_per_m.setConstant(own);
  part.dampingAcross(0, 1) = part.dampingAcross(1, 0) = across;
  // Along (1, 1) the damping is own + across, along (1, -1) it is own - across.
  const double both = std::exp(-(own + across) / mass_kg * time_s),
               apart = std::exp(-(own - across) / mass_kg * time_s);
  const Vec3 expected(0.5 * (both + apart), 0.5 * (both - apart), 0.0);
  const auto errorAt = [&](int steps)
  {
    const PrincipalPlant plant(part, HandModel{}, time_s / steps);
    Vec3 p_D = Vec3::Zero(), v_D = Vec3::UnitX();
    for (int k = 0; k < steps; ++k)
    {
      plant.step(p_D, v_D, Vec3::Zero());
    }
    return (v_D - expected).norm();
  };
  const double coarse = errorAt(80), fine = errorAt(800);
  EXPECT_LE(fine, 0.11 * coarse);
  EXPECT_LE(coarse, 0.01);
}

} // namespace
} // namespace palpate
