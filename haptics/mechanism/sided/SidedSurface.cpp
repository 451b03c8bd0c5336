// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/mechanism/sided/SidedSurface.h"

#include <algorithm>
#include <utility>

#include "haptics/geometry/tree/SurfaceData.h"

namespace palpate
{
namespace
{

/// The triangles that are joined with one over edges of two, all given its side.
std::vector<std::uint32_t> spreadSide(const SurfaceData& data, std::uint32_t first, std::vector<double>& side)
{
  std::vector<std::uint32_t> piece{ first };
  side[first] = 1.0;
  for (std::size_t next = 0; next < piece.size(); ++next)
  {
    const std::uint32_t t = piece[next];
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::uint32_t other = data.across[t][k];
      if (other == SurfaceData::none || side[other] != 0.0)
      {
        continue;
      }
      const std::uint32_t i = data.corners(t)[k], j = data.corners(t)[(k + 1) % 3];
      const bool alike = runsAlong(data.corners(t), i, j) != runsAlong(data.corners(other), i, j);
      side[other] = alike ? side[t] : -side[t];
      piece.push_back(other);
    }
  }
  return piece;
}

/// Six times the volume that a piece encloses, about its first corner.
double volumeOf(const SurfaceData& data, const std::vector<std::uint32_t>& piece, const std::vector<double>& side)
{
  const Vec3 from = data.cornersOf(piece.front())[0];
  double volume = 0.0;
  for (const std::uint32_t t : piece)
  {
    const auto corner = data.cornersOf(t);
    volume += side[t] * (corner[0] - from).dot((corner[1] - from).cross(corner[2] - from));
  }
  return volume;
}

std::vector<SidedSurface::Edge> edgesOf(const SurfaceData& data)
{
  std::vector<SidedSurface::Edge> edges;
  for (std::uint32_t t = 0; t < data.mesh.triangles.size(); ++t)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::uint32_t other = data.across[t][k];
      if (other != SurfaceData::none && t < other)
      {
        edges.push_back({ { data.corners(t)[k], data.corners(t)[(k + 1) % 3] }, { t, other } });
      }
    }
  }
  return edges;
}

std::string tooMany(std::size_t triangles, std::size_t most)
{
  return "the mesh has " + std::to_string(triangles) + " triangles, a rigid body's may have " + std::to_string(most);
}

std::string refuseEdges(std::size_t open, std::size_t shared)
{
  return open > 0 ? "the mesh is open: " + std::to_string(open) +
                      " of its edges have one triangle, and a rigid body needs an inside"
         : shared > 0 ? "the mesh has " + std::to_string(shared) +
                          " edges of more than two triangles, so that its inside is not clear"
                      : "";
}

/// Of one triangle; of more than two.
std::pair<std::size_t, std::size_t> countEdges(const SurfaceData& data)
{
  std::size_t open = 0, shared = 0;
  for (std::uint32_t t = 0; t < data.mesh.triangles.size(); ++t)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      std::uint32_t around = 0, first = SurfaceData::none;
      const auto count = [&](std::uint32_t of)
      {
        first = std::min(first, of);
        ++around;
      };
      if (data.across[t][k] == SurfaceData::none)
      {
        data.forEachAtEdge(data.corners(t)[k], data.corners(t)[(k + 1) % 3], count);
        open += around == 1 ? 1 : 0;
        shared += around > 2 && first == t ? 1 : 0;
      }
    }
  }
  return { open, shared };
}

} // namespace

Vec3 SidedSurface::normalAt(std::uint32_t vertex, const std::vector<Vec3>& vertices) const
{
  Vec3 sum = Vec3::Zero();
  this->tree->data().forEachAround(vertex, [&](std::uint32_t t) { sum += this->areaOf(t, vertices); });
  return sum.normalized();
}

TriangleMesh SidedSurface::rightHanded() const
{
  TriangleMesh mesh = this->tree->mesh();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    if (this->side[t] < 0.0)
    {
      std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
    }
  }
  return mesh;
}

std::shared_ptr<const SidedSurface> makeSided(std::shared_ptr<const SurfaceTree> tree)
{
  auto made = std::make_shared<SidedSurface>();
  const SurfaceData& data = tree->data();
  made->tree = std::move(tree);
  made->side.assign(data.mesh.triangles.size(), 0.0);
  for (std::uint32_t t = 0; t < made->side.size(); ++t)
  {
    if (made->side[t] != 0.0)
    {
      continue;
    }
    const std::vector<std::uint32_t> piece = spreadSide(data, t, made->side);
    const double outer = volumeOf(data, piece, made->side) < 0.0 ? -1.0 : 1.0;
    std::ranges::for_each(piece, [&](std::uint32_t of) { made->side[of] *= outer; });
  }
  made->edges = edgesOf(data);
  for (std::uint32_t e = 0; e < made->edges.size(); ++e)
  {
    const auto& [one, other] = made->edges[e].triangles;
    const std::vector<Vec3>& vertices = data.mesh.vertices_W;
    if (made->areaOf(one, vertices).normalized().dot(made->areaOf(other, vertices).normalized()) <
        SidedSurface::sharpBelow)
    {
      made->sharp.push_back(e);
    }
  }
  for (const Vec3& p : data.mesh.vertices_W)
  {
    made->radius_u = std::max(made->radius_u, p.norm());
  }
  made->diagonal_u = (data.high_W - data.low_W).norm();
  return made;
}

Outcome<std::shared_ptr<const SidedSurface>> makeRigidMesh(const TriangleMesh& raw)
{
  if (raw.triangles.size() > SidedSurface::mostTriangles)
  {
    return { nullptr, tooMany(raw.triangles.size(), SidedSurface::mostTriangles) };
  }
  CleanResult clean = cleanMesh(raw);
  if (!clean.ok())
  {
    return { nullptr, "the mesh cannot be used: " + clean.refusal };
  }
  std::string refusal = refuseEdges(clean.report.boundaryEdges, clean.report.nonManifoldEdges);
  auto made = refusal.empty() ? makeSided(std::make_shared<const SurfaceTree>(std::move(clean.mesh))) : nullptr;
  return { std::move(made), std::move(refusal) };
}

Outcome<std::shared_ptr<const SidedSurface>> makeStandingMesh(std::shared_ptr<const SurfaceTree> tree)
{
  const SurfaceData& data = tree->data();
  if (data.coat_u > 0.0)
  {
    return { nullptr, "its lines have no inside, and a rigid body needs one" };
  }
  if (data.mesh.triangles.size() > SidedSurface::mostStanding)
  {
    return { nullptr, tooMany(data.mesh.triangles.size(), SidedSurface::mostStanding) };
  }
  const auto [open, shared] = countEdges(data);
  std::string refusal = refuseEdges(open, shared);
  return { refusal.empty() ? makeSided(std::move(tree)) : nullptr, std::move(refusal) };
}

} // namespace palpate
