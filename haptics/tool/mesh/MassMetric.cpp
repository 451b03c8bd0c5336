// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tool/mesh/MassMetric.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "haptics/geometry/measure/MassMoments.h"

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

/// Inertia about the axes is the trace less each second moment: their mean is two thirds of the trace.
double gyrationOf(double meanSquare)
{
  return std::sqrt(std::max(0.0, 2.0 / 3.0 * meanSquare));
}

} // namespace

MassMetric massMetric(const TriangleMesh& raw, const CleanResult& clean)
{
  const Vec3 about_W = clean.mesh.vertices_W.front();
  const bool closed = clean.report.boundaryEdges == 0 && clean.report.nonManifoldEdges == 0 &&
                      clean.report.trianglesOut == clean.report.trianglesIn;
  MassMetric metric;
  MassMoments<double> moments;
  if (closed && turnedAlike(raw, clean.mesh))
  {
    moments = momentsOf<double>(raw, about_W, addSolid);
    metric.solid = moments.weight != 0.0;
  }
  if (!metric.solid)
  {
    moments = momentsOf<double>(clean.mesh, about_W, addSheet);
  }
  const Vec3 centre = moments.first / moments.weight;
  metric.centre_W = about_W + centre;
  metric.gyration_u = gyrationOf(moments.second / moments.weight - centre.squaredNorm());
  return metric;
}

MassMetric metricAbout(const TriangleMesh& clean, const Vec3& handle_W)
{
  const MassMoments<double> moments = momentsOf<double>(clean, handle_W, addSheet);
  return { handle_W, gyrationOf(moments.second / moments.weight), false };
}

} // namespace palpate
