// SPDX-License-Identifier: GPL-3.0-or-later
// A scene that is a part of a whole: within it the force is that of the whole, beyond it there is none.
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include <gtest/gtest.h>

#include "haptics/tick/ForceRenderer.h"
#include "testing/haptics/tick/stages/Tick.h"
#include "testing/support/Meshes.h"
#include "testing/support/NoisySphere.h"

namespace palpate
{
namespace
{

using test::dt_s;

constexpr double stiffness_N_per_m = 500.0, scale_u_per_m = 1000.0;

/// All triangles that reach into a box, as a server cuts them.
TriangleMesh partOf(const TriangleMesh& whole, const Vec3& centre_W, double reach_u)
{
  TriangleMesh part;
  part.vertices_W = whole.vertices_W;
  for (const auto& t : whole.triangles)
  {
    const Vec3 &a = whole.vertices_W[t[0]], &b = whole.vertices_W[t[1]], &c = whole.vertices_W[t[2]];
    const Vec3 low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
    if (((low - centre_W).array() <= reach_u).all() && ((high - centre_W).array() >= -reach_u).all())
    {
      part.triangles.push_back(t);
    }
  }
  return part;
}

/// Ticks one after the other, with a scene that is replaced and its known region.
class FarHand
{
public:
  FarHand()
  {
    this->parameters.stiffness_N_per_m = stiffness_N_per_m;
    this->parameters.map.scale_u_per_m = scale_u_per_m;
    this->parameters.safety = SafetyLimits::none();
  }

  void take(std::shared_ptr<const Scene> scene)
  {
    this->before_ = std::move(this->scene_);
    this->scene_ = std::move(scene);
  }

  /// The part within the reach of a place.
  void takePart(const TriangleMesh& whole, const Vec3& centre_W, double reach_u)
  {
    const std::uint64_t was = this->scene_ ? this->scene_->geometryHash() : 0;
    this->take(test::sceneOf(partOf(whole, centre_W, reach_u)));
    this->parameters.known = { this->scene_->geometryHash(), was, centre_W, reach_u };
  }

  TickOutput at(const Vec3& p_W)
  {
    TickInput input;
    input.tick = ++this->tick_;
    input.dt_s = dt_s;
    input.scene = this->scene_.get();
    input.previousScene = this->before_.get();
    input.tool = this->tool ? &*this->tool : nullptr;
    input.sample.time_s = dt_s * static_cast<double>(this->tick_);
    input.sample.pose_D.p = p_W / scale_u_per_m;
    const TickOutput out = renderTick(input, this->parameters, this->state);
    this->before_.reset();
    return out;
  }

  HapticParameters parameters;
  RendererState state;
  std::optional<ToolContacts> tool; ///< in place of the ball

private:
  std::shared_ptr<const Scene> scene_, before_;
  std::uint64_t tick_ = 0;
};

class Surroundings : public ::testing::TestWithParam<double>
{
};

TEST_P(Surroundings, AHandThatIsFollowedByPartsFeelsTheWholeToTheLastDigits)
{
  constexpr double reach_u = 12.0;
  const test::NoisySphere sphere(20000, 1.0);
  FarHand whole, far;
  for (FarHand* hand : { &whole, &far })
  {
    hand->parameters.contact.radius_u = GetParam();
    hand->parameters.contact.friction = { 0.3, 0.2 };
  }
  whole.take(test::sceneOf(sphere.mesh()));
  Vec3 centre_W = test::slideStart_W(sphere);
  far.takePart(sphere.mesh(), centre_W, reach_u);
  static_cast<void>(whole.at(centre_W));
  static_cast<void>(far.at(centre_W));
  int parts = 0, pressed = 0;
  for (std::size_t i = 0; i < 1500; ++i)
  {
    const Vec3 hand_W = test::slideOver(sphere, i).p_W;
    if ((hand_W - centre_W).norm() > 0.4 * reach_u)
    {
      centre_W = hand_W;
      far.takePart(sphere.mesh(), centre_W, reach_u);
      ++parts;
    }
    const TickOutput expected = whole.at(hand_W), found = far.at(hand_W);
    ASSERT_FALSE(found.state.known.beyond) << "tick " << i;
    ASSERT_LE((found.command.wrench_D.force - expected.command.wrench_D.force).norm(), 1e-9) << "tick " << i;
    pressed += expected.state.contacts > 0 ? 1 : 0;
  }
  EXPECT_GT(parts, 20);
  EXPECT_GT(pressed, 1200);
}

INSTANTIATE_TEST_SUITE_P(Radii, Surroundings, ::testing::Values(0.0, 0.7));

/// A sheet of 100 u x 100 u in z = 0, 1 u a cell.
TriangleMesh sheet()
{
  test::Random random(test::testSeed(171));
  return test::makeSheet({ 100, 100, 100, 100, 0.2 }, random);
}

constexpr double depth_u = 1.0, reach_u = 10.0;
const double spring_N = stiffness_N_per_m * depth_u / scale_u_per_m;

TEST(SurroundingsRim, BeyondItTheForceFadesAndTheProxyWaitsWhereAllWasKnown)
{
  const TriangleMesh whole = sheet();
  FarHand hand;
  hand.takePart(whole, Vec3::Zero(), reach_u);
  static_cast<void>(hand.at({ 0.1, 0.2, 3.0 }));
  const TickOutput pressed = hand.at({ 0.1, 0.2, -depth_u });
  EXPECT_NEAR(pressed.command.wrench_D.force.z(), spring_N, 1e-12);
  // Hand and pull are within the region up to |p| + depth = reach.
  const Vec3 beyond_W(9.1, 0.2, -depth_u);
  for (int i = 0; i <= 88; ++i) // to 8.9, from where the proxy is 0.1 u and the depth away
  {
    ASSERT_FALSE(hand.at({ 0.1 + 0.1 * i, 0.2, -depth_u }).state.known.beyond) << "step " << i;
  }
  const Vec3 waits_W = hand.state.contact.x_W;
  const double tau_s = hand.parameters.sceneBlend_s;
  double expected_N = spring_N;
  for (std::uint64_t i = 1; i <= 700; ++i)
  {
    const TickOutput out = hand.at(beyond_W);
    ASSERT_TRUE(out.state.known.beyond);
    ASSERT_EQ(out.state.known.beyondTicks, i);
    ASSERT_EQ(out.state.proxy_W.p, waits_W);
    ASSERT_LE(out.command.wrench_D.force.z(), expected_N * (1.0 + 1e-9)) << "tick " << i;
    expected_N *= tau_s / (tau_s + dt_s);
  }
  EXPECT_LE(hand.at(beyond_W).command.wrench_D.force.norm(), 1e-9);
}

/// A mesh that lies on the sheet above a hand, and touches it where the sheet is nearest.
ToolContacts lyingAt(double x, double toolReach_u, std::uint64_t revision)
{
  ToolContacts set;
  set.held = set.placed = true;
  set.pose_W.p = Vec3(x, 0.2, 0.0);
  set.reach_u = toolReach_u;
  set.revision = revision;
  set.count = 1;
  set.contacts[0] = { Vec3::UnitZ(), Vec3(0, 0, -1), 0.0 };
  return set;
}

TEST(SurroundingsRim, OfAToolThatIsFeltByItsMeshTheForceFadesWhereItReachesBeyondIt)
{
  constexpr double toolReach_u = 2.0;
  FarHand hand;
  hand.takePart(sheet(), Vec3::Zero(), reach_u);
  std::uint64_t revision = 0;
  const auto at = [&](double x)
  {
    hand.tool = lyingAt(x, toolReach_u, ++revision);
    return hand.at({ x, 0.2, -depth_u });
  };
  // All that the tool may touch is within |p| + depth + its reach of the middle.
  const double rim_u = std::sqrt(std::pow(reach_u - depth_u - toolReach_u, 2) - depth_u * depth_u - 0.2 * 0.2);
  for (double x = 0.0; x < rim_u - 1e-9; x += 0.1)
  {
    const TickOutput out = at(x);
    ASSERT_FALSE(out.state.known.beyond) << x;
    ASSERT_NEAR(out.command.wrench_D.force.z(), spring_N, 1e-9) << x;
  }
  const double tau_s = hand.parameters.sceneBlend_s;
  double expected_N = spring_N;
  for (int i = 0; i < 700; ++i)
  {
    const TickOutput out = at(rim_u + 1e-6);
    ASSERT_TRUE(out.state.known.beyond);
    ASSERT_EQ(out.state.contacts, 0);
    ASSERT_LE(out.command.wrench_D.force.z(), expected_N * (1.0 + 1e-9)) << "tick " << i;
    expected_N *= tau_s / (tau_s + dt_s);
  }
  EXPECT_LE(at(rim_u + 1e-6).command.wrench_D.force.norm(), 1e-9);
}

TEST(SurroundingsRim, APartThatHasBothPlacesGoesOnFromWhereTheProxyWaited)
{
  const TriangleMesh whole = sheet();
  FarHand hand;
  hand.takePart(whole, Vec3::Zero(), reach_u);
  static_cast<void>(hand.at({ 0, 0, 3.0 }));
  static_cast<void>(hand.at({ 0, 0, -depth_u }));
  const Vec3 beyond_W(11.0, 0.2, -depth_u);
  EXPECT_TRUE(hand.at(beyond_W).state.known.beyond);
  hand.takePart(whole, beyond_W, 3.0 * reach_u);
  TickOutput out = hand.at(beyond_W);
  EXPECT_FALSE(out.state.known.beyond);
  EXPECT_LE((out.state.proxy_W.p - Vec3(11.0, 0.2, 0.0)).norm(), 1e-9); // on its side, above the hand
  for (int i = 0; i < 1000; ++i)
  {
    out = hand.at(beyond_W);
  }
  EXPECT_NEAR(out.command.wrench_D.force.z(), spring_N, 1e-9);
}

TEST(SurroundingsRim, APartThatCameTooLateHasTheHandBeginAnewWithoutAStep)
{
  const TriangleMesh whole = sheet();
  FarHand hand;
  hand.takePart(whole, Vec3::Zero(), reach_u);
  static_cast<void>(hand.at({ 0, 0, 3.0 }));
  static_cast<void>(hand.at({ 0, 0, -depth_u }));
  const Vec3 away_W(40.0, 0.2, -depth_u);
  for (int i = 0; i < 1000; ++i)
  {
    static_cast<void>(hand.at(away_W));
  }
  hand.takePart(whole, away_W, reach_u); // has the hand, not the proxy
  for (int i = 0; i < 10; ++i)
  {
    const TickOutput out = hand.at(away_W);
    EXPECT_LE(out.command.wrench_D.force.norm(), 1e-9);
    EXPECT_EQ(out.state.known.beyond, i == 0);
  }
  TickOutput below;
  for (int i = 0; i < 1000; ++i)
  {
    below = hand.at({ 40.0, 0.2, depth_u });
  }
  EXPECT_NEAR(below.command.wrench_D.force.z(), -spring_N, 1e-9); // it began on the other side
}

TEST(SurroundingsRim, ARequestWithoutAnAnswerEndsTheForceAndItsAnswerBringsItBack)
{
  const TriangleMesh whole = sheet();
  FarHand hand;
  hand.takePart(whole, Vec3::Zero(), reach_u);
  static_cast<void>(hand.at({ 0, 0, 3.0 }));
  const Vec3 in_W(0, 0, -depth_u);
  hand.parameters.known.asked = 1;
  const auto late = static_cast<int>(std::lround(hand.parameters.knownLate_s / dt_s));
  for (int i = 0; i < late; ++i)
  {
    const TickOutput out = hand.at(in_W);
    ASSERT_FALSE(out.state.known.beyond) << "tick " << i;
    ASSERT_NEAR(out.command.wrench_D.force.z(), spring_N, 1e-9);
  }
  static_cast<void>(hand.at(in_W)); // the last that rounding may count to the time
  TickOutput out = hand.at(in_W);
  EXPECT_TRUE(out.state.known.beyond && out.state.known.late);
  for (int i = 0; i < 1000; ++i)
  {
    out = hand.at(in_W);
  }
  EXPECT_LE(out.command.wrench_D.force.norm(), 1e-9);
  hand.parameters.known.asked = 0;
  for (int i = 0; i < 1000; ++i)
  {
    out = hand.at(in_W);
  }
  EXPECT_FALSE(out.state.known.beyond);
  EXPECT_NEAR(out.command.wrench_D.force.z(), spring_N, 1e-9);
}

TEST(SurroundingsRim, WhatIsSaidOfASceneThatIsOnItsWayHoldsNotForTheOneThatIsFelt)
{
  const TriangleMesh whole = sheet();
  FarHand hand;
  hand.takePart(whole, Vec3::Zero(), reach_u);
  static_cast<void>(hand.at({ 0, 0, 3.0 }));
  const Vec3 beyond_W(11.0, 0.2, -depth_u);
  EXPECT_TRUE(hand.at(beyond_W).state.known.beyond);
  const TriangleMesh next = partOf(whole, beyond_W, 3.0 * reach_u);
  hand.parameters.known = { test::sceneOf(next)->geometryHash(), 0, beyond_W, 3.0 * reach_u };
  EXPECT_TRUE(hand.at(beyond_W).state.known.beyond);
}

} // namespace
} // namespace palpate
