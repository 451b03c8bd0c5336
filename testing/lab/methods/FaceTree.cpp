// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/lab/methods/FaceTree.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

namespace palpate::lab
{
namespace
{

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Triangle = Kernel::Triangle_3;
using Triangles = std::vector<Triangle>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using CgalTree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

Point toCgal(const Vec3& v)
{
  return { v.x(), v.y(), v.z() };
}

Vec3 toEigen(const Point& p)
{
  return { p.x(), p.y(), p.z() };
}

Vec3 areaVector(const Triangle& t)
{
  const Vec3 a = toEigen(t[0]);
  return (toEigen(t[1]) - a).cross(toEigen(t[2]) - a);
}

Triangles usable(const TriangleMesh& mesh)
{
  Triangles triangles;
  for (const auto& [a, b, c] : mesh.triangles)
  {
    const Triangle t(toCgal(mesh.vertices_W[a]), toCgal(mesh.vertices_W[b]), toCgal(mesh.vertices_W[c]));
    const double area2 = areaVector(t).squaredNorm();
    if (std::isfinite(area2) && area2 > 0)
    {
      triangles.push_back(t);
    }
  }
  return triangles;
}

/// Where the segment from + t (to - from) crosses the triangle (Moeller & Trumbore 1997); one along its plane never
/// does.
std::optional<double> crossing(const Triangle& triangle, const Vec3& from, const Vec3& way)
{
  const Vec3 a = toEigen(triangle[0]), e = toEigen(triangle[1]) - a, f = toEigen(triangle[2]) - a;
  const Vec3 across = way.cross(f), offset = from - a, turned = offset.cross(e);
  const double determinant = e.dot(across);
  if (determinant == 0.0)
  {
    return std::nullopt;
  }
  const double u = offset.dot(across) / determinant, v = way.dot(turned) / determinant;
  const double t = f.dot(turned) / determinant;
  return u >= 0 && v >= 0 && u + v <= 1 && t > 0 && t <= 1 ? std::optional(t) : std::nullopt;
}

} // namespace

struct FaceTree::Tree
{
  explicit Tree(const TriangleMesh& mesh) : triangles(usable(mesh)), faces(triangles.cbegin(), triangles.cend())
  {
    this->faces.build();
  }

  [[nodiscard]] Face face(Triangles::const_iterator at, const Vec3& point_W) const
  {
    return { static_cast<std::size_t>(at - this->triangles.cbegin()), point_W, areaVector(*at).normalized() };
  }

  [[nodiscard]] std::vector<Triangles::const_iterator> inBox(const CGAL::Bbox_3& box) const
  {
    std::vector<Triangles::const_iterator> found;
    this->faces.all_intersected_primitives(box, std::back_inserter(found));
    std::sort(found.begin(), found.end()); // whatever order the tree has
    return found;
  }

  Triangles triangles;
  CgalTree faces;
};

FaceTree::FaceTree(const TriangleMesh& mesh) : tree_(std::make_unique<const Tree>(mesh)) {}

FaceTree::~FaceTree() = default;

Face FaceTree::nearest(const Vec3& p_W) const
{
  const auto [point, at] = this->tree_->faces.closest_point_and_primitive(toCgal(p_W));
  return this->tree_->face(at, toEigen(point));
}

std::vector<Face> FaceTree::within(const Vec3& p_W, double reach_u, std::size_t most) const
{
  const Vec3 low = p_W.array() - reach_u, high = p_W.array() + reach_u;
  std::vector<std::pair<double, Face>> found;
  const Kernel::Construct_projected_point_3 nearestOn;
  for (const auto at : this->tree_->inBox({ low.x(), low.y(), low.z(), high.x(), high.y(), high.z() }))
  {
    const Vec3 point = toEigen(nearestOn(*at, toCgal(p_W)));
    const double distance = (point - p_W).norm();
    if (distance <= reach_u)
    {
      found.emplace_back(distance, this->tree_->face(at, point));
    }
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Face> faces;
  for (std::size_t i = 0; i < std::min(most, found.size()); ++i)
  {
    faces.push_back(found[i].second);
  }
  return faces;
}

std::optional<Face> FaceTree::firstHit(const Vec3& from_W, const Vec3& to_W) const
{
  const Vec3 way = to_W - from_W;
  const double margin = 1e-3 * way.norm(); // a straight segment has a box without width, which rounding may miss
  const Vec3 low = from_W.cwiseMin(to_W).array() - margin, high = from_W.cwiseMax(to_W).array() + margin;
  double first = 2.0;
  std::optional<Face> hit;
  for (const auto at : this->tree_->inBox({ low.x(), low.y(), low.z(), high.x(), high.y(), high.z() }))
  {
    const std::optional<double> t = crossing(*at, from_W, way);
    if (t && *t < first)
    {
      first = *t;
      hit = this->tree_->face(at, from_W + *t * way);
    }
  }
  return hit;
}

} // namespace palpate::lab
