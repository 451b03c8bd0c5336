// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "haptics/core/Types.h"

namespace palpate
{

using Tetra = std::array<std::uint32_t, 4>;

/// Indexed tetrahedra in scene units. As it comes in: nothing about it is trusted.
struct TetraMesh
{
  std::vector<Vec3> vertices_W;
  std::vector<Tetra> tetras;
};

/// Above 0 with its corners in the usual order [u^3].
[[nodiscard]] double volumeOf(const TetraMesh& mesh, const Tetra& t);

/// The result of a check: counts of tetrahedra.
struct TetraReport
{
  std::size_t turned = 0;  ///< had their corners in the other order: all four are in the usual one now
  std::size_t flat = 0;    ///< left out: no volume
  std::size_t doubled = 0; ///< left out: the same four corners again
  std::size_t loose = 0;   ///< left out: of parts that hang together with nothing that is fixed

  /// One line for a person; empty when there is nothing to say.
  [[nodiscard]] std::string summary() const;
};

/// Tetrahedra that a body can be made of, or why there are none. Vertices without any are left out.
struct CheckedTetras
{
  TetraMesh mesh;
  std::vector<std::uint32_t> sourceVertex; ///< of each vertex: its index in the input
  std::vector<std::uint32_t> sourceTetra;  ///< of each tetrahedron
  std::vector<bool> fixed;                 ///< of each vertex
  TetraReport report;
  std::string refusal;
};

/// `fixed`: of each vertex of `raw`. Refuses: a corner that is no finite vertex, two tetrahedra that lie on one side of
/// the face they share, three at one face, nothing fixed, a part that its fixed vertices let turn (fewer than three
/// that are not in line).
[[nodiscard]] CheckedTetras checkTetras(const TetraMesh& raw, const std::vector<bool>& fixed);

/// The triangles of one tetrahedron, seen from outside.
[[nodiscard]] std::vector<std::array<std::uint32_t, 3>> borderOf(const TetraMesh& mesh);

} // namespace palpate
