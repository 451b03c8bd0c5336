// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/contact/Seat.h"

#include <algorithm>
#include <array>

#include "haptics/contact/Projection.h"
#include "haptics/contact/Sweep.h"
#include "haptics/geometry/SurfaceData.h"

namespace palpate
{
namespace
{

constexpr int rounds = 32;
constexpr int mostRows = 32;

/// Nearest point of a closed triangle (regions of its corners, edges and inside in turn).
Vec3 nearestOnTriangle(const Vec3& x, const Vec3& a, const Vec3& b, const Vec3& c) noexcept
{
  const Vec3 ab = b - a, ac = c - a;
  const double d1 = ab.dot(x - a), d2 = ac.dot(x - a);
  const double d3 = ab.dot(x - b), d4 = ac.dot(x - b);
  const double d5 = ab.dot(x - c), d6 = ac.dot(x - c);
  const double va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2;
  if (d1 <= 0 && d2 <= 0)
  {
    return a;
  }
  if (d3 >= 0 && d4 <= d3)
  {
    return b;
  }
  if (d6 >= 0 && d5 <= d6)
  {
    return c;
  }
  if (vc <= 0 && d1 >= 0 && d3 <= 0)
  {
    return a + d1 / (d1 - d3) * ab;
  }
  if (vb <= 0 && d2 >= 0 && d6 <= 0)
  {
    return a + d2 / (d2 - d6) * ac;
  }
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
  {
    return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
  }
  const double sum = va + vb + vc;
  return a + vb / sum * ab + vc / sum * ac;
}

/// Calls visit(data, triangle) for each triangle of a leaf whose box comes within reach of x.
template<class Visit>
void forEachNear(const Scene& scene, const Vec3& x_W, double reach, Visit visit) noexcept
{
  for (const Surface& surface : scene.surfaces())
  {
    const SurfaceData& data = surface.tree->data();
    std::array<std::uint32_t, 96> stack;
    int top = 0;
    stack[top++] = data.nodes.empty() ? TreeNode::leafBit : 0u;
    while (top > 0)
    {
      const std::uint32_t child = stack[--top];
      if (child & TreeNode::leafBit)
      {
        const Leaf& leaf = data.leaves[child & ~TreeNode::leafBit];
        for (std::uint32_t t = leaf.first; t < leaf.first + leaf.count; ++t)
        {
          visit(data, t);
        }
        continue;
      }
      const TreeNode& node = data.nodes[child];
      for (int k = 0; k < 2; ++k)
      {
        bool apart = false;
        for (int axis = 0; axis < 3; ++axis)
        {
          apart |= node.low_W[axis][k] > x_W[axis] + reach || node.high_W[axis][k] < x_W[axis] - reach;
        }
        if (!apart)
        {
          stack[top++] = node.child[k];
        }
      }
    }
  }
}

/// The deepest overlaps of the ball at x, as rows that push it out.
struct Overlaps
{
  std::array<PlaneRow, mostRows> rows;
  int count = 0;

  void add(const PlaneRow& row) noexcept
  {
    for (int i = 0; i < this->count; ++i)
    {
      if (this->rows[i].n.dot(row.n) > 1.0 - 1e-12)
      {
        this->rows[i].bound = std::max(this->rows[i].bound, row.bound);
        return;
      }
    }
    if (this->count < mostRows)
    {
      this->rows[this->count++] = row;
      return;
    }
    const auto shallowest = std::min_element(this->rows.begin(), this->rows.end(),
      [](const PlaneRow& a, const PlaneRow& b) { return a.bound < b.bound; });
    if (shallowest->bound < row.bound)
    {
      *shallowest = row;
    }
  }
};

bool seatRound(const Scene& scene, double r, const Vec3& p_W, Vec3& x_W) noexcept
{
  Resolution resolution;
  resolution.include(p_W);
  resolution.include(Vec3::Constant(r));
  const double tol = resolution.tol();
  Vec3 x = p_W;
  for (int round = 0; round < rounds; ++round)
  {
    Overlaps overlaps;
    forEachNear(scene, x, r,
      [&](const SurfaceData& data, std::uint32_t t)
      {
        const auto& [a, b, c] = data.faces[t].corner_W;
        const Vec3 away = x - nearestOnTriangle(x, a, b, c);
        const double distance = away.norm();
        if (distance < r - tol)
        {
          overlaps.add({ distance > tol ? Vec3(away / distance) : data.faces[t].normal_W, r - distance });
        }
      });
    if (overlaps.count == 0)
    {
      x_W = x;
      return true;
    }
    const ProjectionResult out =
      projectOntoPlanes({ overlaps.rows.data(), static_cast<std::size_t>(overlaps.count) }, Vec3::Zero(), tol);
    x += out.y;
    if (!out.feasible || (x - p_W).norm() > r + tol)
    {
      return false;
    }
  }
  return false;
}

/// A step of zero length hits exactly the triangles that hold the point.
bool offEveryTriangle(const Scene& scene, const Vec3& x_W, SweepHit& hit) noexcept
{
  SweepQuery query;
  query.from_W = query.to_W = x_W;
  query.resolution.include(x_W);
  hit = sweepBall(scene, query, 1u << 20);
  return !hit.hit && hit.freeUntil >= 1.0;
}

bool seatPoint(const Scene& scene, const Vec3& p_W, Vec3& x_W) noexcept
{
  SweepHit hit;
  if (offEveryTriangle(scene, p_W, hit))
  {
    x_W = p_W;
    return true;
  }
  Resolution resolution;
  resolution.include(p_W);
  const Vec3 n = scene.surfaces()[hit.feature.surface].tree->data().faces[hit.feature.a].normal_W;
  for (double lift = resolution.del(); lift < 1e6 * resolution.tol(); lift *= 2)
  {
    for (const double side : { 1.0, -1.0 })
    {
      const Vec3 x = p_W + side * lift * n;
      SweepHit ignored;
      if (offEveryTriangle(scene, x, ignored))
      {
        x_W = x;
        return true;
      }
    }
  }
  return false;
}

} // namespace

bool seatBall(const Scene& scene, double radius_u, const Vec3& p_W, Vec3& x_W) noexcept
{
  return radius_u > 0.0 ? seatRound(scene, radius_u, p_W, x_W) : seatPoint(scene, p_W, x_W);
}

} // namespace palpate
