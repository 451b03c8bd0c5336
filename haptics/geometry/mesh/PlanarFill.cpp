// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/mesh/PlanarFill.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#define CGAL_DISABLE_GMP 1 // the library would have to be linked; CGAL's own exact numbers do
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

namespace palpate
{
namespace
{

enum class Side
{
  Unknown,
  Outside,
  Inside,
};

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using FaceBase =
  CGAL::Triangulation_face_base_with_info_2<Side, Kernel, CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Cdt =
  CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
    CGAL::No_constraint_intersection_requiring_constructions_tag>;
using Edge =
  std::pair<std::uint32_t, std::uint32_t>; // numbers of corners, each the first in its place, the lower first

Edge edgeOf(std::uint32_t a, std::uint32_t b)
{
  return std::minmax(a, b);
}

/// Those that are there an odd number of times, once each and in order.
std::vector<Edge> oddOnes(std::vector<Edge> edges)
{
  std::sort(edges.begin(), edges.end());
  std::vector<Edge> odd;
  for (auto run = edges.begin(); run != edges.end();)
  {
    const auto stop = std::upper_bound(run, edges.end(), *run);
    if ((stop - run) % 2 == 1)
    {
      odd.push_back(*run);
    }
    run = stop;
  }
  return odd;
}

std::vector<Edge> bordersOf(const PlanarPolygon& polygon)
{
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < polygon.place.size(); ++i)
  {
    const std::uint32_t a = polygon.place[i], b = polygon.place[(i + 1) % polygon.place.size()];
    if (a != b)
    {
      edges.push_back(edgeOf(a, b));
    }
  }
  return oddOnes(std::move(edges));
}

/// Corners in units of the power of two next to the largest coordinate, which changes no predicate; a coordinate that
/// is subnormal even then becomes zero. Reason: cpp_float of CGAL 5.6 to 6.2 takes subnormal numbers for larger ones.
class InUnitsOfSize
{
public:
  explicit InUnitsOfSize(const std::vector<PlanarPolygon::Point>& points)
  {
    double largest = 0.0;
    for (const auto& p : points)
    {
      largest = std::max({ largest, std::abs(p.u), std::abs(p.v) });
    }
    this->exponent_ = largest > 0.0 ? std::ilogb(largest) : 0;
  }

  [[nodiscard]] Kernel::Point_2 operator()(const PlanarPolygon::Point& p) const
  {
    return { this->scaled(p.u), this->scaled(p.v) };
  }

private:
  [[nodiscard]] double scaled(double coordinate) const
  {
    const double x = std::scalbn(coordinate, -this->exponent_);
    return std::isnormal(x) ? x : 0.0;
  }

  int exponent_ = 0;
};

class Fill
{
public:
  /// False where corners hide each other or are all on a line.
  bool place(const PlanarPolygon& polygon)
  {
    const InUnitsOfSize seen(polygon.points);
    std::vector<std::pair<Kernel::Point_2, std::uint32_t>> points;
    for (std::uint32_t i = 0; i < polygon.points.size(); ++i)
    {
      if (polygon.place[i] == i)
      {
        points.emplace_back(seen(polygon.points[i]), i);
      }
    }
    this->cdt_.insert(points.begin(), points.end());
    this->vertices_.resize(polygon.points.size());
    for (const Cdt::Vertex_handle v : this->cdt_.finite_vertex_handles())
    {
      this->vertices_[v->info()] = v;
    }
    return this->cdt_.dimension() == 2 && this->cdt_.number_of_vertices() == points.size();
  }

  /// False where edges cross.
  bool constrain(const std::vector<Edge>& borders)
  {
    try
    {
      for (const auto& [a, b] : borders)
      {
        this->cdt_.insert_constraint(this->vertices_[a], this->vertices_[b]);
      }
    }
    catch (const Cdt::Intersection_of_constraints_exception&)
    {
      return false;
    }
    return true;
  }

  /// Takes the triangles that join an edge to its parts, and returns the parts of all edges.
  std::vector<Edge> split(const std::vector<Edge>& borders, const TakeTriangle& take) const
  {
    std::vector<Edge> parts;
    for (const auto& [a, b] : borders)
    {
      for (std::uint32_t from = a; from != b;)
      {
        const std::uint32_t to = this->nextOn(from, b);
        parts.push_back(edgeOf(from, to));
        if (from != a)
        {
          take(a, from, to);
        }
        from = to;
      }
    }
    return oddOnes(std::move(parts));
  }

  /// Takes the triangles inside, counterclockwise: each passing of a border changes the side.
  void takeInside(const std::vector<Edge>& borders, const TakeTriangle& take)
  {
    for (const Cdt::Face_handle face : this->cdt_.all_face_handles())
    {
      face->info() = Side::Unknown;
    }
    std::vector<Cdt::Face_handle> open = { this->cdt_.infinite_face() };
    open.front()->info() = Side::Outside;
    while (!open.empty())
    {
      const Cdt::Face_handle face = open.back();
      open.pop_back();
      if (face->info() == Side::Inside)
      {
        take(face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info());
      }
      for (int i = 0; i < 3; ++i)
      {
        const Cdt::Face_handle beside = face->neighbor(i);
        if (beside->info() == Side::Unknown)
        {
          beside->info() =
            this->isBorder(face, i, borders) == (face->info() == Side::Inside) ? Side::Outside : Side::Inside;
          open.push_back(beside);
        }
      }
    }
  }

private:
  /// The next corner on the segment from `a` to `b`, which the triangulation has edges along.
  [[nodiscard]] std::uint32_t nextOn(std::uint32_t a, std::uint32_t b) const
  {
    Cdt::Vertex_handle next;
    Cdt::Face_handle face;
    int index = 0;
    const bool found = this->cdt_.includes_edge(this->vertices_[a], this->vertices_[b], next, face, index);
    return found ? next->info() : b;
  }

  [[nodiscard]] bool isBorder(Cdt::Face_handle face, int index, const std::vector<Edge>& borders) const
  {
    if (!this->cdt_.is_constrained({ face, index })) // all borders are, no edge of the infinite vertex is
    {
      return false;
    }
    const std::uint32_t a = face->vertex(Cdt::ccw(index))->info(), b = face->vertex(Cdt::cw(index))->info();
    return std::binary_search(borders.begin(), borders.end(), edgeOf(a, b));
  }

  Cdt cdt_;
  std::vector<Cdt::Vertex_handle> vertices_; ///< by the number of the corner
};

} // namespace

bool fillPlanar(const PlanarPolygon& polygon, const TakeTriangle& take)
{
  const std::vector<Edge> borders = bordersOf(polygon);
  Fill fill;
  if (!fill.place(polygon) || !fill.constrain(borders))
  {
    return false;
  }
  fill.takeInside(fill.split(borders, take), [&](std::uint32_t a, std::uint32_t b, std::uint32_t c)
    { take(a, polygon.mirrored ? c : b, polygon.mirrored ? b : c); });
  return true;
}

} // namespace palpate
