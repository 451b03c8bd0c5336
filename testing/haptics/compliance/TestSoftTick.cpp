// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>

#include "SoftScenes.h"
#include "haptics/compliance/servo/SubgridForce.h"
#include "haptics/contact/GodObject.h"
#include "testing/support/AllocationGuard.h"
#include "testing/support/Random.h"

namespace palpate::test
{
namespace
{

/// Residuals of the forces of a tick on the body's whole stiffness.
struct Certificate
{
  double gap_u = 0.0;     ///< largest of a contact that carries force, and largest overlap
  double balance_N = 0.0; ///< of the coupling
  double cone_N = 0.0;    ///< outside of it
  double slip_u = 0.0;    ///< within the cone any, on it the part not against the force
};

/// Turns after which a tick goes on from where it is.
constexpr int usualLoops = 8;

/// How much further along its surface a contact had the ball before the tick than the core was: the core's displacement
/// less the contact's.
Vec3 asideBefore(const SoftState& before, const SoftContact& contact)
{
  Vec3 aside = Vec3::Zero();
  for (int c = 0; c < before.count; ++c)
  {
    const bool pressed = before.contacts[c].force_N.norm() > 0.0;
    aside = pressed && before.contacts[c].n.dot(contact.n) > std::cos(10.0 * M_PI / 180.0)
              ? Vec3(before.yielded_W - before.contacts[c].yielded_W)
              : aside;
  }
  return aside;
}

/// `before`: the state that the tick began with. Slip counts from where each contact had the ball in the material then,
/// and in a tick of `usualLoops` turns or more from where it went on after so many.
Certificate certify(const SoftScene& s, const SoftResult& tick, const Vec3& p_W, const SoftState& before)
{
  Eigen::VectorXd load = Eigen::VectorXd::Zero(s.pad.body->displacement().size());
  Vec3 sum = Vec3::Zero();
  for (int c = 0; c < s.state.count; ++c)
  {
    const SoftContact& contact = s.state.contacts[c];
    sum += contact.force_N;
    for (int i = 0; i < 3; ++i)
    {
      s.pad.surface.map.addForce(contact.point.at.vertices[i], -contact.point.at.weights[i] * contact.force_N, load);
    }
  }
  const Eigen::VectorXd moved = s.pad.body->linearAnswer(load);
  const Vec3 ball_W = p_W + sum / s.plan.coupling_N_per_m;
  Certificate found;
  found.balance_N = (sum - tick.force_N).norm();
  for (int c = 0; c < s.state.count; ++c)
  {
    const SoftContact& contact = s.state.contacts[c];
    Vec3 place = contact.foot_W;
    Vec3 own = Vec3::Zero();
    for (int i = 0; i < 3; ++i)
    {
      place += contact.point.at.weights[i] * s.pad.surface.map.displacementOf(contact.point.at.vertices[i], moved);
    }
    // Beyond the mesh's own bilinear form the point yields by the share of compliantPoint().
    for (int d = 0; d < s.state.count; ++d)
    {
      const SoftContact& other = s.state.contacts[d];
      Mat3 bilinear = Mat3::Zero();
      for (int i = 0; i < 9; ++i)
      {
        bilinear += contact.point.at.weights[i / 3] * other.point.at.weights[i % 3] *
                    s.snapshot->between(contact.point.at.vertices[i / 3], other.point.at.vertices[i % 3]);
      }
      own += (complianceBetween(*s.snapshot, contact.point, other.point) - bilinear) * other.force_N;
    }
    const double normal = contact.n.dot(contact.force_N);
    const double gap = contact.n.dot(ball_W - place + own) - s.plan.radius_u;
    found.gap_u = std::max(found.gap_u, normal > 0.0 ? std::abs(gap) : -gap);
    const Vec3 across = contact.force_N - normal * contact.n;
    const bool fromBefore = tick.loops < usualLoops;
    const Vec3 from_W = fromBefore ? before.core.x_W : tick.slipFrom_W;
    const Vec3 aside_W = fromBefore ? asideBefore(before, contact) : contact.aside_W;
    const Vec3 moved = ball_W - place + own + contact.foot_W - from_W - aside_W;
    const Vec3 slip = moved - contact.n.dot(moved) * contact.n;
    const double limit = s.plan.friction.kinetic * normal;
    const bool sticks = across.norm() < limit * (1.0 - 1e-9);
    const Vec3 against = limit > 0.0 && !sticks ? Vec3(slip + slip.norm() / across.norm() * across) : slip;
    found.slip_u = limit > 0.0 ? std::max(found.slip_u, against.norm()) : found.slip_u;
    found.cone_N = std::max({ found.cone_N, -normal, across.norm() - s.plan.friction.kinetic * normal });
  }
  return found;
}

TEST(SoftTick, TheTurnsOfATickKeepTheListOfFacesThatTheFirstOneMade)
{
  SoftScene s(bumpyPad());
  Vec3 p_W(0.032, 0.046, 0.056);
  SoftState before;
  for (SoftResult tick = s.move(p_W); tick.force_N.isZero(); tick = s.move(p_W))
  {
    before = s.state;
    p_W.z() -= 2e-4;
  }
  // The tick that first touches, where no list is kept: its first turn is the rigid tick, as nothing has yielded yet.
  s.state = before;
  s.state.core.around.far.clear();
  GodObjectState rigid = s.state.core;
  (void)moveGodObject(s.scene, s.plan, p_W, rigid);
  ASSERT_GT(rigid.around.far.count(), 0);
  ASSERT_GE(s.move(p_W).loops, 2);
  EXPECT_EQ(s.state.core.around.far.reach().centre_W, rigid.around.far.reach().centre_W);
  EXPECT_EQ(s.state.core.around.far.reach().reach_u, rigid.around.far.reach().reach_u);

  s.state = before;
  s.state.core.around = FacesAround{};
  ASSERT_GE(s.move(p_W).loops, 2);
  EXPECT_EQ(s.state.core.around.far.count(), 0) << "the tick that opens a scene makes a list in a later turn";
}

TEST(SoftTick, WithoutComplianceItIsTheRigidTickBitForBit)
{
  for (const double friction : { 0.0, 0.3 })
  {
    SoftScene s(bumpyPad());
    s.scaleCompliance(0.0);
    s.plan.friction = { friction, friction };
    GodObjectState rigid;
    for (int tick = 0; tick < 250; ++tick)
    {
      const ContactResult expected = moveGodObject(s.scene, s.plan, wayOver(tick), rigid);
      const SoftResult found = s.move(wayOver(tick));
      ASSERT_EQ(found.proxy_W, expected.proxy_W);
      ASSERT_EQ(found.force_N, Vec3(s.plan.coupling_N_per_m * expected.pull_W));
    }
  }
}

TEST(SoftTick, AsComplianceGoesToNothingSoDoesTheDifferenceToTheRigidTick)
{
  for (const double factor : { 1e-12, 1e-9, 1e-6 })
  {
    SoftScene s(SoftPad(8, 2.0, ElementKind::Linear));
    s.scaleCompliance(factor);
    GodObjectState rigid;
    double off = 0.0;
    for (int tick = 0; tick < 300; ++tick)
    {
      const ContactResult expected = moveGodObject(s.scene, s.plan, wayOver(tick), rigid);
      off = std::max(off, (s.move(wayOver(tick)).proxy_W - expected.proxy_W).norm());
    }
    // 5 N on some 2 mm/N, and rounding.
    EXPECT_LE(off, 0.02 * factor + 1e-15);
  }
}

TEST(SoftTick, OnAFlatPadForcesAreStraightAndMeetTheLawsOnTheWholeBody)
{
  for (const double friction : { 0.0, 0.3 })
  {
    SoftScene s(SoftPad(8, 2.0, ElementKind::Linear));
    s.snapshot->springs.assign(s.snapshot->springs.size(), SubgridSpring{});
    s.plan.friction = { friction, friction };
    int touched = 0;
    int capped = 0;
    for (int tick = 0; tick < 500; ++tick)
    {
      const SoftState before = s.state;
      const SoftResult found = s.move(wayOver(tick));
      touched += s.state.count > 0;
      capped += found.capped;
      if (friction == 0.0)
      {
        ASSERT_EQ(found.force_N.head<2>(), Eigen::Vector2d::Zero());
      }
      if (tick % 25 == 0)
      {
        const Certificate open = certify(s, found, wayOver(tick), before);
        EXPECT_LE(open.gap_u, 1e-12);
        EXPECT_LE(open.balance_N, 1e-12);
        EXPECT_LE(open.cone_N, 1e-12);
        EXPECT_LE(open.slip_u, 1e-12);
      }
    }
    EXPECT_GT(touched, 300);
    EXPECT_EQ(capped, 0);
  }
}

TEST(SoftTick, OnBumpsForcesMeetTheLawsOnTheWholeBody)
{
  for (const double friction : { 0.0, 0.3 })
  {
    SoftScene s(bumpyPad());
    s.snapshot->springs.assign(s.snapshot->springs.size(), SubgridSpring{});
    s.plan.friction = { friction, friction };
    int capped = 0;
    int several = 0;
    std::vector<int> loops;
    for (int tick = 0; tick < 600; ++tick)
    {
      const SoftState before = s.state;
      const SoftResult found = s.move(wayOver(tick));
      capped += found.capped;
      several += s.state.count > 1;
      loops.push_back(found.loops);
      if (tick % 10 == 0)
      {
        const Certificate open = certify(s, found, wayOver(tick), before);
        EXPECT_LE(open.gap_u, 1e-12) << tick;
        EXPECT_LE(open.slip_u, 1e-12) << tick << " " << found.loops;
        EXPECT_TRUE(found.loops >= usualLoops || s.state.count == 0 || found.slipFrom_W == before.core.x_W) << tick;
        EXPECT_LE(open.balance_N, 1e-12);
        EXPECT_LE(open.cone_N, 1e-12);
      }
    }
    std::sort(loops.begin(), loops.end());
    std::cout << "friction " << friction << ": capped " << capped << " of 600, several contacts " << several
              << ", loops " << loops[300] << " / " << loops[594] << "\n";
    EXPECT_GT(several, 20);
    EXPECT_EQ(capped, 0);
  }
}

TEST(SoftTick, ASmallBallIsAsDeepAsHertzInsideTheLoopAndWithFriction)
{
  SoftScene s(SoftPad(10, 2.0, ElementKind::EdgeSmoothed), 0.01, 0.05);
  for (const double friction : { 0.0, 0.5 })
  {
    s.plan.friction = { friction, friction };
    for (const double depth : { 1e-5, 1e-4, 5e-3 })
    {
      s.state = {};
      (void)s.move(SoftPad::middle() + Vec3(0, 0, 0.02));
      const SoftResult found = s.move(SoftPad::middle() + Vec3(0, 0, 0.01 - depth));
      ASSERT_EQ(s.state.count, 1);
      EXPECT_FALSE(found.capped);
      // All compressions along the normal add up to the device's depth: body, spring below the patch, coupling.
      const CompliantPoint& point = s.state.contacts[0].point;
      const SubgridSpring& spring = s.state.contacts[0].spring;
      const Vec3 f = found.force_N;
      const Vec3 given = complianceBetween(*s.snapshot, point, point) * f + f / s.plan.coupling_N_per_m;
      EXPECT_NEAR(given.z() + subgridDepth(spring, f.z()).depth_u, depth, 1e-9 * depth);
      if (depth < 1e-3) // a contact much smaller than ball and patch: Hertz, less the patch on a half space
      {
        const double t = std::cbrt(f.z());
        EXPECT_NEAR(given.z() + spring.hertz * t * t - spring.patch * t * t * t, depth, 2e-3 * depth);
      }
      // And the ball is shown where the coupling alone holds it off the device.
      EXPECT_NEAR(found.proxy_W.z(), 0.06 - depth + f.z() / s.plan.coupling_N_per_m, 1e-9);
    }
    // 1 mm deep: Hertz times the layer's factor (ComplianceSnapshot).
    const double truth_N = 1.0653 * 4.0 / 3.0 * 20e3 / 0.84 * 0.1 * std::pow(1e-3, 1.5);
    s.state = {};
    (void)s.move(SoftPad::middle() + Vec3(0, 0, 0.02));
    const SoftResult found = s.move(SoftPad::middle() + Vec3(0, 0, 0.01 - 1e-3 - truth_N / s.plan.coupling_N_per_m));
    EXPECT_NEAR(found.force_N.z() / truth_N, 1.0, 0.05);
  }
}

TEST(SoftTick, RandomShotsCrossNoTriangle)
{
  Random random(testSeed(190));
  SoftScene s(bumpyPad());
  s.plan.friction = { 0.2, 0.2 };
  const TriangleMesh mesh{ s.pad.surface.rest_W, s.pad.surface.triangles };
  Vec3 p(0.05, 0.05, 0.07);
  (void)s.move(p);
  int pressed = 0;
  for (std::size_t shot = 0; shot < testCount(1000); ++shot)
  {
    p += random.inCube(0.01);
    p = p.cwiseMax(Vec3(0.01, 0.01, 0.03)).cwiseMin(Vec3(0.09, 0.09, 0.065));
    (void)s.move(p);
    pressed += s.state.count > 0;
    // The ball in the material is outside: no nearer to any triangle than its radius, on the outer side of the top or,
    // for the hand may be deeper below the top than it is away from a side, round its rim.
    double nearest = 1.0;
    for (const auto& t : mesh.triangles)
    {
      const Vec3& a = mesh.vertices_W[t[0]];
      const Vec3& b = mesh.vertices_W[t[1]];
      const Vec3& c = mesh.vertices_W[t[2]];
      const Vec3 n = (b - a).cross(c - a).normalized();
      const double h = std::abs(n.dot(s.state.core.x_W - a));
      const Vec3 foot = s.state.core.x_W - n.dot(s.state.core.x_W - a) * n;
      const bool inside = (b - a).cross(foot - a).dot(n) >= 0.0 && (c - b).cross(foot - b).dot(n) >= 0.0 &&
                          (a - c).cross(foot - c).dot(n) >= 0.0;
      nearest = inside ? std::min(nearest, h) : nearest;
    }
    ASSERT_GE(nearest, s.plan.radius_u - 1e-12);
    const Vec3& x_W = s.state.core.x_W;
    const bool beside = std::min(x_W.x(), x_W.y()) < 0.0 || std::max(x_W.x(), x_W.y()) > 0.1;
    ASSERT_TRUE(beside || x_W.z() > bumpAt(x_W) - 1e-3) << x_W.transpose() << ": facets lie that near to the waves";
  }
  EXPECT_GT(pressed, 100);
}

TEST(SoftTick, ASofterPacketLeavesTheForceAsItIsAndIsFeltOnceTheChangeHasFaded)
{
  const Vec3 p = SoftPad::middle() + Vec3(0.0, 0.0, 0.001);
  SoftScene s(SoftPad(8, 2.0, ElementKind::Linear));
  SoftScene anew(SoftPad(8, 2.0, ElementKind::Linear));
  (void)s.move(p + Vec3(0, 0, 0.02));
  const double before_N = s.move(p).force_N.norm();
  ComplianceSnapshot softer = *s.snapshot;
  softer.compliance *= 1.5;
  *anew.snapshot = softer;
  s.touch.snapshot = &softer;
  changeSnapshots(std::span(&s.touch, 1), s.state);
  EXPECT_NEAR(s.move(p).force_N.norm(), before_N, 1e-6 * before_N);
  for (int tick = 0; tick < 1000; ++tick)
  {
    fadeChange(1e-3, s.state);
    (void)s.move(p);
  }
  (void)anew.move(p + Vec3(0, 0, 0.02));
  const double after_N = anew.move(p).force_N.norm();
  EXPECT_LT(after_N, 0.97 * before_N);
  EXPECT_NEAR(s.move(p).force_N.norm(), after_N, 1e-6 * after_N);
}

TEST(SoftTick, WithLittleWorkItEndsSafely)
{
  for (const std::uint32_t budget : { 60u, 300u })
  {
    SoftScene s(bumpyPad());
    s.plan.friction = { 0.3, 0.3 };
    s.plan.workBudget = budget;
    int over = 0;
    for (int tick = 0; tick < 200; ++tick)
    {
      const SoftResult found = s.move(wayOver(tick));
      over += found.overBudget;
      EXPECT_LE(found.work, budget + 3000u); // the turn that it ends in
      EXPECT_LT(found.force_N.norm(), 20.0);
      for (int c = 0; c < s.state.count; ++c)
      {
        const SoftContact& contact = s.state.contacts[c];
        const double normal = contact.n.dot(contact.force_N);
        EXPECT_GE(normal, 0.0);
        EXPECT_LE((contact.force_N - normal * contact.n).norm(), 0.3 * normal + 1e-12);
      }
      ASSERT_GT(s.state.core.x_W.z(), bumpAt(s.state.core.x_W) - 1e-3); // nothing is crossed
    }
    EXPECT_GT(over, 0) << budget;
  }
}

TEST(SoftTick, AfterTicksWithLittleWorkItComesToWhereItWouldHaveBeen)
{
  SoftScene s(SoftPad(8, 2.0, ElementKind::Linear));
  SoftScene whole(SoftPad(8, 2.0, ElementKind::Linear));
  s.plan.workBudget = 60;
  for (int tick = 0; tick < 200; ++tick)
  {
    (void)s.move(wayOver(tick));
    (void)whole.move(wayOver(tick));
  }
  s.plan.workBudget = whole.plan.workBudget;
  (void)s.move(wayOver(200));
  const SoftResult expected = whole.move(wayOver(200));
  // The ball is as deep as one contact by itself allows: coupling, patch and dent in series.
  ASSERT_EQ(whole.state.count, 1);
  const SoftContact& contact = whole.state.contacts[0];
  const Vec3 f = expected.force_N;
  const double given_u = (complianceBetween(*whole.snapshot, contact.point, contact.point) * f).z() +
                         f.z() / whole.plan.coupling_N_per_m + subgridDepth(contact.spring, f.z()).depth_u;
  const double depth_u = 0.05 + whole.plan.radius_u - wayOver(200).z();
  EXPECT_NEAR(given_u, depth_u, 1e-9 * depth_u);
  EXPECT_LE((s.move(wayOver(200)).force_N - expected.force_N).norm(), 1e-6);
}

TEST(SoftTick, ItAllocatesNothing)
{
  SoftScene s(bumpyPad());
  s.plan.friction = { 0.3, 0.3 };
  (void)s.move(wayOver(0));
  const AllocationGuard guard;
  for (int tick = 1; tick < 300; ++tick)
  {
    (void)s.move(wayOver(tick));
  }
  EXPECT_EQ(guard.allocations(), 0u);
  EXPECT_EQ(guard.locks(), 0u);
}

} // namespace
} // namespace palpate::test
