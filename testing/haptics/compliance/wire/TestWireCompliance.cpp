// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "haptics/compliance/wire/WireCompliance.h"
#include "haptics/core/Across.h"
#include "testing/haptics/compliance/wire/RandomBeams.h"
#include "testing/support/AllocationGuard.h"
#include "testing/support/Linear.h"
#include "testing/support/WireCapstan.h"
#include "testing/support/WireScenes.h"

namespace palpate::test
{
namespace
{

Eigen::MatrixXd denseOf(const WireMatrix& matrix)
{
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(6 * matrix.nodes, 6 * matrix.nodes);
  for (int i = 0; i < matrix.nodes; ++i)
  {
    dense.block<6, 6>(6 * i, 6 * i) = matrix.own[i];
    if (i + 1 < matrix.nodes)
    {
      dense.block<6, 6>(6 * i, 6 * i + 6) = matrix.after[i];
      dense.block<6, 6>(6 * i + 6, 6 * i) = matrix.after[i].transpose();
    }
  }
  return dense;
}

/// Bent in space under forces at its end, clamped at its first node.
WireRig bentWire(int beams)
{
  WireRig rig(arcPoints(beams, 0.5, 1.5), roundSection(0.02, 1e6, 0.3));
  rig.loads.held[0] = WireLoads::clamped;
  rig.loads.force[beams].head<3>() = Vec3(0.02, -0.05, 0.04);
  rig.settle();
  return rig;
}

std::vector<WireTouch> touchesAt(const std::vector<std::pair<int, double>>& places)
{
  Random random(testSeed(7));
  std::vector<WireTouch> touches;
  for (const auto& [beam, share] : places)
  {
    const Vec3 normal = random.direction();
    const auto [first, second] = tangentsOf(normal);
    touches.push_back({ beam, share, -0.02 * normal, (Mat3() << normal, first, second).finished() });
  }
  return touches;
}

/// The rows of a touch over all nodes: forces along its axes to forces and moments.
Eigen::MatrixXd rowsOf(const WireTouch& touch, int nodes)
{
  Eigen::MatrixXd rows(6 * nodes, 3);
  for (int axis = 0; axis < 3; ++axis)
  {
    WireVector forces;
    forces.fill(NodeVector::Zero());
    pressAt(touch, Vec3::Unit(axis), forces);
    for (int i = 0; i < nodes; ++i)
    {
      rows.block<6, 1>(6 * i, axis) = forces[i];
    }
  }
  return rows;
}

TEST(WireFactor, SolvesWhatADenseFactorSolves)
{
  WireRig rig = bentWire(20);
  const Eigen::MatrixXd dense = denseOf(rig.newton->stiffness());
  Random random(testSeed(5));
  WireVector b;
  Eigen::VectorXd right(dense.rows());
  for (int i = 0; i < rig.wire.nodes(); ++i)
  {
    b[i] << random.inCube(1.0), random.inCube(0.1);
    right.segment<6>(6 * i) = b[i];
  }
  const Eigen::VectorXd truth = solved(dense, right);
  rig.newton->factor().solve(b);
  for (int i = 0; i < rig.wire.nodes(); ++i)
  {
    EXPECT_LE((b[i] - truth.segment<6>(6 * i)).norm(), 1e-9 * truth.norm()) << i;
  }
}

TEST(WireFactor, RefusesWhatIsNotPositiveDefinite)
{
  WireRig rig = bentWire(4);
  WireMatrix matrix = rig.newton->stiffness();
  WireFactor factor;
  EXPECT_TRUE(factor.factor(matrix));
  matrix.own[2] -= 2.0 * NodeBlock(matrix.own[2].diagonal().asDiagonal());
  EXPECT_FALSE(factor.factor(matrix));
}

TEST(WireCompliance, BetweenTouchesIsThatOfTheDenseInverse)
{
  for (const auto& places :
    { std::vector<std::pair<int, double>>{ { 0, 0.3 } }, { { 0, 0.0 }, { 0, 1.0 }, { 3, 0.5 }, { 4, 0.2 }, { 4, 0.9 },
                                                           { 12, 0.0 }, { 13, 1.0 }, { 19, 0.4 }, { 19, 1.0 } } })
  {
    WireRig rig = bentWire(20);
    const std::vector<WireTouch> touches = touchesAt(places);
    const int rows = 3 * static_cast<int>(touches.size());
    Eigen::MatrixXd all(6 * rig.wire.nodes(), rows);
    for (std::size_t t = 0; t < touches.size(); ++t)
    {
      all.middleCols<3>(3 * static_cast<int>(t)) = rowsOf(touches[t], rig.wire.nodes());
    }
    const Eigen::MatrixXd truth = all.transpose() * solved(denseOf(rig.newton->stiffness()), all);
    const auto w = std::make_unique<ContactProblem::Square>(ContactProblem::Square::Zero(rows, rows));
    {
      const AllocationGuard guard;
      rig.newton->factor().invert();
      addWireCompliance(rig.newton->factor(), touches, *w);
      EXPECT_EQ(guard.allocations(), 0u);
    }
    EXPECT_LE((*w - truth).cwiseAbs().maxCoeff(), 1e-9 * truth.cwiseAbs().maxCoeff());
    // Numbers that are there already stay: those of a vessel.
    addWireCompliance(rig.newton->factor(), touches, *w);
    EXPECT_LE((*w - 2.0 * truth).cwiseAbs().maxCoeff(), 2e-9 * truth.cwiseAbs().maxCoeff());
  }
}

TEST(WireCompliance, ATouchPressesTheNodesWithItsForceAndMomentAndMovesByTheSameShares)
{
  WireRig rig = bentWire(6);
  const WireTouch touch = touchesAt({ { 2, 0.3 } }).front();
  WireVector forces;
  forces.fill(NodeVector::Zero());
  const Vec3 force(1.0, -2.0, 0.5);
  pressAt(touch, force, forces);
  const Vec3 force_W = touch.axes_W * force;
  Vec3 sum = Vec3::Zero(), moment = Vec3::Zero();
  Random random(testSeed(6));
  WireVector motion;
  double power = 0.0;
  for (int i = 0; i < rig.wire.nodes(); ++i)
  {
    sum += forces[i].head<3>();
    moment += rig.places_W[i].p.cross(forces[i].head<3>()) + forces[i].tail<3>();
    motion[i] << random.inCube(1.0), random.inCube(1.0);
    power += forces[i].dot(motion[i]);
  }
  const Vec3 place_W = 0.7 * rig.places_W[2].p + 0.3 * rig.places_W[3].p + touch.arm_W;
  EXPECT_LE((sum - force_W).norm(), 1e-15);
  EXPECT_LE((moment - place_W.cross(force_W)).norm(), 1e-15);
  EXPECT_NEAR(motionAt(touch, motion).dot(force), power, 1e-14);
}

TEST(WireCompliance, ALimpWireRoundADrumPullsByTheRatioOfItsBends)
{
  for (const auto& [friction, bends] : { std::pair{ 0.2, 12 }, std::pair{ 0.2, 3 }, std::pair{ 0.5, 6 } })
  {
    const double half = 0.5 * std::numbers::pi / bends;
    // Each bend's two tensions and its normal and friction force balance.
    const double truth = std::pow((1.0 + friction * std::tan(half)) / (1.0 - friction * std::tan(half)), bends);
    EXPECT_NEAR(capstanRatio(friction, bends), truth, 1e-6 * truth) << friction << ", " << bends;
  }
  EXPECT_NEAR(capstanRatio(0.2, 12), 1.8815, 5e-5);
}

} // namespace
} // namespace palpate::test
