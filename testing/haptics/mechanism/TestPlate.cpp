// SPDX-License-Identifier: GPL-3.0-or-later
// A rigid plate on four soft patches, pressed by a rod off its middle, against a solve of each set of patches that may
// bear it.
#include <bitset>
#include <optional>

#include <gtest/gtest.h>

#include "haptics/tool/motion/Turn.h"
#include "testing/support/Linear.h"
#include "testing/support/MechanismRig.h"
#include "testing/support/Random.h"

namespace palpate::test
{
namespace
{

constexpr double lengthOverPlate = 0.2, halfPlate = 0.05, thickPlate = 0.005;
/// Beyond it a tick goes in parts, each with arms of its own: no closed form of small turns has that.
constexpr double smallTurn_rad = 0.5;

/// The input of a plate.
struct PressedPlate
{
  std::array<Vec3, 4> feet;
  std::array<double, 4> springs{};
  double weight = 0.0;
  Vec3 pressed = Vec3::Zero();
  double depth = 0.0;
};

/// Forces of the feet and of the rod.
using PlateForces = Eigen::Matrix<double, 5, 1>;

struct BornePlate
{
  PlateForces forces;
  double turn_rad = 0.0;
};

/// The plate goes by (z, turn about x, turn about y), borne by those feet of the set alone, its last the rod; none
/// where that does not agree with itself.
std::optional<BornePlate> borneBy(const PressedPlate& c, const std::bitset<5>& bears)
{
  Eigen::Matrix<double, 5, 3> rows;
  PlateForces springs, free = PlateForces::Zero();
  for (Eigen::Index i = 0; i < 5; ++i)
  {
    const bool rod = i == 4;
    const Vec3& at = rod ? c.pressed : c.feet[static_cast<std::size_t>(i)];
    rows.row(i) = (rod ? -1.0 : 1.0) * Vec3(1.0, at.y(), -at.x()).transpose();
    springs[i] = !bears[static_cast<std::size_t>(i)] ? 0.0 : rod ? kc : c.springs[static_cast<std::size_t>(i)];
  }
  free[4] = -c.depth;
  const Mat3 stiffness = rows.transpose() * springs.asDiagonal() * rows;
  const Vec3 load = Vec3(-c.weight, 0.0, 0.0) - rows.transpose() * springs.cwiseProduct(free);
  const std::optional<Eigen::VectorXd> solution = test::solvedUniquely(stiffness, load);
  if (!solution)
  {
    return std::nullopt;
  }
  const Vec3 way = *solution;
  const PlateForces gaps = free + rows * way;
  for (Eigen::Index i = 0; i < 5; ++i)
  {
    if (bears[static_cast<std::size_t>(i)] ? gaps[i] > 0.0 : gaps[i] < 0.0)
    {
      return std::nullopt;
    }
  }
  return BornePlate{ -springs.cwiseProduct(gaps), way.tail<2>().norm() };
}

/// The one that agrees with itself among all sets.
std::optional<BornePlate> borne(const PressedPlate& c)
{
  for (unsigned long set = 0; set < 32; ++set)
  {
    if (const auto found = borneBy(c, std::bitset<5>(set)))
    {
      return found;
    }
  }
  return std::nullopt;
}

/// The tick on the same plate: how many of its feet are open.
int judgePlate(const PressedPlate& c, const PlateForces& expected)
{
  MechanismRig rig(lengthOverPlate);
  MechanismBody plate;
  plate.name = "plate";
  plate.kind = MechanismBodyKind::Rigid;
  plate.halfSize_u = Vec3(halfPlate, halfPlate, thickPlate);
  plate.load_W = Vec3(0.0, 0.0, -c.weight);
  rig.mechanism.bodies.push_back(plate);
  for (std::size_t foot = 0; foot < 4; ++foot)
  {
    const std::string name = "patch " + std::to_string(foot);
    rig.addSoft(name, springWall(name, c.feet[foot], Vec3::UnitZ(), 0.01, 1.0 / c.springs[foot]));
    MechanismConstraint& law = rig.join(ConstraintKind::Contact, name, c.feet[foot], c.feet[foot]);
    law.a = "plate";
    law.axis_B = Vec3::UnitZ();
  }
  rig.join(ConstraintKind::Contact, "plate", Vec3(0.0, 0.0, lengthOverPlate), c.pressed).axis_B = Vec3::UnitZ();
  // The rod stands upside down over the plate.
  const MechanismResult& r =
    rig.step(Pose{ c.pressed + Vec3(0.0, 0.0, lengthOverPlate - c.depth), Quat(0.0, 1.0, 0.0, 0.0) });
  EXPECT_FALSE(r.capped);
  EXPECT_LE(r.residual_u, 1e-15);
  const Pose& at = r.pose_W[2];
  const double size = expected.cwiseAbs().maxCoeff();
  Vec3 balance(-c.weight - r.exact_W.force.z(), 0.0, 0.0);
  balance.tail<2>() = -r.exact_W.force.z() * Vec3(c.pressed.y(), -c.pressed.x(), 0.0).head<2>() / halfPlate;
  int open = 0;
  for (std::size_t foot = 0; foot < 4; ++foot)
  {
    const double force = r.laws[foot].force_W.z();
    const double gap = (at.p + rotationVector(at.q).cross(c.feet[foot])).z();
    EXPECT_NEAR(force, expected[static_cast<Eigen::Index>(foot)], 1e-12 * size) << foot;
    balance += force * Vec3(1.0, c.feet[foot].y() / halfPlate, -c.feet[foot].x() / halfPlate);
    if (expected[static_cast<Eigen::Index>(foot)] == 0.0)
    {
      ++open;
      EXPECT_EQ(force, 0.0) << foot;
      EXPECT_GE(gap, 0.0) << foot;
      EXPECT_EQ(r.laws[foot].phase, ConstraintPhase::Open);
    }
  }
  EXPECT_LE(balance.lpNorm<Eigen::Infinity>(), 1e-12 * size);
  EXPECT_NEAR(r.exact_W.force.z(), expected[4], 1e-12 * size);
  return open;
}

PressedPlate plateOn(double feetAt)
{
  PressedPlate c;
  for (int foot = 0; foot < 4; ++foot)
  {
    c.feet[static_cast<std::size_t>(foot)] =
      Vec3(foot & 1 ? feetAt : -feetAt, foot & 2 ? feetAt : -feetAt, -thickPlate);
  }
  c.springs.fill(400.0);
  return c;
}

TEST(Plate, PressedBeyondItsFeetOpensTwoCornersExactlyAndTheOtherTwoBearAll)
{
  PressedPlate c = plateOn(0.04);
  c.weight = 0.2;
  c.pressed = Vec3(0.045, 0.01, thickPlate);
  c.depth = 6e-3;
  const auto expected = borne(c);
  ASSERT_TRUE(expected);
  // About the line of the two feet: weight .04 = push .005.
  const double push = c.weight * 0.04 / 0.005;
  ASSERT_NEAR(expected->forces[4], push, 1e-12);
  ASSERT_NEAR(expected->forces[1] - expected->forces[3], -push * 0.01 / 0.04, 1e-12);
  EXPECT_EQ(judgePlate(c, expected->forces), 2);
}

TEST(Plate, PressedAnywhereOpensTheCornersThatTheSetSaysThatBearsIt)
{
  Random random(testSeed(2010));
  std::array<int, 4> seen{};
  std::size_t turnedOver = 0;
  for (std::size_t trial = 0; trial < testCount(200); ++trial)
  {
    PressedPlate c = plateOn(random.uniform(0.02, 0.05));
    for (double& spring : c.springs)
    {
      spring = random.uniform(100.0, 1000.0);
    }
    c.weight = random.uniform(0.05, 1.0);
    c.depth = random.uniform(1e-4, 8e-3);
    c.pressed = Vec3(random.uniform(-halfPlate, halfPlate), random.uniform(-halfPlate, halfPlate), thickPlate);
    const auto expected = borne(c);
    ASSERT_TRUE(expected) << trial;
    if (expected->turn_rad > smallTurn_rad)
    {
      ++turnedOver;
      continue;
    }
    ++seen[static_cast<std::size_t>(judgePlate(c, expected->forces))];
  }
  EXPECT_LT(10 * turnedOver, testCount(200));
  EXPECT_GT(seen[0], 0);
  EXPECT_GT(seen[1], 0);
  EXPECT_GT(seen[2], 0);
}

} // namespace
} // namespace palpate::test
