// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "PressedLayer.h"
#include "testing/support/LongForm.h"

namespace palpate::test
{
namespace
{

/// A ball pressed so deep into a layer.
struct Study
{
  double ball_m;
  double depth_m;
  double thickness_m;
  std::vector<double> usual_m; ///< edges in every run; with PALPATE_TEST_FULL those of the grid besides
};

/// Why a layer of that thickness is not studied with such edges; empty: it is.
std::string refusalOf(double thickness_m, double edge_m)
{
  if (edge_m > thickness_m)
  {
    return "the layer is thinner than an element";
  }
  if (edge_m > 0.5 * thickness_m)
  {
    return "a single element through a layer has its strain no room to differ below the ball";
  }
  if (edge_m < 0.0008 && thickness_m > 0.002)
  {
    return "the study ends at .8 mm, but on the layer of 2 mm, which has two elements there";
  }
  return "";
}

/// Vertices of a body whose factor takes some 8 GB: of .8 mm under a ball of 20 mm 52,800 take 4.2 GB, and memory goes
/// with their number to the power of 1.4.
constexpr std::size_t mostVertices = 85'000;

/// With PALPATE_TEST_FULL from 17 mm to .8 mm, on the thinnest layer to .4 mm. The finest take minutes and gigabytes.
std::vector<double> edgesOf(const Study& study)
{
  std::vector<double> edges = study.usual_m;
  if (isLongForm())
  {
    for (const double edge : { 0.017, 0.0125, 0.00625, 0.004, 0.0029, 0.0021, 0.0012, 0.0008, 0.0005, 0.0004 })
    {
      const std::string refusal = refusalOf(study.thickness_m, edge);
      if (!refusal.empty())
      {
        std::cout << "layer " << 1e3 * study.thickness_m << " mm, edge " << 1e3 * edge << " mm: " << refusal
                  << std::endl;
      }
      const bool isNew = refusal.empty() && std::ranges::find(edges, edge) == edges.end();
      edges.insert(edges.end(), isNew ? 1 : 0, edge);
    }
  }
  std::ranges::sort(edges, std::greater<>());
  return edges;
}

/// Each within 3 % of the truth, and no finer mesh further from it than a coarser one but for 1 %.
void expectTruth(const Study& study)
{
  const oracle::Layer layer{ 20e3, 0.4, study.thickness_m };
  const oracle::BallContact truth = oracle::contactOfDepth(layer, study.ball_m, study.depth_m);
  double leastOff = 0.03;
  for (const double edge : edgesOf(study))
  {
    const SoftBodyInput input = layerOf(layer, edge, 1.2 * truth.radius_m + edge);
    if (input.mesh.vertices_W.size() > mostVertices)
    {
      std::cout << "ball " << 1e3 * study.ball_m << " mm, layer " << 1e3 * study.thickness_m << " mm, edge "
                << 1e3 * edge << " mm: " << input.mesh.vertices_W.size() << " vertices do not fit into 8 GB"
                << std::endl;
      continue;
    }
    Presser presser(input, study.ball_m);
    const double at = presser.press(study.depth_m) / truth.force_N;
    const double between = presser.press(study.depth_m, Vec3(0.37 * edge, 0.21 * edge, 0.0)) / truth.force_N;
    std::ostringstream which;
    which << "ball " << 1e3 * study.ball_m << " mm, layer " << 1e3 * study.thickness_m << " mm, edge " << 1e3 * edge
          << " mm: " << at << " of " << truth.force_N << " N at a vertex, " << between << " between vertices";
    std::cout << which.str() << std::endl; // at once: the next mesh may take minutes
    EXPECT_LE(std::abs(at - 1.0), std::max(leastOff, 0.01)) << which.str();
    EXPECT_NEAR(between, 1.0, 0.03) << which.str();
    leastOff = std::min(leastOff, std::abs(at - 1.0));
  }
}

TEST(MeshStudy, ABallOf20mmOn50mmIsTheTrueOneOnEveryMesh)
{
  expectTruth({ 0.02, 0.003, 0.05, { 0.017, 0.00625, 0.0029 } });
}

TEST(MeshStudy, ABallOf50mmOn50mmIsTheTrueOneOnEveryMesh)
{
  expectTruth({ 0.05, 0.003, 0.05, { 0.017, 0.0125, 0.00625, 0.004 } });
}

TEST(MeshStudy, AContactOfMillimetresIsTheTrueOneOnEveryMesh)
{
  expectTruth({ 0.01, 0.001, 0.05, { 0.0125, 0.004 } });
  expectTruth({ 0.002, 0.0003, 0.05, { 0.017, 0.0012 } });
}

TEST(MeshStudy, FromTwoElementsThroughItOnALayerOf10Or20mmIsAsStiffAsItIs)
{
  expectTruth({ 0.002, 0.0003, 0.02, { 0.01, 0.0029 } });
  expectTruth({ 0.01, 0.001, 0.02, { 0.01, 0.004 } });
  expectTruth({ 0.02, 0.002, 0.02, { 0.01, 0.004 } });
  expectTruth({ 0.05, 0.002, 0.02, { 0.01, 0.004 } });
  expectTruth({ 0.002, 0.0003, 0.01, { 0.005, 0.0021 } });
  expectTruth({ 0.01, 0.001, 0.01, { 0.005, 0.0021 } });
  expectTruth({ 0.02, 0.002, 0.01, { 0.005, 0.0021 } });
  expectTruth({ 0.05, 0.002, 0.01, { 0.005, 0.0029 } });
}

TEST(MeshStudy, FromTwoElementsThroughItOnALayerOf5mmIsAsStiffAsItIs)
{
  expectTruth({ 0.002, 0.0003, 0.005, { 0.0025 } });
  expectTruth({ 0.01, 0.001, 0.005, { 0.0025, 0.00125 } });
  expectTruth({ 0.02, 0.001, 0.005, { 0.0025 } });
  expectTruth({ 0.05, 0.0005, 0.005, { 0.0025 } });
}

TEST(MeshStudy, FromTwoElementsThroughItOnALayerOf2mmIsAsStiffAsItIs)
{
  expectTruth({ 0.002, 0.0002, 0.002, { 0.001 } });
  expectTruth({ 0.01, 0.0002, 0.002, { 0.001, 0.0005 } });
  expectTruth({ 0.02, 0.0002, 0.002, {} });
  expectTruth({ 0.05, 0.0001, 0.002, { 0.001 } }); // contacts of many thicknesses
}

TEST(MeshStudy, AlongTheSurfaceAContactGivesWayAsMindlinSays)
{
  // On a half space: 1 / (8 G* a), G* = G / (2 - nu). The base is 60 contacts deep.
  const oracle::Layer layer;
  const double shear = layer.young_Pa / (2.0 * (1.0 + layer.poisson));
  for (const double edge : { 0.017, 0.00625 })
  {
    Presser presser(layerOf(layer, edge, edge), 0.002);
    const double depth_m = 0.0003;
    presser.press(depth_m);
    const double contact_m = oracle::contactOfDepth(layer, 0.002, depth_m).radius_m;
    const double truth = (2.0 - layer.poisson) / (8.0 * shear * contact_m);
    EXPECT_NEAR(presser.givesAlong(1e-6) / truth, 1.0, 0.03) << "edge " << edge;
  }
}

TEST(BallOnLayer, IsSneddonsBallFarFromTheBase)
{
  const oracle::Layer deep{ 20e3, 0.4, 50.0 };
  for (const double contact_m : { 1e-4, 2e-3, 7e-3 })
  {
    const oracle::BallContact found = oracle::contactOfRadius(deep, 0.01, contact_m);
    const oracle::BallContact truth = oracle::onHalfSpace(20e3, 0.4, 0.01, contact_m);
    EXPECT_NEAR(found.depth_m / truth.depth_m, 1.0, 1e-3);
    EXPECT_NEAR(found.force_N / truth.force_N, 1.0, 1e-3);
  }
}

TEST(BallOnLayer, IsABedOfSpringsWhereTheContactIsFarWiderThanTheLayerIsThick)
{
  // Springs of (lambda + 2 mu) / thickness: the force is pi M r depth^2 / thickness.
  const double nu = 0.3;
  const oracle::Layer thin{ 20e3, nu, 1e-3 };
  const oracle::BallContact found = oracle::contactOfRadius(thin, 10.0, 0.005);
  const double modulus = 20e3 * (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu));
  const double springs_N = 3.141592653589793 * modulus * 10.0 * found.depth_m * found.depth_m / 1e-3;
  EXPECT_NEAR(found.force_N / springs_N, 1.0, 0.01);
}

TEST(BallOnLayer, HasTheFactorOfTheLayerThatIsPublished)
{
  // Dimitriadis et al. 2002, eq. 12, of a bonded layer, chi = sqrt(r depth) / h; for shallow balls.
  const double nu = 0.4;
  const double pi = 3.141592653589793;
  const double a0 = -(1.2876 - 1.4678 * nu + 1.3442 * nu * nu) / (1.0 - nu);
  const double b0 = (0.6387 - 1.0277 * nu + 1.5164 * nu * nu) / (1.0 - nu);
  for (const double chi : { 0.05, 0.1, 0.2 })
  {
    const double ball_m = 1.0;
    const double depth_m = 1e-3;
    const oracle::Layer layer{ 20e3, nu, std::sqrt(ball_m * depth_m) / chi };
    const double hertz_N = 4.0 / 3.0 * 20e3 / (1.0 - nu * nu) * std::sqrt(ball_m) * std::pow(depth_m, 1.5);
    const double factor = 1.0 - 2.0 * a0 / pi * chi + 4.0 * a0 * a0 / (pi * pi) * chi * chi -
                          8.0 / (pi * pi * pi) * (a0 * a0 * a0 + 4.0 * pi * pi / 15.0 * b0) * chi * chi * chi +
                          16.0 * a0 / std::pow(pi, 4) * (a0 * a0 * a0 + 3.0 * pi * pi / 5.0 * b0) * std::pow(chi, 4);
    EXPECT_NEAR(oracle::contactOfDepth(layer, ball_m, depth_m).force_N / (factor * hertz_N), 1.0, 0.01) << chi;
  }
}

} // namespace
} // namespace palpate::test
