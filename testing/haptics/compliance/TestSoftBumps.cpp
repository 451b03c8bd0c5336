// SPDX-License-Identifier: GPL-3.0-or-later
// A ball slides over bumps that yield. The force is judged from the triangles and the snapshot alone.
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "BumpySlide.h"
#include "haptics/contact/GodObject.h"
#include "testing/support/Linear.h"

namespace palpate::test
{
namespace
{

using namespace slide;

/// A triangle that a point may lie on.
struct NearFace
{
  Vec3 n = Vec3::Zero();
  double off_u = 0.0; ///< of the point from its plane, above it > 0
};

/// All whose points are within `reach` of x but for their plane.
std::vector<NearFace> facesAt(const SoftScene& s, const Vec3& x, double reach)
{
  std::vector<NearFace> found;
  for (const auto& t : s.pad.surface.triangles)
  {
    const Vec3& a = s.pad.surface.rest_W[t[0]];
    const Vec3& b = s.pad.surface.rest_W[t[1]];
    const Vec3& c = s.pad.surface.rest_W[t[2]];
    const Vec3 n = (b - a).cross(c - a).normalized();
    const auto within = [&](const Vec3& from, const Vec3& to)
    { return (to - from).normalized().cross(x - from).dot(n) > -reach; };
    if (std::abs(n.z()) > 0.5 && x.z() > 0.03 && std::abs(n.dot(x - a)) < 1e-5 && within(a, b) && within(b, c) &&
        within(c, a))
    {
      const double up = n.z() > 0.0 ? 1.0 : -1.0; // in either order of its corners
      found.push_back({ up * n, up * n.dot(x - a) });
    }
  }
  return found;
}

/// The surface's compliance at a place: the mean of those of its triangle's corners by themselves.
Mat3 complianceAt(const SoftScene& s, const Vec3& x)
{
  for (const auto& t : s.pad.surface.triangles)
  {
    const Vec3& a = s.pad.surface.rest_W[t[0]];
    const Vec3& b = s.pad.surface.rest_W[t[1]];
    const Vec3& c = s.pad.surface.rest_W[t[2]];
    const Vec3 n = (b - a).cross(c - a);
    const Vec3 weights =
      Vec3((c - b).cross(x - b).dot(n), (a - c).cross(x - c).dot(n), (b - a).cross(x - a).dot(n)) / n.squaredNorm();
    if (std::abs(n.normalized().dot(x - a)) < 1e-6 && weights.minCoeff() > -1e-9)
    {
      return weights[0] * s.snapshot->between(t[0], t[0]) + weights[1] * s.snapshot->between(t[1], t[1]) +
             weights[2] * s.snapshot->between(t[2], t[2]);
    }
  }
  ADD_FAILURE() << "no face at " << x.transpose();
  return Mat3::Zero();
}

/// How far f is from the cone of some of the faces: the least over faces, pairs and triples.
double outsideCone(const Vec3& f, const std::vector<NearFace>& faces)
{
  double least = f.norm();
  for (const NearFace& one : faces)
  {
    least = std::min(least, (f - std::max(0.0, f.dot(one.n)) * one.n).norm());
    for (const NearFace& other : faces)
    {
      Eigen::Matrix<double, 3, 2> both;
      both << one.n, other.n;
      const Eigen::Vector2d push = test::solved(both, f);
      least = push.minCoeff() >= 0.0 ? std::min(least, (f - both * push).norm()) : least;
      for (const NearFace& third : faces)
      {
        Mat3 all;
        all << one.n, other.n, third.n;
        const Vec3 pushes = test::solved(all, f);
        least = pushes.minCoeff() >= 0.0 ? std::min(least, (f - all * pushes).norm()) : least;
      }
    }
  }
  return least;
}

TEST(SoftBumps, APointWithoutFrictionRestsOnTheSurfaceAndIsPushedByFacesThatItLiesOn)
{
  for (const Bumps& bumps : { Bumps{}, Bumps{ 10e6 }, Bumps{ 20e3, 0.002 } })
  {
    SoftScene s(padOf(bumps), 0.0);
    int pressed = 0;
    int creases = 0;
    for (int tick = 0; tick < 600; ++tick)
    {
      const Vec3 p = handAt(bumps, tick);
      const Vec3 f = s.move(p).force_N;
      if (f.norm() < 1e-3)
      {
        continue;
      }
      ++pressed;
      // Whatever the core did: the force says where in the material the point is, and that is all that is judged.
      Vec3 x = s.state.core.x_W;
      x = p + f / stiffness + complianceAt(s, x) * f;
      const std::vector<NearFace> faces = facesAt(s, x, 1e-7);
      ASSERT_FALSE(faces.empty()) << tick;
      for (const NearFace& face : faces)
      {
        EXPECT_LE(std::abs(face.off_u), 1e-8) << tick;
      }
      EXPECT_LE(outsideCone(f, faces), 1e-5 * f.norm()) << tick;
      creases += faces.size() > 1;
    }
    EXPECT_GT(pressed, 400);
    EXPECT_GT(creases, 10);
  }
}

TEST(SoftBumps, UnderFrictionAPointSlidesOnlyOnTheConeAndAgainstTheForce)
{
  for (const double friction : { 0.3, 0.8 })
  {
    const Bumps bumps{ 20e3, 0.001, 0.0, friction };
    SoftScene s(padOf(bumps), 0.0);
    s.plan.friction = { friction, friction };
    Vec3 before = Vec3::Constant(std::nan(""));
    Vec3 faceBefore = Vec3::Zero();
    int slid = 0;
    int stuck = 0;
    for (int tick = 0; tick < 600; ++tick)
    {
      const Vec3 p = handAt(bumps, tick);
      const Vec3 f = s.move(p).force_N;
      if (f.norm() < 0.01)
      {
        faceBefore = Vec3::Zero();
        continue;
      }
      const Vec3 x = p + f / stiffness + complianceAt(s, s.state.core.x_W) * f;
      const std::vector<NearFace> faces = facesAt(s, x, 1e-7);
      const bool one = faces.size() == 1;
      const Vec3 n = one ? faces.front().n : Vec3(Vec3::Zero());
      if (one && n == faceBefore) // on the same face as before: motion over a crease is not judged
      {
        const double push = n.dot(f);
        const Vec3 across = f - push * n;
        const Vec3 way = x - before;
        EXPECT_LE(across.norm(), friction * push * (1.0 + 1e-9)) << tick;
        const bool slides = way.norm() > 1e-8;
        slides ? ++slid : ++stuck;
        if (slides)
        {
          EXPECT_NEAR(across.norm(), friction * push, 1e-5 * push) << tick;
          EXPECT_LE((across.normalized() + way.normalized()).norm(), 1e-3) << tick;
        }
      }
      before = x;
      faceBefore = n;
    }
    EXPECT_GT(slid, 200);
    EXPECT_GT(stuck, 20);
  }
}

TEST(SoftBumps, TheForceIsTheCouplingTimesTheWayToTheBallAndNoTickEndsAtALimit)
{
  for (const double young_Pa : { 20e3, 10e6 })
  {
    for (const double height : { 0.001, 0.002 })
    {
      for (const double radius : { 0.0, 0.002, 0.005 })
      {
        SoftScene s(padOf({ young_Pa, height, radius, 0.0 }), radius);
        for (const double friction : { 0.0, 0.3, 0.8 })
        {
          const Bumps bumps{ young_Pa, height, radius, friction };
          s.plan.friction = { friction, friction };
          s.state = {};
          int atALimit = 0;
          std::vector<std::uint32_t> work;
          for (int tick = 0; tick < 600; ++tick)
          {
            const Vec3 p = handAt(bumps, tick);
            const SoftResult found = s.move(p);
            work.push_back(found.work);
            atALimit += found.capped || found.overBudget || found.core.capped || found.core.infeasible;
            // The numbers that it is the difference of are rounded.
            const double rounding = 4e-16 * stiffness * p.norm();
            EXPECT_LE(
              (found.force_N - stiffness * (found.proxy_W - p)).norm(), 1e-12 * found.force_N.norm() + rounding);
            // The core, which crosses nothing, is where the ball is but for the displacement of the surfaces.
            const Vec3 core_W = s.state.core.x_W + s.state.yielded_W;
            EXPECT_LE(stiffness * (core_W - found.proxy_W).norm(), 1e-5)
              << tick << " " << young_Pa << " " << height << " " << radius << " " << friction;
          }
          // In units of 20 ns (ContactPlan::workBudget). Every tick ends within its period of 1 ms and leaves two
          // fifths of it to the other stages. Of a hundred, 99 end within the 150 us that a tick among bodies may take;
          // over bumps of 2 mm, within a quarter of the period, so that a machine four times as slow still keeps up.
          constexpr double unit_s = 20e-9, period_s = 1e-3;
          std::ranges::sort(work);
          EXPECT_LE(unit_s * work[work.size() * 99 / 100], height > 0.001 ? 0.25 * period_s : 150e-6);
          EXPECT_LE(unit_s * work.back(), 0.6 * period_s);
          EXPECT_EQ(atALimit, 0) << young_Pa << " " << height << " " << radius << " " << friction;
        }
      }
    }
  }
}

/// Feature and multiplier of the one face that holds a rigid point; null: none or several.
const ActivePlane* oneFaceOf(const ContactResult& rigid)
{
  return rigid.heldCount == 1 && rigid.held[0].feature.kind == FeatureKind::Face ? &rigid.held[0] : nullptr;
}

/// The one face that holds a point.
const SoftContact* oneFaceOf(const SoftState& soft)
{
  const SoftContact* found = nullptr;
  for (int c = 0; c < soft.count; ++c)
  {
    if (soft.contacts[c].force_N.norm() > 0.0)
    {
      if (found != nullptr)
      {
        return nullptr;
      }
      found = &soft.contacts[c];
    }
  }
  return found != nullptr && found->feature.kind == FeatureKind::Face ? found : nullptr;
}

/// How far apart one step and many come of a hand that goes `way_u` while friction slips at the force R = mu N: a step
/// projects the force into the cone once. While R turns the angle t to the hand's displacement s as tan(t / 2) exp(-q),
/// q = K s / R, one step leaves tan(t) = sin / (cos + q). They differ by q^2 sin cos / 2 at most, so by R q^2 / 4 of
/// the force; as much again for an R that changes by mu K s.
double pathWithinTick_N(double way_u, double friction, double normal_N)
{
  const double goes_N = stiffness * way_u;
  return friction > 0.0 ? 0.25 * (1.0 + friction * friction) * goes_N * goes_N / (friction * normal_N) : 0.0;
}

/// Turns after which a tick is gone through again in parts.
constexpr int turnsAtOnce = 8;

TEST(SoftBumps, AsHardAsSteelTheyAreFeltAsRigidOnesButForWhereInItsConeFrictionHoldsThePoint)
{
  for (const double friction : { 0.0, 0.3, 0.8 })
  {
    const Bumps bumps{ 9e11, 0.001, 0.0, friction };
    SoftScene s(padOf(bumps), 0.0);
    s.plan.friction = { friction, friction };
    s.plan.coupling_N_per_m = stiffness;
    GodObjectState rigid;
    std::uint32_t faceBefore = 0;
    double apartBefore_N = 0.0;
    Vec3 handBefore = handAt(bumps, 0);
    int compared = 0, apart = 0;
    for (int tick = 0; tick < ticksOfSlide; ++tick)
    {
      const Vec3 p = handAt(bumps, tick);
      const double way_u = (p - std::exchange(handBefore, p)).norm();
      const SoftResult soft = s.move(p);
      const ContactResult hard = moveGodObject(s.scene, s.plan, p, rigid);
      const Vec3 hard_N = stiffness * hard.pull_W;
      const ActivePlane* const face = oneFaceOf(hard);
      const SoftContact* const own = oneFaceOf(s.state);
      if (face == nullptr || own == nullptr || face->feature.a != own->feature.a)
      {
        faceBefore = 0;
        continue;
      }
      ++compared;
      // On one face the hand's depth below it is the normal force, wherever on it friction holds the point.
      const double normal_N = own->n.dot(hard_N);
      EXPECT_NEAR(own->n.dot(soft.force_N), normal_N, 1e-6 * normal_N) << tick;
      EXPECT_LE((hard_N - normal_N * own->n).norm(), friction * normal_N * (1.0 + 1e-9) + 1e-12) << tick;
      // Where it is in the cone came about where they went over an edge. Along the face each step projects both into
      // one cone, by which they only come nearer, but for a tick that one of them goes through in parts.
      const double apart_N = (hard_N - soft.force_N).norm();
      apart += apart_N > 1e-6 * normal_N;
      if (face->feature.a + 1 == faceBefore)
      {
        const double parts_N = soft.loops < turnsAtOnce ? 0.0 : pathWithinTick_N(way_u, friction, normal_N);
        EXPECT_LE(apart_N, apartBefore_N + 1e-6 * normal_N + parts_N) << tick;
      }
      EXPECT_TRUE(friction > 0.0 || apart_N <= 1e-6 * normal_N) << tick;
      faceBefore = face->feature.a + 1;
      apartBefore_N = apart_N;
    }
    EXPECT_GT(compared, ticksOfSlide / 2);
    EXPECT_EQ(apart > 0, friction > 0.0);
  }
}

} // namespace
} // namespace palpate::test
