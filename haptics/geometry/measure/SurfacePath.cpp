// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/measure/SurfacePath.h"

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <limits>
#include <queue>
#include <utility>

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>

#include "haptics/core/WordHash.h"
#include "haptics/geometry/simplify/SurfaceDistance.h"
#include "haptics/geometry/tree/SurfaceData.h"

namespace palpate
{
namespace
{

namespace Processing = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Simple_cartesian<double>; // no exact numbers, whose libraries would have to be linked
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Paths = CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>>;

/// Length of the shortest path along edges, with straight first and last pieces; infinite if there is none.
double lengthAlongEdges_u(const SurfaceData& data, const NearestPoint& from, const NearestPoint& to)
{
  using Reached = std::pair<double, std::uint32_t>;
  std::vector<double> way_u(data.mesh.vertices_W.size(), std::numeric_limits<double>::infinity());
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> open;
  const auto reach = [&](std::uint32_t v, double length_u)
  {
    if (length_u < way_u[v])
    {
      way_u[v] = length_u;
      open.emplace(length_u, v);
    }
  };
  for (const std::uint32_t v : data.corners(from.triangle))
  {
    reach(v, (data.vertex(v) - from.p_W).norm());
  }
  double best_u = std::numeric_limits<double>::infinity();
  while (!open.empty() && open.top().first < best_u)
  {
    const auto [length_u, v] = open.top();
    open.pop();
    if (length_u > way_u[v])
    {
      continue;
    }
    best_u = data.hasCorner(to.triangle, v) ? std::min(best_u, length_u + (to.p_W - data.vertex(v)).norm()) : best_u;
    data.forEachAround(v,
      [&](std::uint32_t t)
      {
        for (const std::uint32_t next : data.corners(t))
        {
          reach(next, length_u + (data.vertex(next) - data.vertex(v)).norm());
        }
      });
  }
  return best_u;
}

/// Whether a path of that length from one place to the other can come to the triangle.
bool matters(const std::array<Vec3, 3>& corner_W, const NearestPoint& from, const NearestPoint& to, double length_u)
{
  const Vec3 centre_W = (corner_W[0] + corner_W[1] + corner_W[2]) / 3.0;
  double radius_u = 0.0;
  for (const Vec3& corner : corner_W)
  {
    radius_u = std::max(radius_u, (corner - centre_W).norm());
  }
  constexpr double rounding = 1.0 + 1e-9;
  return (centre_W - from.p_W).norm() + (centre_W - to.p_W).norm() - 2.0 * radius_u <= length_u * rounding;
}

/// A vertex's place, off by next to nothing and differently for each. CGAL's search sometimes loses a path that goes
/// exactly through the vertices of a regular grid, and finds a longer one. The path found so is laid on the exact
/// surface, where it is longer than the shortest by the square of that share only.
Vec3 unsettled(const SurfaceData& data, std::uint32_t v)
{
  constexpr double share = 1e-6; // of an edge
  WordHash hash;
  hash.add(std::uint64_t{ v });
  std::uint64_t bits = hash.value();
  double edge_u = std::numeric_limits<double>::infinity();
  data.forEachAround(v,
    [&](std::uint32_t t)
    {
      for (const std::uint32_t other : data.corners(t))
      {
        edge_u = other == v ? edge_u : std::min(edge_u, (data.vertex(other) - data.vertex(v)).norm());
      }
    });
  Vec3 off;
  for (int k = 0; k < 3; ++k, bits >>= 16)
  {
    off[k] = static_cast<double>(bits & 0xffff) / 0xffff - 0.5;
  }
  return data.vertex(v) + share * edge_u * off;
}

/// The triangles that matter as CGAL wants them, and which faces the two places are on.
struct Part
{
  Mesh mesh;
  Mesh::Face_index from, to;
  std::vector<Vec3> place_W; ///< of the vertices of `mesh`, where they are

  Part(const SurfaceData& data, const NearestPoint& begin, const NearestPoint& end, double length_u)
  {
    constexpr std::uint32_t unused = SurfaceData::none;
    std::vector<std::uint32_t> number(data.mesh.vertices_W.size(), unused);
    std::vector<Kernel::Point_3> points;
    std::vector<std::array<std::size_t, 3>> faces;
    for (std::uint32_t t = 0; t < data.mesh.triangles.size(); ++t)
    {
      if (!matters(data.cornersOf(t), begin, end, length_u))
      {
        continue;
      }
      this->from = t == begin.triangle ? Mesh::Face_index(static_cast<std::uint32_t>(faces.size())) : this->from;
      this->to = t == end.triangle ? Mesh::Face_index(static_cast<std::uint32_t>(faces.size())) : this->to;
      std::array<std::size_t, 3> face{};
      for (std::size_t k = 0; k < 3; ++k)
      {
        const std::uint32_t v = data.corners(t)[k];
        if (number[v] == unused)
        {
          number[v] = static_cast<std::uint32_t>(points.size());
          const Vec3 off_W = unsettled(data, v);
          points.emplace_back(off_W.x(), off_W.y(), off_W.z());
          this->place_W.push_back(data.vertex(v));
        }
        face[k] = number[v];
      }
      faces.push_back(face);
    }
    Copies copies{ {}, this->place_W };
    Processing::orient_polygon_soup(points, faces, CGAL::parameters::visitor(copies)); // faces keep their order
    Processing::polygon_soup_to_polygon_mesh(points, faces, this->mesh);
  }

private:
  /// Edges of three triangles are cut apart: their vertices are there more than once.
  struct Copies : Processing::Default_orientation_visitor
  {
    std::vector<Vec3>& place_W;
    void duplicated_vertex(std::size_t v, std::size_t /*copy*/) { this->place_W.push_back(this->place_W[v]); }
  };
};

/// Corners of a face where they are, in the order of its own halfedge, as barycentric coordinates go.
std::array<Vec3, 3> cornersOf(const Part& part, Mesh::Face_index face)
{
  const auto h = part.mesh.halfedge(face);
  return { part.place_W[part.mesh.source(h)], part.place_W[part.mesh.target(h)],
    part.place_W[part.mesh.target(part.mesh.next(h))] };
}

Paths::Face_location locationOf(const Part& part, Mesh::Face_index face, const Vec3& p_W)
{
  const auto [a, b, c] = cornersOf(part, face);
  const Vec3 normal = (b - a).cross(c - a);
  const double u = std::max(0.0, (c - b).cross(p_W - b).dot(normal));
  const double v = std::max(0.0, (a - c).cross(p_W - c).dot(normal));
  const double w = std::max(0.0, (b - a).cross(p_W - a).dot(normal));
  const double sum = u + v + w;
  return { face, { u / sum, v / sum, w / sum } };
}

/// Receives a path as CGAL has it, by edges and faces, and lays it where they are.
struct Laying
{
  const Part& part;
  std::vector<Vec3>& points_W;

  void operator()(Mesh::Halfedge_index edge, double share)
  {
    const Vec3& from = this->part.place_W[this->part.mesh.source(edge)];
    this->points_W.push_back(from + share * (this->part.place_W[this->part.mesh.target(edge)] - from));
  }
  void operator()(Mesh::Vertex_index v) { this->points_W.push_back(this->part.place_W[v]); }
  void operator()(Mesh::Face_index face, const Paths::Barycentric_coordinates& at)
  {
    const auto [a, b, c] = cornersOf(this->part, face);
    this->points_W.emplace_back(at[0] * a + at[1] * b + at[2] * c);
  }
};

SurfacePath refused(const char* problem)
{
  return { {}, 0.0, problem };
}

SurfacePath over(const Part& part, const NearestPoint& from, const NearestPoint& to)
{
  Paths paths(part.mesh);
  const Paths::Face_location begin = locationOf(part, part.from, from.p_W);
  const Paths::Face_location end = locationOf(part, part.to, to.p_W);
  paths.add_source_point(end.first, end.second); // paths come back from a place to the source
  SurfacePath path;
  Laying laying{ part, path.points_W };
  paths.shortest_path_sequence_to_source_points(begin.first, begin.second, laying);
  for (std::size_t i = 1; i < path.points_W.size(); ++i)
  {
    path.length_u += (path.points_W[i] - path.points_W[i - 1]).norm();
  }
  return path.points_W.size() < 2 ? refused("no path on the surface was found between the two points") : path;
}

} // namespace

SurfacePath shortestPath(const SurfaceTree& surface, const Vec3& from_W, const Vec3& to_W)
{
  const SurfaceData& data = surface.data();
  if (data.coat_u > 0.0)
  {
    return refused("lines have no surface for a path");
  }
  if (!from_W.allFinite() || !to_W.allFinite())
  {
    return refused("a point is not finite");
  }
  const NearestPoint from = nearestOn(data, from_W), to = nearestOn(data, to_W);
  if (from.triangle == to.triangle)
  {
    return { { from.p_W, to.p_W }, (to.p_W - from.p_W).norm(), "" };
  }
  const double bound_u = lengthAlongEdges_u(data, from, to);
  if (bound_u == std::numeric_limits<double>::infinity())
  {
    return refused("the two points are on parts of the surface that are not connected");
  }
  return over(Part(data, from, to, bound_u), from, to);
}

} // namespace palpate
