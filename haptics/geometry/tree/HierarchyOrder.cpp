// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/tree/HierarchyOrder.h"

#include <cstddef>
#include <memory>
#include <span>

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Simple_cartesian.h>

#include "haptics/core/InTwo.h"
#include "haptics/core/LargePages.h"

namespace palpate
{
namespace
{

using Kernel = CGAL::Simple_cartesian<double>;

/// A triangle as CGAL's AABB tree needs it to build its hierarchy: its number and its box, stored in the primitive
/// itself, since the construction reads them some twenty times. That tree is never queried.
class BoxPrimitive
{
public:
  struct Box
  {
    Vec3 low, high;
    [[nodiscard]] CGAL::Bbox_3 bbox() const
    {
      return { this->low.x(), this->low.y(), this->low.z(), this->high.x(), this->high.y(), this->high.z() };
    }
  };
  using Id = std::uint32_t;
  using Point = Kernel::Point_3;
  using Datum = Box;
  using Datum_reference = const Datum&;
  using Point_reference = Point;

  BoxPrimitive() {} // NOLINT(modernize-use-equals-default): many are made, and then each of them gets its box
  BoxPrimitive(std::uint32_t triangle, const TriangleMesh& mesh) : id_(triangle)
  {
    const auto& t = mesh.triangles[triangle];
    const Vec3 &a = mesh.vertices_W[t[0]], &b = mesh.vertices_W[t[1]], &c = mesh.vertices_W[t[2]];
    this->box_ = { a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c) };
  }
  [[nodiscard]] Id id() const { return this->id_; }
  [[nodiscard]] Datum_reference datum() const { return this->box_; }
  [[nodiscard]] Point reference_point() const
  {
    return Point(this->box_.low.x(), this->box_.low.y(), this->box_.low.z());
  }

private:
  Box box_;
  Id id_;
};

using Traits = CGAL::AABB_traits<Kernel, BoxPrimitive>;
using CgalTree = CGAL::AABB_tree<Traits>;
using CgalNode = CGAL::AABB_node<Traits>;

/// A tree of this many primitives fits into a core's cache during its construction.
constexpr std::size_t mostOfATree = 8192;

/// The order in which CGAL's tree stores its primitives: an in-order traversal of its leaves.
std::uint32_t* collectOrder(const CgalNode* node, std::size_t count, std::uint32_t* order)
{
  if (count == 2)
  {
    *order++ = node->left_data().id();
    *order++ = node->right_data().id();
    return order;
  }
  if (count == 3)
  {
    *order++ = node->left_data().id();
    return collectOrder(&node->right_child(), 2, order);
  }
  order = collectOrder(&node->left_child(), count / 2, order);
  return collectOrder(&node->right_child(), count - count / 2, order);
}

void orderOfTree(std::span<const BoxPrimitive> boxes, std::uint32_t* order)
{
  if (boxes.size() < 2)
  {
    *order = boxes.front().id();
    return;
  }
  CgalTree tree;
  for (const BoxPrimitive& box : boxes)
  {
    tree.insert(box);
  }
  tree.build();
  collectOrder(tree.root_node(), boxes.size(), order);
}

/// CGAL's tree splits its primitives, then each half as a tree of its own: so its upper nodes can be split here, by its
/// own traits, without storage for these nodes, and each of two threads takes one half.
void orderHalves(std::span<BoxPrimitive> boxes, unsigned threads, std::uint32_t* order)
{
  if (boxes.size() <= mostOfATree)
  {
    orderOfTree(boxes, order);
    return;
  }
  const Traits traits;
  const CGAL::Bbox_3 bounds = traits.compute_bbox_object()(boxes.begin(), boxes.end());
  traits.split_primitives_object()(boxes.begin(), boxes.end(), bounds);
  const std::size_t half = boxes.size() / 2;
  inTwo(
    threads, [&] { orderHalves(boxes.first(half), 1, order); },
    [&] { orderHalves(boxes.subspan(half), 1, order + half); });
}

} // namespace

std::vector<std::uint32_t> hierarchyOrder(const TriangleMesh& mesh, unsigned threads)
{
  const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
  const auto boxes = std::make_unique_for_overwrite<BoxPrimitive[]>(count);
  askForLargePages(boxes.get(), count * sizeof(BoxPrimitive));
  const auto box = [&](std::uint32_t first, std::uint32_t last)
  {
    for (std::uint32_t i = first; i < last; ++i)
    {
      boxes[i] = BoxPrimitive(i, mesh);
    }
  };
  inTwo(
    threads, [&] { box(0, count / 2); }, [&] { box(count / 2, count); });
  std::vector<std::uint32_t> order;
  resizeLarge(order, count);
  orderHalves({ boxes.get(), count }, threads, order.data());
  return order;
}

} // namespace palpate
