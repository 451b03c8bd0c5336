// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

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

} // namespace palpate
