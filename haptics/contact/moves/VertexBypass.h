// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "haptics/contact/moves/VertexDescent.h"
#include "haptics/contact/planes/VertexFan.h"

namespace palpate
{

/// How far from a vertex, and how high above the faces, a point is led round the vertex [u]. The height is nothing
/// beside the distance.
struct BypassScale
{
  double reach_u = 0.0;
  double height_u = 0.0;
};

/// Places that lead from face to face round a vertex.
struct VertexBypass
{
  std::array<Vec3, 3 * static_cast<std::size_t>(VertexFan::capacity)> places_W;
  int count = 0;

  void add(const Vec3& place_W) noexcept { this->places_W[static_cast<std::size_t>(this->count++)] = place_W; }
};

/// The way over the faces of a fan from its first face to the beginning of a descent from its vertex v: over the middle
/// of each face, and round those edges between them over which one face does not see the next.
template<class View>
[[nodiscard]] VertexBypass bypassVertex(const View& s, const VertexFan& fan, std::uint32_t v, const Descent& descent,
  const Vec3& q, const BypassScale& scale) noexcept;

} // namespace palpate
