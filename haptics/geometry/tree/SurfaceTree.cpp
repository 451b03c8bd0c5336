// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/tree/SurfaceTree.h"

#include <span>
#include <stdexcept>
#include <utility>

#include "haptics/core/InTwo.h"
#include "haptics/core/LargePages.h"
#include "haptics/geometry/mesh/Buckets.h"
#include "haptics/geometry/tree/HierarchyOrder.h"
#include "haptics/geometry/tree/SurfaceData.h"
#include "haptics/geometry/tree/SurfaceRecords.h"

namespace palpate
{
namespace
{

/// Number of leaves for `count` triangles.
std::size_t leavesOf(std::size_t count)
{
  return count <= Leaf::capacity ? 1 : leavesOf(count / 2) + leavesOf(count - count / 2);
}

/// Writes the shape of CGAL's hierarchy down as flat arrays: CGAL keeps each subtree's primitives contiguous and gives
/// the left child floor(n / 2) of them, so the shape follows from the counts alone.
class Shape
{
public:
  explicit Shape(SurfaceData& data) : data_(data)
  {
    const std::size_t leaves = leavesOf(data.mesh.triangles.size());
    reserveLarge(data.leaves, leaves);
    resizeLarge(data.discs, 2 * leaves);
    reserveLarge(data.nodes, leaves - 1);
  }

  /// Returns the child index of the subtree with these `count` primitives.
  std::uint32_t lay(std::size_t first, std::size_t count)
  {
    if (count <= Leaf::capacity)
    {
      const auto leaf = static_cast<std::uint32_t>(this->data_.leaves.size());
      this->data_.leaves.push_back(
        { Vec3::Zero(), 0.0, static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(count) });
      return leaf | TreeNode::leafBit;
    }
    const auto index = static_cast<std::uint32_t>(this->data_.nodes.size());
    this->data_.nodes.emplace_back();
    const std::uint32_t child0 = this->lay(first, count / 2);
    const std::uint32_t child1 = this->lay(first + count / 2, count - count / 2);
    this->data_.nodes[index].child = { child0, child1 };
    return index;
  }

private:
  SurfaceData& data_;
};

void reorder(
  std::vector<std::array<std::uint32_t, 3>>& triangles, const std::vector<std::uint32_t>& order, unsigned threads)
{
  std::vector<std::array<std::uint32_t, 3>> ordered;
  resizeLarge(ordered, order.size());
  const auto put = [&](const Half& half)
  {
    for (std::size_t i = half.first; i < half.last; ++i)
    {
      ordered[i] = triangles[order[i]];
    }
  };
  inTwo(
    threads, [&] { put(halfOf(order.size(), 0)); }, [&] { put(halfOf(order.size(), 1)); });
  triangles.swap(ordered);
}

std::span<const std::uint32_t> cornersOnce(const std::array<std::uint32_t, 3>& corners)
{
  return { corners.data(), isSegment(corners) ? 2U : 3U };
}

void layFans(SurfaceData& data, unsigned threads)
{
  const std::vector<std::array<std::uint32_t, 3>>& triangles = data.mesh.triangles;
  const auto corners = [&](std::size_t part, auto visit)
  {
    const Half half = halfOf(triangles.size(), part);
    for (auto t = static_cast<std::uint32_t>(half.first); t < half.last; ++t)
    {
      for (const std::uint32_t corner : cornersOnce(triangles[t]))
      {
        visit(corner, t);
      }
    }
  };
  auto fans = makeBuckets<std::uint32_t>(data.mesh.vertices_W.size(), threads, corners);
  data.fanStart = std::move(fans.start);
  data.fan = std::move(fans.entries);
}

/// Makes faces, discs and neighbours of some leaves of a surface that has its shape and fans. The first triangle at an
/// edge or a vertex owns it.
class FaceMaker
{
public:
  FaceMaker(SurfaceData& data, const Half& leaves) : data_(data), leaves_(leaves)
  {
    const Leaf& last = data.leaves[leaves.last - 1];
    this->triangles_ = { data.leaves[leaves.first].first, last.first + last.count };
  }

  void run(std::vector<Box>& boxes)
  {
    for (std::size_t index = this->leaves_.first; index < this->leaves_.last; ++index)
    {
      Leaf& leaf = this->data_.leaves[index];
      boxes[index] = Box::empty();
      for (std::uint32_t t = leaf.first; t < leaf.first + leaf.count; ++t)
      {
        const FaceRecord face = makeFace(this->data_, t, this->ownedBits(t));
        this->data_.faces[t] = face;
        boxes[index].include(boxOf(face.corner_W));
      }
      leaf = makeLeaf(boxes[index], leaf.first, leaf.count);
      layDiscs(this->data_, index);
    }
  }

private:
  /// Notes the only other triangle over edge k. True if a triangle before this one has the edge.
  [[nodiscard]] bool meetsAcross(std::uint32_t triangle, std::uint32_t k)
  {
    std::uint32_t& across = this->data_.across[triangle][k];
    if (across != SurfaceData::none)
    {
      return true; // entered with the other triangle
    }
    const auto& t = this->data_.mesh.triangles[triangle];
    const std::uint32_t v = t[k], w = t[(k + 1) % 3];
    std::uint32_t others = 0, other = SurfaceData::none;
    bool first = true;
    this->data_.forEachAtEdge(v, w,
      [&](std::uint32_t at)
      {
        first = first && at >= triangle;
        others += at != triangle ? 1 : 0;
        other = at != triangle ? at : other;
      });
    if (others == 1)
    {
      across = other;
      this->tell(other, edgeOf(this->data_.mesh.triangles[other], v, w), triangle);
    }
    return !first;
  }

  /// Saves a later triangle the search, unless that triangle belongs to another thread.
  void tell(std::uint32_t other, std::size_t k, std::uint32_t triangle)
  {
    if (other > triangle && other < this->triangles_.last)
    {
      this->data_.across[other][k] = triangle;
    }
  }

  [[nodiscard]] std::uint32_t ownedBits(std::uint32_t triangle)
  {
    const auto& t = this->data_.mesh.triangles[triangle];
    const std::uint32_t vertices = isSegment(t) ? 2 : 3, edges = isSegment(t) ? 1 : 3;
    std::uint32_t bits = 0;
    for (std::uint32_t k = 0; k < vertices; ++k)
    {
      bits |= this->data_.fan[this->data_.fanStart[t[k]]] == triangle ? ownsVertex0 << k : 0;
      bits |= k < edges && !this->meetsAcross(triangle, k) ? ownsEdge0 << k : 0;
    }
    return bits;
  }

  SurfaceData& data_;
  Half leaves_, triangles_;
};

void layFaces(SurfaceData& data, unsigned threads)
{
  const std::size_t triangles = data.mesh.triangles.size(), leaves = data.leaves.size();
  inTwo(
    threads, [&] { resizeLarge(data.faces, triangles); },
    [&]
    {
      reserveLarge(data.across, triangles);
      data.across.assign(triangles, { SurfaceData::none, SurfaceData::none, SurfaceData::none });
    });
  std::vector<Box> boxes;
  resizeLarge(boxes, leaves);
  const auto make = [&](const Half& of)
  {
    if (of.first < of.last)
    {
      FaceMaker(data, of).run(boxes);
    }
  };
  inTwo(
    threads, [&] { make(halfOf(leaves, 0)); }, [&] { make(halfOf(leaves, 1)); });
  const Box all = layBoxes(data.nodes, boxes, data.nodes);
  data.low_W = all.low_W;
  data.high_W = all.high_W;
}

/// `ordered`: the triangles stand in the order of a tree.
std::unique_ptr<SurfaceData> buildData(TriangleMesh clean, double coat_u, bool ordered, unsigned threads)
{
  if (clean.triangles.empty())
  {
    throw std::invalid_argument("a surface needs at least one triangle");
  }
  auto data = std::make_unique<SurfaceData>();
  data->mesh = std::move(clean);
  data->coat_u = coat_u;
  if (!ordered)
  {
    reorder(data->mesh.triangles, hierarchyOrder(data->mesh, threads), threads);
  }
  const auto hash = [&of = *data]
  {
    of.topologyHash = hashTopology(of.mesh);
    of.contentHash = hashContent(of);
  };
  layFans(*data, threads);
  inTwo(
    threads, [&] { (void)Shape(*data).lay(0, data->mesh.triangles.size()); }, hash);
  layFaces(*data, threads);
  return data;
}

template<class T>
std::size_t bytesOf(const std::vector<T>& v)
{
  return v.capacity() * sizeof(T);
}

} // namespace

SurfaceTree::SurfaceTree(TriangleMesh clean, double coat_u, unsigned threads)
  : data_(buildData(std::move(clean), coat_u, false, threads))
{
}

std::shared_ptr<const SurfaceTree> SurfaceTree::inOrder(TriangleMesh ordered, double coat_u, unsigned threads)
{
  return std::shared_ptr<const SurfaceTree>(new SurfaceTree(buildData(std::move(ordered), coat_u, true, threads)));
}

SurfaceTree::SurfaceTree(std::unique_ptr<SurfaceData> data) : data_(std::move(data)) {}

SurfaceTree::~SurfaceTree() = default;

const TriangleMesh& SurfaceTree::mesh() const noexcept
{
  return this->data_->mesh;
}

double SurfaceTree::coat_u() const noexcept
{
  return this->data_->coat_u;
}

std::uint64_t SurfaceTree::contentHash() const noexcept
{
  return this->data_->contentHash;
}

std::uint64_t SurfaceTree::topologyHash() const noexcept
{
  return this->data_->topologyHash;
}

std::uint64_t SurfaceTree::wayName() const noexcept
{
  return this->data_->wayName;
}

std::size_t SurfaceTree::bytes() const noexcept
{
  const SurfaceData& d = *this->data_;
  std::size_t places = 0;
  for (const PlaceBounds& place : d.places)
  {
    places += sizeof(place) + bytesOf(place.nodes) + bytesOf(place.balls);
  }
  return sizeof(SurfaceData) + places + bytesOf(d.faces) + bytesOf(d.discs) + bytesOf(d.leaves) + bytesOf(d.nodes) +
         bytesOf(d.fanStart) + bytesOf(d.fan) + bytesOf(d.across);
}

} // namespace palpate
