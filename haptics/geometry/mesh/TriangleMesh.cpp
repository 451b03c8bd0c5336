// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/mesh/TriangleMesh.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "haptics/geometry/mesh/ExactPredicates.h"

namespace palpate
{
namespace
{

using Triangle = std::array<std::uint32_t, 3>;
constexpr std::uint32_t unused = 0xffffffffu;

bool finite(const Vec3& v)
{
  return std::isfinite(v.x()) && std::isfinite(v.y()) && std::isfinite(v.z());
}

bool lexicographic(const Vec3& a, const Vec3& b)
{
  return a.x() != b.x() ? a.x() < b.x() : (a.y() != b.y() ? a.y() < b.y() : a.z() < b.z());
}

/// Finite vertices in lexicographic order without repeats, and where each raw vertex went.
struct Weld
{
  std::vector<Vec3> vertices_W;
  std::vector<std::uint32_t> newIndex;
  std::vector<std::uint32_t> source; ///< the first raw vertex of each
};

Weld weld(const std::vector<Vec3>& raw)
{
  struct Keyed
  {
    Vec3 v;
    std::uint32_t index;
  };
  std::vector<Keyed> order;
  order.reserve(raw.size());
  for (std::uint32_t i = 0; i < raw.size(); ++i)
  {
    if (finite(raw[i]))
    {
      order.push_back({ raw[i] + Vec3::Zero(), i }); // + 0.0: one zero, not two
    }
  }
  std::sort(order.begin(), order.end(), [](const Keyed& a, const Keyed& b) { return lexicographic(a.v, b.v); });
  Weld result;
  result.newIndex.assign(raw.size(), unused);
  for (const Keyed& keyed : order)
  {
    if (result.vertices_W.empty() || lexicographic(result.vertices_W.back(), keyed.v))
    {
      result.vertices_W.push_back(keyed.v);
      result.source.push_back(keyed.index);
    }
    result.source.back() = std::min(result.source.back(), keyed.index);
    result.newIndex[keyed.index] = static_cast<std::uint32_t>(result.vertices_W.size() - 1);
  }
  return result;
}

void dropUnusedVertices(TriangleMesh& mesh, std::vector<std::uint32_t>& source)
{
  std::vector<std::uint32_t> place(mesh.vertices_W.size(), unused);
  for (const Triangle& t : mesh.triangles)
  {
    for (const std::uint32_t corner : t)
    {
      place[corner] = 0;
    }
  }
  std::uint32_t next = 0;
  for (std::uint32_t i = 0; i < place.size(); ++i)
  {
    if (place[i] != unused)
    {
      place[i] = next;
      source[next] = source[i];
      mesh.vertices_W[next++] = mesh.vertices_W[i];
    }
  }
  mesh.vertices_W.resize(next);
  source.resize(next);
  for (Triangle& t : mesh.triangles)
  {
    t = { place[t[0]], place[t[1]], place[t[2]] };
  }
}

/// Counts edges with one and with more than two triangles. Edges are bucketed by their lower vertex.
void countEdges(const TriangleMesh& mesh, CleanReport& report)
{
  std::vector<std::uint32_t> start(mesh.vertices_W.size() + 1, 0);
  for (const Triangle& t : mesh.triangles)
  {
    start[t[0] + 1] += 2; // corners ascend: edges (0,1) and (0,2) start at t[0], edge (1,2) at t[1]
    start[t[1] + 1] += 1;
  }
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<std::uint32_t> higher(start.back());
  std::vector<std::uint32_t> fill(start.begin(), start.end() - 1);
  for (const Triangle& t : mesh.triangles)
  {
    higher[fill[t[0]]++] = t[1];
    higher[fill[t[0]]++] = t[2];
    higher[fill[t[1]]++] = t[2];
  }
  for (std::size_t v = 0; v + 1 < start.size(); ++v)
  {
    const auto begin = higher.begin() + start[v], end = higher.begin() + start[v + 1];
    std::sort(begin, end);
    for (auto run = begin; run != end;)
    {
      const auto stop = std::upper_bound(run, end, *run);
      report.boundaryEdges += (stop - run) == 1;
      report.nonManifoldEdges += (stop - run) > 2;
      run = stop;
    }
  }
}

std::string indexRefusal(const TriangleMesh& raw)
{
  for (std::size_t i = 0; i < raw.triangles.size(); ++i)
  {
    for (const std::uint32_t corner : raw.triangles[i])
    {
      if (corner >= raw.vertices_W.size())
      {
        return "triangle " + std::to_string(i) + " names vertex " + std::to_string(corner) + ", but there are only " +
               std::to_string(raw.vertices_W.size()) + " vertices";
      }
    }
  }
  return {};
}

/// A triangle without area; of curves, a segment without length. Corners ascend.
bool isNothing(const Triangle& t, const Weld& welded, bool segments)
{
  if (segments)
  {
    return t[0] == t[2];
  }
  return t[0] == t[1] || t[1] == t[2] ||
         exactlyCollinear(welded.vertices_W[t[0]], welded.vertices_W[t[1]], welded.vertices_W[t[2]]);
}

/// Re-indexed triangles with ascending corners; bad ones are counted and left out.
std::vector<Triangle> goodTriangles(const TriangleMesh& raw, const Weld& welded, CleanReport& report)
{
  std::vector<Triangle> good;
  good.reserve(raw.triangles.size());
  for (const Triangle& corners : raw.triangles)
  {
    Triangle t = { welded.newIndex[corners[0]], welded.newIndex[corners[1]], welded.newIndex[corners[2]] };
    std::sort(t.begin(), t.end());
    if (t[2] == unused)
    {
      ++report.nonFinite;
    }
    else if (isNothing(t, welded, report.segments))
    {
      ++report.collinear;
    }
    else
    {
      good.push_back(report.segments ? Triangle{ t[0], t[2], t[2] } : t);
    }
  }
  std::sort(good.begin(), good.end());
  const auto last = std::unique(good.begin(), good.end());
  report.duplicate = static_cast<std::size_t>(good.end() - last);
  good.erase(last, good.end());
  return good;
}

} // namespace

std::string CleanReport::summary() const
{
  std::string text = "kept " + std::to_string(this->trianglesOut) + " of " + std::to_string(this->trianglesIn) +
                     (this->segments ? " segments" : " triangles");
  const auto add = [&text](std::size_t count, const char* what)
  {
    if (count > 0)
    {
      text += "; " + std::to_string(count) + " " + what;
    }
  };
  add(this->nonFinite, this->segments ? "dropped: non-finite end" : "dropped: non-finite corner");
  add(this->collinear, this->segments ? "dropped: no length" : "dropped: no area");
  add(this->duplicate, "dropped: duplicate");
  add(this->boundaryEdges, "boundary edges");
  add(this->nonManifoldEdges, "non-manifold edges");
  return text;
}

namespace
{

std::string emptyRefusal(const TriangleMesh& raw, bool segments)
{
  if (raw.triangles.empty())
  {
    return segments ? "it has no lines" : "it has no triangles";
  }
  return "none of its " + std::to_string(raw.triangles.size()) +
         (segments ? " segments can be touched (all non-finite or without length)"
                   : " triangles can be touched (all non-finite or without area)");
}

CleanResult clean(const TriangleMesh& raw, bool segments)
{
  CleanResult result;
  result.report.trianglesIn = raw.triangles.size();
  result.report.segments = segments;
  result.refusal = indexRefusal(raw);
  if (!result.ok())
  {
    return result;
  }
  Weld welded = weld(raw.vertices_W);
  result.mesh.triangles = goodTriangles(raw, welded, result.report);
  result.mesh.vertices_W = std::move(welded.vertices_W);
  result.sourceVertex = std::move(welded.source);
  dropUnusedVertices(result.mesh, result.sourceVertex);
  result.report.trianglesOut = result.mesh.triangles.size();
  result.report.verticesOut = result.mesh.vertices_W.size();
  if (result.mesh.triangles.empty())
  {
    result.refusal = emptyRefusal(raw, segments);
  }
  return result;
}

} // namespace

CleanResult cleanMesh(const TriangleMesh& raw)
{
  CleanResult result = clean(raw, false);
  if (result.ok())
  {
    countEdges(result.mesh, result.report);
  }
  return result;
}

CleanResult cleanSegments(const TriangleMesh& raw)
{
  const auto noSegment =
    std::find_if(raw.triangles.begin(), raw.triangles.end(), [](const Triangle& t) { return t[1] != t[2]; });
  if (noSegment != raw.triangles.end())
  {
    CleanResult result;
    result.refusal = "triangle " + std::to_string(noSegment - raw.triangles.begin()) + " is no segment of a curve";
    return result;
  }
  return clean(raw, true);
}

namespace
{

bool isClean(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& t, bool segments)
{
  if (std::max({ t[0], t[1], t[2] }) >= mesh.vertices_W.size() || t[0] >= t[1] ||
      (segments ? t[1] != t[2] : t[1] >= t[2]))
  {
    return false;
  }
  const Vec3 &a = mesh.vertices_W[t[0]], &b = mesh.vertices_W[t[1]], &c = mesh.vertices_W[t[2]];
  return a.allFinite() && b.allFinite() && c.allFinite() && (segments ? a != b : !exactlyCollinear(a, b, c));
}

} // namespace

void append(TriangleMesh& mesh, const TriangleMesh& more)
{
  const auto offset = static_cast<std::uint32_t>(mesh.vertices_W.size());
  mesh.vertices_W.insert(mesh.vertices_W.end(), more.vertices_W.begin(), more.vertices_W.end());
  for (const auto& [a, b, c] : more.triangles)
  {
    mesh.triangles.push_back({ a + offset, b + offset, c + offset });
  }
}

std::string refuseUnclean(const TriangleMesh& mesh, bool segments)
{
  if (mesh.triangles.empty())
  {
    return "it has no triangles";
  }
  const auto bad = std::find_if(mesh.triangles.begin(), mesh.triangles.end(),
    [&](const std::array<std::uint32_t, 3>& t) { return !isClean(mesh, t, segments); });
  return bad == mesh.triangles.end()
           ? ""
           : "triangle " + std::to_string(bad - mesh.triangles.begin()) + " is invalid after cleaning";
}

} // namespace palpate
