// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/compliance/element/Materials.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>

#include "haptics/core/DisjointSets.h"

namespace palpate
{
namespace
{

/// Strain that is smoothed over a step of the modulus gives stress beside it an error of half of that step: 1 %.
constexpr double sameWithin = 0.02;

/// Beyond this Poisson's ratio a few tetrahedra with smoothed edges are too stiff.
constexpr double mostOfSmoothed = 0.4;
/// The most nodes, mid-edge nodes included. A block of 8,000 has 80 snapshots per second where its stiffness is
/// factored once, and its factor takes 99 MB.
constexpr std::size_t mostNodes = 10'000;
/// Number of tetrahedra at a vertex of a regular mesh (six per cube). A smaller set surrounds no vertex anyway.
constexpr std::size_t aroundVertex = 24;

bool isSame(const ElasticModuli& a, const ElasticModuli& b)
{
  const auto near = [](double p, double q) { return std::abs(p - q) <= sameWithin * std::min(p, q); };
  return near(a.mu, b.mu) && near(a.lambda, b.lambda);
}

/// Joins tetrahedra that share a face and are of one modulus.
DisjointSets joinByFaces(const TetraMesh& mesh, const std::vector<ElasticModuli>& moduli)
{
  DisjointSets parts(mesh.tetras.size());
  std::map<std::array<std::uint32_t, 3>, std::uint32_t> waiting;
  for (std::uint32_t i = 0; i < mesh.tetras.size(); ++i)
  {
    Tetra corners = mesh.tetras[i];
    std::sort(corners.begin(), corners.end());
    for (std::size_t without = 0; without < 4; ++without)
    {
      std::array<std::uint32_t, 3> face{};
      std::copy_if(
        corners.begin(), corners.end(), face.begin(), [&](std::uint32_t v) { return v != corners[without]; });
      const auto [other, isFirst] = waiting.try_emplace(face, i);
      if (!isFirst)
      {
        if (isSame(moduli[i], moduli[other->second]))
        {
          parts.join(i, other->second);
        }
        waiting.erase(other);
      }
    }
  }
  return parts;
}

/// The only part around each vertex; none for a vertex on the border or between parts.
std::vector<std::uint32_t> partsInside(const TetraMesh& mesh, DisjointSets& parts, std::uint32_t none)
{
  constexpr std::uint32_t unmet = ~0u;
  std::vector<std::uint32_t> inside(mesh.vertices_W.size(), unmet);
  for (std::uint32_t i = 0; i < mesh.tetras.size(); ++i)
  {
    const std::uint32_t part = parts.of(i);
    for (const std::uint32_t v : mesh.tetras[i])
    {
      inside[v] = inside[v] == unmet || inside[v] == part ? part : none;
    }
  }
  for (const auto& corners : borderOf(mesh))
  {
    for (const std::uint32_t v : corners)
    {
      inside[v] = none;
    }
  }
  return inside;
}

std::size_t nodesHalved(const TetraMesh& mesh)
{
  std::vector<std::array<std::uint32_t, 2>> edges;
  for (const Tetra& t : mesh.tetras)
  {
    for (std::size_t a = 0; a < 4; ++a)
    {
      for (std::size_t b = 0; b < a; ++b)
      {
        edges.push_back({ std::min(t[a], t[b]), std::max(t[a], t[b]) });
      }
    }
  }
  std::ranges::sort(edges);
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return mesh.vertices_W.size() + edges.size();
}

} // namespace

bool hasThinLayers(const TetraMesh& mesh, const std::vector<ElasticModuli>& moduli)
{
  constexpr std::uint32_t none = ~0u - 1;
  DisjointSets parts = joinByFaces(mesh, moduli);
  const std::vector<std::uint32_t> inside = partsInside(mesh, parts, none);
  const auto count = static_cast<std::uint32_t>(mesh.tetras.size());
  std::vector<std::size_t> sizes(count, 0);
  std::vector<bool> isThick(count, false);
  for (std::uint32_t i = 0; i < count; ++i)
  {
    const std::uint32_t part = parts.of(i);
    ++sizes[part];
    isThick[part] =
      isThick[part] || std::ranges::all_of(mesh.tetras[i], [&](std::uint32_t v) { return inside[v] == part; });
  }
  for (std::uint32_t part = 0; part < count; ++part)
  {
    if (sizes[part] > aroundVertex && sizes[part] < count && !isThick[part])
    {
      return true;
    }
  }
  return false;
}

ElementKind usualElement(const TetraMesh& mesh, const std::vector<double>& young_Pa, double poisson, ElasticModel model)
{
  if (poisson > mostOfSmoothed)
  {
    return ElementKind::Quadratic;
  }
  const auto isThere = [&mesh](const Tetra& t)
  { return std::ranges::all_of(t, [&mesh](std::uint32_t v) { return v < mesh.vertices_W.size(); }); };
  if (!std::ranges::all_of(mesh.tetras, isThere) || nodesHalved(mesh) > mostNodes)
  {
    return ElementKind::EdgeSmoothed; // checkTetras() refuses the first case
  }
  if (model == ElasticModel::Linear)
  {
    return ElementKind::Quadratic;
  }
  if (young_Pa.size() != mesh.tetras.size())
  {
    return ElementKind::EdgeSmoothed; // one modulus
  }
  std::vector<ElasticModuli> moduli;
  std::ranges::transform(
    young_Pa, std::back_inserter(moduli), [poisson](double young) { return moduliOf(young, poisson, 1.0).value; });
  return hasThinLayers(mesh, moduli) ? ElementKind::Quadratic : ElementKind::EdgeSmoothed;
}

std::vector<std::uint32_t> materialsOf(const TetraMesh& mesh, const std::vector<ElasticModuli>& moduli)
{
  DisjointSets parts = joinByFaces(mesh, moduli);
  const auto count = static_cast<std::uint32_t>(mesh.tetras.size());
  constexpr std::uint32_t none = ~0u;
  constexpr std::uint32_t several = none - 1;
  std::vector<std::uint32_t> around(mesh.vertices_W.size(), none); // the only part around each vertex
  for (std::uint32_t i = 0; i < count; ++i)
  {
    for (const std::uint32_t v : mesh.tetras[i])
    {
      const std::uint32_t part = parts.of(i);
      around[v] = around[v] == none || around[v] == part ? part : several;
    }
  }
  std::vector<bool> isMaterial(count, false);
  for (const std::uint32_t part : around)
  {
    if (part < count)
    {
      isMaterial[part] = true;
    }
  }
  std::vector<std::uint32_t> materials;
  for (std::uint32_t i = 0; i < count; ++i)
  {
    const std::uint32_t part = parts.of(i);
    materials.push_back(isMaterial[part] ? 1 + part : gradedMaterial);
  }
  return materials;
}

} // namespace palpate
