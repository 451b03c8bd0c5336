// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "haptics/compliance/element/StrainPoints.h"
#include "haptics/compliance/material/ElasticLaw.h"
#include "haptics/compliance/mesh/TetraMesh.h"

namespace palpate
{

/// The number of a material that is none: moduli that differ from cell to cell.
inline constexpr std::uint32_t gradedMaterial = 0;

/// Which material each tetrahedron is of. Tetrahedra that hang together by faces and differ there by no more than 2 %
/// are one, where they are all there is around one of their vertices at least. Others are of a graded modulus, all of
/// them together: layers of a single cell inside a body, or an array that takes another value in every cell.
[[nodiscard]] std::vector<std::uint32_t> materialsOf(const TetraMesh& mesh, const std::vector<ElasticModuli>& moduli);

/// Whether a body has layers, rods or inclusions of another modulus of one or two tetrahedra through them: sets that
/// hang together by faces within 2 %, of more tetrahedra than surround a vertex, none of which has all four corners
/// inside the set. Strain that is smoothed over edges bends such layers up to 22 % too stiffly.
[[nodiscard]] bool hasThinLayers(const TetraMesh& mesh, const std::vector<ElasticModuli>& moduli);

/// The kind of element for a body. Nodes halfway the edges are truer, and are taken beyond a Poisson's ratio of .4. Up
/// to 10,000 nodes they are taken too where the stiffness is factored once (the linear model), and where layers are
/// thin; other bodies would come too seldom, and have smoothed edges.
[[nodiscard]] ElementKind usualElement(
  const TetraMesh& mesh, const std::vector<double>& young_Pa, double poisson, ElasticModel model);

} // namespace palpate
