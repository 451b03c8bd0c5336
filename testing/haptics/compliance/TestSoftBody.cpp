// SPDX-License-Identifier: GPL-3.0-or-later
#include <chrono>

#include <gtest/gtest.h>

#include "Blocks.h"
#include "testing/support/Random.h"

namespace palpate::test
{
namespace
{

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
    EXPECT_LE(held.norm(), 1e-12); // what strain does to all nodes together
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

} // namespace
} // namespace palpate::test
