// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/mechanism/check/InnerVertices.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "haptics/geometry/measure/SurfaceTurns.h"

namespace palpate
{
namespace
{

/// For each triangle of a closed surface 1 where its normal points to the outer side, else -1. Clean meshes have their
/// corners in order of their numbers, so normals follow from the neighbours', and the sign from the volume enclosed.
std::vector<double> outwardSigns(const TriangleMesh& mesh)
{
  const Turns turns(mesh, sidesOf(mesh));
  std::vector<double> signs(mesh.triangles.size(), 1.0);
  for (std::uint32_t part = 0; part < turns.members.size(); ++part)
  {
    const bool firstOutward = sixVolumesOf(mesh, turns, part) >= 0.0;
    for (const std::uint32_t t : turns.members[part])
    {
      signs[t] = turns.asFirst[t] == firstOutward ? 1.0 : -1.0;
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
