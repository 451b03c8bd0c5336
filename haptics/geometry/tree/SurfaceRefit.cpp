// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <tuple>
#include <utility>

#include "haptics/core/LargePages.h"
#include "haptics/geometry/mesh/ExactPredicates.h"
#include "haptics/geometry/tree/SurfaceData.h"
#include "haptics/geometry/tree/SurfaceRecords.h"
#include "haptics/geometry/tree/SurfaceTree.h"
#include "haptics/geometry/tree/VertexStart.h"

namespace palpate
{
namespace
{

/// Below this amplification of its rounding a normal in double precision proves that a triangle has an area.
constexpr float certainlyFlat = 1e9F;
/// Most positions of a path beside the tree's own: VertexStart has a weight for each.
constexpr std::size_t mostPlaces = std::tuple_size_v<decltype(VertexStart::ofPlaces)>;

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
    return "vertex " + std::to_string(bad - vertices_W.begin()) + " has moved to a position that is not finite";
  }
  return {};
}

std::string refusalOf(const SurfaceData& old, const std::vector<Vec3>& vertices_W, const VertexWay* way)
{
  std::string refusal = refusalOf(old, vertices_W);
  if (way != nullptr && way->also.size() > mostPlaces)
  {
    return "a surface has at most " + std::to_string(mostPlaces) + " positions, not " +
           std::to_string(way->also.size());
  }
  for (std::size_t i = 0; way != nullptr && refusal.empty() && i < way->also.size(); ++i)
  {
    refusal = refusalOf(old, *way->also[i]);
  }
  return refusal;
}

/// True if a triangle has an area, a segment a length.
bool hasExtent(const FaceRecord& face)
{
  const auto& [a, b, c] = face.corner_W;
  if (b == c)
  {
    return a != b;
  }
  return face.normal_W.allFinite() && (face.sliver < certainlyFlat || !exactlyCollinear(a, b, c));
}

/// The box of each leaf at the tree's own positions, then at each other position of the path.
using LeafBoxes = std::vector<std::vector<Box>>;

/// The faces of a leaf at the present positions. Returns false where a triangle has no area, a segment no length.
bool refitFaces(SurfaceData& data, const Leaf& leaf, const std::vector<FacePlane>& old, Box& box)
{
  box = Box::empty();
  for (std::uint32_t t = leaf.first; t < leaf.first + leaf.count; ++t)
  {
    const FaceRecord face = makeFace(data, t, old[t].owned);
    data.faces[t] = face;
    if (!hasExtent(face))
    {
      return false;
    }
    box.include(boxOf(face.corner_W));
  }
  return true;
}

/// The corners of a leaf's faces at another position of the path, and their box.
using LeafCorners = std::array<std::array<Vec3, 3>, Leaf::capacity>;

Box cornersAt(const SurfaceData& data, const Leaf& leaf, const std::vector<Vec3>& places_W, LeafCorners& corners_W)
{
  Box box = Box::empty();
  for (std::uint32_t k = 0; k < leaf.count; ++k)
  {
    const auto& [a, b, c] = data.corners(leaf.first + k);
    corners_W[k] = { places_W[a], places_W[b], places_W[c] };
    box.include(boxOf(corners_W[k]));
  }
  return box;
}

/// Works leaf by leaf, while its faces are in the cache: memory access is the cost. Returns false where a triangle has
/// no area, a segment no length.
bool refitLeaves(SurfaceData& data, const std::vector<FacePlane>& old,
  const std::vector<const std::vector<Vec3>*>& also, LeafBoxes& boxes)
{
  resizeLarge(data.faces, old.size());
  resizeLarge(data.discs, 2 * data.leaves.size());
  std::vector<LeafCorners> elsewhere_W(also.size());
  for (std::size_t index = 0; index < data.leaves.size(); ++index)
  {
    Leaf& leaf = data.leaves[index];
    if (!refitFaces(data, leaf, old, boxes[0][index]))
    {
      return false;
    }
    Box hull = boxes[0][index];
    for (std::size_t place = 0; place < also.size(); ++place)
    {
      boxes[place + 1][index] = cornersAt(data, leaf, *also[place], elsewhere_W[place]);
      hull.include(boxes[place + 1][index]);
    }
    leaf = makeLeaf(hull, leaf.first, leaf.count);
    layDiscs(data, index);
    for (std::size_t place = 0; place < also.size(); ++place)
    {
      for (std::uint32_t k = 0; k < leaf.count; ++k)
      {
        layBall(data.places[place].balls[2 * index + k / 4], static_cast<int>(k % 4), leaf, elsewhere_W[place][k]);
      }
    }
  }
  return true;
}

void refitNodes(SurfaceData& data, const LeafBoxes& boxes)
{
  const Box all = layBoxes(data.nodes, boxes[0], data.nodes);
  data.low_W = all.low_W;
  data.high_W = all.high_W;
  for (std::size_t place = 0; place < data.places.size(); ++place)
  {
    PlaceBounds& bounds = data.places[place];
    resizeLarge(bounds.nodes, data.nodes.size());
    bounds.all = layBoxes(data.nodes, boxes[place + 1], bounds.nodes);
  }
}

} // namespace

std::unique_ptr<SurfaceData> SurfaceTree::roomForRefit(std::shared_ptr<const SurfaceTree> retired) const
{
  if (retired && retired.get() != this && retired.use_count() == 1 && retired->topologyHash() == this->topologyHash())
  {
    std::atomic_thread_fence(std::memory_order_acquire); // after all reads by the last other owner
    return std::move(std::const_pointer_cast<SurfaceTree>(retired)->data_);
  }
  const SurfaceData& old = *this->data_;
  auto data = std::make_unique<SurfaceData>();
  data->mesh.triangles = old.mesh.triangles;
  data->fanStart = old.fanStart;
  data->fan = old.fan;
  data->across = old.across;
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
  const std::vector<const std::vector<Vec3>*> also =
    way != nullptr ? way->also : std::vector<const std::vector<Vec3>*>{};
  data->places.resize(also.size());
  for (PlaceBounds& place : data->places)
  {
    resizeLarge(place.balls, 2 * data->leaves.size());
  }
  LeafBoxes boxes(1 + also.size());
  for (std::vector<Box>& of : boxes)
  {
    resizeLarge(of, data->leaves.size());
  }
  if (!refitLeaves(*data, old.faces, also, boxes))
  {
    return { nullptr, old.coat_u > 0.0 ? "a segment has lost its length" : "a triangle has become collinear" };
  }
  refitNodes(*data, boxes);
  data->coat_u = old.coat_u;
  data->wayName = way != nullptr ? way->name : 0;
  data->contentHash = hashContent(*data);
  return { std::shared_ptr<const SurfaceTree>(new SurfaceTree(std::move(data))), {} };
}

} // namespace palpate
