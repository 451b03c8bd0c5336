// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "haptics/compliance/mesh/TetraMesh.h"

namespace palpate
{

/// The number of vertices of a body's border that are one element away from the border on the other side: such a layer
/// feels stiffer than it is. Corners of tetrahedra that are no vertices are left out.
struct ThinPlaces
{
  std::size_t thin = 0;
  std::size_t all = 0; ///< vertices of the border

  /// The message; empty where two elements lie between the sides everywhere.
  [[nodiscard]] std::string sentence() const;
};

[[nodiscard]] ThinPlaces thinPlacesOf(const TetraMesh& mesh);

} // namespace palpate
