// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "haptics/field/iso/IsoProxy.h"
#include "testing/support/FieldOracle.h"
#include "testing/support/Fields.h"
#include "testing/support/Random.h"

namespace palpate
{
namespace
{

constexpr double scrub_u = 0.045; ///< 0.045 N a tick at 1 N a spacing

struct Scrubbed
{
  std::uint64_t wrong = 0, touching = 0, released = 0;
  double mostChange_u = 0.0; ///< of the pull, beyond the hand's motion and the fading, while the surface moves
};

/// The level is drawn anew two hundred times a second while a hand presses.
template<class Function>
Scrubbed scrub(const Function& function, double low, double high, double hand_u, std::uint64_t seed)
{
  const auto brick = test::scalarFieldBlock(32, function);
  const FieldBlockComponent field = brick->component(FieldBlockRole::Scalar);
  test::FieldOracle oracle(field);
  test::Random random(test::testSeed(seed));
  IsoPlan plan;
  plan.scrub_u = scrub_u;
  plan.level = 0.5 * (low + high);
  IsoState state;
  Vec3 p(15.5, 15.5, 12.5), pull = Vec3::Zero();
  Scrubbed seen;
  for (std::size_t i = 0; i < test::testCount(4000); ++i)
  {
    plan.level = i % 5 == 0 ? random.uniform(low, high) : plan.level;
    const Vec3 next = (p + random.inCube(hand_u)).cwiseMax(4).cwiseMin(27);
    const bool moving = state.placed && (state.level != plan.level || state.catchingUp);
    const std::uint32_t stuck = state.stuck;
    const IsoResult result = moveIsoProxy(field, Vec3::Ones(), plan, next, state);
    seen.released += result.released;
    seen.touching += result.contacts > 0;
    seen.wrong += state.placed && oracle.value(state.x, state.level, state.side) < 0.0;
    if (moving && !result.released)
    {
      const double faded_u =
        state.stuck != stuck ? state.x.from(GridPlace::at(next)).norm() / IsoState::mostStuck : 0.0;
      const double change_u = (result.pull_u - pull).norm() - 2.0 * (next - p).norm() - faded_u;
      seen.mostChange_u = std::max(seen.mostChange_u, change_u);
    }
    pull = result.pull_u;
    p = next;
  }
  return seen;
}

TEST(IsoScrub, MovesTheSurfaceUnderAStillHandByLessThanATenthOfANewtonATickAndKeepsItsSide)
{
  const auto ball = [](const Vec3& i) { return (i - Vec3(15.5, 15.5, 15.5)).norm(); };
  const Scrubbed seen = scrub(ball, 2.0, 12.0, 0.0, 1630);
  EXPECT_EQ(seen.wrong, 0U);
  EXPECT_GT(seen.touching, 100U);
  // The proxy is taken along by 1.1 displacements of the scrub and makes one itself: below 0.1 N at 1 N a spacing.
  EXPECT_LE(seen.mostChange_u, 2.1 * scrub_u + 1e-9);
}

TEST(IsoScrub, OfAFieldWithSaddlesKeepsTheSideOfAMovingHandAndStepsByNoMore)
{
  const auto waves = [](const Vec3& i)
  { return std::sin(0.5 * i.x()) * std::cos(0.4 * i.y()) + std::sin(0.45 * i.z()); };
  for (const double hand_u : { 0.0, 0.05, 0.2 })
  {
    const Scrubbed seen = scrub(waves, -1.5, 1.5, hand_u, 1631);
    EXPECT_EQ(seen.wrong, 0U);
    EXPECT_GT(seen.touching, 100U);
    EXPECT_LE(seen.mostChange_u, 2.1 * scrub_u + 1e-9) << hand_u;
  }
}

TEST(IsoScrub, ReachesANewLevelAndComesToRestOnIt)
{
  const auto field = [](const Vec3& i) { return i.z(); };
  const auto brick = test::scalarFieldBlock(32, field);
  IsoPlan plan;
  plan.level = 10.5;
  plan.scrub_u = scrub_u;
  IsoState state;
  const auto tick = [&](double z) {
    return moveIsoProxy(brick->component(FieldBlockRole::Scalar), Vec3::Ones(), plan, { 15, 15, z }, state);
  };
  tick(11.0);
  EXPECT_NEAR(tick(10.0).pull_u.z(), 0.5, 1e-12);
  plan.level = 12.25; // it rises under the hand
  for (int i = 0; i < static_cast<int>(1.75 / scrub_u) + 2; ++i)
  {
    tick(10.0);
  }
  EXPECT_NEAR(tick(10.0).pull_u.z(), 2.25, 1e-12);
  plan.level = 9.0; // it falls away: the hand is let down no faster
  double before_u = 2.25;
  while (before_u > 0.0)
  {
    const double now_u = tick(10.0).pull_u.z();
    ASSERT_LT(now_u, before_u);
    ASSERT_GT(now_u, before_u - 2.0 * scrub_u - 1e-9);
    before_u = now_u;
  }
}

TEST(IsoScrub, LetsGoOfAHandWhoseSurfaceVanishes)
{
  // Inside of a hill that is cut off at the top the field does not rise any more.
  const auto hill = [](const Vec3& i) { return std::max(-(i - Vec3(15.5, 15.5, 15.5)).norm(), -3.0); };
  const auto brick = test::scalarFieldBlock(32, hill);
  IsoPlan plan;
  plan.level = -4.0;
  plan.scrub_u = scrub_u;
  IsoState state;
  const Vec3 p(25, 15, 15);
  const auto tick = [&]
  { return moveIsoProxy(brick->component(FieldBlockRole::Scalar), Vec3::Ones(), plan, p, state); };
  tick();
  EXPECT_EQ(state.side, 1.0);
  plan.level = -2.0; // above every value near the hand: its side is nowhere
  int ticks = 1;
  while (!tick().released)
  {
    ASSERT_LE(++ticks, 30 + 1);
  }
  tick();
  EXPECT_EQ(state.side, -1.0) << "it is on the side where it is";
  EXPECT_TRUE(tick().pull_u.isZero());
}

TEST(IsoScrub, FadesWithinThirtyMillisecondsOfWhereTheLastOfASurfaceIsGone)
{
  // A hill of the value -|i - top|, whose corner nearest to the hand is (16, 16, 16) wherever the top is in that cell:
  // there the level can go to -|top - corner| and no further. A hand that is outside pulls at the rest of the surface.
  test::Random random(test::testSeed(1632));
  for (std::size_t i = 0; i < test::testCount(40); ++i)
  {
    const Vec3 top = Vec3(15.75, 15.75, 15.75) + random.inCube(0.2);
    const auto brick = test::scalarFieldBlock(32, [&](const Vec3& at) { return -(at - top).norm(); });
    const auto tick = [&](const IsoPlan& plan, const Vec3& p, IsoState& state)
    { return moveIsoProxy(brick->component(FieldBlockRole::Scalar), Vec3::Ones(), plan, p, state); };
    IsoPlan plan;
    plan.level = -4.0;
    plan.scrub_u = scrub_u;
    IsoState state;
    tick(plan, top, state);
    const Vec3 hand(22, 22, 22);
    Vec3 pull = tick(plan, hand, state).pull_u;
    plan.level = 1.0;
    int left = 0;
    IsoResult result;
    while (!(result = tick(plan, hand, state)).released)
    {
      const double far_u = state.x.from(GridPlace::at(hand)).norm();
      EXPECT_LE((result.pull_u - pull).norm(), 2.1 * scrub_u + far_u / 30.0 + 1e-9);
      pull = result.pull_u;
      left += (state.x.index() - Vec3(16, 16, 16)).norm() < 1e-3;
      ASSERT_LE(left, 30 + 1);
    }
    EXPECT_LE(pull.norm(), 10.5 / 30.0 + 2.1 * scrub_u) << "nearly nothing is left to let go of";
  }
}

} // namespace
} // namespace palpate
