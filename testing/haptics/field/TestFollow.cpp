// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <functional>
#include <numbers>

#include <gtest/gtest.h>

#include "haptics/field/proxy/FieldProxy.h"
#include "testing/support/Fields.h"
#include "testing/support/Random.h"

namespace palpate
{
namespace
{

constexpr double k_N_per_u = 1.0; ///< a spacing is a millimetre: work is in mJ
const Vec3 centre(23.5, 23.5, 1.5);

FieldBlock vectorFieldBlock(const std::function<Vec3(const Vec3&)>& function)
{
  const GridIndex size{ 48, 48, 4 };
  return FieldBlock(
    1, FieldBlockGrid{ size }, { { FieldBlockRole::Vector, "v", test::sampledVectors(size, function) } });
}

/// Exact between points: it is linear.
Vec3 solidBody(const Vec3& i)
{
  return { centre.y() - i.y(), i.x() - centre.x(), 0.0 };
}

/// A vortex that decays: its core is 4 spacings wide.
Vec3 lambOseen(const Vec3& i)
{
  const Vec3 r = solidBody(i);
  const double r2 = r.squaredNorm();
  return r2 > 0.0 ? Vec3(r * ((1.0 - std::exp(-r2 / 16.0)) / r2)) : Vec3(Vec3::Zero());
}

FieldPlan follow(double strength_N)
{
  FieldPlan plan;
  plan.follow_N = strength_N;
  return plan;
}

Vec3 onCircle(double radius, double turn)
{
  return centre + radius * Vec3(std::cos(turn), std::sin(turn), 0.0);
}

/// The radius of the proxy after ten turns of a hand that is a millimetre outside, less that before, over it.
double driftOfTenTurns(const FieldBlock& brick, double radius, double speed_mm_per_s)
{
  FieldState state;
  const FieldPlan plan = follow(5.0);
  (void)moveFieldProxy(brick, plan, k_N_per_u, onCircle(radius, 0.0), state);
  const double step = 1e-3 * speed_mm_per_s / (radius + 1.0);
  for (double turn = 0.0; turn < 20.0 * std::numbers::pi; turn += step)
  {
    (void)moveFieldProxy(brick, plan, k_N_per_u, onCircle(radius + 1.0, turn), state);
  }
  return (state.soft_W - centre).norm() / radius - 1.0;
}

TEST(Follow, StaysOnTheCircleOfASolidBodyForTenTurnsAt300MillimetresASecond)
{
  EXPECT_LE(std::fabs(driftOfTenTurns(vectorFieldBlock(solidBody), 20.0, 300.0)), 1e-9);
}

TEST(Follow, StaysOnTheCircleOfAVortexThatDecaysToWhatItsGridHolds)
{
  EXPECT_LE(std::fabs(driftOfTenTurns(vectorFieldBlock(lambOseen), 12.0, 100.0)), 1e-4);
}

TEST(Follow, OfAnUndirectedFieldGoesTheSameWay)
{
  // Eigenvectors have no sign: half of the field points backwards.
  const FieldBlock turned = vectorFieldBlock([](const Vec3& i) { return i.x() < 24 ? Vec3(-1, 0, 0) : Vec3(1, 0, 0); });
  FieldState state;
  for (double x = 2; x < 20; x += 0.1)
  {
    (void)moveFieldProxy(turned, follow(1.0), k_N_per_u, { x, 10.5, 1.5 }, state);
  }
  EXPECT_NEAR(state.soft_W.x(), 19.9, 0.11);
}

TEST(Follow, HoldsAHandBesideAStraightStreamlineByItsStrengthAndNoMore)
{
  const FieldBlock brick = vectorFieldBlock([](const Vec3&) { return Vec3(2, 0, 0); });
  const double s = 0.6;
  FieldState state;
  (void)moveFieldProxy(brick, follow(s), k_N_per_u, { 10, 10, 1 }, state);
  for (double away = 0.0; away < 2.0; away += 0.01)
  {
    const FieldResult result = moveFieldProxy(brick, follow(s), k_N_per_u, { 10 + away, 10 + away, 1 }, state);
    EXPECT_NEAR(result.pull_W.norm() * k_N_per_u, std::min(k_N_per_u * away, s), 1e-12);
    EXPECT_NEAR(result.pull_W.x(), 0.0, 1e-12) << "along it the hand is free";
  }
}

TEST(Follow, GivesNoEnergyOnAWayThereAndBackOutsideOfTheCurve)
{
  const FieldBlock brick = vectorFieldBlock(solidBody);
  for (const double speed_mm_per_s : { 30.0, 90.0 })
  {
    FieldState state;
    const FieldPlan plan = follow(5.0);
    (void)moveFieldProxy(brick, plan, k_N_per_u, onCircle(20.0, 0.0), state);
    Vec3 p = onCircle(21.0, 0.0);
    Vec3 pull = moveFieldProxy(brick, plan, k_N_per_u, p, state).pull_W;
    const Vec3 before = pull;
    const double step = 1e-3 * speed_mm_per_s / 21.0;
    const int steps = static_cast<int>(30.0 / 21.0 / step);
    double work_mJ = 0.0;
    for (int i = 1; i <= 2 * steps; ++i)
    {
      const Vec3 next = onCircle(21.0, step * (i <= steps ? i : 2 * steps - i));
      const Vec3 now = moveFieldProxy(brick, plan, k_N_per_u, next, state).pull_W;
      work_mJ += 0.5 * k_N_per_u * (pull + now).dot(next - p);
      pull = now;
      p = next;
    }
    const double stored_mJ = 0.5 * k_N_per_u * (pull.squaredNorm() - before.squaredNorm());
    EXPECT_LE(std::fabs(work_mJ + stored_mJ), 1e-4);
    EXPECT_LT((state.soft_W - onCircle(20.0, 0.0)).norm(), 1e-6) << "it is back where it was";
  }
}

TEST(Follow, LetsGoWhereThereAreNoVectors)
{
  const FieldBlock brick =
    vectorFieldBlock([](const Vec3& i) { return i.x() > 20 ? Vec3(NAN, NAN, NAN) : Vec3(1, 0, 0); });
  FieldState state;
  (void)moveFieldProxy(brick, follow(1.0), k_N_per_u, { 10, 10, 1 }, state);
  EXPECT_GT(moveFieldProxy(brick, follow(1.0), k_N_per_u, { 10, 10.5, 1 }, state).pull_W.norm(), 0.4);
  const FieldResult outside = moveFieldProxy(brick, follow(1.0), k_N_per_u, { 25, 10.5, 1 }, state);
  EXPECT_TRUE(outside.outside && outside.letGo);
  EXPECT_TRUE(outside.pull_W.isZero());
}

TEST(Follow, LeadsAlongAxesWhoseSignsMeanNothingAsAlongTheirVectors)
{
  // Three spacings from the middle of the vortex and further the vectors at the corners of a cell are less than a right
  // angle apart, so every sign is known from the way that one goes.
  const GridIndex size{ 48, 48, 4 };
  test::Random random(test::testSeed(1642));
  const auto turned = [&](const Vec3& i) { return Vec3((random.uniform() < 0.5 ? -1.0 : 1.0) * lambOseen(i)); };
  const FieldBlock axes(
    1, FieldBlockGrid{ size }, { { FieldBlockRole::Axis, "v", test::sampledVectors(size, turned) } });
  const FieldBlock vectors = vectorFieldBlock(lambOseen);
  FieldState alongAxes, alongVectors;
  for (double turn = 0.0; turn < 2.0 * std::numbers::pi; turn += 0.01)
  {
    const Vec3 p = onCircle(8.0 + std::sin(3.0 * turn), turn);
    const Vec3 one = moveFieldProxy(axes, follow(5.0), k_N_per_u, p, alongAxes).pull_W;
    const Vec3 other = moveFieldProxy(vectors, follow(5.0), k_N_per_u, p, alongVectors).pull_W;
    ASSERT_LT((one - other).norm(), 1e-9) << turn;
  }
  EXPECT_FALSE(axes.axis({ -1, 0, 0 }, Vec3::UnitX()));
  FieldPlan push;
  push.push_N = 0.5;
  FieldState state;
  EXPECT_TRUE(moveFieldProxy(axes, push, k_N_per_u, onCircle(8.0, 0.0), state).push_W.isZero()) << "no direction";
}

} // namespace
} // namespace palpate
