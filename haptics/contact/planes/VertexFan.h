// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

#include "haptics/contact/view/GodObjectState.h"
#include "haptics/contact/view/SceneView.h"

namespace palpate
{

/// The faces round a vertex with the side that is seen from one and the same space, in the order in which they were
/// reached: each from one before it, over an edge that they share.
struct VertexFan
{
  static constexpr int capacity = 64; ///< both sides of 32 faces; a larger fan is not whole, and is not asked
  struct Face
  {
    ActiveFeature face;
    int before = -1;        ///< index of the face it was reached from; -1: the first
    std::uint32_t over = 0; ///< far end of the edge over which that was
  };

  std::array<Face, capacity> faces;
  int count = 0;
  bool whole = true;     ///< there was room for all of them
  bool branches = false; ///< three or more faces meet in an edge of it

  /// True if it shows that side of face f.
  [[nodiscard]] bool has(const ActiveFeature& f) const noexcept
  {
    return std::any_of(this->faces.begin(), this->faces.begin() + this->count,
      [&f](const Face& g) { return g.face.a == f.a && g.face.side == f.side; });
  }
  [[nodiscard]] const ActiveFeature& operator[](int i) const noexcept
  {
    return this->faces[static_cast<std::size_t>(i)].face;
  }
};

/// The end of a fan at a boundary edge.
enum class FreeEdge : std::uint8_t
{
  Ends, ///< it ends there
  Turns ///< it goes on with the other side of the same face
};

/// The first face met on turning from face `from` round its edge from v to `far`, on the side the point lies on, with
/// the side it shows; none at a free edge. Exact: a fin may lie as close to a face as it likes. `branches` is set where
/// three or more faces meet in the edge.
template<class View>
[[nodiscard]] std::optional<ActiveFeature> across(
  const View& s, const ActiveFeature& from, std::uint32_t v, std::uint32_t far, bool& branches) noexcept;

/// The fan of face f, a face at v, seen from its side f.side. Not whole where it has more than 32 faces, or 64 sides.
template<class View>
[[nodiscard]] VertexFan fanAround(const View& s, const ActiveFeature& f, std::uint32_t v, FreeEdge atFreeEdge) noexcept;

} // namespace palpate
