// SPDX-License-Identifier: GPL-3.0-or-later
// The truth of TestMeshStudy.cpp for other elements, Poisson's ratios and meshes than the structured ones that the
// product's correction of smoothed edges was fitted to.
#include <cmath>
#include <iostream>
#include <sstream>
#include <vector>

#include <gtest/gtest.h>

#include "PressedLayer.h"
#include "haptics/compliance/build/TetraMesher.h"
#include "testing/support/LongForm.h"

namespace palpate::test
{
namespace
{

struct Press
{
  double ball_m = 0.0;
  double depth_m = 0.0;
};

/// At some places of one mesh, each within 3 %.
void expectTruth(const SoftBodyInput& input, const oracle::Layer& layer, const Press& press,
  const std::vector<Vec3>& places_m, const std::string& which)
{
  const oracle::BallContact truth = oracle::contactOfDepth(layer, press.ball_m, press.depth_m);
  Presser presser(input, press.ball_m);
  for (const Vec3& at_m : places_m)
  {
    std::ostringstream where;
    where << which << ", nu " << layer.poisson << ", ball " << press.ball_m << ", layer " << layer.thickness_m
          << ", at " << at_m.transpose();
    const double ratio = presser.press(press.depth_m, at_m) / truth.force_N;
    std::cout << where.str() << ": " << ratio << std::endl;
    EXPECT_NEAR(ratio, 1.0, 0.03) << where.str();
  }
}

/// A structured block, at a vertex and between vertices.
void expectTruthOnBlock(const oracle::Layer& layer, const Press& press, double edge, ElementKind element)
{
  const double contact_m = oracle::contactOfDepth(layer, press.ball_m, press.depth_m).radius_m;
  SoftBodyInput input = layerOf(layer, edge, 1.2 * contact_m + edge);
  input.element = element;
  std::ostringstream which;
  which << (element == ElementKind::Quadratic ? "nodes halfway" : "smoothed edges") << ", edge " << edge;
  expectTruth(input, layer, press, { Vec3::Zero(), Vec3(0.37 * edge, 0.21 * edge, 0.0) }, which.str());
}

TEST(MeshKinds, WithNodesHalfwayABallIsFeltTruly)
{
  for (const double poisson : casesOf<double>({ 0.3, 0.45, 0.49 }, { 0.49 }))
  {
    const oracle::Layer thick{ 20e3, poisson, 0.05 };
    expectTruthOnBlock(thick, { 0.02, 0.003 }, 0.017, ElementKind::Quadratic);
    expectTruthOnBlock(thick, { 0.02, 0.003 }, 0.00625, ElementKind::Quadratic);
    expectTruthOnBlock(thick, { 0.002, 0.0003 }, 0.017, ElementKind::Quadratic);
    const oracle::Layer thin{ 20e3, poisson, 0.005 };
    expectTruthOnBlock(thin, { 0.01, 0.001 }, 0.0025, ElementKind::Quadratic);
    expectTruthOnBlock(thin, { 0.01, 0.001 }, 0.00165, ElementKind::Quadratic);
  }
}

TEST(MeshKinds, WithSmoothedEdgesABallIsFeltTrulyAtOtherPoissonsRatiosToo)
{
  for (const double poisson : casesOf<double>({ 0.0, 0.3 }, { 0.0 }))
  {
    const oracle::Layer thick{ 20e3, poisson, 0.05 };
    expectTruthOnBlock(thick, { 0.02, 0.003 }, 0.017, ElementKind::EdgeSmoothed);
    expectTruthOnBlock(thick, { 0.02, 0.003 }, 0.004, ElementKind::EdgeSmoothed);
    expectTruthOnBlock({ 20e3, poisson, 0.005 }, { 0.01, 0.001 }, 0.0025, ElementKind::EdgeSmoothed);
    expectTruthOnBlock({ 20e3, poisson, 0.005 }, { 0.01, 0.001 }, 0.00125, ElementKind::EdgeSmoothed);
  }
}

/// A layer whose sides are eight thicknesses apart, filled as a closed surface is.
SoftBodyInput filled(const oracle::Layer& layer, double edge)
{
  const double h = layer.thickness_m;
  TetraMesh box = blockOf({ 1, 1, 1 }, Vec3(8.0 * h, 8.0 * h, h));
  for (Vec3& p : box.vertices_W)
  {
    p -= Vec3(4.0 * h, 4.0 * h, h);
  }
  const SurfaceTree closed(cleanMesh({ box.vertices_W, borderOf(box) }).mesh);
  TetraMeshResult made = meshInside(closed, { edge, 0.1 * edge });
  EXPECT_EQ(made.refusal, "");
  SoftBodyInput input;
  input.mesh = std::move(made.mesh);
  // CGAL's vertices lie on a plane of the border within its distance, a tenth of an edge, and no others so near to it.
  input.fixed = fixedWhere(input.mesh, [h, edge](const Vec3& p) { return p.z() < -h + 0.1 * edge; });
  input.young_Pa = { layer.young_Pa };
  input.poisson = layer.poisson;
  input.model = ElasticModel::Linear;
  input.mostBytes = std::size_t{ 16 } << 30;
  return input;
}

TEST(MeshKinds, OnAMeshThatFillsAClosedSurfaceABallIsFeltTruly)
{
  const oracle::Layer layer{ 20e3, 0.4, 0.02 };
  for (const double edge : { 0.01, 0.006 })
  {
    std::ostringstream which;
    which << "filled, edge " << edge;
    const std::vector<Vec3> places_m{ Vec3::Zero(), Vec3(0.0031, 0.0017, 0.0), Vec3(-0.0043, 0.0059, 0.0),
      Vec3(0.0077, -0.0068, 0.0) };
    expectTruth(filled(layer, edge), layer, { 0.01, 0.001 }, places_m, which.str());
    expectTruth(filled(layer, edge), layer, { 0.002, 0.0003 }, places_m, which.str());
  }
}

} // namespace
} // namespace palpate::test
