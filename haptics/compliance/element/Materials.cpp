// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/compliance/element/Materials.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

namespace palpate
{
namespace
{

/// Strain that is smoothed over a step of the modulus makes stress beside it wrong by half of that step: by 1 %.
constexpr double sameWithin = 0.02;

bool isSame(const ElasticModuli& a, const ElasticModuli& b)
{
  const auto near = [](double p, double q) { return std::abs(p - q) <= sameWithin * std::min(p, q); };
  return near(a.mu, b.mu) && near(a.lambda, b.lambda);
}

/// Disjoint sets of tetrahedra; each is called by its lowest one.
class Parts
{
public:
  explicit Parts(std::size_t count) : root_(count) { std::iota(this->root_.begin(), this->root_.end(), 0u); }

  [[nodiscard]] std::uint32_t partOf(std::uint32_t i)
  {
    while (this->root_[i] != i)
    {
      i = this->root_[i] = this->root_[this->root_[i]];
    }
    return i;
  }
  void join(std::uint32_t a, std::uint32_t b)
  {
    const auto [low, high] = std::minmax({ this->partOf(a), this->partOf(b) });
    this->root_[high] = low;
  }

private:
  std::vector<std::uint32_t> root_;
};

Parts joinByFaces(const TetraMesh& mesh, const std::vector<ElasticModuli>& moduli)
{
  Parts parts(mesh.tetras.size());
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

} // namespace

std::vector<std::uint32_t> materialsOf(const TetraMesh& mesh, const std::vector<ElasticModuli>& moduli)
{
  Parts parts = joinByFaces(mesh, moduli);
  const auto count = static_cast<std::uint32_t>(mesh.tetras.size());
  constexpr std::uint32_t none = ~0u;
  constexpr std::uint32_t several = none - 1;
  std::vector<std::uint32_t> around(mesh.vertices_W.size(), none); // the one part around each vertex
  for (std::uint32_t i = 0; i < count; ++i)
  {
    for (const std::uint32_t v : mesh.tetras[i])
    {
      const std::uint32_t part = parts.partOf(i);
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
    const std::uint32_t part = parts.partOf(i);
    materials.push_back(isMaterial[part] ? 1 + part : gradedMaterial);
  }
  return materials;
}

} // namespace palpate
