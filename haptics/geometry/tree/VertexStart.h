// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "haptics/core/Types.h"
#include "haptics/core/WordHash.h"

namespace palpate
{

/// Positions from which the vertices of a surface move straight to those of its tree. Immutable.
struct VertexStart
{
  std::vector<Vec3> vertices_W; ///< one for each vertex of the tree's mesh, in its order [u]
  std::uint64_t continues = 0;  ///< content of the surface that was felt there; 0: of none
  /// Weights in the start of the positions of the tree's VertexWay; the rest to 1 is the weight of the tree's own
  /// vertices.
  std::array<double, 2> ofPlaces;
  std::uint64_t hash = 0; ///< of vertices and content

  VertexStart(std::vector<Vec3> start_W, std::uint64_t felt, const std::array<double, 2>& ofWay = { 1.0, 0.0 })
    : vertices_W(std::move(start_W)), continues(felt), ofPlaces(ofWay), hash(hashOf(vertices_W, felt))
  {
  }

private:
  [[nodiscard]] static std::uint64_t hashOf(const std::vector<Vec3>& vertices_W, std::uint64_t felt) noexcept
  {
    WordHash hash;
    hash.add(felt);
    for (const Vec3& v : vertices_W)
    {
      hash.add(v.x());
      hash.add(v.y());
      hash.add(v.z());
    }
    return hash.value();
  }
};

/// A vertex at a share 0..1 of its path, within the box of both ends whatever rounding does.
[[nodiscard]] inline Vec3 alongWay(const Vec3& begin, const Vec3& end, double share) noexcept
{
  return (begin + share * (end - begin)).cwiseMax(begin.cwiseMin(end)).cwiseMin(begin.cwiseMax(end));
}

} // namespace palpate
