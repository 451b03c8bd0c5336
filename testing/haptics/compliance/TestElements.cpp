// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>

#include "Blocks.h"
#include "testing/support/Random.h"

namespace palpate::test
{
namespace
{

constexpr std::array elements{ ElementKind::Linear, ElementKind::EdgeSmoothed, ElementKind::Quadratic };
constexpr std::array models{ ElasticModel::Linear, ElasticModel::CoRotational, ElasticModel::NeoHookean };

Eigen::VectorXd affine(const SoftBody& body, const Mat3& f)
{
  Eigen::VectorXd u(body.displacement().size());
  for (std::size_t n = 0; n < body.points().rest_W.size(); ++n)
  {
    u.segment<3>(3 * static_cast<Eigen::Index>(n)) = (f - Mat3::Identity()) * body.points().rest_W[n];
  }
  return u;
}

TEST(SoftElements, UnderOneDeformationNoInnerNodeFeelsAForce)
{
  Random random(testSeed(181));
  SoftBodyInput input;
  input.mesh = blockOf({ 4, 3, 3 }, { 4, 3, 3 });
  const auto inside = [](const Vec3& p)
  { return (p.array() > 0.5).all() && p.x() < 3.5 && p.y() < 2.5 && p.z() < 2.5; };
  for (Vec3& p : input.mesh.vertices_W)
  {
    p += inside(p) ? Vec3(0.15 * random.direction()) : Vec3(Vec3::Zero());
  }
  input.fixed = fixedWhere(input.mesh, [](const Vec3& p) { return p.x() == 0.0; });
  input.young_Pa = { 100.0 };
  input.unit_m = 0.1; // 1 N on a square of the unit
  Mat3 f;
  f << 1.1, 0.2, -0.05, 0.1, 0.9, 0.15, -0.1, 0.05, 1.2;
  for (const ElementKind element : elements)
  {
    for (const ElasticModel model : models)
    {
      input.element = element;
      input.model = model;
      const SoftBodyResult made = makeSoftBody(input);
      ASSERT_TRUE(made.body) << made.refusal;
      made.body->place(affine(*made.body, f));
      const Eigen::VectorXd forces = made.body->innerForces();
      int judged = 0;
      for (std::size_t n = 0; n < made.body->points().rest_W.size(); ++n)
      {
        const Vec3& p = made.body->points().rest_W[n];
        if ((p.array() > 1e-9).all() && p.x() < 4 - 1e-9 && p.y() < 3 - 1e-9 && p.z() < 3 - 1e-9)
        {
          ++judged;
          // Stress is about 1 and faces have an area of about 1.
          EXPECT_LE(forces.segment<3>(3 * static_cast<Eigen::Index>(n)).norm(), 1e-12);
        }
      }
      EXPECT_GE(judged, 12);
    }
  }
}

TEST(SoftElements, TheForceOnAnEndIsTheStressTimesItsArea)
{
  const ElasticModuli moduli = moduliOf(1.0, 0.4, 1.0).value;
  SoftBodyInput input;
  input.mesh = blockOf({ 3, 2, 2 }, { 3, 2, 2 });
  input.fixed = fixedWhere(input.mesh, [](const Vec3& p) { return p.x() == 0.0; });
  input.young_Pa = { 100.0 };
  input.unit_m = 0.1; // 1 N on a square of the unit
  const Mat3 f = Vec3(1.5, 0.85, 0.9).asDiagonal();
  for (const ElementKind element : elements)
  {
    input.element = element;
    const SoftBodyResult made = makeSoftBody(input);
    ASSERT_TRUE(made.body) << made.refusal;
    made.body->place(affine(*made.body, f));
    const Eigen::VectorXd forces = made.body->innerForces();
    double end = 0.0;
    for (std::size_t n = 0; n < made.body->points().rest_W.size(); ++n)
    {
      end -= made.body->points().rest_W[n].x() == 3.0 ? forces[3 * static_cast<Eigen::Index>(n)] : 0.0;
    }
    EXPECT_NEAR(end, 4.0 * stressOf(ElasticModel::NeoHookean, moduli, f)(0, 0), 1e-12);
  }
}

/// Tip of a bar of .1 x .02 x .02 m, 1 MPa, nu .3, fixed at one end, 1 N across spread evenly over the other [m].
double tipOf(ElementKind element, int r)
{
  SoftBodyInput input;
  input.mesh = blockOf({ 5 * r, r, r }, { 0.1, 0.02, 0.02 });
  input.fixed = fixedWhere(input.mesh, [](const Vec3& p) { return p.x() == 0.0; });
  input.young_Pa = { 1e6 };
  input.poisson = 0.3;
  input.element = element;
  input.model = ElasticModel::Linear;
  const SoftBodyResult made = makeSoftBody(input);
  EXPECT_TRUE(made.body) << made.refusal;
  const StrainPoints& points = made.body->points();
  Eigen::VectorXd load = Eigen::VectorXd::Zero(made.body->displacement().size());
  const auto across = [](std::uint32_t n) { return 3 * static_cast<Eigen::Index>(n) + 2; };
  const auto atEnd = [&made](std::uint32_t n) { return made.checked.mesh.vertices_W[n].x() > 0.1 - 1e-9; };
  std::map<std::array<std::uint32_t, 2>, std::uint32_t> middle;
  for (std::size_t h = 0; h < points.halves.size(); ++h)
  {
    middle[points.halves[h]] = static_cast<std::uint32_t>(points.rest_W.size() - points.halves.size() + h);
  }
  const double ofTriangle_N = 1.0 / (2.0 * r * r);
  for (const auto& t : borderOf(made.checked.mesh))
  {
    for (int i = 0; atEnd(t[0]) && atEnd(t[1]) && atEnd(t[2]) && i < 3; ++i)
    {
      const auto [low, high] = std::minmax(t[i], t[(i + 1) % 3]);
      const bool quadratic = element == ElementKind::Quadratic;
      load[across(quadratic ? middle.at({ low, high }) : t[i])] += ofTriangle_N / 3.0;
    }
  }
  return load.dot(made.body->linearAnswer(load));
}

TEST(SoftElements, EdgeSmoothedTetrahedraBendWhereLinearOnesLock)
{
  const double timoshenko_m = 0.02578;
  // docs/theory.md, "Elements that bend": exact solutions of the discretisations, computed independently, to three
  // digits.
  EXPECT_NEAR(tipOf(ElementKind::Linear, 1) / timoshenko_m, 0.233, 5e-4);
  EXPECT_NEAR(tipOf(ElementKind::Linear, 2) / timoshenko_m, 0.507, 5e-4);
  EXPECT_NEAR(tipOf(ElementKind::Linear, 4) / timoshenko_m, 0.782, 5e-4);
  EXPECT_NEAR(tipOf(ElementKind::EdgeSmoothed, 2) / timoshenko_m, 0.918, 2e-3);
  EXPECT_NEAR(tipOf(ElementKind::Quadratic, 2) / timoshenko_m, 0.978, 2e-3);
  // Clamped three-dimensional elasticity is 1.3 % stiffer than Timoshenko's beam, whose end may narrow.
  const double clamped_m = 0.02545;
  const double smoothed_m = tipOf(ElementKind::EdgeSmoothed, 4);
  EXPECT_GE(smoothed_m, 0.98 * clamped_m);
  EXPECT_LE(smoothed_m, clamped_m);
}

TEST(SoftElements, ATurnOfAllStrainsNothingButInHookesLaw)
{
  SoftBodyInput input;
  input.mesh = blockOf({ 2, 2, 2 }, { 1, 1, 1 });
  input.fixed = fixedWhere(input.mesh, [](const Vec3& p) { return p.x() == 0.0; });
  input.young_Pa = { 100.0 };
  input.unit_m = 0.1; // 1 N on a square of the unit
  const Mat3 turn = Eigen::AngleAxisd(2.5, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  for (const ElasticModel model : models)
  {
    input.model = model;
    const SoftBodyResult made = makeSoftBody(input);
    made.body->place(affine(*made.body, turn));
    const double most = made.body->innerForces().lpNorm<Eigen::Infinity>();
    EXPECT_EQ(most <= 1e-13, model != ElasticModel::Linear) << most;
  }
}

} // namespace
} // namespace palpate::test
