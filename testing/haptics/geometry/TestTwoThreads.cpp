// SPDX-License-Identifier: GPL-3.0-or-later
// A surface that two threads have made is the one that a single thread makes, bit for bit.
#include <algorithm>
#include <cmath>
#include <map>
#include <new>
#include <set>
#include <stdexcept>
#include <thread>
#include <tuple>

#include <gtest/gtest.h>

#include "haptics/core/InTwo.h"
#include "haptics/geometry/tree/HierarchyOrder.h"
#include "haptics/geometry/tree/SurfaceData.h"
#include "haptics/geometry/tree/SurfaceTree.h"
#include "testing/support/Meshes.h"
#include "testing/support/NoisySphere.h"

namespace palpate::test
{
namespace
{

using Triangle = std::array<std::uint32_t, 3>;

TEST(InTwo, RunsTheSecondInAThreadOfItsOwnOnlyIfThereMayBeTwo)
{
  for (const unsigned threads : { 0u, 1u, 2u })
  {
    std::thread::id first, second;
    inTwo(
      threads, [&] { first = std::this_thread::get_id(); }, [&] { second = std::this_thread::get_id(); });
    EXPECT_EQ(first, std::this_thread::get_id());
    EXPECT_EQ(second != first, threads > 1) << threads;
    EXPECT_NE(second, std::thread::id());
  }
}

TEST(InTwo, BringsAnExceptionOfEitherAndWaitsForTheOther)
{
  const auto outOfMemory = [] { throw std::bad_alloc(); };
  for (const unsigned threads : { 1u, 2u })
  {
    EXPECT_THROW(inTwo(
                   threads, [] {}, outOfMemory),
      std::bad_alloc);
    bool ended = false;
    EXPECT_THROW(inTwo(threads, outOfMemory,
                   [&]
                   {
                     std::this_thread::yield();
                     ended = true;
                   }),
      std::bad_alloc);
    EXPECT_EQ(ended, threads > 1); // with one thread it never began
    EXPECT_THROW(inTwo(
                   threads, [] { throw std::runtime_error(""); }, outOfMemory),
      std::runtime_error);
  }
}

/// Meshes of all kinds that cleaning has to tell apart.
std::vector<TriangleMesh> roughMeshes()
{
  Random random(testSeed(811));
  std::vector<TriangleMesh> meshes = { makeIcosphere(0, 1.0), makeFin(), NoisySphere(30000, 1.0).mesh() };
  meshes.push_back(makeSheet({ 70.0, 80.0, 70, 80 }, random)); // all of one z
  meshes.push_back(makeBox({ -1, -2, -3 }, { 1, 2, 3 }));
  meshes.push_back(makeSoup(20000, 1.0, random));
  TriangleMesh lattice = makeSoup(20000, 6.0, random); // many vertices share coordinates, and many triangles are none
  for (Vec3& v : lattice.vertices_W)
  {
    v = v.array().round();
  }
  meshes.push_back(lattice);
  TriangleMesh zeros = lattice; // two zeros, small and large numbers
  for (Vec3& v : zeros.vertices_W)
  {
    v[random.below(3)] = std::array{ 0.0, -0.0, 1e-100, -1e-100, 1e100, -1e100, 1.0, -1.0 }[random.below(8)];
  }
  meshes.push_back(zeros);
  const std::size_t whole = meshes.size();
  for (std::size_t i = 0; i < whole; ++i)
  {
    meshes.push_back(shuffled(unwelded(meshes[i]), random));
    meshes.push_back(withDefects(meshes[i], random));
  }
  return meshes;
}

/// The clean vertices by a set of numbers, as welding is meant to give them.
std::map<std::array<double, 3>, std::uint32_t> firstOfEqual(const TriangleMesh& raw)
{
  std::map<std::array<double, 3>, std::uint32_t> first;
  for (std::uint32_t i = 0; i < raw.vertices_W.size(); ++i)
  {
    const Vec3& v = raw.vertices_W[i];
    if (v.allFinite())
    {
      first.try_emplace({ v.x(), v.y(), v.z() }, i); // -0 is 0 there
    }
  }
  return first;
}

void expectSameReport(const CleanReport& a, const CleanReport& b)
{
  const auto counts = [](const CleanReport& r)
  {
    return std::tie(r.trianglesIn, r.trianglesOut, r.verticesOut, r.nonFinite, r.collinear, r.duplicate,
      r.boundaryEdges, r.nonManifoldEdges);
  };
  EXPECT_EQ(counts(a), counts(b)) << a.summary() << "\n" << b.summary();
}

TEST(TwoThreads, CleanAsOneDoes)
{
  for (const TriangleMesh& raw : roughMeshes())
  {
    const CleanResult one = cleanMesh(raw), two = cleanMesh(raw, 2);
    EXPECT_EQ(one.mesh.vertices_W, two.mesh.vertices_W);
    EXPECT_EQ(one.mesh.triangles, two.mesh.triangles);
    EXPECT_EQ(one.sourceVertex, two.sourceVertex);
    EXPECT_EQ(one.refusal, two.refusal);
    expectSameReport(one.report, two.report);
  }
}

TEST(TwoThreads, WeldAsASetOfNumbersDoes)
{
  for (const TriangleMesh& raw : roughMeshes())
  {
    const auto first = firstOfEqual(raw);
    const CleanResult clean = cleanMesh(raw, 2);
    ASSERT_EQ(clean.mesh.vertices_W.size(), clean.sourceVertex.size());
    auto at = first.begin();
    for (std::size_t i = 0; i < clean.sourceVertex.size(); ++i, ++at)
    {
      const Vec3& v = clean.mesh.vertices_W[i];
      const std::array key = { v.x(), v.y(), v.z() };
      ASSERT_FALSE(std::ranges::any_of(key, [](double x) { return x == 0.0 && std::signbit(x); }));
      at = std::find_if(at, first.end(), [&](const auto& entry) { return entry.first == key; }); // some are not used
      ASSERT_NE(at, first.end()) << "vertex " << i << " is out of order or none of the raw mesh";
      ASSERT_EQ(clean.sourceVertex[i], at->second);
    }
  }
}

TEST(TwoThreads, CountTheEdgesOfTheTriangles)
{
  for (const TriangleMesh& raw : roughMeshes())
  {
    const CleanResult clean = cleanMesh(raw, 2);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
    for (const auto& [a, b, c] : clean.mesh.triangles)
    {
      ++uses[{ a, b }];
      ++uses[{ a, c }];
      ++uses[{ b, c }];
    }
    const auto count = [&](auto is) { return std::ranges::count_if(uses, [&](auto& use) { return is(use.second); }); };
    EXPECT_EQ(clean.report.boundaryEdges, count([](int n) { return n == 1; }));
    EXPECT_EQ(clean.report.nonManifoldEdges, count([](int n) { return n > 2; }));
    EXPECT_TRUE(std::ranges::is_sorted(clean.mesh.triangles));
    EXPECT_EQ(
      std::set<Triangle>(clean.mesh.triangles.begin(), clean.mesh.triangles.end()).size(), clean.mesh.triangles.size());
  }
}

/// Halved by the least corners of the boxes down to pairs, as CGAL's tree does it in one piece.
void orderPlainly(
  std::vector<std::uint32_t>::iterator first, std::vector<std::uint32_t>::iterator last, const std::vector<Box>& boxes)
{
  if (last - first < 2)
  {
    return;
  }
  Box all = Box::empty();
  std::for_each(first, last, [&](std::uint32_t i) { all.include(boxes[i]); });
  const Vec3 sides = all.high_W - all.low_W;
  const int axis = sides.x() >= sides.y() ? (sides.x() >= sides.z() ? 0 : 2) : (sides.y() >= sides.z() ? 1 : 2);
  const auto middle = first + (last - first) / 2;
  std::nth_element(
    first, middle, last, [&](std::uint32_t a, std::uint32_t b) { return boxes[a].low_W[axis] < boxes[b].low_W[axis]; });
  if (last - first > 3)
  {
    orderPlainly(first, middle, boxes);
    orderPlainly(middle, last, boxes);
  }
  else if (last - first == 3) // a leaf and a pair
  {
    orderPlainly(first + 1, last, boxes);
  }
}

TEST(TwoThreads, OrderTrianglesAsOneTreeInOnePieceDoes)
{
  for (const TriangleMesh& raw : { NoisySphere(70000, 1.0).mesh(), makeIcosphere(5, 1.0), makeFin() })
  {
    const TriangleMesh mesh = cleanMesh(raw).mesh;
    std::vector<Box> boxes;
    std::vector<std::uint32_t> plain;
    for (const auto& [a, b, c] : mesh.triangles)
    {
      plain.push_back(static_cast<std::uint32_t>(boxes.size()));
      boxes.push_back(boxOf({ mesh.vertices_W[a], mesh.vertices_W[b], mesh.vertices_W[c] }));
    }
    orderPlainly(plain.begin(), plain.end(), boxes);
    EXPECT_EQ(hierarchyOrder(mesh, 1), plain);
    EXPECT_EQ(hierarchyOrder(mesh, 2), plain);
  }
}

void expectSameTree(const SurfaceData& a, const SurfaceData& b)
{
  EXPECT_EQ(a.contentHash, b.contentHash);
  EXPECT_EQ(a.topologyHash, b.topologyHash);
  EXPECT_EQ(a.mesh.triangles, b.mesh.triangles);
  EXPECT_EQ(a.fanStart, b.fanStart);
  EXPECT_EQ(a.fan, b.fan);
  EXPECT_EQ(a.across, b.across);
  EXPECT_EQ(a.low_W, b.low_W);
  EXPECT_EQ(a.high_W, b.high_W);
  const auto same = [](const auto& x, const auto& y, auto parts) { return std::ranges::equal(x, y, {}, parts, parts); };
  EXPECT_TRUE(same(a.nodes, b.nodes, [](const TreeNode& n) { return std::tie(n.low_W, n.high_W, n.child); }));
  EXPECT_TRUE(same(a.leaves, b.leaves,
    [](const Leaf& l)
    { return std::tuple(l.origin_W[0], l.origin_W[1], l.origin_W[2], l.perUnit, l.first, l.count); }));
  EXPECT_TRUE(same(a.faces, b.faces,
    [](const FacePlane& f) { return std::tuple(f.normal_W[0], f.normal_W[1], f.normal_W[2], f.sliver, f.owned); }));
  EXPECT_TRUE(
    same(a.discs, b.discs, [](const DiscQuad& d) { return std::tie(d.cx, d.cy, d.cz, d.nx, d.ny, d.nz, d.radius); }));
}

TEST(TwoThreads, BuildTheTreeThatOneBuilds)
{
  for (const TriangleMesh& raw : roughMeshes())
  {
    const CleanResult clean = cleanMesh(raw);
    if (clean.ok())
    {
      const SurfaceTree one(clean.mesh), two(clean.mesh, 0.0, 2);
      expectSameTree(one.data(), two.data());
      expectSameTree(one.data(), SurfaceTree::inOrder(one.mesh(), 0.0, 2)->data());
    }
  }
}

TEST(TwoThreads, BuildAFaceThatOwnsEachEdgeAndVertexOnce)
{
  for (const TriangleMesh& raw : roughMeshes())
  {
    const CleanResult clean = cleanMesh(raw);
    if (!clean.ok())
    {
      continue;
    }
    const SurfaceTree tree(clean.mesh, 0.0, 2);
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    std::set<std::uint32_t> vertices;
    for (std::uint32_t t = 0; t < tree.mesh().triangles.size(); ++t)
    {
      const Triangle& corners = tree.mesh().triangles[t];
      for (std::size_t k = 0; k < 3; ++k)
      {
        const auto edge = std::minmax(corners[k], corners[(k + 1) % 3]);
        const std::uint32_t owned = tree.data().plane(t).owned;
        ASSERT_EQ((owned & ownsEdge0 << k) != 0, edges.insert(edge).second); // the first at an edge
        ASSERT_EQ((owned & ownsVertex0 << k) != 0, vertices.insert(corners[k]).second);
      }
    }
  }
}

} // namespace
} // namespace palpate::test
