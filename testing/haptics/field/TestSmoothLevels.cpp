// SPDX-License-Identifier: GPL-3.0-or-later
// Smooth levels have a potential up to the strength that mostSmooth_N() says, wherever the hand goes. The judge is the
// work over closed paths, and derivatives that are sampled densely.
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "haptics/field/LevelBounds.h"
#include "haptics/field/UsualGradient.h"
#include "haptics/field/laws/SmoothScalar.h"
#include "haptics/session/scene/FeltField.h"
#include "testing/haptics/field/FieldHand.h"
#include "testing/support/Random.h"

namespace palpate
{
namespace
{

using test::cube_n;
using test::k;
using test::middle;

using Function = std::function<double(const Vec3&)>;
using Way = std::function<Vec3(double)>;
using FieldBlockAt = std::function<std::shared_ptr<const FieldBlock>(const Vec3&)>;

constexpr double mostLost_mJ = 1e-4, mostStep_N = 0.02;

double distance(const Vec3& p)
{
  return (p - middle).norm();
}

double waves(const Vec3& p)
{
  return p.x() + 1.5 * std::sin(0.35 * p.y()) * std::cos(0.3 * p.z());
}

std::shared_ptr<const FieldBlock> brickOn(
  const FieldBlockGrid& grid, const Function& function, std::shared_ptr<const FieldBlock> finer = nullptr)
{
  return std::make_shared<const FieldBlock>(1, grid,
    std::vector<FieldBlockArray>{ { FieldBlockRole::Scalar, "f",
      test::sampledValues(grid.size, [&](const Vec3& index) { return function(grid.toWorld(index)); }) } },
    std::vector<Vec3>(), std::vector<FieldBlockLine>(), std::move(finer));
}

LevelBounds boundsOf(const FieldBlock& brick)
{
  return levelBounds(brick.arrays().front().values, brick.grid().size, brick.grid().spacing_u);
}

DetentPlan levelsOf(double strength_N, const LevelBounds& bounds)
{
  DetentPlan plan{ strength_N, 0.0, 3.0, 1.0, false };
  plan.bounds = bounds;
  return plan;
}

/// The work that levels do on a hand over a closed path, after a first turn on which it takes its place. No step of the
/// force is longer than asked. `largest_N` becomes the largest force.
double workOver(const Way& way, const FieldBlockAt& brickAt, const DetentPlan& detent, double& largest_N)
{
  FieldPlan plan;
  plan.detent = detent;
  FieldState state;
  const int steps = 8000;
  Vec3 p = way(0.0), force_N = Vec3::Zero();
  double work_mJ = 0.0, longest_N = 0.0;
  largest_N = 0.0;
  for (int i = 0; i <= 2 * steps; ++i)
  {
    const Vec3 next = way(2.0 * std::numbers::pi * i / steps);
    const Vec3 now_N = k * moveFieldProxy(*brickAt(next), plan, k, next, state).pull_W;
    work_mJ = i <= steps ? 0.0 : work_mJ + 0.5 * (force_N + now_N).dot(next - p);
    longest_N = i <= steps ? 0.0 : std::max(longest_N, (now_N - force_N).norm());
    largest_N = std::max(largest_N, now_N.norm());
    force_N = now_N;
    p = next;
  }
  EXPECT_LT(longest_N, mostStep_N) << "no jump";
  return work_mJ;
}

TEST(SmoothLevels, TakeNoWorkOverClosedWaysWhateverStrengthIsAskedOfThemAlsoWhereTheyBend)
{
  const Way way = [](double turn)
  { return Vec3(middle + Vec3(9.5 + 4.0 * std::cos(turn), 2.0 * std::sin(turn), 1.5 * std::sin(2.0 * turn))); };
  for (const Function& function : { Function(distance), Function(waves) })
  {
    const auto brick = brickOn({ cube_n }, function);
    for (const double strength_N : { 0.1, 0.3, 1.0, 5.0 })
    {
      const DetentPlan plan = levelsOf(strength_N, boundsOf(*brick));
      const double most_N = mostSmooth_N(plan, k);
      double largest_N = 0.0;
      EXPECT_LT(std::fabs(workOver(
                  way, [&](const Vec3&) { return brick; }, plan, largest_N)),
        mostLost_mJ)
        << strength_N;
      EXPECT_GT(largest_N, 0.5 * std::min(strength_N, most_N)) << "they are felt";
      EXPECT_GT(most_N, 0.1) << "and may be strong";
    }
  }
}

TEST(SmoothLevels, TakeNoWorkOverClosedWaysAroundTheCentreOfABallAndThroughIt)
{
  // A level of 0.4 lies within a spacing of the centre, where the ball's distance bends most.
  const auto brick = brickOn({ cube_n }, distance);
  const Vec3 off(0.21, -0.13, 0.08);
  const Way through = [&](double turn)
  { return Vec3(middle + Vec3(2.0 * std::cos(turn), 0.3 * std::sin(turn), 0.2 * std::sin(2.0 * turn))); };
  const Way around = [&](double turn)
  { return Vec3(middle + off + Vec3(0.7 * std::cos(turn), 0.6 * std::sin(turn), 0.4 * std::sin(2.0 * turn))); };
  for (const Way& way : { through, around })
  {
    for (const double origin : { 0.0, 0.4, 1.5 })
    {
      DetentPlan plan = levelsOf(5.0, boundsOf(*brick));
      plan.origin = origin;
      double largest_N = 0.0;
      EXPECT_LT(std::fabs(workOver(
                  way, [&](const Vec3&) { return brick; }, plan, largest_N)),
        mostLost_mJ)
        << origin;
      EXPECT_GT(largest_N, 0.01) << "they are felt";
    }
  }
}

/// FieldBlocks of one lattice that follow the hand, each with a finer one in it where `finer` says so.
class FollowingFieldBlocks
{
public:
  FollowingFieldBlocks(const Function& function, bool finer) : function_(function), finer_(finer) {}

  std::shared_ptr<const FieldBlock> operator()(const Vec3& hand_W)
  {
    constexpr double used_u = 3.0;
    if (!this->brick_ || (hand_W - this->centre_W_).cwiseAbs().maxCoeff() > used_u)
    {
      this->centre_W_ = hand_W;
      const Vec3 corner_W = (hand_W - Vec3::Constant(8.0)).array().round();
      std::shared_ptr<const FieldBlock> finer;
      if (this->finer_)
      {
        const Vec3 inner_W = (hand_W - Vec3::Constant(2.0)).array().round();
        finer = brickOn({ { 33, 33, 33 }, Vec3::Constant(0.125), { inner_W } }, this->function_);
      }
      this->brick_ = brickOn({ { 17, 17, 17 }, Vec3::Ones(), { corner_W } }, this->function_, finer);
      ++this->made;
    }
    return this->brick_;
  }

  int made = 0;

private:
  Function function_;
  bool finer_;
  Vec3 centre_W_ = Vec3::Zero();
  std::shared_ptr<const FieldBlock> brick_;
};

TEST(SmoothLevels, TakeNoWorkOverClosedWaysWhereBricksFollowTheHandAndTheFinerOneTakesOver)
{
  const Way way = [](double turn)
  { return Vec3(middle + Vec3(6.5 + 5.0 * std::cos(turn), 4.0 * std::sin(turn), 2.5 * std::sin(2.0 * turn))); };
  // Steeper on one side: by its own steepest place each block would have another limit.
  const Function uneven = [](const Vec3& p) { return p.x() + 0.02 * p.x() * p.x() + 0.5 * std::sin(0.4 * p.y()); };
  for (const Function& function : { Function(distance), uneven })
  {
    const auto whole = brickOn({ { 48, 48, 48 }, Vec3::Ones(), { Vec3::Constant(-8.0) } }, function);
    for (const bool finer : { false, true })
    {
      FollowingFieldBlocks bricks(function, finer);
      double largest_N = 0.0;
      const double work_mJ = workOver(
        way, [&](const Vec3& hand_W) { return bricks(hand_W); }, levelsOf(5.0, boundsOf(*whole)), largest_N);
      EXPECT_LT(std::fabs(work_mJ), mostLost_mJ) << finer;
      EXPECT_GT(largest_N, 0.02) << "they are felt";
      EXPECT_GT(bricks.made, 8) << "of the two turns";
    }
  }
}

TEST(SmoothLevels, AreLimitedByBoundsThatNoPlaceExceedsAndOnePlaceComesNearTo)
{
  test::Random random(test::testSeed(2820));
  std::vector<double> noise(4096);
  std::ranges::generate(noise, [&] { return random.uniform(-1.0, 1.0); });
  const Function rough = [&](const Vec3& p)
  { return noise[static_cast<std::size_t>(p.x() + 16.0 * p.y() + 256.0 * p.z())]; };
  const FieldBlockGrid grid{ { 16, 16, 16 }, Vec3(1.0, 0.5, 2.0) };
  for (const Function& function : { Function([&](const Vec3& i) { return rough(i); }), Function(waves),
         Function([](const Vec3& i) { return (i - Vec3(7.4, 7.6, 7.5)).norm(); }) })
  {
    const auto values = test::sampledValues(grid.size, function);
    const FieldBlock brick(1, grid, { { FieldBlockRole::Scalar, "f", values } });
    const LevelBounds bounds = levelBounds(values, grid.size, grid.spacing_u);
    double steepest = 0.0, most = 0.0;
    for (std::size_t i = 0; i < test::testCount(200000); ++i)
    {
      const Vec3 index = Vec3::Constant(7.5) + random.inCube(7.5);
      const auto f = smoothScalar(brick, grid.toWorld(index));
      ASSERT_TRUE(f);
      steepest = std::max(steepest, f->gradient_W.norm());
      most = std::max(most, f->bend_W.norm());
    }
    EXPECT_LE(steepest, bounds.gradient_per_u * (1.0 + 1e-9));
    EXPECT_LE(most, bounds.bend_per_u2 * (1.0 + 1e-9));
    // A polynomial of degree 2 along three axes lies at most some tens of per cent below its coefficients.
    EXPECT_GE(steepest, 0.6 * bounds.gradient_per_u);
    EXPECT_GE(most, 0.5 * bounds.bend_per_u2);
  }
}

TEST(SmoothLevels, HaveTheDerivativesOfTheirScalar)
{
  test::Random random(test::testSeed(2821));
  const FieldBlockGrid grid{ cube_n, Vec3(1.0, 0.5, 2.0),
    { Vec3(3, -2, 1), Quat(Eigen::AngleAxisd(0.7, Vec3(1, 2, -1).normalized())) } };
  const FieldBlock brick(1, grid, { { FieldBlockRole::Scalar, "f", test::sampledValues(cube_n, waves) } });
  for (int i = 0; i < 300; ++i)
  {
    const Vec3 p_W = grid.toWorld(middle + random.inCube(15.0));
    const auto at = smoothScalar(brick, p_W);
    const double d = 1e-5;
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto low = smoothScalar(brick, p_W - d * Vec3::Unit(axis));
      const auto high = smoothScalar(brick, p_W + d * Vec3::Unit(axis));
      ASSERT_TRUE(at && low && high);
      EXPECT_NEAR(at->gradient_W[axis], (high->value - low->value) / (2.0 * d), 1e-7);
      const Vec3 bend = (high->gradient_W - low->gradient_W) / (2.0 * d);
      // Second derivatives jump at the middles between points, which a difference may straddle.
      const Vec3 between = (grid.toIndex(p_W).array() + 0.5 - (grid.toIndex(p_W).array() + 0.5).round()).abs();
      if (between.minCoeff() > 1e-3)
      {
        EXPECT_LT((at->bend_W.col(axis) - bend).norm(), 1e-6);
      }
    }
  }
}

/// The number behind a word of a sentence.
double numberAfter(const std::string& sentence, const std::string& word)
{
  const std::size_t at = sentence.find(word);
  EXPECT_NE(at, std::string::npos) << sentence;
  return at == std::string::npos ? 0.0 : std::stod(sentence.substr(at + word.size()));
}

TEST(SmoothLevels, AreNowhereFeltWithMoreThanTheirSentenceSaysAndSomewhereWithMoreThanWhereTheValuesRiseAsUsual)
{
  test::Random random(test::testSeed(2822));
  const std::string usual = "smooth levels hold with ", most = "at most ";
  for (int field = 0; field < 4; ++field)
  {
    const Vec3 wave = 0.4 * random.direction(), other = 0.3 * random.direction();
    const double height = random.uniform(0.5, 3.0), bent = random.uniform(0.0, 0.03);
    const auto brick = brickOn({ cube_n }, [&](const Vec3& p)
      { return 2.0 * std::sin(wave.dot(p)) + height * std::cos(other.dot(p)) + bent * p.z() * p.z(); });
    FieldPlan plan;
    plan.detent = levelsOf(50.0, boundsOf(*brick));
    plan.detent.spacing = random.uniform(0.3, 2.0);
    plan.detent.slope_per_u = usualGradient(*brick);
    const std::string said = detentText(plan, k);
    double felt_N = 0.0;
    FieldState state;
    Vec3 hand_W = middle, way_W = random.direction();
    for (std::size_t i = 0; i < test::testCount(20000); ++i)
    {
      const Vec3 next_W = hand_W + 0.05 * way_W;
      way_W = (next_W - middle).cwiseAbs().maxCoeff() < 12.0 && i % 500 != 499 ? way_W : random.direction();
      hand_W = (next_W - middle).cwiseAbs().maxCoeff() < 12.0 ? next_W : hand_W;
      felt_N = std::max(felt_N, k * moveFieldProxy(*brick, plan, k, hand_W, state).pull_W.norm());
    }
    EXPECT_LE(felt_N, numberAfter(said, most)) << said;
    EXPECT_GT(felt_N, numberAfter(said, usual)) << "the force at the usual gradient is not the largest: " << said;
    EXPECT_NEAR(numberAfter(said, usual), mostSmooth_N(plan.detent, k), 0.05 * mostSmooth_N(plan.detent, k)) << said;
    EXPECT_LE(numberAfter(said, most),
      1.2 * plan.detent.bounds.gradient_per_u / plan.detent.slope_per_u * mostSmooth_N(plan.detent, k))
      << "it is no blind bound: " << said;
  }
}

TEST(SmoothLevels, DoNotHoldWhereNobodyKnowsHowSteepTheDataAre)
{
  const auto brick = brickOn({ cube_n }, distance);
  FieldPlan plan;
  plan.detent = levelsOf(0.1, unknownLevels);
  EXPECT_EQ(mostSmooth_N(plan.detent, k), 0.0);
  FieldState state;
  (void)moveFieldProxy(*brick, plan, k, middle + Vec3(5, 0, 0), state);
  EXPECT_LT(moveFieldProxy(*brick, plan, k, middle + Vec3(5.5, 0, 0), state).pull_W.norm(), 1e-12);
}

} // namespace
} // namespace palpate
