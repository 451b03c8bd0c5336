// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/mesh/TriangleMesh.h"

#include <algorithm>
#include <span>
#include <utility>

#include "haptics/core/InTwo.h"
#include "haptics/core/LargePages.h"
#include "haptics/geometry/mesh/Buckets.h"
#include "haptics/geometry/mesh/ExactPredicates.h"
#include "haptics/geometry/mesh/Weld.h"

namespace palpate
{
namespace
{

using Triangle = std::array<std::uint32_t, 3>;

void dropUnusedVertices(TriangleMesh& mesh, std::vector<std::uint32_t>& source)
{
  std::vector<std::uint32_t> place(mesh.vertices_W.size(), Weld::nowhere);
  for (const Triangle& t : mesh.triangles)
  {
    for (const std::uint32_t corner : t)
    {
      place[corner] = 0;
    }
  }
  if (std::ranges::find(place, Weld::nowhere) == place.end())
  {
    return;
  }
  std::uint32_t next = 0;
  for (std::uint32_t i = 0; i < place.size(); ++i)
  {
    if (place[i] != Weld::nowhere)
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

/// Edges of one triangle and of more than two.
struct EdgeCounts
{
  std::size_t boundary = 0, nonManifold = 0;
};

/// Of edges whose lower vertex is in `vertices`; `higher` has the other ends of all edges of each triangle.
EdgeCounts countEdges(Buckets<std::uint32_t>& higher, const Half& vertices)
{
  EdgeCounts counts;
  for (std::size_t v = vertices.first; v < vertices.last; ++v)
  {
    const auto begin = higher.entries.begin() + higher.start[v], end = higher.entries.begin() + higher.start[v + 1];
    std::sort(begin, end);
    for (auto run = begin; run != end;)
    {
      const auto stop = std::find_if(run, end, [w = *run](std::uint32_t other) { return other != w; });
      counts.boundary += (stop - run) == 1;
      counts.nonManifold += (stop - run) > 2;
      run = stop;
    }
  }
  return counts;
}

void countEdges(const TriangleMesh& mesh, unsigned threads, CleanReport& report)
{
  const auto edges = [&](std::size_t part, auto visit)
  {
    const Half half = halfOf(mesh.triangles.size(), part);
    for (std::size_t i = half.first; i < half.last; ++i)
    {
      const Triangle& t = mesh.triangles[i]; // corners ascend
      visit(t[0], t[1]);
      visit(t[0], t[2]);
      visit(t[1], t[2]);
    }
  };
  const std::size_t vertices = mesh.vertices_W.size();
  auto higher = makeBuckets<std::uint32_t>(vertices, threads, edges);
  std::array<EdgeCounts, 2> counts;
  inTwo(
    threads, [&] { counts[0] = countEdges(higher, halfOf(vertices, 0)); },
    [&] { counts[1] = countEdges(higher, halfOf(vertices, 1)); });
  report.boundaryEdges = counts[0].boundary + counts[1].boundary;
  report.nonManifoldEdges = counts[0].nonManifold + counts[1].nonManifold;
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

/// Re-indexed triangles with ascending corners, and how many were left out.
struct Sifted
{
  std::vector<Triangle> good;
  std::size_t nonFinite = 0, collinear = 0;
};

Sifted sift(std::span<const Triangle> raw, const Weld& welded, bool segments)
{
  Sifted sifted;
  reserveLarge(sifted.good, raw.size());
  for (const Triangle& corners : raw)
  {
    Triangle t = { welded.newIndex[corners[0]], welded.newIndex[corners[1]], welded.newIndex[corners[2]] };
    std::sort(t.begin(), t.end());
    if (t[2] == Weld::nowhere)
    {
      ++sifted.nonFinite;
    }
    else if (isNothing(t, welded, segments))
    {
      ++sifted.collinear;
    }
    else
    {
      sifted.good.push_back(segments ? Triangle{ t[0], t[2], t[2] } : t);
    }
  }
  return sifted;
}

/// Triangles in ascending order, each once.
std::vector<Triangle> inOrder(const std::array<Sifted, 2>& parts, std::size_t vertices, unsigned threads)
{
  const auto triangles = [&](std::size_t part, auto visit)
  {
    for (const Triangle& t : parts[part].good)
    {
      visit(t[0], t);
    }
  };
  Buckets<Triangle> buckets = makeBuckets<Triangle>(vertices, threads, triangles);
  const auto sortIn = [&](const Half& half)
  {
    for (std::size_t v = half.first; v < half.last; ++v)
    {
      std::sort(buckets.entries.begin() + buckets.start[v], buckets.entries.begin() + buckets.start[v + 1]);
    }
  };
  inTwo(
    threads, [&] { sortIn(halfOf(vertices, 0)); }, [&] { sortIn(halfOf(vertices, 1)); });
  buckets.entries.erase(std::unique(buckets.entries.begin(), buckets.entries.end()), buckets.entries.end());
  return std::move(buckets.entries);
}

std::vector<Triangle> goodTriangles(const TriangleMesh& raw, const Weld& welded, unsigned threads, CleanReport& report)
{
  std::array<Sifted, 2> parts;
  const auto siftPart = [&](std::size_t part)
  {
    const Half half = halfOf(raw.triangles.size(), part);
    parts[part] = sift(std::span(raw.triangles).subspan(half.first, half.last - half.first), welded, report.segments);
  };
  inTwo(
    threads, [&] { siftPart(0); }, [&] { siftPart(1); });
  report.nonFinite = parts[0].nonFinite + parts[1].nonFinite;
  report.collinear = parts[0].collinear + parts[1].collinear;
  std::vector<Triangle> good = inOrder(parts, welded.vertices_W.size(), threads);
  report.duplicate = parts[0].good.size() + parts[1].good.size() - good.size();
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

CleanResult clean(const TriangleMesh& raw, bool segments, unsigned threads)
{
  CleanResult result;
  result.report.trianglesIn = raw.triangles.size();
  result.report.segments = segments;
  result.refusal = indexRefusal(raw);
  if (!result.ok())
  {
    return result;
  }
  Weld welded = weld(raw.vertices_W, threads);
  result.mesh.triangles = goodTriangles(raw, welded, threads, result.report);
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

CleanResult cleanMesh(const TriangleMesh& raw, unsigned threads)
{
  CleanResult result = clean(raw, false, threads);
  if (result.ok())
  {
    countEdges(result.mesh, threads, result.report);
  }
  return result;
}

CleanResult cleanSegments(const TriangleMesh& raw, unsigned threads)
{
  const auto noSegment =
    std::find_if(raw.triangles.begin(), raw.triangles.end(), [](const Triangle& t) { return t[1] != t[2]; });
  if (noSegment != raw.triangles.end())
  {
    CleanResult result;
    result.refusal = "triangle " + std::to_string(noSegment - raw.triangles.begin()) + " is no segment of a curve";
    return result;
  }
  return clean(raw, true, threads);
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
