// SPDX-License-Identifier: GPL-3.0-or-later
// The answer of a rounded proof for two triangles is checked once more in rational numbers. Debug builds do so for each
// pair that a tool proves in its motion.
#include <gtest/gtest.h>

#include "Tools.h"
#include "haptics/tool/certify/ExactProof.h"

namespace palpate::test
{
namespace
{

Corners randomTriangle(Random& random, const Vec3& middle, double size)
{
  Corners corners;
  for (Vec3& p : corners)
  {
    p = middle + size * random.direction();
  }
  const bool sliver = random.below(4) == 0;
  corners[2] =
    sliver ? Vec3(corners[0] + random.uniform() * (corners[1] - corners[0]) + 1e-7 * random.direction()) : corners[2];
  return corners;
}

/// Two triangles that come near each other on a step, with a part of it.
struct Meeting
{
  explicit Meeting(Random& random)
  {
    const double size = std::pow(10.0, random.uniform(-2.0, 2.0));
    step.from_W = { 10.0 * size * random.direction(), turnBy(random.uniform(0.0, 3.0) * random.direction()) };
    step.v_W = random.uniform(0.0, 0.3) * size * random.direction();
    step.w_W = random.uniform(0.0, 0.2) * random.direction();
    pair.arms_W = randomTriangle(random, random.uniform(0.0, 3.0) * size * random.direction(), size);
    const Vec3 met_W = step.from_W.p + pair.arms_W[random.below(3)];
    pair.scene_W = randomTriangle(random, met_W + random.uniform(0.3, 1.5) * size * random.direction(), size);
    span.from = random.uniform(0.0, 0.5);
    span.to = span.from + random.uniform(0.01, 0.5);
    span.turnFrom = step.turn(span.from);
    span.turnTo = step.turn(span.to);
    gap = 1e-7 * size;
  }

  ScrewStep step;
  Span span;
  MovingPair pair;
  double gap = 0.0;
};

/// The planes that a proof would try, beside a normal that is as good as any.
std::vector<ProvenPlane> planesOf(const SpanProof& proof, Random& random)
{
  const NearestPair first = nearestPair(proof.toolFrom_W(), proof.pair().scene_W);
  const NearestPair last = nearestPair(proof.toolTo_W(), proof.pair().scene_W);
  std::vector<ProvenPlane> planes{ { PlaneWay::Between, first.n, last.n } };
  for (const Vec3& n : { first.n, last.n, unitNormal(proof.pair().scene_W), random.direction() })
  {
    planes.push_back({ PlaneWay::InScene, n, n });
    planes.push_back({ PlaneWay::InTool, n, n });
  }
  return planes;
}

TEST(ExactProof, SaysOfRandomPairsWhatTheRoundedOneSaysAndOfALargerGapThatItDoesNotHold)
{
  Random random(testSeed(3401));
  std::size_t proven = 0, failed = 0;
  for (std::size_t i = 0; i < testCount(200); ++i)
  {
    const Meeting meeting(random);
    const SpanProof proof(meeting.step, meeting.span, meeting.pair);
    for (const ProvenPlane& plane : planesOf(proof, random))
    {
      const double least = proof.gapOf(plane).least();
      EXPECT_TRUE(holdsExactly(proof, plane, least)) << i;
      EXPECT_FALSE(holdsExactly(proof, plane, least + std::max(1e-6 * std::abs(least), meeting.gap))) << i;
      proven += least >= meeting.gap ? 1 : 0;
      failed += least < meeting.gap ? 1 : 0;
    }
  }
  EXPECT_GT(proven, failed / 20);
  EXPECT_GT(failed, proven / 20);
}

/// Independent of all bounds: the triangles posed at many moments of a span that a plane is said to prove.
TEST(ExactProof, KeepsTrianglesApartAtEachOfManyMoments)
{
  Random random(testSeed(3402));
  constexpr int moments = 16;
  for (std::size_t i = 0; i < testCount(500); ++i)
  {
    const Meeting meeting(random);
    const SpanProof proof(meeting.step, meeting.span, meeting.pair);
    for (const ProvenPlane& plane : planesOf(proof, random))
    {
      const double least = proof.gapOf(plane).least();
      for (int k = 0; least >= meeting.gap && k <= moments; ++k)
      {
        const double s = meeting.span.from + (meeting.span.to - meeting.span.from) * k / moments;
        const Mat3 turn = meeting.step.turn(s);
        Corners tool_W;
        for (int c = 0; c < 3; ++c)
        {
          tool_W[c] = meeting.step.centre_W(s) + turn * meeting.pair.arms_W[c];
        }
        EXPECT_GE(nearestPair(tool_W, meeting.pair.scene_W).distance_u, least * (1.0 - 1e-9)) << i << " at " << s;
      }
    }
  }
}

} // namespace
} // namespace palpate::test
