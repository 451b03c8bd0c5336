// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <gtest/gtest.h>

#include "Blocks.h"
#include "haptics/compliance/map/FrameMap.h"
#include "haptics/compliance/map/Patches.h"
#include "haptics/compliance/snapshot/SoftSurface.h"
#include "testing/support/Random.h"

namespace palpate::test
{
namespace
{

/// A pad whose top is a hill: no patch lies in a plane.
SoftBodyInput hill(ElementKind element)
{
  SoftBodyInput input = pad(6);
  for (Vec3& p : input.mesh.vertices_W)
  {
    p.z() *= 1.0 + 20.0 * (p.x() * (0.1 - p.x()) + p.y() * (0.1 - p.y()));
    p.x() += 0.2 * p.z();
  }
  input.element = element;
  return input;
}

const Vec3 turn(0.5, 1.0, -0.7);

Vec3 turnAndShift(const Vec3& p)
{
  return Vec3(0.3, -0.2, 0.1) + turn.cross(p);
}

/// Three numbers that a map follows: how far a place went, or how a frame there turned.
struct Followed
{
  Vec3 place_W;
  bool turns = false;
};

std::vector<Followed> nodesAt(const std::vector<Vec3>& nodes_W)
{
  std::vector<Followed> all;
  std::ranges::transform(nodes_W, std::back_inserter(all), [](const Vec3& p) { return Followed{ p }; });
  return all;
}

/// Forces on mapped points and on the nodes that they follow have one sum, one moment and one power; motions of a rigid
/// body go through.
void expectEqualWrenches(
  const SurfaceMap& map, const std::vector<Vec3>& points_W, const std::vector<Followed>& followed)
{
  Random random(testSeed(184));
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(followed.size()));
  Eigen::VectorXd moved = forces;
  Eigen::VectorXd rigid = forces;
  for (std::size_t i = 0; i < followed.size(); ++i)
  {
    moved.segment<3>(3 * static_cast<Eigen::Index>(i)) = random.inCube(1e-2);
    rigid.segment<3>(3 * static_cast<Eigen::Index>(i)) = followed[i].turns ? turn : turnAndShift(followed[i].place_W);
  }
  Vec3 force = Vec3::Zero();
  Vec3 moment = Vec3::Zero();
  double power = 0.0;
  for (std::size_t v = 0; v < points_W.size(); ++v)
  {
    const Vec3 f = random.direction();
    map.addForce(v, f, forces);
    force += f;
    moment += points_W[v].cross(f);
    power += f.dot(map.displacementOf(v, moved));
    EXPECT_LE((map.displacementOf(v, rigid) - turnAndShift(points_W[v])).norm(), 1e-12);
  }
  power -= forces.dot(moved);
  for (std::size_t i = 0; i < followed.size(); ++i)
  {
    const Vec3 f = forces.segment<3>(3 * static_cast<Eigen::Index>(i));
    force -= followed[i].turns ? Vec3(Vec3::Zero()) : f;
    moment -= followed[i].turns ? f : Vec3(followed[i].place_W.cross(f));
  }
  // Of some hundred forces of 1 N.
  EXPECT_LE(force.norm(), 1e-12);
  EXPECT_LE(moment.norm(), 1e-12);
  EXPECT_LE(std::abs(power), 1e-12);
}

TEST(SurfaceMap, PatchesCarryForceMomentAndPowerToTheNodes)
{
  for (const ElementKind element : { ElementKind::EdgeSmoothed, ElementKind::Quadratic })
  {
    const SoftBodyResult made = makeSoftBody(hill(element));
    ASSERT_TRUE(made.body) << made.refusal;
    const SoftSurface surface = makeSoftSurface(*made.body, made.checked.mesh);
    expectEqualWrenches(surface.map, surface.rest_W, nodesAt(made.body->points().rest_W));
  }
}

TEST(SurfaceMap, PointsInTetrahedraCarryThemToo)
{
  Random random(testSeed(185));
  const TetraMesh mesh = hill(ElementKind::Linear).mesh;
  std::vector<Vec3> points_W;
  for (std::size_t i = 0; i < testCount(200); ++i)
  {
    points_W.emplace_back(Vec3(0.05, 0.05, 0.03) + random.inCube(0.05)); // some are outside
  }
  const Embedding embedding = embed(mesh, points_W);
  EXPECT_GT(embedding.outside, points_W.size() / 20);
  EXPECT_LT(embedding.outside, points_W.size() * 3 / 4);
  expectEqualWrenches(embedding.map, points_W, nodesAt(mesh.vertices_W));
}

TEST(SurfaceMap, PointsOnFramesCarryThemAsForceAndMomentOfEachFrame)
{
  Random random(testSeed(194));
  const std::vector<Vec3> origins_W{ { 0.0, 0.0, 0.0 }, { 0.1, 0.0, 0.0 }, { 0.05, 0.1, 0.02 } };
  std::vector<Vec3> points_W;
  std::vector<std::vector<FrameWeight>> weights;
  for (int i = 0; i < 50; ++i)
  {
    points_W.emplace_back(random.inCube(0.1));
    const double first = random.uniform();
    const double second = random.uniform() * (1.0 - first);
    weights.push_back({ { 0, first }, { 1, second }, { 2, 1.0 - first - second } });
  }
  std::vector<Followed> frames;
  for (const Vec3& origin_W : origins_W)
  {
    frames.insert(frames.end(), { { origin_W }, { origin_W, true } });
  }
  expectEqualWrenches(followFrames(origins_W, points_W, weights), points_W, frames);
}

TEST(SurfaceMap, PointsThatAreNodesMoveAndPressAsThey)
{
  const SurfaceMap map = followNodes({ 2, 0 });
  Eigen::VectorXd moved(9);
  moved << 1, 2, 3, 4, 5, 6, 7, 8, 9;
  EXPECT_EQ(map.displacementOf(0, moved), Vec3(7, 8, 9));
  EXPECT_EQ(map.displacementOf(1, moved), Vec3(1, 2, 3));
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(9);
  map.addForce(0, Vec3(1, 0, 2), forces);
  EXPECT_EQ(forces.tail<3>(), Vec3(1, 0, 2));
  EXPECT_EQ(forces.head<6>().norm(), 0.0);
}

TEST(SurfaceMap, APatchEndsWhereTheSurfaceDoesThoughAnotherSheetIsNear)
{
  // Two plates .2 apart, which hang together at one end that is further away than a patch reaches.
  SoftBodyInput input;
  input.mesh = blockOf({ 20, 6, 1 }, { 20, 6, 1 });
  for (Vec3& p : input.mesh.vertices_W)
  {
    const double x = p.x();
    p = x <= 10.0 ? Vec3(x, p.y(), p.z()) : Vec3(20.0 - x, p.y(), 2.2 - p.z());
    p.x() -= x == 10.0 ? 0.0 : 1e-9;
  }
  input.fixed = fixedWhere(input.mesh, [](const Vec3& p) { return p.x() < 0.5 && p.z() < 1.05; });
  input.young_Pa = { 1.0 };
  const StrainPoints points = makeStrainPoints(
    input.mesh, ElementKind::Linear, std::vector<ElasticModuli>(input.mesh.tetras.size(), ElasticModuli{ 1.0, 1.0 }));
  const BorderFaces border(points, borderOf(input.mesh));
  for (std::uint32_t node = 0; node < points.rest_W.size(); ++node)
  {
    const Vec3& p = points.rest_W[node];
    if (std::abs(p.x() - 5.0) < 0.1 && std::abs(p.y() - 3.0) < 0.1 && p.z() > 0.9 && p.z() < 1.1)
    {
      for (const std::uint32_t reached : patchAt(border, p, border.facesAt(node).front(), 2.5).nodes)
      {
        EXPECT_LE(points.rest_W[reached].z(), 1.1);
      }
      return;
    }
  }
  FAIL() << "no node there";
}

} // namespace
} // namespace palpate::test
