// SPDX-License-Identifier: GPL-3.0-or-later
// Row 75: wires that bend far, by closed forms and elliptic integrals.
#include <cmath>
#include <cstring>
#include <numbers>

#include <gtest/gtest.h>

#include "haptics/core/PoseMath.h"
#include "haptics/tool/motion/Turn.h"
#include "testing/oracles/elastica/Elastica.h"
#include "testing/oracles/elastica/SpatialRod.h"
#include "testing/support/AllocationGuard.h"
#include "testing/support/WireScenes.h"

namespace palpate::test
{
namespace
{

TEST(Elastica, HasTheNumbersOfTheTables)
{
  // Load; across, shorter, degrees: by collocation to 1e-10.
  for (const auto& [load, across, shorter, degrees] :
    { std::array{ 1.0, 0.301721, 0.056433, 26.4335 }, std::array{ 2.0, 0.493457, 0.160642, 44.7910 },
      std::array{ 5.0, 0.713792, 0.387628, 69.6355 }, std::array{ 10.0, 0.810609, 0.554996, 81.9493 } })
  {
    const CantileverTip tip = cantileverTip(load);
    EXPECT_NEAR(tip.across, across, 6e-7);
    EXPECT_NEAR(tip.shorter, shorter, 6e-7);
    EXPECT_NEAR(tip.angle_rad * 180.0 / std::numbers::pi, degrees, 6e-5);
  }
  EXPECT_NEAR(columnForce(1e-9), 1.0, 1e-6);
  EXPECT_NEAR(0.18168 * columnForce(0.04), 0.1854, 5e-5);
}

TEST(WireStatics, ACantileverOf20BeamsIsTheElasticaTo5e4AndMoreBeamsAreNearer)
{
  for (const double load : { 1.0, 2.0, 5.0, 10.0 })
  {
    const CantileverTip truth = cantileverTip(load);
    double before = 1.0;
    for (const int beams : { 5, 10, 20, 40 })
    {
      WireRig rig = cantilever(beams, load);
      ASSERT_TRUE(rig.settle()) << load << " on " << beams;
      const double off = std::abs(rig.tip_W().y() - truth.across);
      // Of second order: a quarter of the error with twice the beams.
      EXPECT_LE(off, 0.3 * before) << load << " on " << beams;
      before = off;
      if (beams == 20)
      {
        EXPECT_LE(off, 5e-4) << load;
        EXPECT_NEAR(1.0 - rig.tip_W().x(), truth.shorter, 5e-4);
      }
    }
  }
}

TEST(WireStatics, AMomentRollsItUpToACircleAndHalfOfItToAHalfCircle)
{
  for (const int beams : { 8, 20, 64 })
  {
    EXPECT_LE(rolledUp(beams, 1.0).tip_W().norm(), 5e-4) << beams;
    // The nodes are on a polygon whose beams turn by equal angles: it is as wide as half of it is long.
    const double corner = 0.5 * std::numbers::pi / beams;
    const double width = 1.0 / beams / std::sin(corner);
    EXPECT_LE((rolledUp(beams, 0.5).tip_W() - width * Vec3(0.0, 1.0, 0.0)).norm(), 1e-6) << beams;
  }
  EXPECT_LE((rolledUp(64, 0.5).tip_W() - Vec3(0.0, 2.0 / std::numbers::pi, 0.0)).norm(), 5e-4);
}

TEST(WireStatics, APinnedColumnBucklesAtEulersForceAndBearsThatOfTheElastica)
{
  PinnedColumn column(20);
  EXPECT_NEAR(PinnedColumn::euler_N(), 0.18168, 5e-6);
  EXPECT_NEAR(column.buckles_N(), PinnedColumn::euler_N(), 0.005 * PinnedColumn::euler_N());
  const double truth = PinnedColumn::euler_N() * columnForce(0.04);
  EXPECT_NEAR(column.bent_N(0.04), truth, 0.005 * truth);
}

TEST(WireStatics, TheBendOfBatheAndBolourchiIsWhereCosseratsEquationsHaveItAndWhereItWasPublished)
{
  const BeamSection section = BathesBend::section();
  SpatialRod rod;
  rod.length = BathesBend::radius * BathesBend::angle_rad;
  rod.curvature = 1.0 / BathesBend::radius;
  rod.stretch = { section.stretch_N, section.shear_N, section.shear_N };
  rod.bend = { section.twist_Nu2, section.bend_Nu2, section.bend_Nu2 };
  const Vec3 truth = rod.tip(BathesBend::force * Vec3::UnitZ());
  double before = 1.0;
  for (const int beams : { 8, 16, 32 })
  {
    const double off = (BathesBend::tip(beams) - truth).norm();
    EXPECT_LE(off, 0.3 * before) << beams; // of second order
    before = off;
  }
  const Vec3 tip = BathesBend::tip(8);
  const Vec3 bathe(47.2, 15.9, 53.4), simo(47.23, 15.79, 53.37); // of eight elements each
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_NEAR(tip[i], simo[i], 0.01 * simo[i]);
    EXPECT_NEAR(tip[i], bathe[i], i == 1 ? 0.012 * bathe[i] : 0.01 * bathe[i]); // the truth is 1.35 % off there
  }
  EXPECT_NEAR(truth.y() / bathe.y(), 0.9865, 1e-4);
}

TEST(WireStatics, AHelicalSpringIsAsStiffAsItsTorsionSays)
{
  // Nodes are on the coil and beams cut its arcs: with f half the angle between nodes, the mean square of their
  // distance from the axis is smaller by 2 f^2 / 3, and they are shorter by f^2 / 6.
  for (const int beams : { 32, 64 })
  {
    const double half = 2.0 * std::numbers::pi / beams;
    EXPECT_NEAR(springOverTextbook(beams, 2), 1.0 + 5.0 / 6.0 * half * half, 0.003) << beams;
  }
  EXPECT_NEAR(springOverTextbook(64, 2), 1.0, 0.02);
}

TEST(WireStatics, TorqueThatGoesInComesOutOfAStraightAndABentTube)
{
  constexpr int beams = 20;
  for (const bool straight : { true, false })
  {
    WireRig rig(straightPoints(beams, 1.0), thinSection());
    if (!straight)
    {
      rig.places_W = placesAlong(arcPoints(beams, 1.0, 1.0)); // a chord is shorter than its arc: .01 % of the length
    }
    rig.loads.held.fill(WireLoads::place);
    rig.loads.held[0] = rig.loads.held[beams] = WireLoads::clamped;
    const Quat end = rig.places_W[beams].q;
    const Vec3 in = rig.places_W[0].q * Vec3::UnitX(), out = end * Vec3::UnitX();
    rig.places_W[0].q = turnBy(in) * rig.places_W[0].q;
    ASSERT_TRUE(rig.settle());
    const double torqueIn = rig.newton->held(0).tail<3>().dot(in),
                 torqueOut = -rig.newton->held(beams).tail<3>().dot(out);
    EXPECT_NEAR(torqueOut, torqueIn, straight ? 1e-9 : 0.005 * torqueIn);
    EXPECT_NEAR(torqueIn, 1.0, straight ? 1e-9 : 0.005); // G J over its length, for a turn of 1
  }
}

TEST(WireStatics, ARigidMotionOfClampAndLoadCarriesTheWholeWire)
{
  const Pose motion{ Vec3(5.0, -3.0, 2.0), turnBy(Vec3(1.0, -2.0, 0.5)) };
  WireRig rig = cantilever(12, 5.0);
  WireRig carried = cantilever(12, 0.0);
  for (int i = 0; i <= 12; ++i)
  {
    carried.places_W[i] = motion * carried.places_W[i];
  }
  carried.loads.force[12].head<3>() = motion.q * Vec3(0.0, 5.0, 0.0);
  ASSERT_TRUE(rig.settle());
  ASSERT_TRUE(carried.settle());
  for (int i = 0; i <= 12; ++i)
  {
    EXPECT_LE((carried.places_W[i].p - motion * rig.places_W[i].p).norm(), 1e-9);
    EXPECT_LE(turnFromTo(motion.q * rig.places_W[i].q, carried.places_W[i].q).norm(), 1e-9);
  }
}

TEST(WireStatics, ABentShaftWithASoftTipBendsAsItsTwoParts)
{
  // A little load: each part bends as a beam of its own. Stiff over the first half, a tenth as stiff over the second.
  BeamSection stiff = thinSection(), soft = stiff;
  soft.bend_Nu2 = 0.1;
  std::vector<BeamSection> sections(10, stiff);
  std::fill(sections.begin() + 5, sections.end(), soft);
  WireRig rig(straightPoints(10, 1.0), stiff);
  rig.wire = makeWire(straightPoints(10, 1.0), sections).value;
  rig.loads.held[0] = WireLoads::clamped;
  const double load = 1e-6;
  rig.loads.force[10][1] = load;
  ASSERT_TRUE(rig.settle());
  // The integral of (1 - x)^2 / (E I).
  EXPECT_NEAR(rig.tip_W().y() / load, (1.0 - 0.125) / 3.0 + 0.125 / 3.0 / 0.1, 1e-6);
}

TEST(WireStatics, ASpringPullsItsNodeAsFarAsBothStiffnessesSay)
{
  WireRig rig = cantilever(10, 0.0);
  const double spring = 2.0, away = 1e-4;
  rig.loads.spring_N_per_u[10] = spring;
  rig.loads.pulledTo_W[10] = Vec3(1.0, away, 0.0);
  ASSERT_TRUE(rig.settle());
  EXPECT_NEAR(rig.tip_W().y() / away, spring / (spring + 3.0), 1e-6); // 3 E I / L^3 against it
}

TEST(WireStatics, NewtonsStepsGetFromStraightToRestUnderTenTimesTheLoadInFewSteps)
{
  WireRig rig = cantilever(20, 10.0);
  const WireRest rest = rig.newton->toRest(rig.wire, rig.loads, 200, 1e-6, rig.places_W);
  EXPECT_TRUE(rest.met);
  EXPECT_LE(rest.steps, 12);
  EXPECT_EQ(rig.newton->toRest(rig.wire, rig.loads, 0, 1e-6, rig.places_W).steps, 0);
}

TEST(WireStatics, AStepIsTakenWholeUpToHalfARadianAndElseInPart)
{
  constexpr int beams = 8;
  for (const double turn : { 0.3, 3.0 })
  {
    WireRig rig(straightPoints(beams, 8.0), thinSection());
    const Quat start = rig.places_W[8].q;
    WireVector motion;
    for (int i = 0; i <= beams; ++i)
    {
      motion[i] << 0.01 * i, 0.2 * turn * i, 0.0, 0.0, 0.0, turn;
    }
    moveWire(rig.wire, motion, rig.places_W);
    const double share = std::min(1.0, 0.5 / turn);
    EXPECT_LE((rig.tip_W() - Vec3(8.0, 0.0, 0.0) - share * motion[8].head<3>()).norm(), 1e-14);
    EXPECT_LE((turnFromTo(start, rig.places_W[8].q) - share * turn * Vec3::UnitZ()).norm(), 1e-14);
  }
  // Of a chord likewise: the second node goes across by twice the beam's length.
  WireRig rig(straightPoints(beams, 8.0), thinSection());
  WireVector motion;
  motion.fill(NodeVector::Zero());
  motion[1][1] = 2.0;
  moveWire(rig.wire, motion, rig.places_W);
  EXPECT_DOUBLE_EQ(rig.places_W[1].p.y(), 0.5);
}

TEST(WireStatics, AStepAllocatesNothingAndIsBoundedAndTheSameRunHasTheSameBits)
{
  WireRig once = cantilever(64, 10.0), again = cantilever(64, 10.0);
  WireRest rest;
  {
    const AllocationGuard guard;
    rest = once.newton->toRest(once.wire, once.loads, 3, 0.0, once.places_W);
    EXPECT_EQ(guard.allocations(), 0u);
    EXPECT_EQ(guard.locks(), 0u);
  }
  EXPECT_EQ(rest.steps, 3);
  EXPECT_FALSE(rest.met);
  (void)again.newton->toRest(again.wire, again.loads, 3, 0.0, again.places_W);
  EXPECT_EQ(std::memcmp(once.places_W.data(), again.places_W.data(), sizeof(WirePlaces)), 0);
}

/// A wire askew to the axis that its end is held along, pushed together far beyond buckling.
TEST(WireStatics, WhereDragIsAddedAMotionThatIsHeldStaysHeld)
{
  constexpr int beams = 20;
  std::vector<Vec3> points;
  for (const Vec3& p : straightPoints(beams, 1.0))
  {
    points.push_back(Eigen::AngleAxisd(0.7, Vec3::UnitZ()) * p);
  }
  WireRig rig(points, thinSection());
  rig.loads.held[0] = WireLoads::clamped;
  rig.loads.held[beams] = 0b000001;
  rig.loads.force[beams].head<3>() = Vec3(1.0, 2.0, 3.0);
  for (Pose& pose : rig.places_W)
  {
    pose.p *= 0.99;
  }
  ASSERT_TRUE(rig.newton->linearise(rig.wire, rig.places_W, rig.loads));
  ASSERT_FALSE(rig.newton->firm());
  WireVector motion;
  rig.newton->step(motion);
  EXPECT_EQ(motion[beams][0], 0.0);
  EXPECT_GT(motion[beams].norm(), 0.0);
}

} // namespace
} // namespace palpate::test
