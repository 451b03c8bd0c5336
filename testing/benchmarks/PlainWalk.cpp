// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/benchmarks/PlainWalk.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace palpate::test
{
namespace
{

constexpr std::uint32_t leafSize = 4;
constexpr double miss = std::numeric_limits<double>::infinity();

Vec3 sumOf(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& t)
{
  return mesh.vertices_W[t[0]] + mesh.vertices_W[t[1]] + mesh.vertices_W[t[2]];
}

/// True if the part of the segment up to `most` meets the box.
bool meetsBox(const Vec3& low_W, const Vec3& high_W, const Vec3& from_W, const Vec3& inverse, double most)
{
  double enters = 0.0, leaves = most;
  for (int k = 0; k < 3; ++k)
  {
    const double a = (low_W[k] - from_W[k]) * inverse[k], b = (high_W[k] - from_W[k]) * inverse[k];
    enters = std::max(enters, std::min(a, b));
    leaves = std::min(leaves, std::max(a, b));
  }
  return enters <= leaves;
}

} // namespace

PlainWalk::PlainWalk(const TriangleMesh& mesh) : mesh_(mesh)
{
  this->nodes_.resize(1);
  this->split(0, 0, static_cast<std::uint32_t>(mesh.triangles.size()));
}

void PlainWalk::split(std::uint32_t node, std::uint32_t first, std::uint32_t count)
{
  const auto begin = this->mesh_.triangles.begin() + first, end = begin + count;
  Vec3 low = Vec3::Constant(miss), high = Vec3::Constant(-miss);
  std::for_each(begin, end,
    [&](const auto& t)
    {
      for (const std::uint32_t v : t)
      {
        low = low.cwiseMin(this->mesh_.vertices_W[v]);
        high = high.cwiseMax(this->mesh_.vertices_W[v]);
      }
    });
  if (count <= leafSize)
  {
    this->nodes_[node] = { low, high, first, count };
    return;
  }
  Vec3::Index axis = 0;
  (high - low).maxCoeff(&axis);
  const std::uint32_t half = count / 2;
  std::nth_element(begin, begin + half, end,
    [&](const auto& a, const auto& b) { return sumOf(this->mesh_, a)[axis] < sumOf(this->mesh_, b)[axis]; });
  const auto children = static_cast<std::uint32_t>(this->nodes_.size());
  this->nodes_[node] = { low, high, children, 0 };
  this->nodes_.resize(children + 2);
  this->split(children, first, half);
  this->split(children + 1, first + half, count - half);
}

/// Moller & Trumbore 1997.
double PlainWalk::hitTriangle(std::uint32_t triangle, const Vec3& from_W, const Vec3& way_W) const
{
  const auto& [a, b, c] = this->mesh_.triangles[triangle];
  const Vec3 &at = this->mesh_.vertices_W[a], e = this->mesh_.vertices_W[b] - at, f = this->mesh_.vertices_W[c] - at;
  const Vec3 p = way_W.cross(f), s = from_W - at, q = s.cross(e);
  const double inverse = 1.0 / e.dot(p), u = inverse * s.dot(p), v = inverse * way_W.dot(q), t = inverse * f.dot(q);
  return u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t >= 0.0 ? t : miss;
}

double PlainWalk::firstHit(const Vec3& from_W, const Vec3& to_W) const
{
  const Vec3 way_W = to_W - from_W, inverse = way_W.cwiseInverse();
  double best = 1.0;
  bool met = false;
  std::array<std::uint32_t, 128> stack;
  std::size_t top = 0;
  stack[top++] = 0;
  while (top > 0)
  {
    const Node& node = this->nodes_[stack[--top]];
    if (!meetsBox(node.low_W, node.high_W, from_W, inverse, best))
    {
      continue;
    }
    if (node.count == 0)
    {
      stack[top++] = node.first + 1;
      stack[top++] = node.first;
      continue;
    }
    for (std::uint32_t t = node.first; t < node.first + node.count; ++t)
    {
      const double hit = this->hitTriangle(t, from_W, way_W);
      met = met || hit <= best;
      best = std::min(best, hit);
    }
  }
  return met ? best : miss;
}

} // namespace palpate::test
