// SPDX-License-Identifier: GPL-3.0-or-later
// Loose bodies on a soft one whose snapshots are late. Judge: the sum of kinetic and potential energy of the stone from
// its poses, and its weight.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "HeldMesh.h"
#include "LooseRig.h"
#include "haptics/tool/motion/Turn.h"

namespace palpate::test
{
namespace
{

constexpr double tickOnPad_s = 1e-3;
constexpr int stoneOfPad = 2;
const Vec3 halfOfStone_m(0.03, 0.02, 0.01), far_W(-0.5, -0.5, 0.5);

/// A cube in the hand, the pad of Blocks.h, and a stone above its middle.
struct StoneOnPad
{
  StoneOnPad(double density_kg_per_m3, double young_Pa, double above_m)
    : inputs(meshOnPad(boxOf(Vec3::Constant(0.005)), 6, 0.3))
  {
    SoftBodyInput soft = *this->inputs.soft.front().input;
    soft.young_Pa = { young_Pa };
    this->inputs.soft.front().input = std::make_shared<const SoftBodyInput>(soft);
    this->body.name = "stone";
    this->body.kind = MechanismBodyKind::Rigid;
    this->body.halfSize_u = halfOfStone_m;
    Vec3 low = soft.mesh.vertices_W.front(), high = low;
    for (const Vec3& p : soft.mesh.vertices_W)
    {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    const Vec3 middle = 0.5 * (low + high);
    this->body.pose_W.p = Vec3(middle.x(), middle.y(), high.z() + halfOfStone_m.z() + above_m);
    EXPECT_EQ(giveMass(this->body, density_kg_per_m3, 1.0).refusal, "");
    this->body.load_W = -this->weight_N() * Vec3::UnitZ();
    this->inputs.mechanism.bodies.push_back(this->body);
  }

  [[nodiscard]] double weight_N() const { return gravity_m_per_s2 * this->body.mass.mass_Ns2_per_u; }
  /// Kinetic energy between two poses, and potential energy in the second.
  [[nodiscard]] double energy_J(const Pose& from_W, const Pose& to_W) const
  {
    const Vec3 v = (to_W.p - from_W.p) / tickOnPad_s;
    const Vec3 w = from_W.q.conjugate() * Vec3(turnFromTo(from_W.q, to_W.q) / tickOnPad_s);
    const Vec3 square = halfOfStone_m.cwiseAbs2();
    const double mass_kg = this->body.mass.mass_Ns2_per_u;
    const Vec3 inertia =
      mass_kg / 3.0 * Vec3(square.y() + square.z(), square.z() + square.x(), square.x() + square.y());
    return 0.5 * mass_kg * v.squaredNorm() + 0.5 * w.dot(inertia.cwiseProduct(w)) + this->weight_N() * to_W.p.z();
  }

  MechanismBody body;
  MechanismInputs inputs;
};

double pressed_N(const MechanismResult& result)
{
  double sum_N = 0.0;
  for (int l = 0; l < result.found; ++l)
  {
    sum_N += result.laws[static_cast<std::size_t>(l)].force_W.z();
  }
  return sum_N;
}

/// As far as docs/mechanisms.md says that a pad holds a stone up: its even load would strain the pad by no more than a
/// quarter.
TEST(LooseOnSoft, AStoneIsGivenNoEnergyAndComesToRestWithItsWeightAtAnyRate)
{
  for (const double rate_Hz : { 30.0, 60.0, 200.0 })
  {
    for (const double density_kg_per_m3 : { 1000.0, 2700.0, 7800.0 })
    {
      for (const double young_Pa : { 5e3, 20e3, 50e3 })
      {
        const double strain = density_kg_per_m3 * gravity_m_per_s2 * 2.0 * halfOfStone_m.z() / young_Pa;
        if (strain > 0.25)
        {
          continue;
        }
        const StoneOnPad scene(density_kg_per_m3, young_Pa, 1e-4);
        MeshTouch touch(scene.inputs, firmHold(rate_Hz));
        Pose before_W = scene.body.pose_W;
        const double began_J = scene.energy_J(before_W, before_W);
        double most_J = 0.0, force_N = 0.0;
        for (int i = 0; i < 4000; ++i)
        {
          const MechanismResult& result = touch.to(far_W);
          most_J = std::max(most_J, scene.energy_J(before_W, result.pose_W[stoneOfPad]));
          before_W = result.pose_W[stoneOfPad];
          force_N = pressed_N(result);
        }
        const auto where = testing::Message() << rate_Hz << " Hz, " << density_kg_per_m3 << ", " << young_Pa << " Pa";
        EXPECT_LE(most_J, began_J * (1.0 + 1e-12)) << where;
        EXPECT_NEAR(force_N, scene.weight_N(), 0.01 * scene.weight_N()) << where;
        const Vec3 way_m = touch.to(far_W).pose_W[stoneOfPad].p - before_W.p;
        EXPECT_LE(way_m.norm(), 1e-3 * tickOnPad_s) << where << ": a millimetre a second";
      }
    }
  }
}

/// An impact beside the middle of edges of the pad: snapshots change by much between two ticks.
TEST(LooseOnSoft, AStoneThatFallsGainsNoEnergy)
{
  for (const double rate_Hz : { 30.0, 200.0 })
  {
    for (const double above_m : { 2e-3, 1e-2 })
    {
      const StoneOnPad scene(2700.0, 20e3, above_m);
      MeshTouch touch(scene.inputs, firmHold(rate_Hz));
      Pose before_W = scene.body.pose_W;
      const double began_J = scene.energy_J(before_W, before_W);
      for (int i = 0; i < 2000; ++i)
      {
        const Pose now_W = touch.to(far_W).pose_W[stoneOfPad];
        ASSERT_LE(scene.energy_J(before_W, now_W), began_J * (1.0 + 1e-12))
          << rate_Hz << ", " << above_m << " at " << i;
        before_W = now_W;
      }
    }
  }
}

/// The pad without weight of its own holds a flat mesh by one stiffness from the first touch on, though rounding bends
/// the flat side either way: a place of the stone that differs by rounding makes no difference in the force.
TEST(LooseOnSoft, AFlatSideIsFlatWithinRounding)
{
  double least_N = 1e9, most_N = 0.0;
  for (int k = -4; k <= 4; ++k)
  {
    StoneOnPad scene(7800.0, 50e3, 1e-4 + 7e-18 * k); // the last bit of a place there
    MeshTouch touch(scene.inputs, firmHold(30.0));
    double force_N = 0.0;
    for (int i = 0; i < 20; ++i)
    {
      force_N = pressed_N(touch.to(far_W));
    }
    least_N = std::min(least_N, force_N);
    most_N = std::max(most_N, force_N);
  }
  EXPECT_NEAR(least_N, most_N, 0.01 * most_N);
  EXPECT_GT(least_N, 2.0) << "half a millimetre deep at 5 N/mm";
}

} // namespace
} // namespace palpate::test
