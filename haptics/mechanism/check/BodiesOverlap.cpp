// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/mechanism/check/BodiesOverlap.h"

#include <algorithm>
#include <cmath>

#include "haptics/geometry/measure/RayWalk.h"
#include "haptics/geometry/tree/SurfaceData.h"
#include "haptics/mechanism/check/MechanismFaults.h"

namespace palpate
{
namespace
{

/// Of an edge, of a box: by less they touch.
constexpr double touches = 1e-6;

struct Edge
{
  Vec3 from_W;
  Vec3 to_W;
};

/// A little inside of the box, so that edges of boxes that stand in line with each other are not on their faces.
Vec3 cornerOf(const MechanismBody& box, int corner)
{
  const Vec3 signs(corner & 1 ? 1.0 : -1.0, corner & 2 ? 1.0 : -1.0, corner & 4 ? 1.0 : -1.0);
  const Vec3 half_u = (1.0 - 2.0 * touches) * box.halfSize_u;
  return box.pose_W.p + box.pose_W.q.normalized() * half_u.cwiseProduct(signs);
}

std::vector<Edge> edgesOf(const MechanismBody& box)
{
  std::vector<Edge> edges;
  for (int corner = 0; corner < 8; ++corner)
  {
    for (const int along : { 1, 2, 4 })
    {
      if ((corner & along) == 0)
      {
        edges.push_back({ cornerOf(box, corner), cornerOf(box, corner | along) });
      }
    }
  }
  return edges;
}

const SurfaceTree& surfaceOf(const PressedBody& body)
{
  return *body.scene->surfaces()[body.touch.surface].tree;
}

std::vector<Edge> edgesOf(const PressedBody& body)
{
  const TriangleMesh& mesh = surfaceOf(body).mesh();
  std::vector<Edge> edges;
  for (const auto& triangle : mesh.triangles)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      edges.push_back({ mesh.vertices_W[triangle[c]], mesh.vertices_W[triangle[(c + 1) % 3]] });
    }
  }
  return edges;
}

/// Whether a part of the edge lies in the box (of its three slabs).
bool passes(const MechanismBody& box, const Edge& edge)
{
  const Quat back = box.pose_W.q.normalized().conjugate();
  const Vec3 from = back * (edge.from_W - box.pose_W.p);
  const Vec3 way = back * (edge.to_W - edge.from_W);
  double first = 0.0, last = 1.0;
  for (int k = 0; k < 3; ++k)
  {
    const double half = (1.0 - touches) * box.halfSize_u[k];
    if (way[k] == 0.0)
    {
      last = std::abs(from[k]) < half ? last : -1.0;
      continue;
    }
    const double a = (-half - from[k]) / way[k], b = (half - from[k]) / way[k];
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  return first < last;
}

/// Whether the edge passes through the surface, and not only ends there.
bool passes(const PressedBody& body, const Edge& edge)
{
  const Vec3 way_W = edge.to_W - edge.from_W;
  const double length_u = way_W.norm();
  if (!(length_u > 0.0))
  {
    return false;
  }
  const auto hit = firstHit(surfaceOf(body), edge.from_W, way_W / length_u, touches * length_u);
  return hit && hit->way_u < (1.0 - touches) * length_u;
}

bool isIn(const PressedBody& body, const Vec3& p_W)
{
  return isClosed(surfaceOf(body)) && sideOf(surfaceOf(body), p_W) == PointSide::Inside;
}
bool isIn(const MechanismBody& box, const Vec3& p_W)
{
  return passes(box, { p_W, p_W });
}

Vec3 insideOf(const MechanismBody& box)
{
  return box.pose_W.p;
}
/// A point of its surface: what has no edge in another lies in that whole, or not at all.
Vec3 insideOf(const PressedBody& body)
{
  return surfaceOf(body).mesh().vertices_W.front();
}

template<class A, class B>
bool overlap(const A& a, const B& b)
{
  const auto through = [](const auto& edges, const auto& other)
  { return std::ranges::any_of(edges, [&other](const Edge& edge) { return passes(other, edge); }); };
  return through(edgesOf(a), b) || through(edgesOf(b), a) || isIn(a, insideOf(b)) || isIn(b, insideOf(a));
}

} // namespace

std::vector<std::pair<std::string, std::string>> overlapsOf(
  const Mechanism& mechanism, std::span<const MechanismSoft> soft)
{
  std::vector<std::pair<std::string, std::string>> pairs;
  const auto visit = [&soft](const MechanismBody& body, const auto& with)
  {
    const MechanismSoft* named = softNamed(soft, body.name);
    return body.kind == MechanismBodyKind::Rigid                          ? with(body)
           : body.kind == MechanismBodyKind::Soft && named && named->body ? with(*named->body)
                                                                          : false;
  };
  for (std::size_t i = 0; i < mechanism.bodies.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      const MechanismBody& a = mechanism.bodies[j];
      const MechanismBody& b = mechanism.bodies[i];
      if (visit(
            a, [&](const auto& first) { return visit(b, [&](const auto& other) { return overlap(first, other); }); }))
      {
        pairs.emplace_back(a.name, b.name);
      }
    }
  }
  return pairs;
}

} // namespace palpate
