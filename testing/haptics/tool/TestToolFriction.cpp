// SPDX-License-Identifier: GPL-3.0-or-later
// Friction on a tool: a block that is pulled at a slant and one that is spun on its face, by closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

#include "Tools.h"
#include "haptics/tool/move/SettledTarget.h"
#include "haptics/tool/servo/ToolForce.h"

namespace palpate::test
{
namespace
{

constexpr double halfOfRubbed_mm = 20.0, pressedBy_mm = 2.0, stiffness_N_per_mm = 1.0;
constexpr double solved = 1e-3;     // of sliding contacts
constexpr double atTheLimit = 4e-2; // likewise in a tick, where friction just holds the tool: its sweeps are few

constexpr double contactLever_mm = 1.0;

ToolContacts contactsOf(const std::vector<ToolContact>& contacts)
{
  ToolContacts set;
  set.placed = true;
  set.characteristic_u = contactLever_mm;
  set.count = static_cast<std::uint32_t>(contacts.size());
  std::copy(contacts.begin(), contacts.end(), set.contacts.begin());
  return set;
}

/// Normals within a half space, so that a tool may always leave them.
ToolContacts slantedContacts(Random& random, int count)
{
  std::vector<ToolContact> contacts;
  while (static_cast<int>(contacts.size()) < count)
  {
    const Vec3 n_W = random.direction();
    if (n_W.z() > 0.2)
    {
      contacts.push_back({ n_W, random.uniform(0.3, 1.5) * random.direction(), 0.0 });
    }
  }
  return contactsOf(contacts);
}

/// The eight corners of an octagon that lies on a plane: the push of each of them is not unique.
ToolContacts face()
{
  std::vector<ToolContact> contacts;
  for (int i = 0; i < 8; ++i)
  {
    const double a = i * std::numbers::pi / 4.0;
    contacts.push_back({ Vec3::UnitZ(), Vec3(std::cos(a), std::sin(a), -1.0), 0.0 });
  }
  return contactsOf(contacts);
}

/// A hand that presses.
Pose pressingHand(Random& random)
{
  const Vec3 p_W(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, -0.3));
  return { p_W, turnBy(random.uniform(0.0, 0.5) * random.direction()) };
}

/// By how much the power of friction misses Coulomb's: a point that slides by v under a push p takes friction p |v|.
double powerMissed(const ToolPull& pull, const Vec6& wish, double friction)
{
  const Vec6 motion = pull.pull_u + wish;
  Vec6 rubs = pull.pull_u;
  double taken = 0.0;
  for (int i = 0; i < pull.active; ++i)
  {
    const ToolPress& press = pull.presses[i];
    rubs -= press.push_u *
            whitened(press.n_W, press.p_W.cross(press.n_W) / (contactLever_mm * contactLever_mm), contactLever_mm);
    const Vec3 slide = motion.head<3>() + Vec3(motion.tail<3>()).cross(press.p_W) / contactLever_mm;
    taken += friction * press.push_u * (slide - slide.dot(press.n_W) * press.n_W).norm();
  }
  return std::abs(rubs.dot(motion) + taken) / wish.squaredNorm();
}

double secondsOf(const ToolContacts& set, const Pose& hand_W, double friction)
{
  double least_s = 1.0;
  for (int i = 0; i < 5; ++i)
  {
    const auto begin = std::chrono::steady_clock::now();
    for (int k = 0; k < 20; ++k)
    {
      EXPECT_GE(toolPull(set, hand_W, ToolCoupling::Constraints, friction).active, 0);
    }
    least_s = std::min(least_s, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  }
  return least_s;
}

} // namespace

/// A cube that lies on a plane of triangles, pressed by the hand above its middle.
class RubbedCube : public testing::TestWithParam<double>
{
protected:
  RubbedCube()
  {
    Random random(testSeed(2301));
    const TriangleMesh plane = makeSheet({ 400.0, 400.0, 8, 8, 0.3 }, random);
    this->move.emplace(this->tool, makeToolScene(cleanMesh(plane).mesh, this->tool), this->tool.gyration_u);
    this->move->rub(this->friction);
    EXPECT_EQ(this->move->place({ Vec3(0, 0, halfOfRubbed_mm + 1.0), Quat::Identity() }), "");
    EXPECT_TRUE(settle(*this->move, this->pressed(0.0, 0.0)));
  }

  [[nodiscard]] Pose pressed(double along_mm, double spin_rad) const
  {
    return { along_mm * this->along + Vec3(0, 0, halfOfRubbed_mm - pressedBy_mm), turnBy(Vec3(0, 0, spin_rad)) };
  }
  /// The plane's push, over the stiffness: it holds the cube at its rest gap.
  [[nodiscard]] double push_mm() const { return pressedBy_mm + this->tool.restGap_u(); }

  double friction = GetParam();
  Vec3 along = Vec3(0.6, 0.8, 0.0);
  ToolMesh tool = makeTool(makeBox(Vec3::Constant(-halfOfRubbed_mm), Vec3::Constant(halfOfRubbed_mm))).value;
  std::optional<ToolMove> move;
};

TEST_P(RubbedCube, StaysUntilItsPullLeansByTheAngleOfFrictionAndThenTrailsByIt)
{
  const double most_mm = this->friction * this->push_mm(); // tan of the angle times the push
  ASSERT_TRUE(settle(*this->move, this->pressed(0.999 * most_mm, 0.0)));
  EXPECT_LE(this->move->pose_W().p.head<2>().norm(), 1e-7);
  for (const double pull_mm : { 1.001 * most_mm, 2.0 * most_mm, 7.0 * most_mm })
  {
    ASSERT_TRUE(settle(*this->move, this->pressed(pull_mm, 0.0)));
    EXPECT_LE(
      (this->move->pose_W().p.head<2>() - (pull_mm - most_mm) * this->along.head<2>()).norm(), solved * most_mm);
    EXPECT_LE(rotationVector(this->move->pose_W().q).norm(), 1e-6) << "it neither tips nor turns";
  }
  // Back again it stays until it is pulled in the opposite direction.
  const double rests_mm = 6.0 * most_mm;
  ASSERT_TRUE(settle(*this->move, this->pressed(rests_mm - 0.99 * most_mm, 0.0)));
  EXPECT_NEAR(this->move->pose_W().p.dot(this->along), rests_mm, solved * most_mm);
}

TEST_P(RubbedCube, SpunOnItsFaceHoldsUpToTheTorqueOfItsCorners)
{
  // Its corners carry it, each sqrt(2) h from the middle: mu N sqrt(2) h, against L^2 t of the spring that turns.
  const double lever2_mm2 = std::pow(this->tool.gyration_u, 2);
  const double most_rad = this->friction * this->push_mm() * std::numbers::sqrt2 * halfOfRubbed_mm / lever2_mm2;
  ASSERT_LT(2.0 * most_rad, 1.5) << "the lead that is not cut";
  ASSERT_TRUE(settle(*this->move, this->pressed(0.0, 0.99 * most_rad)));
  EXPECT_LE(rotationVector(this->move->pose_W().q).norm(), 1e-8);
  ASSERT_TRUE(settle(*this->move, this->pressed(0.0, 2.0 * most_rad)));
  EXPECT_NEAR(rotationVector(this->move->pose_W().q).z(), most_rad, 1e-6);
}

TEST_P(RubbedCube, InEveryTickIsPulledBackByFrictionTimesWhatPressesItAndNoMore)
{
  const ToolContacts set = this->move->contacts();
  for (const double pull_mm : { 0.2, 0.5, 1.0, 4.0 })
  {
    const ToolPush push =
      toolPush(set, this->pressed(pull_mm, 0.0), stiffness_N_per_mm, ToolCoupling::Constraints, this->friction);
    const double rubs_N = stiffness_N_per_mm * std::min(pull_mm, this->friction * this->push_mm());
    EXPECT_NEAR(push.wrench_W.force.z(), stiffness_N_per_mm * this->push_mm(), 1e-7);
    EXPECT_LE((push.wrench_W.force.head<2>() + rubs_N * this->along.head<2>()).norm(),
      (std::abs(pull_mm / this->friction / this->push_mm() - 1.0) < 0.25 ? atTheLimit : solved) * rubs_N);
  }
}

TEST_P(RubbedCube, PaysForItsFrictionFromTheWorkOfAnUpdate)
{
  const Pose stuck = this->pressed(0.5 * this->friction * this->push_mm(), 0.0);
  ASSERT_TRUE(settle(*this->move, stuck));
  const ToolUpdate rubbed = this->move->update(stuck, plenty);
  EXPECT_TRUE(rubbed.converged);
  EXPECT_GT(rubbed.work, 0u) << "it stays, so that friction is all that it looks at";
}

TEST_P(RubbedCube, SaysThatTheHandIsTurnedTooFarAheadAlsoWhereFrictionHoldsTheTool)
{
  // Pressed so hard that its corners hold a turn by 2 rad (see the spin), and led by 2.5, of which 1.5 are asked for.
  const double most_rad_per_mm =
    this->friction * std::numbers::sqrt2 * halfOfRubbed_mm / std::pow(this->tool.gyration_u, 2);
  Pose hand = this->pressed(0.0, 2.5);
  hand.p.z() = halfOfRubbed_mm - 2.0 / most_rad_per_mm;
  EXPECT_TRUE(this->move->update(hand, plenty).leadCut);
  EXPECT_LE(rotationVector(this->move->pose_W().q).norm(), 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Friction, RubbedCube, testing::Values(0.1, 0.3, 0.6));

TEST(RubbedTool, OnOneSlantedContactGoesWhatFrictionTimesThePushLeavesOfItsSlide)
{
  Random random(testSeed(2302));
  for (std::size_t i = 0; i < testCount(200); ++i)
  {
    const ToolContacts set = contactsOf({ { random.direction(), Vec3::Zero(), 0.0 } });
    const Vec3& n_W = set.contacts[0].n_W;
    const double friction = random.uniform(0.1, 3.0);
    Vec3 way = random.direction();
    way -= 2.0 * std::max(0.0, way.dot(n_W)) * n_W;
    const Vec3 slide = way - way.dot(n_W) * n_W;
    const double left = std::max(0.0, slide.norm() + friction * way.dot(n_W));
    const ToolPull pull = toolPull(set, { way, Quat::Identity() }, ToolCoupling::Constraints, friction);
    EXPECT_LE((pull.pull_u.head<3>() + way - left * slide.normalized()).norm(), 1e-4)
      << "of the wish, at which a tick stops";
  }
}

TEST(RubbedTool, InAGrooveIsHeldByBothOfItsWalls)
{
  // Walls at 45 degrees, touched at the height of the centre and pressed straight down by d: each pushes by d /
  // sqrt(2).
  const double r = 1.0 / std::numbers::sqrt2;
  const ToolContacts groove =
    contactsOf({ { Vec3(r, 0, r), Vec3(-1, 0, 0), 0.0 }, { Vec3(-r, 0, r), Vec3(1, 0, 0), 0.0 } });
  const double down = 0.5;
  for (const double friction : { 0.3, 0.6, 2.0 })
  {
    const double most = 2.0 * friction * down * r;
    for (const double along : { 0.5 * most, 3.0 * most })
    {
      Vec6 wish = Vec6::Zero();
      wish.head<3>() = Vec3(0, along, -down);
      const SettledTarget rubbed = settledTarget(groove, wish, friction);
      const Vec6 goes = allowedMotion(groove, rubbed.wish).y;
      EXPECT_NEAR(goes.y(), std::max(0.0, along - most), 1e-9);
      EXPECT_LT(rubbed.rounds, 60) << "it settles";
    }
  }
}

TEST(RubbedTool, OnSlantedContactsLosesThePowerThatCoulombsLawTakes)
{
  Random random(testSeed(2303));
  for (const double friction : { 0.3, 0.6, 1.0 })
  {
    std::vector<double> missed, missedInATick;
    for (std::size_t i = 0; i < testCount(1000); ++i)
    {
      const ToolContacts set = slantedContacts(random, 2 + static_cast<int>(i % 4));
      const Pose hand_W = pressingHand(random);
      bool cut = false;
      const Vec6 wish = wishedMotion(set.pose_W, hand_W, contactLever_mm, cut);
      missedInATick.push_back(powerMissed(toolPull(set, hand_W, ToolCoupling::Constraints, friction), wish, friction));
      const AllowedMotion slow = allowedMotion(set, settledTarget(set, wish, friction).wish);
      missed.push_back(powerMissed({ slow.y - wish, slow.active, slow.presses }, wish, friction));
    }
    std::sort(missed.begin(), missed.end());
    std::sort(missedInATick.begin(), missedInATick.end());
    EXPECT_LE(missed[missed.size() / 2], 1e-9);
    EXPECT_LE(missed[missed.size() * 95 / 100], 5e-3);
    EXPECT_LE(missedInATick[missed.size() / 2], 1e-3);
    EXPECT_LE(missedInATick[missed.size() * 9 / 10], 2e-2);
  }
}

TEST(RubbedTool, OnAFaceWhosePushesAreNotUniqueFollowsTheHandWithoutAJump)
{
  constexpr double step = 1e-3;
  Random random(testSeed(2304));
  const ToolContacts set = face();
  for (std::size_t way = 0; way < testCount(50); ++way)
  {
    Pose hand_W = pressingHand(random);
    const Vec3 along = step * random.direction(), turn = step * random.direction();
    Vec6 last = toolPull(set, hand_W, ToolCoupling::Constraints, 0.3).pull_u;
    for (int i = 0; i < 200; ++i)
    {
      hand_W = { hand_W.p + along, (turnBy(turn) * hand_W.q).normalized() };
      const Vec6 now = toolPull(set, hand_W, ToolCoupling::Constraints, 0.3).pull_u;
      EXPECT_LE((now - last).norm(), 3.0 * std::numbers::sqrt2 * step);
      last = now;
    }
  }
}

TEST(RubbedTool, IsSpringedByTheVirtualCouplingAsWithoutFriction)
{
  Random random(testSeed(2305));
  const ToolContacts set = slantedContacts(random, 6);
  const Pose hand_W = pressingHand(random);
  EXPECT_EQ(
    toolPull(set, hand_W, ToolCoupling::Virtual, 0.6).pull_u, toolPull(set, hand_W, ToolCoupling::Virtual).pull_u);
}

// The tick asks twice where a new set comes.
TEST(RubbedTool, AtEightContactsCostsATickNoMoreThanTenTimesWhatItCostsWithoutFriction)
{
  Random random(testSeed(2306));
  double with_s = 0.0, without_s = 0.0;
  for (int i = 0; i < 40; ++i)
  {
    const ToolContacts set = slantedContacts(random, 8);
    const Pose hand_W = pressingHand(random);
    with_s += secondsOf(set, hand_W, 0.3);
    without_s += secondsOf(set, hand_W, 0.0);
  }
  EXPECT_LE(with_s, 10.0 * without_s);
  RecordProperty("timesAsLong", std::to_string(with_s / without_s));
}

} // namespace palpate::test
