// SPDX-License-Identifier: GPL-3.0-or-later
// A tool that rubs: a block that is pulled at a slant and one that is spun on its face, by closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "Tools.h"
#include "haptics/tool/servo/ToolForce.h"

namespace palpate::test
{
namespace
{

constexpr double halfOfRubbed_mm = 20.0, pressedBy_mm = 2.0, stiffness_N_per_mm = 1.0;
constexpr double solved = 1e-3; // of what rubs: which of four corners rub changes from turn to turn

/// A cube that lies on a plane of triangles, pressed by the hand above its middle.
class RubbedCube : public testing::TestWithParam<double>
{
protected:
  RubbedCube()
  {
    Random random(testSeed(2301));
    const TriangleMesh plane = makeSheet({ 400.0, 400.0, 8, 8, 0.3 }, random);
    this->move.emplace(this->tool, makeToolScene(cleanMesh(plane).mesh, this->tool), this->tool.gyration_u);
    this->move->rub(this->friction);
    EXPECT_EQ(this->move->place({ Vec3(0, 0, halfOfRubbed_mm + 1.0), Quat::Identity() }), "");
    EXPECT_TRUE(settle(*this->move, this->pressed(0.0, 0.0)));
  }

  [[nodiscard]] Pose pressed(double along_mm, double spin_rad) const
  {
    return { along_mm * this->along + Vec3(0, 0, halfOfRubbed_mm - pressedBy_mm), turnBy(Vec3(0, 0, spin_rad)) };
  }
  /// What the plane pushes with, over the stiffness: it holds the cube at its rest gap.
  [[nodiscard]] double push_mm() const { return pressedBy_mm + this->tool.restGap_u(); }

  double friction = GetParam();
  Vec3 along = Vec3(0.6, 0.8, 0.0);
  ToolMesh tool = makeTool(makeBox(Vec3::Constant(-halfOfRubbed_mm), Vec3::Constant(halfOfRubbed_mm))).tool;
  std::optional<ToolMove> move;
};

} // namespace

TEST_P(RubbedCube, StaysUntilItsPullLeansByTheAngleOfFrictionAndThenTrailsByIt)
{
  const double most_mm = this->friction * this->push_mm(); // tan of the angle times what presses
  ASSERT_TRUE(settle(*this->move, this->pressed(0.999 * most_mm, 0.0)));
  EXPECT_LE(this->move->pose_W().p.head<2>().norm(), 1e-7);
  for (const double pull_mm : { 1.001 * most_mm, 2.0 * most_mm, 7.0 * most_mm })
  {
    ASSERT_TRUE(settle(*this->move, this->pressed(pull_mm, 0.0)));
    EXPECT_LE(
      (this->move->pose_W().p.head<2>() - (pull_mm - most_mm) * this->along.head<2>()).norm(), solved * most_mm);
    EXPECT_LE(rotationVector(this->move->pose_W().q).norm(), 1e-6) << "it neither tips nor turns";
  }
  // Back again it stays until it is pulled the other way.
  const double rests_mm = 6.0 * most_mm;
  ASSERT_TRUE(settle(*this->move, this->pressed(rests_mm - 0.99 * most_mm, 0.0)));
  EXPECT_NEAR(this->move->pose_W().p.dot(this->along), rests_mm, solved * most_mm);
}

TEST_P(RubbedCube, SpunOnItsFaceHoldsUpToTheTorqueOfItsCorners)
{
  // Its corners carry it, each sqrt(2) h from the middle: mu N sqrt(2) h, against L^2 t of the spring that turns.
  const double lever2_mm2 = std::pow(this->tool.gyration_u, 2);
  const double most_rad = this->friction * this->push_mm() * std::numbers::sqrt2 * halfOfRubbed_mm / lever2_mm2;
  ASSERT_LT(2.0 * most_rad, 1.5) << "the lead that is not cut";
  ASSERT_TRUE(settle(*this->move, this->pressed(0.0, 0.99 * most_rad)));
  EXPECT_LE(rotationVector(this->move->pose_W().q).norm(), 1e-8);
  ASSERT_TRUE(settle(*this->move, this->pressed(0.0, 2.0 * most_rad)));
  EXPECT_NEAR(rotationVector(this->move->pose_W().q).z(), most_rad, 1e-6);
}

TEST_P(RubbedCube, InEveryTickIsPulledBackByFrictionTimesWhatPressesItAndNoMore)
{
  const ToolContacts set = this->move->contacts();
  for (const double pull_mm : { 0.2, 0.5, 1.0, 4.0 })
  {
    const ToolPush push =
      toolPush(set, this->pressed(pull_mm, 0.0), stiffness_N_per_mm, ToolCoupling::Constraints, this->friction);
    const double rubs_N = stiffness_N_per_mm * std::min(pull_mm, this->friction * this->push_mm());
    EXPECT_NEAR(push.wrench_W.force.z(), stiffness_N_per_mm * this->push_mm(), 1e-7);
    EXPECT_LE((push.wrench_W.force.head<2>() + rubs_N * this->along.head<2>()).norm(), solved * rubs_N);
  }
}

INSTANTIATE_TEST_SUITE_P(Friction, RubbedCube, testing::Values(0.1, 0.3, 0.6));

} // namespace palpate::test
