// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tool/mesh/MassMetric.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{

using Edge = std::pair<std::uint32_t, std::uint32_t>;

std::uint32_t weldedIndex(const std::vector<Vec3>& ordered, const Vec3& v)
{
  const auto before = [](const Vec3& a, const Vec3& b)
  { return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end()); };
  return static_cast<std::uint32_t>(std::lower_bound(ordered.begin(), ordered.end(), v, before) - ordered.begin());
}

/// True if each edge is traversed once in each direction.
bool turnedAlike(const TriangleMesh& raw, const TriangleMesh& clean)
{
  std::vector<Edge> ways;
  for (const auto& t : raw.triangles)
  {
    std::array<std::uint32_t, 3> c;
    std::transform(
      t.begin(), t.end(), c.begin(), [&](std::uint32_t v) { return weldedIndex(clean.vertices_W, raw.vertices_W[v]); });
    for (int k = 0; k < 3; ++k)
    {
      ways.emplace_back(c[k], c[(k + 1) % 3]);
    }
  }
  std::sort(ways.begin(), ways.end());
  const bool once = std::adjacent_find(ways.begin(), ways.end()) == ways.end();
  return once &&
         std::all_of(ways.begin(), ways.end(),
           [&](const Edge& way) { return std::binary_search(ways.begin(), ways.end(), Edge(way.second, way.first)); });
}

/// Weight, first and second moments about a point near the mesh, so that far from the origin nothing cancels.
struct Moments
{
  double weight = 0.0;
  Vec3 first = Vec3::Zero();
  double second = 0.0; ///< trace
};

/// A tetrahedron with one corner at the reference, with the sign of its volume.
void addSolid(Moments& m, const Vec3& a, const Vec3& b, const Vec3& c)
{
  const double volume = a.dot(b.cross(c)) / 6.0;
  const Vec3 sum = a + b + c;
  m.weight += volume;
  m.first += volume / 4.0 * sum;
  m.second += volume / 20.0 * (sum.squaredNorm() + a.squaredNorm() + b.squaredNorm() + c.squaredNorm());
}

void addSheet(Moments& m, const Vec3& a, const Vec3& b, const Vec3& c)
{
  const double area = 0.5 * (b - a).cross(c - a).norm();
  const Vec3 sum = a + b + c;
  m.weight += area;
  m.first += area / 3.0 * sum;
  m.second += area / 12.0 * (sum.squaredNorm() + a.squaredNorm() + b.squaredNorm() + c.squaredNorm());
}

/// Inertia about the axes is the trace less each second moment: their mean is two thirds of the trace.
double gyrationOf(double meanSquare)
{
  return std::sqrt(std::max(0.0, 2.0 / 3.0 * meanSquare));
}

template<class Add>
Moments momentsOf(const TriangleMesh& mesh, const Vec3& about_W, Add add)
{
  Moments moments;
  for (const auto& [a, b, c] : mesh.triangles)
  {
    add(moments, mesh.vertices_W[a] - about_W, mesh.vertices_W[b] - about_W, mesh.vertices_W[c] - about_W);
  }
  return moments;
}

} // namespace

MassMetric massMetric(const TriangleMesh& raw, const CleanResult& clean)
{
  const Vec3 about_W = clean.mesh.vertices_W.front();
  const bool closed = clean.report.boundaryEdges == 0 && clean.report.nonManifoldEdges == 0 &&
                      clean.report.trianglesOut == clean.report.trianglesIn;
  MassMetric metric;
  Moments moments;
  if (closed && turnedAlike(raw, clean.mesh))
  {
    moments = momentsOf(raw, about_W, addSolid);
    metric.solid = moments.weight != 0.0;
  }
  if (!metric.solid)
  {
    moments = momentsOf(clean.mesh, about_W, addSheet);
  }
  const Vec3 centre = moments.first / moments.weight;
  metric.centre_W = about_W + centre;
  metric.gyration_u = gyrationOf(moments.second / moments.weight - centre.squaredNorm());
  return metric;
}

MassMetric metricAbout(const TriangleMesh& clean, const Vec3& handle_W)
{
  const Moments moments = momentsOf(clean, handle_W, addSheet);
  return { handle_W, gyrationOf(moments.second / moments.weight), false };
}

} // namespace palpate
