// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "haptics/core/PoseMath.h"
#include "haptics/recording/RecordedStages.h"
#include "haptics/tick/ForceRenderer.h"
#include "testing/haptics/tick/stages/Tick.h"
#include "testing/support/AllocationGuard.h"
#include "testing/support/Fields.h"
#include "testing/support/Meshes.h"
#include "testing/support/Random.h"

namespace palpate
{
namespace
{

using test::dt_s;

constexpr double coupling_N_per_m = 800.0;
const GridIndex size{ 33, 33, 33 };

/// 32 cells of a sixteenth of a metre around the origin: numbers that are exact in binary.
FieldBlockGrid grid()
{
  return { size, Vec3::Constant(0.0625), { Vec3::Constant(-1.0), Quat::Identity() } };
}

template<class Function>
FieldBlock scalarIn(const Function& function_W)
{
  return FieldBlock(1, grid(),
    { { FieldBlockRole::Scalar, "f",
      test::sampledValues(size, [&](const Vec3& i) { return function_W(grid().toWorld(i)); }) } });
}

/// A hand in a field, with a surface or without, engaged from the first tick.
class Field : public testing::Test
{
protected:
  Field()
  {
    this->parameters_.stiffness_N_per_m = coupling_N_per_m;
    this->parameters_.safety = SafetyLimits::none();
    this->parameters_.field.isosurface = true;
  }

  HapticState tick(const Vec3& p_W, const FieldBlock* brick, const Scene* scene = nullptr)
  {
    const HapticEvent told{ 0, EventKind::Engage, 0 };
    TickInput input;
    input.tick = ++this->tick_;
    input.scene = scene;
    input.brick = brick;
    input.dt_s = dt_s;
    input.sample.time_s = dt_s * static_cast<double>(this->tick_);
    input.sample.pose_D.p = this->parameters_.map.toDevice(p_W);
    input.events = { &told, this->tick_ == 1 ? 1U : 0U };
    return renderTick(input, this->parameters_, this->state_).state;
  }

  HapticParameters parameters_;
  RendererState state_;
  std::uint64_t tick_ = 0;
};

TEST_F(Field, AloneHoldsTheHandWithTheStiffnessOfTheCoupling)
{
  const FieldBlock brick = scalarIn([](const Vec3& p) { return p.z(); });
  this->parameters_.map.scale_u_per_m = 4.0;
  this->parameters_.map.q_WD = shortestTurn(Vec3::UnitZ(), Vec3(1, 2, 2).normalized());
  this->tick({ 0, 0, 0.1 }, &brick);
  const HapticState state = this->tick({ 0, 0, -0.02 }, &brick); // 5 mm of the hand
  EXPECT_LT((state.force_W - Vec3(0, 0, coupling_N_per_m * 0.005)).norm(), 1e-9);
  EXPECT_EQ(state.field.contacts, 1);
  EXPECT_LT((state.field.proxy_W - Vec3::Zero()).norm(), 1e-12);
}

TEST_F(Field, AndASurfaceShareTheStiffnessAndAreFeltAsTheirSum)
{
  test::Random random(test::testSeed(1660));
  const auto floor = test::sceneOf(test::makeSheet({ 2.0, 2.0, 8, 8, 0.2 }, random));
  const FieldBlock wall = scalarIn([](const Vec3&p) { return p.x(); }),
                   same = scalarIn([](const Vec3&p) { return p.z(); });
  this->tick({ 0.1, 0.05, 0.1 }, &wall, floor.get());
  const HapticState both = this->tick({ -0.004, 0.05, -0.002 }, &wall, floor.get());
  EXPECT_LT((both.force_W - 0.5 * coupling_N_per_m * Vec3(0.004, 0, 0.002)).norm(), 1e-9);
  EXPECT_EQ(both.contacts, 1);
  this->state_ = {};
  this->tick({ 0.1, 0.05, 0.1 }, &same, floor.get());
  const HapticState doubled = this->tick({ 0.1, 0.05, -0.002 }, &same, floor.get());
  EXPECT_LT((doubled.force_W - coupling_N_per_m * Vec3(0, 0, 0.002)).norm(), 1e-9) << "no stiffer than one of them";
}

TEST_F(Field, AndASurfaceThatIsAskewTakeNoWorkOverAClosedWay)
{
  // Both hold on the whole path, so the force is linear in the place, and the trapezoid of a polygon exact. A proxy
  // that went to one and from there to the other would have a force with curl.
  test::Random random(test::testSeed(1661));
  const auto floor = test::sceneOf(test::makeSheet({ 2.0, 2.0, 8, 8, 0.2 }, random));
  const FieldBlock slope = scalarIn([](const Vec3& p) { return p.x() + 0.75 * p.z(); });
  this->tick({ 0.1, 0.05, 0.1 }, &slope, floor.get());
  Vec3 before_W, force_W;
  double work_J = 0.0;
  for (int i = -100; i <= 1000; ++i)
  {
    const double turn = 2.0 * std::numbers::pi * i / 500;
    const Vec3 p_W(-0.03 + 0.01 * std::cos(turn), 0.05, -0.03 + 0.01 * std::sin(turn));
    const HapticState state = this->tick(p_W, &slope, floor.get());
    work_J += i > 0 ? 0.5 * (state.force_W + force_W).dot(p_W - before_W) : 0.0;
    before_W = p_W;
    force_W = state.force_W;
  }
  EXPECT_NEAR(work_J, 0.0, 1e-12);
}

TEST_F(Field, FadesIn30MillisecondsWhereItEnds)
{
  const auto half = [](const Vec3& p) { return p.x() > 0.5 ? std::nan("") : p.z(); };
  const FieldBlock brick = scalarIn(half);
  this->tick({ 0.4, 0, 0.1 }, &brick);
  const double pressed_N = this->tick({ 0.4, 0, -0.005 }, &brick).force_W.z();
  ASSERT_NEAR(pressed_N, coupling_N_per_m * 0.005, 1e-9);
  double before_N = pressed_N;
  for (int i = 0; i < 30; ++i)
  {
    const HapticState state = this->tick({ 0.8, 0, -0.005 }, &brick);
    EXPECT_TRUE(state.field.outside);
    EXPECT_NEAR(state.force_W.z(), pressed_N * (30 - i) / 30, 1e-9);
    before_N = state.force_W.z();
  }
  EXPECT_GT(before_N, 0.0);
  EXPECT_NEAR(this->tick({ 0.8, 0, -0.005 }, &brick).force_W.norm(), 0.0, 1e-12);
}

TEST_F(Field, FadesLikewiseWhenItIsTakenAway)
{
  const FieldBlock brick = scalarIn([](const Vec3& p) { return p.z(); });
  this->tick({ 0, 0, 0.1 }, &brick);
  const double pressed_N = this->tick({ 0, 0, -0.005 }, &brick).force_W.z();
  EXPECT_NEAR(this->tick({ 0, 0, -0.005 }, nullptr).force_W.z(), pressed_N, 1e-9);
  for (int i = 1; i < 30; ++i)
  {
    this->tick({ 0, 0, -0.005 }, nullptr);
  }
  EXPECT_NEAR(this->tick({ 0, 0, -0.005 }, nullptr).force_W.norm(), 0.0, 1e-12);
}

TEST_F(Field, PushesOnlyWhoIsEngagedAndTellsItsPower)
{
  const FieldBlock brick(1, grid(),
    { { FieldBlockRole::Vector, "v", test::sampledVectors(size, [](const Vec3&) { return Vec3(0, 2, 0); }) } });
  this->parameters_.field = {};
  this->parameters_.field.push_N = 0.4;
  this->parameters_.safety.engageRamp_s = 0.0;
  this->tick({ 0, 0, 0 }, &brick);
  double power_W = 0.0;
  Vec3 force_W;
  for (int i = 1; i <= 200; ++i)
  {
    const HapticState state = this->tick({ 0, 1e-4 * i, 0 }, &brick);
    power_W = state.field.pushPower_W;
    force_W = state.force_W;
  }
  EXPECT_LT((force_W - Vec3(0, 0.4, 0)).norm(), 1e-12);
  EXPECT_NEAR(power_W, 0.4 * 0.1, 1e-3) << "force times speed";
}

TEST_F(Field, BooksWhatANewBrickGivesTheHandAndIsEndedBeyondTheLimitOfTheLatch)
{
  const FieldBlock low = scalarIn([](const Vec3& p) { return p.z(); });
  const FieldBlock high =
    scalarIn([](const Vec3& p) { return p.z() - 0.0078125; }); // the surface is an eighth of a cell higher
  const double depth_m = 0.02, raised_m = depth_m + 0.0078125;
  const double given_J = 0.5 * coupling_N_per_m * (raised_m * raised_m - depth_m * depth_m);
  for (const double limit_J : { 2.0 * given_J, 0.5 * given_J })
  {
    this->state_ = {};
    this->tick_ = 0;
    this->parameters_.safety.hand.excess_J = limit_J;
    for (int i = 0; i <= 4000; ++i) // slowly: the work of a held force is behind its spring by a step
    {
      ASSERT_EQ(this->tick({ 0, 0, 0.001 - (depth_m + 0.001) * i / 4000 }, &low).fault, Fault::None);
    }
    HapticState state = this->tick({ 0, 0, -depth_m }, &low);
    EXPECT_NEAR(state.field.energy.excess_J, 0.0, 1e-3 * given_J);
    Fault fault = Fault::None;
    for (int i = 0; i < 400 && fault == Fault::None; ++i)
    {
      state = this->tick({ 0, 0, -depth_m }, &high);
      fault = state.fault;
    }
    EXPECT_EQ(fault, limit_J < given_J ? Fault::EnergyLatch : Fault::None);
    if (fault == Fault::None)
    {
      EXPECT_NEAR(state.field.proxy_W.z(), 0.0078125, 1e-9);
      EXPECT_NEAR(state.field.energy.excess_J, given_J, 1e-3 * given_J);
    }
  }
}

TEST_F(Field, PushesAsADeclaredSourceThatTheLatchDoesNotTakeForAFault)
{
  const FieldBlock brick(1, grid(),
    { { FieldBlockRole::Vector, "v", test::sampledVectors(size, [](const Vec3&) { return Vec3(1, 0, 0); }) } });
  this->parameters_.field.isosurface = false;
  this->parameters_.field.push_N = 0.5;
  this->parameters_.safety.hand.excess_J = 1e-3;
  double given_J = 0.0;
  for (int i = 0; i < 1500; ++i)
  {
    const HapticState state = this->tick({ -0.75 + 1e-3 * i, 0, 0 }, &brick);
    ASSERT_EQ(state.fault, Fault::None);
    EXPECT_EQ(state.field.energy.excess_J, 0.0);
    given_J += state.field.pushPower_W * dt_s;
  }
  EXPECT_GT(given_J, 0.5);
}

TEST_F(Field, IsRecordedAndWhatCannotBeIsRefused)
{
  this->parameters_.field.isovalue = 7.5;
  this->parameters_.field.detent.click = true;
  ByteWriter bytes;
  putParameters(bytes, this->parameters_);
  ByteReader in(bytes.bytes().data(), bytes.bytes().size());
  HapticParameters read;
  getParameters(in, read);
  EXPECT_EQ(read.field.isovalue, 7.5);
  EXPECT_TRUE(read.field.detent.click && read.field.isosurface);
  const auto refused = [](const auto& change)
  {
    HapticParameters parameters;
    change(parameters.field);
    return parameters.validate();
  };
  EXPECT_EQ(refused([](FieldPlan&) {}), "");
  EXPECT_NE(refused([](FieldPlan& f) { f.push_N = 0.6; }), "");
  EXPECT_NE(refused([](FieldPlan& f) { f.drag_N = -1.0; }), "");
  EXPECT_NE(refused([](FieldPlan& f) { f.isovalue = std::nan(""); }), "");
  EXPECT_NE(refused([](FieldPlan& f) { f.detent.spacing = 0.0; }), "");
  EXPECT_NE(refused([](FieldPlan& f) { f.dragNone = std::numeric_limits<double>::infinity(); }), "");
  EXPECT_NE(refused([](FieldPlan& f) { f.dragFull = std::nan(""); }), "");
  EXPECT_EQ(refused([](FieldPlan& f) { f.dragNone = 2.0, f.dragFull = -1.0; }), "") << "less resists more";
  EXPECT_NE(refused([](FieldPlan& f) { f.noSpeed = 1.0; }), "");
  EXPECT_EQ(refused([](FieldPlan& f) { f.noSpeed = 1.0, f.fullSpeed = 2.0; }), "");
}

TEST_F(Field, BeginsAnewWhereAnotherMapPutsTheHand)
{
  const FieldBlock brick = scalarIn([](const Vec3& p) { return p.z(); });
  this->tick({ 0, 0, 0.1 }, &brick);
  this->parameters_.map.offset_W = Vec3(0, 0, -0.3);
  EXPECT_NEAR(this->tick({ 0, 0, -0.2 }, &brick).force_W.norm(), 0.0, 1e-12) << "nothing lay between";
  EXPECT_LT(this->tick({ 0, 0, 0.01 }, &brick).force_W.z(), -1.0) << "now it is on the other side";
}

TEST_F(Field, AllocatesNothing)
{
  const FieldBlock brick = scalarIn([](const Vec3& p) { return p.norm(); });
  this->parameters_.field.isovalue = 0.5;
  this->parameters_.field.drag_N = 0.2;
  test::Random random(test::testSeed(1662));
  const test::AllocationGuard guard;
  for (int i = 0; i < 100; ++i)
  {
    this->tick(random.inCube(0.9), &brick);
  }
  EXPECT_EQ(guard.allocations() + guard.frees() + guard.locks(), 0U);
}

} // namespace
} // namespace palpate
