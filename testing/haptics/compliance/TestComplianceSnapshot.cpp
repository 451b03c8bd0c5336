// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <thread>

#include <gtest/gtest.h>

#include "SoftPads.h"
#include "haptics/compliance/snapshot/PointCompliance.h"
#include "testing/support/Linear.h"
#include "testing/support/Random.h"

namespace palpate::test
{
namespace
{

/// A random point of the pad's top within `half` of its middle.
SurfacePoint onTop(const SoftPad& soft, Random& random, double half)
{
  for (;;)
  {
    const std::uint32_t t = random.below(static_cast<std::uint32_t>(soft.surface.triangles.size()));
    const double a = random.uniform();
    const double b = random.uniform() * (1.0 - a);
    const SurfacePoint p = soft.pointOn(t, Vec3(1.0 - a - b, a, b));
    if (p.x_W.z() > 0.0499 && (p.x_W - soft.middle()).norm() < half)
    {
      return p;
    }
  }
}

TEST(ComplianceSnapshot, BetweenVerticesComplianceIsThatOfAPatchAroundThePoint)
{
  Random random(testSeed(186));
  SoftPad soft(16, 2.0, ElementKind::Linear); // patches of two edges: the least that is allowed
  const auto snapshot = soft.snapshot(0.0, 0.08);
  const BorderFaces border(soft.body->points(), borderOf(soft.mesh));
  for (std::size_t i = 0; i < testCount(12); ++i)
  {
    const SurfacePoint q = onTop(soft, random, 0.012);
    double patch_u = 0.0;
    for (int c = 0; c < 3; ++c)
    {
      patch_u += q.weights[c] * soft.surface.patch_u[q.vertices[c]];
    }
    SurfaceMap map;
    map.add(patchAt(border, q.x_W, soft.faceUnder(border, q), patch_u));
    const std::vector<std::uint32_t> first{ 0 };
    const double truth = soft.body->compliance(map.columnsOf(first))(2, 2);
    const CompliantPoint point = compliantPoint(*snapshot, q);
    EXPECT_NEAR(complianceBetween(*snapshot, point, point)(2, 2) / truth, 1.0, 0.005);
  }
}

TEST(ComplianceSnapshot, OfAnyPointsComplianceIsSymmetricAndNeverNegative)
{
  Random random(testSeed(187));
  SoftPad soft(8);
  const auto snapshot = soft.snapshot(0.0, 0.06);
  for (std::size_t trial = 0; trial < testCount(10); ++trial)
  {
    std::vector<CompliantPoint> points;
    for (int i = 0; i < 10; ++i)
    {
      points.push_back(compliantPoint(*snapshot, onTop(soft, random, 0.03)));
    }
    points.push_back(points.front()); // twice the same
    Eigen::MatrixXd w(33, 33);
    for (int i = 0; i < 11; ++i)
    {
      for (int j = 0; j < 11; ++j)
      {
        w.block<3, 3>(3 * i, 3 * j) = complianceBetween(*snapshot, points[i], points[j]);
      }
    }
    EXPECT_LE((w - w.transpose()).lpNorm<Eigen::Infinity>(), 1e-15 * w.lpNorm<Eigen::Infinity>());
    const Eigen::VectorXd own = test::eigenvaluesOf(w);
    EXPECT_GE(own[0], -1e-14 * own[32]);
    const Mat3 twice = w.topLeftCorner<3, 3>() - w.topRightCorner<3, 3>();
    EXPECT_LE(twice.norm(), 1e-14 * w.norm());
  }
}

/// Depth of a ball of r = 10 mm under a force on a half space of 20 kPa, nu .4, as Hertz has it.
double hertzForce(double depth)
{
  return 4.0 / 3.0 * 20e3 / (1.0 - 0.16) * std::sqrt(0.01) * std::pow(depth, 1.5);
}

/// Solves compliance F + s(F) = depth by bisection.
double forceAt(double depth, double compliance, const SubgridSpring& spring)
{
  double low = 0.0;
  double high = 10.0;
  for (int i = 0; i < 200; ++i)
  {
    const double f = 0.5 * (low + high);
    const double t = std::cbrt(f);
    (compliance * f + spring.hertz * t * t - spring.patch * f > depth ? high : low) = f;
  }
  return low;
}

TEST(ComplianceSnapshot, ABallIsAsFarFromHertzOnACoarseMeshAsOnAFineOne)
{
  // On 50 mm of rigid floor Hertz's force is to be multiplied by the layer's factor (docs/theory.md, "A patch, and
  // Hertz below it").
  const std::array<std::array<double, 2>, 2> depthAndLayer{ { { 0.25e-3, 1.0317 }, { 1e-3, 1.0653 } } };
  for (const int n : { 8, 12 }) // edges of 12.5 and 8.3 mm: up to 11 times the radius of the contact
  {
    for (const double edges : { 2.0, 3.0 })
    {
      if (n == 8 && edges == 3.0)
      {
        continue; // the patch would end at the sides of the pad
      }
      SoftPad soft(n, edges, ElementKind::EdgeSmoothed);
      const auto snapshot = soft.snapshot(0.01, 0.001);
      const SurfacePoint top = soft.top();
      const CompliantPoint point = compliantPoint(*snapshot, top);
      const double normal = complianceBetween(*snapshot, point, point)(2, 2);
      for (const auto& [depth, layer] : depthAndLayer)
      {
        const double ratio = forceAt(depth, normal, springAt(*snapshot, top)) / (layer * hertzForce(depth));
        EXPECT_NEAR(ratio, 1.0, 0.05) << n << " cells, patch of " << edges << " edges, depth " << depth;
      }
    }
  }
}

TEST(ComplianceSnapshot, WithTheForceOfItsStateTheSurfaceIsThatOfItsState)
{
  for (const ElasticModel model : { ElasticModel::Linear, ElasticModel::NeoHookean })
  {
    SoftPad soft(8, 2.0, ElementKind::EdgeSmoothed, [model](SoftBodyInput& input) { input.model = model; });
    SnapshotRequest request = soft.request(0.005);
    request.forceAt = { soft.top() };
    request.force_N = { Vec3(0.05, 0.02, -0.3) };
    SnapshotMaker maker(*soft.body, soft.surface);
    const auto snapshot = maker.make(request, 20);
    ASSERT_TRUE(snapshot);
    EXPECT_LE(snapshot->residual_N, 1e-10);
    for (std::size_t i = 0; i < snapshot->near.size(); ++i)
    {
      Vec3 place = snapshot->free_W[snapshot->near[i]];
      for (int c = 0; c < 3; ++c)
      {
        place += request.forceAt[0].weights[c] * snapshot->between(snapshot->near[i], request.forceAt[0].vertices[c]) *
                 request.force_N[0];
      }
      const std::uint32_t v = snapshot->near[i]; // at rest but for the force, which patches carry
      const Vec3 state = soft.surface.rest_W[v] + soft.surface.map.displacementOf(v, soft.body->displacement());
      EXPECT_LE((place - state).norm(), 1e-14);
    }
  }
}

TEST(ComplianceSnapshot, OfABodyThatIsCrushedTheFreeSurfaceIsTheUntouchedOneAndComplianceIsNotNegative)
{
  SoftPad soft(6, 2.0, ElementKind::EdgeSmoothed, [](SoftBodyInput& input) { input.model = ElasticModel::NeoHookean; });
  const std::vector<Vec3> untouched_W = soft.surface.placesOf(*soft.body);
  SnapshotMaker maker(*soft.body, soft.surface);
  SnapshotRequest request = soft.request(0.005);
  request.forceAt = { soft.top() };
  for (const int steps : { 1, 3, 20 }) // most of them before the body is at rest
  {
    for (const double force_N : { 0.3, 30.0, 3.0, 0.0 })
    {
      request.force_N = { Vec3(0.1 * force_N, 0.0, -force_N) };
      const auto snapshot = maker.make(request, steps);
      ASSERT_TRUE(snapshot);
      EXPECT_EQ(snapshot->free_W, untouched_W);
      EXPECT_EQ(snapshot->compliance, snapshot->compliance.transpose());
      const Eigen::VectorXd eigenvalues = eigenvaluesOf(snapshot->compliance);
      // Rounding of the factor's solves and of the eigenvalues themselves.
      EXPECT_GE(eigenvalues[0], -1e-12 * eigenvalues[eigenvalues.size() - 1]);
    }
  }
}

TEST(ComplianceSnapshot, IsTheSameToTheBitWhetherOneTwoOrFourThreadsMakeTheirOwn)
{
  const auto make = []
  {
    SoftPad soft(
      6, 2.0, ElementKind::EdgeSmoothed, [](SoftBodyInput& input) { input.model = ElasticModel::NeoHookean; });
    SnapshotRequest request = soft.request(0.005);
    request.forceAt = { soft.top() };
    request.force_N = { Vec3(0.1, 0.0, -0.5) };
    return SnapshotMaker(*soft.body, soft.surface).make(request);
  };
  const auto alone = make();
  ASSERT_TRUE(alone);
  for (const std::size_t count : { 2u, 4u })
  {
    std::vector<std::shared_ptr<const ComplianceSnapshot>> made(count);
    {
      std::vector<std::jthread> threads;
      for (auto& snapshot : made)
      {
        threads.emplace_back([&snapshot, &make] { snapshot = make(); });
      }
    }
    for (const auto& snapshot : made)
    {
      ASSERT_TRUE(snapshot);
      EXPECT_EQ(snapshot->compliance, alone->compliance);
      EXPECT_EQ(snapshot->free_W, alone->free_W);
      EXPECT_EQ(snapshot->energy_Nu, alone->energy_Nu);
    }
  }
}

TEST(ComplianceSnapshot, WhatIsKnownOfALinearBodyIsThatOfTheWholeBodyThoughVerticesComeAndGo)
{
  SoftPad soft(12, 2.0, ElementKind::Linear);
  SpreadPatches patches(soft.surface, 0.0);
  ComplianceCache known(*soft.body, patches);
  const auto around = [&soft](const Vec3& p_W)
  { return nearVerticesOf(soft.surface, soft.surface.rest_W, p_W, 1.0, 90); };
  EXPECT_EQ(known.learn(around(SoftPad::middle()), 5).size(), 90u); // of nothing known all is learnt at once
  std::vector<std::uint32_t> asked;
  const std::array<Vec3, 7> places{ { { 0.06, 0.05, 0.05 }, { 0.0, 0.0, 0.05 }, { 0.1, 0.1, 0.05 }, { 0.0, 0.1, 0.03 },
    { 0.1, 0.0, 0.03 }, { 0.0, 0.1, 0.03 }, { 0.05, 0.05, 0.05 } } };
  for (const Vec3& p_W : places)
  {
    const std::vector<std::uint32_t> wanted = around(p_W);
    const std::vector<std::uint32_t> before = known.learn(wanted, 0);
    const std::vector<std::uint32_t> after = known.learn(wanted, 70);
    EXPECT_EQ(after.size(), std::min<std::size_t>(before.size() + 70, 90));
    EXPECT_TRUE(std::ranges::all_of(after, [&](std::uint32_t v) { return std::ranges::count(wanted, v) == 1; }));
    const Eigen::MatrixXd found = known.between(after);
    const Eigen::MatrixXd whole = soft.body->compliance(soft.surface.map.columnsOf(after));
    EXPECT_EQ(found, found.transpose());
    EXPECT_LE((found - whole).lpNorm<Eigen::Infinity>(), 1e-13 * whole.lpNorm<Eigen::Infinity>());
    asked.insert(asked.end(), after.begin(), after.end());
  }
  std::ranges::sort(asked);
  asked.erase(std::unique(asked.begin(), asked.end()), asked.end());
  EXPECT_GT(asked.size(), ComplianceCache::mostKnown); // so that some were forgotten
}

TEST(ComplianceSnapshot, AHandThatCrossesAPatchWithinThePeriodOfTheBodyStrikesIt)
{
  SoftPad soft(6);
  SnapshotRequest request = soft.request(0.005);
  request.period_s = 0.001;
  // A patch is 2.5 mean edges, between 2.5 and 3.54 cells of .1 / 6 m: crossed in .42 to .59 s at .1 m/s.
  request.velocity_u_per_s = Vec3(0.1, 0.0, 0.0);
  EXPECT_FALSE(SnapshotMaker(*soft.body, soft.surface).make(request)->struck);
  EXPECT_FALSE(SnapshotMaker(*soft.body, soft.surface, 0.40).make(request)->struck);
  EXPECT_TRUE(SnapshotMaker(*soft.body, soft.surface, 0.60).make(request)->struck);
  request.period_s = 0.60; // nor can the worker
  EXPECT_TRUE(SnapshotMaker(*soft.body, soft.surface).make(request)->struck);
}

TEST(ComplianceSnapshot, OfPatchesThatAreNotAlikeComplianceIsNeverNegativeToo)
{
  Random random(testSeed(195));
  // Cells grow eightfold along x: so do patches.
  SoftPad soft(8, 2.0, ElementKind::Linear,
    [](SoftBodyInput& input)
    {
      for (Vec3& p : input.mesh.vertices_W)
      {
        p.x() = 0.1 * (std::pow(8.0, p.x() / 0.1) - 1.0) / 7.0;
      }
    });
  ComplianceSnapshot snapshot = *soft.snapshot(0.0, 0.2);
  double least_u = 1.0;
  double most_u = 0.0;
  for (const double patch_u : snapshot.patchRadius_u)
  {
    least_u = std::min(least_u, patch_u);
    most_u = std::max(most_u, patch_u);
  }
  EXPECT_GT(most_u, 1.5 * least_u);
  double worst = 0.0;
  for (std::size_t trial = 0; trial < testCount(30); ++trial)
  {
    Eigen::MatrixXd w(60, 60);
    std::vector<CompliantPoint> points;
    for (int i = 0; i < 20; ++i)
    {
      points.push_back(compliantPoint(snapshot, onTop(soft, random, 0.06)));
      points.back().own = Mat3::Identity(); // the kernel alone
    }
    for (int i = 0; i < 20; ++i)
    {
      for (int j = 0; j < 20; ++j)
      {
        const CompliantPoint& a = points[static_cast<std::size_t>(i)];
        const CompliantPoint& b = points[static_cast<std::size_t>(j)];
        CompliantPoint bareA = a;
        bareA.own.setZero();
        w.block<3, 3>(3 * i, 3 * j) = complianceBetween(snapshot, a, b) - complianceBetween(snapshot, bareA, b);
      }
    }
    worst = std::min(worst, test::eigenvaluesOf(w)[0]);
  }
  EXPECT_GE(worst, -1e-12);
}

TEST(ComplianceSnapshot, WhereAllCornersAnswerAsOneTheirPointDoesToo)
{
  Random random(testSeed(218));
  SoftPad soft(6);
  ComplianceSnapshot snapshot = *soft.snapshot(0.0, 0.06);
  snapshot.placeOf.assign(snapshot.placeOf.size(), 0); // as outside of the neighbourhood
  const Mat3 one = snapshot.compliance.topLeftCorner<3, 3>();
  for (std::size_t i = 0; i < testCount(200); ++i)
  {
    const CompliantPoint point = compliantPoint(snapshot, onTop(soft, random, 0.04));
    EXPECT_LE((complianceBetween(snapshot, point, point) - one).norm(), 1e-12 * one.norm());
  }
}

TEST(ComplianceSnapshot, ItsNeighbourhoodLiesAheadAndWhatIsOutsideAnswersAsTheNearestVertex)
{
  SoftPad soft(16, 2.0, ElementKind::Linear);
  SnapshotRequest request = soft.request(0.005);
  SnapshotMaker maker(*soft.body, soft.surface);
  const auto resting = maker.make(request);
  request.velocity_u_per_s = Vec3(0.2, 0.0, 0.0);
  const auto moving = maker.make(request);
  ASSERT_TRUE(resting && moving);
  const auto middleOf = [&soft](const ComplianceSnapshot& snapshot)
  {
    Vec3 sum = Vec3::Zero();
    for (const std::uint32_t v : snapshot.near)
    {
      sum += soft.surface.rest_W[v] / static_cast<double>(snapshot.near.size());
    }
    return sum;
  };
  EXPECT_NEAR(middleOf(*resting).x(), 0.05, 0.002);
  EXPECT_NEAR(middleOf(*moving).x(), 0.05 + 1.5 * 0.04 * 0.2, 0.005);
  EXPECT_GT(moving->near.size(), resting->near.size());
  EXPECT_LE(moving->near.size(), SnapshotMaker::usualVertices);
  for (std::uint32_t v = 0; v < soft.surface.rest_W.size(); ++v)
  {
    const std::uint32_t nearest = resting->near[resting->placeOf[v]];
    EXPECT_EQ(resting->between(v, v), resting->between(nearest, nearest));
    const bool within = std::find(resting->near.begin(), resting->near.end(), v) != resting->near.end();
    EXPECT_EQ(within, nearest == v);
  }
  EXPECT_EQ(nearVerticesOf(soft.surface, soft.surface.rest_W, soft.middle(), 1.0, 7).size(), 7u);
}

/// How far a wall of 80 x 80 x 16 mm, 100 kPa, fixed around, goes in under a tip in the middle of it [m/N].
double wallUnder(int n, double tip_u)
{
  SoftPad wall(n, patchEdges, ElementKind::EdgeSmoothed,
    [n](SoftBodyInput& input)
    {
      input.mesh = blockOf({ n, n, n / 5 }, { 0.08, 0.08, 0.016 });
      input.fixed = fixedWhere(input.mesh,
        [](const Vec3& p) {
          return std::min({ p.x(), p.y(), 0.08 - p.x(), 0.08 - p.y() }) < 1e-9;
        });
      input.young_Pa = { 100e3 };
    });
  SnapshotRequest request;
  request.ball_W = Vec3(0.04, 0.04, 0.016);
  request.tip_u = tip_u;
  const auto snapshot = SnapshotMaker(*wall.body, wall.surface).make(request);
  const std::uint32_t at = snapshot->near.front();
  return snapshot->between(at, at)(2, 2);
}

TEST(ComplianceSnapshot, UnderATipAWallGivesWayByItsRadiusAndNotByItsEdges)
{
  // The mean under a paraboloid of pressure (1 / pi) int (8 J2(s) / s^2)^2 ds = .65875 of 1 / (E* r), by quadrature.
  const auto onHalfSpace = [](double tip_u) { return 0.65875 * (1.0 - 0.16) / (100e3 * tip_u); };
  for (const double tip_u : { 0.0006, 0.002 })
  {
    const double coarse = wallUnder(10, tip_u);
    const double fine = wallUnder(20, tip_u);
    EXPECT_NEAR(coarse / fine, 1.0, 0.15); // its bending is of one or two elements through it
    EXPECT_NEAR(fine / onHalfSpace(tip_u), 1.0, 0.4);
  }
  for (const int n : { 5, 10, 20 }) // between two tips bending is the same
  {
    const double more = wallUnder(n, 0.0006) - wallUnder(n, 0.002);
    EXPECT_NEAR(more / (onHalfSpace(0.0006) - onHalfSpace(0.002)), 1.0, 0.01) << n;
  }
}

TEST(ComplianceSnapshot, WithNodesHalfwayTheDentOfATipAsWideAsItsPatchIsWhatThePatchLacks)
{
  // Between radii a (1 - e) and a the compliance of a half space differs by e / (1 - e) of .65875 / (E* a), and that of
  // a layer by less. The patch of nodes half an edge apart lacks .25 % of that compliance (docs/theory.md); it would be
  // 1.2 % of nodes an edge apart.
  constexpr double narrower = 1e-3;
  const double lack = 0.1 * std::pow(0.5 / patchEdges, 2.3);
  for (const double poisson : { 0.45, 0.49 })
  {
    SoftPad soft(6, patchEdges, ElementKind::Quadratic, [poisson](SoftBodyInput& input) { input.poisson = poisson; });
    const SurfacePoint top = soft.top();
    Eigen::Index corner = 0;
    top.weights.maxCoeff(&corner);
    const std::uint32_t v = top.vertices[static_cast<std::size_t>(corner)];
    const double patch_u = soft.surface.patch_u[v];
    SnapshotMaker maker(*soft.body, soft.surface);
    SnapshotRequest request = soft.request(0.0);
    const double bare = maker.make(request)->between(v, v)(2, 2);
    request.tip_u = (1.0 - narrower) * patch_u;
    const double dent = maker.make(request)->between(v, v)(2, 2) - bare;
    const double halfSpace = 0.65875 / (soft.surface.stiffness[v] * patch_u);
    EXPECT_GT(dent, 0.0) << poisson;
    EXPECT_LE(dent, (1.01 * narrower + lack) * halfSpace) << poisson;
    EXPECT_GE(dent, 0.9 * lack * halfSpace) << poisson;
  }
}

TEST(ComplianceSnapshot, WhatIsKeptIsThatOfOneBallHoweverOftenItsRadiusChanges)
{
  SoftPad soft(16);
  SnapshotMaker maker(*soft.body, soft.surface);
  const auto pressed = [&soft](double radius_u, double tip_u, double force_N)
  {
    SnapshotRequest request = soft.request(radius_u);
    request.tip_u = tip_u;
    request.forceAt = { soft.top() };
    request.force_N = { Vec3(0.0, 0.0, -force_N) };
    return request;
  };
  std::size_t most = 0;
  for (int i = 0; i < 6; ++i)
  {
    const double radius_u = 0.02 + 0.006 * i;
    for (const double force_N : { 0.0, 0.5, 20.0, 0.0 })
    {
      ASSERT_TRUE(maker.make(pressed(radius_u, 0.0, force_N)));
      most = std::max(most, maker.widths());
    }
    ASSERT_TRUE(maker.make(pressed(0.0, radius_u, 0.5)));
    most = std::max(most, maker.widths());
  }
  EXPECT_GT(most, 2u); // patches of several widths for one ball
  EXPECT_LE(most, SnapshotMaker::mostWidths);
  const auto after = maker.make(pressed(0.05, 0.0, 20.0));
  const auto alone = SnapshotMaker(*soft.body, soft.surface).make(pressed(0.05, 0.0, 20.0));
  EXPECT_EQ(after->near, alone->near);
  EXPECT_EQ(after->compliance, alone->compliance);
}

} // namespace
} // namespace palpate::test
