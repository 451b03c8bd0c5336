// SPDX-License-Identifier: GPL-3.0-or-later
// How far a step leads a wire off its own line, against distances from the line itself.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include <gtest/gtest.h>

#include "haptics/mechanism/wire/WireProof.h"
#include "testing/support/Random.h"
#include "testing/support/WireTube.h"

namespace palpate::test
{
namespace
{

constexpr int proofBeams = 5;
constexpr double chord_mm = 4.0, free_mm = 100.0;

/// Distance of a place from the wire as it was, whose outer end goes on straight in the sheath.
double off_mm(const WirePlaces& before_M, const Vec3& p)
{
  double least_mm = std::numeric_limits<double>::infinity();
  for (int b = 0; b < proofBeams; ++b)
  {
    const Vec3 &a = before_M[b].p, chord = before_M[b + 1].p - a;
    const double from = b == 0 ? -10.0 : 0.0;
    const double share = std::clamp(chord.dot(p - a) / chord.squaredNorm(), from, 1.0);
    least_mm = std::min(least_mm, (p - a - share * chord).norm());
  }
  return least_mm;
}

struct Step
{
  WirePlan plan;
  WirePlaces before_M{};
  WireVector motion;
  WireContacts near;
  WireReach reach;

  [[nodiscard]] double share() const { return provenShare({ plan, before_M, near, reach }, motion); }
  /// The furthest place of a beam from the wire as it was, after such a share of the step.
  [[nodiscard]] double goes_mm(int beam, double share) const
  {
    double most_mm = 0.0;
    constexpr int places = 20;
    for (int i = 0; i <= places; ++i)
    {
      const double at = static_cast<double>(i) / places;
      const Vec3 p = (1.0 - at) * before_M[beam].p + at * before_M[beam + 1].p;
      const Vec3 way = (1.0 - at) * motion[beam].head<3>() + at * motion[beam + 1].head<3>();
      most_mm = std::max(most_mm, off_mm(before_M, p + share * way));
    }
    return most_mm;
  }
};

/// Far from all walls, so that the reach alone limits the step.
std::unique_ptr<Step> randomStep(Random& random)
{
  static const PushedWire wire(nitinolWire(proofBeams * chord_mm, proofBeams, 0.0), Tube{}.mesh());
  auto step = std::make_unique<Step>();
  step->plan.wire = wire.planned.plan->wire;
  step->plan.mouthAway_u = free_mm;
  step->near.away_u.fill(free_mm);
  step->reach = { random.uniform(0.02, 0.3), random.uniform(0.02, 0.6) };
  const double kink = random.below(8) == 0 ? 3.0 : 0.4, along_mm = random.uniform(-3.0, 3.0);
  Vec3 way = random.direction(), p = Vec3::Zero();
  for (int i = 0; i <= proofBeams; ++i)
  {
    step->before_M[i].p = p;
    step->motion[i].setZero();
    step->motion[i].head<3>() = along_mm * way + random.uniform(0.0, 0.2) * random.direction();
    way = (way + kink * random.uniform(0.0, 1.0) * random.direction()).normalized();
    p += chord_mm * way;
  }
  return step;
}

TEST(WireProof, NoPlaceOfTheWireGoesFurtherOffItsLineThanWasLookedAt)
{
  Random random(testSeed(43));
  int shortened = 0;
  for (std::size_t i = 0; i < testCount(3000); ++i)
  {
    const auto step = randomStep(random);
    const double share = step->share();
    ASSERT_GT(share, 0.0);
    for (int b = 0; b < proofBeams; ++b)
    {
      const double reach_mm = b + 1 < proofBeams ? step->reach.shaft_u : step->reach.tip_u;
      ASSERT_LE(step->goes_mm(b, share), reach_mm * (1.0 + 1e-9)) << i << " beam " << b;
    }
    shortened += share < 1.0 ? 1 : 0;
  }
  EXPECT_GT(shortened, 100);
}

TEST(WireProof, AStraightWireThatSlidesGoesAsFarAsItsTipWasLookedAhead)
{
  Random random(testSeed(44));
  const auto step = randomStep(random);
  step->reach = { 0.075, 0.15 };
  for (int i = 0; i <= proofBeams; ++i)
  {
    step->before_M[i].p = Vec3(chord_mm * i, 0.0, 0.0);
    step->motion[i] << 1.0, 0.0, 0.0, 0.0, 0.0, 0.0;
  }
  EXPECT_NEAR(step->share(), 0.15, 1e-12);
  for (NodeVector& m : step->motion)
  {
    m[0] = -1.0;
  }
  EXPECT_EQ(step->share(), 1.0) << "pulled it stays on its line";
  step->near.away_u[2] = 0.05;
  for (int i = 0; i <= proofBeams; ++i)
  {
    step->motion[i] << 0.0, 0.06, 0.0, 0.0, 0.0, 0.0;
  }
  EXPECT_NEAR(step->share(), 0.9 * 0.05 / 0.06, 1e-12) << "nine tenths of the distance from a wall";
}

} // namespace
} // namespace palpate::test
