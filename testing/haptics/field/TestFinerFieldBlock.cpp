// SPDX-License-Identifier: GPL-3.0-or-later
// A block with a finer one in it. The judge is the ball whose distance both have sampled: a surface of spacing h lies
// h^2 / 4 R inside of it.
#include <cmath>

#include <gtest/gtest.h>

#include "haptics/field/proxy/FieldProxy.h"
#include "haptics/recording/inputs/FieldBlocks.h"
#include "testing/support/Fields.h"

namespace palpate
{
namespace
{

constexpr double stiffness = 1.0; ///< [N/u]
constexpr double coarse_u = 1.0, fine_u = 0.125, radius_u = 12.0;
const Vec3 ball(16.1, 15.9, 16.05);

std::shared_ptr<const FieldBlock> distances(
  const FieldBlockGrid& grid, std::shared_ptr<const FieldBlock> finer = nullptr)
{
  std::vector<FieldBlockArray> arrays{ { FieldBlockRole::Scalar, "f",
    test::sampledValues(grid.size, [&](const Vec3& index) { return (grid.toWorld(index) - ball).norm(); }) } };
  return std::make_shared<const FieldBlock>(
    1, grid, std::move(arrays), std::vector<Vec3>(), std::vector<FieldBlockLine>(), std::move(finer));
}

/// Fine around the place of the surface with the largest x.
std::shared_ptr<const FieldBlock> withFiner()
{
  const Vec3 corner = ball + Vec3(radius_u - 4.0, -4.0, -4.0);
  const FieldBlockGrid fine{ { 65, 65, 65 }, Vec3::Constant(fine_u), { corner } };
  return distances({ { 33, 33, 33 }, Vec3::Constant(coarse_u) }, distances(fine));
}

FieldPlan wall()
{
  FieldPlan plan;
  plan.isosurface = true;
  plan.isovalue = radius_u;
  return plan;
}

TEST(FinerFieldBlock, IsFeltWhereItIsAndItsSurfaceIsAsMuchNearerToTheBallsAsItsPointsAreToEachOther)
{
  const auto brick = withFiner();
  for (const auto& [turn, h] : { std::pair(0.03, fine_u), std::pair(2.0, coarse_u) })
  {
    const Vec3 n = Vec3(std::cos(turn), std::sin(turn), 0.05).normalized();
    FieldState state;
    (void)moveFieldProxy(*brick, wall(), stiffness, ball + (radius_u + 0.5) * n, state);
    const Vec3 p = ball + (radius_u - 1.0) * n;
    Vec3 x = p;
    for (int i = 0; i < 20; ++i)
    {
      x = p + moveFieldProxy(*brick, wall(), stiffness, p, state).pull_W;
    }
    const double inside = radius_u - (x - ball).norm();
    EXPECT_GT(inside, 0.0);
    EXPECT_LT(inside, 1.5 * h * h / (4.0 * radius_u)) << h; // at most half more than the mean of a cell
  }
}

TEST(FinerFieldBlock, ComingToItAndFromItIsNoStepAndTheHandKeepsItsSide)
{
  const auto brick = withFiner();
  FieldState state;
  const double depth_u = 0.8, step_u = 0.02;
  const auto at = [&](double turn)
  { return Vec3(std::cos(turn), std::sin(turn), 0.2 * std::sin(3.0 * turn)).normalized(); };
  (void)moveFieldProxy(*brick, wall(), stiffness, ball + (radius_u + 0.5) * at(-0.6), state);
  Vec3 last = Vec3::Zero();
  int taken = 0;
  std::uint64_t felt = 0;
  for (double turn = -0.6; turn < 0.6; turn += step_u / radius_u)
  {
    const FieldResult result = moveFieldProxy(*brick, wall(), stiffness, ball + (radius_u - depth_u) * at(turn), state);
    EXPECT_FALSE(result.letGo || result.outside || result.beyond);
    if (last.norm() > 0.0)
    {
      // The hand's own motion, a slip across a crease of the coarse surface (h / R of the depth), and the change that a
      // new block may make in a tick.
      EXPECT_LE((result.pull_W - last).norm(), 2.0 * step_u + depth_u * coarse_u / radius_u + 0.1);
    }
    EXPECT_GT(result.pull_W.dot(at(turn)), 0.0);
    taken += state.brick != felt;
    felt = state.brick;
    last = result.pull_W;
  }
  EXPECT_EQ(taken, 3) << "the coarse one, the finer one, the coarse one: not to and fro";
}

TEST(FinerFieldBlock, IsNotFeltByAHandWhoseProxyIsBeyondIt)
{
  const auto brick = withFiner();
  FieldState state;
  const Vec3 outside = ball + Vec3(radius_u + 3.5, 0, 0), inside = ball + Vec3(radius_u - 3.0, 0, 0);
  (void)moveFieldProxy(*brick, wall(), stiffness, outside, state);
  const Vec3 pull_W = moveFieldProxy(*brick, wall(), stiffness, inside, state).pull_W;
  EXPECT_NEAR(pull_W.x(), 3.0, coarse_u * coarse_u / (2.0 * radius_u)) << "held by the surface on its way";
  EXPECT_EQ(state.brick, brick->contentHash());
}

TEST(FinerFieldBlock, IsRecordedWithItsBrickAndARecordingThatEndsBeforeItIsRefused)
{
  const auto brick = withFiner();
  ByteWriter out;
  putFieldBlock(out, *brick);
  ByteReader in(out.bytes().data(), out.bytes().size());
  const auto read = readFieldBlock(in);
  ASSERT_TRUE(read && in.ok() && read->finer());
  EXPECT_EQ(read->contentHash(), brick->contentHash());
  EXPECT_EQ(read->finer()->contentHash(), brick->finer()->contentHash());
  EXPECT_EQ(read->called(brick->finer()->contentHash()), read->finer().get());
  ByteReader cut(out.bytes().data(), out.bytes().size() - 1);
  static_cast<void>(readFieldBlock(cut));
  EXPECT_FALSE(cut.ok());

  FieldState state;
  (void)moveFieldProxy(*brick, wall(), stiffness, ball + Vec3(radius_u + 0.1, 0, 0), state);
  ASSERT_EQ(state.brick, brick->finer()->contentHash());
  FieldState kept = state;
  keepCellsWithin({ read }, kept);
  EXPECT_EQ(kept.brick, state.brick) << "what was felt of the finer one goes on";
  EXPECT_EQ(kept.grid.size, brick->finer()->grid().size);
}

} // namespace
} // namespace palpate
