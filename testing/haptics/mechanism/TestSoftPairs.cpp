// SPDX-License-Identifier: GPL-3.0-or-later
// Two soft bodies that are pressed together: their compliance in series, the balance of their forces, friction, and a
// bar on a bed against a solve of both with all contacts at once.
#include <cmath>

#include <gtest/gtest.h>

#include "SoftPairs.h"

namespace palpate::test
{
namespace
{

constexpr double high_m = 0.04, soft_Pa = 20e3, pressed_N = 3.2;

/// Two blocks that are fixed at their outer sides. The upper one bears an even load on its lower side, which is at
/// z = 0 as the upper side of the other one is.
struct BlocksCase
{
  int cells = 0;      ///< along x and y
  double ratio = 1.0; ///< of Young's moduli, lower to upper
};

std::vector<SoftBodyInput> blocksOf(const BlocksCase& c, double poisson)
{
  const std::array<int, 3> cells{ c.cells, c.cells, c.cells / 2 };
  std::vector<SoftBodyInput> blocks{ pairBody({ cells, 0.0, high_m, soft_Pa, high_m }, poisson),
    pairBody({ cells, -high_m, 0.0, c.ratio * soft_Pa, -high_m }, poisson) };
  blocks.front().load_N = evenLoad_N(blocks.front().mesh, 0.0, Vec3(0.0, 0.0, -pressed_N));
  return blocks;
}

class SoftPairs : public testing::TestWithParam<BlocksCase>
{
};

TEST_P(SoftPairs, UnderAnEvenPressureYieldAsTwoColumnsInSeries)
{
  // At Poisson's ratio 0 a column yields by p h / E, fixed ends or not. The load on the lower side of the upper column
  // brings that down by p h / E1, the contact pushes both back: F (h / E1 + h / E2) = P h / E1.
  PairAlone pair(blocksOf(GetParam(), 0.0));
  const MechanismResult& r = pair.rest(12);
  const double expected_N = pressed_N / (1.0 + 1.0 / GetParam().ratio);
  EXPECT_NEAR(-sumOn(r, 1).z(), expected_N, 0.002 * expected_N);
  EXPECT_GE(r.found, 12);
  EXPECT_FALSE(r.capped);
}

TEST_P(SoftPairs, ThatWidenBearAsMuchAsAllTheirNodesInContactSay)
{
  const std::vector<SoftBodyInput> blocks = blocksOf(GetParam(), 0.4);
  PairAlone pair(blocks);
  const MechanismResult& r = pair.rest(20);
  const auto meets = [](const Vec3& p) { return p.z() == 0.0; };
  WholeBar upper(blocks[0], meets);
  upper.standOn(WholeBar(blocks[1], meets));
  upper.load(blocks[0].load_N);
  const double expected_N = upper.borne_N(0.0);
  EXPECT_NEAR(-sumOn(r, 1).z(), expected_N, 0.01 * expected_N);
}

TEST_P(SoftPairs, ArePressedByEqualAndOppositeForcesInTheTickAndAtTheLowRate)
{
  PairAlone pair(blocksOf(GetParam(), 0.4), 0.2);
  const MechanismResult& r = pair.rest(12);
  EXPECT_GT(sumOn(r, 0).norm(), 1.0);
  EXPECT_LE((sumOn(r, 0) + sumOn(r, 1)).norm(), 1e-12);
  Vec3 atLowRate_N = Vec3::Zero();
  for (const auto& body : pair.bodies().newest())
  {
    for (const Vec3& force_N : body->snapshot->force_N)
    {
      atLowRate_N += force_N;
    }
  }
  EXPECT_LE(atLowRate_N.norm(), 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Each, SoftPairs,
  testing::Values(BlocksCase{ 8, 1.0 }, BlocksCase{ 8, 10.0 }, BlocksCase{ 12, 1.0 }, BlocksCase{ 12, 10.0 }),
  [](const testing::TestParamInfo<BlocksCase>& info) {
    return std::to_string(info.param.cells) + "Cells" + std::to_string(static_cast<int>(info.param.ratio)) + "Times";
  });

const Vec3 aboveBar(0.08, 0.02, barSize.z() + 0.015);
constexpr double step_m = 1e-4;

/// Cells through the bar, rate of its snapshots [Hz]; 0: at rest in each tick.
struct BedCase
{
  int through = 0;
  double rate_Hz = 0.0;
};

class BarOnBed : public testing::TestWithParam<BedCase>
{
};

TEST_P(BarOnBed, MeetsItWhereTheGapClosesAndBearsWhatAWholeSolveOfBothSays)
{
  const auto [through, rate_Hz] = GetParam();
  MeshTouch touch(onBarAndBed(through), firmHold(rate_Hz));
  const SoftBodyInput lower = bed(through);
  WholeBar whole(bar({ 5 * through, 2 * through, through }));
  whole.standOn(WholeBar(lower, [](const Vec3& p)
    { return p.z() > -gap_m - 1e-9 && p.x() < barSize.x() + 1e-9 && p.y() > -1e-9 && p.y() < barSize.y() + 1e-9; }));
  // The mean gap of a part closes after that of its nearest vertex, and a step brings the free end further than the
  // hand.
  constexpr double closes_m = 1e-4;
  bool met = false;
  double before_m = gap_m, worst_N = 0.0, most_N = 0.0;
  for (int i = 0; i <= 45; ++i)
  {
    const MechanismResult& r = touch.to(Vec3(aboveBar - Vec3(0, 0, step_m * i)), 1e-3, rate_Hz > 0.0 ? 100 : 1);
    whole.press(pressesFrom(r, 0), touch.body().snapshot->free_W);
    const double borne_N = -sumOn(r, 1).z(), expected_N = whole.borne_N();
    if (borne_N > 0.0 && !met)
    {
      EXPECT_GE(before_m, -closes_m);
      EXPECT_LE(before_m, closes_m + 1.3 * step_m);
      met = true;
    }
    before_m = whole.leastGap_m();
    most_N = std::max(most_N, expected_N);
    worst_N = std::max(worst_N, std::abs(borne_N - expected_N));
    EXPECT_FALSE(r.ahead) << i;
  }
  EXPECT_TRUE(met);
  EXPECT_GT(most_N, 3.0);
  // The tool's force is spread over a patch here and acts on a vertex there, as on the bar above a rigid block.
  EXPECT_LE(worst_N, 0.02 * barSize.z() / through / 0.005 * most_N);
}

INSTANTIATE_TEST_SUITE_P(Each, BarOnBed, testing::Values(BedCase{ 2, 0.0 }, BedCase{ 4, 0.0 }, BedCase{ 4, 30.0 }));

TEST(BarOnBed, IsHeldByFrictionWithinItsConeAndSlipsAtItsEdge)
{
  constexpr double friction = 0.3;
  const MechanismInputs inputs = onBarAndBed(2, friction);
  MeshTouch touch(inputs);
  double mostOut_N = 0.0;
  int slips = 0;
  for (int i = 0; i < 1500; ++i)
  {
    const double t = 1e-3 * i;
    const Vec3 aside(0.0, 0.01 * std::max(0.0, t - 0.5), 0.0);
    const MechanismResult& r = touch.to(Vec3(aboveBar - Vec3(0, 0, 8e-3 * std::min(t, 0.5)) + aside));
    const FoundContacts& found = touch.touch().bodies().found();
    for (int l = 0; l < r.found; ++l)
    {
      const ConstraintNow& now = r.laws[static_cast<std::size_t>(l)];
      const FoundContact& contact = found.contacts[static_cast<std::size_t>(l)];
      if (contact.body == 2)
      {
        const double push_N = now.force_W.dot(contact.normal_B);
        const double rub_N = (now.force_W - push_N * contact.normal_B).norm();
        mostOut_N = std::max(mostOut_N, r.capped ? 0.0 : rub_N - friction * push_N);
        slips += now.phase == ConstraintPhase::Slips ? 1 : 0;
      }
    }
    EXPECT_LE((sumOn(r, 0) + sumOn(r, 1) + r.exact_W.force).norm(), 1e-12) << "of all forces, the hand's with them";
  }
  EXPECT_LE(mostOut_N, 1e-9);
  EXPECT_GT(slips, 100);
}

TEST(BarOnBed, InOneAnotherAreRefusedByTheirNamesAndNotNamedOnceTheyArePressed)
{
  MechanismInputs inputs = onBarAndBed(2);
  const auto refusal = [&inputs](double up_m)
  {
    SoftBodyInput lifted = bed(2);
    for (Vec3& p : lifted.mesh.vertices_W)
    {
      p.z() += up_m;
    }
    inputs.soft[1].input = std::make_shared<const SoftBodyInput>(lifted);
    std::string said;
    (void)MechanismTouch::make(inputs, firmHold(), said);
    return said;
  };
  EXPECT_EQ(refusal(gap_m), "") << "bodies may touch";
  EXPECT_EQ(refusal(gap_m + 1e-3), "bar and bed lie in one another: move one of them.");
  MeshTouch touch(onBarAndBed(2), firmHold());
  EXPECT_TRUE(std::ranges::none_of(
    touch.touch().check().remarks, [](const std::string& remark) { return remark.find("bed") != std::string::npos; }));
  EXPECT_GT(sumOn(touch.to(Vec3(aboveBar - Vec3(0, 0, 4e-3)), 1e-3, 300), 1).norm(), 0.1);
  EXPECT_TRUE(touch.touch().overlaps().empty());
}

TEST(BarOnBed, GivesAHandNoMoreThanItStored)
{
  // A hand of .1 kg on a spring and a damper goes down, along and up, twice, at 30 answers a second.
  const double mass_kg = 0.1, damping_N_s_per_m = 3.0, arm_N_per_m = 300.0, dt_s = 1e-3;
  MechanismHold hold = firmHold();
  hold.stiffness_N_per_m = 1000.0;
  MeshTouch touch(onBarAndBed(2, 0.3), hold);
  Vec3 at = aboveBar, speed = Vec3::Zero();
  double given_J = 0.0, least_J = 0.0, most_N = 0.0;
  for (int i = 0; i < 8000; ++i)
  {
    const double t = 1e-3 * i, turn = 0.5 * (1.0 - std::cos(2.0 * M_PI * t / 4.0));
    const Vec3 wanted = aboveBar + Vec3(0.002 * std::sin(3.0 * t), 0.004 * std::sin(5.0 * t), -0.012 * turn);
    const Vec3 force_N = touch.to(at).wrench_W.force;
    speed += dt_s / mass_kg * (force_N + arm_N_per_m * (wanted - at) - damping_N_s_per_m * speed);
    at += dt_s * speed;
    given_J -= dt_s * force_N.dot(speed); // by the hand to the bodies
    least_J = std::min(least_J, given_J);
    most_N = std::max(most_N, force_N.norm());
  }
  EXPECT_GT(most_N, 0.5);
  EXPECT_GE(least_J, -5e-3);
}

constexpr double plateThick_m = 0.016, ball_m = 0.012;

/// A plate that two of its sides hold, above a block whose vertices are not below those of the plate. Once a ball
/// presses the plate, the finder sees the block before the ball, too.
MechanismInputs onPlateAndBlock(bool plateFirst)
{
  constexpr double apart_m = 0.002, wide_m = 0.06, deep_m = 0.03, low_m = -apart_m - deep_m;
  SoftBodyInput plate = pairBody({ { 10, 10, 2 }, 0.0, plateThick_m, 20e3 }, 0.4);
  plate.fixed = fixedWhere(plate.mesh, [](const Vec3& p) { return std::abs(p.x()) > 0.5 * pairWide_m - 1e-9; });
  SoftBodyInput block = pairBody({ { 8, 8, 4 }, low_m, -apart_m, 10e3, low_m }, 0.4);
  for (Vec3& p : block.mesh.vertices_W)
  {
    p.head<2>() *= wide_m / pairWide_m;
  }
  std::vector<MechanismSoftInput> bodies{ { "plate", std::make_shared<const SoftBodyInput>(plate) },
    { "block", std::make_shared<const SoftBodyInput>(block) } };
  if (!plateFirst)
  {
    std::ranges::reverse(bodies);
  }
  return ballOn(bodies, ball_m);
}

TEST(SoftPairsBelowATool, BearTheSameInEitherOrderOfTheTwo)
{
  // In the mean of the time that the hand stays: parts differ with the order, and forces with them by no more than they
  // are wrong in the tests above on such edges.
  constexpr double right = 0.023;
  constexpr int down = 800, stays = 800;
  MechanismHold hold = firmHold();
  hold.stiffness_N_per_m = 1000.0;
  std::array<double, 2> felt_N{}, borne_N{};
  for (const std::size_t order : { 0u, 1u })
  {
    MeshTouch touch(onPlateAndBlock(order == 0), hold);
    for (int i = 0; i < down + stays; ++i)
    {
      const double deep_m = 0.012 * std::min(1.0, static_cast<double>(i) / down);
      const MechanismResult& r = touch.to(Vec3(0.0, 0.0, plateThick_m + ball_m - deep_m));
      felt_N[order] += i < down ? 0.0 : r.exact_W.force.z() / stays;
      borne_N[order] -= i < down ? 0.0 : sumOn(r, order == 0 ? 1 : 0).z() / stays;
    }
  }
  EXPECT_GT(borne_N[0], 0.5 * felt_N[0]);
  EXPECT_NEAR(felt_N[1], felt_N[0], right * felt_N[0]);
  EXPECT_NEAR(borne_N[1], borne_N[0], right * felt_N[0]);
}

/// The surface of a body, as the finder has it.
std::shared_ptr<const SidedSurface> surfaceOf(const PressedBody& body)
{
  return makeSided(body.scene->surfaces()[body.touch.surface].tree);
}

TEST(NearPlaces, OfTwoSoftBodiesAreJudgedWithoutTheForcesBetweenThem)
{
  // Without the contact the load brings the upper block down by P h / (E A), and nothing presses the lower one.
  PairAlone pair(blocksOf({ 8, 1.0 }, 0.0));
  const MechanismResult r = pair.rest(6);
  const PressedBody &upper = *pair.bodies().newest()[0], &lower = *pair.bodies().newest()[1];
  const auto mesh = surfaceOf(upper), other = surfaceOf(lower);
  const std::span presses(r.presses.data(), static_cast<std::size_t>(r.pressCount));
  PairView view{ *mesh, {}, *other, &lower, 0, 1, 1, 1e-3, presses };
  view.softMesh = &upper;
  view.other_i = 2;
  const double deep_m = pressed_N * high_m / (soft_Pa * pairWide_m * pairWide_m);
  const std::vector<NearPlace> near = nearPlaces(view);
  ASSERT_GT(near.size(), 50u);
  for (const NearPlace& place : near)
  {
    EXPECT_NEAR(place.free_u, -deep_m, 1e-3 * deep_m); // along normals of faces that the forces bend
    EXPECT_GT(place.gap_u, -0.3 * deep_m) << "with the forces they hardly overlap";
  }
  const FoundContacts& found = pair.bodies().found();
  for (int i = 0; i < found.count; ++i)
  {
    const FoundContact& contact = found.contacts[static_cast<std::size_t>(i)];
    EXPECT_EQ(contact.point_A, upper.snapshot->free_W[contact.place_A.vertices[0]]);
    EXPECT_EQ(contact.place_B.x_W, lower.snapshot->free_W[contact.place_B.vertices[0]]);
  }
}

TEST(NearPlaces, BetweenTwoSoftBodiesHaveTheirGapAndBothTheirPlaces)
{
  constexpr double apart_m = 1e-3;
  std::vector<SoftBodyInput> blocks = blocksOf({ 6, 1.0 }, 0.0);
  for (Vec3& p : blocks.front().mesh.vertices_W)
  {
    p += Vec3(3e-3, 2e-3, apart_m);
  }
  blocks.front().load_N.clear();
  PairAlone pair(blocks);
  const PressedBody &upper = *pair.bodies().first()[0], &lower = *pair.bodies().first()[1];
  const auto mesh = surfaceOf(upper), other = surfaceOf(lower);
  PairView view{ *mesh, {}, *other, &lower, 0, 1, 1, 2.0 * apart_m, {} };
  view.softMesh = &upper;
  view.other_i = 2;
  const std::vector<NearPlace> near = nearPlaces(view);
  ASSERT_GT(near.size(), 50u) << "vertices of both";
  double area_m2 = 0.0;
  for (const NearPlace& place : near)
  {
    const FoundContact& contact = place.contact;
    Vec3 a = Vec3::Zero(), b = Vec3::Zero();
    for (std::size_t c = 0; c < 3; ++c)
    {
      const auto k = static_cast<Eigen::Index>(c);
      a += contact.place_A.weights[k] * upper.snapshot->free_W[contact.place_A.vertices[c]];
      b += contact.place_B.weights[k] * lower.snapshot->free_W[contact.place_B.vertices[c]];
    }
    EXPECT_LE((a - contact.point_A).norm(), 1e-12);
    EXPECT_LE((b - contact.place_B.x_W).norm(), 1e-12);
    EXPECT_NEAR(contact.normal_B.dot(a - b), place.gap_u, 1e-12);
    EXPECT_NEAR(place.gap_u, apart_m, 1e-9);
    area_m2 += place.area_u2;
  }
  // Of each surface half of the part that is over the other one, by whole vertices: a row of edges more or less.
  const double edge_m = pairWide_m / 6.0, wide_m2 = pairWide_m * pairWide_m;
  EXPECT_LE(area_m2, wide_m2);
  EXPECT_GE(area_m2, (pairWide_m - edge_m) * (pairWide_m - edge_m));
}

} // namespace
} // namespace palpate::test
