// SPDX-License-Identifier: GPL-3.0-or-later
// Changes from tick to tick of the force on a ball that slides over bumps that yield.
#include <algorithm>
#include <vector>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "BallRests.h"
#include "BumpySlide.h"
#include "PointRests.h"
#include "testing/support/LongForm.h"

namespace palpate::test
{
namespace
{

using namespace slide;

/// Of some places of rest the one whose force is nearest to another force; null: there are none.
template<class Rest>
const Rest* nearestTo(const Vec3& force_N, const std::vector<Rest>& rests)
{
  const Rest* nearest = nullptr;
  for (const Rest& rest : rests)
  {
    if (nearest == nullptr || (rest.force_N - force_N).norm() < (nearest->force_N - force_N).norm())
    {
      nearest = &rest;
    }
  }
  return nearest;
}

/// A force that follows a hand, and how often it has stepped.
struct FollowedForce
{
  Vec3 hand_W = Vec3::Zero();
  Vec3 force_N = Vec3::Zero();
  int steps = 0;

  /// True if it has stepped.
  bool goTo(const Vec3& p_W, const Vec3& now_N)
  {
    const bool steps_ = (now_N - this->force_N).norm() > this->allowed_N(p_W, now_N);
    this->steps += steps_;
    this->hand_W = p_W;
    this->force_N = now_N;
    return steps_;
  }
  [[nodiscard]] double allowed_N(const Vec3& p_W, const Vec3& now_N) const
  {
    return stepAllowed_N(p_W - this->hand_W, this->force_N, now_N);
  }
};

/// Of the bumps, three in the long form.
std::vector<std::uint64_t> seedsOfSlides()
{
  return casesOf<std::uint64_t>({ 191, 192, 193 }, { 191 });
}

/// The steps here are those of the contact's constraints: over a convex edge a point comes to the end of its face and
/// rests next on the other one, which pushes elsewhere; a ball that is deep enough snaps over an edge. Rigid contact
/// steps there too. A step is right where no place of rest is nearer. A ball steps no more often than an oracle that
/// goes along the same path from each rest to the nearest one.

TEST(SoftBumps, APointWithoutFrictionStepsOnlyWhereNoPlaceOfRestIsNearerThanTheOneItGoesTo)
{
  for (const std::uint64_t seed : seedsOfSlides())
  {
    for (const Bumps& bumps : { Bumps{}, Bumps{ 10e6 } })
    {
      Bumps here = bumps;
      here.seed = seed;
      SoftScene s(padOf(here), 0.0);
      const PointRests rests(s, stiffness, 0.03);
      FollowedForce felt{ handAt(here, 0) };
      for (int tick = 0; tick < ticksOfSlide; ++tick)
      {
        const Vec3 p = handAt(here, tick);
        const Vec3 f = s.move(p).force_N;
        const Vec3 before_N = felt.force_N;
        const double allowed_N = felt.allowed_N(p, f);
        if (felt.goTo(p, f))
        {
          const std::vector<PointRests::Rest> all = rests.at(p);
          const auto* const nearest = nearestTo(before_N, all);
          const auto* const found = nearestTo(f, all);
          ASSERT_NE(found, nullptr) << tick;
          EXPECT_GT((nearest->force_N - before_N).norm(), allowed_N) << tick;
          EXPECT_LE((found->force_N - f).norm(), 1e-8 * f.norm()) << tick << ": it is not at rest";
        }
      }
      EXPECT_LE(felt.steps, 24) << "a way of 70 mm crosses eleven edges of 6 mm and as many diagonals";
    }
  }
}

/// The ball of an oracle: from each rest it goes to the nearest one.
class OracleBall
{
public:
  OracleBall(const SoftScene& s, const Vec3& p_W)
    : rests_(s, stiffness, 0.03), scene_(s), force_{ p_W }, rest_{ p_W, Vec3::Zero(), {} }
  {
    for (const std::uint32_t v : s.snapshot->near)
    {
      this->most_ = std::max(this->most_, s.snapshot->between(v, v).eigenvalues().real().maxCoeff());
    }
  }

  [[nodiscard]] const BallRests& rests() const { return this->rests_; }
  [[nodiscard]] int steps() const { return this->force_.steps; }

  /// How far in the material two rests may be apart whose forces differ by so much: of x = p + f / K + u.
  [[nodiscard]] double reach_u(double way_u, double differ_N, double force_N) const
  {
    const double size_N = std::max(force_N, 1e-3);
    const double dent = subgridDepth(this->scene_.snapshot->springs.front(), size_N).depth_u / size_N;
    return way_u + differ_N * (1.0 / stiffness + this->most_ + dent);
  }

  void follow(const Vec3& p_W)
  {
    const Vec3 way = p_W - this->force_.hand_W;
    const auto same = this->rests_.restOn(this->rest_.on, p_W, this->rest_.x_W + way);
    if (same && (same->force_N - this->rest_.force_N).norm() <= stiffness * way.norm())
    {
      this->rest_ = *same;
    }
    else
    {
      this->goToNearest(p_W, way);
    }
    this->force_.goTo(p_W, this->rest_.force_N);
  }

private:
  void goToNearest(const Vec3& p_W, const Vec3& way)
  {
    constexpr double farthest_u = 0.02;
    double reach = this->reach_u(way.norm(), stiffness * way.norm(), this->rest_.force_N.norm());
    for (; reach < farthest_u; reach *= 1.5)
    {
      const std::vector<BallRest> found = this->rests_.near(p_W, this->rest_.x_W + way, reach);
      if (const BallRest* const next = nearestTo(this->rest_.force_N, found))
      {
        this->rest_ = *next;
        return;
      }
    }
    FAIL() << "no place of rest";
  }

  BallRests rests_;
  const SoftScene& scene_;
  FollowedForce force_;
  BallRest rest_;
  double most_ = 0.0; ///< compliance of a patch in any direction
};

/// One slide: every step judged, and their number.
void expectStepsOfTheLaw(const Bumps& bumps)
{
  SoftScene s(padOf(bumps), bumps.radius);
  FollowedForce felt{ handAt(bumps, 0) };
  OracleBall own(s, felt.hand_W);
  Vec3 xBefore = felt.hand_W;
  for (int tick = 0; tick < ticksOfSlide; ++tick)
  {
    const Vec3 p = handAt(bumps, tick);
    const Vec3 way = p - felt.hand_W, before_N = felt.force_N;
    const Vec3 f = s.move(p).force_N;
    const double allowed_N = felt.allowed_N(p, f);
    own.follow(p);
    if (felt.goTo(p, f))
    {
      const double reach = own.reach_u(way.norm(), allowed_N, before_N.norm());
      const std::vector<BallRest> near = own.rests().near(p, xBefore + way, reach);
      const BallRest* const nearest = nearestTo(before_N, near);
      EXPECT_TRUE(nearest == nullptr || (nearest->force_N - before_N).norm() > allowed_N) << tick;
      const std::vector<BallRest> here = own.rests().near(p, s.state.core.x_W, 1e-5);
      const BallRest* const found = nearestTo(f, here);
      ASSERT_NE(found, nullptr) << tick << ": it is not at rest";
      EXPECT_LE((found->force_N - f).norm(), 1e-6 * f.norm()) << tick << ": it is not at rest";
    }
    xBefore = s.state.core.x_W;
  }
  EXPECT_LE(felt.steps, own.steps()) << bumps.young_Pa << " " << bumps.height << " " << bumps.radius;
}

TEST(SoftBumps, ABallWithoutFrictionHoweverDeepStepsOnlyWhereNoPlaceOfRestIsNearer)
{
  const Bumps softSmall{ 20e3, 0.001, 0.002, 0.0, 191, 0.002 }, hardSmall{ 10e6, 0.001, 0.002, 0.0, 191, 0.002 };
  const Bumps soft{ 20e3, 0.001, 0.005, 0.0, 191, 0.00375 }, hard{ 10e6, 0.001, 0.005, 0.0, 191, 0.00375 };
  const Bumps softOther{ 20e3, 0.001, 0.005, 0.0, 192, 0.00375 }, hardOther{ 10e6, 0.001, 0.005, 0.0, 192, 0.00375 };
  const Bumps high{ 20e3, 0.002, 0.002, 0.0, 191, 0.002 };
  for (const Bumps& bumps :
    casesOf<Bumps>({ softSmall, hardSmall, soft, hard, softOther, hardOther, high }, { softSmall, hard, high }))
  {
    expectStepsOfTheLaw(bumps);
  }
}

/// How much more a surface gives along itself than into itself, of all that it and the coupling give: the most of it.
double moreAcross(const SoftScene& s)
{
  double most = 0.0;
  for (const std::uint32_t v : s.snapshot->near)
  {
    const Mat3 own = s.snapshot->between(v, v);
    const double across = own.topLeftCorner<2, 2>().selfadjointView<Eigen::Lower>().eigenvalues().maxCoeff();
    most = std::max(most, (across - own(2, 2)) / (own(2, 2) + 1.0 / stiffness));
  }
  return most;
}

/// How deep a ball may go that rolls over every edge without a step. On an edge let the hand be h above it, and the
/// ball d = r - h cos(a) deep along the normal, at an angle a from the hand's path to the edge. The energy is E = d^2 /
/// 2 c, c the compliance of surface and coupling along the normal. E is least at a = 0 while h > d (c' - c) / c, c'
/// being c across: nearer, the ball snaps over the edge by the constraints themselves. Under friction it slides by h
/// sin(a) = mu d, at every angle only while h > r sin(atan(mu)). The bumps are 1 mm high, and 1.5 mm are to spare: 30
/// times the hand's displacement in a tick, by which the force then turns a thirtieth.
double depthWithoutSteps(const SoftScene& s, double radius, double friction)
{
  const double more = moreAcross(s), sticks = friction / std::sqrt(1.0 + friction * friction);
  return (radius * (1.0 - sticks) - 0.0025 - more * 0.001) / (1.0 + more);
}

TEST(SoftBumps, ABallOfWhichTheHandStaysHighEnoughOverItsEdgesNeverSteps)
{
  std::size_t slides = 0;
  for (const std::uint64_t seed : seedsOfSlides())
  {
    for (const double young_Pa : { 20e3, 10e6 })
    {
      for (const double radius : { 0.005, 0.008, 0.012 })
      {
        SoftScene s(padOf({ young_Pa, 0.001, radius, 0.0, seed }), radius);
        for (const double friction : { 0.0, 0.3, 0.8 })
        {
          const Bumps bumps{ young_Pa, 0.001, radius, friction, seed, depthWithoutSteps(s, radius, friction) };
          if (bumps.depth < 0.0002) // so large a ball that it would have to stay outside
          {
            continue;
          }
          ++slides;
          s.plan.friction = { friction, friction };
          s.state = {};
          Vec3 before_N = Vec3::Zero(), handBefore = handAt(bumps, 0);
          for (int tick = 0; tick < ticksOfSlide; ++tick)
          {
            const Vec3 p = handAt(bumps, tick);
            const SoftResult found = s.move(p);
            EXPECT_LE((found.force_N - before_N).norm(), stepAllowed_N(p - handBefore, before_N, found.force_N))
              << tick << " " << young_Pa << " " << radius << " " << friction << " " << found.loops;
            before_N = found.force_N;
            handBefore = p;
          }
        }
      }
    }
  }
  EXPECT_GE(slides, seedsOfSlides().size() * 2 * 7);
}

} // namespace
} // namespace palpate::test
