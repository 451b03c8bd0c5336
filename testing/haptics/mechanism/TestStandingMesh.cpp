// SPDX-License-Identifier: GPL-3.0-or-later
// A soft bar is pressed onto a mesh that stands behind it: when it meets that mesh, and how much of the hand's force
// the mesh bears, against a finite element solve with all contacts at once that is written apart.
#include <cmath>

#include <gtest/gtest.h>

#include "WholeBar.h"
#include "haptics/core/PoseMath.h"
#include "haptics/mechanism/servo/StandingGuard.h"

namespace palpate::test
{
namespace
{

/// A mesh in the hand, that bar, and a block that stands below its free end.
MechanismInputs onBarAndBlock(const TriangleMesh& mesh, const std::array<int, 3>& cells, double friction = 0.0)
{
  MechanismInputs inputs;
  MechanismBody tool, soft, block;
  tool.name = "tool";
  tool.kind = MechanismBodyKind::Held;
  tool.mesh = heldMesh(mesh);
  soft.name = "bar";
  soft.kind = MechanismBodyKind::Soft;
  block.name = "block";
  block.mesh = heldMesh(blockBelowBar());
  inputs.mechanism.bodies = { tool, soft, block };
  inputs.mechanism.findsContacts = true;
  inputs.mechanism.foundFriction = friction;
  inputs.soft = { { "bar", std::make_shared<const SoftBodyInput>(bar(cells)) } };
  return inputs;
}

/// Cells of the bar, and rate of its snapshots [Hz]; 0: at rest in each tick.
struct BarCase
{
  std::array<int, 3> cells{};
  double rate_Hz = 0.0;
};

class StandingMesh : public testing::TestWithParam<BarCase>
{
};

TEST_P(StandingMesh, IsMetWhereTheGapClosesAndBearsWhatAWholeSolveSays)
{
  constexpr double step_m = 5e-5, stepOfEnd_m = 1.3 * step_m; // the free end goes further than the hand
  const auto [cells, rate_Hz] = GetParam();
  MeshTouch touch(onBarAndBlock(makeIcosphere(3, 0.015), cells), firmHold(rate_Hz));
  WholeBar whole(bar(cells));
  const Vec3 above(0.08, 0.02, barSize.z() + 0.015);
  bool met = false;
  double before_m = gap_m, worst_N = 0.0, most_N = 0.0;
  for (int i = 0; i <= 90; ++i)
  {
    const MechanismResult& r = touch.to(Vec3(above - Vec3(0, 0, step_m * i)), 1e-3, rate_Hz > 0.0 ? 100 : 1);
    whole.press(pressesFrom(r, 0), touch.body().snapshot->free_W);
    const double borne_N = upwards_N(pressesFrom(r, 2)), expected_N = whole.borne_N();
    if (borne_N > 0.0 && !met)
    {
      EXPECT_GE(before_m, 0.0);
      EXPECT_LE(before_m, stepOfEnd_m);
      met = true;
    }
    before_m = whole.leastGap_m();
    most_N = std::max(most_N, expected_N);
    worst_N = std::max(worst_N, std::abs(borne_N - expected_N));
  }
  // A contact's force is spread over a patch here and acts on a vertex there.
  const double edges = barSize.x() / cells[0] / 0.005;
  EXPECT_TRUE(met);
  EXPECT_GT(most_N, 3.0);
  EXPECT_LE(worst_N, 0.02 * edges * most_N);
}

INSTANTIATE_TEST_SUITE_P(Each, StandingMesh,
  testing::Values(BarCase{ { 10, 4, 2 }, 0.0 }, BarCase{ { 20, 8, 4 }, 0.0 }, BarCase{ { 20, 8, 4 }, 30.0 }));

TEST(StandingMesh, IsMetByABarThatARodPressesAtANamedContact)
{
  MechanismInputs inputs = onBarAndBlock(makeIcosphere(1, 0.01), { 20, 8, 4 });
  constexpr double length_m = 0.05;
  const Vec3 pressed(0.08, 0.02, barSize.z());
  MechanismBody& rod = inputs.mechanism.bodies.front();
  rod.mesh.reset();
  rod.length_u = length_m;
  rod.diameter_u = 0.004;
  rod.pose_W.q = Quat(0.0, 1.0, 0.0, 0.0); // it points down
  MechanismConstraint contact;
  contact.name = "tip";
  contact.kind = ConstraintKind::Contact;
  contact.a = rod.name;
  contact.b = "bar";
  contact.point_A = Vec3(0, 0, length_m);
  contact.point_B = pressed;
  inputs.mechanism.laws = { contact };
  MeshTouch touch(inputs);
  WholeBar whole(bar({ 20, 8, 4 }));
  double worst_N = 0.0, most_N = 0.0;
  for (int i = 0; i <= 80; ++i)
  {
    const MechanismResult& r = touch.to(Vec3(pressed + Vec3(0, 0, length_m - 5e-5 * i)), 1e-3, 100);
    whole.press(pressesFrom(r, 0), touch.body().snapshot->free_W);
    const double borne_N = upwards_N(pressesFrom(r, 2)), expected_N = whole.borne_N();
    most_N = std::max(most_N, expected_N);
    worst_N = std::max(worst_N, std::abs(borne_N - expected_N));
    EXPECT_FALSE(r.ahead) << i;
  }
  EXPECT_GT(most_N, 0.5);
  EXPECT_LE(worst_N, 0.02 * most_N); // as on this mesh under a ball
}

constexpr double half_m = 0.01;
const Vec3 overBlock(0.125, 0.02, half_m - gap_m); ///< beyond the bar: the tool lies on the block

MechanismInputs boxOverBlock(double friction)
{
  return onBarAndBlock(makeBox(Vec3::Constant(-half_m), Vec3::Constant(half_m)), { 10, 4, 2 }, friction);
}

TEST(StandingMesh, StopsTheMeshInTheHandAsAStiffWallDoes)
{
  const double rest_m = StandingGuard::rest * 2.0 * std::sqrt(3.0) * half_m; // that the box stays away
  MeshTouch touch(boxOverBlock(0.0));
  for (int i = -50; i <= 100; ++i)
  {
    const double deep_m = 1e-5 * i;
    const MechanismResult& r = touch.to(Vec3(overBlock - Vec3(0, 0, deep_m)));
    EXPECT_NEAR(r.exact_W.force.z(), firmHold().stiffness_N_per_m * std::max(deep_m + rest_m, 0.0), 1e-6) << i;
    EXPECT_LE(r.exact_W.force.head<2>().norm(), 1e-6) << i;
  }
}

/// The force on a mesh that is dragged over the block, 1 mm deep, at the end of a way of 5 mm.
MechanismResult dragged(const TriangleMesh& mesh, double friction)
{
  MeshTouch touch(onBarAndBlock(mesh, { 10, 4, 2 }, friction));
  const Vec3 pressed = overBlock - Vec3(0, 0, 1e-3);
  MechanismResult slid;
  for (int i = 0; i <= 1000; ++i)
  {
    slid = touch.to(Vec3(pressed + Vec3(0, 5e-6 * i, 0)));
  }
  return slid;
}

TEST(StandingMesh, RubsTheMeshInTheHandByCoulombsLaw)
{
  const TriangleMesh box = makeBox(Vec3::Constant(-half_m), Vec3::Constant(half_m));
  for (const double friction : { 0.0, 0.4 })
  {
    for (const TriangleMesh& mesh : { box, makeIcosphere(2, half_m) })
    {
      const Wrench felt = dragged(mesh, friction).exact_W;
      EXPECT_GT(felt.force.z(), 5.0);
      EXPECT_NEAR(-felt.force.y(), friction * felt.force.z(), 1e-6 * felt.force.z()) << mesh.triangles.size();
    }
  }
}

/// How deep a box gets into the block that comes at half a metre a second, turned and turning [m].
double deepest_m(double turns_rad_per_s, double rate_Hz)
{
  MeshTouch touch(boxOverBlock(0.0), firmHold(rate_Hz));
  const Vec3 from = overBlock + Vec3(0, 0, 0.05), axis = Vec3(1, 2, 0.5).normalized();
  double deepest_m = 0.0;
  for (int i = 0; i < 250; ++i)
  {
    const int ahead =
      std::min(i, 110); // the hand stops 5 mm below: with more, the spring turns the box about its corner
    const Quat turn(Eigen::AngleAxisd(0.4 + 1e-3 * turns_rad_per_s * ahead, axis));
    const Pose& at = touch.to(Pose{ from - Vec3(0, 0, 5e-4 * ahead), turn }).pose_W[0];
    for (int corner = 0; corner < 8; ++corner)
    {
      const Vec3 out((corner & 1) != 0 ? 1.0 : -1.0, (corner & 2) != 0 ? 1.0 : -1.0, (corner & 4) != 0 ? 1.0 : -1.0);
      deepest_m = std::max(deepest_m, -gap_m - (at * Vec3(half_m * out)).z());
    }
  }
  return deepest_m;
}

TEST(StandingMesh, LetsNoMeshThroughThatComesAtHalfAMetreASecond)
{
  for (const double rate_Hz : { 100.0, 30.0, 15.0 })
  {
    EXPECT_LE(deepest_m(0.0, rate_Hz), 0.0) << rate_Hz;
    EXPECT_LE(deepest_m(10.0, rate_Hz), 0.0) << rate_Hz;
  }
}

} // namespace
} // namespace palpate::test
