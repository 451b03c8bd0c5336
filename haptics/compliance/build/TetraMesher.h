// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "haptics/compliance/mesh/TetraMesh.h"
#include "haptics/core/Progress.h"
#include "haptics/geometry/tree/SurfaceTree.h"

namespace palpate
{

/// Sizes of the tetrahedra.
struct TetraSizes
{
  double edge_u = 0.0;       ///< about their longest edges inside
  double distance_u = 0.0;   ///< of the border from the input, as CGAL keeps it; not below 1e-7 of the size
  std::size_t most = 500000; ///< tetrahedra that are expected, from volume and edge: more are refused in advance
};

/// Tetrahedra, or the reason why there are none.
struct TetraMeshResult
{
  TetraMesh mesh;
  std::vector<std::uint32_t> labels; ///< of each tetrahedron: its label
  double bound_u = 0.0; ///< proven: largest distance between points of border and closed surface [u]; or infinity
  std::string refusal;  ///< "cancelled" where `goes` returned false
};

/// Labels at the centres of voxels, x fastest; 0 is outside.
struct LabelImage
{
  std::array<int, 3> counts{};
  Vec3 first_W = Vec3::Zero(); ///< centre of the first voxel [u]
  Vec3 step_u = Vec3::Ones();
  std::vector<std::uint32_t> labels;
};

/// Fills a closed surface (CGAL Mesh_3: Delaunay refinement, Jamin et al. 2015). Its sharp edges are rounded within
/// distance_u. Refuses a surface with holes. Parts that are small against the whole may be missed.
[[nodiscard]] TetraMeshResult meshInside(const SurfaceTree& closed, const TetraSizes& sizes, const Goes& goes = always);

/// Fills every label of an image, with common faces between labels. Refuses an image without labels.
[[nodiscard]] TetraMeshResult meshLabels(const LabelImage& image, const TetraSizes& sizes, const Goes& goes = always);

} // namespace palpate
