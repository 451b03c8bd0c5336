// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/benchmarks/Reference.h"

#include <vector>

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

namespace palpate::test
{
namespace
{

using Kernel = CGAL::Simple_cartesian<double>;
using Triangles = std::vector<Kernel::Triangle_3>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>>>;

Kernel::Point_3 point(const Vec3& v)
{
  return { v.x(), v.y(), v.z() };
}

class CgalReference final : public Reference
{
public:
  explicit CgalReference(const TriangleMesh& mesh)
  {
    this->triangles_.reserve(mesh.triangles.size());
    for (const auto& [a, b, c] : mesh.triangles)
    {
      this->triangles_.emplace_back(point(mesh.vertices_W[a]), point(mesh.vertices_W[b]), point(mesh.vertices_W[c]));
    }
    this->tree_.insert(this->triangles_.cbegin(), this->triangles_.cend());
    this->tree_.build();
  }

  [[nodiscard]] const char* name() const override { return "CGAL AABB do_intersect(segment)"; }
  [[nodiscard]] bool meets(const Vec3& from_W, const Vec3& to_W) override
  {
    return this->tree_.do_intersect(Kernel::Segment_3(point(from_W), point(to_W)));
  }

private:
  Triangles triangles_;
  Tree tree_;
};

} // namespace

std::unique_ptr<Reference> cgalReference(const TriangleMesh& mesh)
{
  return std::make_unique<CgalReference>(mesh);
}

} // namespace palpate::test
