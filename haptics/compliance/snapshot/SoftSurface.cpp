// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/compliance/snapshot/SoftSurface.h"

#include <algorithm>
#include <iterator>
#include <ranges>
#include <set>

#include "haptics/geometry/mesh/TriangleMesh.h"

namespace palpate
{
namespace
{

/// E / (1 - nu^2) of the stiffest point at each node: points around one node hardly differ.
std::vector<double> planeModulusOfNodes(const StrainPoints& points)
{
  std::vector<double> modulus(points.rest_W.size(), 0.0);
  for (const StrainPoint& p : points.points)
  {
    const auto& [mu, lambda] = p.moduli;
    for (const std::uint32_t node : points.nodesOf(p))
    {
      modulus[node] = std::max(modulus[node], 4.0 * mu * (lambda + mu) / (lambda + 2.0 * mu));
    }
  }
  return modulus;
}

double poissonOf(const StrainPoints& points)
{
  const auto& [mu, lambda] = points.points.front().moduli;
  return 0.5 * lambda / (lambda + mu);
}

void numberBorder(SoftSurface& surface, const SoftBody& body, const TetraMesh& mesh)
{
  CleanResult clean = cleanMesh({ body.points().rest_W, borderOf(mesh) });
  surface.vertices = std::move(clean.sourceVertex);
  surface.rest_W = std::move(clean.mesh.vertices_W);
  surface.triangles = std::move(clean.mesh.triangles);
}

void findNeighbours(SoftSurface& surface)
{
  std::vector<std::set<std::uint32_t>> sets(surface.vertices.size());
  for (const auto& t : surface.triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      sets[t[i]].insert({ t[(i + 1) % 3], t[(i + 2) % 3] });
    }
  }
  for (const auto& set : sets)
  {
    surface.neighbours.emplace_back(set.begin(), set.end());
  }
}

} // namespace

std::vector<Vec3> SoftSurface::placesOf(const Eigen::VectorXd& atRest, const Eigen::VectorXd& pressed) const
{
  const Eigen::VectorXd further = pressed - atRest;
  std::vector<Vec3> places = this->rest_W;
  for (std::size_t v = 0; v < places.size(); ++v)
  {
    places[v] += atRest.segment<3>(3 * static_cast<Eigen::Index>(this->vertices[v]));
    places[v] += this->map.displacementOf(v, further);
  }
  return places;
}

std::vector<std::uint32_t> borderNodesFrom(const SoftSurface& surface, const Vec3& place_W)
{
  const BorderFaces& border = *surface.border;
  std::vector<std::pair<double, std::uint32_t>> found;
  for (const auto* faces : { &border.faces(), &border.halves() })
  {
    for (const std::uint32_t node : *faces | std::views::join)
    {
      found.emplace_back((border.place(node) - place_W).squaredNorm(), node);
    }
  }
  std::ranges::sort(found);
  const auto twice = std::ranges::unique(found);
  found.erase(twice.begin(), twice.end());
  std::vector<std::uint32_t> nodes;
  std::ranges::transform(found, std::back_inserter(nodes), [](const auto& at) { return at.second; });
  return nodes;
}

SoftSurface makeSoftSurface(const SoftBody& body, const TetraMesh& mesh, double edges)
{
  SoftSurface surface;
  numberBorder(surface, body, mesh);
  findNeighbours(surface);
  const std::vector<double> modulus = planeModulusOfNodes(body.points());
  StrainPoints bare;
  bare.rest_W = mesh.vertices_W;
  const BorderFaces corners(bare, borderOf(mesh));
  surface.border = std::make_shared<const BorderFaces>(body.points(), borderOf(mesh));
  const BorderFaces& border = *surface.border;
  surface.poisson = poissonOf(body.points());
  for (const std::uint32_t node : surface.vertices)
  {
    surface.edge_u.push_back(corners.edgeLengthAt(node));
    surface.patch_u.push_back(edges * surface.edge_u.back());
    surface.stiffness.push_back(modulus[node]);
    surface.map.add(patchAt(border, body.points().rest_W[node], border.facesAt(node).front(), surface.patch_u.back()));
  }
  return surface;
}

} // namespace palpate
