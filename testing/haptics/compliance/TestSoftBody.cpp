// SPDX-License-Identifier: GPL-3.0-or-later
#include <chrono>
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Blocks.h"
#include "haptics/compliance/body/NaturalPeriod.h"
#include "testing/support/Random.h"

namespace palpate::test
{
namespace
{

using testing::HasSubstr;

/// Three columns at each of the surface vertices that are nearer than `reach` to the middle of a pad's top.
SparseColumns topOf(const SoftBody& body, double reach)
{
  SparseColumns e;
  for (std::size_t n = 0; n < body.points().rest_W.size(); ++n)
  {
    if ((body.points().rest_W[n] - Vec3(0.05, 0.05, 0.05)).norm() < reach)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        e.rows.push_back(static_cast<std::int32_t>(3 * n) + axis);
        e.values.push_back(1.0);
        e.start.push_back(e.rows.size());
      }
    }
  }
  return e;
}

Eigen::MatrixXd byColumns(const SoftBody& body, const SparseColumns& e)
{
  const auto count = static_cast<Eigen::Index>(e.count());
  Eigen::MatrixXd c(count, count);
  for (Eigen::Index j = 0; j < count; ++j)
  {
    Eigen::VectorXd unit = Eigen::VectorXd::Zero(body.displacement().size());
    unit[e.rows[static_cast<std::size_t>(j)]] = 1.0;
    const Eigen::VectorXd answer = body.linearAnswer(unit);
    for (Eigen::Index i = 0; i < count; ++i)
    {
      c(i, j) = answer[e.rows[static_cast<std::size_t>(i)]];
    }
  }
  return c;
}

double seconds(const std::function<void()>& work)
{
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

TEST(SoftBody, TheSharedComplianceIsThatOfColumnsSolvedOneByOne)
{
  for (const ElementKind element : { ElementKind::Linear, ElementKind::EdgeSmoothed })
  {
    SoftBodyInput input = pad(10);
    input.element = element;
    const SoftBodyResult made = makeSoftBody(input);
    ASSERT_TRUE(made.body) << made.refusal;
    const SparseColumns e = topOf(*made.body, 0.026);
    Eigen::MatrixXd path;
    Eigen::MatrixXd columns;
    const double onPath_s = seconds([&] { path = made.body->compliance(e); });
    const double byColumns_s = seconds([&] { columns = byColumns(*made.body, e); });
    EXPECT_LE((path - columns).lpNorm<Eigen::Infinity>(), 1e-12 * columns.lpNorm<Eigen::Infinity>());
    EXPECT_EQ(path, path.transpose());
    RecordProperty("columns", static_cast<int>(e.count()));
    std::cout << e.count() << " columns on the path: " << byColumns_s / onPath_s << " times as fast as one by one\n";
  }
}

TEST(SoftBody, NewtonStepsEndWhereForcesBalance)
{
  SoftBodyInput input = pad(6);
  for (const ElasticModel model : { ElasticModel::Linear, ElasticModel::CoRotational, ElasticModel::NeoHookean })
  {
    input.model = model;
    const SoftBodyResult made = makeSoftBody(input);
    ASSERT_TRUE(made.body) << made.refusal;
    Eigen::VectorXd load = Eigen::VectorXd::Zero(made.body->displacement().size());
    for (std::size_t n = 0; n < made.body->points().rest_W.size(); ++n)
    {
      if ((made.body->points().rest_W[n] - Vec3(0.05, 0.05, 0.05)).norm() < 0.02)
      {
        load.segment<3>(3 * static_cast<Eigen::Index>(n)) = Vec3(0.1, 0.0, -0.6);
      }
    }
    ASSERT_TRUE(made.body->settle(load, 30));
    const SoftBodyState state = made.body->stateUnder(load);
    EXPECT_LE(state.residual_N, 1e-12);
    EXPECT_GT(state.mostGradient, 0.1); // far enough that the laws differ
    if (model == ElasticModel::Linear)
    {
      // Clapeyron: the energy is half the work of the load.
      EXPECT_NEAR(state.energy_Nu, 0.5 * load.dot(made.body->displacement()), 1e-12);
    }
    const Eigen::VectorXd inner = made.body->innerForces();
    Vec3 held = Vec3::Zero();
    Vec3 pressed = Vec3::Zero();
    for (Eigen::Index n = 0; n < load.size() / 3; ++n)
    {
      held += inner.segment<3>(3 * n);
      pressed += load.segment<3>(3 * n);
    }
    EXPECT_LE(held.norm(), 1e-12); // sum of the strain's forces on all nodes
    EXPECT_GT(pressed.norm(), 0.5);
  }
}

TEST(SoftBody, ABodyThatIsMirroredByALoadComesBack)
{
  SoftBodyInput input = pad(4);
  const SoftBodyResult made = makeSoftBody(input);
  ASSERT_TRUE(made.body) << made.refusal;
  Eigen::VectorXd pressed = made.body->displacement();
  for (std::size_t n = 0; n < made.body->points().rest_W.size(); ++n)
  {
    const Vec3& p = made.body->points().rest_W[n];
    pressed[3 * static_cast<Eigen::Index>(n) + 2] = p.z() > 0.02 ? -1.5 * p.z() : 0.0;
  }
  made.body->place(pressed);
  const Eigen::VectorXd nothing = Eigen::VectorXd::Zero(pressed.size());
  ASSERT_TRUE(made.body->settle(nothing, 60));
  EXPECT_LE(made.body->displacement().lpNorm<Eigen::Infinity>(), 1e-12);
}

/// Pressed 5 mm deep, then in steps to 12 mm: how often the stiffness is factored in between, and where the body rests.
struct Pressing
{
  std::size_t factorings = 0;
  Eigen::VectorXd rest;
};

Pressing pressedFurther(int cells, Factoring factoring)
{
  const SoftBodyResult made = makeSoftBody(pad(cells));
  made.body->factorsBe(factoring);
  Eigen::VectorXd load = Eigen::VectorXd::Zero(made.body->displacement().size());
  std::vector<Eigen::Index> pressed;
  for (std::size_t n = 0; n < made.body->points().rest_W.size(); ++n)
  {
    if ((made.body->points().rest_W[n] - Vec3(0.05, 0.05, 0.05)).norm() < 0.018)
    {
      pressed.push_back(static_cast<Eigen::Index>(n));
    }
  }
  for (const double force_N : { 3.0, 3.6, 4.8, 7.2 })
  {
    for (const Eigen::Index n : pressed)
    {
      load.segment<3>(3 * n) = Vec3(0.1, 0.0, -force_N / static_cast<double>(pressed.size()));
    }
    EXPECT_TRUE(made.body->settle(load, 12));
    EXPECT_LE(made.body->stateUnder(load).residual_N, 1e-8);
  }
  return { made.body->factorings(), made.body->displacement() };
}

TEST(SoftBody, AnOldFactorLeadsToTheSameRestWithAFewNewOnes)
{
  for (const int cells : { 6, 8 })
  {
    const Pressing each = pressedFurther(cells, Factoring::EachStep);
    const Pressing old = pressedFurther(cells, Factoring::WhenOld);
    EXPECT_LE((each.rest - old.rest).lpNorm<Eigen::Infinity>(), 1e-9);
    EXPECT_GT(each.rest.lpNorm<Eigen::Infinity>(), 0.006);
    EXPECT_LE(4 * old.factorings, each.factorings);
    RecordProperty("factorings", static_cast<int>(old.factorings));
  }
}

TEST(SoftBody, ABarSwingsWithThePeriodOfItsFirstBendingMode)
{
  // Euler & Bernoulli: w = 3.516 sqrt(E I / (m' L^4)), I / A = a^2 / 12 of a square; .2 x .02 x .02 m, 1000 kg/m^3.
  const double w = 3.516 * std::sqrt(20e3 * 0.02 * 0.02 / 12.0 / (1000.0 * std::pow(0.2, 4)));
  for (const double unit_m : { 1.0, 1e-3 })
  {
    SoftBodyInput input;
    input.mesh = blockOf({ 24, 3, 3 }, Vec3(0.2, 0.02, 0.02) / unit_m);
    input.fixed = fixedWhere(input.mesh, [](const Vec3& p) { return p.x() == 0.0; });
    input.young_Pa = { 20e3 };
    input.poisson = 0.3;
    input.unit_m = unit_m;
    const SoftBodyResult made = makeSoftBody(input);
    ASSERT_TRUE(made.body) << made.refusal;
    // Three edge-smoothed cells across bend within 5 % (SoftElements); a period goes with the root.
    EXPECT_NEAR(naturalPeriod_s(*made.body, 1000.0, unit_m) * w / (2.0 * std::numbers::pi), 1.0, 0.04);
  }
}

TEST(SoftBody, TheLimitOfBytesCountsTheFactorInSinglePrecisionThatALargeBodyKeeps)
{
  SoftBodyInput input = pad(16); // 2,601 nodes: its steps go on with an old factor
  input.element = ElementKind::Linear;
  input.model = ElasticModel::Linear;
  const SoftBodyResult linear = makeSoftBody(input);
  ASSERT_TRUE(linear.body) << linear.refusal;
  ASSERT_LT(linear.body->bytes(), linear.body->factorBytes() * 5 / 4);
  input.mostBytes = linear.body->factorBytes() * 5 / 4;
  EXPECT_TRUE(makeSoftBody(input).body);
  input.model = ElasticModel::NeoHookean;
  EXPECT_THAT(makeSoftBody(input).refusal, HasSubstr("mesh it coarser"));
  input.mostBytes = linear.body->factorBytes() * 7 / 4;
  EXPECT_TRUE(makeSoftBody(input).body);
}

TEST(SoftBody, WhatCannotBeComputedIsRefusedInWords)
{
  const auto refusal = [](const std::function<void(SoftBodyInput&)>& change)
  {
    SoftBodyInput input = pad(4);
    change(input);
    const SoftBodyResult made = makeSoftBody(input);
    EXPECT_FALSE(made.body);
    return made.refusal;
  };
  // 75 nodes that are free have more than 100 kB of stiffness.
  EXPECT_THAT(refusal([](SoftBodyInput& input) { input.mostBytes = 100'000; }), HasSubstr("mesh it coarser"));
  EXPECT_THAT(refusal([](SoftBodyInput& input) { input.fixed.assign(input.fixed.size(), true); }),
    HasSubstr("leave some vertices free"));
  // A vertex that is in no tetrahedron and is not fixed does not free the body.
  EXPECT_THAT(refusal(
                [](SoftBodyInput& input)
                {
                  input.fixed.assign(input.fixed.size(), true);
                  input.mesh.vertices_W.emplace_back(1.0, 1.0, 1.0);
                  input.fixed.push_back(false);
                }),
    HasSubstr("leave some vertices free"));
  for (const double unit_m : { 0.0, -1.0, std::nan(""), 1e300 })
  {
    EXPECT_THAT(refusal([unit_m](SoftBodyInput& input) { input.unit_m = unit_m; }), HasSubstr("A unit of the scene"));
  }
}

} // namespace
} // namespace palpate::test
