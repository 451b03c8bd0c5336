// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tool/certify/TrianglePair.h"

#include <cmath>

#include "haptics/geometry/mesh/NearestOnTriangle.h"
#include "haptics/tool/mesh/BoxedMesh.h"

namespace palpate
{
namespace
{

/// The nearest points so far, and a normal of whatever holds them.
struct Search
{
  NearestPair best;
  double least2 = std::numeric_limits<double>::infinity();
  Vec3 holds = Vec3::Zero(); ///< a face's normal or that of two edges; zero: none

  void offer(const Vec3& onTool, const Vec3& onScene, const Vec3& normal)
  {
    const double d2 = (onTool - onScene).squaredNorm();
    if (d2 < this->least2)
    {
      this->least2 = d2;
      this->best.onTool_W = onTool;
      this->best.onScene_W = onScene;
      this->holds = normal;
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
    const Vec3 foot = nearestOnTriangle(p, scene[0], scene[1], scene[2]);
    search.offer(p, foot, onBorder(foot, scene) ? Vec3(Vec3::Zero()) : unitNormal(scene));
  }
  for (const Vec3& p : scene)
  {
    const Vec3 foot = nearestOnTriangle(p, tool[0], tool[1], tool[2]);
    search.offer(foot, p, onBorder(foot, tool) ? Vec3(Vec3::Zero()) : unitNormal(tool));
  }
}

void offerEdges(Search& search, const Corners& tool, const Corners& scene)
{
  for (int i = 0; i < 3; ++i)
  {
    const Vec3 u = tool[(i + 1) % 3] - tool[i];
    for (int j = 0; j < 3; ++j)
    {
      const Vec3 v = scene[(j + 1) % 3] - scene[j];
      double s = 0.0, t = 0.0;
      // With an end nearest, corner against triangle has found it.
      if (nearestOnLines(tool[i], u, scene[j], v, s, t) && s > 0.0 && s < 1.0 && t > 0.0 && t < 1.0)
      {
        search.offer(tool[i] + s * u, scene[j] + t * v, u.cross(v).normalized());
      }
    }
  }
}

} // namespace

bool nearestOnLines(const Vec3& a, const Vec3& u, const Vec3& b, const Vec3& v, double& onA, double& onB) noexcept
{
  constexpr double parallelBelow = 1e-16; // sine squared
  const double uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v);
  const double determinant = u.cross(v).squaredNorm();
  if (!(determinant > parallelBelow * uu * vv))
  {
    return false;
  }
  const Vec3 d = a - b;
  onA = (uv * v.dot(d) - vv * u.dot(d)) / determinant;
  onB = (uu * v.dot(d) - uv * u.dot(d)) / determinant;
  return true;
}

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
  const double side = search.holds.dot(between);
  if (side != 0.0)
  {
    const Vec3 n = side < 0.0 ? Vec3(-search.holds) : search.holds;
    best.n = gapAlong(n, tool_W, scene_W) >= gapAlong(best.n, tool_W, scene_W) ? n : best.n;
  }
  return best;
}

} // namespace palpate
