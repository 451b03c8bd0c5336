// SPDX-License-Identifier: GPL-3.0-or-later
// Curves in space: touched as tubes round their lines. Lengths in metres unless a test scales them.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "haptics/geometry/scene/SceneBuilder.h"
#include "testing/support/Curves.h"
#include "testing/support/Meshes.h"
#include "testing/support/Probe.h"
#include "testing/support/Stage.h"

namespace palpate::test
{
namespace
{

constexpr double tube_m = 2e-3;

/// Parameter: the ball's radius; 0 is a point.
class Curves : public testing::TestWithParam<double>
{
protected:
  [[nodiscard]] double ball() const { return GetParam(); }
  /// Of the ball that touches curves, the thinnest of which has this radius.
  [[nodiscard]] double centre(double thinnest_m = tube_m) const { return std::max(this->ball(), 1e-3 * thinnest_m); }
};

TEST_P(Curves, AStraightTubeIsACylinder)
{
  const double R = tube_m + this->centre();
  Probe probe(sceneOf({ tubeThrough({ { -0.05, 0, 0 }, { 0.01, 0, 0 }, { 0.05, 0, 0 } }, tube_m) }), this->ball(),
    { -0.04, 0, 1.5 * R });
  for (int i = 0; i <= 2000; ++i)
  {
    const double angle_rad = 4 * std::numbers::pi * i / 2000, depth = 0.9 * R * i / 2000;
    const Vec3 out(0, std::sin(angle_rad), std::cos(angle_rad));
    const Vec3 along(-0.04 + 0.08 * i / 2000, 0, 0);
    const ContactResult result = probe.to(along + (R - depth) * out);
    ASSERT_LE((probe.x_W() - along - R * out).norm(), 1e-12) << i;
    ASSERT_FALSE(result.capped) << i;
  }
}

TEST_P(Curves, TheEndOfATubeIsHalfABall)
{
  const double R = tube_m + this->centre();
  const Vec3 end(0.05, 0, 0);
  Probe probe(sceneOf({ tubeThrough({ { -0.05, 0, 0 }, end }, tube_m) }), this->ball(), end + 1.5 * R * Vec3::UnitX());
  for (int i = 0; i <= 1000; ++i)
  {
    const double polar = 1.5 * i / 1000, around = 12.0 * i / 1000; // from the axis to just short of the cylinder
    const Vec3 out(std::cos(polar), std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around));
    probe.to(end + 0.3 * R * out);
    ASSERT_LE((probe.x_W() - end - R * out).norm(), 1e-12) << i;
  }
}

TEST_P(Curves, AJointIsABallFromOutsideAndTwoCylindersFromInside)
{
  const double R = tube_m + this->centre();
  const std::vector<Tubes> bend{ tubeThrough({ { -0.05, 0, 0 }, { 0, 0, 0 }, { 0, 0.05, 0 } }, tube_m) };
  Probe outside(sceneOf(bend), this->ball(), { 2 * R, -2 * R, 0 });
  for (int i = 1; i < 200; ++i)
  {
    const double angle_rad = -0.25 * std::numbers::pi + (i % 2 ? 1 : -1) * 0.0012 * std::numbers::pi * i;
    const Vec3 out(std::cos(angle_rad), std::sin(angle_rad), 0);
    outside.along(0.5 * R * out, 20);
    ASSERT_LE((outside.x_W() - R * out).norm(), 1e-12) << i;
  }
  Probe inside(sceneOf(bend), this->ball(), { -2 * R, 2 * R, 0 });
  for (int i = 0; i <= 100; ++i)
  {
    const double a = R * (0.1 + 0.008 * i), b = R * (0.9 - 0.008 * i);
    const ContactResult result = inside.to({ -a, b, 0 });
    ASSERT_LE((inside.x_W() - R * Vec3(-1, 1, 0)).norm(), 1e-12) << i;
    ASSERT_EQ(result.contacts, 2) << i;
  }
}

TEST_P(Curves, CrossingFibresHoldTheHandInEachOfTheirCorners)
{
  const double R = tube_m + this->centre();
  const std::vector<Tubes> cross{ tubeThrough({ { -0.05, 0, 0 }, { 0.04, 0, 0 } }, tube_m),
    tubeThrough({ { 0, -0.03, 0 }, { 0, 0.05, 0 } }, tube_m) };
  for (const Vec3& corner : { Vec3(1, 1, 0), Vec3(-1, 1, 0), Vec3(-1, -1, 0), Vec3(1, -1, 0) })
  {
    Probe probe(sceneOf(cross), this->ball(), 2 * R * corner);
    const ContactResult result = probe.along(0.4 * R * corner, 30);
    EXPECT_LE((probe.x_W() - R * corner).norm(), 1e-12) << corner.transpose();
    EXPECT_EQ(result.contacts, 2);
  }
}

TEST_P(Curves, ACurveOnAPlateHoldsTheHandBetweenTubeAndPlate)
{
  const double r = this->centre(), R = tube_m + r;
  Random random(testSeed(41));
  const TriangleMesh plate = makeSheet({ 0.1, 0.1, 7, 7, 0.3 }, random);
  const double y = std::sqrt(R * R - r * r); // the centre is r above the plate and R from the line
  for (const double side : { 1.0, -1.0 })
  {
    Probe probe(sceneOf({ tubeThrough({ { -0.05, 0, 0 }, { 0.05, 0, 0 } }, tube_m) }, plate), this->ball(),
      { -0.03, side * 0.01, 0.01 });
    probe.along({ -0.03, side * 0.01, -0.001 }, 20);
    EXPECT_NEAR(probe.x_W().z(), r, 1e-12);
    for (int i = 0; i <= 200; ++i)
    {
      const double x = -0.03 + 0.0003 * i;
      const ContactResult result = probe.to({ x, side * (0.3 + 0.4 * (i % 3) / 2) * y, -0.0005 });
      ASSERT_LE((probe.x_W() - Vec3(x, side * y, r)).norm(), 1e-9) << i;
      ASSERT_EQ(result.contacts, 2) << i;
    }
  }
}

TEST_P(Curves, AHandAtTenMetresPerSecondNeverPassesAHelix)
{
  const std::vector<Tubes> spring{ helix(0.01, 0.006, 4, 24, 0.3e-3) };
  const double r = this->centre(0.3e-3);
  TubeChecker checker(spring);
  const auto scene = sceneOf(spring);
  ContactPlan plan;
  plan.radius_u = this->ball();
  GodObjectState state;
  TubeHand hand(spring, 0.012, 1e-2, testSeed(42));
  std::size_t pressed = 0;
  for (std::size_t i = 0; i < testCount(20000); ++i)
  {
    const Vec3 p_W = hand.next(), before_W = state.x_W;
    const bool placed = state.placed;
    const ContactResult result = moveGodObject(*scene, plan, p_W, state, &checker);
    if (!placed)
    {
      continue;
    }
    ASSERT_GE(checker.leastClearance(before_W, state.x_W), r - 1e-12) << i;
    if (result.contacts > 0)
    {
      ++pressed;
      ASSERT_NEAR(clearance(spring, state.x_W), r, 1e-9) << i;
    }
    else if (!result.capped)
    {
      ASSERT_EQ(state.x_W, p_W) << i;
    }
  }
  EXPECT_GT(pressed, testCount(20000) / 10);
}

/// A rest is the nearest free place round about: no place `step` away in any direction is free and nearer to the hand.
void expectNearest(
  const std::vector<Tubes>& tubes, double r, const Vec3& x_W, const Vec3& p_W, double step, Random& random)
{
  for (int k = 0; k < 12; ++k)
  {
    const Vec3 y_W = x_W + step * random.direction();
    const bool nearer = (y_W - p_W).norm() < (x_W - p_W).norm() - 1e-3 * step;
    EXPECT_FALSE(nearer && clearance(tubes, y_W) > r + 1e-9) << "from " << x_W.transpose() << " to " << y_W.transpose();
  }
}

TEST_P(Curves, ARandomBundleIsNeverPassedAndEveryRestIsTheNearestFreePlace)
{
  Random random(testSeed(43));
  const std::size_t bundles = testCount(12);
  std::size_t pressed = 0, capped = 0, ticks = 0;
  for (std::size_t bundle = 0; bundle < bundles; ++bundle)
  {
    SCOPED_TRACE(bundle);
    const double half = std::pow(10.0, random.uniform(-3.0, 3.0));
    const double thinnest = random.uniform(0.004, 0.02) * half;
    const std::vector<Tubes> tubes{ wanderingTubes(4, 12, half, thinnest, random),
      wanderingTubes(3, 9, half, random.uniform(1.0, 3.0) * thinnest, random) };
    const double ball = this->ball() * 10 * half, r = std::max(ball, 1e-3 * thinnest);
    TubeChecker checker(tubes);
    const auto scene = sceneOf(tubes);
    ContactPlan plan;
    plan.radius_u = ball;
    GodObjectState state;
    TubeHand hand(tubes, half, 0.5 * half, random.next());
    for (int i = 0; i < 1500; ++i)
    {
      const Vec3 p_W = hand.next(), before_W = state.x_W;
      const bool placed = state.placed;
      const ContactResult result = moveGodObject(*scene, plan, p_W, state, &checker);
      if (!placed)
      {
        continue;
      }
      ++ticks;
      if (result.capped) // only at the axis or beyond it, where no direction is downhill or all are
      {
        ++capped;
        ASSERT_GE((state.x_W - p_W).norm(), 0.5 * (r + thinnest)) << i;
      }
      ASSERT_GE(checker.leastClearance(before_W, state.x_W), r - 1e-12 * half) << i;
      if (result.contacts > 0 && !result.capped)
      {
        ++pressed;
        ASSERT_NEAR(clearance(tubes, state.x_W), r, 1e-9 * half) << i;
        expectNearest(tubes, r, state.x_W, p_W, 1e-5 * half, random);
      }
    }
  }
  EXPECT_GT(pressed, ticks / 10);
  EXPECT_LT(capped, ticks / 2000); // 16 of 18 000 for the ball where a roll never ends at another tube
}

/// Tells two judges of one path.
class Both final : public PathSink
{
public:
  Both(PathSink& one, PathSink& two) : one_(one), two_(two) {}
  void segment(const Vec3& from_W, const Vec3& to_W) noexcept override
  {
    this->one_.segment(from_W, to_W);
    this->two_.segment(from_W, to_W);
  }

private:
  PathSink &one_, &two_;
};

TEST_P(Curves, AmongFibresThroughARoughSheetNeitherIsPassed)
{
  Random random(testSeed(46));
  const double half = 0.02, thick = 0.3e-3, r = this->centre(thick);
  std::size_t capped = 0, pressed = 0, ticks = 0;
  for (std::size_t world = 0; world < testCount(6); ++world)
  {
    SCOPED_TRACE(world);
    TriangleMesh sheet = makeSheet({ 4 * half, 4 * half, 24, 24, 0.3 }, random);
    for (Vec3& v_W : sheet.vertices_W)
    {
      v_W.z() = 1e-3 * random.uniform(-1.0, 1.0);
    }
    const std::vector<Tubes> tubes{ wanderingTubes(5, 12, half, thick, random) };
    PathChecker meshChecker(sheet, r, 1e-12);
    TubeChecker tubeChecker(tubes);
    Both both(meshChecker, tubeChecker);
    const auto scene = sceneOf(tubes, sheet);
    ContactPlan plan;
    plan.radius_u = this->ball();
    GodObjectState state;
    static_cast<void>(moveGodObject(*scene, plan, Vec3(0, 0, 2 * half), state));
    TubeHand hand(tubes, half, 1e-2, random.next());
    for (int i = 0; i < 2000; ++i)
    {
      const Vec3 before_W = state.x_W, p_W = hand.next();
      const ContactResult result = moveGodObject(*scene, plan, p_W, state, &both);
      ++ticks;
      capped += result.capped;
      pressed += result.contacts > 0;
      ASSERT_EQ(meshChecker.finding(before_W), "") << i;
      ASSERT_GE(tubeChecker.leastClearance(before_W, state.x_W), r - 1e-12) << i;
    }
  }
  EXPECT_GT(pressed, ticks / 10);
  EXPECT_LT(capped, ticks / 100);
}

TEST_P(Curves, TheOrderOfPointsAndLinesChangesNoBit)
{
  Random random(testSeed(44));
  const Tubes tubes = wanderingTubes(5, 14, 0.03, 1e-3, random);
  Tubes other = tubes;
  std::vector<std::uint32_t> place(tubes.curves.points_W.size());
  for (std::uint32_t i = 0; i < place.size(); ++i)
  {
    place[i] = i;
  }
  random.shuffle(place);
  for (std::size_t i = 0; i < place.size(); ++i)
  {
    other.curves.points_W[place[i]] = tubes.curves.points_W[i];
  }
  for (auto& line : other.curves.lines)
  {
    std::transform(line.begin(), line.end(), line.begin(), [&place](std::uint32_t i) { return place[i]; });
    std::reverse(line.begin(), line.end());
  }
  random.shuffle(other.curves.lines);
  const Vec3 start_W(0.06, 0.06, 0.06);
  Probe one(sceneOf({ tubes }), this->ball(), start_W), two(sceneOf({ other }), this->ball(), start_W);
  for (int i = 0; i < 60; ++i)
  {
    const Vec3 goal_W = random.inCube(0.03);
    one.along(goal_W, 25);
    two.along(goal_W, 25);
    ASSERT_EQ(one.x_W(), two.x_W()) << i;
  }
}

TEST_P(Curves, TheForceScalesWithTheScene)
{
  Random random(testSeed(45));
  const Tubes tubes = wanderingTubes(5, 14, 0.03, 1e-3, random);
  for (const double factor : { 1e-6, 1e-3, 1e3, 1e6, 0x1p-20, 0x1p20 })
  {
    SCOPED_TRACE(factor);
    Tubes other = tubes;
    std::for_each(other.curves.points_W.begin(), other.curves.points_W.end(), [factor](Vec3& p) { p *= factor; });
    other.radius_u *= factor;
    const Vec3 start_W(0.06, 0.06, 0.06);
    Probe one(sceneOf({ tubes }), this->ball(), start_W);
    Probe two(sceneOf({ other }), factor * this->ball(), factor * start_W);
    for (int i = 0; i < 20; ++i)
    {
      const Vec3 goal_W = random.inCube(0.03);
      one.along(goal_W, 25);
      two.along(factor * goal_W, 25);
      const bool power = factor == 0x1p-20 || factor == 0x1p20;
      ASSERT_LE((two.x_W() / factor - one.x_W()).norm(), power ? 0.0 : 1e-9) << i;
    }
  }
}

TEST_P(Curves, FrictionAlongAFibreSticksAndSlipsByCoulomb)
{
  const double R = tube_m + this->centre(), depth = 0.5e-3, statical = 0.5, kinetic = 0.3;
  Probe probe(sceneOf({ tubeThrough({ { -0.05, 0, 0 }, { 0.05, 0, 0 } }, tube_m) }), this->ball(), { 0, 0, 1.2 * R });
  probe.plan().friction = { statical, kinetic };
  probe.to({ 0, 0, R - depth });
  bool slips = false;
  for (int i = 0; i <= 1000; ++i)
  {
    const double x = 1e-6 * i;
    const ContactResult result = probe.to({ x, 0, R - depth });
    slips = slips || x > statical * depth;
    const double truth = slips ? x - kinetic * depth : 0.0; // breaks away, then trails by the cone's radius
    ASSERT_LE((probe.x_W() - Vec3(truth, 0, R)).norm(), 1e-12) << i;
    ASSERT_EQ(result.friction, slips ? FrictionState::Slips : FrictionState::Sticks) << i;
  }
}

TEST_P(Curves, AFibreThatComesAtTheHandCarriesTheProxyBeforeIt)
{
  const double thin = 0.1e-3, R = thin + this->centre(thin);
  for (const double speed : { 0.01, 0.5, 5.0 })
  {
    const double start = -0.02;
    Stage stage;
    stage.add(sceneOf({ tubeThrough({ { 0, -0.05, 0 }, { 0, 0.05, 0 } }, thin) })->surfaces()[0],
      [&](double t) {
        return Pose{ { start + speed * t, 0, 0 }, Quat::Identity() };
      });
    ContactPlan plan;
    plan.radius_u = this->ball();
    Actor actor(stage, plan, { start + R + 1e-4, 0, 0 });
    const Vec3 p_W = actor.state.x_W - Vec3(0.9 * R + 1e-4, 0, 0); // pressed from the first tick on
    for (int tick = 0; tick * 1e-3 * speed < 0.05; ++tick)
    {
      const double fibre = actor.pose(0).p.x();
      actor.tick(Vec3(std::max(p_W.x(), actor.pose(0).p.x() + 0.1 * R), 0, 0));
      if (tick > 0 && actor.pose(0).p.x() - fibre < 0.9 * R)
      {
        ASSERT_NEAR(actor.state.x_W.x(), actor.pose(0).p.x() + R, 1e-9) << tick << " at " << speed;
      }
      ASSERT_GE(actor.state.x_W.x(), actor.pose(0).p.x()) << tick << " at " << speed; // never passed
    }
  }
}

TEST_P(Curves, AFibreWhosePointsMoveTakesTheHandAlong)
{
  const double R = tube_m + this->centre();
  const auto bent = [](double x) {
    return tubeThrough({ { x, -0.05, 0 }, { x, 0, 0 }, { x + 1e-4, 0.05, 0 } }, tube_m);
  };
  const auto fibreAt = [&bent](double x, SceneBuilder& builder)
  {
    SurfaceInput input;
    input.name = "fibre";
    input.mesh = std::make_shared<const TriangleMesh>(segmentsOf(bent(x).curves));
    input.lineRadius_u = tube_m;
    return builder.build({ input }).scene;
  };
  SceneBuilder builder;
  Probe probe(fibreAt(0, builder), this->ball(), { 1.5 * R, -0.02, 0 });
  probe.to({ 0.5 * R, -0.02, 0 });
  for (int i = 1; i <= 20; ++i)
  {
    const double x = 0.01 * i; // many radii a snapshot
    probe.changeScene(fibreAt(x, builder));
    probe.to({ x + 0.5 * R, -0.02, 0 });
    ASSERT_LE((probe.x_W() - Vec3(x + R, -0.02, 0)).norm(), 1e-9) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(PointAndBall, Curves, testing::Values(0.0, 1e-3));

TEST(CurveInput, ARadiusThatIsNoneIsRefusedWithItsReason)
{
  for (const auto& [radius, reason] : { std::pair(0.0, "its line radius is 0: it must be finite and above 0"),
         std::pair(std::nan(""), "its line radius is nan: it must be finite and above 0"),
         std::pair(-1.0, "its line radius is -1: it must be finite and above 0"),
         std::pair(1e-12, "its line radius of 1e-12 is below the rounding error of coordinates up to 1") })
  {
    SurfaceInput input;
    input.name = "fibre";
    input.mesh =
      std::make_shared<const TriangleMesh>(segmentsOf(tubeThrough({ { 0, 0, 0 }, { 1, 0, 0 } }, 1.0).curves));
    input.lineRadius_u = radius;
    const SceneBuildResult built = SceneBuilder().build({ input });
    EXPECT_EQ(built.scene, nullptr);
    EXPECT_EQ(built.reports.at(0).refusal, reason);
  }
}

TEST(CurveInput, BadPointsRepeatsAndLinesOfOnePointAreDroppedAndCounted)
{
  PolyLines curves;
  curves.points_W = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 3, std::nan(""), 0 }, { 4, 0, 0 } };
  curves.lines = { { 0, 1, 2, 3 }, { 3, 4, 5 }, { 2, 0 }, { 5 }, {} };
  const CleanResult clean = cleanSegments(segmentsOf(curves));
  ASSERT_TRUE(clean.ok());
  // 0-1 and 2-3 are left; 1-2 has no length, 3-4 and 4-5 no place, 2-0 is 0-1 again, the point 5 is no line.
  EXPECT_EQ(clean.report.trianglesIn, 7u);
  EXPECT_EQ(clean.report.trianglesOut, 2u);
  EXPECT_EQ(clean.report.nonFinite, 2u);
  EXPECT_EQ(clean.report.collinear, 2u);
  EXPECT_EQ(clean.report.duplicate, 1u);
  EXPECT_EQ(clean.report.summary(),
    "kept 2 of 7 segments; 2 dropped: non-finite end; 2 dropped: no length; 1 dropped: duplicate");
  curves.lines = { { 5 } };
  EXPECT_EQ(cleanSegments(segmentsOf(curves)).refusal,
    "none of its 1 segments can be touched (all non-finite or without length)");
  curves.lines = { { 0, 6 } };
  EXPECT_NE(cleanSegments(segmentsOf(curves)).refusal.find("names vertex 6"), std::string::npos);
}

} // namespace
} // namespace palpate::test
