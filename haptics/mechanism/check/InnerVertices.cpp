// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/mechanism/check/InnerVertices.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace palpate
{
namespace
{

/// A side of a triangle.
struct Side
{
  std::uint32_t low = 0, high = 0; ///< vertices
  std::uint32_t triangle = 0;
  bool rises = false; ///< from low to high
};

std::vector<Side> sidesOf(const TriangleMesh& mesh)
{
  std::vector<Side> sides;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      const std::uint32_t from = mesh.triangles[t][c], to = mesh.triangles[t][(c + 1) % 3];
      sides.push_back({ std::min(from, to), std::max(from, to), t, from < to });
    }
  }
  std::ranges::sort(sides, {}, [](const Side& s) { return std::tuple(s.low, s.high, s.triangle); });
  return sides;
}

/// Triangles that share an edge, and whether their corners run around the surface alike.
struct Neighbour
{
  std::uint32_t triangle = 0;
  bool alike = false;
};

std::vector<std::vector<Neighbour>> neighboursOf(const TriangleMesh& mesh)
{
  std::vector<std::vector<Neighbour>> neighbours(mesh.triangles.size());
  const std::vector<Side> sides = sidesOf(mesh);
  for (std::size_t i = 0; i + 1 < sides.size(); ++i)
  {
    const Side &one = sides[i], &other = sides[i + 1];
    if (one.low == other.low && one.high == other.high)
    {
      const bool alike = one.rises != other.rises;
      neighbours[one.triangle].push_back({ other.triangle, alike });
      neighbours[other.triangle].push_back({ one.triangle, alike });
    }
  }
  return neighbours;
}

/// For each triangle of a closed surface 1 where its normal points to the outer side, else -1. Clean meshes have their
/// corners in order of their numbers, so normals follow from the neighbours', and the sign from the volume enclosed.
std::vector<double> outwardSigns(const TriangleMesh& mesh)
{
  const std::vector<std::vector<Neighbour>> neighbours = neighboursOf(mesh);
  std::vector<double> signs(mesh.triangles.size(), 0.0);
  for (std::uint32_t seed = 0; seed < signs.size(); ++seed)
  {
    if (signs[seed] != 0.0)
    {
      continue;
    }
    signs[seed] = 1.0;
    std::vector<std::uint32_t> piece{ seed };
    double sixVolumes = 0.0;
    for (std::size_t i = 0; i < piece.size(); ++i)
    {
      const auto& [a, b, c] = mesh.triangles[piece[i]];
      const Vec3& origin_W = mesh.vertices_W[mesh.triangles[seed][0]];
      const Vec3 p = mesh.vertices_W[a] - origin_W, q = mesh.vertices_W[b] - origin_W,
                 r = mesh.vertices_W[c] - origin_W;
      sixVolumes += signs[piece[i]] * p.cross(q).dot(r);
      for (const Neighbour& next : neighbours[piece[i]])
      {
        if (signs[next.triangle] == 0.0)
        {
          signs[next.triangle] = next.alike ? signs[piece[i]] : -signs[piece[i]];
          piece.push_back(next.triangle);
        }
      }
    }
    for (const std::uint32_t t : piece)
    {
      signs[t] *= sixVolumes < 0.0 ? -1.0 : 1.0;
    }
  }
  return signs;
}

/// For each vertex of a closed surface a direction to the outer side of all of its triangles; zero where there is none.
std::vector<Vec3> directionsOutwards(const TriangleMesh& mesh)
{
  constexpr int mostRounds = 64;
  constexpr double leastShare = 0.05; // of its length along each normal
  const std::vector<double> signs = outwardSigns(mesh);
  std::vector<Vec3> out_W(mesh.vertices_W.size(), Vec3::Zero());
  std::vector<bool> wrong;
  for (int round = 0; round < mostRounds; ++round) // the perceptron's, which finds a direction if there is one
  {
    wrong.assign(out_W.size(), false);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    {
      const auto& triangle = mesh.triangles[t];
      const Vec3& a = mesh.vertices_W[triangle[0]];
      const Vec3 normal_W =
        signs[t] * (mesh.vertices_W[triangle[1]] - a).cross(mesh.vertices_W[triangle[2]] - a).normalized();
      for (const std::uint32_t v : triangle)
      {
        const bool behind = normal_W.dot(out_W[v]) <= leastShare * out_W[v].norm() && normal_W != Vec3::Zero();
        out_W[v] += behind ? normal_W : Vec3::Zero();
        wrong[v] = wrong[v] || behind;
      }
    }
    if (std::ranges::find(wrong, true) == wrong.end())
    {
      break;
    }
  }
  for (std::size_t v = 0; v < out_W.size(); ++v)
  {
    out_W[v] = wrong[v] ? Vec3::Zero() : out_W[v].normalized().eval();
  }
  return out_W;
}

} // namespace

std::vector<std::pair<std::uint32_t, std::uint32_t>> edgesOf(const TriangleMesh& mesh)
{
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const Side& side : sidesOf(mesh))
  {
    if (edges.empty() || edges.back() != std::pair(side.low, side.high))
    {
      edges.emplace_back(side.low, side.high);
    }
  }
  return edges;
}

std::vector<Vec3> verticesInside(const TriangleMesh& mesh, double share)
{
  std::vector<double> shortest_u(mesh.vertices_W.size(), std::numeric_limits<double>::infinity());
  for (const auto& triangle : mesh.triangles)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      const std::uint32_t a = triangle[c], b = triangle[(c + 1) % 3];
      const double length_u = (mesh.vertices_W[b] - mesh.vertices_W[a]).norm();
      shortest_u[a] = std::min(shortest_u[a], length_u);
      shortest_u[b] = std::min(shortest_u[b], length_u);
    }
  }
  std::vector<Vec3> inside_W = directionsOutwards(mesh);
  for (std::size_t v = 0; v < inside_W.size(); ++v)
  {
    const Vec3 out_W = std::isfinite(shortest_u[v]) ? Vec3(share * shortest_u[v] * inside_W[v]) : Vec3::Zero();
    inside_W[v] = mesh.vertices_W[v] - out_W;
  }
  return inside_W;
}

} // namespace palpate
