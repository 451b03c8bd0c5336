// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/support/NearestPoints.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace palpate::test
{
namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;

Kernel::Point_3 point(const Vec3& v)
{
  return { v.x(), v.y(), v.z() };
}

Triangles trianglesOf(const TriangleMesh& mesh)
{
  Triangles triangles;
  triangles.reserve(mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles)
  {
    triangles.emplace_back(point(mesh.vertices_W[a]), point(mesh.vertices_W[b]), point(mesh.vertices_W[c]));
  }
  return triangles;
}

} // namespace

class NearestPoints::Tree
{
public:
  explicit Tree(const TriangleMesh& mesh)
    : triangles_(trianglesOf(mesh)), tree_(this->triangles_.cbegin(), this->triangles_.cend())
  {
    this->tree_.accelerate_distance_queries();
  }

  [[nodiscard]] double distance_u(const Vec3& centre_W) const
  {
    return std::sqrt(this->tree_.squared_distance(point(centre_W)));
  }

  [[nodiscard]] std::vector<Vec3> within(const Vec3& centre_W, double distance_u) const
  {
    const Vec3 low = centre_W - Vec3::Constant(distance_u), high = centre_W + Vec3::Constant(distance_u);
    std::vector<Triangles::const_iterator> near;
    this->tree_.all_intersected_primitives(
      CGAL::Bbox_3(low.x(), low.y(), low.z(), high.x(), high.y(), high.z()), std::back_inserter(near));
    const auto projected = Kernel().construct_projected_point_3_object();
    std::vector<Vec3> points;
    for (const auto& triangle : near)
    {
      const Kernel::Point_3 nearest = projected(*triangle, point(centre_W));
      const Vec3 nearest_W(nearest.x(), nearest.y(), nearest.z());
      if ((nearest_W - centre_W).norm() <= distance_u &&
          std::find(points.begin(), points.end(), nearest_W) == points.end())
      {
        points.push_back(nearest_W);
      }
    }
    return points;
  }

private:
  Triangles triangles_;
  CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> tree_;
};

NearestPoints::NearestPoints(const TriangleMesh& mesh) : tree_(std::make_unique<const Tree>(mesh)) {}

NearestPoints::~NearestPoints() = default;

double NearestPoints::distance_u(const Vec3& centre_W) const
{
  return this->tree_->distance_u(centre_W);
}

std::vector<Vec3> NearestPoints::within(const Vec3& centre_W, double distance_u) const
{
  return this->tree_->within(centre_W, distance_u);
}

} // namespace palpate::test
