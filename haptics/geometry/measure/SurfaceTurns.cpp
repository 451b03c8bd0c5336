// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/measure/SurfaceTurns.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>

namespace palpate
{
namespace
{

/// For each vertex the first of those at its place.
std::vector<std::uint32_t> weld(const std::vector<Vec3>& vertices_W)
{
  std::vector<std::uint32_t> order(vertices_W.size()), first(vertices_W.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto place = [&](std::uint32_t v)
  { return std::tuple(vertices_W[v].x(), vertices_W[v].y(), vertices_W[v].z()); };
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return place(a) < place(b); });
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const bool again = i > 0 && place(order[i]) == place(order[i - 1]);
    first[order[i]] = again ? first[order[i - 1]] : order[i];
  }
  return first;
}

bool isUsable(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& t)
{
  return std::all_of(
    t.begin(), t.end(), [&](std::uint32_t v) { return v < mesh.vertices_W.size() && mesh.vertices_W[v].allFinite(); });
}

/// In order of edges, then of triangles. A vertex is the lower end of few sides, so they are dealt out to their lower
/// ends before they are compared.
std::vector<Side> byEdge(const std::vector<Side>& sides, std::size_t vertices)
{
  std::vector<std::size_t> end(vertices + 1, 0); // of the sides of a vertex, once they are dealt out
  for (const Side& side : sides)
  {
    ++end[side.low + 1];
  }
  std::partial_sum(end.begin(), end.end(), end.begin());
  std::vector<Side> dealt(sides.size());
  for (const Side& side : sides)
  {
    dealt[end[side.low]++] = side;
  }
  auto first = dealt.begin();
  for (std::size_t v = 0; v < vertices; ++v)
  {
    const auto last = dealt.begin() + static_cast<std::ptrdiff_t>(end[v]);
    std::sort(first, last,
      [](const Side& a, const Side& b) { return std::tie(a.high, a.triangle) < std::tie(b.high, b.triangle); });
    first = last;
  }
  return dealt;
}

} // namespace

std::vector<Side> sidesOf(const TriangleMesh& mesh)
{
  const std::vector<std::uint32_t> welded = weld(mesh.vertices_W);
  std::vector<Side> sides;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
  {
    if (!isUsable(mesh, mesh.triangles[t]))
    {
      continue;
    }
    const std::array<std::uint32_t, 3> v = { welded[mesh.triangles[t][0]], welded[mesh.triangles[t][1]],
      welded[mesh.triangles[t][2]] };
    if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0])
    {
      continue;
    }
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::uint32_t from = v[k], to = v[(k + 1) % 3];
      sides.push_back({ std::min(from, to), std::max(from, to), t, static_cast<std::uint8_t>(k), from < to });
    }
  }
  return byEdge(sides, mesh.vertices_W.size());
}

Turns::Turns(const TriangleMesh& mesh, const std::vector<Side>& sides) : part(mesh.triangles.size(), none)
{
  Beside beside(mesh.triangles.size());
  this->asFirst.resize(mesh.triangles.size());
  forEachEdge(sides,
    [&](auto first, auto last)
    {
      if (last - first == 2)
      {
        const bool agree = first->rising != (first + 1)->rising;
        beside[first->triangle].emplace_back((first + 1)->triangle, agree);
        beside[(first + 1)->triangle].emplace_back(first->triangle, agree);
      }
    });
  for (const Side& side : sides)
  {
    if (this->part[side.triangle] == none)
    {
      this->spread(side.triangle, beside);
    }
  }
}

void Turns::spread(std::uint32_t from, const Beside& beside)
{
  const auto number = static_cast<std::uint32_t>(this->members.size());
  std::vector<std::uint32_t>& found = this->members.emplace_back();
  this->part[from] = number;
  this->asFirst[from] = true;
  found.push_back(from);
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    for (const auto& [next, agree] : beside[found[i]])
    {
      if (this->part[next] == none)
      {
        this->part[next] = number;
        this->asFirst[next] = this->asFirst[found[i]] == agree;
        found.push_back(next);
      }
    }
  }
}

double sixVolumesOf(const TriangleMesh& mesh, const Turns& turns, std::uint32_t part)
{
  const Vec3 origin_W = mesh.vertices_W[mesh.triangles[turns.members[part].front()][0]];
  double sum = 0.0;
  for (const std::uint32_t t : turns.members[part])
  {
    const auto& [a, b, c] = mesh.triangles[t];
    const double volume =
      (mesh.vertices_W[a] - origin_W).cross(mesh.vertices_W[b] - origin_W).dot(mesh.vertices_W[c] - origin_W);
    sum += turns.asFirst[t] ? volume : -volume;
  }
  return sum;
}

} // namespace palpate
