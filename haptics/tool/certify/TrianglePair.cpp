// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tool/certify/TrianglePair.h"

#include <cmath>
#include <cstdint>
#include <limits>

#include "haptics/geometry/mesh/NearestOnLines.h"
#include "haptics/geometry/mesh/NearestOnTriangle.h"
#include "haptics/tool/mesh/BoxedMesh.h"

namespace palpate
{
namespace
{

/// The features of the nearest points: the normal of a face or two edges is more accurate than the points themselves.
enum class Holder : std::uint8_t
{
  SceneFace,
  ToolFace,
  Edges,
};

/// The nearest points so far.
struct Search
{
  NearestPair best;
  double least2 = std::numeric_limits<double>::infinity();
  Holder holder = Holder::SceneFace;
  Vec3 acrossEdges = Vec3::Zero();

  void offer(const Vec3& onTool, const Vec3& onScene, Holder by)
  {
    const double d2 = (onTool - onScene).squaredNorm();
    if (d2 < this->least2)
    {
      this->least2 = d2;
      this->best.onTool_W = onTool;
      this->best.onScene_W = onScene;
      this->holder = by;
    }
  }
};

bool onBorder(const Vec3& p, const Corners& t)
{
  for (int k = 0; k < 3; ++k)
  {
    const Vec3 side = t[(k + 1) % 3] - t[k];
    if ((p - t[k]).cross(side).squaredNorm() <= 1e-20 * side.squaredNorm() * side.squaredNorm())
    {
      return true;
    }
  }
  return false;
}

void offerCorners(Search& search, const Corners& tool, const Corners& scene)
{
  for (const Vec3& p : tool)
  {
    search.offer(p, nearestOnTriangle(p, scene[0], scene[1], scene[2]), Holder::SceneFace);
  }
  for (const Vec3& p : scene)
  {
    search.offer(nearestOnTriangle(p, tool[0], tool[1], tool[2]), p, Holder::ToolFace);
  }
}

void offerEdges(Search& search, const Corners& tool, const Corners& scene)
{
  for (int i = 0; i < 3; ++i)
  {
    const Vec3 u = tool[(i + 1) % 3] - tool[i];
    for (int j = 0; j < 3; ++j)
    {
      const Vec3 v = scene[(j + 1) % 3] - scene[j], n = u.cross(v);
      const double height = n.dot(tool[i] - scene[j]);
      double s = 0.0, t = 0.0;
      // Lines that are further apart than the best distance cannot lower it. Where an end is nearest, corner against
      // triangle has found the pair.
      if (height * height < search.least2 * n.squaredNorm() && nearestOnLines(tool[i], u, scene[j], v, s, t) &&
          s > 0.0 && s < 1.0 && t > 0.0 && t < 1.0)
      {
        const double before = search.least2;
        search.offer(tool[i] + s * u, scene[j] + t * v, Holder::Edges);
        search.acrossEdges = search.least2 < before ? n : search.acrossEdges;
      }
    }
  }
}

/// Unit normal; zero where a corner or the inside of an edge alone has the nearest point.
Vec3 normalOf(const Search& search, const Corners& tool, const Corners& scene)
{
  switch (search.holder)
  {
    case Holder::SceneFace:
      return onBorder(search.best.onScene_W, scene) ? Vec3(Vec3::Zero()) : unitNormal(scene);
    case Holder::ToolFace:
      return onBorder(search.best.onTool_W, tool) ? Vec3(Vec3::Zero()) : unitNormal(tool);
    case Holder::Edges:
      break;
  }
  return search.acrossEdges.normalized();
}

} // namespace

NearestPair nearestPair(const Corners& tool_W, const Corners& scene_W) noexcept
{
  Search search;
  offerCorners(search, tool_W, scene_W);
  offerEdges(search, tool_W, scene_W);
  NearestPair& best = search.best;
  const Vec3 between = best.onTool_W - best.onScene_W;
  best.distance_u = std::sqrt(search.least2);
  if (best.distance_u > 0.0)
  {
    best.n = between / best.distance_u;
  }
  const Vec3 holds = normalOf(search, tool_W, scene_W);
  const double side = holds.dot(between);
  if (side != 0.0)
  {
    const Vec3 n = side < 0.0 ? Vec3(-holds) : holds;
    best.n = gapAlong(n, tool_W, scene_W) >= gapAlong(best.n, tool_W, scene_W) ? n : best.n;
  }
  return best;
}

} // namespace palpate
