// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <atomic>
#include <utility>

#include "haptics/geometry/mesh/ExactPredicates.h"
#include "haptics/geometry/tree/SurfaceData.h"
#include "haptics/geometry/tree/SurfaceRecords.h"
#include "haptics/geometry/tree/SurfaceTree.h"

namespace palpate
{
namespace
{

/// A normal in double precision leaves no doubt below this amplification of its rounding.
constexpr float certainlyFlat = 1e9F;

std::string refusalOf(const SurfaceData& old, const std::vector<Vec3>& vertices_W)
{
  if (vertices_W.size() != old.mesh.vertices_W.size())
  {
    return "the surface has " + std::to_string(old.mesh.vertices_W.size()) + " vertices, but there are positions for " +
           std::to_string(vertices_W.size());
  }
  const auto bad = std::find_if(vertices_W.begin(), vertices_W.end(), [](const Vec3& v) { return !v.allFinite(); });
  if (bad != vertices_W.end())
  {
    return "vertex " + std::to_string(bad - vertices_W.begin()) + " has moved to a place that is not finite";
  }
  return {};
}

std::string refusalOf(const SurfaceData& old, const std::vector<Vec3>& vertices_W, const VertexWay* way)
{
  std::string refusal = refusalOf(old, vertices_W);
  for (std::size_t i = 0; way != nullptr && refusal.empty() && i < way->also.size(); ++i)
  {
    refusal = refusalOf(old, *way->also[i]);
  }
  return refusal;
}

/// Area, or length in a segment.
bool hasExtent(const FaceRecord& face)
{
  const auto& [a, b, c] = face.corner_W;
  if (b == c)
  {
    return a != b;
  }
  return face.normal_W.allFinite() && (face.sliver < certainlyFlat || !exactlyCollinear(a, b, c));
}

/// Around the corners of a face wherever they may be.
Box boxOf(const SurfaceData& data, std::uint32_t triangle, const VertexWay* way)
{
  const auto& [a, b, c] = data.cornersOf(triangle);
  Box box{ a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c) };
  for (std::size_t i = 0; way != nullptr && i < way->also.size(); ++i)
  {
    for (const std::uint32_t corner : data.corners(triangle))
    {
      box.include((*way->also[i])[corner]);
    }
  }
  return box;
}

/// Around both children of a node.
Box boxOf(const TreeNode& node)
{
  Box box;
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto along = static_cast<std::size_t>(axis);
    box.low_W[axis] = std::min(node.low_W[along][0], node.low_W[along][1]);
    box.high_W[axis] = std::max(node.high_W[along][0], node.high_W[along][1]);
  }
  return box;
}

/// Leaf by leaf, while its faces are at hand: memory is what this costs. Returns false where a triangle has no area, a
/// segment no length.
bool refitLeaves(
  SurfaceData& data, const std::vector<FacePlane>& old, const VertexWay* way, std::vector<Box>& leafBoxes)
{
  data.faces.resize(old.size());
  data.discs.resize(2 * data.leaves.size());
  leafBoxes.reserve(data.leaves.size());
  std::array<Box, Leaf::capacity> faceBoxes;
  for (std::size_t index = 0; index < data.leaves.size(); ++index)
  {
    Leaf& leaf = data.leaves[index];
    for (std::uint32_t k = 0; k < leaf.count; ++k)
    {
      const std::uint32_t t = leaf.first + k;
      const FaceRecord face = makeFace(data, t, old[t].owned);
      data.faces[t] = face;
      if (!hasExtent(face))
      {
        return false;
      }
      faceBoxes[k] = boxOf(data, t, way);
    }
    Box box = faceBoxes[0];
    for (std::uint32_t k = 1; k < leaf.count; ++k)
    {
      box.include(faceBoxes[k].low_W);
      box.include(faceBoxes[k].high_W);
    }
    leafBoxes.push_back(box);
    leaf = makeLeaf(box, leaf.first, leaf.count);
    way != nullptr ? layBalls(data, index, faceBoxes) : layDiscs(data, index);
  }
  return true;
}

/// A parent stands before its children: from the last node to the first, every child is done before it is asked for.
void refitNodes(SurfaceData& data, const std::vector<Box>& leafBoxes)
{
  for (auto node = data.nodes.rbegin(); node != data.nodes.rend(); ++node)
  {
    for (std::size_t k = 0; k < 2; ++k)
    {
      const std::uint32_t child = node->child[k];
      const bool leaf = (child & TreeNode::leafBit) != 0;
      const Box box = leaf ? leafBoxes[child & ~TreeNode::leafBit] : boxOf(data.nodes[child]);
      for (int axis = 0; axis < 3; ++axis)
      {
        const auto along = static_cast<std::size_t>(axis);
        node->low_W[along][k] = box.low_W[axis];
        node->high_W[along][k] = box.high_W[axis];
      }
    }
  }
  const Box all = data.nodes.empty() ? leafBoxes[0] : boxOf(data.nodes[0]);
  data.low_W = all.low_W;
  data.high_W = all.high_W;
}

} // namespace

std::unique_ptr<SurfaceData> SurfaceTree::roomForRefit(std::shared_ptr<const SurfaceTree> retired) const
{
  if (retired && retired.get() != this && retired.use_count() == 1 && retired->topologyHash() == this->topologyHash())
  {
    std::atomic_thread_fence(std::memory_order_acquire); // after whatever the last other holder read
    return std::move(std::const_pointer_cast<SurfaceTree>(retired)->data_);
  }
  const SurfaceData& old = *this->data_;
  auto data = std::make_unique<SurfaceData>();
  data->mesh.triangles = old.mesh.triangles;
  data->fanStart = old.fanStart;
  data->fan = old.fan;
  data->leaves = old.leaves;
  data->nodes = old.nodes;
  data->topologyHash = old.topologyHash;
  return data;
}

RefitResult SurfaceTree::refitted(
  std::vector<Vec3> vertices_W, std::shared_ptr<const SurfaceTree> retired, const VertexWay* way) const
{
  const SurfaceData& old = *this->data_;
  if (std::string refusal = refusalOf(old, vertices_W, way); !refusal.empty())
  {
    return { nullptr, std::move(refusal) };
  }
  std::unique_ptr<SurfaceData> data = this->roomForRefit(std::move(retired));
  data->mesh.vertices_W = std::move(vertices_W);
  std::vector<Box> leafBoxes;
  if (!refitLeaves(*data, old.faces, way, leafBoxes))
  {
    return { nullptr, old.coat_u > 0.0 ? "a segment has no length any more" : "a triangle has become collinear" };
  }
  refitNodes(*data, leafBoxes);
  data->coat_u = old.coat_u;
  data->wayName = way != nullptr ? way->name : 0;
  data->contentHash = hashContent(*data);
  return { std::shared_ptr<const SurfaceTree>(new SurfaceTree(std::move(data))), {} };
}

} // namespace palpate
