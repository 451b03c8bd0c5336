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

/// Indexed tetrahedra in scene units, as given: nothing about them is trusted.
struct TetraMesh
{
  std::vector<Vec3> vertices_W;
  std::vector<Tetra> tetras;
};

/// Positive with its corners in the usual order [u^3].
[[nodiscard]] double volumeOf(const TetraMesh& mesh, const Tetra& t);

/// The result of a check: counts of tetrahedra.
struct TetraReport
{
  std::size_t turned = 0;  ///< had the other orientation: all four corners are in the usual order now
  std::size_t flat = 0;    ///< left out: no volume
  std::size_t doubled = 0; ///< left out: the same four corners again
  std::size_t loose = 0;   ///< left out: of parts that are not connected to a fixed vertex

  /// One line for the user; empty when there is nothing to report.
  [[nodiscard]] std::string summary() const;
};

/// Tetrahedra of which a body can be made, or why there are none. Vertices without any are left out.
struct CheckedTetras
{
  TetraMesh mesh;
  std::vector<std::uint32_t> sourceVertex; ///< of each vertex: its index in the input
  std::vector<std::uint32_t> sourceTetra;  ///< of each tetrahedron
  std::vector<bool> fixed;                 ///< of each vertex
  TetraReport report;
  std::string refusal;
};

/// `fixed`: of each vertex of `raw`. Refuses: a corner that is no finite vertex, two tetrahedra on the same side of
/// their common face, three at one face, no fixed vertex, a part that its fixed vertices let rotate (fewer than three
/// that are not collinear).
[[nodiscard]] CheckedTetras checkTetras(const TetraMesh& raw, const std::vector<bool>& fixed);

/// The triangles that belong to one tetrahedron only, seen from outside.
[[nodiscard]] std::vector<std::array<std::uint32_t, 3>> borderOf(const TetraMesh& mesh);

} // namespace palpate
