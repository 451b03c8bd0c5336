// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "haptics/core/PoseMath.h"
#include "haptics/field/Smoothing.h"
#include "haptics/field/iso/IsoProxy.h"
#include "testing/support/AllocationGuard.h"
#include "testing/support/FieldOracle.h"
#include "testing/support/Fields.h"
#include "testing/support/Random.h"

namespace palpate
{
namespace
{

const Vec3 evenly = Vec3::Ones();

/// A proxy and its hand on one scalar field.
class IsoHand
{
public:
  IsoHand(std::shared_ptr<const FieldBlock> brick, const IsoPlan& plan, const Vec3& spacing_u = evenly)
    : brick_(std::move(brick)), field_(brick_->component(FieldBlockRole::Scalar)), plan_(plan), spacing_u_(spacing_u),
      oracle(field_)
  {
  }

  IsoResult to(const Vec3& index) { return this->move(index, &this->oracle); }
  IsoResult unwatched(const Vec3& index) { return this->move(index, nullptr); }
  [[nodiscard]] Vec3 x() const { return this->state.x.index(); }

private:
  IsoResult move(const Vec3& index, FieldPathSink* sink)
  {
    return moveIsoProxy(this->field_, this->spacing_u_, this->plan_, index, this->state, sink);
  }

  std::shared_ptr<const FieldBlock> brick_;
  FieldBlockComponent field_;
  IsoPlan plan_;
  Vec3 spacing_u_;

public:
  test::FieldOracle oracle;
  IsoState state;
};

IsoPlan at(double level, std::uint32_t passCap = 32)
{
  IsoPlan plan;
  plan.level = level;
  plan.passCap = passCap;
  return plan;
}

Vec3 wholeNumbers(test::Random& random)
{
  return Vec3(1.0 + random.below(63), random.below(64), random.below(64))
    .cwiseProduct(Vec3(random.below(2) ? 1 : -1, random.below(2) ? 1 : -1, 1));
}

TEST(IsoProxy, OnALinearFieldIsTheFootOfTheHandToATrillionthInTheSameTick)
{
  test::Random random(test::testSeed(1610));
  for (std::size_t plane = 0; plane < test::testCount(40); ++plane)
  {
    const Vec3 slope = wholeNumbers(random), n = slope.normalized(), middle(15.5, 15.5, 15.5);
    const Vec3 through = middle + random.inCube(3.0);
    IsoHand hand(test::scalarFieldBlock(32, [&](const Vec3& i) { return slope.dot(i); }), at(slope.dot(through)));
    const double side = random.below(2) ? 1.0 : -1.0;
    hand.to(through + side * 2.0 * n);
    for (int i = 0; i < 50; ++i)
    {
      // The foot within a ball of 9 spacings around the middle: inside of the grid, whatever the plane's direction.
      const Vec3 across = shortestTurn(Vec3::UnitZ(), n) * Vec3(random.uniform(-4, 4), random.uniform(-4, 4), 0);
      const Vec3 foot = through + across, p = foot - side * random.uniform(0.01, 4.0) * n;
      const IsoResult result = hand.to(p);
      EXPECT_LT((hand.x() - foot).norm(), 1e-12);
      EXPECT_LT((result.pull_u - (foot - p)).norm(), 1e-12);
      EXPECT_LT((result.normal - side * n).norm(), 1e-12);
    }
    EXPECT_EQ(hand.oracle.wrongEnds + hand.oracle.crossed, 0U);
  }
}

TEST(IsoProxy, OnAGridOfUnevenSpacingIsTheFootInTheScaledSpace)
{
  test::Random random(test::testSeed(1611));
  const Vec3 h(0.5, 2.0, 1.25);
  for (std::size_t plane = 0; plane < test::testCount(20); ++plane)
  {
    const Vec3 slope = wholeNumbers(random), middle(15.5, 15.5, 15.5); // per cell
    const Vec3 n_u = slope.cwiseQuotient(h).normalized();
    IsoHand hand(test::scalarFieldBlock(32, [&](const Vec3& i) { return slope.dot(i); }), at(slope.dot(middle)), h);
    hand.to(middle + n_u.cwiseQuotient(h));
    const Vec3 p = middle - random.uniform(0.1, 2.0) * n_u.cwiseQuotient(h);
    hand.to(p);
    EXPECT_LT((hand.x() - middle).cwiseProduct(h).norm(), 1e-12);
  }
}

/// The largest distance of proxies from a sphere of radius R whose function is sampled, under hands that jump around
/// inside of it.
double largestRadialError(double radius, bool squared, double level)
{
  const int points = 64;
  const Vec3 centre(31.37, 31.61, 31.13);
  IsoHand hand(test::scalarFieldBlock(points,
                 [&](const Vec3& i)
                 {
                   const double r2 = (i - centre).squaredNorm();
                   return squared ? r2 : std::sqrt(r2);
                 }),
    at(level));
  test::Random random(test::testSeed(1612));
  hand.unwatched(centre + Vec3(radius + 2.0, 0, 0));
  double largest = 0.0;
  for (std::size_t i = 0; i < test::testCount(20000); ++i)
  {
    hand.unwatched(centre + (radius - 1.5) * random.direction());
    EXPECT_TRUE(hand.state.placed);
    largest = std::max(largest, std::fabs((hand.x() - centre).norm() - radius));
  }
  return largest;
}

TEST(IsoProxy, OnASphereOfSampledDistanceErrsByTheSquareOfTheSpacingOverFourRadii)
{
  // Between points along one axis a function errs by t (1 - t) / 2 of its second derivative, at most an eighth. The
  // derivatives of r sum up to 2 / R, and its slope is 1.
  EXPECT_NEAR(largestRadialError(25.0, false, 25.0), 1.0 / (4.0 * 25.0), 0.01 / (4.0 * 25.0));
}

TEST(IsoProxy, OnASphereOfItsSampledSquareErrsByThreeEighthsOfThat)
{
  // The derivatives of r^2 sum up to 6, and its slope is 2 R.
  EXPECT_NEAR(largestRadialError(25.0, true, 625.0), 3.0 / (8.0 * 25.0), 0.01 * 3.0 / (8.0 * 25.0));
}

TEST(IsoProxy, NeverPassesASheetOfAFiftiethOfASpacingUnderJumpsOfSixty)
{
  // The grid holds |z - 32| exactly, since its kink lies on points.
  IsoHand hand(test::scalarFieldBlock(65, [](const Vec3& i) { return std::fabs(i.z() - 32.0); }), at(0.01, 10));
  test::Random random(test::testSeed(1613));
  hand.to({ 32, 32, 40 });
  for (std::size_t i = 0; i < test::testCount(1000); ++i)
  {
    hand.to(Vec3(32, 32, 32) + random.inCube(30.0));
    ASSERT_GE(hand.x().z(), 32.01 - 1e-14);
  }
  EXPECT_EQ(hand.oracle.crossed + hand.oracle.wrongEnds, 0U);
}

/// White noise on a grid, once smoothed or not, with holes or not.
std::shared_ptr<const FieldBlock> noise(test::Random& random, int passes, double holes)
{
  const GridIndex size{ 24, 24, 24 };
  std::vector<float> values = test::sampledValues(size, [&](const Vec3&) { return random.uniform(-1, 1); });
  values = smoothed(values, size, passes);
  for (float& value : values)
  {
    value = random.uniform() < holes ? NAN : value;
  }
  return std::make_shared<const FieldBlock>(
    1, FieldBlockGrid{ size }, std::vector<FieldBlockArray>{ { FieldBlockRole::Scalar, "f", values } });
}

TEST(IsoProxy, IsNeverOnTheWrongSideInNoiseWithHolesInNumbersOf113Bits)
{
  for (int kind = 0; kind < 4; ++kind)
  {
    test::Random random(test::testSeed(1614 + static_cast<std::uint64_t>(kind)));
    IsoHand hand(noise(random, kind % 2, kind / 2 * 0.005), at(0.05, 10));
    Vec3 p(11.5, 11.5, 11.5);
    std::uint64_t touched = 0;
    for (std::size_t i = 0; i < test::testCount(2000); ++i)
    {
      const Vec3 next =
        random.below(50) == 0 ? Vec3(11.5, 11.5, 11.5) + random.inCube(10.0) : Vec3(p + random.inCube(0.2));
      p = next.cwiseMax(0.5).cwiseMin(22.5);
      const IsoResult result = hand.to(p);
      touched += result.contacts > 0;
      ASSERT_TRUE(result.pull_u.allFinite());
      ASSERT_TRUE(!hand.state.placed || hand.oracle.value(hand.state.x, 0.05, hand.state.side) >= 0.0);
    }
    EXPECT_EQ(hand.oracle.crossed, 0U);
    EXPECT_EQ(hand.oracle.wrongEnds, 0U);
    EXPECT_GT(touched, test::testCount(2000) / 5) << "a test of what does not touch shows nothing";
  }
}

TEST(IsoProxy, RestsWhereNoLegalPlaceNearbyIsNearerToTheHand)
{
  // A poll: the proxy, moved by a thousandth of a spacing in many directions and back onto the surface along the
  // segment to the hand, comes no nearer.
  const auto waves = [](const Vec3& i)
  { return std::sin(0.4 * i.x()) + std::sin(0.5 * i.y()) + std::sin(0.45 * i.z() + 0.1 * i.x()); };
  IsoHand hand(test::scalarFieldBlock(32, waves), at(0.2));
  test::Random random(test::testSeed(1620));
  Vec3 p(15, 15, 15);
  std::uint64_t contacts = 0, nearer = 0;
  for (std::size_t i = 0; i < test::testCount(2000); ++i)
  {
    p = (p + random.inCube(0.3)).cwiseMax(2).cwiseMin(29).eval();
    const IsoResult result = hand.unwatched(p);
    if (result.contacts == 0 || result.capped || i % 4 != 0)
    {
      continue;
    }
    ++contacts;
    bool found = false;
    for (int poll = 0; poll < 32; ++poll)
    {
      const GridPlace there = GridPlace::at(hand.x() + 1e-3 * random.direction());
      found = found || (hand.oracle.value(there, 0.2, hand.state.side) >= 0.0 &&
                         (there.index() - p).norm() < result.pull_u.norm() - 1e-5);
    }
    nearer += found;
  }
  EXPECT_GT(contacts, test::testCount(2000) / 20);
  // At ridges that meet a groove the hop fails where a longer one would come nearer: half a hundredth is allowed.
  EXPECT_LE(nearer, 1 + contacts / 200);
}

TEST(IsoProxy, RestsOnASurfaceThatLiesInTheFacesOfCells)
{
  IsoHand hand(test::scalarFieldBlock(16, [](const Vec3& i) { return i.z(); }), at(8.0));
  hand.to({ 7.5, 7.5, 9.0 });
  const IsoResult result = hand.to({ 7.5, 7.25, 7.0 });
  EXPECT_FALSE(result.capped);
  EXPECT_EQ(result.contacts, 1);
  EXPECT_LT((hand.x() - Vec3(7.5, 7.25, 8.0)).norm(), 1e-12);
}

TEST(IsoProxy, GivesNoForceOutsideAndWithoutValuesAndFindsItsSideAgain)
{
  const auto ball = [](const Vec3& i) { return i.x() > 20 ? std::nan("") : (i - Vec3(10, 10, 10)).norm(); };
  IsoHand hand(test::scalarFieldBlock(24, ball), at(5.0));
  for (const Vec3& nowhere : { Vec3(22, 10, 10), Vec3(-1, 10, 10), Vec3(1e200, 0, 0) })
  {
    hand.to(nowhere);
    EXPECT_EQ(hand.to(nowhere).pull_u, Vec3(Vec3::Zero()));
    EXPECT_FALSE(hand.state.placed);
  }
  hand.to({ 17, 10, 10 });
  EXPECT_GT(hand.to({ 13, 10, 10 }).pull_u.x(), 1.9) << "from outside it is held outside";
  EXPECT_TRUE(hand.to({ 17, 10, 10 }).pull_u.isZero());
  EXPECT_TRUE(hand.to({ 22, 10, 10 }).released) << "what is not there is told";
  hand.to({ 10, 10, 10 });
  EXPECT_LT(hand.to({ 17, 10, 10 }).pull_u.x(), -1.9) << "and from inside inside";
}

TEST(IsoProxy, OfAMembraneHoldsItsLimitToRoundingAndThenLetsTheHandThrough)
{
  IsoPlan plan = at(15.5);
  plan.yield_u = 0.7;
  IsoHand hand(test::scalarFieldBlock(32, [](const Vec3& i) { return i.z(); }), plan);
  hand.to({ 15, 15, 18 });
  double p = 16.0;
  for (; 15.5 - p <= plan.yield_u; p -= 0.01)
  {
    EXPECT_NEAR(hand.to({ 15, 15, p }).pull_u.z(), std::max(0.0, 15.5 - p), 1e-12);
  }
  const IsoResult at = hand.to({ 15, 15, p });
  EXPECT_TRUE(at.yielded);
  EXPECT_NEAR(at.pull_u.z(), plan.yield_u, 1e-12) << "the hand trails by what was held";
  EXPECT_EQ(hand.to({ 15, 15, p }).pull_u.z(), 0.0) << "then nothing holds it";
  EXPECT_NEAR(hand.to({ 15, 15, 16.0 }).pull_u.z(), -0.5, 1e-12) << "and it is on the other side";
}

TEST(IsoProxy, UnderFrictionHoldsByTheStaticConeAndTrailsByTheKineticOne)
{
  IsoPlan plan = at(15.25);
  plan.friction = { 0.5, 0.3 };
  IsoHand hand(test::scalarFieldBlock(32, [](const Vec3& i) { return i.z(); }), plan);
  hand.to({ 8, 15, 16.0 });
  const double depth = 2.0;
  hand.to({ 8, 15, 15.25 - depth });
  double before = 0.0;
  for (double away = 0.01; away < 10.0; away += 0.013)
  {
    const IsoResult result = hand.to({ 8 + away, 15, 15.25 - depth });
    EXPECT_NEAR(result.pull_u.z(), depth, 1e-9);
    EXPECT_NEAR(-result.pull_u.x(), away <= 0.5 * depth ? away : 0.3 * depth, 1e-9) << away;
    EXPECT_GE(hand.x().x(), before - 1e-12);
    before = hand.x().x();
  }
  EXPECT_EQ(hand.oracle.crossed + hand.oracle.wrongEnds, 0U);
}

TEST(IsoProxy, UnderFrictionOnlyTakesEnergyOverClosedWays)
{
  IsoPlan plan = at(10.0);
  plan.friction = { 0.4, 0.2 };
  const Vec3 centre(15.3, 15.1, 15.8);
  IsoHand hand(test::scalarFieldBlock(32, [&](const Vec3& i) { return (i - centre).norm(); }), plan);
  Vec3 p = centre + Vec3(11, 0, 0), pull = Vec3::Zero();
  hand.unwatched(p);
  double gain = 0.0;
  for (int i = 0; i <= 4000; ++i)
  {
    const double turn = 2.0 * std::numbers::pi * i / 4000,
                 depth = std::min({ i / 200.0, (4000 - i) / 200.0, 2.0 }) - 1.0;
    const Vec3 next = centre + (10.0 - depth) * Vec3(std::cos(turn), std::sin(turn), 0);
    const Vec3 now = hand.unwatched(next).pull_u;
    gain += 0.5 * (pull + now).dot(next - p);
    pull = now;
    p = next;
  }
  // The kinetic force, 0.2 of a millimetre, along most of the path that the hand makes a millimetre deep.
  EXPECT_LT(gain, -0.8 * 0.2 * 2.0 * std::numbers::pi * 9.0);
  EXPECT_GT(gain, -1.2 * 0.2 * 2.0 * std::numbers::pi * 9.0);
}

TEST(IsoProxy, GivesNoEnergyOverClosedWays)
{
  // A circle under the surface of a ball, entered and left outside: the hand's work under the held force of each tick,
  // by the trapezoid of both its ends, which is exact for a spring.
  const double radius = 12.0;
  const Vec3 centre(16.3, 16.1, 15.8);
  IsoHand hand(test::scalarFieldBlock(34, [&](const Vec3& i) { return (i - centre).norm(); }), at(radius));
  test::Random random(test::testSeed(1621));
  for (std::size_t way = 0; way < test::testCount(20); ++way)
  {
    const Vec3 a = random.direction(), b = a.cross(random.direction()).normalized();
    double gain = 0.0, depth = 0.0;
    Vec3 p = centre + (radius + 1.0) * a, pull = Vec3::Zero();
    hand.state.placed = false;
    hand.unwatched(p);
    for (int i = 0; i <= 4000; ++i)
    {
      const double turn = 2.0 * std::numbers::pi * i / 4000;
      depth = std::min({ i / 200.0, (4000 - i) / 200.0, 2.0 }) - 1.0;
      const Vec3 next = centre + (radius - depth) * (std::cos(turn) * a + std::sin(turn) * b);
      const Vec3 now = hand.unwatched(next).pull_u;
      gain += 0.5 * (pull + now).dot(next - p);
      pull = now;
      p = next;
    }
    // In units of stiffness times the square of a spacing; K = 1 N/mm and 1 mm: 1e-4 mJ are 1e-4.
    EXPECT_LE(gain, 1e-4);
    EXPECT_GE(gain, -1.1 * 2.0 * std::numbers::pi * radius / (2.0 * radius * radius)) << "the loss of its creases";
  }
}

TEST(IsoProxy, AllocatesNothing)
{
  test::Random random(test::testSeed(1622));
  IsoHand hand(noise(random, 1, 0.005), at(0.0, 10));
  hand.unwatched({ 11, 11, 11 });
  const test::AllocationGuard guard;
  for (int i = 0; i < 200; ++i)
  {
    hand.unwatched(Vec3(11, 11, 11) + random.inCube(4.0));
  }
  EXPECT_EQ(guard.allocations() + guard.frees() + guard.locks(), 0U);
}

} // namespace
} // namespace palpate
