// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>

#include <gtest/gtest.h>

#include "haptics/arm/ArmMeasures.h"
#include "haptics/arm/file/ArmFile.h"
#include "haptics/arm/shown/ArmSkeleton.h"
#include "haptics/core/PoseMath.h"
#include "testing/oracles/arm/ArmOracle.h"
#include "testing/support/AllocationGuard.h"
#include "testing/support/Arms.h"
#include "testing/support/LongForm.h"

namespace palpate
{
namespace
{

/// Of each arm, the long form's 2,000.
std::size_t postures()
{
  return test::isLongForm() ? 2000 : 200;
}

JointVector randomWay(const Arm& arm, test::Random& random)
{
  JointVector way(arm.joints());
  for (int k = 0; k < arm.joints(); ++k)
  {
    way[k] = k < arm.motors() ? random.uniform(-1, 1) : 0.0;
  }
  return way;
}

/// Calls visit(arm, q, random) for random postures of each arm.
template<class Visit>
void forEachPosture(std::uint64_t seed, const std::vector<ArmPlan>& arms, std::size_t count, const Visit& visit)
{
  for (const ArmPlan& plan : arms)
  {
    ASSERT_EQ(refuse(plan), "") << plan.name;
    SCOPED_TRACE(plan.name);
    const Arm arm(plan);
    test::Random random(test::testSeed(seed));
    for (std::size_t i = 0; i < test::testCount(count) && !testing::Test::HasFailure(); ++i)
    {
      visit(arm, test::randomJoints(arm, random), random);
    }
  }
}

TEST(Arm, BringsTheTipWhereTheConstraintsOfItsLinksPutIt)
{
  forEachPosture(871, test::allArms(), postures(),
    [](const Arm& arm, const JointVector& q, test::Random&)
    {
      const Vec3 p = arm.forward(q)->p;
      const Vec3 near_D = arm.carrier(q).tip.p;
      const Vec3 true_D = test::tipInQuad(arm.plan(), q.cast<test::Quad>(), near_D).cast<double>();
      EXPECT_LE((p - true_D).norm(), 1e-12 * true_D.norm());
    });
}

TEST(Arm, ReachesAgainWhereItWas)
{
  forEachPosture(872, test::allArms(), postures(),
    [](const Arm& arm, const JointVector& q, test::Random&)
    {
      const Pose tip = *arm.forward(q);
      const std::optional<JointVector> back = arm.joints() == 6 || arm.plan().wrist.count > 0
                                                ? arm.inverse(tip, q + JointVector::Constant(arm.joints(), 0.05))
                                                : arm.inverse(tip.p);
      ASSERT_TRUE(back) << q.transpose();
      EXPECT_TRUE(arm.withinLimits(*back));
      const Pose again = *arm.forward(*back);
      EXPECT_LE((again.p - tip.p).norm(), 1e-12 * tip.p.norm());
      EXPECT_LE(again.q.angularDistance(tip.q), 1e-11);
    });
}

TEST(Arm, HasTheJacobianOfDifferencesAndDoesTheWorkOfItsTorques)
{
  forEachPosture(873, test::allArms(), postures(),
    [](const Arm& arm, const JointVector& q, test::Random& random)
    {
      const Posture posture = arm.posture(q);
      const JointVector way = randomWay(arm, random);
      const Vec3 slope = test::tipSlope(arm.plan(), q, way, arm.carrier(q).tip.p);
      EXPECT_LE((posture.jacobian.topRows<3>() * way - slope).norm(), 1e-8 * slope.norm());
      const Vec3 force = random.inCube(5.0);
      const double work = force.dot(slope), given = arm.torqueOf(q, { force, Vec3::Zero() }).dot(way);
      EXPECT_LE(std::fabs(work - given), 1e-12 * force.norm() * slope.norm());
    });
}

TEST(Arm, TurnsTheTipAsItsJacobianSays)
{
  const Arm arm(test::sixJoints());
  test::Random random(test::testSeed(874));
  for (std::size_t i = 0; i < test::testCount(200); ++i)
  {
    const JointVector q = test::randomJoints(arm, random), way = randomWay(arm, random);
    constexpr double h = 1e-5;
    const Quat turn = arm.forward(q + h * way)->q * arm.forward(q - h * way)->q.conjugate();
    const Vec3 rate = 2.0 / (2.0 * h) * std::copysign(1.0, turn.w()) * turn.vec();
    EXPECT_LE((arm.jacobian(q).bottomRows<3>() * way - rate).norm(), 1e-8);
    const Vec3 torque = random.inCube(1.0);
    EXPECT_NEAR(arm.torqueOf(q, { Vec3::Zero(), torque }).dot(way), torque.dot(rate), 1e-8);
  }
}

/// The turn of the last link, column by column: where the tip would be a unit further along its axes.
Mat3 turnInQuad(const ArmPlan& plan, const JointVector& q, const Vec3& near_D)
{
  const test::QuadPoint tip = test::tipInQuad(plan, q.cast<test::Quad>(), near_D);
  Mat3 turn;
  for (int axis = 0; axis < 3; ++axis)
  {
    ArmPlan further = plan;
    further.wrist.tip.p[axis] += 1.0;
    turn.col(axis) = (test::tipInQuad(further, q.cast<test::Quad>(), near_D) - tip).cast<double>();
  }
  return turn;
}

/// The same for arms with wrists alone.
template<class Visit>
void forEachWrist(std::uint64_t seed, const Visit& visit)
{
  constexpr std::size_t count = 200;
  forEachPosture(seed, test::armsWithWrists(), count, visit);
}

TEST(Arm, TurnsTheTipOfAWristAsTheDirectionsOfItsLinksSay)
{
  forEachWrist(879,
    [](const Arm& arm, const JointVector& q, test::Random&)
    {
      const Mat3 true_D = turnInQuad(arm.plan(), q, arm.carrier(q).tip.p);
      EXPECT_LE((arm.forward(q)->q.toRotationMatrix() - true_D).norm(), 1e-13);
    });
}

TEST(Arm, MovesAndTurnsTheTipOfAWristByEveryJointAsDifferencesSay)
{
  forEachWrist(880,
    [](const Arm& arm, const JointVector& q, test::Random& random)
    {
      JointVector way(arm.joints());
      for (int k = 0; k < arm.joints(); ++k)
      {
        way[k] = random.uniform(-1, 1);
      }
      const Posture posture = arm.posture(q);
      const Vec3 near_D = arm.carrier(q).tip.p;
      const Vec3 slope = test::tipSlope(arm.plan(), q, way, near_D), spin = posture.jacobian.bottomRows<3>() * way;
      EXPECT_LE((posture.jacobian.topRows<3>() * way - slope).norm(), 1e-8 * slope.norm());
      for (int axis = 0; axis < 3; ++axis)
      {
        // A point a unit from the tip moves with it, and about it.
        ArmPlan further = arm.plan();
        further.wrist.tip.p[axis] += 1.0;
        const Vec3 arm_D = posture.tip.q * Vec3::Unit(axis);
        EXPECT_LE((test::tipSlope(further, q, way, near_D) - slope - spin.cross(arm_D)).norm(), 1e-12);
      }
    });
}

TEST(Arm, OfAWristThroughOnePointReachesAPoseFromAnywhereAndNoneThatItsLimitsExclude)
{
  const Arm arm(knownArm("delta-wrist").value);
  test::Random random(test::testSeed(886));
  for (std::size_t i = 0; i < test::testCount(300); ++i)
  {
    const JointVector q = test::randomJoints(arm, random), from = test::randomJoints(arm, random);
    const Pose tip = *arm.forward(q);
    const std::optional<JointVector> back = arm.inverse(tip, from);
    ASSERT_TRUE(back);
    EXPECT_LE((arm.forward(*back)->p - tip.p).norm(), 1e-12 * tip.p.norm());
    EXPECT_LE(arm.forward(*back)->q.angularDistance(tip.q), 1e-11);
  }
  const Vec3 centre_D = arm.plan().workSpace.centre_D;
  const JointVector middle = *arm.inverse(centre_D);
  // Half a turn about z is reached by none of these hinges: the one about z ends at 120 degrees, and with the one about
  // x at +-180 degrees that about y would stand at 180 degrees, beyond its 70.
  EXPECT_FALSE(arm.inverse(Pose{ centre_D, Quat(0, 0, 0, 1) }, middle));
  EXPECT_TRUE(arm.inverse(Pose{ centre_D, Quat(0.51, 0, 0, std::sqrt(1.0 - 0.51 * 0.51)) }, middle)) << "118.7 degrees";
  EXPECT_FALSE(arm.inverse(Pose{ Vec3(0, 0, 0.5), Quat::Identity() }, middle)) << "out of reach";
}

TEST(Arm, WithAWristReachesAPlaceThatIsOffItsPlaneToo)
{
  forEachWrist(888,
    [](const Arm& arm, const JointVector& q, test::Random&)
    {
      const Vec3 p_D = arm.forward(q)->p;
      JointVector from = q;
      from.array() += 0.05;
      const std::optional<JointVector> back = arm.inverse(p_D, from);
      ASSERT_TRUE(back) << q.transpose();
      EXPECT_TRUE(arm.withinLimits(*back));
      EXPECT_LE((arm.forward(*back)->p - p_D).norm(), 1e-12 * p_D.norm());
    });
}

TEST(Arm, WithoutAWristHasTheSamePostureAsWithOneThatStandsStillAtItsTip)
{
  for (const ArmPlan& with : test::armsWithWrists())
  {
    SCOPED_TRACE(with.name);
    ArmPlan without = with;
    without.wrist = {};
    without.masses.clear();
    const Arm arm(with), base(without);
    test::Random random(test::testSeed(885));
    for (std::size_t i = 0; i < test::testCount(100); ++i)
    {
      const JointVector q = test::randomJoints(arm, random);
      const Posture carrier = arm.carrier(q), alone = base.posture(q.head(base.joints()));
      EXPECT_EQ(carrier.tip.p, alone.tip.p);
      EXPECT_EQ(carrier.jacobian.topRows<3>(), alone.jacobian.topRows<3>());
      EXPECT_EQ(alone.tip.q.coeffs(), without.base_D.q.coeffs()) << "an arm without a wrist senses no rotation";
      EXPECT_TRUE(alone.jacobian.bottomRows<3>().isZero(0.0));
    }
  }
}

TEST(Arm, GivesNoNumberThatIsNotFiniteWhereverItsJointsAre)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const ArmPlan& plan : test::allArms())
  {
    SCOPED_TRACE(plan.name);
    const Arm arm(plan);
    test::Random random(test::testSeed(875));
    for (std::size_t i = 0; i < test::testCount(20000); ++i)
    {
      JointVector q(arm.joints());
      for (int k = 0; k < arm.joints(); ++k)
      {
        // Right angles too, where arms are stretched, folded or level.
        q[k] = random.below(2) == 0 ? random.uniform(-10, 10) : 0.5 * M_PI * (static_cast<int>(random.below(9)) - 4);
      }
      if (i % 10 == 0)
      {
        q[random.below(static_cast<std::uint32_t>(arm.joints()))] = i % 20 == 0 ? nan : 1.0 / 0.0;
      }
      const Posture posture = arm.posture(q);
      ASSERT_TRUE(posture.tip.p.allFinite() && posture.jacobian.allFinite()) << q.transpose();
      ASSERT_TRUE(arm.torqueOf(q, { Vec3(1, 2, 3), Vec3(3, 2, 1) }).allFinite());
      const double fade = arm.forceFade(q, posture);
      ASSERT_TRUE(fade >= 0.0 && fade <= 1.0) << fade;
      ASSERT_TRUE(i % 10 != 0 || !posture.exists);
    }
    for (int i = 0; i < 300; ++i)
    {
      const std::optional<JointVector> q = arm.inverse(Vec3(random.inCube(1.0)));
      ASSERT_TRUE(!q || q->allFinite());
    }
    EXPECT_FALSE(arm.inverse(Vec3(nan, 0, 0)));
    EXPECT_FALSE(arm.inverse(Vec3(9.0, 0.0, 0.0))) << "out of reach";
  }
}

TEST(Arm, ReadsItsCountsAsItShowsThem)
{
  for (const ArmPlan& plan : test::allArms())
  {
    SCOPED_TRACE(plan.name);
    const Arm arm(plan);
    test::Random random(test::testSeed(876));
    for (int i = 0; i < 200 && plan.joints[0].countsPerTurn > 0.0; ++i)
    {
      JointCounts counts{};
      for (int k = 0; k < arm.joints(); ++k)
      {
        counts[static_cast<std::size_t>(k)] = static_cast<std::int32_t>(random.below(8000)) - 4000;
      }
      // From the middle of a step, so that rounding decides nothing.
      JointVector turns(arm.joints());
      for (int k = 0; k < arm.joints(); ++k)
      {
        turns[k] = 2.0 * M_PI * (counts[static_cast<std::size_t>(k)] + 0.5) /
                   plan.joints[static_cast<std::size_t>(k)].countsPerTurn;
      }
      const JointVector q = arm.jointsOfEncoders(turns);
      EXPECT_EQ(arm.countsOf(q), counts);
      EXPECT_LE((arm.shown(q) - arm.jointsOf(counts)).norm(), 1e-15);
    }
  }
}

TEST(Arm, MovesAJointWithTheOneThatItFollows)
{
  // A forearm that keeps its direction while the upper arm turns (a parallel rod): joint 2 = own encoder - encoder 1.
  ArmPlan plan = test::twoLinks();
  plan.joints[0].gear = 10.0;
  plan.joints[1].gear = -8.0;
  plan.joints[1].follows = 0;
  plan.joints[1].followShare = -1.0;
  const Arm arm(plan);
  JointVector turns = JointVector::Zero(2);
  turns << 3.0, -4.0;
  const JointVector q = arm.jointsOfEncoders(turns);
  EXPECT_NEAR(q[0], 0.3, 1e-15);
  EXPECT_NEAR(q[1], 0.5 - 0.3, 1e-15);
  // Work is the same at the joints and at the motors.
  JointVector torque = JointVector::Constant(2, 0.7);
  torque[1] = -0.2;
  const JointVector motors = arm.motorTorqueOf(torque);
  EXPECT_NEAR(motors[0] * turns[0] + motors[1] * turns[1], torque[0] * q[0] + torque[1] * q[1], 1e-15);
}

TEST(Arm, LetsItsForceFadeBeforeAnEndAndBeforeASingularity)
{
  ArmPlan plan = test::twoLinks();
  plan.joints[0].low_rad = 0.0;
  plan.joints[0].high_rad = 2.0;
  plan.maxCondition = 5.0;
  const Arm arm(plan);
  const auto fadeAt = [&arm](double first, double elbow)
  {
    JointVector q(2);
    q << first, elbow;
    return arm.forceFade(q, arm.posture(q));
  };
  EXPECT_EQ(fadeAt(1.0, 1.5), 1.0);
  EXPECT_NEAR(fadeAt(0.05, 1.5), 0.5, 1e-12) << "the last 5 % of 2 rad";
  EXPECT_NEAR(fadeAt(1.975, 1.5), 0.25, 1e-12);
  EXPECT_EQ(fadeAt(2.1, 1.5), 0.0) << "beyond the end";
  // A stretched elbow is a singularity: no force from a condition of 5 on, all of it up to 4.75, half between them.
  const auto conditionAt = [](double e)
  {
    // Singular values of two equal links l: s1 s2 = l^2 |sin e|, s1^2 + s2^2 = l^2 (3 + 2 cos e).
    const double sum = 3.0 + 2.0 * std::cos(e), root = std::sqrt(sum * sum - 4.0 * std::pow(std::sin(e), 2));
    return std::sqrt((sum + root) / (sum - root));
  };
  const auto elbowOf = [&conditionAt](double condition)
  {
    double low = 1e-3, high = 1.5;
    for (int i = 0; i < 60; ++i)
    {
      (conditionAt(0.5 * (low + high)) > condition ? low : high) = 0.5 * (low + high);
    }
    return low;
  };
  EXPECT_EQ(fadeAt(1.0, elbowOf(4.7)), 1.0);
  EXPECT_NEAR(fadeAt(1.0, elbowOf(4.875)), 0.5, 1e-9);
  EXPECT_EQ(fadeAt(1.0, elbowOf(5.01)), 0.0);
  EXPECT_EQ(fadeAt(1.0, 0.0), 0.0);
}

TEST(ArmSkeleton, EndsAtTheTipWithTheLineOfItsWrist)
{
  for (const ArmPlan& plan : test::armsWithWrists())
  {
    SCOPED_TRACE(plan.name);
    const Arm arm(plan);
    ArmPlan base = plan;
    base.wrist = {};
    base.masses.clear();
    test::Random random(test::testSeed(887));
    const JointVector q = test::randomJoints(arm, random);
    std::vector<std::vector<Vec3>> lines = skeletonOf(arm, q);
    const std::vector<Vec3> wrist = lines.back();
    lines.pop_back();
    EXPECT_EQ(lines, skeletonOf(Arm(base), q.head(jointCountOf(plan.geometry))));
    ASSERT_EQ(wrist.size(), static_cast<std::size_t>(plan.wrist.count) + 2);
    EXPECT_EQ(wrist.front(), arm.carrier(q).tip.p);
    EXPECT_LE((wrist.back() - arm.forward(q)->p).norm(), 1e-15);
    EXPECT_NEAR((wrist.back() - wrist[wrist.size() - 2]).norm(), plan.wrist.tip.p.norm(), 1e-15);
  }
}

TEST(ArmSkeleton, HasLinksThatKeepTheirLengthsInEveryPosture)
{
  for (const ArmPlan& plan : test::allArms())
  {
    SCOPED_TRACE(plan.name);
    const Arm arm(plan);
    test::Random random(test::testSeed(878));
    std::vector<double> lengths;
    for (int i = 0; i < 100; ++i)
    {
      const JointVector q = test::randomJoints(arm, random);
      std::vector<double> found;
      for (const std::vector<Vec3>& line : skeletonOf(arm, q))
      {
        for (std::size_t k = 1; k < line.size(); ++k)
        {
          found.push_back((line[k] - line[k - 1]).norm());
        }
      }
      ASSERT_FALSE(found.empty());
      lengths = i == 0 ? found : lengths;
      // With hinges apart a forearm in the picture is the straight line between its ends, up to a tenth shorter.
      const auto* const delta = std::get_if<DeltaGeometry>(&plan.geometry);
      const double slack = delta != nullptr && delta->hinge_m > 0.0 ? 0.1 : 1e-12;
      for (std::size_t k = 0; k < found.size(); ++k)
      {
        ASSERT_NEAR(found[k], lengths[k], slack * lengths[k] + 1e-12) << k;
      }
    }
  }
}

TEST(Arm, AllocatesNothingInATick)
{
  for (const ArmPlan& plan : test::allArms())
  {
    const Arm arm(plan);
    test::Random random(test::testSeed(877));
    const JointVector q = test::randomJoints(arm, random);
    test::AllocationGuard guard;
    const Posture posture = arm.posture(arm.shown(q));
    const JointVector held = JointVector::Zero(arm.joints());
    const JointVector motors = arm.motorTorqueOf(arm.givenTorqueOf(q, { Vec3(1, 2, 3), Vec3::Zero() }, held));
    const std::optional<JointVector> back = arm.inverse(posture.tip.p, q);
    EXPECT_EQ(guard.allocations(), 0u) << plan.name << motors.size() << back.has_value();
  }
}

} // namespace
} // namespace palpate
