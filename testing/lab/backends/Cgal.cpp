// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>

#include "testing/lab/backends/Backend.h"
#include "testing/support/Alternative.h"

namespace palpate::lab
{
namespace
{

template<class Kernel>
typename Kernel::Point_3 point(const Vec3& v)
{
  return { v.x(), v.y(), v.z() };
}

template<class Point>
Vec3 vec(const Point& p)
{
  return { p.x(), p.y(), p.z() };
}

template<class Kernel>
std::vector<typename Kernel::Triangle_3> trianglesOf(const TriangleMesh& mesh)
{
  std::vector<typename Kernel::Triangle_3> triangles;
  triangles.reserve(mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles)
  {
    triangles.emplace_back(
      point<Kernel>(mesh.vertices_W[a]), point<Kernel>(mesh.vertices_W[b]), point<Kernel>(mesh.vertices_W[c]));
  }
  return triangles;
}

/// The fraction of the segment from `from` that `p` of the segment stands for.
double fractionOf(const Vec3& p_W, const Vec3& from_W, const Vec3& to_W)
{
  return std::clamp((p_W - from_W).norm() / (to_W - from_W).norm(), 0.0, 1.0);
}

template<class Kernel>
class CgalTree final : public Backend
{
public:
  explicit CgalTree(const TriangleMesh& mesh)
    : triangles_(trianglesOf<Kernel>(mesh)), tree_(this->triangles_.cbegin(), this->triangles_.cend())
  {
    this->tree_.build();
    this->tree_.accelerate_distance_queries();
  }

  [[nodiscard]] bool meets(const Vec3& from_W, const Vec3& to_W) override
  {
    return this->tree_.do_intersect(Segment(point<Kernel>(from_W), point<Kernel>(to_W)));
  }

  [[nodiscard]] std::optional<double> firstHit(const Vec3& from_W, const Vec3& to_W) override
  {
    // The tree has a first intersection for rays only; of a segment, all are asked for.
    std::vector<Hit> hits;
    this->tree_.all_intersections(Segment(point<Kernel>(from_W), point<Kernel>(to_W)), std::back_inserter(hits));
    std::optional<double> first;
    for (const Hit& hit : hits)
    {
      const double t = fractionOf(this->nearest(hit, from_W), from_W, to_W);
      first = first ? std::min(*first, t) : t;
    }
    return first;
  }

  [[nodiscard]] std::optional<double> distance_u(const Vec3& p_W) override
  {
    return (vec(this->tree_.closest_point(point<Kernel>(p_W))) - p_W).norm();
  }

private:
  using Segment = typename Kernel::Segment_3;
  using Triangles = std::vector<typename Kernel::Triangle_3>;
  using Primitive = CGAL::AABB_triangle_primitive<Kernel, typename Triangles::const_iterator>;
  using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;
  using Hit = typename Tree::template Intersection_and_primitive_id<Segment>::Type;

  /// A hit is a point, or a piece of the segment that lies in the triangle's plane.
  [[nodiscard]] static Vec3 nearest(const Hit& hit, const Vec3& from_W)
  {
    if (const auto* p = test::alternative<typename Kernel::Point_3>(hit.first))
    {
      return vec(*p);
    }
    const auto& piece = *test::alternative<Segment>(hit.first);
    const Vec3 a = vec(piece.source()), b = vec(piece.target());
    return (a - from_W).squaredNorm() < (b - from_W).squaredNorm() ? a : b;
  }

  Triangles triangles_;
  Tree tree_;
};

using ExactPredicates = CGAL::Exact_predicates_inexact_constructions_kernel;

class BruteForce final : public Backend
{
public:
  explicit BruteForce(const TriangleMesh& mesh) : triangles_(trianglesOf<ExactPredicates>(mesh)) {}

  [[nodiscard]] bool meets(const Vec3& from_W, const Vec3& to_W) override
  {
    const ExactPredicates::Segment_3 segment(point<ExactPredicates>(from_W), point<ExactPredicates>(to_W));
    return std::any_of(this->triangles_.begin(), this->triangles_.end(),
      [&segment](const auto& triangle) { return CGAL::do_intersect(segment, triangle); });
  }

  [[nodiscard]] std::optional<double> firstHit(const Vec3& from_W, const Vec3& to_W) override
  {
    std::optional<double> first;
    const ExactPredicates::Segment_3 segment(point<ExactPredicates>(from_W), point<ExactPredicates>(to_W));
    for (const auto& triangle : this->triangles_)
    {
      if (CGAL::do_intersect(segment, triangle))
      {
        const Vec3 a = vec(triangle.vertex(0));
        const Vec3 n = (vec(triangle.vertex(1)) - a).cross(vec(triangle.vertex(2)) - a);
        const double t = std::clamp(n.dot(a - from_W) / n.dot(to_W - from_W), 0.0, 1.0);
        first = first ? std::min(*first, t) : t;
      }
    }
    return first;
  }

  [[nodiscard]] std::optional<double> distance_u(const Vec3& p_W) override
  {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& triangle : this->triangles_)
    {
      least = std::min(least, CGAL::squared_distance(point<ExactPredicates>(p_W), triangle));
    }
    return std::sqrt(least);
  }

private:
  const std::vector<ExactPredicates::Triangle_3> triangles_;
};

} // namespace

std::unique_ptr<Backend> makeCgal(const TriangleMesh& mesh)
{
  return std::make_unique<CgalTree<CGAL::Simple_cartesian<double>>>(mesh);
}

std::unique_ptr<Backend> makeExact(const TriangleMesh& mesh)
{
  return std::make_unique<CgalTree<ExactPredicates>>(mesh);
}

std::unique_ptr<Backend> makeBruteForce(const TriangleMesh& mesh)
{
  return std::make_unique<BruteForce>(mesh);
}

} // namespace palpate::lab
