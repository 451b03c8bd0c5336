// SPDX-License-Identifier: GPL-3.0-or-later
// A ball slides over bumps that give way. What it feels is judged from the triangles and the packet alone.
#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "SoftScenes.h"
#include "testing/support/Random.h"

namespace palpate::test
{
namespace
{

constexpr double stiffness = 1000.0;

/// What is slid over, and with what.
struct Bumps
{
  double young_Pa = 20e3;
  double height = 0.001; ///< of its vertices at random, up and down [m]
  double radius = 0.0;
  double friction = 0.0;
};

SoftPad padOf(const Bumps& bumps)
{
  Random random(testSeed(191));
  return SoftPad(16, patchEdges, ElementKind::EdgeSmoothed,
    [&](SoftBodyInput& input)
    {
      input.young_Pa = { bumps.young_Pa };
      for (Vec3& p : input.mesh.vertices_W)
      {
        p.z() += std::abs(p.z() - 0.05) < 1e-9 ? bumps.height * random.uniform(-1.0, 1.0) : 0.0;
      }
    });
}

/// A slide of 50 mm/s in ticks of 1 ms, as deep in the soft as in the stiff one.
Vec3 handAt(const Bumps& bumps, int tick)
{
  const double depth = bumps.young_Pa < 1e6 ? 0.006 : 0.0015;
  const double down = std::min(1.0, tick / 100.0);
  return { 0.013 + 5e-5 * tick, 0.0513 + 0.01 * std::sin(0.003 * tick), 0.054 + bumps.radius - down * (depth + 0.004) };
}

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
      const double up = n.z() > 0.0 ? 1.0 : -1.0; // whichever way its corners run
      found.push_back({ up * n, up * n.dot(x - a) });
    }
  }
  return found;
}

/// How the surface yields at a place: the mean of what its triangle's corners yield by themselves.
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
      return weights[0] * s.packet->between(t[0], t[0]) + weights[1] * s.packet->between(t[1], t[1]) +
             weights[2] * s.packet->between(t[2], t[2]);
    }
  }
  ADD_FAILURE() << "no face at " << x.transpose();
  return Mat3::Zero();
}

/// How far f is from what one or two of the faces could push with: the least over faces and pairs.
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
      const Eigen::Vector2d push = both.colPivHouseholderQr().solve(f);
      least = push.minCoeff() >= 0.0 ? std::min(least, (f - both * push).norm()) : least;
      for (const NearFace& third : faces)
      {
        Mat3 all;
        all << one.n, other.n, third.n;
        const Vec3 pushes = all.colPivHouseholderQr().solve(f);
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
      if (one && n == faceBefore) // on the face on which it was: what it did over a crease is not judged
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
          for (int tick = 0; tick < 600; ++tick)
          {
            const Vec3 p = handAt(bumps, tick);
            const SoftResult found = s.move(p);
            atALimit += found.capped || found.overBudget || found.core.capped || found.core.infeasible;
            // The numbers that it is the difference of are rounded.
            const double rounding = 4e-16 * stiffness * p.norm();
            EXPECT_LE(
              (found.force_N - stiffness * (found.proxy_W - p)).norm(), 1e-12 * found.force_N.norm() + rounding);
            // The core, which crosses nothing, is where the ball is but for what the surfaces have yielded.
            const Vec3 core_W = s.state.core.x_W + s.state.yielded_W;
            EXPECT_LE(stiffness * (core_W - found.proxy_W).norm(), 1e-5)
              << tick << " " << young_Pa << " " << height << " " << radius << " " << friction;
          }
          EXPECT_EQ(atALimit, 0) << young_Pa << " " << height << " " << radius << " " << friction;
        }
      }
    }
  }
}

} // namespace
} // namespace palpate::test
