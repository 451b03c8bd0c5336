// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/SurfaceTree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <stdexcept>
#include <utility>

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Simple_cartesian.h>

#include "haptics/geometry/SurfaceData.h"
#include "haptics/geometry/SurfaceRecords.h"

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

/// Round nothing yet.
Box emptyBox()
{
  constexpr double inf = std::numeric_limits<double>::infinity();
  return { Vec3::Constant(inf), Vec3::Constant(-inf) };
}

/// Writes CGAL's hierarchy down as flat arrays: CGAL keeps each subtree's primitives contiguous and gives the
/// left child floor(n / 2) of them, so the shape follows from the counts alone.
class Flattener
{
public:
  Flattener(SurfaceData& data, const std::vector<std::uint32_t>& order) : data_(data), order_(order)
  {
    data.mesh.triangles.swap(this->unordered_);
    data.mesh.triangles.reserve(order.size());
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
    Box boxes[2] = { emptyBox(), emptyBox() };
    const std::uint32_t child0 = this->flatten(first, left, boxes[0]);
    const std::uint32_t child1 = this->flatten(first + left, count - left, boxes[1]);
    TreeNode& flat = this->data_.nodes[index];
    flat.child = { child0, child1 };
    for (int axis = 0; axis < 3; ++axis)
    {
      flat.low_W[axis] = { boxes[0].low_W[axis], boxes[1].low_W[axis] };
      flat.high_W[axis] = { boxes[0].high_W[axis], boxes[1].high_W[axis] };
    }
    for (const Box& child : boxes)
    {
      box.include(child.low_W);
      box.include(child.high_W);
    }
    return index;
  }

private:
  std::uint32_t addLeaf(std::size_t first, std::size_t count, Box& box)
  {
    for (std::size_t i = first; i < first + count; ++i)
    {
      this->data_.mesh.triangles.push_back(this->unordered_[this->order_[i]]);
      for (const std::uint32_t corner : this->data_.mesh.triangles.back())
      {
        box.include(this->data_.vertex(corner));
      }
    }
    this->data_.leaves.push_back(makeLeaf(box, static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(count)));
    return static_cast<std::uint32_t>(this->data_.leaves.size() - 1) | TreeNode::leafBit;
  }

  SurfaceData& data_;
  const std::vector<std::uint32_t>& order_;
  std::vector<std::array<std::uint32_t, 3>> unordered_;
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

void layHierarchy(SurfaceData& data, const std::vector<std::uint32_t>& order)
{
  Box box = emptyBox();
  Flattener(data, order).flatten(0, order.size(), box);
  data.low_W = box.low_W;
  data.high_W = box.high_W;
}

std::span<const std::uint32_t> cornersOnce(const std::array<std::uint32_t, 3>& corners)
{
  return { corners.data(), isSegment(corners) ? 2U : 3U };
}

void buildFans(SurfaceData& data)
{
  data.fanStart.assign(data.mesh.vertices_W.size() + 1, 0);
  for (const auto& t : data.mesh.triangles)
  {
    for (const std::uint32_t corner : cornersOnce(t))
    {
      ++data.fanStart[corner + 1];
    }
  }
  for (std::size_t v = 1; v < data.fanStart.size(); ++v)
  {
    data.fanStart[v] += data.fanStart[v - 1];
  }
  data.fan.resize(data.fanStart.back());
  std::vector<std::uint32_t> next(data.fanStart.begin(), data.fanStart.end() - 1);
  for (std::uint32_t t = 0; t < data.mesh.triangles.size(); ++t)
  {
    for (const std::uint32_t corner : cornersOnce(data.mesh.triangles[t]))
    {
      data.fan[next[corner]++] = t;
    }
  }
}

std::uint32_t ownedBits(const SurfaceData& data, std::uint32_t triangle)
{
  const auto& t = data.mesh.triangles[triangle];
  std::uint32_t bits = 0;
  const std::uint32_t vertices = isSegment(t) ? 2 : 3, edges = isSegment(t) ? 1 : 3;
  for (std::uint32_t k = 0; k < vertices; ++k)
  {
    const std::uint32_t begin = data.fanStart[t[k]];
    if (data.fan[begin] == triangle)
    {
      bits |= ownsVertex0 << k;
    }
    if (k >= edges)
    {
      continue;
    }
    std::uint32_t i = begin; // fans ascend: the first one that holds the edge owns it
    while (!data.hasCorner(data.fan[i], t[(k + 1) % 3]))
    {
      ++i;
    }
    if (data.fan[i] == triangle)
    {
      bits |= ownsEdge0 << k;
    }
  }
  return bits;
}

void buildRecords(SurfaceData& data)
{
  data.faces.reserve(data.mesh.triangles.size());
  for (std::uint32_t t = 0; t < data.mesh.triangles.size(); ++t)
  {
    data.faces.push_back(makeFace(data, t, ownedBits(data, t)));
  }
  data.discs.assign(2 * data.leaves.size(), DiscQuad{});
  for (std::size_t leaf = 0; leaf < data.leaves.size(); ++leaf)
  {
    layDiscs(data, leaf);
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
  const std::size_t leavesAtMost = data->mesh.triangles.size() / (Leaf::capacity / 2) + 1;
  data->leaves.reserve(leavesAtMost);
  data->nodes.reserve(leavesAtMost);
  std::vector<std::uint32_t> order;
  if (ordered)
  {
    order.resize(data->mesh.triangles.size());
    std::iota(order.begin(), order.end(), 0u);
  }
  else
  {
    order = hierarchyOrder(*data);
  }
  layHierarchy(*data, order);
  data->leaves.shrink_to_fit();
  data->nodes.shrink_to_fit();
  buildFans(*data);
  buildRecords(*data);
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
  return sizeof(SurfaceData) + bytesOf(d.faces) + bytesOf(d.discs) + bytesOf(d.leaves) + bytesOf(d.nodes) +
         bytesOf(d.fanStart) + bytesOf(d.fan);
}

} // namespace palpate
