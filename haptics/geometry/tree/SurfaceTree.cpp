// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/tree/SurfaceTree.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <stdexcept>
#include <utility>

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Simple_cartesian.h>

#include "haptics/geometry/tree/SurfaceData.h"
#include "haptics/geometry/tree/SurfaceRecords.h"

namespace palpate
{
namespace
{

using Kernel = CGAL::Simple_cartesian<double>;

/// A triangle as CGAL's AABB tree wants it to build its hierarchy: its number and its box, at hand in the primitive
/// itself, since building asks for them some twenty times. No query is made to that tree.
class BoxPrimitive
{
public:
  struct Box
  {
    CGAL::Bbox_3 bounds;
    [[nodiscard]] const CGAL::Bbox_3& bbox() const { return this->bounds; }
  };
  using Id = std::uint32_t;
  using Point = Kernel::Point_3;
  using Datum = Box;
  using Shared_data = const TriangleMesh*;
  using Datum_reference = const Datum&;
  using Point_reference = Point;

  BoxPrimitive() = default;
  template<class Iterator>
  BoxPrimitive(Iterator it, const TriangleMesh& mesh) : id_(*it)
  {
    const auto& t = mesh.triangles[this->id_];
    const Vec3 &a = mesh.vertices_W[t[0]], &b = mesh.vertices_W[t[1]], &c = mesh.vertices_W[t[2]];
    const Vec3 low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
    this->box_.bounds = CGAL::Bbox_3(low.x(), low.y(), low.z(), high.x(), high.y(), high.z());
  }
  [[nodiscard]] Id id() const { return this->id_; }
  [[nodiscard]] Datum_reference datum(Shared_data) const { return this->box_; }
  [[nodiscard]] Point reference_point(Shared_data) const
  {
    return Point(this->box_.bounds.xmin(), this->box_.bounds.ymin(), this->box_.bounds.zmin());
  }
  static Shared_data construct_shared_data(const TriangleMesh& mesh) { return &mesh; }

private:
  Box box_;
  Id id_ = 0;
};

using Traits = CGAL::AABB_traits<Kernel, BoxPrimitive>;
using CgalTree = CGAL::AABB_tree<Traits>;
using CgalNode = CGAL::AABB_node<Traits>;

/// How many leaves so many triangles make.
std::size_t leavesOf(std::size_t count)
{
  return count <= Leaf::capacity ? 1 : leavesOf(count / 2) + leavesOf(count - count / 2);
}

/// Writes CGAL's hierarchy down as flat arrays: CGAL keeps each subtree's primitives contiguous and gives the
/// left child floor(n / 2) of them, so the shape follows from the counts alone. The faces are there, in its order.
class Flattener
{
public:
  explicit Flattener(SurfaceData& data) : data_(data)
  {
    const std::size_t leaves = leavesOf(data.faces.size());
    data.leaves.reserve(leaves);
    data.discs.reserve(2 * leaves);
    data.nodes.reserve(leaves - 1);
  }

  /// Returns the child index of the subtree with these `count` primitives.
  std::uint32_t flatten(std::size_t first, std::size_t count, Box& box)
  {
    if (count <= Leaf::capacity)
    {
      return this->addLeaf(first, count, box);
    }
    const std::size_t left = count / 2;
    const auto index = static_cast<std::uint32_t>(this->data_.nodes.size());
    this->data_.nodes.emplace_back();
    std::array<Box, 2> boxes = { Box::empty(), Box::empty() };
    const std::uint32_t child0 = this->flatten(first, left, boxes[0]);
    const std::uint32_t child1 = this->flatten(first + left, count - left, boxes[1]);
    TreeNode& flat = this->data_.nodes[index];
    flat.child = { child0, child1 };
    for (const std::size_t k : { 0U, 1U })
    {
      setBox(flat, k, boxes[k]);
      box.include(boxes[k]);
    }
    return index;
  }

private:
  std::uint32_t addLeaf(std::size_t first, std::size_t count, Box& box)
  {
    for (std::size_t i = first; i < first + count; ++i)
    {
      box.include(boxOf(this->data_.cornersOf(static_cast<std::uint32_t>(i))));
    }
    const std::size_t leaf = this->data_.leaves.size();
    this->data_.leaves.push_back(makeLeaf(box, static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(count)));
    this->data_.discs.resize(2 * (leaf + 1));
    layDiscs(this->data_, leaf);
    return static_cast<std::uint32_t>(leaf) | TreeNode::leafBit;
  }

  SurfaceData& data_;
};

/// The order in which CGAL's tree stores its primitives: an in-order walk of its leaves.
void collectOrder(const CgalNode* node, std::size_t count, std::vector<std::uint32_t>& order)
{
  if (count == 2)
  {
    order.push_back(node->left_data().id());
    order.push_back(node->right_data().id());
  }
  else if (count == 3)
  {
    order.push_back(node->left_data().id());
    collectOrder(&node->right_child(), 2, order);
  }
  else
  {
    collectOrder(&node->left_child(), count / 2, order);
    collectOrder(&node->right_child(), count - count / 2, order);
  }
}

/// The order in which CGAL's tree has the triangles.
std::vector<std::uint32_t> hierarchyOrder(const SurfaceData& data)
{
  const auto count = static_cast<std::uint32_t>(data.mesh.triangles.size());
  std::vector<std::uint32_t> ids(count);
  for (std::uint32_t i = 0; i < count; ++i)
  {
    ids[i] = i;
  }
  CgalTree tree(ids.begin(), ids.end(), data.mesh);
  if (count < 2)
  {
    return ids;
  }
  std::vector<std::uint32_t> order;
  order.reserve(count);
  tree.build();
  collectOrder(tree.root_node(), count, order);
  return order;
}

void layHierarchy(SurfaceData& data)
{
  Box box = Box::empty();
  Flattener(data).flatten(0, data.faces.size(), box);
  data.low_W = box.low_W;
  data.high_W = box.high_W;
}

void reorder(std::vector<std::array<std::uint32_t, 3>>& triangles, const std::vector<std::uint32_t>& order)
{
  std::vector<std::array<std::uint32_t, 3>> ordered;
  ordered.reserve(order.size());
  for (const std::uint32_t t : order)
  {
    ordered.push_back(triangles[t]);
  }
  triangles.swap(ordered);
}

std::span<const std::uint32_t> cornersOnce(const std::array<std::uint32_t, 3>& corners)
{
  return { corners.data(), isSegment(corners) ? 2U : 3U };
}

/// Room in the fans: for each vertex as many places as triangles have it.
void countFans(SurfaceData& data)
{
  data.fanStart.assign(data.mesh.vertices_W.size() + 1, 0);
  for (const auto& t : data.mesh.triangles)
  {
    for (const std::uint32_t corner : cornersOnce(t))
    {
      ++data.fanStart[corner + 1];
    }
  }
  std::partial_sum(data.fanStart.begin(), data.fanStart.end(), data.fanStart.begin());
  data.fan.resize(data.fanStart.back());
}

/// Faces and fans in one pass, in the order of the leaves, in which what is read lies close together. The first
/// triangle to come to an edge or a vertex owns it; those before it are in the fans.
class FaceMaker
{
public:
  explicit FaceMaker(SurfaceData& data) : data_(data), next_(data.fanStart.begin(), data.fanStart.end() - 1)
  {
    data.faces.reserve(data.mesh.triangles.size());
    data.across.assign(data.mesh.triangles.size(), { SurfaceData::none, SurfaceData::none, SurfaceData::none });
  }

  void add(std::uint32_t triangle)
  {
    this->data_.faces.push_back(makeFace(this->data_, triangle, this->ownedBits(triangle)));
    for (const std::uint32_t corner : cornersOnce(this->data_.mesh.triangles[triangle]))
    {
      this->data_.fan[this->next_[corner]++] = triangle;
    }
  }

private:
  [[nodiscard]] std::span<const std::uint32_t> before(std::uint32_t v) const
  {
    const std::uint32_t* const fan = this->data_.fan.data();
    return { fan + this->data_.fanStart[v], fan + this->next_[v] };
  }

  /// Tells the triangles before and this one of each other over its edge k. False if no triangle before has the edge.
  /// The end with fewer of them is asked: a spoke of a disc costs as little as any.
  [[nodiscard]] bool meetsAcross(std::uint32_t triangle, std::uint32_t k)
  {
    const auto& t = this->data_.mesh.triangles[triangle];
    std::uint32_t v = t[k], w = t[(k + 1) % 3];
    if (this->before(w).size() < this->before(v).size())
    {
      std::swap(v, w);
    }
    std::uint32_t* first = nullptr;
    auto& own = this->data_.across[triangle][k];
    for (const std::uint32_t other : this->before(v))
    {
      if (this->data_.hasCorner(other, w))
      {
        std::uint32_t& theirs = this->data_.across[other][edgeOf(this->data_.mesh.triangles[other], v, w)];
        const bool another = first != nullptr;
        own = another ? SurfaceData::none : other;
        theirs = another ? SurfaceData::none : triangle;
        first = another ? first : &theirs;
        *first = another ? SurfaceData::none : triangle;
      }
    }
    return first != nullptr;
  }

  [[nodiscard]] std::uint32_t ownedBits(std::uint32_t triangle)
  {
    const auto& t = this->data_.mesh.triangles[triangle];
    const std::uint32_t vertices = isSegment(t) ? 2 : 3, edges = isSegment(t) ? 1 : 3;
    std::uint32_t bits = 0;
    for (std::uint32_t k = 0; k < vertices; ++k)
    {
      bits |= this->before(t[k]).empty() ? ownsVertex0 << k : 0;
      bits |= k < edges && !this->meetsAcross(triangle, k) ? ownsEdge0 << k : 0;
    }
    return bits;
  }

  SurfaceData& data_;
  std::vector<std::uint32_t> next_; ///< for each vertex the first free place in its fan
};

void buildFaces(SurfaceData& data)
{
  countFans(data);
  FaceMaker maker(data);
  for (std::uint32_t t = 0; t < data.mesh.triangles.size(); ++t)
  {
    maker.add(t);
  }
}

/// `ordered`: the triangles stand in the order of a tree.
std::unique_ptr<SurfaceData> buildData(TriangleMesh clean, double coat_u, bool ordered)
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
    reorder(data->mesh.triangles, hierarchyOrder(*data));
  }
  buildFaces(*data);
  layHierarchy(*data);
  data->topologyHash = hashTopology(data->mesh);
  data->contentHash = hashContent(*data);
  return data;
}

template<class T>
std::size_t bytesOf(const std::vector<T>& v)
{
  return v.capacity() * sizeof(T);
}

} // namespace

SurfaceTree::SurfaceTree(TriangleMesh clean, double coat_u) : data_(buildData(std::move(clean), coat_u, false)) {}

std::shared_ptr<const SurfaceTree> SurfaceTree::inOrder(TriangleMesh ordered, double coat_u)
{
  return std::shared_ptr<const SurfaceTree>(new SurfaceTree(buildData(std::move(ordered), coat_u, true)));
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
