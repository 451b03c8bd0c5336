// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <numeric>
#include <thread>

#include <gtest/gtest.h>

#include "SoftPads.h"
#include "haptics/compliance/body/KeptInverse.h"
#include "testing/support/Eventually.h"
#include "testing/support/Linear.h"
#include "testing/support/Random.h"

namespace palpate::test
{
namespace
{

/// The numbers of a body's nodes that move.
std::vector<Eigen::Index> movingRows(const SoftBody& body)
{
  std::vector<Eigen::Index> rows;
  for (std::size_t n = 0; n < body.points().rest_W.size(); ++n)
  {
    for (int axis = 0; axis < 3 && !body.isHeld(n); ++axis)
    {
      rows.push_back(static_cast<Eigen::Index>(3 * n) + axis);
    }
  }
  return rows;
}

/// K^-1 of all nodes, 0 where they are held: K from the forces of a linear body that one number of its displacement
/// after the other is set of, solved as a full matrix. No pattern, no order of elimination, no factor of the product.
Eigen::MatrixXd fullInverse(SoftBody& body)
{
  const Eigen::VectorXd before = body.displacement();
  const std::vector<Eigen::Index> rows = movingRows(body);
  Eigen::MatrixXd k(rows.size(), rows.size());
  for (std::size_t c = 0; c < rows.size(); ++c)
  {
    body.place(Eigen::VectorXd::Unit(before.size(), rows[c]));
    k.col(static_cast<Eigen::Index>(c)) = -body.innerForces()(rows);
  }
  body.place(before);
  Eigen::MatrixXd inverse = Eigen::MatrixXd::Zero(before.size(), before.size());
  inverse(rows, rows) = solvedSymmetric(k, Eigen::MatrixXd::Identity(k.rows(), k.cols()));
  return inverse;
}

Eigen::MatrixXd dense(const SparseColumns& h, Eigen::Index rows)
{
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(rows, static_cast<Eigen::Index>(h.count()));
  for (std::size_t c = 0; c < h.count(); ++c)
  {
    for (std::size_t i = h.start[c]; i < h.start[c + 1]; ++i)
    {
      all(h.rows[i], static_cast<Eigen::Index>(c)) += h.values[i];
    }
  }
  return all;
}

std::shared_ptr<KeptInverse> keptOf(const SoftPad& soft, const Vec3& place_W, std::size_t most = KeptInverse::mostNodes)
{
  auto kept = std::make_shared<KeptInverse>(*soft.body, borderNodesFrom(soft.surface, place_W));
  while (kept->known() < most && kept->condenseNext())
  {
  }
  return kept;
}

std::vector<std::uint32_t> allVertices(const SoftSurface& surface)
{
  std::vector<std::uint32_t> all(surface.vertices.size());
  std::iota(all.begin(), all.end(), 0u);
  return all;
}

class OfEachElement : public testing::TestWithParam<ElementKind>
{
};

TEST_P(OfEachElement, TheKeptInverseIsThatOfTheWholeBodyInverted)
{
  SoftPad soft(4, 2.0, GetParam());
  const Eigen::MatrixXd whole = fullInverse(*soft.body);
  const auto kept = keptOf(soft, SoftPad::middle());
  EXPECT_EQ(kept->known(), kept->size());
  const SparseColumns patches = soft.surface.map.columnsOf(allVertices(soft.surface));
  ASSERT_TRUE(kept->knows(patches)); // held nodes among them
  const Eigen::MatrixXd h = dense(patches, whole.rows());
  const Eigen::MatrixXd truth = h.transpose() * whole * h;
  const Eigen::MatrixXd found = kept->compliance(patches, patches);
  EXPECT_LE((found - truth).lpNorm<Eigen::Infinity>(), 1e-12 * truth.lpNorm<Eigen::Infinity>());
  const std::vector<std::uint32_t> few{ 3, 17, 11 };
  const Eigen::MatrixXd some = kept->compliance(patches, soft.surface.map.columnsOf(few));
  for (std::size_t i = 0; i < few.size(); ++i)
  {
    EXPECT_LE((some.middleCols<3>(static_cast<Eigen::Index>(3 * i)) - truth.middleCols<3>(3 * few[i])).norm(),
      1e-12 * truth.lpNorm<Eigen::Infinity>());
  }
}

INSTANTIATE_TEST_SUITE_P(
  KeptInverse, OfEachElement, testing::Values(ElementKind::Linear, ElementKind::EdgeSmoothed, ElementKind::Quadratic));

/// A ball or a point somewhere on the top, under a force that pushes it in.
SnapshotRequest somewhere(const SoftPad& soft, Random& random)
{
  SnapshotRequest request = soft.request(std::array{ 0.0, 0.004, 0.03 }[random.below(3)]);
  request.tip_u = request.radius_u > 0.0 ? 0.0 : 0.002;
  request.ball_W += Vec3(random.uniform(-0.03, 0.03), random.uniform(-0.03, 0.03), 0.0);
  request.velocity_u_per_s = 0.2 * random.direction();
  const auto isUnder = [&](const std::array<std::uint32_t, 3>& t)
  { return (soft.surface.rest_W[t[0]] - request.ball_W).norm() < 0.015; };
  const auto under = std::ranges::find_if(soft.surface.triangles, isUnder);
  request.forceAt = { soft.pointOn(
    static_cast<std::uint32_t>(under - soft.surface.triangles.begin()), Vec3(0.5, 0.3, 0.2)) };
  request.force_N = { Vec3(random.uniform(-0.2, 0.2), 0.1, random.uniform(-1.0, -0.1)) };
  return request;
}

/// Of each vertex that both have.
void expectAlike(const ComplianceSnapshot& found, const ComplianceSnapshot& truth, double share)
{
  ASSERT_EQ(found.near, truth.near);
  const double most = truth.compliance.lpNorm<Eigen::Infinity>();
  EXPECT_LE((found.compliance - truth.compliance).lpNorm<Eigen::Infinity>(), share * most);
  EXPECT_EQ(found.free_W, truth.free_W);
  EXPECT_EQ(found.placeOf, truth.placeOf);
  EXPECT_NEAR(found.energy_Nu, truth.energy_Nu, share * (std::abs(truth.energy_Nu) + most));
  for (std::size_t i = 0; i < found.springs.size(); ++i)
  {
    for (std::size_t k = 0; k < SubgridSpring::knots; ++k)
    {
      EXPECT_NEAR(found.springs[i].depth_u[k], truth.springs[i].depth_u[k], 1e3 * share * 0.01);
    }
  }
}

TEST(KeptInverse, ASnapshotOfItIsThatOfTheFactorWhateverPressesWherever)
{
  Random random(testSeed(401));
  SoftPad soft(8, 2.0, ElementKind::Linear);
  SnapshotMaker byKept(*soft.body, soft.surface);
  byKept.answerBy(keptOf(soft, SoftPad::middle()));
  SnapshotMaker byFactor(*soft.body, soft.surface);
  for (std::size_t i = 0; i < testCount(30); ++i)
  {
    const SnapshotRequest request = somewhere(soft, random);
    const auto found = byKept.make(request);
    EXPECT_TRUE(byKept.answeredByKept());
    const auto truth = byFactor.make(request);
    EXPECT_FALSE(byFactor.answeredByKept());
    expectAlike(*found, *truth, 1e-12);
    // Where the body is not brought to its rest, the drawn shape is found later.
    EXPECT_LE((soft.body->restUnder(byKept.load_N()) - soft.body->displacement()).norm(),
      1e-12 * soft.body->displacement().norm());
  }
}

TEST(KeptInverse, NothingInsideTheBodyIsAskedForASnapshot)
{
  // A body that is twice as stiff stands behind the inverse of the first: a number of its own would be half of the
  // other.
  SoftPad soft(8, 2.0, ElementKind::Linear);
  SoftPad stiffer(8, 2.0, ElementKind::Linear, [](SoftBodyInput& input) { input.young_Pa.front() *= 2.0; });
  for (const double radius_u : { 0.0, 0.004, 0.06 }) // the last is wider than its patch
  {
    SnapshotRequest request = soft.request(radius_u);
    request.tip_u = radius_u > 0.0 ? 0.0 : 0.002;
    request.velocity_u_per_s = Vec3(0.0, 0.0, -0.3);
    request.forceAt = { soft.top() };
    request.force_N = { Vec3(0.1, 0.0, -0.5) };
    SnapshotMaker maker(*stiffer.body, soft.surface);
    maker.answerBy(keptOf(soft, SoftPad::middle()));
    const Eigen::VectorXd marked = Eigen::VectorXd::Constant(stiffer.body->displacement().size(), 0.125);
    stiffer.body->place(marked);
    const auto found = maker.make(request);
    EXPECT_TRUE(maker.answeredByKept());
    EXPECT_EQ(stiffer.body->displacement(), marked);
    expectAlike(*found, *SnapshotMaker(*soft.body, soft.surface).make(request), 1e-12);
  }
}

TEST(KeptInverse, NumbersAreThoseOfTheEndWheneverTheyAreAskedFor)
{
  SoftPad soft(8, 2.0, ElementKind::Linear);
  const auto whole = keptOf(soft, SoftPad::middle());
  const auto part = keptOf(soft, SoftPad::middle(), 160);
  ASSERT_LT(part->known(), part->size());
  const auto near = nearVerticesOf(soft.surface, soft.surface.rest_W, SoftPad::middle(), 0.02, 12);
  const SparseColumns patches = soft.surface.map.columnsOf(near);
  ASSERT_TRUE(part->knows(patches));
  EXPECT_EQ(part->compliance(patches, patches), whole->compliance(patches, patches)); // to the bit
  EXPECT_FALSE(part->knows(soft.surface.map.columnsOf(allVertices(soft.surface))));
}

TEST(KeptInverse, BeforeItKnowsWhatIsPressedTheFactorAnswers)
{
  SoftPad soft(8, 2.0, ElementKind::Linear);
  const auto kept = keptOf(soft, Vec3(0.0, 0.0, 0.05), 16);
  SnapshotMaker maker(*soft.body, soft.surface);
  maker.answerBy(kept);
  Random random(testSeed(403));
  const SnapshotRequest request = somewhere(soft, random);
  const auto early = maker.make(request);
  EXPECT_FALSE(maker.answeredByKept());
  while (kept->condenseNext())
  {
  }
  const auto late = maker.make(request);
  expectAlike(*late, *early, 1e-12);
}

TEST(KeptInverse, AnswersWhileItIsCondensedInAnotherThread)
{
  SoftPad soft(8, 2.0, ElementKind::Linear);
  auto kept = std::make_shared<KeptInverse>(*soft.body, borderNodesFrom(soft.surface, SoftPad::middle()));
  SnapshotMaker maker(*soft.body, soft.surface);
  maker.answerBy(kept);
  SnapshotMaker byFactor(*soft.body, soft.surface);
  const SnapshotRequest request = soft.request(0.004);
  const auto truth = byFactor.make(request);
  ASSERT_TRUE(maker.make(request));
  EXPECT_FALSE(maker.answeredByKept()) << "nothing is condensed yet";
  std::jthread aside(
    [&kept]
    {
      while (kept->condenseNext())
      {
      }
    });
  EXPECT_TRUE(eventually(
    [&]
    {
      expectAlike(*maker.make(request), *truth, 1e-12);
      return maker.answeredByKept();
    }));
}

TEST(KeptInverse, OfALawThatBendsNothingIsKept)
{
  SoftPad soft(4, 2.0, ElementKind::Linear, [](SoftBodyInput& input) { input.model = ElasticModel::NeoHookean; });
  SnapshotMaker maker(*soft.body, soft.surface);
  maker.answerBy(keptOf(soft, SoftPad::middle()));
  ASSERT_TRUE(maker.make(soft.request(0.004)));
  EXPECT_FALSE(maker.answeredByKept());
}

TEST(ComplianceSnapshot, UnderAFeatherALawThatBendsAnswersAsHookesOnPatchesOfAnyWidth)
{
  std::vector<std::shared_ptr<const ComplianceSnapshot>> found;
  for (const double radius_u : { 0.004, 0.06 }) // patches as their edges ask for, and as wide as the ball
  {
    for (const ElasticModel model : { ElasticModel::Linear, ElasticModel::NeoHookean })
    {
      SoftPad soft(8, 2.0, ElementKind::Linear, [model](SoftBodyInput& input) { input.model = model; });
      SnapshotRequest request = soft.request(radius_u);
      request.velocity_u_per_s = Vec3(0.0, 0.0, -0.3); // so that the ball will soon press a wide contact
      request.forceAt = { soft.top() };
      request.force_N = { Vec3(0.0, 0.0, -1e-6) };
      found.push_back(SnapshotMaker(*soft.body, soft.surface).make(request, 3));
    }
    const Eigen::MatrixXd& hooke = found[found.size() - 2]->compliance;
    EXPECT_LE((found.back()->compliance - hooke).lpNorm<Eigen::Infinity>(), 1e-5 * hooke.lpNorm<Eigen::Infinity>());
  }
  EXPECT_GT(found[2]->patchRadius_u.front(), 1.1 * found[0]->patchRadius_u.front());
}

TEST(ComplianceSnapshot, NothingIsKnownOfAFactorThatThereIsNoMore)
{
  for (const double radius_u : { 0.004, 0.06 }) // the second is wider than its patch
  {
    SoftPad soft(8, 2.0, ElementKind::Linear, [](SoftBodyInput& i) { i.model = ElasticModel::NeoHookean; });
    SnapshotMaker going(*soft.body, soft.surface);
    SnapshotRequest request = soft.request(radius_u);
    request.velocity_u_per_s = Vec3(0.0, 0.0, -0.3);
    request.forceAt = { soft.top() };
    request.force_N = { Vec3::Zero() }; // without a force there is no secant, and without a step the state stays
    const auto before = going.make(request, 0);
    Eigen::VectorXd load = Eigen::VectorXd::Zero(soft.body->displacement().size());
    soft.surface.map.addForce(soft.top().vertices[0], Vec3(0.3, 0.0, -3.0), load);
    ASSERT_TRUE(soft.body->settle(load, 20) && soft.body->refactor());
    const auto after = going.make(request, 0);
    const auto truth = SnapshotMaker(*soft.body, soft.surface).make(request, 0);
    ASSERT_EQ(after->near, truth->near);
    EXPECT_EQ(after->compliance, truth->compliance);
    for (std::size_t i = 0; i < truth->springs.size(); ++i)
    {
      EXPECT_EQ(after->springs[i].depth_u, truth->springs[i].depth_u);
    }
    EXPECT_GT((after->compliance - before->compliance).lpNorm<Eigen::Infinity>(),
      0.01 * after->compliance.lpNorm<Eigen::Infinity>())
      << "the factor is to be another one";
  }
}

TEST(ComplianceSnapshot, WhatIsKnownOfAnOldFactorIsThatOfTheFactor)
{
  SoftPad soft(8, 2.0, ElementKind::Linear, [](SoftBodyInput& input) { input.model = ElasticModel::NeoHookean; });
  soft.body->factorsBe(Factoring::WhenOld);
  SnapshotMaker going(*soft.body, soft.surface);
  Random random(testSeed(404));
  std::size_t factorings = soft.body->factorings();
  std::size_t kept = 0;
  for (std::size_t i = 0; i < testCount(20); ++i)
  {
    SnapshotRequest request = somewhere(soft, random);
    request.radius_u = 0.004;
    request.force_N.front() *= 0.2 * static_cast<double>(i % 3); // now and then nothing
    const auto found = going.make(request);
    // The secant is the state's, the rest of the factor's compliance is to be the same.
    const Eigen::MatrixXd whole = soft.body->compliance(soft.surface.map.columnsOf(found->near));
    if (request.force_N.front().isZero())
    {
      EXPECT_LE((found->compliance - whole).lpNorm<Eigen::Infinity>(), 1e-12 * whole.lpNorm<Eigen::Infinity>());
    }
    kept += soft.body->factorings() == factorings;
    factorings = soft.body->factorings();
  }
  EXPECT_GT(kept, 0u);
}

} // namespace
} // namespace palpate::test
