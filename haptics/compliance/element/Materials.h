// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "haptics/compliance/element/StrainPoints.h"
#include "haptics/compliance/material/ElasticLaw.h"
#include "haptics/compliance/mesh/TetraMesh.h"

namespace palpate
{

/// The number for moduli that differ from cell to cell and form no material.
inline constexpr std::uint32_t gradedMaterial = 0;

/// The material of each tetrahedron. Tetrahedra that are connected by faces and differ there by no more than 2 %
/// are one material, if at least one of their vertices has no others around it. The rest has a graded modulus, all of
/// it together: layers of a single cell inside a body, or an array with another value in every cell.
[[nodiscard]] std::vector<std::uint32_t> materialsOf(const TetraMesh& mesh, const std::vector<ElasticModuli>& moduli);

/// True if a body has layers, rods or inclusions of another modulus that are one or two tetrahedra thick: sets that
/// are connected by faces within 2 %, of more tetrahedra than surround a vertex, none of which has all four corners
/// inside the set. Strain that is smoothed over edges bends such layers up to 22 % too stiffly.
[[nodiscard]] bool hasThinLayers(const TetraMesh& mesh, const std::vector<ElasticModuli>& moduli);

/// The kind of element for a body. Quadratic ones are more accurate, and are used beyond a Poisson's ratio of .4. Up
/// to 10,000 nodes they are used too where the stiffness is factored once (the linear model), and where layers are
/// thin; other bodies would have too few snapshots, and have smoothed edges.
[[nodiscard]] ElementKind usualElement(
  const TetraMesh& mesh, const std::vector<double>& young_Pa, double poisson, ElasticModel model);

} // namespace palpate
