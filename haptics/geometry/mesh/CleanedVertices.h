// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "haptics/geometry/mesh/TriangleMesh.h"

namespace palpate
{

/// Which vertex of a clean mesh each vertex of the raw one became: takes new positions of the same raw triangles to the
/// clean mesh without cleaning again.
class CleanedVertices
{
public:
  /// Result of cleanMesh() for `raw`: its vertices [u], their sources, and whether it dropped triangles for where their
  /// corners were, collinear or not finite. O(n log n).
  CleanedVertices(std::shared_ptr<const TriangleMesh> raw, const std::vector<Vec3>& clean_W,
    std::vector<std::uint32_t> source, bool droppedByPlace);

  /// Positions [u] of the clean mesh's vertices, in its order, or nothing where the clean mesh of `moved` would be
  /// another one: other triangles, triangles that had been dropped for where their corners were, or vertices apart
  /// that were one. Vertices that have become one stay two. O(n).
  [[nodiscard]] std::optional<std::vector<Vec3>> follow(const TriangleMesh& moved) const;

private:
  std::shared_ptr<const TriangleMesh> raw_;
  std::vector<std::uint32_t> source_;   ///< a raw vertex for each clean one
  std::vector<std::uint32_t> becameOf_; ///< a clean vertex for each raw one, or source_.size()
  bool droppedByPlace_;
};

} // namespace palpate
