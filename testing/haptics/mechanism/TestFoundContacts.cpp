// SPDX-License-Identifier: GPL-3.0-or-later
// A mesh in the hand presses a soft body: forces against an exact ball's and against a dense solve written apart, and
// the force from answer to answer.
#include <cmath>

#include <gtest/gtest.h>

#include "HeldMesh.h"
#include "haptics/compliance/snapshot/PointCompliance.h"
#include "haptics/core/PoseMath.h"
#include "haptics/session/path/PathTouch.h"
#include "haptics/tool/motion/Turn.h"
#include "testing/support/AllocationGuard.h"
#include "testing/support/LongForm.h"

namespace palpate::test
{
namespace
{

/// A mesh ball of 30 mm that rests on the pad.
struct RestingBall
{
  double depth_m = 0.0; ///< of the ball that it is inscribed in
  Vec3 force_N = Vec3::Zero();

  static constexpr double radius_m = 0.03;
};

/// Where the hand is when a ball at rest would be so deep.
Vec3 handAt(double depth_m)
{
  return middleOfPad() + Vec3(1.1e-3, 0.8e-3, RestingBall::radius_m - depth_m);
}

/// One at each depth of the hand, pressed deeper and deeper.
std::vector<RestingBall> restingBalls(int level, int cells, const std::vector<double>& depths_m)
{
  MeshTouch touch(meshOnPad(makeIcosphere(level, RestingBall::radius_m), cells));
  std::vector<RestingBall> balls;
  double before_m = 0.0;
  for (const double depth_m : depths_m)
  {
    for (int i = 1; i <= 50; ++i)
    {
      (void)touch.to(handAt(before_m + (depth_m - before_m) * i / 50.0));
    }
    before_m = depth_m;
    const MechanismResult& r = touch.to(handAt(depth_m), 1e-3, 1000);
    balls.push_back({ middleOfPad().z() + RestingBall::radius_m - r.pose_W[0].p.z(), r.exact_W.force });
  }
  return balls;
}

/// The force on the exact ball in these places, by a ball's own tick on the same pad.
std::vector<Vec3> exactForces_N(const std::vector<RestingBall>& balls, int cells)
{
  HapticParameters parameters;
  parameters.stiffness_N_per_m = 1e4;
  parameters.contact.radius_u = RestingBall::radius_m;
  PathTouch touch(nullptr, parameters, 1e-3);
  SoftBodyInput block = pad(cells);
  block.poisson = padPoisson;
  block.model = ElasticModel::Linear;
  std::string refusal;
  touch.press(BodyMaker::make(block, "block", 0, refusal), 0.0);
  double time_s = 0.0, hand_m = 0.0;
  std::vector<Vec3> forces_N;
  for (const RestingBall& ball : balls)
  {
    HapticState state;
    for (int i = 0; i < 60; ++i) // the hand goes where the spring leaves the ball so deep
    {
      state = touch.next(time_s += 1e-3, { handAt(hand_m), Quat::Identity() });
      hand_m += ball.depth_m - (middleOfPad().z() + RestingBall::radius_m - state.proxy_W.p.z());
    }
    forces_N.push_back(state.force_W);
  }
  return forces_N;
}

class BallOnPads : public testing::TestWithParam<int>
{
};

// On edges of 12.5 and of 6.25 mm.
TEST_P(BallOnPads, OfAMeshIsPressedBackAsTheExactBallOnTheSamePad)
{
  const std::vector<double> depths_m{ 0.25e-3, 0.5e-3, 1e-3, 2e-3, 4e-3 };
  // Facets lie below the ball by up to R (1 - cos .0415), 2,562 vertices being .0415 from their middles: of a depth of
  // 4 mm that takes a share of the force, which goes with its power of 1.5.
  const double facetShare = 1.5 * RestingBall::radius_m * (1.0 - std::cos(0.0415)) / depths_m.back();
  const int cells = GetParam();
  const std::vector<RestingBall> coarse = restingBalls(3, cells, depths_m), fine = restingBalls(4, cells, depths_m);
  const std::vector<Vec3> exact_N = exactForces_N(fine, cells), exactCoarse_N = exactForces_N(coarse, cells);
  for (std::size_t i = 0; i < depths_m.size(); ++i)
  {
    const double share = fine[i].force_N.z() / exact_N[i].z();
    EXPECT_NEAR(share, 1.0, 0.02 + facetShare) << i;
    EXPECT_NEAR(coarse[i].force_N.z() / exactCoarse_N[i].z(), share, 0.01) << i;
    EXPECT_LE(fine[i].force_N.head<2>().norm(), 0.01 * fine[i].force_N.z()) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Each, BallOnPads, testing::ValuesIn(casesOf<int>({ 8, 16 }, { 8 })));

/// Speed at which the hand comes down, and how deep it stops.
struct Descent
{
  double speed_m_per_s = 0.0, depth_m = 0.0;
};

class ComingDown : public testing::TestWithParam<Descent>
{
};

// An answer is one to two periods old: while the hand moves the force is one of a depth that it has passed or will pass
// within so long.
TEST_P(ComingDown, ABallOfAMeshIsPressedBackAsTheExactBallIsNearby)
{
  constexpr int cells = 8;
  const auto [speed_m_per_s, depth_m] = GetParam();
  const int ticks = static_cast<int>(depth_m / speed_m_per_s / 1e-3);
  const double way_m = 1.5 * speed_m_per_s / 30.0;
  MeshTouch touch(meshOnPad(makeIcosphere(4, RestingBall::radius_m), cells));
  std::vector<RestingBall> balls, before, after;
  for (int i = -200; i < ticks + 500; ++i)
  {
    const MechanismResult& r = touch.to(handAt(std::min(1e-3 * i * speed_m_per_s, depth_m)));
    if ((i > 0 && i < ticks && i % std::max(ticks / 8, 1) == 0) || i == ticks + 499)
    {
      const double deep_m = middleOfPad().z() + RestingBall::radius_m - r.pose_W[0].p.z();
      balls.push_back({ deep_m, r.exact_W.force });
      before.push_back({ deep_m - way_m, {} });
      after.push_back({ deep_m + way_m, {} });
    }
  }
  const std::vector<Vec3> least_N = exactForces_N(before, cells), most_N = exactForces_N(after, cells);
  ASSERT_GE(balls.size(), 8u);
  for (std::size_t i = 0; i + 1 < balls.size(); ++i)
  {
    EXPECT_GE(balls[i].force_N.z(), least_N[i].z()) << balls[i].depth_m;
    EXPECT_LE(balls[i].force_N.z(), most_N[i].z()) << balls[i].depth_m;
  }
  EXPECT_NEAR(balls.back().force_N.z() / exactForces_N({ balls.back() }, cells).front().z(), 1.0, 0.02);
}

INSTANTIATE_TEST_SUITE_P(
  Each, ComingDown, testing::Values(Descent{ 3e-3, 1e-3 }, Descent{ 10e-3, 0.5e-3 }, Descent{ 30e-3, 2e-3 }));

/// The force of every contact that was found, by an active set written apart: each subset of the rows that press in
/// turn, one row more or less, until no gap is open under a force and no force draws. Rows: the body's compliance
/// between the contacts and the hand's springs, of small turns.
class DenseContacts
{
public:
  DenseContacts(const PressedBody& body, const FoundContacts& found, const Pose& hand_W, const Pose& at_W,
    const MechanismGrip& grip)
  {
    const int n = found.count;
    this->compliance_.resize(n, n);
    this->gap_.resize(n);
    std::vector<CompliantPoint> points;
    Eigen::MatrixXd jacobian(n, 6);
    for (int i = 0; i < n; ++i)
    {
      const FoundContact& contact = found.contacts[static_cast<std::size_t>(i)];
      points.push_back(compliantPoint(*body.snapshot, contact.place_B));
      const Vec3 arm_W = at_W.q * contact.point_A;
      jacobian.row(i) << contact.normal_B.transpose(), arm_W.cross(contact.normal_B).transpose();
      const Vec3 back_W = hand_W.p - at_W.p + turnFromTo(at_W.q, hand_W.q).cross(arm_W);
      this->gap_[i] = contact.normal_B.dot(at_W * contact.point_A + back_W - contact.place_B.x_W);
    }
    Eigen::VectorXd springs(6);
    springs << Vec3::Constant(1.0 / grip.coupling_N_per_u), Vec3::Constant(1.0 / grip.turning_Nu_per_rad);
    for (int i = 0; i < n; ++i)
    {
      for (int j = 0; j < n; ++j)
      {
        const Vec3 &a = found.contacts[static_cast<std::size_t>(i)].normal_B,
                   &b = found.contacts[static_cast<std::size_t>(j)].normal_B;
        this->compliance_(i, j) = a.dot(
          complianceBetween(*body.snapshot, points[static_cast<std::size_t>(i)], points[static_cast<std::size_t>(j)]) *
          b);
      }
    }
    this->compliance_ += jacobian * springs.asDiagonal() * jacobian.transpose();
  }

  [[nodiscard]] Eigen::VectorXd solve() const
  {
    std::vector<Eigen::Index> active;
    for (int left = 1000; left > 0; --left)
    {
      Eigen::VectorXd force = Eigen::VectorXd::Zero(this->gap_.size());
      if (!active.empty())
      {
        const Eigen::MatrixXd w = this->compliance_(active, active);
        const Eigen::VectorXd f = w.completeOrthogonalDecomposition().solve(-Eigen::VectorXd(this->gap_(active)));
        for (std::size_t k = 0; k < active.size(); ++k)
        {
          force[active[k]] = f[static_cast<Eigen::Index>(k)];
        }
      }
      Eigen::Index worst = 0;
      if (force.minCoeff(&worst) < -1e-13)
      {
        std::erase(active, worst);
        continue;
      }
      const Eigen::VectorXd open = this->gap_ + this->compliance_ * force;
      if (open.minCoeff(&worst) > -1e-14)
      {
        return force;
      }
      active.push_back(worst);
    }
    ADD_FAILURE() << "no set of contacts";
    return {};
  }

private:
  Eigen::MatrixXd compliance_;
  Eigen::VectorXd gap_;
};

TEST(FoundContacts, OfAFlatPunchEachForceIsThatOfADenseSolveWrittenApart)
{
  const double half = 0.02, high = 0.02;
  const MechanismHold hold = firmHold(0.0); // the block at rest in every tick
  MeshTouch touch(meshOnPad(makeBox(Vec3(-half, -half, 0), Vec3(half, half, high)), 8), hold);
  Pose at{ middleOfPad() + Vec3(3e-3, 2e-3, 1e-3), Quat(Eigen::AngleAxisd(0.03, Vec3(1, 0.5, 0.2).normalized())) };
  for (int i = 0; i < 6; ++i)
  {
    (void)touch.to(at);
    at.p.z() -= 5e-4;
  }
  const MechanismResult& r = touch.to(at);
  ASSERT_GE(r.found, 6);
  const DenseContacts dense(touch.body(), touch.touch().bodies().found(), at, r.pose_W[0], gripOf(hold));
  const Eigen::VectorXd expected = dense.solve();
  double total = 0.0;
  for (int i = 0; i < r.found; ++i)
  {
    const Vec3& n = touch.touch().bodies().found().contacts[static_cast<std::size_t>(i)].normal_B;
    EXPECT_NEAR(r.laws[static_cast<std::size_t>(i)].force_W.dot(n), expected[i], 1e-9) << i;
    total += expected[i] * n.z();
  }
  EXPECT_GT(total, 1.0);
  EXPECT_NEAR(r.exact_W.force.z(), total, 1e-9);
}

TEST(FoundContacts, TheBodyIsPressedAsTheHandIs)
{
  MeshTouch touch(meshOnPad(makeIcosphere(3, 0.02), 8, 0.4));
  for (int i = 0; i < 300; ++i)
  {
    const MechanismResult& r = touch.to(Vec3(middleOfPad() + Vec3(2e-5 * i, 1e-5 * i, 0.0205 - 1e-5 * i)));
    Vec3 onBody = Vec3::Zero();
    for (int p = 0; p < r.pressCount; ++p)
    {
      onBody += r.presses[static_cast<std::size_t>(p)].force_N;
    }
    EXPECT_LE((onBody + r.exact_W.force).norm(), 1e-12);
  }
}

TEST(FoundContacts, AtEveryAnswerAndWhereRowsOpenAndCloseTheForceGoesOnWithoutAStep)
{
  // A block is pressed flat and rocks, so that its corners open and close, at 30 answers a second.
  const double stiffness = firmHold().stiffness_N_per_m;
  MeshTouch touch(meshOnPad(makeBox(Vec3(-0.012, -0.012, 0), Vec3(0.012, 0.012, 0.02)), 8, 0.3));
  Vec3 before = Vec3::Zero();
  double mostStep = 0.0, most = 0.0;
  int opened = 0, last = 0;
  for (int i = 0; i < 1500; ++i)
  {
    const double t = 1e-3 * i;
    const Pose at{ middleOfPad() + Vec3(2e-3 * t, 0, 5e-4 - 2.5e-3 * std::min(t, 0.8)),
      Quat(Eigen::AngleAxisd(0.08 * std::sin(6.0 * t), Vec3(1, 1, 0).normalized())) };
    const MechanismResult& r = touch.to(at);
    mostStep = std::max(mostStep, (r.wrench_W.force - before).norm());
    before = r.wrench_W.force;
    most = std::max(most, before.norm());
    int pressing = 0;
    for (int l = 0; l < r.found; ++l)
    {
      pressing += r.laws[static_cast<std::size_t>(l)].force_W != Vec3::Zero();
    }
    opened += pressing < last;
    last = pressing;
    EXPECT_FALSE(r.capped) << i;
  }
  // The hand goes 2.5e-6 m a tick, its turn carries a corner .08 * 6 * 1e-3 * .017 m: with the spring, no more.
  const double hand = stiffness * (3.3e-6 + 0.08 * 6.0 * 1e-3 * 0.017);
  EXPECT_GT(most, 1.0);
  // Of a turn by sin(6 t) there are 2.9 half swings in 1.5 s; at the end of each, rows of the side that rises open.
  EXPECT_GE(opened, 3);
  EXPECT_LT(mostStep, hand + ToolBlend::largestStep_N);
}

TEST(FoundContacts, AMeshThatSticksKeepsItsForceFromAnswerToAnswer)
{
  for (const int cells : { 8, 16 })
  {
    MeshTouch touch(meshOnPad(makeIcosphere(3, 0.02), cells, 0.6));
    for (int i = 0; i < 300; ++i)
    {
      (void)touch.to(Vec3(middleOfPad() + Vec3(0, 0, 0.0205 - 1e-5 * i)));
    }
    for (int i = 0; i < 100; ++i)
    {
      (void)touch.to(Vec3(middleOfPad() + Vec3(5e-6 * i, 0, 0.0175)));
    }
    const Vec3 hand = middleOfPad() + Vec3(5e-4, 0, 0.0175);
    const Vec3 early = touch.to(hand, 1e-3, 1000).exact_W.force;
    const Vec3 late = touch.to(hand, 1e-3, 2000).exact_W.force;
    EXPECT_LT(early.x(), -0.05) << cells;
    EXPECT_LT(-early.x(), 0.6 * early.z()) << cells;
    EXPECT_LT((late - early).norm(), 1e-3 * early.norm()) << "sixty answers later, cells: " << cells;
  }
}

TEST(FoundContacts, ATickWithThemAllocatesNothing)
{
  const MeshTouch first(meshOnPad(makeIcosphere(2, 0.02), 8, 0.4));
  const Range range(makeIcosphere(2, 0.02), *first.touch().bodies().newest().front(), 0.4);
  ContactFinder finder(range.meshes(), range.plan.held, range.most);
  finder.add(1, range.body, padYoung_Pa);
  MechanismTick tick;
  const std::array<const PressedBody*, 1> soft{ &range.body };
  MechanismResult result;
  double most = 0.0;
  for (int i = 0; i < 200; ++i)
  {
    MechanismInput input;
    input.tick = static_cast<std::uint64_t>(i + 1);
    input.plan = &range.plan;
    input.hand_W = { middleOfPad() + Vec3(0, 1e-5 * i, 0.0202 - 1e-5 * i), Quat::Identity() };
    input.grip = gripOf(firmHold());
    input.soft = soft;
    if (i % 25 == 0)
    {
      FinderView view;
      const Pose held_W = i == 0 ? input.hand_W : result.pose_W[0];
      view.pose_W = { &held_W, 1 };
      view.held = { 0.02, 1e-3 };
      view.soft = soft;
      view.presses = { result.presses.data(), static_cast<std::size_t>(result.pressCount) };
      (void)finder.find(view);
    }
    input.found = &finder.last();
    const AllocationGuard guard;
    const MechanismResult& now = tick.step(input);
    EXPECT_EQ(guard.allocations() + guard.frees() + guard.locks(), 0u);
    result = now;
    most = std::max(most, result.exact_W.force.z());
  }
  EXPECT_GT(most, 0.2);
}

} // namespace
} // namespace palpate::test
