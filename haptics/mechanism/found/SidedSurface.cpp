// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/mechanism/found/SidedSurface.h"

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
  for (const Vec3& p : data.mesh.vertices_W)
  {
    made->radius_u = std::max(made->radius_u, p.norm());
  }
  made->diagonal_u = (data.high_W - data.low_W).norm();
  made->tree = std::move(tree);
  return made;
}

Outcome<std::shared_ptr<const SidedSurface>> makeRigidMesh(const TriangleMesh& raw)
{
  if (raw.triangles.size() > SidedSurface::mostTriangles)
  {
    return { nullptr, "the mesh has " + std::to_string(raw.triangles.size()) + " triangles, a rigid body's may have " +
                        std::to_string(SidedSurface::mostTriangles) };
  }
  CleanResult clean = cleanMesh(raw);
  if (!clean.ok())
  {
    return { nullptr, "the mesh cannot be used: " + clean.refusal };
  }
  if (clean.report.boundaryEdges > 0)
  {
    return { nullptr, "the mesh is open: " + std::to_string(clean.report.boundaryEdges) +
                        " of its edges have one triangle, and a rigid body needs an inside" };
  }
  if (clean.report.nonManifoldEdges > 0)
  {
    return { nullptr, "the mesh has " + std::to_string(clean.report.nonManifoldEdges) +
                        " edges of more than two triangles, so that its inside is not clear" };
  }
  return { makeSided(std::make_shared<const SurfaceTree>(std::move(clean.mesh))), "" };
}

} // namespace palpate
