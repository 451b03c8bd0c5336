// SPDX-License-Identifier: GPL-3.0-or-later
// Row 18: force shading over the facets of a smooth body, and none where edges are meant.
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "haptics/contact/view/SceneView.h"
#include "testing/support/Meshes.h"
#include "testing/support/Probe.h"
#include "testing/support/Random.h"

namespace palpate
{
namespace
{

constexpr double R = 50.0, depth = 1.0; // mm
constexpr int ticks = 20000;
constexpr double degree = std::numbers::pi / 180.0;

double angle(const Vec3& a, const Vec3& b)
{
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Once round a great circle 1 mm below the true sphere.
std::vector<Vec3> circle(double distance, int count)
{
  const Vec3 u = Vec3(0.3, 0.5, 0.8).normalized(), v = u.unitOrthogonal();
  std::vector<Vec3> path_W;
  for (int i = 0; i <= count; ++i)
  {
    const double a = 2 * std::numbers::pi * i / count;
    path_W.push_back(distance * (std::cos(a) * u + std::sin(a) * v));
  }
  return path_W;
}

struct Rub
{
  double off = 0.0;  ///< largest angle between the force and the radius [rad]
  double jump = 0.0; ///< largest turn of the force from tick to tick beyond that of the radius [rad]
  double work = 0.0; ///< done on the hand over the closed path, for 1 N/mm [N mm]
};

Rub rub(const TriangleMesh& mesh, double radius, bool shading)
{
  const std::vector<Vec3> path_W = circle(R + radius - depth, ticks);
  test::Probe probe(test::sceneOf(mesh), radius, 1.2 * path_W[0]);
  probe.plan().shading = shading;
  probe.to(path_W[0]);
  Rub seen;
  Vec3 before = probe.force(1.0);
  for (std::size_t i = 1; i < path_W.size(); ++i)
  {
    probe.to(path_W[i]);
    const Vec3 force = probe.force(1.0);
    seen.off = std::max(seen.off, angle(force, path_W[i]));
    seen.jump = std::max(seen.jump, angle(force, before) - angle(path_W[i], path_W[i - 1]));
    seen.work += 0.5 * (force + before).dot(path_W[i] - path_W[i - 1]);
    before = force;
  }
  return seen;
}

TEST(Shading, OfAPointOnAFacetedSphereIsRadialEverywhere)
{
  const Rub seen = rub(test::makeIcosphere(3, R), 0.0, true);
  // A round leaves d / R of a step, and where it ends over an edge half of the turn there, of at most 5.75 degrees.
  const double step = 2 * std::numbers::pi * (R - depth) / ticks;
  const double left = step * std::pow(depth / R + 0.5 * 5.75 * degree, 4);
  EXPECT_LT(seen.off, left / depth);
  EXPECT_LT(seen.jump, 2 * left / depth);
}

TEST(Shading, OfABallOnAFacetedSphereTurnsWithoutJumps)
{
  const double radius = 1.0;
  const Rub seen = rub(test::makeIcosphere(3, R), radius, true);
  // The ball's centre stands over its foot along the facet's normal, at most 5.46 degrees off the smooth one.
  EXPECT_LT(seen.off, radius * 5.46 * degree / (R + radius - depth));
  EXPECT_LT(seen.jump, 0.2 * degree);
}

TEST(Shading, WithoutItTheForceJumpsFromFacetToFacet)
{
  EXPECT_GT(rub(test::makeIcosphere(3, R), 0.0, false).jump, 5.0 * degree);
}

TEST(Shading, GivesOrTakesLittleOverAClosedWay)
{
  for (const double radius : { 0.0, 1.0 })
  {
    EXPECT_LT(std::abs(rub(test::makeIcosphere(3, R), radius, true).work), 0.01 * 0.5 * depth * depth) << radius;
  }
}

TEST(Shading, DoesNotDependOnHowFacesAreTurnedOrOrdered)
{
  test::Random random(test::testSeed(511));
  const TriangleMesh mesh = test::makeIcosphere(2, R);
  TriangleMesh other = mesh;
  for (auto& t : other.triangles)
  {
    if (random.uniform() < 0.5)
    {
      std::swap(t[0], t[1]);
    }
  }
  std::reverse(other.triangles.begin(), other.triangles.end());
  test::Probe one(test::sceneOf(mesh), 0.0, { 0, 0, 60 }), two(test::sceneOf(other), 0.0, { 0, 0, 60 });
  one.plan().shading = two.plan().shading = true;
  for (const Vec3& p_W : circle(R - depth, 500))
  {
    one.to(p_W);
    two.to(p_W);
    ASSERT_EQ(one.x_W(), two.x_W());
  }
}

TEST(Shading, NeverReachesAcrossAnEdgeThatIsMeant)
{
  const auto scene = test::sceneOf(test::makeBox({ -20, -20, -20 }, { 20, 20, 20 }));
  test::Random random(test::testSeed(512));
  for (const double radius : { 0.0, 1.0 })
  {
    test::Probe plain(scene, radius, { 0, 0, 30 }), shaded(scene, radius, { 0, 0, 30 });
    shaded.plan().shading = true;
    Vec3 p_W(0, 0, 20 + radius - depth);
    for (int i = 0; i < 2000; ++i)
    {
      p_W += 0.3 * random.direction();
      p_W.z() = 20 + radius - depth;
      plain.to(p_W);
      shaded.to(p_W);
      ASSERT_LT((plain.x_W() - shaded.x_W()).norm(), 1e-9) << i;
    }
  }
}

TEST(Shading, IsTheSameOnASurfaceThatIsTurned)
{
  const TriangleMesh mesh = test::makeIcosphere(2, R);
  const Quat turn(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()));
  Surface surface = test::sceneOf(mesh)->surfaces()[0];
  surface.motion.begin_WS = surface.motion.end_WS = { Vec3::Zero(), turn };
  const auto turned = std::make_shared<const Scene>(2, std::vector<Surface>{ surface });
  test::Probe plain(test::sceneOf(mesh), 0.0, { 0, 0, 60 }), posed(turned, 0.0, turn * Vec3(0, 0, 60));
  plain.plan().shading = posed.plan().shading = true;
  for (const Vec3& p_W : circle(R - depth, 500))
  {
    plain.to(p_W);
    posed.to(turn * p_W);
    ASSERT_LT((turn * plain.x_W() - posed.x_W()).norm(), 1e-11 * R);
  }
}

TEST(Shading, LetsFrictionHoldTheHandWhereItIs)
{
  test::Probe probe(test::sceneOf(test::makeIcosphere(3, R)), 0.0, { 0, 0, 60 });
  probe.plan().shading = true;
  probe.plan().friction = { 0.5, 0.3 };
  const Vec3 in = Vec3(0.3, 0.5, 0.8).normalized();
  probe.to(60 * in);
  probe.to((R - depth) * in);
  probe.along((R - depth) * in, 50); // comes to rest
  const Vec3 x_W = probe.x_W();
  const Vec3 aside = in.unitOrthogonal();
  for (int i = 0; i < 1000; ++i)
  {
    const ContactResult result = probe.to((R - depth) * in + 0.3 * depth * std::sin(0.1 * i) * aside);
    ASSERT_EQ(result.friction, FrictionState::Sticks);
    ASSERT_EQ(probe.x_W(), x_W);
  }
}

} // namespace
} // namespace palpate
