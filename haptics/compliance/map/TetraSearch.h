// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "haptics/compliance/mesh/TetraMesh.h"
#include "haptics/core/PointGrid.h"

namespace palpate
{

/// A tetrahedron and barycentric coordinates in it, which add up to 1.
struct TetraPlace
{
  std::uint32_t tetra = 0;
  std::array<double, 4> weights{};
  bool inside = false;
};

/// Finds the tetrahedron around a point, or the nearest one. Keeps a reference to the mesh.
class TetraSearch
{
public:
  explicit TetraSearch(const TetraMesh& mesh);
  [[nodiscard]] TetraPlace find(const Vec3& p_W) const;

private:
  void lookAt(const std::vector<std::uint32_t>& tetras, const Vec3& p_W, TetraPlace& best, double& distance) const;

  const TetraMesh& mesh_;
  PointGrid grid_;
  std::vector<std::vector<std::uint32_t>> cells_; ///< tetrahedra whose box meets the cell
};

} // namespace palpate
