// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/compliance/mesh/ThinPlaces.h"

#include <algorithm>
#include <set>
#include <vector>

namespace palpate
{
namespace
{

/// Sides face away from each other from this cosine on: around an edge of a box an element has two that do not.
constexpr double oppositeFrom = -0.5;

using Edge = std::array<std::uint32_t, 2>;

Edge edgeOf(std::uint32_t a, std::uint32_t b)
{
  return { std::min(a, b), std::max(a, b) };
}

bool isWhole(const TetraMesh& mesh, const Tetra& t)
{
  return std::ranges::all_of(t, [&mesh](std::uint32_t v) { return v < mesh.vertices_W.size(); });
}

} // namespace

std::string ThinPlaces::sentence() const
{
  return this->thin == 0 ? ""
                         : std::to_string(this->thin) + " of " + std::to_string(this->all) +
                             " places of the body are one element thick and therefore feel too stiff: use a finer "
                             "mesh, with at least two elements across";
}

ThinPlaces thinPlacesOf(const TetraMesh& mesh)
{
  TetraMesh whole{ mesh.vertices_W, {} };
  std::ranges::copy_if(
    mesh.tetras, std::back_inserter(whole.tetras), [&mesh](const Tetra& t) { return isWhole(mesh, t); });
  std::vector<Vec3> outward(mesh.vertices_W.size(), Vec3::Zero());
  std::set<Edge> along;
  std::set<std::uint32_t> border;
  for (const auto& [a, b, c] : borderOf(whole))
  {
    const Vec3 across = (whole.vertices_W[b] - whole.vertices_W[a]).cross(whole.vertices_W[c] - whole.vertices_W[a]);
    for (const std::uint32_t v : { a, b, c })
    {
      outward[v] += across;
      border.insert(v);
    }
    along.insert({ edgeOf(a, b), edgeOf(b, c), edgeOf(c, a) });
  }
  const auto goesThrough = [&](std::uint32_t a, std::uint32_t b)
  {
    const double sizes = outward[a].norm() * outward[b].norm();
    return sizes > 0.0 && outward[a].dot(outward[b]) < oppositeFrom * sizes && !along.contains(edgeOf(a, b));
  };
  std::set<std::uint32_t> thin;
  for (const Tetra& t : whole.tetras)
  {
    for (std::size_t i = 0; i < t.size(); ++i)
    {
      for (std::size_t j = i + 1; j < t.size(); ++j)
      {
        if (goesThrough(t[i], t[j]))
        {
          thin.insert({ t[i], t[j] });
        }
      }
    }
  }
  return { thin.size(), border.size() };
}

} // namespace palpate
