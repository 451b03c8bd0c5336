// SPDX-License-Identifier: GPL-3.0-or-later
// Rows 21, 22 and 25: surfaces that come at the hand, close on it or turn under it are never passed.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <ostream>

#include <gtest/gtest.h>

#include "testing/support/Meshes.h"
#include "testing/support/Random.h"
#include "testing/support/Stage.h"

namespace palpate
{
namespace
{

constexpr double K = 1000.0, T = 1e-3; // scenes in metres

using test::Actor;
using test::Stage;

TriangleMesh plate(std::uint64_t seed)
{
  test::Random random(test::testSeed(seed));
  return test::makeSheet({ 0.4, 0.4, 12, 12, 0.3 }, random);
}

struct Ball
{
  double radius;
  FrictionPlan friction = {};
};

void PrintTo(const Ball& ball, std::ostream* out)
{
  *out << "r=" << ball.radius << " mu=" << ball.friction.statical << ',' << ball.friction.kinetic;
}

class MovingSurfaces : public testing::TestWithParam<Ball>
{
protected:
  [[nodiscard]] static ContactPlan plan()
  {
    ContactPlan plan;
    plan.radius_u = GetParam().radius;
    plan.friction = GetParam().friction;
    return plan;
  }
};

TEST_P(MovingSurfaces, APlatformThatComesAtAHandCarriesTheProxyBeforeIt)
{
  const double radius = GetParam().radius;
  for (const double speed : { 0.01, 0.5, 5.0, -0.5, -5.0 })
  {
    Stage stage;
    const double start = speed > 0 ? -0.02 : 0.02;
    stage.add(plate(101), [&](double t) { return Pose{ { 0, 0, start + speed * t }, Quat::Identity() }; });
    Actor actor(stage, plan(), Vec3::Zero());
    const int ticks = std::min(400, static_cast<int>(0.05 / std::abs(speed) / T));
    const double side = speed > 0 ? 1.0 : -1.0;
    for (int i = 1; i <= ticks; ++i)
    {
      actor.tick(Vec3::Zero());
      const double before = side * actor.pose(0).p.z() + radius; // where the plate pushes the centre to
      const double expected = K * std::max(0.0, before);
      ASSERT_NEAR(K * side * actor.state.x_W.z(), expected, 1e-9) << speed << " m/s, tick " << i;
      ASSERT_LE(actor.state.x_W.head<2>().norm(), 1e-9);
    }
  }
}

TEST_P(MovingSurfaces, PlatesThatCloseLikeScissorsPushItOutAlongTheirBisectorOrPinIt)
{
  const double radius = GetParam().radius;
  // Two plates hinged on the y axis at x = -0.2, closing on a hand at the origin from +-40 degrees.
  Stage stage;
  const Vec3 hinge(-0.2, 0, 0);
  const auto blade = [&](double sign)
  {
    return [=](double t)
    {
      const double angle = sign * (40.0 - 200.0 * t) * std::numbers::pi / 180;
      const Quat q(Eigen::AngleAxisd(std::max(0.0, std::abs(angle)) * (angle < 0 ? -1 : 1), Vec3::UnitY()));
      return Pose{ hinge - q * hinge, q };
    };
  };
  stage.add(plate(102), blade(1.0));
  stage.add(plate(103), blade(-1.0));
  Actor actor(stage, plan(), { 0.0, 0.0, 0.0 });
  const double first = actor.inSurface(0).z(), second = actor.inSurface(1).z();
  for (int i = 0; i < 190; ++i) // to 2 degrees
  {
    actor.tick(Vec3::Zero());
    const double roundOff = 1e-12;
    ASSERT_GT(actor.inSurface(0).z() * (first > 0 ? 1 : -1), -roundOff) << "tick " << i;
    ASSERT_GT(actor.inSurface(1).z() * (second > 0 ? 1 : -1), -roundOff) << "tick " << i;
    ASSERT_TRUE(actor.state.x_W.allFinite());
    if (!actor.carry.pinned)
    {
      ASSERT_GT(std::abs(actor.inSurface(0).z()), radius - 1e-9) << "tick " << i;
      ASSERT_GT(std::abs(actor.inSurface(1).z()), radius - 1e-9) << "tick " << i;
      ASSERT_NEAR(actor.state.x_W.z(), 0.0, 1e-9); // the bisector
    }
  }
}

TEST_P(MovingSurfaces, ATumblingShellKeepsWhatIsInItAndWhatIsOutside)
{
  const double radius = GetParam().radius, R = 0.05;
  const TriangleMesh shell = test::makeIcosphere(2, R);
  double inner = R;
  for (const auto& t : shell.triangles)
  {
    const Vec3 a = shell.vertices_W[t[0]], b = shell.vertices_W[t[1]], c = shell.vertices_W[t[2]];
    inner = std::min(inner, std::abs((b - a).cross(c - a).normalized().dot(a)));
  }
  for (const bool inside : { true, false })
  {
    Stage stage;
    stage.add(shell,
      [](double t)
      {
        const Vec3 centre(0.06 * std::sin(31 * t), 0.05 * std::sin(23 * t + 1), 0.06 * std::sin(17 * t));
        return Pose{ centre, Quat(Eigen::AngleAxisd(20 * t, Vec3(1, 2, 3).normalized())) };
      });
    test::Random random(test::testSeed(104));
    const Vec3 start = inside ? stage.pose(0, 0.0).p : Vec3(0, 0.04, 0.3);
    Actor actor(stage, plan(), start);
    for (std::size_t i = 0; i < test::testCount(2000); ++i)
    {
      actor.tick(0.05 * random.direction());
      const double r = actor.inSurface(0).norm();
      if (inside)
      {
        ASSERT_LT(r, R + 1e-12) << "tick " << i;
      }
      else
      {
        ASSERT_GT(r, inner + (radius > 0 ? 0.5 * radius : 0.0) - 1e-12) << "tick " << i;
      }
    }
  }
}

TEST_P(MovingSurfaces, AStillPoseIsFeltLikeTheSameMeshTurnedThere)
{
  test::Random random(test::testSeed(105));
  const TriangleMesh rough = test::makeIcosphere(3, 0.05);
  const Quat q(Eigen::AngleAxisd(1.1, Vec3(3, -1, 2).normalized()));
  const Vec3 shift(0.02, -0.01, 0.03);
  Stage stage;
  stage.add(rough, [&](double) { return Pose{ shift, q }; });
  const auto turned = test::sceneOf(test::shifted(test::rotated(rough, q), shift));
  const Vec3 start = shift + Vec3(0, 0, 0.1);
  Actor actor(stage, plan(), start);
  GodObjectState state;
  static_cast<void>(moveGodObject(*turned, plan(), start, state));
  Vec3 p = start;
  for (std::size_t i = 0; i < test::testCount(1000); ++i)
  {
    p = shift + 0.047 * (p - shift + random.direction() * 3e-3).normalized(); // 3 mm deep: one place is nearest
    const ContactResult a = actor.tick(p), b = moveGodObject(*turned, plan(), p, state);
    ASSERT_LE((a.proxy_W - b.proxy_W).norm(), 1e-9) << "tick " << i;
  }
}

TEST_P(MovingSurfaces, ATurntableDragsTheHandWithKineticFrictionAtAnySpeed)
{
  const double radius = GetParam().radius, d = 2e-3, mu_k = GetParam().friction.kinetic;
  for (const double speed : { 0.01, 0.3, 1.0 })
  {
    Stage stage;
    stage.add(plate(106), [&](double t) { return Pose{ { speed * t - 0.1, 0, 0 }, Quat::Identity() }; });
    Actor actor(stage, plan(), { 0, 0, 0.01 + radius });
    const Vec3 p(0, 0, radius - d);
    bool slips = false;
    for (int i = 1; i <= 150; ++i)
    {
      const Vec3 before = actor.state.x_W;
      const ContactResult result = actor.tick(p);
      const Vec3 force = K * (actor.state.x_W - p);
      if (result.friction == FrictionState::Slips && slips)
      {
        // Along the motion of the plate, mu_k F_n whatever its speed; the plate never gets work out of it.
        ASSERT_NEAR(force.x(), mu_k * K * d, 1e-6) << speed << ", tick " << i;
        ASSERT_NEAR(force.z(), K * d, 1e-9);
        const double slipOfPlate = speed * T - (actor.state.x_W - before).x();
        ASSERT_GE(force.x() * slipOfPlate, 0.0);
      }
      slips = result.friction == FrictionState::Slips;
    }
    EXPECT_EQ(slips, mu_k > 0.0) << speed;
    EXPECT_NEAR(K * actor.state.x_W.x(), mu_k * K * d, 1e-6) << speed;
  }
}

INSTANTIATE_TEST_SUITE_P(PointAndBall, MovingSurfaces,
  testing::Values(Ball{ 0.0 }, Ball{ 1e-3 }, Ball{ 0.0, { 0.5, 0.3 } }, Ball{ 1e-3, { 0.5, 0.3 } }));

} // namespace
} // namespace palpate
